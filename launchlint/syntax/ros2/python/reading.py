"""A launch file in Python as a description, without running it."""

from __future__ import annotations

import ast
import os
from collections.abc import Sequence

from launchlint.problem import Problem
from launchlint.python.memory import Ended, Exhausted
from launchlint.python.source import Source as Parsed
from launchlint.python.source import SourceError, parse_text
from launchlint.python.values import Function, Handle
from launchlint.source import Place, Source, Span
from launchlint.syntax.ros2.description import Action, Description
from launchlint.syntax.ros2.python.entry import ENTRY, gives, needs_arguments, takes_arguments, unreadable, without_entry
from launchlint.syntax.ros2.python.imports import wrong_imports
from launchlint.syntax.ros2.python.making import Maker
from launchlint.syntax.ros2.python.recogniser import Outside
from launchlint.syntax.ros2.python.strict import Strict, StrictModules, loose
from launchlint.syntax.ros2.python.texts import NotUnderstood
from launchlint.syntax.ros2.reading import Reading

LARGEST = 1 << 20


def read(data: bytes, path: str, file: str, outside: Outside, package: str = "") -> Reading:
    """Read the content of a launch file in Python. Nothing of it is run.

    Args:
        data: the whole file.
        path: the name shown to people.
        file: where it is, absolute.
        outside: what its functions ask of the machine.
        package: the directory of the package that it is of; empty where it is of none.

    Raises:
        NotUnderstood: what it describes cannot be told as a whole, and no reason is known why launch would refuse it; says why.
    """
    try:
        text = data.decode("utf-8-sig") if len(data) <= LARGEST else ""
    except UnicodeDecodeError as error:
        raise NotUnderstood(f"it is no text: {error}") from None
    if len(data) > LARGEST:
        raise NotUnderstood("it is too large")
    source = Source(path, text, file)
    try:
        tree = ast.parse(text)
        parsed = parse_text(text)
    except SyntaxError as error:
        problem = unreadable(source, error)
        if problem is None:
            raise NotUnderstood(f"it is no Python that can be read here: {error}") from None
        return _refused(source, [problem])
    except (ValueError, RecursionError, MemoryError) as error:
        raise NotUnderstood(f"it is no Python: {error}") from None
    root = package or os.path.dirname(file)
    run = Strict(source, outside, root, package, StrictModules({}))
    try:
        actions = _actions(run, file, source, tree, parsed)
    except NotUnderstood as reason:
        if not any(problem.refused for problem in run.problems):
            reason.problems = tuple(run.problems)
            raise
        return _refused(source, run.problems)
    finally:
        run.leave()
    return Reading(Description(actions, Place(source, Span(0, 0))), tuple(run.problems), source)


def _refused(source: Source, problems: Sequence[Problem]) -> Reading:
    """A file that launch does not load, and of which no more is known than why."""
    return Reading(Description((), Place(source, Span(0, 0))), tuple(problems), source)


def _actions(run: Strict, file: str, source: Source, tree: ast.Module, parsed: Parsed) -> tuple[Action, ...]:
    """What the file describes; what is wrong with it is noted on the way. Raises NotUnderstood."""
    main = run.main(file, parsed)
    for problem in wrong_imports(parsed.tree, lambda node: run.place(node, main.scope)):
        run.record(problem)
    missing = without_entry(tree, source)
    if missing is not None:
        run.record(missing)
        raise NotUnderstood(f"it has no function {ENTRY}")
    reason = loose(tree)
    if reason:
        raise NotUnderstood(reason)
    run.look_at(parsed.tree)
    try:
        main.scope.variables.update({"__name__": "launch_file", "__file__": file})
        if run.execute(parsed.tree.body, main.scope):
            raise NotUnderstood("it ends before its last statement")
        function = main.scope.variables.get(ENTRY)
        if not isinstance(function, Function):
            raise NotUnderstood(f"it has no function {ENTRY}")
        where = run.name_place(function)
        needed = needs_arguments(function)
        if needed:
            run.record(takes_arguments(needed, where))
            raise NotUnderstood(f"{ENTRY} takes arguments")
        made = run.call_function(function, [], {})
        if run.environment.entries != run.outside.environment:
            raise NotUnderstood("it changes the environment")
    except (Ended, Exhausted, RecursionError, SourceError):
        raise NotUnderstood("it ends with an error, or is too much to be followed") from None
    wrong = gives(made, where)
    if wrong is not None:
        run.record(wrong)
    if not isinstance(made, Handle) or made.kind != "LaunchDescription":
        raise NotUnderstood(f"{ENTRY} gives what is not known to be a LaunchDescription")
    maker = Maker()
    maker.once(made)
    try:
        return maker.actions(made.state["initial_entities"], Place(source, Span(0, 0)))
    except RecursionError:
        raise NotUnderstood("actions in actions too deep to be followed") from None
