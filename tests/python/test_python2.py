"""Python 2 spelled so that Python 3's grammar takes it."""

from __future__ import annotations

import ast

import pytest

from launchlint.python.python2 import rewritten
from launchlint.python.source import SourceError, parse_text


@pytest.mark.parametrize(
    ("before", "after"),
    [
        ("print 'x'", "print( 'x')"),
        ("print 'x', y", "print( 'x', y)"),
        ("print", "print()"),
        ("print('x')", "print('x')"),
        ("print ('%s') % x", "print( ('%s') % x)"),
        ("print >>f, x", "print( f, x)"),
        ("print = 3", "print = 3"),
        ("if x: print y", "if x: print( y)"),
        ("print x; print y", "print( x); print( y)"),
        ("print x # why", "print( x) # why"),
        ("except E, e:\n", "except E as e:\n"),
        ("except (A, B), e:\n", "except (A, B) as e:\n"),
        ("except (A, B):\n", "except (A, B):\n"),
        ("raise E, 'text'", "raise E( 'text')"),
        ("raise E('a', 'b')", "raise E('a', 'b')"),
        ("exec code", "exec( code)"),
        ("exec(code)", "exec(code)"),
        ("a <> b", "a != b"),
        ("a != b", "a != b"),
        ("0777", "0o777"),
        ("0", "0"),
        ("00", "0o0"),
        ("0.5 + 08.5", "0.5 + 08.5"),
        ("10L + 0xFFL", "10 + 0xFF"),
        ("`x`", "repr(x)"),
        ("ur'x'", "r'x'"),
        ("u'x'", "u'x'"),
        ("lambda (a, b): a", "lambda _tuple : a"),
        ("def f(self, (a, b), c):\n", "def f(self, _tuple , c):\n"),
        ("def f(a=(1, 2)):\n", "def f(a=(1, 2)):\n"),
        ("'print x'", "'print x'"),
        ("'''\nprint x\n'''", "'''\nprint x\n'''"),
        ("if x:\n\tprint x\n        print y\n", "if x:\n        print( x)\n        print( y)\n"),
        ("print a, \\\n  b", "print( a, \\\n  b)"),
    ],
)
def test_rewritten(before: str, after: str) -> None:
    assert " ".join(rewritten(before).split()) == " ".join(after.split())
    assert rewritten(before).count("\n") == before.count("\n")


def test_what_is_in_order_is_not_rewritten() -> None:
    assert ast.dump(parse_text("print(f'{x!r}')\nasync def f(): await g()\n").tree) == ast.dump(
        ast.parse("print(f'{x!r}')\nasync def f(): await g()\n")
    )


@pytest.mark.parametrize(
    ("source", "reason"),
    [
        ("def f(:\n", "is not Python: line 1: "),
        ("x = " + "(" * 500 + ")" * 500, "is "),
        ("x = " + "-" * 5_000 + "1", "is nested too deep"),
        ("x = '\0'", "is not Python: "),
        ("x = " + ".a" * 100_000, "is "),
        ("a" + "[0]" * 3_000, "is nested too deep"),
    ],
)
def test_what_is_no_python(source: str, reason: str) -> None:
    with pytest.raises(SourceError) as error:
        parse_text(source)
    assert str(error.value).startswith(reason)
