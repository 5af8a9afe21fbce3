"""One Python program of ROS 2 as it is followed: from its entry point, with the nodes that it makes."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

from launchlint.extract.fact import Fact, Made
from launchlint.extract.python.modules import PackageModules
from launchlint.extract.python.program import Run
from launchlint.extract.python.ros2 import api, nodes
from launchlint.extract.python.ros2.names import NodeParam, is_of_each
from launchlint.extract.python.ros2.recognised import RCLPY
from launchlint.extract.python.ros2.recogniser import Ros2Recogniser
from launchlint.python.values import Bound, Class, External, Instance, Scope, Seq, Unknown, Value, alternatives

TYPE_CHECKING = False
if TYPE_CHECKING:
    import ast

    from launchlint.extract.described_params import Description

_TRANSITIONS = {
    "on_configure": "configured",
    "on_activate": "active",
    "on_deactivate": "active",
    "on_cleanup": "configured",
    "on_shutdown": "configured",
    "on_error": "configured",
}
"""What calls the methods of a lifecycle node, in order: in which state the node is when they have made something."""
_ASKED = frozenset((*api.MAKING, "get_parameter"))
"""Methods that nothing but a node has."""


class Ros2Run(Run):
    """Follows a program of ROS 2."""

    dialect = RCLPY
    recognise = Ros2Recogniser
    recogniser: Ros2Recogniser

    def __init__(self, root: str, package: str, finder: PackageModules, beside: str) -> None:
        super().__init__(root, package, finder, beside)
        self.nodes = nodes.Nodes()
        self.exists = ""
        self.descriptions: dict[tuple[str, str], Description | None] = {}

    @property
    def made(self) -> tuple[Made, ...]:
        """The nodes, the first one first."""
        return self.nodes.made

    def note(self, fact: Mapping[str, Any], condition: str) -> None:
        """Note a fact under the conditions that hold here and ``condition``."""
        super().note({"exists": self.exists, **fact}, condition)

    def settled(self) -> list[Fact]:
        """The facts, those of nodes that were not known as of the only one there is; where there are several, they stay doubts."""
        if len(self.nodes.made) > 1:
            return [each for each in self.facts if each.node != nodes.ELSEWHERE]
        return [each._replace(node="") if each.node == nodes.ELSEWHERE else each for each in self.facts]

    def rounds(self, value: Value) -> tuple[list[Value], bool]:
        """What a loop takes. Of a param that is a list, and of what is made of each of its values, it takes that, once and for all."""
        if isinstance(value, NodeParam):
            return [value.each()], False
        if isinstance(value, Seq) and not value.complete and len(value.items) == 1 and is_of_each(value.items[0]):
            return value.items, False
        return super().rounds(value)

    # -- what is called -------------------------------------------------------------------------------------------------

    def attribute(self, value: Value, name: str, node: ast.AST, scope: Scope) -> Value:
        """``value.name``: a value that is not known may be a node."""
        if isinstance(value, Unknown) and name in _ASKED:
            self.unknown_methods.add(name)
            return Bound(value, name)
        return super().attribute(value, name, node, scope)

    def call_method(
        self, receiver: Value, name: Value, positional: list[Value], keywords: dict[str, Value], node: ast.AST, scope: Scope
    ) -> Value:
        """Call a method of something that is no object of a followed class."""
        if isinstance(receiver, Unknown) and name in _ASKED:
            return self.recogniser.of_unknown(receiver, name, positional, keywords, node, scope)
        return super().call_method(receiver, name, positional, keywords, node, scope)

    def _found(self, order: Sequence[Value], name: str, receiver: Instance | None, cls: Class | None) -> Value:
        if name not in api.ATTRIBUTES and any(isinstance(each, Class) and name in each.attributes for each in order):
            order = [each for each in order if not nodes.is_node_class(each)]  # a node does not have it: a class behind it does
        return super()._found(order, name, receiver, cls)

    def escape(self, values: Sequence[Value], when: str, depth: int = 0) -> None:
        """Values are given to code that is not followed. Nobody calls the methods of a node but those that it was made for."""
        super().escape([each for value in values for _, each in alternatives(value) if not self._is_plain_node(each)], when, depth)

    def _give(self, values: list[Value], node: ast.AST, scope: Scope) -> None:
        """Values are given to something of which nothing is known: with a node it may make any names."""
        self.recogniser.doubt_given("something", values, node, scope)
        super()._give(values, node, scope)

    def _is_plain_node(self, value: Value) -> bool:
        return isinstance(value, Instance) and self._of_rclpy(value.type.order)

    @staticmethod
    def _of_rclpy(order: Sequence[Value]) -> bool:
        outside = [each for each in order if isinstance(each, External) and each.name != "builtins.object"]
        return bool(outside) and all(map(nodes.is_node_class, outside))

    def arrange(self, function: Value, when: str, positional: list[Value] | None = None, keywords: dict[str, Value] | None = None) -> None:
        """Have a function called later. What a callback of a state makes is there from that state on."""
        super().arrange(function, f"{when}@{self.exists}" if self.exists and "@" not in when else when, positional, keywords)

    def _callable(self, instance: Instance, foreign: list[Value]) -> list[tuple[str, str]]:
        if not self._of_rclpy(instance.type.order):
            return super()._callable(instance, foreign)
        if not any(each.name in nodes.LIFECYCLE for each in foreign if isinstance(each, External)):
            return []
        return [(name, f"start@{state}") for name, state in _TRANSITIONS.items()]

    def _enter(self, when: str) -> None:
        self.when, _, self.exists = when.partition("@")

    # -- the end --------------------------------------------------------------------------------------------------------

    def doubt_nothing(self, path: str) -> None:
        """A program that uses rclpy and of which no node was found is not understood."""
        if self.uses_ros and not self.nodes.made and not self.doubts:
            self.doubt("it uses rclpy, and no node of it was found", path, 1)
