"""Several nodes publish the same command topic.

What it does: it looks for topics that command something (`cmd_vel`, `cmd`, `command` and the like) with two or more publishers of
different nodes. Publishers that may or may not be there do not count, and neither does a second relay of the same input. Only the
publishers of that very topic count: behind a mux there is one. Trajectories do not count, whatever the topic is called: nodes take turns
in sending those. It is an info where all but one are silent until a person acts, who takes over from a planner so: by holding a button of
the joystick (a dead-man switch), or by pressing a key, for programs of which the library says that they send nothing else.

## Why it matters

A driver obeys every message. With two sources, say a joystick and a planner, it gets both in turn: the robot jerks between two
commands, or does not stop when one of them says so.

## Example

```xml
<launch>
  <node pkg="turtlesim" type="turtlesim_node" name="turtle"/>
  <node pkg="turtlebot3_teleop" type="turtlebot3_teleop_key" name="teleop">
    <remap from="cmd_vel" to="turtle1/cmd_vel"/>
  </node>
  <node pkg="turtlesim" type="draw_square" name="square"/>
</launch>
```

## Use instead

```xml
<launch>
  <node pkg="turtlesim" type="turtlesim_node" name="turtle"/>
  <node pkg="turtlebot3_teleop" type="turtlebot3_teleop_key" name="teleop">
    <remap from="cmd_vel" to="teleop/cmd_vel"/>
  </node>
  <node pkg="turtlesim" type="draw_square" name="square">
    <remap from="turtle1/cmd_vel" to="square/cmd_vel"/>
  </node>
  <node pkg="topic_tools" type="mux" name="mux" args="turtle1/cmd_vel teleop/cmd_vel square/cmd_vel"/>
</launch>
```
"""

from __future__ import annotations

import re
from collections.abc import Iterator

from launchlint.finding import Finding, Severity
from launchlint.graph.connections import Channel, ConnectionGraph, Endpoint, Instance
from launchlint.late import late
from launchlint.rules.connections.places import Owners, acting_origin, how, node_origin, owners
from launchlint.rules.rule import Rule
from launchlint.rules.view import GraphView

RULE = Rule("LL616", "competing-publishers", Severity.WARNING)

COMMANDS = frozenset({"cmd_vel", "cmd_vel_unstamped", "cmd_vel_stamped", "cmd", "cmd_drive", "ackermann_cmd", "command", "commands"})
"""Last parts of the names of topics that command something: a driver obeys each message on them."""
DEAD_MAN = late(r"dead_?man|(?:.*/)?enable_(?:button|axis)\Z", re.IGNORECASE)
"""The param of the button, or axis, that must be held while a joystick commands; a negative number says that there is none."""
TURNS = "trajectory_msgs/"
"""The package of messages that say all that is to be done: nodes take turns in sending them."""
JOYSTICK = "sensor_msgs/Joy"


def check(view: GraphView) -> Iterator[Finding]:
    """Look at every command topic."""
    known: Owners | None = None
    for channel in view.graph.channels.values():
        if channel.kind != "topic" or len(channel.offers) < 2 or channel.name.rpartition("/")[2] not in COMMANDS:
            continue
        known = known or owners(view.graph)
        sources = _sources(channel, known)
        if len(sources) > 1:
            yield _finding(channel, sources, known, view.graph)


def _sources(channel: Channel, known: Owners) -> list[Endpoint]:
    """One publisher of each node that publishes on its own account; of relays of one input, the first."""
    found: dict[str, Endpoint] = {}
    inputs: set[str] = set()
    for endpoint in channel.offers:
        if not endpoint.certain or endpoint.action or endpoint.type.startswith(TURNS) or known[id(endpoint)].node.is_test:
            continue  # tests run one after another
        if endpoint.declaration.when == "message":
            heard = {each.name for each in known[id(endpoint)].endpoints if each.role == "subscriber"}
            if heard & inputs:
                continue
            inputs |= heard
        found.setdefault(endpoint.node, endpoint)
    return list(found.values())


def _by_hand(source: Endpoint, instance: Instance, graph: ConnectionGraph) -> str:
    """What a person does while the node commands; empty where it does so on its own."""
    if source.declaration.by_hand:
        return "presses keys"
    return "holds a button of the joystick" if _is_held(instance, graph) else ""


def _is_held(source: Instance, graph: ConnectionGraph) -> bool:
    """Whether the node hears a joystick and commands only while somebody holds a button of it."""
    if not any(each.role == "subscriber" and each.type == JOYSTICK for each in source.endpoints):
        return False
    for reading in source.readings:
        if DEAD_MAN.search(reading.declared.lstrip("~")):
            value = graph.parameters.value(reading.name)
            value = reading.declaration.default if value is None else value
            if not isinstance(value, int | float) or value >= 0:
                return True
    return False


def _finding(channel: Channel, sources: list[Endpoint], known: Owners, graph: ConnectionGraph) -> Finding:
    first, *_, last = sources
    ways = {source.node: way for source in sources if (way := _by_hand(source, known[id(source)], graph))}
    taking_over = len(sources) - len(ways) <= 1
    names = ", ".join(sorted(source.node for source in sources)[:4]) + (" …" if len(sources) > 4 else "")
    heard = next((use.node for use in channel.uses if use.certain), "")
    notes = [f"{heard} obeys all of them"] if heard else []
    if taking_over:
        node, way = next(iter(ways.items()))
        notes.append(f"{node} commands only while somebody {way}")
    notes += [words for words in (how(source, known[id(source)]) for source in (first, last)) if words]
    return RULE.at(
        acting_origin(last, known[id(last)]),
        f"{len(sources)} nodes publish the commands on {channel.name}: {names}",
        severity=Severity.INFO if taking_over else None,
        label="publishes it, too",
        related=((node_origin(known[id(first)]).place, f"{first.node} publishes it"),),
        notes=tuple(notes),
        help="give each of them a topic of its own and decide between them with a mux (twist_mux, topic_tools/mux)",
        topic=channel.name,
    )
