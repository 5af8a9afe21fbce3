"""Where a launch file sets a launch configuration that is not set where it is read: below, or in a group that has ended."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from launchlint.syntax.ros2.description import Action, Argument, Group, Let, Timer

TYPE_CHECKING = False
if TYPE_CHECKING:
    from launchlint.evaluate.session import Session
    from launchlint.source import Place, Source

_ENDS = (".xml", ".launch", ".yaml", ".yml")


def set_elsewhere(session: Session, source: Source, name: str) -> tuple[Place, ...]:
    """The places of ``source`` that set the configuration ``name`` under no condition; none of what is no launch file in XML or YAML."""
    known = session.reading(source.file) if source.file.endswith(_ENDS) else None
    description = getattr(known, "description", None)
    return () if description is None else tuple(_setting(description.actions, name))


def _setting(actions: Iterable[Action], name: str) -> Iterator[Place]:
    for action in actions:
        if action.condition is not None:
            continue
        if isinstance(action, (Group, Timer)):
            yield from _setting(action.actions, name)
        elif _sets(action, name):
            yield action.place


def _sets(action: Action, name: str) -> bool:
    if isinstance(action, Argument):
        return action.name == name and action.default is not None
    return isinstance(action, Let) and action.name.literal == name
