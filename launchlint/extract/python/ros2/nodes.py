"""The nodes that a program has made so far, and which of them a value is."""

from __future__ import annotations

from collections.abc import Iterator

from launchlint.extract.fact import Made
from launchlint.extract.python.arguments import Call
from launchlint.extract.python.outside import NAMESPACE, NODE
from launchlint.extract.python.ros2.names import interface_type
from launchlint.python.text import ANY, template
from launchlint.python.values import MISSING, UNKNOWN, Choice, External, Handle, Instance, Value, alternatives, conjunction

TYPE_CHECKING = False
if TYPE_CHECKING:
    from launchlint.extract.python.ros2.run import Ros2Run

NODE_CLASSES = frozenset(("rclpy.node.Node", "rclpy.lifecycle.Node", "rclpy.lifecycle.LifecycleNodeMixin"))
LIFECYCLE = frozenset(("rclpy.lifecycle.Node", "rclpy.lifecycle.LifecycleNodeMixin"))
KNOWN_NODES = {"nav2_simple_commander.robot_navigator.BasicNavigator": "basic_navigator"}
"""Classes of other packages that are nodes, with the name that they give themselves."""
ELSEWHERE = "?"
"""The key of a node that is not known."""
MOST_NODES = 200


class Node:
    """One node: its key in facts, what is known of it, and the params that it has declared with their defaults."""

    __slots__ = ("declared", "made", "value")

    def __init__(self, value: Value, made: Made) -> None:
        self.value = value
        self.made = made
        self.declared: dict[str, Value] = {}


class Nodes:
    """The nodes of one program."""

    def __init__(self) -> None:
        self._all: list[Node] = []
        self._by_value: dict[int, Node] = {}

    @property
    def made(self) -> tuple[Made, ...]:
        """What is known of each, the first one first; those of one name are one."""
        return tuple({each.made.key: each.made for each in reversed(self._all)}.values())[::-1]

    def of(self, value: Value) -> Node | None:
        """The node that a value is; None where it is none, or not known to be one."""
        return self._by_value.get(id(value))

    def add(self, value: Value, made: Made) -> Node:
        """Note a node that is made."""
        alike = next(
            (each for each in self._all if made.name and (each.made.name, each.made.namespace) == (made.name, made.namespace)), None
        )
        if alike is not None:
            key = alike.made.key
        elif not self._all:
            key = ""
        else:
            key = made.name or f"{len(self._all)}"
            if any(each.made.key == key for each in self._all):
                key = f"{made.namespace}/{key}"
        node = Node(value, made._replace(key=key))
        self._all.append(node)
        self._by_value[id(value)] = node
        return node

    def __len__(self) -> int:
        return len(self._all)


def construct(run: Ros2Run, value: Value, made: Call, lifecycle: bool, name: str = "") -> None:
    """A node is made: ``Node(node_name, namespace=…, …)``.

    Args:
        run: the program.
        value: the node.
        made: the call.
        lifecycle: whether it is a lifecycle node.
        name: what it is called where the call does not say.
    """
    if run.nodes.of(value) is not None:
        return
    if len(run.nodes) >= MOST_NODES:
        made.doubt("it makes too many nodes to be followed")
        return
    allowed = ("allow_undeclared_parameters", "automatically_declare_parameters_from_overrides")
    namespace = made.get(MOST_NODES if not name else 1, "namespace", "")
    node = run.nodes.add(
        value,
        Made(
            name=_text(made.get(0, "node_name", name or UNKNOWN)),
            namespace=_text("" if namespace is None else namespace),
            lifecycle=lifecycle,
            undeclared=any(made.get(MOST_NODES, each, False) is not False for each in allowed),
            condition=conjunction(run.conditions),
            path=made.path,
            line=made.line,
        ),
    )
    if made.get(MOST_NODES, "enable_logger_service", False) is True:
        for word in ("Get", "Set"):
            made.fact("services", f"~/{word.lower()}_logger_levels", type=f"rcl_interfaces/srv/{word}LoggerLevels", node=node.made.key)


def _text(value: Value) -> str:
    """A name as a template; empty where it is not known."""
    spelled = "" if isinstance(value, (Choice, Handle, Instance)) else template(value)
    return "" if ANY in spelled or NODE in spelled or NAMESPACE in spelled else spelled


def is_node_class(value: Value) -> bool:
    """Whether a class outside is that of a node."""
    return isinstance(value, External) and (value.name in NODE_CLASSES or value.name in KNOWN_NODES)


def is_node(run: Ros2Run, value: Value) -> bool:
    """Whether a value is a node."""
    return run.nodes.of(value) is not None or (isinstance(value, Instance) and any(map(is_node_class, value.type.order)))


def keys(made: Call, value: Value) -> Iterator[str]:
    """The keys of the nodes that an argument can be, each under its condition; where it is none that is known, that is doubted."""
    run: Ros2Run = made.run  # type: ignore[assignment]
    for condition, each in alternatives(UNKNOWN if value is MISSING else value):
        mark = len(run.conditions)
        run.conditions += [condition] if condition else []
        node = run.nodes.of(each)
        if node is None:
            made.doubt(f"it gives {made.name.rpartition('.')[2]} a node that is not known")
        yield ELSEWHERE if node is None else node.made.key
        del run.conditions[mark:]


def is_interface(value: Value) -> bool:
    """Whether a value is the class of a message, service or action."""
    return interface_type(value) != ""
