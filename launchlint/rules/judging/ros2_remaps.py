"""Remaps of ROS 2 that act on no name of the nodes they are given to."""

from __future__ import annotations

from collections.abc import Iterator

from launchlint.finding import Finding, Severity
from launchlint.graph.connections import HUBS, Instance
from launchlint.graph.names import Applied, kind
from launchlint.machinery import LIFECYCLE_SERVICES, PARAMETER_SERVICES
from launchlint.named_tuple import NamedTuple
from launchlint.plural import listed
from launchlint.rules.judging.other_version import may_be_another_version
from launchlint.rules.rule import Fine, Rule
from launchlint.rules.view import GraphView
from launchlint.source import Origin
from launchlint.spelling import closest

_EVERYWHERE = HUBS | {"/parameter_events"}
_CLOCK = "clock"
_SIMULATED = "use_sim_time"
_MOST_NAMES = 6
_OF_NODES = (
    *PARAMETER_SERVICES,
    *LIFECYCLE_SERVICES,
    "get_logger_levels",
    "set_logger_levels",
    "get_type_description",
    "transition_event",
)
"""Private names that rclcpp and rclpy give to nodes."""


class Miss(NamedTuple):
    """A remap that acts on no name of a node. ``meant``: the name of its code for which the source was taken for its global name."""

    origin: Origin
    instance: Instance
    applied: Applied
    names: dict[str, str]
    meant: str


def misses(view: GraphView) -> tuple[list[Miss], list[Origin]]:
    """The remaps that do nothing in this launch, one for each place, and the places of those that may do something."""
    fine: dict[tuple[str, int], Origin] = {}
    found: dict[tuple[str, int], Miss] = {}
    for instance in view.graph.instances:
        names = _names(instance) if instance.node.remaps else None
        names = None if names is None or may_be_another_version(instance, view) else names
        table = {id(applied.rule.remap): applied for applied in instance.namer.remappings.values()}
        for remap in instance.node.remaps:
            applied = table.get(id(remap))
            if names is None or applied is None or not view.launch.complete or _has(instance, names, applied):
                fine[remap.origin.place.key] = remap.origin
            elif applied.source != applied.target:
                meant = _meant(applied, names)
                found.setdefault(remap.origin.place.key, Miss(remap.origin, instance, applied, names, meant))
    return [miss for key, miss in found.items() if key not in fine], list(fine.values())


def _names(instance: Instance) -> dict[str, str] | None:
    """Where the names of a node lie before any remapping, and how its code says them; None where not all are known."""
    unsure = instance.is_unknown or instance.open.keys() - {"params"} or instance.kind == "container" or not instance.client
    if unsure or not instance.certain or not instance.node.knows("name", "namespace", "remaps", "arguments"):
        return None
    return {each.unremapped: each.declared for each in instance.endpoints}


def _has(instance: Instance, names: dict[str, str], applied: Applied) -> bool:
    source = applied.source
    if source in names or source in _EVERYWHERE or "/_action/" in source or instance.client == "none":
        return True
    if source.startswith(f"{instance.name}/") and source.rpartition("/")[2] in _OF_NODES:
        return True
    derived = any(each.declaration.transport and source.startswith(f"{each.unremapped}/") for each in instance.endpoints)
    return derived or any(doubt.category != "params" and doubt.may_be(source) for doubt in instance.doubts)


def _may_run_on_simulated_time(instance: Instance) -> bool:
    """Whether the node hears the clock, and so a remap of it may matter (rclcpp.TimeSource); where its params are not known it may."""
    own = instance.node.own
    return own is None or own.get(_SIMULATED, ("", False))[1] is not False


def _meant(applied: Applied, names: dict[str, str]) -> str:
    """The one name of the code that lies in a namespace, or is private, and that the remap takes for a global one; else nothing."""
    if not applied.rule.source.startswith("/"):
        return ""
    near = [declared for full, declared in names.items() if full.endswith(applied.source) and kind(declared) != "global"]
    return near[0] if len(near) == 1 else ""


def in_vain(rule: Rule, view: GraphView, *, absolute: bool) -> Iterator[Finding | Fine]:
    """What to say of them: of those whose source is a global name that the node has elsewhere (``absolute``), or of all others."""
    found, fine = view.once(misses)
    yield from (rule.fine(origin) for origin in fine)
    for miss in found:
        if bool(miss.meant) == absolute:
            yield _of_absolute(rule, miss) if absolute else _of_other(rule, miss)


def _of_absolute(rule: Rule, miss: Miss) -> Finding:
    instance, applied = miss.instance, miss.applied
    real = next(full for full, declared in miss.names.items() if declared == miss.meant and full.endswith(applied.source))
    return rule.at(
        miss.origin,
        f"the remap of {applied.rule.source} does nothing: {instance.name} says {miss.meant}, which is {real}",
        severity=Severity.INFO if applied.target == real else None,
        label="no such name",
        notes=(f"{applied.rule.source} is a global name: no namespace is put before it",),
        help=f"remap {_spelled(miss.meant)}",
        cause=f"{instance.program} {applied.rule.source} {miss.meant}",
    )


def _of_other(rule: Rule, miss: Miss) -> Finding:
    instance, applied = miss.instance, miss.applied
    written = applied.rule.source
    own = sorted(set(miss.names.values()))
    notes = [] if written == applied.source else [f"{written} stands for {applied.source} there"]
    last = written.rpartition("/")[2]
    same = [each for each in own if each.lstrip("~/") == written.lstrip("~/") or each.rpartition("/")[2].lstrip("~") == last]
    near = same[0] if len(same) == 1 else closest(written, own)
    anyhow = applied.target in miss.names
    inside = f"{instance.namer.namespace.rstrip('/')}/"
    whole = next((each for each in miss.names if applied.source.endswith(each) and inside != "/" and each.startswith(inside)), "")
    kept = last == _CLOCK and not _may_run_on_simulated_time(instance)
    if kept:
        near = None
        notes.append("the node runs on the time of the machine: the remap may wait for a simulation")
    if whole:
        notes.append(f"it would act if this file were included in the namespace {applied.source.removesuffix(whole)}")
    if anyhow:
        near = None
    elif not own:
        notes.append(f"{instance.name} has no names of its own")
    elif near is None and not kept:
        notes.append(f"the names of {instance.name} are {listed(own, _MOST_NAMES)}")
    return rule.at(
        miss.origin,
        f"the remap of {written} does nothing: {instance.name} ({instance.program}) has no such name",
        severity=None if own and not anyhow and not whole and not kept else Severity.INFO,
        label="no such name",
        notes=tuple(notes),
        help=f"remove it: {applied.target} is what the node uses anyhow"
        if anyhow
        else f"did you mean {_spelled(near)}?"
        if near is not None
        else "remove it",
        cause=f"{instance.program} {written}{' in vain' if kept else ''}",
    )


def _spelled(declared: str) -> str:
    """A name as a remap rule of ROS 2 says it: ``~/state`` for what the library calls ``~state``."""
    return f"~/{declared[1:].lstrip('/')}" if declared.startswith("~") else declared
