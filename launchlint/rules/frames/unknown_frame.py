"""A param names a frame that nobody publishes, and a published one is one letter away.

What it does: it compares the frames that nodes take from their params with those whose transforms the launch publishes: by static
publishers, by nodes that the library knows, and by a plain URDF. It speaks where all that publishes transforms is known, and
where exactly one frame is one letter away. Names that differ in a digit or in a mark (`_l`, `_r`) are those of other sensors.
A frame that its own node publishes, as amcl does `odom_frame_id`, is there; it is told where nothing hangs on it, while the one that is
one letter away has no parent: two trees that were meant to be one.

## Why it matters

There is no transform to a frame that does not exist: the node waits, or drops its data.

## Example

```xml
<launch>
  <node pkg="tf2_ros" type="static_transform_publisher" name="mount" args="0.2 0 0.1 0 0 0 base_link laser_front"/>
  <node pkg="rplidar_ros" type="rplidarNode" name="lidar">
    <param name="frame_id" value="laser_fron"/>
  </node>
</launch>
```

## Use instead

```xml
<launch>
  <node pkg="tf2_ros" type="static_transform_publisher" name="mount" args="0.2 0 0.1 0 0 0 base_link laser_front"/>
  <node pkg="rplidar_ros" type="rplidarNode" name="lidar">
    <param name="frame_id" value="laser_front"/>
  </node>
</launch>
```
"""

from __future__ import annotations

from collections.abc import Iterator

from launchlint.finding import Finding, Severity
from launchlint.graph.connections import ConnectionGraph, Instance
from launchlint.named_tuple import NamedTuple
from launchlint.rules.judging.near_names import SLIP, relation
from launchlint.rules.judging.param_values import is_certain
from launchlint.rules.judging.published_frames import TOPICS, bare, description, has_prefix, published
from launchlint.rules.rule import Fine, Rule
from launchlint.rules.view import GraphView

MOST_COMPARED = 100_000
"""Pairs of names that are held against each other: no robot has so many."""

RULE = Rule("LL624", "unknown-frame", Severity.WARNING)


def check(view: GraphView) -> Iterator[Finding | Fine]:
    """Look for each frame among those that are published."""
    graph = view.graph
    given = {frame.parameter for instance in graph.instances for frame in instance.frames if frame.role == "child"}
    named = [
        (instance, frame, setting)
        for instance in graph.instances
        for frame in instance.frames
        if frame.name and frame.parameter and (frame.role == "child" or frame.parameter not in given)
        if (setting := graph.parameters.setting(frame.parameter)) is not None
    ]
    if not named:
        return
    made = _made(graph)
    if made is not None and len(named) * len(made.publishers) > MOST_COMPARED:
        return
    for instance, frame, setting in named:
        name, own = bare(frame.name), frame.role == "child"
        if made is None or name in (made.parents if own else made.publishers):
            yield RULE.fine(setting.origin)
            continue
        near = [other for other in (made.roots if own else made.publishers) if relation(f"/{name}", f"/{other}") == SLIP]
        if len(near) == 1 and frame.certain and is_certain(setting):
            note = f"{made.publishers[near[0]].name} publishes {near[0]}"
            if own:
                said = f"{instance.program} publishes the frame {name}, from {frame.parameter}, and nothing in this launch hangs on it"
                label, note = "nothing hangs on it", f"{note}, which has no parent"
            else:
                said = f"nothing in this launch publishes the frame {name}, which {instance.program} takes from {frame.parameter}"
                label = "no such frame"
            yield RULE.at(
                setting.origin,
                said,
                label=label,
                notes=(note,),
                help=f"did you mean {near[0]}?",
                topic=frame.parameter,
                cause=f"{name} for {near[0]}",
            )


class _Made(NamedTuple):
    """The frames that a launch publishes, each with a node that does; those that others hang on, and those of them without a parent."""

    publishers: dict[str, Instance]
    parents: frozenset[str]
    roots: frozenset[str]


def _made(graph: ConnectionGraph) -> _Made | None:
    """What the launch publishes; None where there may be more."""
    if not graph.launch.complete or has_prefix(graph) or any(_may_publish_more(graph, instance) for instance in graph.instances):
        return None
    publishers: dict[str, Instance] = {}
    transforms = list(published(graph))
    for each in transforms:
        publishers.setdefault(each.child, each.instance)
        publishers.setdefault(each.parent, each.instance)
    parents = frozenset(each.parent for each in transforms)
    return _Made(publishers, parents, parents.difference(each.child for each in transforms))


def _may_publish_more(graph: ConnectionGraph, instance: Instance) -> bool:
    """Whether a node may publish transforms of frames that are not known."""
    if instance.is_unknown or instance.may_have_more("publishers"):
        return True
    children = [frame for frame in instance.frames if frame.role == "child"]
    if any(
        (frame.urdf and description(graph, frame) is None) or (not frame.urdf and not (frame.name and frame.parent)) for frame in children
    ):
        return True
    return not children and any(each.role == "publisher" and each.unremapped in TOPICS for each in instance.endpoints)
