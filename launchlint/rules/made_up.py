"""Values that nobody gives: the search for configurations tries them to see the other side of a condition."""

from __future__ import annotations

import re
from collections.abc import Iterable

from launchlint.model import Launch
from launchlint.problem import Problem

_BOOLEANS = ("true", "false", "1", "0")


def has_odd_boolean(launch: Launch) -> bool:
    """Whether a boolean was only tried for an arg of the entry file whose default is another text: nobody gives it that one."""
    steered: frozenset[str] = frozenset().union(*(branch.steered_by for branch in launch.branches))
    odd = {name for name, value in launch.given if name in steered and value.strip().lower() in _BOOLEANS}
    return any(
        argument.name in odd and isinstance(argument.default, str) and argument.default.strip().lower() not in _BOOLEANS
        for argument in launch.declared
        if argument.origin.step is None and not argument.passed
    )


def is_made_up(path: str, problem: Problem, launch: Launch) -> bool:
    """Whether ``path``, which ``problem`` is about, holds a value that was only tried for an arg.

    Not where a file on the way to it compares something with just this value: ``$(eval robot == 'ur5')`` says that it may be given.
    """
    if "$(" not in problem.place.text:
        return False
    steered: frozenset[str] = frozenset().union(*(branch.steered_by for branch in launch.branches))
    tried = [value for name, value in launch.given if name in steered and value and _holds(path, value)]
    if not tried:
        return False
    texts = {place.source.text for place in (problem.place, *problem.origin.chain)}
    return any(value.lower() in ("true", "false") or not _compared(value, texts) for value in tried)


def _holds(path: str, value: str) -> bool:
    return re.search(rf"(?<![^\W_]){re.escape(value)}(?![^\W_])", path) is not None


def _compared(value: str, texts: Iterable[str]) -> bool:
    quoted = rf"(?:['\"]|&quot;|&apos;){re.escape(value)}(?:['\"]|&quot;|&apos;)"
    equal = re.compile(rf"[=!]=\s*{quoted}|{quoted}\s*[=!]=")
    return any(equal.search(text) for text in texts)
