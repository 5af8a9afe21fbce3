"""Values that nobody gives: the search for configurations tries them to see the other side of a condition."""

from __future__ import annotations

from launchlint.model import Launch

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
