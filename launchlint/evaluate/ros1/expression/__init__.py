"""``$(eval …)``: the expression, computed as roslaunch computes it, without letting it do anything (roslaunch.substitution_args._eval).

roslaunch hands the text to Python's ``eval``. Here the text is parsed, and a small interpreter walks the tree: it knows the harmless
part of the language, counts every step and every character it would produce, and gives up with :class:`UnknownValue` before
anything gets large. Nothing else of the machine can be reached from it.
"""

from __future__ import annotations

from collections.abc import Mapping

from launchlint.evaluate.ros1.expression.resolver import EnvironmentUnset, ExpressionError, UndefinedArg, UnknownValue

TYPE_CHECKING = False
if TYPE_CHECKING:
    from launchlint.evaluate.ros1.expression.resolver import Resolver

__all__ = (
    "EnvironmentUnset",
    "ExpressionError",
    "UndefinedArg",
    "UnknownValue",
    "arguments_read",
    "compared_literals",
    "evaluate",
    "made_into_text",
    "never_equal",
    "truth_tested",
    "whole_arg",
)


def evaluate(text: str, resolver: Resolver) -> str:
    """What ``$(eval text)`` becomes: ``str()`` of the value of ``text`` (roslaunch.substitution_args._eval).

    Raises :class:`ExpressionError` where roslaunch fails, and :class:`UnknownValue` where the value depends on something that cannot be
    known, lies beyond our bounds, or uses a corner of Python that is not covered.
    """
    from launchlint.evaluate.ros1.expression.interpreter import run

    return run(text, resolver)


def arguments_read(text: str) -> frozenset[str]:
    """Every arg that ``text`` may read: bare names, and the literal names in ``arg('…')``; nothing is evaluated.

    Names of Python's functions are among them when they are used (``str``, ``map``), since an arg of that name goes before the
    function. For a text that cannot be parsed, every word counts.
    """
    from launchlint.evaluate.ros1.expression.reading import names_read

    return names_read(text)


def compared_literals(text: str, *, exact: bool = False, parts: bool = True) -> Mapping[str, tuple[str, ...]]:
    """Per arg the values that ``text`` tells apart, spelled as a user would pass them, in order of appearance.

    They come from ``==``, ``!=``, ``in``, ``startswith``, the keys of a dict that the arg is looked up in, and the like; a number in
    ``<`` or ``>`` gives itself and its two neighbours; an arg used as a condition gives ``true`` and ``false``. With ``exact`` only what
    an arg may be equal to as a whole: no beginnings, no other parts, no neighbours. Without ``parts`` no text that is looked for in an arg
    (``'/' in model``): it says nothing of what the whole may be.
    """
    from launchlint.evaluate.ros1.expression.reading import literals_compared

    return literals_compared(text, exact=exact, parts=parts)


def never_equal(text: str) -> tuple[tuple[int, int, str, str, bool], ...]:
    """Comparisons of an arg with a text that no arg can be equal to: start and end in ``text``, the arg, the text it is compared with, and
    whether it asks for the two to differ.

    roslaunch makes a number or a boolean of every arg that looks like one (roslaunch.loader.convert_value with type auto), so that
    ``count == '5'`` is false whatever is given.
    """
    from launchlint.evaluate.ros1.expression.reading import comparisons_never_equal

    return comparisons_never_equal(text)


def made_into_text(text: str) -> frozenset[str]:
    """The args that ``text`` computes with or makes part of a longer text, so that none of them can be meant as a boolean."""
    from launchlint.evaluate.ros1.expression.reading import names_as_text

    return names_as_text(text)


def truth_tested(text: str) -> frozenset[str]:
    """The args that ``text`` asks whether they are true."""
    from launchlint.evaluate.ros1.expression.reading import names_as_truth

    return names_as_truth(text)


def whole_arg(text: str) -> str | None:
    """The arg that ``text`` consists of, if it is nothing else."""
    from launchlint.evaluate.ros1.expression.reading import only_name

    return only_name(text)
