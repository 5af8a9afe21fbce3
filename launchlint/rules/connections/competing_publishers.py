"""Several nodes publish the same command topic.

What it does: it looks for topics that command something (`cmd_vel`, `cmd`, `command` and the like) with two or more publishers of
different nodes. Publishers that may or may not be there do not count, and neither does a second relay of the same input. Only the
publishers of that very topic count: behind a mux there is one. A node that only sends on what it hears (a relay, a throttle, a mux) counts
where something in the launch publishes its input, and then that is named, too; else it waits for a person or another launch file.
Trajectories do not count, whatever the topic is called: nodes take turns in sending those. It is an info where all but one are silent
until a person acts, who takes over from a planner so: by holding a button of the joystick (a dead-man switch), or by a key or a slider, for
programs of which the library says that they send nothing else. It is an info, too, where fewer than two are known to command on their own
account: of a publisher that was only read from source, or seen in a run, nobody knows whether it waits for a click, a goal or for ever.
What the same programs do, for several robots or in several files, is told once.

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
from collections.abc import Iterator, Sequence

from launchlint.finding import Finding, Severity
from launchlint.graph.connections import Channel, ConnectionGraph, Endpoint, Instance
from launchlint.late import late
from launchlint.named_tuple import NamedTuple
from launchlint.rules.judging.conduits import forwarded
from launchlint.rules.judging.joined import joined
from launchlint.rules.judging.name_places import Owners, acting_origin, how, is_known_to_act, node_origin, owners
from launchlint.rules.rule import Rule
from launchlint.rules.view import GraphView
from launchlint.workspace.registered_tests import TEST_END

RULE = Rule("LL616", "competing-publishers", Severity.WARNING)

COMMANDS = frozenset({"cmd_vel", "cmd_vel_unstamped", "cmd_vel_stamped", "cmd", "cmd_drive", "ackermann_cmd", "command", "commands"})
"""Last parts of the names of topics that command something: a driver obeys each message on them."""
DEAD_MAN = late(r"dead_?man|enable_(?:button|axis)\Z", re.IGNORECASE)
"""The param of the button, or axis, that must be held while a joystick commands; a negative number says that there is none."""
TURNS = "trajectory_msgs/"
"""The package of messages that say all that is to be done: nodes take turns in sending them."""
JOYSTICK = "sensor_msgs/Joy"


class Source(NamedTuple):
    """A publisher of commands, and where it has them from: ``origins`` is itself, or, if it sends on what it hears, who publishes that."""

    endpoint: Endpoint
    origins: tuple[Endpoint, ...]

    @property
    def name(self) -> str:
        """The node in words."""
        first = self.origins[0].node
        return first if first == self.endpoint.node else f"{first} (through {self.endpoint.node})"


def check(view: GraphView) -> Iterator[Finding]:
    """Look at every command topic."""
    for channel in view.graph.channels.values():
        if channel.kind != "topic" or len(channel.offers) < 2 or channel.name.rpartition("/")[2] not in COMMANDS:
            continue
        known = view.once(owners)
        sources = _sources(channel, known, view.graph)
        if len(sources) > 1:
            yield _finding(channel, sources, known, view.graph)


def together(findings: Sequence[Finding]) -> Finding:
    """What the same programs do, in several files or for several robots: the topics of the others are named."""
    places = {finding.location: finding for finding in reversed(findings)}
    told = joined([finding for finding in findings if places[finding.location] is finding])
    topics = sorted({finding.topic for finding in findings} - {told.topic})
    if not topics:
        return told
    more = f" and {len(topics) - 4} more" if len(topics) > 4 else ""
    return told._replace(notes=(*told.notes, f"the same programs do so on {', '.join(topics[:4])}{more}"))


def _sources(channel: Channel, known: Owners, graph: ConnectionGraph) -> list[Source]:
    """One publisher of each node that publishes on its own account; of relays of one input, the first."""
    found: dict[str, Source] = {}
    inputs: set[str] = set()
    for endpoint in channel.offers:
        if not endpoint.certain or endpoint.action or endpoint.type.startswith(TURNS) or known[id(endpoint)].node.is_test:
            continue  # tests run one after another
        if endpoint.declaration.when == "message":
            heard = {each.name for each in known[id(endpoint)].endpoints if each.role == "subscriber"}
            if heard & inputs:
                continue
            inputs |= heard
        origins = forwarded(endpoint, known, graph)
        if origins is None:
            found.setdefault(endpoint.node, Source(endpoint, (endpoint,)))
        elif origins:
            found.setdefault(endpoint.node, Source(endpoint, origins))
    direct = {source.endpoint.node for source in found.values() if source.origins == (source.endpoint,)}
    return [source for node, source in found.items() if node in direct or any(each.node not in direct for each in source.origins)]


def _by_hand(source: Source, known: Owners, graph: ConnectionGraph) -> str:
    """What a person does while the node commands; empty where it does so on its own."""
    ways = [
        "works it by hand" if each.declaration.by_hand else "holds a button of the joystick" if _is_held(known[id(each)], graph) else ""
        for each in source.origins
    ]
    return ways[0] if all(ways) else ""


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


def _hearer(channel: Channel, known: Owners) -> list[str]:
    """Who hears the commands: one that a person described and that sends no such commands on obeys them; of others nobody knows."""
    uses = [use for use in channel.uses if use.certain]
    for use in uses:
        sends = any(each.role == "publisher" and each.type == use.type for each in known[id(use)].endpoints)
        if is_known_to_act(use) and not sends:
            return [f"{use.node} obeys all of them"]
    return [f"{uses[0].node} hears all of them"] if uses else []


def _finding(channel: Channel, sources: list[Source], known: Owners, graph: ConnectionGraph) -> Finding:
    guessed = sorted(source.endpoint.node for source in sources if not any(map(is_known_to_act, source.origins)))
    if len(sources) - len(guessed) > 1:
        sources = [source for source in sources if source.endpoint.node not in guessed]
        guessed = []
    first, last = sources[0].endpoint, sources[-1].endpoint
    ways = {source.origins[0].node: way for source in sources if (way := _by_hand(source, known, graph))}
    taking_over = len(sources) - len(ways) <= 1
    may = bool(guessed) and not taking_over
    does = "may publish" if may else "publishes"
    names = ", ".join(sorted(source.name for source in sources)[:4]) + (" …" if len(sources) > 4 else "")
    notes = _hearer(channel, known)
    if taking_over:
        node, way = next(iter(ways.items()))
        notes.append(f"{node} commands only while somebody {way}")
    if may:
        more = " …" if len(guessed) > 4 else ""
        notes.append(f"whether {', '.join(guessed[:4])}{more} publish{'es' if len(guessed) == 1 else ''} all the time is not known")
    notes += [words for words in (how(each, known[id(each)]) for each in (first, last)) if words]
    here, other = acting_origin(last, known[id(last)]), node_origin(known[id(first)]).place
    tested = graph.launch.entry.file.endswith(TEST_END)
    if tested:
        notes.append("it is a test, which may be there to see what comes of it")
    severity = Severity.INFO if taking_over or may or tested else RULE.severity
    programs = sorted({known[id(source.endpoint)].program for source in sources})
    return RULE.at(
        here,
        f"{len(sources)} nodes {'may publish' if may else 'publish'} the commands on {channel.name}: {names}",
        severity=severity,
        label=f"{does} it, too",
        related=((other, f"{first.node} {does} it"),),
        notes=tuple(notes),
        help="give each of them a topic of its own and decide between them with a mux (twist_mux, topic_tools/mux)",
        topic=channel.name,
        cause=" ".join((severity.word, channel.name.rpartition("/")[2], *programs)),
    )
