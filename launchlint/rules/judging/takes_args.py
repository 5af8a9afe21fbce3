"""Whether a launch file could stand in for another one at an include."""

from __future__ import annotations

from functools import lru_cache

from launchlint.problem import Problem
from launchlint.rules.edits import spot
from launchlint.rules.view import LaunchView
from launchlint.syntax.parse import parse
from launchlint.workspace.looking import content

_TEST = ".test"


def is_alike(wanted: str, name: str) -> bool:
    """Whether both are tests, or neither is."""
    return wanted.endswith(_TEST) == name.endswith(_TEST)


def passed_at(problem: Problem, view: LaunchView) -> frozenset[str]:
    """The names of the args that the include at ``problem`` passes one by one; what ``pass_all_args`` passes is never too much."""
    at = spot(view, problem.place)
    if at is None:
        return frozenset()
    return frozenset(name for child in at.element.children if child.tag == "arg" and (name := child.get("name")))


def takes(file: str, passed: frozenset[str]) -> bool:
    """Whether the launch file declares all args that are ``passed``: roslaunch refuses others (loader.post_process_include_args)."""
    if not passed:
        return True
    data = content(file)
    if data is None:
        return False
    return passed <= _declared(data)


@lru_cache(maxsize=64)
def _declared(data: bytes) -> frozenset[str | None]:
    """The args of a launch file; kept, since many includes that lead nowhere may be proposed the same one."""
    document = parse(data, "")
    return frozenset(each.get("name") for each in document.elements if each.tag == "arg" and each.parent is document.launch)
