"""Problems about what stands in an entity and should not, or does not and should: each made in one place."""

from __future__ import annotations

from launchlint.source import Origin
from launchlint.syntax.ros2 import of_ros1
from launchlint.syntax.ros2.problems import (
    LacksAttribute,
    MisplacedEntity,
    NotInDistribution,
    OfRos1,
    UnknownAction,
    UnreadAttribute,
)
from launchlint.syntax.ros2.tables import PARAMETER, TAGS, Attribute, Children, Conditions, Parameters

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Iterable, Sequence

    from launchlint.syntax.ros2.entity import Entity
    from launchlint.syntax.ros2.parsing import Parser
    from launchlint.syntax.ros2.problems import Where
    from launchlint.syntax.ros2.tables import Read


def lacks(parser: Parser, entity: Entity, name: str, child: bool = False) -> None:
    """The attribute (or the child) ``name`` is missing; at the tag's name."""
    parser.problems.append(
        LacksAttribute(origin=Origin(entity.name_place), refused=True, tag=entity.tag, attribute=name, given=entity.given, child=child)
    )


def unknown_action(parser: Parser, entity: Entity, parent: str) -> None:
    """``entity`` stands where an action must, and is none."""
    name, origin = entity.tag, Origin(entity.name_place)
    tag = TAGS.get(name)
    if tag is not None:
        _absent(parser, origin, "tag", name, parent, tag.since)
    elif name in of_ros1.TAGS:
        instead = of_ros1.TAGS[name]
        parser.problems.append(OfRos1(origin=origin, refused=True, tag=parent, what="tag", construct=name, instead=instead))
    else:
        _unknown(parser, entity, parent, tuple(parser.distribution.tags), child=False)


def _unknown(parser: Parser, entity: Entity, parent: str, known: tuple[str, ...], *, child: bool) -> None:
    """``entity`` is nothing that may stand in ``parent``."""
    name, origin = entity.tag, Origin(entity.name_place)
    holders = tuple(tag.name for tag in TAGS.values() if name in children_of(tag.reads))
    action = name in parser.distribution.tags
    if holders or action:
        parser.problems.append(
            MisplacedEntity(origin=origin, refused=True, tag=name, parent=parent, holders=holders, action=action, known=known)
        )
    elif child and name in of_ros1.TAGS:
        instead = of_ros1.TAGS[name]
        parser.problems.append(OfRos1(origin=origin, refused=True, tag=parent, what="tag", construct=name, instead=instead))
    else:
        parser.problems.append(UnknownAction(origin=origin, refused=True, tag=name, parent=parent, known=known, child=child))


def unread(parser: Parser, entity: Entity, attributes: Sequence[str], children: Sequence[str]) -> None:
    """What launch did not read of ``entity``, which has these attributes and children."""
    tags, names = entity.unread()
    for child in tags:
        _unknown(parser, child, entity.tag, tuple(children), child=True)
    if not names:
        return
    tag = TAGS.get(entity.tag)
    newer = {} if tag is None else {each.name: each.since for each in tag.reads if isinstance(each, Attribute)}
    given = entity.given
    free = tuple(each for each in attributes if each not in given)
    for name in names:
        origin = Origin(entity.attribute_place(name))
        if name in newer and not parser.distribution.has(newer[name]):
            _absent(parser, origin, "attribute", name, entity.tag, newer[name])
            continue
        kind = "node" if entity.tag == "node_container" else entity.tag
        instead = of_ros1.ATTRIBUTES.get(kind, {}).get(name)
        if instead is not None:
            renamed = instead if instead in of_ros1.RENAMED and instead not in given else ""
            parser.problems.append(
                OfRos1(origin=origin, refused=True, tag=entity.tag, what="attribute", construct=name, instead=instead, renamed=renamed)
            )
            continue
        parser.problems.append(
            UnreadAttribute(
                origin=origin,
                refused=True,
                tag=entity.tag,
                attribute=name,
                known=free,
                given=given,
                owners=_owners(name, entity.tag),
            )
        )


def attributes_of(reads: Iterable[Read]) -> tuple[str, ...]:
    """The names of the attributes that are read, conditions too."""
    found: list[str] = []
    for each in reads:
        if isinstance(each, Attribute):
            found.append(each.name)
        elif isinstance(each, Conditions):
            found.extend(("if", "unless"))
    return tuple(found)


def children_of(reads: Iterable[Read]) -> tuple[str, ...]:
    """The names of the children that are read by name."""
    return tuple(each.name if isinstance(each, Children) else "param" for each in reads if isinstance(each, (Children, Parameters)))


def _owners(name: str, but: str) -> tuple[str, ...]:
    """The tags that have an attribute ``name``."""
    found = [tag.name for tag in TAGS.values() if name in attributes_of(tag.reads)]
    return tuple(tag for tag in (*found, *(["param"] if name in PARAMETER else [])) if tag != but)


def _absent(parser: Parser, origin: Origin, what: Where, name: str, tag: str, since: str) -> None:
    parser.problems.append(
        NotInDistribution(
            origin=origin,
            refused=True,
            what=what,
            name=name,
            tag=tag,
            distro=parser.distribution.name,
            since=since,
            sure=parser.distribution.lacks_for_sure(name, since),
        )
    )
