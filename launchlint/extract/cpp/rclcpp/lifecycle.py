"""Lifecycle nodes: what they make when they are configured, and when they are activated."""

from __future__ import annotations

from launchlint.extract.cpp import classes
from launchlint.extract.cpp.values import UNKNOWN, Argument, Thing, node_of

TYPE_CHECKING = False
if TYPE_CHECKING:
    from launchlint.extract.cpp.machine import Machine

_STEPS = (
    ("on_configure", "configured"),
    ("on_activate", "active"),
    ("on_deactivate", "active"),
    ("on_cleanup", "configured"),
    ("on_error", "configured"),
    ("on_shutdown", "configured"),
)


def follow(machine: Machine, thing: Thing) -> None:
    """Follow the transitions of a lifecycle node, in the order in which they come."""
    handle = node_of(thing)
    known = None if handle is None else machine.nodes.get(handle.node or "")
    if known is None or not known.lifecycle:
        return
    for name, state in _STEPS:
        for function in classes.methods(machine, thing, name)[:1]:
            machine.exists, machine.when, machine.conditions, machine.horizon = state, "start", [], 0
            try:
                machine.call(function, thing, [Argument(UNKNOWN) for _ in function.parameters])
            finally:
                machine.exists = ""
