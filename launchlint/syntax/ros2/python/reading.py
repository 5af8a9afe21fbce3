"""A launch file in Python as a description, without running it."""

from __future__ import annotations

import ast
import os
from collections.abc import Iterator

from launchlint.problem import Problem
from launchlint.python.failures import Raised
from launchlint.python.memory import Ended, Exhausted
from launchlint.python.source import Source as Parsed
from launchlint.python.source import SourceError
from launchlint.python.values import Choice, Function, Handle
from launchlint.source import Place, Source, Span
from launchlint.syntax.ros2 import description as described
from launchlint.syntax.ros2.description import Action, Description
from launchlint.syntax.ros2.python.ending import actions_of
from launchlint.syntax.ros2.python.entry import ENTRY, gives, needs_arguments, takes_arguments, unreadable, without_entry
from launchlint.syntax.ros2.python.following import Following
from launchlint.syntax.ros2.python.imports import wrong_imports
from launchlint.syntax.ros2.python.loading import runs_at_load
from launchlint.syntax.ros2.python.making import Maker
from launchlint.syntax.ros2.python.performed import performed_as_boolean
from launchlint.syntax.ros2.python.recogniser import Outside
from launchlint.syntax.ros2.python.running import Caller, Ending
from launchlint.syntax.ros2.python.unused import never_added, of_what_is_executed
from launchlint.syntax.ros2.python.workspace_modules import WorkspaceModules
from launchlint.syntax.ros2.reading import Reading
from launchlint.syntax.ros2.unresolved import unresolved

LARGEST = 1 << 20


def read(data: bytes, path: str, file: str, outside: Outside, package: str = "") -> Reading:
    """Read the content of a launch file in Python. Nothing of it is run. Never raises.

    Args:
        data: the whole file.
        path: the name shown to people.
        file: where it is, absolute.
        outside: what its functions ask of the machine.
        package: the directory of the package that it is of; empty where it is of none.
    """
    try:
        text = data.decode("utf-8-sig") if len(data) <= LARGEST else None
    except UnicodeDecodeError:
        text = None
    source = Source(path, text or "", file)
    everything = Place(source, Span(0, 0))
    if text is None:
        reason = "it is too large to be looked into" if len(data) > LARGEST else "it is no text in UTF-8"
        return _reading(source, (described.Open(reason, everything),), ())
    try:
        parsed = Parsed(ast.parse(text), len(text))
    except SyntaxError as error:
        problem = unreadable(source, error)
        reason = f"it is no Python that can be read here: {error}"
        return _reading(source, (described.Open(reason, everything),), () if problem is None else (problem,))
    except (ValueError, RecursionError, MemoryError) as error:
        return _reading(source, (described.Open(f"it is no Python: {error}", everything),), ())
    root = package or os.path.dirname(file)
    run = Following(source, outside, root, package, WorkspaceModules(outside.share))
    try:
        actions = _actions(run, source, outside, parsed)
        actions = (*run.asked(0), *actions)
    except Ended as ended:
        if isinstance(ended, Ending):
            run.record(ended.problem)
        stops = actions_of(ended, run, everything, called=False) if isinstance(ended, Raised) else ()
        actions = (
            *run.asked(0),
            *stops,
            described.Open(f"it ends with an error{f': {ended}' if str(ended) else ''}", everything),
        )
    except (Exhausted, RecursionError, SourceError):
        actions = (described.Open("it is too much to be followed", everything),)
    return _reading(source, actions, of_what_is_executed(run.problems))


def _reading(source: Source, actions: tuple[Action, ...], problems: tuple[Problem, ...]) -> Reading:
    return Reading(Description(actions, Place(source, Span(0, 0))), problems, source, unresolved=tuple(unresolved(actions)))


def _actions(run: Following, source: Source, outside: Outside, parsed: Parsed) -> tuple[Action, ...]:
    """What the file describes; what is wrong with it is noted on the way. Raises as the interpreter does."""
    everything = Place(source, Span(0, 0))
    main = run.main(source.file, parsed)
    for problem in wrong_imports(parsed.tree, lambda node: run.place(node, main.scope)):
        run.record(problem)
    for found in (runs_at_load, performed_as_boolean, never_added):
        for problem in found(parsed.tree, lambda node: run.place(node, main.scope)):
            run.record(problem)
    missing = without_entry(parsed.tree, source)
    if missing is not None:
        run.record(missing)
        return (described.Open(f"it has no function {ENTRY}", everything),)
    run.look_at(parsed.tree)
    caller = Caller(run, run.known.running, main.scope, run.known.environment)
    maker = caller.maker = Maker(run.known.texts, caller.calls, caller.loops)
    run.known.texts.gives = caller.gives
    main.scope.variables.update({"__name__": "launch_file", "__file__": source.file})
    if run.execute(parsed.tree.body, main.scope):
        if isinstance(run.raised, Raised):
            raise run.raised
        return (described.Open("it ends before its last statement", everything),)
    function = main.scope.variables.get(ENTRY)
    if not isinstance(function, Function):
        return (described.Open(f"it has no function {ENTRY} that is known", everything),)
    where = run.name_place(function)
    needed = [] if getattr(function.node, "decorator_list", ()) else needs_arguments(function)
    if needed:
        run.record(takes_arguments(needed, where))
        return (described.Open(f"{ENTRY} takes arguments", everything),)
    made = run.call_function(function, [], {})
    wrong = gives(made, where)
    if wrong is not None:
        run.record(wrong)
    if not isinstance(made, (Handle, Choice)):
        return (described.Open(f"what {ENTRY} gives is not known to be a LaunchDescription", everything),)
    risky = (described.Unsettled("what it asks of code that is not looked into may fail", everything),) if run.risks else ()
    return (*_environment(run, outside, everything), *risky, *maker.actions(made, everything))


def _environment(run: Following, outside: Outside, place: Place) -> Iterator[Action]:
    """What the file has set in the environment while it was loaded."""
    before, after = outside.environment, run.known.environment.entries
    texts = run.known.texts
    for name, value in dict(after).items():
        if isinstance(name, str) and (name not in before or value != before[name]):
            yield described.SetEnvironment(texts.text(name, place), texts.text(value, place), place)
    for name in before:
        if not dict.__contains__(after, name):
            yield described.UnsetEnvironment(texts.text(name, place), place)
