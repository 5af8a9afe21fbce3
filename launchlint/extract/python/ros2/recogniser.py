"""What lies outside of a program of ROS 2: rclpy, whose nodes make names by their methods, and the packages around it."""

from __future__ import annotations

from launchlint.extract.python.arguments import Call
from launchlint.extract.python.foreign import has_no_ros
from launchlint.extract.python.recogniser import RosRecogniser
from launchlint.extract.python.ros2 import api, described, libraries, nodes, params, qos
from launchlint.extract.python.ros2.canonical import canonical
from launchlint.python.values import MISSING, UNKNOWN, External, Handle, Instance, Map, Scope, Seq, Value, alternatives

TYPE_CHECKING = False
if TYPE_CHECKING:
    import ast
    from collections.abc import Sequence

    from launchlint.extract.python.ros2.run import Ros2Run

_DEEPEST = 3


class Ros2Recogniser(RosRecogniser):
    """Recognises for one run."""

    _run: Ros2Run

    def __init__(self, run: Ros2Run) -> None:
        super().__init__(run)
        self._profiles: dict[str, Handle | None] = {}

    def call(self, name: str, positional: list[Value], keywords: dict[str, Value], node: ast.AST, scope: Scope) -> Value:
        """Something outside is called. What is given a node, and is not known, may make any names of it."""
        name = canonical(name)
        head, _, member = name.rpartition(".")
        if nodes.is_node_class(External(head)) and positional and member in api.METHODS:  # Node.create_publisher(self, …)
            return self._of_node(positional[0], member, positional[1:], keywords, node, scope)
        if nodes.is_node_class(External(name)) and name not in libraries.HANDLERS:
            made = Handle("node", {})
            nodes.construct(self._run, made, Call(self._run, name, positional, keywords, node, scope), name in nodes.LIFECYCLE)
            return made
        if name.endswith(described.LISTENER):
            return described.listener(Call(self._run, name, positional, keywords, node, scope))
        if name not in libraries.HANDLERS and not name.endswith(".__init__"):
            self.doubt_given(name, [*positional, *keywords.values()], node, scope)
        return super().call(name, positional, keywords, node, scope)

    def attribute(self, name: str, member: str) -> Value:
        """``name.member`` of a module that is not followed."""
        found = super().attribute(name, member)
        if not isinstance(found, External):
            return found
        full = canonical(found.name)
        if full.startswith("rclpy.qos.") and full not in self._profiles:
            self._profiles[full] = qos.named(full)
        return self._profiles.get(full) or External(full)

    def member(self, receiver: Handle, name: str) -> Value:
        """What a param says, and the profile that an enumeration holds; all else that is not set is a method."""
        if receiver.kind == "qos" and name == "value":
            return receiver
        return params.member(receiver, name) if receiver.kind in ("parameter", "parameter value") else MISSING

    def method(
        self, receiver: Handle, name: str, positional: list[Value], keywords: dict[str, Value], node: ast.AST, scope: Scope
    ) -> Value:
        """Call a method of what a recognised call made."""
        if receiver.kind == "node":
            return self._of_node(receiver, name, positional, keywords, node, scope)
        return super().method(receiver, name, positional, keywords, node, scope)

    def inherited(
        self, base: str, instance: Instance, positional: list[Value], keywords: dict[str, Value], node: ast.AST, scope: Scope
    ) -> None:
        """The constructor of a base class that is not followed: that of a node makes it one."""
        base = canonical(base)
        made = Call(self._run, base, positional, keywords, node, scope)
        if base in nodes.KNOWN_NODES:
            libraries.navigator(made, instance)
        elif base in nodes.NODE_CLASSES:
            lifecycle = any(isinstance(each, External) and each.name in nodes.LIFECYCLE for each in instance.type.order)
            if base != "rclpy.lifecycle.LifecycleNodeMixin":
                nodes.construct(self._run, instance, made, lifecycle)
        else:
            self.doubt_given(base, [*positional, *keywords.values()], node, scope)
            super().inherited(base, instance, positional, keywords, node, scope)

    def inherited_method(
        self, name: str, instance: Value, positional: list[Value], keywords: dict[str, Value], node: ast.AST, scope: Scope
    ) -> Value:
        """A method that a followed class has from one that is not followed: where it is a node, it may be one of a node."""
        member = name.rpartition(".")[2]
        owner = External(name.rpartition(".")[0])
        if isinstance(instance, Instance) and member in api.METHODS and (nodes.is_node(self._run, instance) or self.is_open(owner.name)):
            return self._of_node(instance, member, positional, keywords, node, scope)
        self._run.escape([*positional, *keywords.values()], "message")
        return UNKNOWN

    def of_unknown(
        self, receiver: Value, name: str, positional: list[Value], keywords: dict[str, Value], node: ast.AST, scope: Scope
    ) -> Value:
        """A method of a node is called of a value that is not known."""
        made = Call(self._run, name, positional, keywords, node, scope)
        made.doubt(f"it calls {name} of a node that is not known")
        return api.METHODS[name](nodes.ELSEWHERE, None, made)

    def _of_node(
        self, receiver: Value, name: str, positional: list[Value], keywords: dict[str, Value], node: ast.AST, scope: Scope
    ) -> Value:
        made = Call(self._run, name, positional, keywords, node, scope)
        does = api.METHODS.get(name)
        if does is None:
            self._run.escape([*positional, *keywords.values()], "message")
            return UNKNOWN
        known = self._run.nodes.of(receiver)
        if known is None and name in api.MAKING:
            made.doubt(f"it calls {name} of a node whose making was not seen")
        return does(nodes.ELSEWHERE if known is None else known.made.key, known, made)

    def doubt_given(self, name: str, values: Sequence[Value], node: ast.AST, scope: Scope) -> None:
        """Note that something of which nothing is known has been given a node."""
        if name.startswith(("rclpy.", "builtins.")) or has_no_ros(name) or not self._has_node(values, 0):
            return
        Call(self._run, name, [], {}, node, scope).doubt(f"it gives a node to {name}, of which is not known what it does")

    def _has_node(self, values: Sequence[Value], depth: int) -> bool:
        for value in values:
            for _, each in alternatives(value):
                inner = each.items if isinstance(each, Seq) else list(each.entries.values()) if isinstance(each, Map) else ()
                if nodes.is_node(self._run, each) or (inner and depth < _DEEPEST and self._has_node(inner, depth + 1)):
                    return True
        return False
