"""A publisher offers less than a subscriber of the topic asks for, and the two do not connect.

What it does: it compares the quality of service of both ends, as far as it is known for certain: what the code says, and the params and
`qos_overrides` with which the launch file changes that. Reliability, durability, deadline, liveliness and its lease are policies of which a
publisher has to offer at least what a subscriber asks for. Nothing is said of values that the sources or a library do not tell. It is a
warning where the subscriber hears another publisher on that topic, or may not be there. What the code of one program asks for on several
topics, or offers, is told once.

## Why it matters

Both nodes run and are seen on the topic, and no message ever arrives. At most one line in the output of each tells of it.

## Example

```xml example.launch.xml
<launch>
  <node pkg="lidar" exec="driver" name="driver"/>
  <node pkg="mapping" exec="mapper" name="mapper"/>
</launch>
```

```yaml .launchlint.yaml
library: [nodes.json]
```

```json nodes.json
{"format": "launchlint-library", "version": 2, "packages": {
  "lidar": {"middleware": "ros2", "executables": {"driver": {"class": "rclcpp", "variants": {"default": {
    "publishers": [{"name": "scan", "type": "sensor_msgs/msg/LaserScan", "qos": {"reliability": "best_effort"}, "overrides": true}]}}}}},
  "mapping": {"middleware": "ros2", "executables": {"mapper": {"class": "rclcpp", "variants": {"default": {
    "subscribers": [{"name": "scan", "type": "sensor_msgs/msg/LaserScan", "qos": {"reliability": "reliable"}}]}}}}}
}}
```

## Use instead

```xml example.launch.xml
<launch>
  <node pkg="lidar" exec="driver" name="driver">
    <param name="qos_overrides./scan.publisher.reliability" value="reliable"/>
  </node>
  <node pkg="mapping" exec="mapper" name="mapper"/>
</launch>
```

```yaml .launchlint.yaml
library: [nodes.json]
```

```json nodes.json
{"format": "launchlint-library", "version": 2, "packages": {
  "lidar": {"middleware": "ros2", "executables": {"driver": {"class": "rclcpp", "variants": {"default": {
    "publishers": [{"name": "scan", "type": "sensor_msgs/msg/LaserScan", "qos": {"reliability": "best_effort"}, "overrides": true}]}}}}},
  "mapping": {"middleware": "ros2", "executables": {"mapper": {"class": "rclcpp", "variants": {"default": {
    "subscribers": [{"name": "scan", "type": "sensor_msgs/msg/LaserScan", "qos": {"reliability": "reliable"}}]}}}}}
}}
```
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from launchlint.finding import Finding, Severity
from launchlint.graph.connections import Channel, Endpoint
from launchlint.graph.qos import Clash, clashes
from launchlint.library.template import Slot, is_template, parse
from launchlint.named_tuple import NamedTuple
from launchlint.plural import counted, listed
from launchlint.rules.judging.joined import joined, spokesman
from launchlint.rules.judging.name_places import Owners, acting_origin, how, node_origin, owners, remap_origin, with_sources
from launchlint.rules.judging.same_definition import may_be_alike
from launchlint.rules.rule import Rule
from launchlint.rules.view import GraphView

RULE = Rule("LL942", "qos-incompatible", Severity.ERROR)
_MOST_NAMED = 6
_MOST_PROFILES = 20
_IN_THE_CODE = "let the publisher offer more, or the subscriber ask for less: the code of the two says what they do"
_OVERRIDABLE = ("history", "depth", "reliability")
_SIDES = {"publisher": "publisher", "subscriber": "subscription"}


class _Pair(NamedTuple):
    """A publisher and a subscriber that do not connect. ``others``: how many more pairs of the same two profiles there are."""

    offer: Endpoint
    use: Endpoint
    clashes: tuple[Clash, ...]
    others: int


def check(view: GraphView) -> Iterator[Finding]:
    """Look at every topic of both sides (rmw_qos_profile_check_compatible)."""
    for channel in view.graph.channels.values():
        if channel.kind == "topic" and channel.offers and channel.uses:
            for pair in _pairs(channel):
                yield _finding(channel, pair, view.once(owners))


def _pairs(channel: Channel) -> Iterator[_Pair]:
    """One pair for each two profiles that clash: of one program there are often many nodes."""
    offers, uses = _profiles(channel.offers), _profiles(channel.uses)
    for givers in offers:
        for takers in uses:
            found = clashes(givers[0].qos, takers[0].qos)
            pairs = [(giver, taker) for giver in givers[:2] for taker in takers[:2] if giver.node != taker.node] if found else []
            if pairs and may_be_alike(givers[0].type, takers[0].type):
                yield _Pair(*pairs[0], found, len(givers) * len(takers) - 1)


def _profiles(endpoints: Sequence[Endpoint]) -> list[list[Endpoint]]:
    """The ends that are there for certain and of which something is known, by program, type and profile."""
    found: dict[object, list[Endpoint]] = {}
    for each in endpoints:
        if each.certain and each.qos:
            found.setdefault((id(each.declaration), each.type, tuple(sorted(each.qos.items()))), []).append(each)
    return list(found.values())[:_MOST_PROFILES]


def _finding(channel: Channel, pair: _Pair, owner: Owners) -> Finding:
    offer, use = pair.offer, pair.use
    giver, taker = owner[id(offer)], owner[id(use)]
    acting = offer if remap_origin(offer) is not None and remap_origin(use) is None else use
    mine, other = owner[id(acting)], (use if acting is offer else offer)
    hears = [each for each in channel.offers if each.certain and each is not offer and not clashes(each.qos, use.qos)]
    first = pair.clashes[0]
    notes = ["the two do not connect: both run, and no message ever arrives"]
    if hears:
        notes = [f"the two do not connect: of {channel.name} {taker.name} hears {hears[0].node} only"]
    notes += [f"{each.policy}: {_said(each.offered)} is offered, {_said(each.requested)} is asked for" for each in pair.clashes[1:]]
    notes += [text for text in (how(acting, mine), how(other, owner[id(other)])) if text]
    if pair.others:
        notes.append(f"the same holds for {counted(pair.others, 'more pair')} of these programs")
    severity = Severity.WARNING if hears else RULE.severity
    advice = _advice(channel.name, first, offer, use)
    ends = f"{giver.program} {taker.program} {channel.name}" if advice else ""  # what a launch file changes, it changes for each topic
    found = RULE.at(
        acting_origin(acting, mine),
        f"{taker.name} asks for {_asked(first)} on {channel.name}, but {giver.name} offers {_offered(first)}",
        severity=severity,
        label=f"{acting.role} with {_said(first.offered if acting is offer else first.requested)}",
        related=(
            (node_origin(owner[id(other)]).place, f"{other.role} with {_said(first.requested if acting is offer else first.offered)}"),
        ),
        notes=tuple(notes),
        help=advice or _IN_THE_CODE,
        topic=f"{channel.name} {first.policy}",
        cause=f"{severity.word} {mine.program} {acting.role} {' '.join(map(str, first))} {ends}".rstrip(),
    )
    return with_sources(found, acting, other)


def together(findings: Sequence[Finding]) -> Finding:
    """One program asks for one thing, or offers it, wherever that does not fit: the first topic, the names of the others, all ends."""
    first = spokesman(findings)
    topics = dict.fromkeys(each.topic.partition(" ")[0] for each in (first, *findings))
    others = list(topics)[1:]
    if not others:
        return joined(findings, first)
    here = [each for each in findings if each is not first and each.location == first.location]
    said = first._replace(
        message=f"{first.message}; likewise on {listed(others, _MOST_NAMED)}",
        related=tuple(dict.fromkeys(item for each in (first, *here) for item in each.related)),
        notes=tuple(dict.fromkeys(note for each in (first, *here) for note in each.notes)),
    )
    return joined([said, *(each for each in findings if each is not first)], said)


def _asked(clash: Clash) -> str:
    return {
        "reliability": "reliable messages",
        "durability": f"{clash.requested} messages (those sent before it came)",
        "liveliness": "liveliness manual_by_topic",
        "deadline": f"a message every {_said(clash.requested)}",
        "lease": f"a sign of life every {_said(clash.requested)}",
    }[clash.policy]


def _offered(clash: Clash) -> str:
    if clash.policy in ("deadline", "lease"):
        return "no such promise" if _said(clash.offered) == "infinite" else f"one every {_said(clash.offered)}"
    return str(clash.offered)


def _said(value: str | float) -> str:
    return value if isinstance(value, str) else "infinite" if value == 0 else f"{value:g} s"


def _advice(topic: str, clash: Clash, offer: Endpoint, use: Endpoint) -> str:
    """What in the launch file changes it, if anything does."""
    for end, wanted in ((offer, clash.requested), (use, clash.offered)):
        said = (end.declaration.qos or {}).get(clash.policy, "")
        if end.declaration.overrides and clash.policy in _OVERRIDABLE:
            return f"set the param qos_overrides.{topic}.{_SIDES[end.role]}.{clash.policy} of {end.node} to {wanted}"
        if isinstance(said, str) and is_template(said):
            param = next((part.key for part in parse(said) if isinstance(part, Slot) and part.kind == "param"), "")
            if param:
                return f"set the param {param.lstrip('~')} of {end.node} to {wanted}"
    return ""
