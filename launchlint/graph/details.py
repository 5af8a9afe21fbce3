"""What the launch files say beside the connection graph: machines, params that others override, and who may be where nobody is known."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from launchlint.graph.connections import ConnectionGraph
from launchlint.graph.doubts import End, MayBe, Partly, doubts
from launchlint.graph.topology import origin_text, place_text, value_text
from launchlint.model import Argument, Launch
from launchlint.named_tuple import NamedTuple
from launchlint.source import Place


class IncludeArgument(NamedTuple):
    """An arg of an include: ``value`` is what is passed, ``default`` what the included file has; None where there is none."""

    name: str
    value: str | None
    default: str | None


Key = tuple[str, str]
"""The name of a node or param, and its place as a topology spells it."""


class Details(NamedTuple):
    """Details of one launch file in all its configurations.

    Args:
        machines: node → the name of its ``<machine>``, and the address of that; the address is empty where no launch file declares it.
        overridden: param, with the place of the setting that holds → value and place of each earlier setting, in order.
        doubts: as :func:`launchlint.graph.doubts.doubts`.
        partly: node → its names that are known only in part: the category of the library and what is known, with ``*`` for the rest.
        arguments: include, by the id of its container → the args that it passes, and those that the file has beside.
        lifecycle: nodes of ROS 2 that somebody has to configure and activate.
    """

    machines: Mapping[Key, tuple[str, str]]
    overridden: Mapping[Key, tuple[tuple[str, str], ...]]
    doubts: Mapping[End, tuple[MayBe, ...]]
    partly: Partly
    arguments: Mapping[str, tuple[IncludeArgument, ...]]
    lifecycle: frozenset[Key]


NO_DETAILS = Details({}, {}, {}, {}, {}, frozenset())


def details(graphs: Sequence[ConnectionGraph]) -> Details:
    """The details of all graphs of one launch file."""
    machines: dict[Key, tuple[str, str]] = {}
    overridden: dict[Key, dict[tuple[str, str], None]] = {}
    partly: dict[Key, tuple[tuple[str, str], ...]] = {}
    arguments: dict[str, tuple[IncludeArgument, ...]] = {}
    lifecycle: set[Key] = set()
    for graph in graphs:
        launch = graph.launch
        _add_arguments(arguments, launch)
        for instance in graph.instances:
            node = instance.node
            if not (node.machine or instance.doubts or instance.lifecycle):
                continue
            at = place_text(node.places.get("name", node.origin.place))
            if instance.lifecycle:
                lifecycle.add((instance.name, at))
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
    settings_of = {key: tuple(settings) for key, settings in overridden.items()}
    return Details(machines, settings_of, doubts(graphs), partly, arguments, frozenset(lifecycle))


def _add_arguments(arguments: dict[str, tuple[IncludeArgument, ...]], launch: Launch) -> None:
    """Add what each further include passes, and the other args of the file that it includes; linear in the args of all files."""
    own: dict[tuple[Place, ...], dict[str, Argument]] = {}
    for argument in launch.declared:
        if not argument.passed:
            own.setdefault(argument.origin.chain, {}).setdefault(argument.name, argument)
    for include in launch.includes:
        key = origin_text(include.origin)
        if key in arguments:
            continue
        known = own.get((*include.origin.chain, include.origin.place), {})
        found = []
        for name in dict.fromkeys((*include.arguments, *known)):
            default = known[name].default if name in known else None
            value = include.arguments.get(name)
            found.append(
                IncludeArgument(name, None if value is None else value_text(value), None if default is None else value_text(default))
            )
        if found:
            arguments[key] = tuple(found)
