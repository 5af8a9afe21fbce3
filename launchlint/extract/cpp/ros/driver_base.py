"""driver_base: a main() and a node class that drivers of the early days are built on (driver_common, driver_base/driver_node.h)."""

from __future__ import annotations

from launchlint.extract.cpp import classes
from launchlint.extract.cpp.spelled_type import Type
from launchlint.extract.cpp.values import UNKNOWN, Argument, Handle, Text, Thing, Value

TYPE_CHECKING = False
if TYPE_CHECKING:
    from launchlint.extract.cpp.calls import Call

_STEPS = ("addDiagnostics", "addOpenedTests", "addStoppedTests", "addRunningTests", "reconfigureHook")
_STEPS_OF_DRIVER = ("doOpen", "doStart", "doStop", "doClose", "config_update")


def main(asked: Call) -> Value:
    """``driver_base::main<Node>(argc, argv, name)``: the node is made with a node handle, and its driver opened and started."""
    machine = asked.machine
    node = classes.construct(machine, asked.types[0], [Argument(Handle(""))], asked.node, asked.frame) if asked.types else UNKNOWN
    if not isinstance(node, Thing) or node.declared is None:
        machine.doubt_all("driver_base::main runs a node that is not in these sources", asked.frame.path, asked.node.line)
        return UNKNOWN
    driver = node.fields.get("driver_")
    _run(asked, node, _STEPS)
    if driver is not None and isinstance(driver.value, Thing):
        _run(asked, driver.value, _STEPS_OF_DRIVER)
    return UNKNOWN


def _run(asked: Call, thing: Thing, names: tuple[str, ...]) -> None:
    for name in names:
        for function in classes.methods(asked.machine, thing, name):
            asked.machine.call(function, thing, [Argument(UNKNOWN) for _ in function.parameters])


def node(asked: Call) -> Value:
    """``driver_base::DriverNode<Driver>(handle)``: diagnostics, a self test, dynamic_reconfigure with ``Driver::Config``."""
    from launchlint.extract.cpp.ros import library

    machine, at, frame = asked.machine, asked.node, asked.frame
    handle = asked.value(0) if isinstance(asked.value(0), Handle) else Handle("")
    private = Handle("~")
    machine.serial += 1
    thing = Thing(Type("driver_base::DriverNode", asked.types), None, machine.serial)
    thing.fields["node_handle_"] = machine.cell(handle)
    thing.fields["private_node_handle_"] = machine.cell(private)
    for name in ("diagnostic_updater::Updater", "self_test::TestRunner"):
        library.MAKERS[name](asked._replace(name=name, arguments=()))
    if asked.types:
        thing.fields["driver_"] = machine.cell(classes.construct(machine, asked.types[0], [], at, frame), asked.types[0])
        config = Type(f"{asked.types[0].name}::Config")
        name = "dynamic_reconfigure::Server"
        library.MAKERS[name](asked._replace(name=name, types=(config,), arguments=[Argument(private)]))
    else:
        machine.doubt_all("the driver of a driver_base::DriverNode is not known", frame.path, at.line)
    for name in ("self_test_", "diagnostic_"):
        thing.fields[name] = machine.cell(Text(""))
    return thing
