"""Texts of launch configurations that a function of a launch file takes for a boolean: ``'false'`` counts as true in Python.

It is read off the text, in all functions: what ``LaunchConfiguration('sim').perform(context)`` gives is a string. Only those count whose
arg is declared in the same file with a default that is a boolean word: for others, to be empty or not may be the question.
"""

from __future__ import annotations

import ast
from collections.abc import Callable, Iterator, Mapping

from launchlint.problem import Problem
from launchlint.python.walking import walk
from launchlint.source import Origin, Place
from launchlint.syntax.ros2.python.problems import ConfigurationAsPythonValue
from launchlint.syntax.ros2.python.uses import uses

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import TypeAlias

    Routine: TypeAlias = "ast.FunctionDef | ast.AsyncFunctionDef"

_WORDS = ("true", "false")


def performed_as_boolean(tree: ast.Module, place: Callable[[ast.AST], Place]) -> Iterator[Problem]:
    """Each test of such a text, in the order of the text."""
    booleans = set(_declared(tree))
    if not booleans:
        return
    tested = {key: whole for key, (use, whole) in uses(tree).items() if use == "test"}
    made = _assigned(tree)
    found: dict[tuple[int, int], Problem] = {}
    for routine in walk(tree):
        if not isinstance(routine, (ast.FunctionDef, ast.AsyncFunctionDef)):
            continue
        held = {**made, **_assigned(routine)}
        texts = _performed(routine, held)
        for node in walk(routine):
            against = _against_boolean(node)
            whole = tested.get(id(node)) if against is None else against
            side = node if against is None else against.left
            name = texts.get(side.id, "") if isinstance(side, ast.Name) else _configuration(side, held)
            if whole is not None and name in booleans:
                origin = Origin(place(whole))
                problem = ConfigurationAsPythonValue(origin=origin, use="performed", name="LaunchConfiguration", of=name)
                found[whole.lineno, whole.col_offset] = problem
    yield from (found[key] for key in sorted(found))


def _declared(tree: ast.Module) -> Iterator[str]:
    """The args that are declared with a boolean word as their default."""
    for node in walk(tree):
        if not (isinstance(node, ast.Call) and _word(node.func) == "DeclareLaunchArgument"):
            continue
        given = {each.arg: each.value for each in node.keywords}
        name = node.args[0] if node.args else given.get("name")
        default = given.get("default_value")
        if isinstance(name, ast.Constant) and isinstance(default, ast.Constant) and str(default.value).lower() in _WORDS:
            yield str(name.value)


def _word(function: ast.expr) -> str:
    return function.attr if isinstance(function, ast.Attribute) else function.id if isinstance(function, ast.Name) else ""


def _assigned(around: ast.AST) -> dict[str, str]:
    """Variables that hold a LaunchConfiguration, with its name; none that holds something else, too."""
    found: dict[str, str] = {}
    other: set[str] = set()
    for node in walk(around):
        if isinstance(node, ast.Assign) and len(node.targets) == 1 and isinstance(node.targets[0], ast.Name):
            name = _named(node.value)
            target = node.targets[0].id
            if name and found.get(target, name) == name:
                found[target] = name
            else:
                other.add(target)
    return {name: configuration for name, configuration in found.items() if name not in other}


def _named(node: ast.expr) -> str:
    """The name in ``LaunchConfiguration('name')``."""
    if isinstance(node, ast.Call) and _word(node.func) == "LaunchConfiguration" and node.args:
        first = node.args[0]
        return first.value if isinstance(first, ast.Constant) and isinstance(first.value, str) else ""
    return ""


def _configuration(node: ast.AST, made: Mapping[str, str]) -> str:
    """The name of the configuration that is performed: ``x.perform(context)``, ``context.launch_configurations['x']``."""
    if isinstance(node, ast.Call) and isinstance(node.func, ast.Attribute) and node.func.attr == "perform":
        of = node.func.value
        return made.get(of.id, "") if isinstance(of, ast.Name) else _named(of)
    if isinstance(node, ast.Subscript) and _word(node.value) == "launch_configurations" and isinstance(node.slice, ast.Constant):
        return str(node.slice.value)
    return ""


def _performed(routine: Routine, made: Mapping[str, str]) -> dict[str, str]:
    """Variables of a function that hold such a text, and nothing else."""
    found: dict[str, str] = {}
    other: set[str] = set()
    for node in walk(routine):
        targets = node.targets if isinstance(node, ast.Assign) else [node.target] if isinstance(node, (ast.AugAssign, ast.For)) else []
        for target in targets:
            name = _configuration(node.value, made) if isinstance(node, ast.Assign) else ""
            for each in walk(target):
                if isinstance(each, ast.Name):
                    if name and each is target:
                        found[each.id] = name
                    else:
                        other.add(each.id)
    return {name: configuration for name, configuration in found.items() if name not in other}


def _against_boolean(node: ast.AST) -> ast.Compare | None:
    """A comparison with True or False."""
    if isinstance(node, ast.Compare) and len(node.ops) == 1 and isinstance(node.ops[0], (ast.Eq, ast.NotEq, ast.Is, ast.IsNot)):
        side = node.comparators[0]
        return node if isinstance(side, ast.Constant) and isinstance(side.value, bool) else None
    return None
