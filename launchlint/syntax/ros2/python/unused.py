"""Actions that a launch file in Python makes, keeps in a variable, and never looks at again: launch never sees them."""

from __future__ import annotations

import ast
from bisect import bisect_right
from collections.abc import Callable, Iterable, Iterator

from launchlint.problem import Problem
from launchlint.python.walking import walk
from launchlint.source import Origin, Place
from launchlint.syntax.ros2.python.problems import LaunchArgumentsNotPairs, NeverAdded, NotACondition

_ACTIONS = frozenset(
    """Node LifecycleNode ComposableNodeContainer LoadComposableNodes ExecuteProcess IncludeLaunchDescription GroupAction TimerAction
    DeclareLaunchArgument SetEnvironmentVariable SetLaunchConfiguration SetParameter SetRemap PushRosNamespace PushROSNamespace LogInfo
    RegisterEventHandler OpaqueFunction""".split()
)
_SETS = frozenset(("DeclareLaunchArgument", "SetEnvironmentVariable", "SetLaunchConfiguration", "SetParameter", "SetRemap"))
_SLIPS = 2
"""Actions that may be forgotten in one function."""
_LOOKING = frozenset(("locals", "vars", "eval", "exec"))


def never_added(tree: ast.Module, place: Callable[[ast.AST], Place]) -> Iterator[Problem]:
    """Each variable of a function that holds nothing but such an action, and that nothing reads."""
    made = _imported(tree)
    for routine in walk(tree):
        if not isinstance(routine, ast.FunctionDef):
            continue
        inside = list(walk(routine))
        names = [node for node in inside if isinstance(node, ast.Name)]
        read = {node.id for node in names if not isinstance(node.ctx, ast.Store)}
        shared = {name for node in inside if isinstance(node, (ast.Global, ast.Nonlocal)) for name in node.names}
        if read & _LOOKING:
            continue
        written = [node.id for node in names if isinstance(node.ctx, ast.Store)]
        found: list[tuple[Place, Place, str, bool]] = []
        added = 0
        for node in inside:
            if not isinstance(node, ast.Assign) or len(node.targets) != 1 or not isinstance(node.value, ast.Call):
                continue
            target = node.targets[0]
            callee = _word(node.value.func, made)
            if not isinstance(target, ast.Name) or callee not in _ACTIONS or written.count(target.id) != 1:
                continue
            if target.id not in read and target.id not in shared and not target.id.startswith("_"):
                at = place(target)
                found.append((at, place(node.value), callee, _is_commented(at)))
            elif callee not in _SETS:
                added += 1
        # Where more are commented out than added, people choose by comments what they start: what is missing is no slip. Neither is it
        # in what was cut down from a longer file.
        left_out = [commented for _, _, callee, commented in found if callee not in _SETS]
        chosen = sum(left_out) > added or len(left_out) > max(added, _SLIPS)
        together = " ".join(sorted(f"{callee} {at.text}" for at, _, callee, commented in found if not commented))
        for at, call, callee, commented in found:
            yield NeverAdded(
                origin=Origin(at), callee=callee, name=at.text, commented=commented, chosen=chosen, call=call, together=together
            )


def of_what_is_executed(problems: Iterable[Problem]) -> tuple[Problem, ...]:
    """``problems`` of a file, without those of its actions that are never added: what would stop launch there is related to what is said
    of the action.

    launch asks a condition, and takes the arguments of an include apart, only when it executes the action (``launch.Action.visit``,
    ``launch.actions.IncludeLaunchDescription.execute``).
    """
    problems = tuple(problems)
    left_out = sorted((each for each in problems if isinstance(each, NeverAdded)), key=lambda each: each.call.span)
    if not left_out:
        return problems
    starts = [each.call.span.start for each in left_out]  # statements, of which none stands in another
    waiting: dict[Problem, list[tuple[Place, str]]] = {}
    gone: set[Problem] = set()
    for problem in problems:
        words = _when_executed(problem)
        action = left_out[max(bisect_right(starts, problem.place.span.start) - 1, 0)]
        source, span = action.call
        if words and problem.place.source is source and span.start <= problem.place.span.start < span.end:
            waiting.setdefault(action, []).append((problem.place, f"{words}: launch would stop here, were it added"))
            gone.add(problem)
    return tuple(
        type(each)(**vars(each) | {"related": tuple(dict.fromkeys(waiting[each]))}) if each in waiting else each
        for each in problems
        if each not in gone
    )


def _when_executed(problem: Problem) -> str:
    """In words what is wrong, where launch sees it only when it executes the action; empty for all else."""
    if isinstance(problem, NotACondition):
        return "no condition"
    return "no pairs" if isinstance(problem, LaunchArgumentsNotPairs) and problem.is_dict and problem.refused else ""


def _imported(tree: ast.Module) -> dict[str, str]:
    """Names that are imported from launch and launch_ros, with those that they have there."""
    found: dict[str, str] = {}
    for node in walk(tree):
        if isinstance(node, ast.ImportFrom) and (node.module or "").partition(".")[0] in ("launch", "launch_ros"):
            found.update({alias.asname or alias.name: alias.name for alias in node.names})
    return found


def _word(function: ast.expr, made: dict[str, str]) -> str:
    if isinstance(function, ast.Name):
        return made.get(function.id, function.id if "*" in made else "")
    if isinstance(function, ast.Attribute) and ast.unparse(function).startswith(("launch.", "launch_ros.", "actions.")):
        return function.attr
    return ""


def _is_commented(place: Place) -> bool:
    """Whether a comment names the variable: the line that adds the action has been taken out."""
    name = place.text
    lines = place.source.text.splitlines()
    return any(name in line.partition("#")[2] for line in lines if "#" in line)
