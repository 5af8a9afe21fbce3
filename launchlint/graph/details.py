"""What the launch files say beside the connection graph: machines, params that others override, and who may be where nobody is known."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import NamedTuple

from launchlint.graph.connections import ConnectionGraph
from launchlint.graph.doubts import End, MayBe, Partly, doubts
from launchlint.graph.topology import place_text, value_text

Key = tuple[str, str]
"""The name of a node or param, and its place as a topology spells it."""


class Details(NamedTuple):
    """Details of one launch file in all its configurations.

    Args:
        machines: node → the name of its ``<machine>``, and the address of that; the address is empty where no launch file declares it.
        overridden: param, with the place of the setting that holds → value and place of each earlier setting, in order.
        doubts: as :func:`launchlint.graph.doubts.doubts`.
        partly: node → its names that are known only in part: the category of the library and what is known, with ``*`` for the rest.
    """

    machines: Mapping[Key, tuple[str, str]]
    overridden: Mapping[Key, tuple[tuple[str, str], ...]]
    doubts: Mapping[End, tuple[MayBe, ...]]
    partly: Partly


NO_DETAILS = Details({}, {}, {}, {})


def details(graphs: Sequence[ConnectionGraph]) -> Details:
    """The details of all graphs of one launch file."""
    machines: dict[Key, tuple[str, str]] = {}
    overridden: dict[Key, dict[tuple[str, str], None]] = {}
    partly: dict[Key, tuple[tuple[str, str], ...]] = {}
    for graph in graphs:
        launch = graph.launch
        for instance in graph.instances:
            node = instance.node
            if not (node.machine or instance.doubts):
                continue
            at = place_text(node.places.get("name", node.origin.place))
            if instance.doubts:
                partly[instance.name, at] = tuple(dict.fromkeys((doubt.category, doubt.pattern) for doubt in instance.doubts))
            if node.machine:
                declared = launch.machines.get(node.machine)
                machines[instance.name, at] = (node.machine, "" if declared is None else declared.address)
        for setting in launch.parameter_settings:
            final = launch.parameters.get(setting.name)
            if final is not None and setting is not final:
                earlier = (value_text(setting.value), place_text(setting.origin.place))
                overridden.setdefault((final.name, place_text(final.origin.place)), {})[earlier] = None
    return Details(machines, {key: tuple(settings) for key, settings in overridden.items()}, doubts(graphs), partly)
