"""The names an expression can use besides args, in the order roslaunch looks them up (roslaunch.substitution_args._DictWrapper)."""

from __future__ import annotations

#: Handed in by roslaunch with the context: they go before everything else.
CONTEXT_FUNCTIONS = frozenset({"anon", "arg", "dirname", "env", "find", "optenv"})

#: The words that roslaunch adds as truth values.
TRUTH = {"true": True, "false": False, "True": True, "False": False}

#: All of Python's math module as of 3.11. An arg of one of these names can only be read with ``arg('…')``.
MATH = frozenset(
    """acos acosh asin asinh atan atan2 atanh cbrt ceil comb copysign cos cosh degrees dist e erf erfc exp exp2 expm1 fabs factorial
    floor fmod frexp fsum gamma gcd hypot inf isclose isfinite isinf isnan isqrt lcm ldexp lgamma log log10 log1p log2 modf
    nan nextafter perm pi pow prod radians remainder sin sinh sqrt tan tanh tau trunc ulp""".split()
)

#: What goes before an arg of the same name.
RESERVED = CONTEXT_FUNCTIONS | TRUTH.keys() | MATH

#: Python's builtins as of 3.11, the interactive ones of ``site`` among them: reached when there is no arg of the name.
BUILTINS = frozenset(
    """abs aiter all anext any ascii bin bool breakpoint bytearray bytes callable chr classmethod compile complex copyright credits
    delattr dict dir divmod enumerate eval exec exit filter float format frozenset getattr globals hasattr hash help hex id
    input int isinstance issubclass iter len license list locals map max memoryview min next object oct open ord pow print
    property quit range repr reversed round set setattr slice sorted staticmethod str sum super tuple type vars zip Ellipsis
    NotImplemented ArithmeticError AssertionError AttributeError BaseException BaseExceptionGroup BlockingIOError
    BrokenPipeError BufferError BytesWarning ChildProcessError ConnectionAbortedError ConnectionError ConnectionRefusedError
    ConnectionResetError DeprecationWarning EOFError EncodingWarning EnvironmentError Exception ExceptionGroup
    FileExistsError FileNotFoundError FloatingPointError FutureWarning GeneratorExit IOError ImportError ImportWarning
    IndentationError IndexError InterruptedError IsADirectoryError KeyError KeyboardInterrupt LookupError MemoryError
    ModuleNotFoundError NameError NotADirectoryError NotImplementedError OSError OverflowError PendingDeprecationWarning
    PermissionError ProcessLookupError RecursionError ReferenceError ResourceWarning RuntimeError RuntimeWarning
    StopAsyncIteration StopIteration SyntaxError SyntaxWarning SystemError SystemExit TabError TimeoutError TypeError
    UnboundLocalError UnicodeDecodeError UnicodeEncodeError UnicodeError UnicodeTranslateError UnicodeWarning UserWarning
    ValueError Warning ZeroDivisionError""".split()
)
