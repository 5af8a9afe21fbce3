"""Event handlers that end the launch when a process ends: in XML and YAML that is an attribute of the process, ``on_exit``."""

from __future__ import annotations

from collections import Counter

from launchlint.syntax.ros2 import description as described

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Iterable, Iterator

    from launchlint.syntax.ros2.description import Action, Process


def ending(actions: tuple[Action, ...]) -> tuple[Action, ...]:
    """``actions`` with ``on_exit="shutdown"`` in place of each handler that does the same.

    Such a handler waits for one process, which does nothing else when it ends, and shuts down; it is there whenever that process is.
    """
    processes = [each for each in _all(actions) if isinstance(each, (described.Node, described.Executable))]
    at = Counter(each.place.key for each in processes)
    free = {each.place.key for each in processes if at[each.place.key] == 1 and _is_free(each.process)}
    handlers = [each for each in _always_there(actions) if each.target is not None and each.target.key in free]
    ended = {each.target.key for each in handlers if each.target is not None}
    return tuple(_written(actions, ended, {id(each) for each in handlers})) if handlers else actions


def shuts_down(actions: object) -> bool:
    """Whether these actions shut down, and do nothing else."""
    return isinstance(actions, tuple) and len(actions) == 1 and isinstance(actions[0], described.Shutdown) and actions[0].condition is None


def _always_there(actions: Iterable[Action]) -> Iterator[described.Handler]:
    """The handlers that shut down when a process ends, and that stand under no condition."""
    for each in actions:
        if isinstance(each, described.Group) and each.condition is None:
            yield from _always_there(each.actions)
        elif isinstance(each, described.Handler) and each.condition is None and each.event == "OnProcessExit" and shuts_down(each.actions):
            yield each


def _is_free(process: Process) -> bool:
    """Whether a process does nothing when it ends, and is not started again then."""
    return process.on_exit is None and process.respawn in (None, False)


def _all(actions: Iterable[Action]) -> Iterator[Action]:
    for each in actions:
        yield each
        if isinstance(each, (described.Group, described.Timer, described.Maybe, described.Handler)) and isinstance(each.actions, tuple):
            yield from _all(each.actions)


def _written(actions: Iterable[Action], ended: set[tuple[str, int]], gone: set[int]) -> Iterator[Action]:
    for each in actions:
        if id(each) in gone:
            continue
        if isinstance(each, (described.Node, described.Executable)) and each.place.key in ended:
            yield each._replace(process=each.process._replace(on_exit="shutdown"))
        elif isinstance(each, (described.Group, described.Timer)):
            yield each._replace(actions=tuple(_written(each.actions, ended, gone)))
        else:
            yield each
