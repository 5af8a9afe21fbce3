"""Two copies of a node in different namespaces share a global topic.

What it does: it looks for two nodes of one program in different namespaces that publish the same topic because its name begins with `/`:
in the program itself, or in the `args` or a remap of a file that is included for both. Topics that are shared on purpose (`/tf`,
`/diagnostics`, `/joint_states`, markers for rviz …) do not count. It is an info where the copies only subscribe to the topic, and where
the launch file writes the global name and a node outside these namespaces gathers what they publish. It is an info, too, where nobody
described the program: its sources, which were read, or a run say that it may publish the topic, not that it does.

## Why it matters

The namespaces are there to keep two robots or two cameras apart. A name that begins with `/` is the same in each of them: whoever
listens gets the messages of both, mixed.

## Example

```xml
<launch>
  <include file="$(dirname)/robot.launch" ns="left"/>
  <include file="$(dirname)/robot.launch" ns="right"/>
</launch>
```

```xml robot.launch
<launch>
  <node pkg="depthimage_to_laserscan" type="depthimage_to_laserscan" name="scanner">
    <remap from="scan" to="/scan"/>
  </node>
</launch>
```

## Use instead

```xml
<launch>
  <include file="$(dirname)/robot.launch" ns="left"/>
  <include file="$(dirname)/robot.launch" ns="right"/>
</launch>
```

```xml robot.launch
<launch>
  <node pkg="depthimage_to_laserscan" type="depthimage_to_laserscan" name="scanner">
    <remap from="scan" to="front_scan"/>
  </node>
</launch>
```
"""

from __future__ import annotations

from collections.abc import Iterator

from launchlint.finding import Finding, Severity
from launchlint.graph.connections import Channel, Endpoint, Instance
from launchlint.rules.judging.name_places import Owners, acting_origin, how, is_known_to_act, owners, put_remap
from launchlint.rules.rule import Rule
from launchlint.rules.view import GraphView

RULE = Rule("LL617", "absolute-name-escapes-namespace", Severity.WARNING)

SHARED_TYPES = ("visualization_msgs/", "tf2_msgs/", "tf/", "diagnostic_msgs/", "rosgraph_msgs/", "sensor_msgs/JointState")
"""Types of topics on which many nodes publish on purpose: each message says what it is about."""
_IN_THE_CODE = "code"
SHARED = frozenset({"map", "map_metadata", "initialpose", "clicked_point", "goal", "robot_description", "e_stop", "clock"})
"""Last parts of the names of topics that all robots of one place have in common."""


def check(view: GraphView) -> Iterator[Finding]:
    """Look at every topic that several nodes of one program publish, or several hear."""
    for channel in view.graph.channels.values():
        if channel.kind != "topic" or channel.is_hub or channel.is_plumbing or channel.name.rpartition("/")[2] in SHARED:
            continue
        if len(channel.offers) < 2 and len(channel.uses) < 2:
            continue
        known = view.once(owners)
        copies = _copies(channel.offers, known)
        if copies:
            shared = _is_gathered(channel, copies, known) or not all(map(_surely_publishes, copies))
            yield _finding(channel, copies, known, Severity.INFO if shared else None)
        elif not channel.offers and (copies := _copies(channel.uses, known)):
            yield _finding(channel, copies, known, Severity.INFO)


def _copies(endpoints: list[Endpoint], known: Owners) -> list[Endpoint]:
    """The endpoints of nodes of one program in different namespaces, all of them global; empty where there are not two."""
    groups: dict[tuple[str, object], dict[str, Endpoint]] = {}
    for endpoint in endpoints:
        instance = known[id(endpoint)]
        counts = endpoint.certain and not instance.node.is_test and not endpoint.type.startswith(SHARED_TYPES)
        cause = _cause(endpoint, instance) if counts else None
        if cause is not None:
            groups.setdefault((instance.program, cause), {}).setdefault(instance.node.namespace, endpoint)
    return max((list(group.values()) for group in groups.values() if len(group) > 1), key=len, default=[])


def _surely_publishes(endpoint: Endpoint) -> bool:
    return endpoint.declaration.when == "start" and is_known_to_act(endpoint)


def _is_gathered(channel: Channel, copies: list[Endpoint], known: Owners) -> bool:
    """Whether the launch file says so, by ``args`` or a remap, and a node outside the namespaces of the copies hears all of them."""
    if _cause(copies[0], known[id(copies[0])]) == _IN_THE_CODE:
        return False
    namespaces = tuple(known[id(copy)].node.namespace for copy in copies)
    return any(not known[id(use)].node.namespace.startswith(namespaces) for use in channel.uses)


def _cause(endpoint: Endpoint, instance: Instance) -> object:
    """What makes the name global, equal for copies of one node: the code, or a remap or args written once; None where it is not."""
    if endpoint.action:
        return None
    if endpoint.applied:
        rule = endpoint.applied[-1].rule
        if not rule.target.startswith("/"):
            return None
        place = rule.remap.origin.place if rule.remap is not None else instance.node.origin.place
        return place.key
    if not endpoint.declared.startswith("/"):
        return None
    if endpoint.declaration.name.startswith("/"):
        return _IN_THE_CODE
    place = instance.node.origin.place
    return place.key


def _finding(channel: Channel, copies: list[Endpoint], known: Owners, severity: Severity | None) -> Finding:
    last = copies[-1]
    instance = known[id(last)]
    names = ", ".join(sorted(copy.node for copy in copies)[:4]) + (" …" if len(copies) > 4 else "")
    does = "all subscribe to"
    if copies[0].role == "publisher":
        does = "all publish" if all(map(_surely_publishes, copies)) else "may all publish"
    words = how(last, instance)
    return RULE.at(
        acting_origin(last, instance),
        f"the copies {names} of {instance.program} {does} {channel.name}: their namespaces do not keep it apart",
        severity=severity,
        label="a global name" if last.applied else "says a global name",
        notes=(words,) if words else (),
        help=f"{_help(last, instance)}{'' if severity is None else ', unless they are to share it'}",
        topic=channel.name,
    )


def _help(endpoint: Endpoint, instance: Instance) -> str:
    if endpoint.applied:
        return f"write {endpoint.applied[-1].rule.target} without / at its start"
    return put_remap(instance, endpoint.declared, endpoint.declared[1:])
