"""A launch file in Python as a description, without running it."""

from __future__ import annotations

import ast
import os

from launchlint.python.memory import Ended, Exhausted
from launchlint.python.source import SourceError, parse_text
from launchlint.python.values import Function, Handle
from launchlint.source import Place, Source, Span
from launchlint.syntax.ros2.description import Description
from launchlint.syntax.ros2.python.making import Maker
from launchlint.syntax.ros2.python.recogniser import Outside
from launchlint.syntax.ros2.python.strict import Strict, StrictModules, loose
from launchlint.syntax.ros2.python.texts import NotUnderstood
from launchlint.syntax.ros2.reading import Reading

ENTRY = "generate_launch_description"
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
        NotUnderstood: what it describes cannot be told as a whole, or launch would refuse it; says why.
    """
    try:
        text = data.decode("utf-8-sig") if len(data) <= LARGEST else ""
        tree = ast.parse(text)
        if len(data) > LARGEST:
            raise NotUnderstood("it is too large")
        parsed = parse_text(text)
    except (SyntaxError, ValueError, RecursionError, MemoryError) as error:
        raise NotUnderstood(f"it is no Python: {error}") from None
    reason = loose(tree)
    if reason:
        raise NotUnderstood(reason)
    source = Source(path, text, file)
    root = package or os.path.dirname(file)
    run = Strict(source, outside, root, package, StrictModules({}))
    try:
        main = run.main(file, parsed)
        main.scope.variables.update({"__name__": "launch_file", "__file__": file})
        if run.execute(parsed.tree.body, main.scope):
            raise NotUnderstood("it ends before its last statement")
        function = main.scope.variables.get(ENTRY)
        if not isinstance(function, Function):
            raise NotUnderstood(f"it has no function {ENTRY}")
        arguments = function.node.args
        if arguments.args or arguments.posonlyargs or arguments.kwonlyargs:
            raise NotUnderstood(f"{ENTRY} takes arguments")
        made = run.call_function(function, [], {})
        if run.environment.entries != outside.environment:
            raise NotUnderstood("it changes the environment")
    except (Ended, Exhausted, RecursionError, SourceError):
        raise NotUnderstood("it ends with an error, or is too much to be followed") from None
    finally:
        run.leave()
    if not isinstance(made, Handle) or made.kind != "LaunchDescription":
        raise NotUnderstood(f"{ENTRY} gives what is not known to be a LaunchDescription")
    everything = Place(source, Span(0, 0))
    maker = Maker()
    maker.once(made)
    try:
        actions = maker.actions(made.state["initial_entities"], everything)
    except RecursionError:
        raise NotUnderstood("actions in actions too deep to be followed") from None
    return Reading(Description(actions, everything), (), source)
