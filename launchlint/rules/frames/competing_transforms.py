"""Two nodes of one launch publish the transform of the same frame.

What it does: it compares the frames whose transforms the nodes publish, as far as that is known for certain: those of the
`static_transform_publisher`s of tf and tf2_ros, of localizers and SLAM nodes that the library knows (map → odom), and of the fixed joints
of a plain URDF that a `robot_state_publisher` gets. It is an error where two static publishers hang one frame below two parents, an info
where they say the same twice (a fixed joint and a static publisher with the same numbers do, too), or where one of the two is published
upon a message that nothing in the launch sends, and a warning elsewhere; and a step milder where both are started only with another value
of an arg than its default. Two publishers are told of once, with all the frames that both publish, and so are all static publishers of
one file that say again what one node publishes, and the same programs in several launch files. Of two nodes of one name LL301 tells.
Nodes whose `/tf` is remapped apart do not meet, and with a `tf_prefix` in the launch the rule is silent.

## Why it matters

A frame has one parent. With two, the one heard last wins: the robot jumps between two places, or a part of the tree is cut off, and
which part changes from start to start.

## Example

```xml
<launch>
  <node pkg="tf2_ros" type="static_transform_publisher" name="laser" args="0.2 0 0.1 0 0 0 base_link laser"/>
  <node pkg="tf2_ros" type="static_transform_publisher" name="mount" args="0 0 0.1 0 0 0 mast laser"/>
</launch>
```

## Use instead

```xml
<launch>
  <node pkg="tf2_ros" type="static_transform_publisher" name="laser" args="0.2 0 0.1 0 0 0 mast laser"/>
  <node pkg="tf2_ros" type="static_transform_publisher" name="mount" args="0 0 0.1 0 0 0 base_link mast"/>
</launch>
```
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from launchlint.evaluate.names import UNKNOWN_NAMESPACE
from launchlint.finding import Finding, Severity
from launchlint.graph.connections import ConnectionGraph, Instance
from launchlint.rules.judging.joined import joined
from launchlint.rules.judging.pose import are_alike
from launchlint.rules.judging.published_frames import STATIC, Published, has_prefix, published
from launchlint.rules.rule import Rule
from launchlint.rules.view import GraphView, tried
from launchlint.source import Origin

RULE = Rule("LL622", "competing-transforms", Severity.ERROR)
MOST_NAMED = 6


def check(view: GraphView) -> Iterator[Finding]:
    """Compare the child frames of all transforms (tf2::BufferCore::setTransform keeps one parent for each frame)."""
    graph = view.graph
    if has_prefix(graph):
        return
    known: dict[tuple[str, str], list[Published]] = {}
    for each in published(graph):
        if UNKNOWN_NAMESPACE in each.instance.name:  # what it would publish once that is mended is a guess
            continue
        if each.certain and not each.instance.node.is_test and each.instance.node.knows("arguments", "namespace", "name"):
            known.setdefault((each.topic, each.child), []).append(each)
    pairs: dict[tuple[object, ...], list[tuple[Published, Published]]] = {}
    for group in known.values():
        first = group[0]
        for other in group[1:]:
            if other.instance.name != first.instance.name:  # of two nodes of one name LL301 says that roslaunch refuses the file
                severity = _level(first, other, graph)
                pairs.setdefault((severity, id(first.instance), _told_with(first, other)), []).append((first, other))
    for both in pairs.values():
        yield _finding(both, graph)


def together(findings: Sequence[Finding]) -> Finding:
    """What the same two lines do in several namespaces, and the same two programs in several launch files."""
    first = findings[0]
    if any(finding.location != first.location for finding in findings):
        return joined(findings)
    return first._replace(entries=max(finding.entries for finding in findings))


def _told_with(first: Published, other: Published) -> object:
    """What all that is told with ``other`` shares: the node, or the file where static publishers say what another program publishes."""
    if other.instance.program not in STATIC or first.instance.program in STATIC:
        return id(other.instance)
    origin = other.instance.node.origin
    return origin.place.source.path, tuple(place.key for place in origin.chain)


def _unheard(one: Published, graph: ConnectionGraph) -> str:
    """What the transform waits for, where nothing that is known to be in the launch sends it."""
    channel = graph.channels.get(("topic", one.upon)) if one.upon else None
    waits = one.upon and (channel is None or not channel.offers)
    return f"{one.instance.name} publishes it only upon a message on {one.upon}, which nothing here sends" if waits else ""


def _judged(first: Published, other: Published, graph: ConnectionGraph) -> tuple[Severity, tuple[str, ...]]:
    """How bad it is that both publish it, and what comes of it."""
    static = {first.instance.program, other.instance.program} <= STATIC
    unheard = _unheard(first, graph) or _unheard(other, graph)
    severity, effect = Severity.WARNING, f"both say where {other.child} is in {other.parent}, and the one heard last wins"
    if first.parent != other.parent:
        severity = Severity.ERROR if static else Severity.WARNING
        effect = f"{first.instance.name} puts it below {first.parent}, {other.instance.name} below {other.parent}: a frame has one parent"
    elif are_alike(first.pose, other.pose) or (static and first.instance.node.arguments.split() == other.instance.node.arguments.split()):
        severity, effect = Severity.INFO, "they say the same: one of them is enough"
    if unheard and severity is Severity.WARNING:
        severity = Severity.INFO
    return severity, (effect, *([unheard] if unheard else []))


def _level(first: Published, other: Published, graph: ConnectionGraph) -> Severity:
    """As :func:`_judged` says, a step milder where only another value of an arg than its default starts both: they may be alternatives."""
    severity = _judged(first, other, graph)[0]
    return Severity(severity - 1) if severity > Severity.INFO and tried(graph.launch) else severity


def _finding(both: Sequence[tuple[Published, Published]], graph: ConnectionGraph) -> Finding:
    """What one node and another one, or several of one file, both publish, of one severity."""
    first, other = both[0]
    severity, notes = _level(first, other, graph), _judged(first, other, graph)[1]
    further = {id(each.instance): each for _, each in both if each.instance is not other.instance}
    frames = [each.child for _, each in both]
    more = f" and {len(frames) - MOST_NAMED} more" if len(frames) > MOST_NAMED else ""
    named = f"the frame {frames[0]}" if len(frames) == 1 else f"{len(frames)} frames ({', '.join(frames[:MOST_NAMED])}{more})"
    here, there = _place(other.instance), _place(first.instance).place
    return RULE.at(
        here,
        f"{first.instance.name} publishes the transform{'s' * (len(frames) > 1)} of {named}, too",
        severity=severity,
        label=f"publishes {other.parent} → {other.child}",
        related=(
            *((_place(each.instance).place, f"publishes {each.parent} → {each.child}") for each in further.values()),
            (there, f"publishes {first.parent} → {first.child}"),
        ),
        notes=notes,
        help="start only one of them, or give each a frame of its own",
        topic=other.child,
        cause=" ".join((severity.word, *_sources(both[0]), *frames)),
    )


def _sources(both: tuple[Published, Published]) -> list[str]:
    """What tells one cause from another: of a static transform beside what works it out, whatever does that, the static one."""
    programs = [each.instance.program for each in both]
    static = [each for each in programs if each in STATIC]
    return [" ".join(map(str, static if len(static) == 1 else programs)), *sorted(each.parent for each in both)]


def _place(instance: Instance) -> Origin:
    node = instance.node
    place = node.places.get("arguments" if instance.program in STATIC else "name", node.origin.place)
    return Origin(place, node.origin.step)
