"""A remap acts on a node that has no such name.

It is told where the library knows the node completely, and none of the names in its code (topics, services, actions, params)
is the `from` of the remap. Of a remap outside a node it is told where this holds for all nodes that it reaches. It is an info
where the remap would change nothing anyhow: one of `/tf` and the like, one of a param that the node does not read and others
do, or one to a name that the node uses in any case, be it that `to` lacks a slash in front of the namespace. So it is where a
further namespace stands before the name of the node in its own one, in which another file may include this one; where the
sources of the node have the name in a comment, and where none of several remaps of a node matches anything and it has params that
the program does not read, whose sources are not here: all this may be for another version; and so it is of a public program in a package
that rosbuild builds. A name that the node would have if it were
started in another way is one of its names.

A nodelet in no namespace has its relative names in the namespace of its manager (roscpp makes them there, and the `<remap>` of the
nodelet does not know it), so that a remap must say that namespace, too. A remap acts on params as it does on topics: where a node has a
topic and a param of one name, a remap moves both.

No name is proposed that only ends alike where the node hears it, and would hear nobody that is known instead.

All remaps of a program for which nothing better is known than that it has no such names are one finding, and so are all below one name in
a file, and the same remap of the
same program in several files.

Nothing is said of a public program whose package, or the repository that it is known from, a `.repos`, `.rosinstall` or `.gitmodules`
of the workspace names: it is another version that is built there, or another fork. So it is in ROS 2 where the node is given a param that
the program is not known to declare, and that is no slip.

In ROS 2 a remap acts on topics and services; that of a global name which the node has in a namespace is told by LL948. It is an info for
the clock of a node that runs on the time of the machine.

A remap acts on whole names only: `camera` does not remap `camera/image`, unless the code makes a NodeHandle of `camera`.

## Why it matters

The remap does nothing, nobody says so, and the node goes on talking under the name in its code.

## Example

```xml
<launch>
  <node pkg="amcl" type="amcl" name="amcl">
    <remap from="base_scan" to="scan"/>
  </node>
</launch>
```

## Use instead

```xml
<launch>
  <node pkg="amcl" type="amcl" name="amcl">
    <remap from="scan" to="base_scan"/>
  </node>
</launch>
```

## Fix

`--unsafe-fixes` removes the remap where the node uses the name in `to` anyhow, or where another remap does already what was meant; it swaps
`from` and `to` where some other node of the launch uses the name in `from`; else it writes the name of the node that the help proposes.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence

from launchlint.finding import Finding, Fix, Severity
from launchlint.graph.connections import HUBS, OFFERS, ConnectionGraph, Instance
from launchlint.graph.names import Applied, absolute, around, kind
from launchlint.model import ROS2
from launchlint.named_tuple import NamedTuple
from launchlint.plural import listed
from launchlint.rules.edits import fix, remove_element, set_value, spot
from launchlint.rules.judging.commented_code import commented_out
from launchlint.rules.judging.joined import alike, joined
from launchlint.rules.judging.name_places import is_inside
from launchlint.rules.judging.of_rosbuild import SINCE, is_of_rosbuild
from launchlint.rules.judging.other_file import root_of
from launchlint.rules.judging.other_version import may_be_another_version
from launchlint.rules.judging.own_names import OwnNames, own_names
from launchlint.rules.rule import Fine, Rule
from launchlint.rules.view import GraphView
from launchlint.source import Origin
from launchlint.spelling import closest, one_slip

RULE = Rule("LL601", "remap-matches-nothing", Severity.WARNING, fixable="unsafe")
UNIVERSAL = ("~get_loggers", "~set_logger_level", "/rosout", "/clock", "/use_sim_time", "/statistics")
"""Names that every node has (roscpp, rospy)."""
REMOVE = "remove it"
_IS_OTHER = "the name of the node is"
_OF_MANAGER = "a nodelet in no namespace says its names in that of its manager"
_IS_PARAM = "it is a param of the node, to which a remap gives no value"
_MOST_NAMES = 6
_MOST_CANDIDATES = 300


class _Miss(NamedTuple):
    """A remap that does nothing for a node."""

    origin: Origin
    instance: Instance
    applied: Applied
    names: OwnNames
    graph: ConnectionGraph


class _Advice:
    """What to do about a remap: ``remove`` it, or write another ``source`` (with ``target``: swap the two).

    ``habit`` is what it has in common with others that are wrong in the same way, whatever their names.
    """

    __slots__ = ("habit", "remove", "source", "target", "text")

    def __init__(self, text: str, habit: str = "", *, remove: bool = False, source: str = "", target: str = "") -> None:
        self.text = text
        self.habit = habit
        self.remove = remove
        self.source = source
        self.target = target


def check(view: GraphView) -> Iterator[Finding | Fine]:
    """Look at every remap of every node that the library knows completely."""
    if view.dialect.name == ROS2:
        from launchlint.rules.judging.ros2_remaps import in_vain

        yield from in_vain(RULE, view, absolute=False)
        return
    missed: dict[tuple[str, int, str], list[_Miss]] = {}
    fine: dict[tuple[str, int], Origin] = {}
    for instance in view.graph.instances:
        if not instance.node.remaps and not instance.namer.remappings:
            continue
        names = None if may_be_another_version(instance, view) else view.fact(instance, own_names)
        table = instance.namer.remappings.values()
        acting = set() if names is None else {id(applied.rule.remap) for applied in table}
        for remap in instance.node.remaps:
            if id(remap) not in acting or not (view.launch.complete or is_inside(remap, instance)):
                fine[remap.origin.place.key] = remap.origin
        if names is None:
            continue
        for applied in table:
            remap_or_none = applied.rule.remap
            if remap_or_none is not None:
                origin, topic = remap_or_none.origin, ""
            else:
                origin = Origin(instance.node.places.get("arguments", instance.node.origin.place), instance.node.origin.step)
                topic = f"{instance.name} {applied.rule.source}"
            if applied.source == applied.target:
                continue  # the rule of remaps to themselves speaks about it
            if not _has(instance, names, applied):
                missed.setdefault((*origin.place.key, topic), []).append(_Miss(origin, instance, applied, names, view.graph))
            elif remap_or_none is not None:
                fine[origin.place.key] = origin
    yield from (RULE.fine(origin) for origin in fine.values())
    for (path, start, topic), misses in missed.items():
        if (path, start) not in fine:
            yield _finding(misses, topic, view)


def _has(instance: Instance, names: OwnNames, applied: Applied) -> bool:
    """Whether the remap may act on a name of the node."""
    source, namer = applied.source, instance.namer
    if source in names.spelled or source == namer.node:
        return True
    if any(source == absolute(name, namer.namespace, namer.node) for name in UNIVERSAL):
        return True
    if any(step.source == source for endpoint in instance.endpoints for step in endpoint.applied):
        return True  # the second of two that act: rospy and image_transport look a topic up twice
    if any(source.startswith(f"{name}/") for name in names.below):
        return True
    if any(doubt.may_be(source) for doubt in (*instance.doubts, *names.otherwise)):
        return True
    # There may be more params, but hardly one that is remapped to a topic, or that is spelled almost like one.
    return "params" in instance.open and applied.target not in names.spelled and one_slip(source, names.spelled) is None


def _finding(misses: list[_Miss], topic: str, view: GraphView) -> Finding:
    first = misses[0]
    origin, instance, applied, names = first.origin, first.instance, first.applied, first.names
    rule = applied.rule
    written = rule.remap.source if rule.remap is not None else rule.source
    if len(misses) == 1:
        who = f"{instance.name} ({instance.program}) has no such name"
    else:
        who = f"none of the {len(misses)} nodes that it reaches has such a name"
    notes = []
    if written != applied.source and kind(written) != "global":
        notes.append(f"{written} stands for {applied.source} there")
    advice = next((found for miss in misses if (found := _advice(miss, written)) is not None), None)
    own = sorted(set(names.spelled.values()))
    if not own:
        notes.append(f"{instance.name} has no names of its own")
    elif advice is None and len(own) <= _MOST_NAMES:
        notes.append(f"the names of {instance.name} are {listed(own, _MOST_NAMES)}")
    off = commented_out(written, instance, root_of(view.launch.entry))
    if off:
        notes.append(f"the code that has this name is commented out: {off}")
    other = rule.remap is not None and _is_another_version(first)
    if other:
        notes.append(
            f"nor does any other remap here, and the params are not its own: this may be for another version of {instance.program}"
        )
    old = not _is_read_here(instance) and is_of_rosbuild(view.packages.package_of(origin.place.source.file))
    if old:
        notes.append(SINCE)
    whole = "" if topic else _namespace_of_whole(first)
    if whole:
        notes.append(f"it would act if this file were included in the namespace {whole}")
    severity = Severity.INFO if off or other or old or whole or all(_is_harmless(miss) for miss in misses) else RULE.severity
    return RULE.at(
        origin,
        f"the remap of {written} matches nothing: {who}",
        severity=severity,
        label="matches nothing",
        notes=tuple(notes),
        help="remove it, or write the name that the node's code uses" if advice is None else advice.text,
        topic=topic,
        fix=None if topic or advice is None else _fix(origin, advice, view),
        cause=_cause(origin, instance, severity, written, advice) if len(misses) == 1 else "",
        about=(instance.program.partition("/")[0], written),
    )


def _namespace_of_whole(miss: _Miss) -> str:
    """The namespace before the node's own one in which the remap would act, where a name of the node in that stands in its source."""
    source, inside = miss.applied.source, f"{miss.instance.namer.namespace.rstrip('/')}/"
    names = (full for full in miss.names.spelled if inside != "/" and full.startswith(inside))
    return next((source.removesuffix(full) for full in names if source.endswith(full) and source != full), "")


def of_copies(findings: Sequence[Finding]) -> Iterator[Finding]:
    """One for programs of one package of which the same remap is told, written alike: one launch file was made from the other."""
    for several in alike(findings, lambda each: (each.about, each.location.text)):
        yield from [joined(several)] if len(several) > 1 and several[0].about else several


def _cause(origin: Origin, instance: Instance, severity: Severity, written: str, advice: _Advice | None) -> str:
    """What holds for several remaps of one program, or for one of them in several files, or for all below one name in a file."""
    below = written.rpartition("/")[0]
    if below and below == instance.name.rpartition("/")[2] and severity is Severity.WARNING:
        return f"{instance.program} {severity.word} below its own name {'' if advice is None else advice.text}"
    if kind(written) == "relative" and below and severity is Severity.WARNING:
        return f"{instance.program} {severity.word} {origin.place.source.path} below {below}"
    reason = "other names" if advice is None else advice.habit or ("in vain" if advice.remove else f"{written} {advice.text}")
    return f"{instance.program} {severity.word} {reason}"


def _fix(origin: Origin, advice: _Advice, view: GraphView) -> Fix | None:
    """What :func:`_advice` proposes: the remap goes, or ``from`` gets another name, or both sides do."""
    at = spot(view, origin.place)
    if at is not None and advice.remove and at.element.tag.lower() == "remap":
        return fix("remove the remap", remove_element(at), safe=False, changes="the same, without a remap that matches nothing")
    name = advice.source
    if not name or at is None or at.element.tag.lower() != "remap" or any("$" in each.raw for each in at.element.attributes.values()):
        return None
    edits = set_value(at, name, at.element.attributes.get("from"))
    if not advice.target:
        return fix(f'write from="{name}"', edits, safe=False, changes=f"{name} is remapped")
    edits += set_value(at, advice.target, at.element.attributes.get("to"))
    return fix("swap from and to", edits, safe=False, changes=f"{name} is remapped to {advice.target}")


def _is_harmless(miss: _Miss) -> bool:
    """Whether all may be as intended: the node uses the target in any case, the name is one of those for everybody, or a NodeHandle's."""
    source, target = miss.applied.source, miss.applied.target
    if source in HUBS or (target in miss.names.spelled and _reversed(miss) is None) or _is_said_twice(miss):
        return True
    if _as_wanted(miss) is not None or _is_idle_param(miss):
        return True
    return miss.instance.client != "rospy" and any(full.startswith(f"{source}/") for full in miss.names.spelled)


def _is_read_here(instance: Instance) -> bool:
    return any(endpoint.is_read_here for endpoint in instance.endpoints)


def _is_another_version(miss: _Miss) -> bool:
    """Whether all of several remaps in a ``<node>`` match nothing, and the program, whose sources are not here, reads other params."""
    instance = miss.instance
    if _is_read_here(instance):
        return False
    inside = [each for each in instance.namer.remappings.values() if each.rule.remap is not None and is_inside(each.rule.remap, instance)]
    sources = {each.source for each in inside}
    if len(sources) < 2 or miss.applied.source not in sources or not sources.isdisjoint(miss.names.spelled):
        return False
    read = {reading.name for reading in instance.readings}
    return any(not read & {name, *around(name)} for name in miss.graph.parameters.below(instance.namer.private))


def _as_wanted(miss: _Miss) -> str | None:
    """The name that the node uses anyhow and that was wanted: a ``from`` that acts would lead the node away from it.

    It is written in ``to`` with its namespace, and resolved in that namespace ``to`` would hold it twice.
    """
    wanted, namespace = _as_global(miss), miss.instance.namer.home.rstrip("/")
    return wanted if namespace and wanted in miss.names.used and wanted.startswith(f"{namespace}/") else None


def _as_global(miss: _Miss) -> str:
    """``to`` as it would be with a leading slash."""
    return "/" + miss.applied.rule.target.strip().lstrip("/")


def _is_idle_param(miss: _Miss) -> bool:
    """Whether it is a param that is set, or that other nodes read, and that this node does not read, by no name that is like it."""
    names, source = miss.names, miss.applied.source
    end = source.rpartition("/")[2]
    sides, graph = (source, miss.applied.target, _as_global(miss)), miss.graph
    is_param = any(graph.parameters.is_set(side) or side in graph.readers for side in sides)
    return is_param and not any(full.rpartition("/")[2] == end for full in names.spelled) and closest(source, names.spelled) is None


def _param(miss: _Miss, written: str) -> str | None:
    """The param of the node that is called so, where nothing else of it is: a remap gives it no value."""
    namer, bare = miss.instance.namer, written.lstrip("~/")
    full = absolute(f"~{bare}", namer.namespace, namer.node) if bare else ""
    params = {absolute(each.declared, namer.namespace, namer.node) for each in miss.instance.readings}
    others = {absolute(each.declared, namer.namespace, namer.node) for each in miss.instance.endpoints}
    return bare if full in params - others else None


def _is_said_twice(miss: _Miss) -> bool:
    """Whether another remap leads a name with the same last part to the same target: one of them is for another version of the node."""
    end = miss.applied.source.rpartition("/")[2]
    return any(
        other.target == miss.applied.target and other.source != miss.applied.source and other.source.rpartition("/")[2] == end
        for other in miss.instance.namer.remappings.values()
    )


def _reversed(miss: _Miss) -> str | None:
    """How the code spells the target, where that is one of its own names: the two sides may be swapped.

    Not where the source is that name without the namespace of the node: then the target is what was wanted, and is so anyhow.
    """
    source, target = miss.applied.source, miss.applied.target
    return None if target in miss.names.derived or target.endswith(source) else miss.names.spelled.get(target)


def _advice(miss: _Miss, written: str) -> _Advice | None:
    names, source = miss.names, miss.applied.source
    spelled = names.spelled
    param = _param(miss, written)
    if param is not None:
        return _Advice(f'{_IS_PARAM}: write <param name="{param}" value="{miss.applied.rule.target}"/>', habit=_IS_PARAM)
    turned = _reversed(miss)
    if turned is not None and source not in HUBS:
        swapped = f'write from="{turned}" to="{written}"'
        if any((kind_, source) in miss.graph.channels for kind_ in ("topic", "service", "action")):
            return _Advice(
                f"if from and to are swapped, {swapped}; else remove it, since {turned} is the name in the code",
                source=turned,
                target=written,
            )
        return _Advice(
            f"{REMOVE}: {turned} is the name in the code, which the node uses anyhow; if from and to are swapped, {swapped}", remove=True
        )
    inside = sorted(spelled[full] for full in spelled if full.startswith(f"{source}/"))
    if inside:
        return _Advice(f"a remap does not reach below a name: remap {listed(inside, _MOST_NAMES)} one by one")
    if _is_harmless(miss):
        anyhow = miss.applied.target if miss.applied.target in names.used else _as_wanted(miss)
        return _Advice(REMOVE if anyhow is None else f"{REMOVE}: {anyhow} is the name that the node uses anyhow", remove=True)
    bare, namer = written.lstrip("~/"), miss.instance.namer
    for other, what in ((f"~{bare}", "private"), (bare, "relative"), (f"/{bare}", "global")):
        found = spelled.get(absolute(other, namer.namespace, namer.node)) if bare else None
        if found is not None:
            full = absolute(other, namer.namespace, namer.node)
            habit = _OF_MANAGER if what == "relative" and kind(found) == "global" else f"{_IS_OTHER} {what}"
            return _done_by_another(miss, full) or _moves_param(miss, full, habit) or _Advice(_from(habit, found), habit, source=found)
    if len(spelled) > _MOST_CANDIDATES:
        return None
    own = {full: name for full, name in spelled.items() if full not in names.derived}
    near = closest(source, own)
    if near is None:
        near = _same_end(source, own)
        if near is None or _takes_input_away(miss, near):
            return None
    meant = f'did you mean from="{spelled[near]}"?'
    return _done_by_another(miss, near) or _moves_param(miss, near, meant.rstrip("?")) or _Advice(meant, source=spelled[near])


def _done_by_another(miss: _Miss, name: str) -> _Advice | None:
    """What to do where another remap of the node acts on ``name`` (full), which this one would act on once it is corrected; else empty."""
    others = miss.instance.namer.remappings.values()
    other = next((each for each in others if each is not miss.applied and each.source == name), None)
    if other is None:
        return None
    return _Advice(f"{REMOVE}: another remap leads {miss.names.spelled[name]} to {other.target} already", remove=True)


def _from(reason: str, name: str) -> str:
    return f'{reason}: write from="{name}"'


def _moves_param(miss: _Miss, name: str, advice: str) -> _Advice | None:
    """What to do where a remap of ``name`` (full) would lead the node away from a param of that name, too; None where it would not."""
    namer = miss.instance.namer
    is_read = any(absolute(each.declared, namer.namespace, namer.node) == name for each in miss.instance.readings)
    if not is_read and miss.graph.parameters.setting(name) is None:
        return None
    both = f"{miss.names.spelled[name]} is a param of the node, too, which a remap would move as well"
    return _Advice(f"{advice}; but {both}: call one of the two otherwise in the code, or remove this", habit="a param, too")


def _takes_input_away(miss: _Miss, name: str) -> bool:
    """Whether the node hears ``name`` (full), and would hear nobody that is known under the target instead."""
    takes = {each.kind for each in miss.instance.endpoints if each.name == name and each.role not in OFFERS}
    targets = (miss.graph.channels.get((kind_, miss.applied.target)) for kind_ in takes)
    return bool(takes) and not any(channel is not None and channel.offers for channel in targets)


def _same_end(source: str, spelled: Mapping[str, str]) -> str | None:
    """The only name whose last part is that of ``source``, or begins or ends with it: ``image`` and ``~image_raw``."""
    end = source.rpartition("/")[2]
    for fits in (str.__eq__, lambda last, end: last.startswith(f"{end}_") or last.endswith(f"_{end}")):
        found = [full for full in spelled if fits(full.rpartition("/")[2], end)]
        if found:
            return found[0] if len(found) == 1 else None
    return None
