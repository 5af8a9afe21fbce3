"""What a problem says beside where it stands."""

from __future__ import annotations

from launchlint.problem import Problem


def own_fields(problem: Problem) -> dict[str, object]:
    """The fields of its kind, by name."""
    return {name: value for name, value in vars(problem).items() if name not in Problem.__annotations__}
