"""Nodelets: where following one begins."""

from __future__ import annotations

from launchlint.extract.cpp import classes
from launchlint.extract.cpp.declarations import Class, Function
from launchlint.extract.cpp.naming import UNKNOWN_SPACE
from launchlint.extract.cpp.values import UNKNOWN, Argument, Handle, Thing, Value
from launchlint.extract.fact import Fact

TYPE_CHECKING = False
if TYPE_CHECKING:
    from launchlint.extract.cpp.machine import Machine

_LAZY_PARAMS: tuple[tuple[str, bool | float | None, str], ...] = (
    ("~lazy", True, "bool"),
    ("~verbose_connection", False, "bool"),
    ("verbose_connection", False, "bool"),
    ("~duration_to_warn_no_connection", 5.0, "double"),
)
_STARTS = ("onInit", "init", "initialize", "onInitialize", "Load", "initRT", "initPlugin")


def start(machine: Machine, entry: str, path: str) -> None:
    """Follow the start of a nodelet: its constructor, ``onInit``, and what a lazy one does when it has listeners."""
    thing = classes.make_loaded(machine, entry, path, [])
    declared = thing.declared if isinstance(thing, Thing) else None
    if not isinstance(thing, Thing) or declared is None:
        return
    before = machine.when
    for name in _STARTS:
        functions = classes.methods(machine, thing, name)
        if functions:
            chosen = functions[-1]
            machine.call(chosen, thing, _given(chosen))
            break
    else:
        machine.doubt_all(f"{declared.name} has no onInit() in these sources", path, 1)
        return
    if _is_lazy(machine, declared):
        _lazy_params(machine, declared, chosen)
        for name in ("subscribe", "unsubscribe"):
            for function in classes.methods(machine, thing, name):
                if not function.parameters:
                    machine.when = "subscriber"
                    machine.call(function, thing, [])
                    machine.when = before


def _is_lazy(machine: Machine, declared: Class) -> bool:
    """Whether its subscriptions are made and ended by the base class, as there are listeners."""
    known = [declared, *machine.names.bases(declared.name)]
    return any("azy" in base.name or base.last in classes.LAZY for each in known for base in each.bases)


def _lazy_params(machine: Machine, declared: Class, function: Function) -> None:
    """Params that nodelet_topic_tools::NodeletLazy reads."""
    bases = [base for each in [declared, *machine.names.bases(declared.name)] for base in each.bases]
    if any(base.name == "nodelet_topic_tools::NodeletLazy" and base.name not in machine.declarations.classes for base in bases):
        for name, default, kind in _LAZY_PARAMS:
            machine.note(Fact("params", name, function.path, function.line, default=default, value_type=kind))


def _given(function: Function) -> list[Argument]:
    """What a framework gives to an init function: node handles, the second one private; the rest is not known."""
    handles: list[Value] = [Handle(UNKNOWN_SPACE), Handle(UNKNOWN_SPACE)]
    given: list[Argument] = []
    for parameter in function.parameters:
        is_handle = parameter.type.last == "NodeHandle"
        given.append(Argument(handles.pop(0) if is_handle and handles else UNKNOWN))
    return given
