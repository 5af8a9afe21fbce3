"""Where a launch file sets a launch configuration that is not set where it is read: below, or in a group that has ended."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from launchlint.syntax.ros2.description import Action, Argument, Description, Group, Let, Timer

TYPE_CHECKING = False
if TYPE_CHECKING:
    from launchlint.evaluate.session import Session
    from launchlint.source import Place, Source

_ENDS = (".xml", ".launch", ".yaml", ".yml")


def set_elsewhere(session: Session, source: Source, name: str) -> tuple[Place, ...]:
    """The places of ``source`` that set the configuration ``name`` under no condition; none of what is no launch file in XML or YAML."""
    known = session.reading(source.file) if source.file.endswith(_ENDS) else None
    description = getattr(known, "description", None)
    return () if description is None else tuple(session.once(description, _settings).get(name, ()))


def _settings(description: Description) -> dict[str, list[Place]]:
    """What a description sets under no condition, and where."""
    places: dict[str, list[Place]] = {}
    for name, place in _set(description.actions):
        places.setdefault(name, []).append(place)
    return places


def _set(actions: Iterable[Action]) -> Iterator[tuple[str, Place]]:
    for action in actions:
        if action.condition is not None:
            continue
        if isinstance(action, (Group, Timer)):
            yield from _set(action.actions)
        elif isinstance(action, Argument) and action.default is not None:
            yield action.name, action.place
        elif isinstance(action, Let) and action.name.literal is not None:
            yield action.name.literal, action.place
