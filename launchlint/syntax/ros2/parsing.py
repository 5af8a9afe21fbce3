"""Entities to actions: what launch reads of each entity, in its order, and what it refuses.

Launch stops at the first problem. Here the reading goes on: what is missing or wrong is left out, or replaced by what says nothing.
"""

from __future__ import annotations

from launchlint.source import Origin
from launchlint.syntax.ros2 import complaints, substitutions
from launchlint.syntax.ros2.actions import MAKE
from launchlint.syntax.ros2.description import Condition, Text
from launchlint.syntax.ros2.fields import Fields
from launchlint.syntax.ros2.kinds import WANTED, made
from launchlint.syntax.ros2.parameters import parameters
from launchlint.syntax.ros2.problems import BothConditions, TooDeep, WrongValue
from launchlint.syntax.ros2.tables import Actions, Attribute, Children, Conditions
from launchlint.syntax.ros2.words import EXPECTED

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Iterable

    from launchlint.problem import Problem
    from launchlint.syntax.ros2.description import Action
    from launchlint.syntax.ros2.entity import Entity
    from launchlint.syntax.ros2.tables import Distribution, Read
    from launchlint.syntax.ros2.written import Written

DEEPEST = 180
"""Actions that may stand in each other: launch takes five frames of Python's 1,000 for each."""

_EXACT = "ros_timer"
"""Its period must be a number already, where ``timer`` makes one of a text (launch_ros.actions.ROSTimer, launch.actions.TimerAction)."""


class Parser:
    """Reads entities for one distribution; ``problems`` fills in launch's order."""

    __slots__ = ("_depth", "distribution", "problems")

    def __init__(self, distribution: Distribution) -> None:
        self.distribution = distribution
        self.problems: list[Problem] = []
        self._depth = 0

    def text(self, written: Written) -> Text:
        """The pieces of a value."""
        return substitutions.parse(written, self.distribution, self.problems)

    def actions(self, entities: Iterable[Entity], parent: str) -> tuple[Action, ...]:
        """The actions that ``entities``, which stand in ``parent``, describe."""
        found: list[Action] = []
        self._depth += 1
        for entity in entities:
            if self._depth > DEEPEST:
                self.problems.append(TooDeep(origin=Origin(entity.name_place), refused=True, deepest=DEEPEST))
                break
            action = self._action(entity, parent)
            if action is not None:
                found.append(action)
        self._depth -= 1
        return tuple(found)

    def _action(self, entity: Entity, parent: str) -> Action | None:
        tag = self.distribution.tags.get(entity.tag)
        if tag is None:
            complaints.unknown_action(self, entity, parent)
            return None
        shapeless = entity.shapeless()
        if shapeless is not None:
            self.problems.append(shapeless)
            return None
        fields = self._read(entity, tag.reads)
        self._unread(entity, tag.reads)
        for name in tag.needs:
            if not entity.has(name):
                complaints.lacks(self, entity, name)
        self._made(entity.tag, fields)
        return MAKE[tag.name](fields)

    def _read(self, entity: Entity, reads: tuple[Read, ...]) -> Fields:
        """What ``reads`` names, in this order."""
        fields = Fields(entity.place)
        for each in reads:
            if isinstance(each, Attribute):
                fields.put(each.name, self._attribute(entity, each))
            elif isinstance(each, Conditions):
                fields.put("if", self._condition(entity))
            elif isinstance(each, Children):
                fields.put(each.name, self._children(entity, each))
            elif isinstance(each, Actions):
                named = complaints.children_of(reads)
                children = [child for child in entity.children(self.problems) if child.tag not in named]
                fields.put("actions", self.actions(children, entity.tag))
            else:
                fields.put("param", parameters(self, entity))
        return fields

    def _attribute(self, entity: Entity, attribute: Attribute) -> object:
        value = entity.value(attribute.name, WANTED.get(attribute.kind, "str"), self.problems)
        if value is not None:
            return made(self, entity.tag, attribute.name, attribute.kind, value)
        if attribute.required and not entity.has(attribute.name):
            complaints.lacks(self, entity, attribute.name)
        return None

    def _condition(self, entity: Entity) -> Condition | None:
        first = entity.value("if", "str", self.problems)
        second = entity.value("unless", "str", self.problems)
        if first is not None and second is not None:
            one, other = sorted((entity.attribute_place("if"), entity.attribute_place("unless")), key=lambda place: place.span)
            related = ((one, "the other condition"),)
            self.problems.append(BothConditions(origin=Origin(other), refused=True, related=related, tag=entity.tag))
        if first is not None:
            return Condition("if", (self.text(first.text),), first.place)
        if second is not None:
            return Condition("unless", (self.text(second.text),), second.place)
        return None

    def _children(self, entity: Entity, children: Children) -> tuple[Fields, ...] | None:
        """What was read of the children with a name of their own; None where there are none."""
        found = entity.named(children.name, self.problems)
        if found is None:
            if children.required:
                complaints.lacks(self, entity, children.name, child=True)
            return None
        read: list[Fields] = []
        for each in found:
            read.append(self._read(each, children.reads))
            if children.checked == "each":
                self._unread(each, children.reads)
        if children.checked == "all":
            for each in found:
                self._unread(each, children.reads)
        return tuple(read)

    def _unread(self, entity: Entity, reads: tuple[Read, ...]) -> None:
        complaints.unread(self, entity, complaints.attributes_of(reads), complaints.children_of(reads))

    def _made(self, tag: str, fields: Fields) -> None:
        """What launch refuses only when it makes the action: a text where a number, or true or false, is wanted."""
        for name, wanted in (("period", "float"), ("prepend", "bool"), ("cancel_on_shutdown", "bool")):
            text = fields.text(name)
            if text is None or text.literal is None or (wanted == "float" and tag != _EXACT and _is_number(text.literal)):
                continue
            self.problems.append(
                WrongValue(origin=Origin(text.place), refused=True, tag=tag, attribute=name, value=text.literal, expected=EXPECTED[wanted])
            )


def _is_number(text: str) -> bool:
    try:
        float(text)
    except ValueError:
        return False
    return True
