"""How a program runs its nodes: the client library is begun, nodes are spun, executors are given them."""

from __future__ import annotations

from collections.abc import Callable as Does

from launchlint.extract.cpp.syntax import shortened
from launchlint.extract.cpp.values import UNKNOWN, Null, Thing, Value, choices, node_of
from launchlint.extract.fact import Doubt

TYPE_CHECKING = False
if TYPE_CHECKING:
    from launchlint.extract.cpp.calls import Call
    from launchlint.extract.cpp.machine import Machine

_EXECUTORS = (
    "Executor", "executors::SingleThreadedExecutor", "executors::MultiThreadedExecutor", "executors::StaticSingleThreadedExecutor",
    "executors::EventsExecutor", "experimental::executors::EventsExecutor",
)  # fmt: skip


def _nothing(asked: Call) -> Value:
    return UNKNOWN


def _begin(asked: Call) -> Value:
    """``rclcpp::init(argc, argv)``: who calls it means to have a node."""
    asked.machine.begun = asked.machine.begun or (asked.frame.path, asked.node.line)
    return UNKNOWN


def _spin(asked: Call) -> Value:
    """``rclcpp::spin(node)``, ``executor.add_node(node)``: a node of which nothing is known has names of its own."""
    for _, each in choices(asked.value(0)) if asked.arguments else ():
        followed = isinstance(each, Thing) and each.declared is not None  # its base class may be elsewhere, which is said there
        if node_of(each) is None and not isinstance(each, Null) and not followed:
            reason = f"it runs a node of which nothing is known: {shortened(asked.node.text)}"
            asked.machine.strangers.setdefault(Doubt("", reason, asked.frame.path, asked.node.line))
    return UNKNOWN


def _below(asked: Call) -> Value:
    """``rcl_publisher_init(…)``: an interface that is made without rclcpp."""
    asked.machine.doubt_all(f"{asked.name} makes an interface below rclcpp", asked.frame.path, asked.node.line)
    return UNKNOWN


def _of_executor(does: Does[[Call], Value]) -> Does[[Thing, Call], Value]:
    return lambda this, asked: does(asked)


def doubt_nodes(machine: Machine) -> None:
    """A program that runs a node which is not known, or begins the client library and has none, is not understood.

    Nothing is said where all of it is in doubt for another reason, which is why the node is not known.
    """
    from launchlint.extract.cpp.machine import CATEGORIES

    if len({each.category for each in machine.doubts}) == len(CATEGORIES):
        return
    for each in machine.strangers:
        machine.doubt_all(each.reason, each.path, each.line)
    if machine.begun is not None and not machine.nodes and not machine.doubts:
        machine.doubt_all("it uses rclcpp, and no node of it was found", *machine.begun)


FUNCTIONS: dict[str, Does[[Call], Value | None]] = {
    **dict.fromkeys(
        (
            f"rcl_{each}_init"
            for each in ("node", "publisher", "subscription", "service", "client", "action_server", "action_client")
        ),
        _below,
    ),
    **dict.fromkeys(("rclcpp::init", "rclcpp::init_and_remove_ros_arguments"), _begin),
    **dict.fromkeys((f"rclcpp::{name}" for name in ("spin", "spin_some", "spin_all", "spin_until_future_complete")), _spin),
    **dict.fromkeys(
        (
            f"rclcpp::{name}"
            for name in (
                "shutdown", "ok", "sleep_for", "get_logger", "on_shutdown", "remove_ros_arguments", "uninstall_signal_handlers",
                "install_signal_handlers", "executors::spin_node_until_future_complete", "executors::spin_node_once",
                "get_global_default_context", "contexts::get_global_default_context", "get_c_string",
            )
        ),
        _nothing,
    ),
}  # fmt: skip
METHODS: dict[tuple[str, str], Does[[Thing, Call], Value]] = {
    (f"rclcpp::{executor}", name): _of_executor(_spin if name == "add_node" else _nothing)
    for executor in _EXECUTORS
    for name in (
        "add_node", "remove_node", "spin_node_some", "spin_node_all", "spin_node_once", "add_callback_group", "spin_until_future_complete",
    )
}  # fmt: skip
