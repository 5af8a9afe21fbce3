"""Some nodes of a launch run on simulated time and others do not, or `use_sim_time` is a text.

What it does: it looks at `use_sim_time` of all nodes of a launch that is known to its end. It is an error where it is anything but true or
false; a warning where the same program is started with it and without it; information where most nodes have it and a few do not.

## Why it matters

A node on the wall clock throws the messages of the others away as decades too old, or waits for a transform that never comes. With a text
in `use_sim_time` a node dies when it starts.

## Example

```xml
<launch>
  <node pkg="demo_nodes_cpp" exec="talker" name="front">
    <param name="use_sim_time" value="true"/>
  </node>
  <node pkg="demo_nodes_cpp" exec="talker" name="rear"/>
  <node pkg="demo_nodes_cpp" exec="listener" name="listener">
    <param name="use_sim_time" value="'true'"/>
  </node>
</launch>
```

## Use instead

```xml
<launch>
  <set_parameter name="use_sim_time" value="true"/>
  <node pkg="demo_nodes_cpp" exec="talker" name="front"/>
  <node pkg="demo_nodes_cpp" exec="talker" name="rear"/>
  <node pkg="demo_nodes_cpp" exec="listener" name="listener"/>
</launch>
```
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from launchlint.finding import Finding, Severity
from launchlint.model import Node, Unknown
from launchlint.plural import listed
from launchlint.rules.rule import Rule
from launchlint.rules.view import LaunchView
from launchlint.rules.wording import words_at
from launchlint.source import Origin

RULE = Rule("LL943", "sim-time-patchy", Severity.WARNING)
_NAME = "use_sim_time"
_FEW = 3
"""Of so many nodes with simulated time one may be without, to be told."""
_MOST_NAMED = 4


def check(view: LaunchView) -> Iterator[Finding]:
    """Yield one finding for each text, and one for all that is on another clock (rclcpp.TimeSource, rclpy.time_source)."""
    simulated: list[Node] = []
    without: list[Node] = []
    known = view.launch.complete
    for node in view.launch.nodes:
        if node.own is None or not node.name or any(condition.assumed for condition in node.conditions):
            known = False
            continue
        kind, value = node.own.get(_NAME, ("", None))
        if kind == "bool" and value is True:
            simulated.append(node)
        elif not kind:
            without.append(node)
        elif kind != "bool" and not isinstance(value, Unknown) and kind != "unknown":
            yield _no_boolean(node, kind, value)
    if known and simulated and without:
        yield from _patchy(simulated, without)


def _no_boolean(node: Node, kind: str, value: object) -> Finding:
    return RULE.at(
        _origin(node),
        f"use_sim_time of {_called(node)} is {value!r}, which is not true or false",
        severity=Severity.ERROR,
        label=f"of the type {kind}",
        notes=("the node dies when it starts: it declares use_sim_time as a boolean",),
        help="write true or false, and nothing that makes a text of it: no quotes, no type str",
        cause="no boolean",
    )


def _patchy(simulated: list[Node], without: list[Node]) -> Iterator[Finding]:
    programs = {_program(node) for node in simulated}
    same = [node for node in without if _program(node) in programs]
    if not same and len(simulated) < _FEW * len(without):
        return
    told = same or without
    named = listed([_called(node) for node in told], _MOST_NAMED)
    other = next((node for node in simulated if same and _program(node) == _program(same[0])), simulated[0])
    yield RULE.at(
        told[0].origin,
        f"{named} {'run' if len(told) > 1 else 'runs'} on the wall clock, and {_called(other)} on simulated time",
        severity=None if same else Severity.INFO,
        label="without use_sim_time",
        related=((other.origin.place, "with use_sim_time"), *((node.origin.place, "without, too") for node in told[1:])),
        help="set it for all, before the first node: "
        + words_at(told[0].origin).written(
            "set_parameter", {"name": "use_sim_time", "value": "true"}, "SetParameter('use_sim_time', True)"
        ),
        cause="patchy",
    )


def _program(node: Node) -> tuple[str, str]:
    return node.package, node.plugin or node.executable


def _called(node: Node) -> str:
    return node.full_name if node.name else node.plugin or node.executable


def _origin(node: Node) -> Origin:
    """Where it is set, as far as that is in a launch file."""
    for source in node.sources:
        values = source.content.values() if isinstance(source.content, Mapping) else ()
        if any(isinstance(each, Mapping) and _NAME in each.get("ros__parameters", ()) for each in values):
            return source.origin
    return node.origin
