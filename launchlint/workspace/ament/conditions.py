"""The conditions of a ``package.xml`` of format 3 (REP 149): ``condition="$ROS_VERSION == 2 and $ROS_DISTRO >= jazzy"``.

As catkin_pkg.condition reads them: comparisons of two terms, ``and`` before ``or``, parentheses; a variable that is not set is empty, and
all is compared as text. A term alone is no condition.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping
from operator import eq, ge, gt, le, lt, ne

from launchlint.late import late

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import TypeAlias

    Judge: TypeAlias = Callable[[Mapping[str, str]], bool]

_TOKEN = late(
    r"""\s*(?:(?P<compare>[=!<>]=|[<>])
    | (?P<parenthesis>[()])
    | \$(?P<name>[A-Za-z0-9_]+)
    | "(?P<double>[^"\n]*)"
    | '(?P<single>[^'\n]*)'
    | (?P<word>[A-Za-z0-9_-]+))""",
    re.VERBOSE,
)
_COMPARE: Mapping[str, Callable[[str, str], bool]] = {"==": eq, "!=": ne, "<=": le, "<": lt, ">=": ge, ">": gt}

# Bounds against hostile files.
_LONGEST = 4_000
_DEEPEST = 20


def holds(condition: str, context: Mapping[str, str]) -> bool:
    """Whether ``condition`` is true where the variables are those of ``context``.

    Raises:
        ValueError: it is no condition; catkin_pkg refuses the whole file then.
    """
    tokens = _tokens(condition)
    result, end = _any(tokens, 0, context, 0)
    if end != len(tokens):
        raise ValueError(f"the condition {condition[:100]!r} is not understood")
    return result


def _tokens(text: str) -> list[tuple[str, str]]:
    """Pairs of a kind (``compare``, ``parenthesis``, ``name``, ``word``, ``quoted``) and a text."""
    tokens: list[tuple[str, str]] = []
    text = text[: _LONGEST + 1].rstrip()
    position = 0
    while position < len(text) <= _LONGEST:
        match = _TOKEN.match(text, position)
        if match is None or match.lastgroup is None:
            break
        kind = "quoted" if match.lastgroup in ("double", "single") else match.lastgroup
        tokens.append((kind, match[match.lastgroup]))
        position = match.end()
    if position < len(text):
        raise ValueError(f"the condition {text[:100]!r} is not understood")
    return tokens


def _any(tokens: list[tuple[str, str]], at: int, context: Mapping[str, str], depth: int) -> tuple[bool, int]:
    result, at = _all(tokens, at, context, depth)
    while tokens[at : at + 1] == [("word", "or")]:
        right, at = _all(tokens, at + 1, context, depth)
        result = result or right
    return result, at


def _all(tokens: list[tuple[str, str]], at: int, context: Mapping[str, str], depth: int) -> tuple[bool, int]:
    result, at = _comparison(tokens, at, context, depth)
    while tokens[at : at + 1] == [("word", "and")]:
        right, at = _comparison(tokens, at + 1, context, depth)
        result = result and right
    return result, at


def _comparison(tokens: list[tuple[str, str]], at: int, context: Mapping[str, str], depth: int) -> tuple[bool, int]:
    if tokens[at : at + 1] == [("parenthesis", "(")] and depth < _DEEPEST:
        result, at = _any(tokens, at + 1, context, depth + 1)
        if tokens[at : at + 1] == [("parenthesis", ")")]:
            return result, at + 1
        raise ValueError("a condition lacks a )")
    terms = tokens[at : at + 3]
    if [kind in ("compare", "parenthesis") for kind, _ in terms] != [False, True, False] or terms[1][0] != "compare":
        raise ValueError("a condition compares two terms")
    left, right = (context.get(text, "") if kind == "name" else text for kind, text in (terms[0], terms[2]))
    return _COMPARE[terms[1][1]](left, right), at + 3
