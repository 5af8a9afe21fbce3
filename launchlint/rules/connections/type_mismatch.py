"""A publisher and a subscriber of one topic speak different types.

The same holds for server and client of a service, and of an action. It is a warning where the two types may be one definition under two
names (a copy of a message in a package of one's own), and silent where they are: both are in the workspace, and are alike field by field.
Of two such types it is an info where one end is a program of the workspace and the other one is public, and the former is in a package
that rosbuild builds, or the package of the latter lies in the workspace, too: which type that version of it has nobody knows here. The
same two programs with the same two types are told of once, also where several launch files start them, and so are all programs that take
one of two such names for the other, and all that meet one program on one topic with another type than its own. In ROS 2 types of different
names never meet, whatever is in them; it is an info where they differ as those of two releases of a public program do, whose messages
moved to a package of their own (`turtlesim/msg/Pose` and `turtlesim_msgs/msg/Pose`), or from it (`opennav_docking_msgs`), or whose speeds
got a header with Jazzy (`Twist` and `TwistStamped`), and where two public programs are known from two states of one repository: those of
one release may well have one type.

It is a warning where two public programs of different packages meet by the names in their code alone, which may be by chance. Nothing is
said of an input for which params of the node switch on a file (`use_pcd_map: true` and a `map_path` for `map`).

## Why it matters

ROS compares the MD5 sums of the two definitions and refuses the connection: no message ever arrives, while the
topic looks all right in `rostopic list`. In ROS 2 the two do not even find each other, and nobody is told.

## Example

```xml
<launch>
  <node pkg="teleop_twist_keyboard" type="teleop_twist_keyboard.py" name="teleop"/>
  <node pkg="turtlesim" type="turtlesim_node" name="sim">
    <remap from="turtle1/pose" to="cmd_vel"/>
  </node>
  <node pkg="turtlesim" type="turtlesim_node" name="other_sim">
    <remap from="turtle1/cmd_vel" to="cmd_vel"/>
  </node>
</launch>
```

## Use instead

```xml
<launch>
  <node pkg="teleop_twist_keyboard" type="teleop_twist_keyboard.py" name="teleop"/>
  <node pkg="turtlesim" type="turtlesim_node" name="sim">
    <remap from="turtle1/pose" to="pose"/>
  </node>
  <node pkg="turtlesim" type="turtlesim_node" name="other_sim">
    <remap from="turtle1/cmd_vel" to="cmd_vel"/>
  </node>
</launch>
```
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Iterator, Sequence

from launchlint.finding import Finding, Severity
from launchlint.graph.connections import Channel, Endpoint
from launchlint.late import late
from launchlint.library.shipped import is_in_library
from launchlint.library.template import is_template, parse
from launchlint.model import ROS2
from launchlint.rules.judging.given_by_file import is_given_by_file
from launchlint.rules.judging.joined import alike, joined
from launchlint.rules.judging.name_places import TALKS, acting_origin, how, node_origin, owners, remap_origin, with_sources
from launchlint.rules.judging.of_rosbuild import SINCE, is_of_rosbuild
from launchlint.rules.judging.other_file import is_inside
from launchlint.rules.judging.same_definition import is_known, may_be_alike, may_be_copies
from launchlint.rules.judging.written_definition import are_written_alike
from launchlint.rules.rule import Rule
from launchlint.rules.view import GraphView

RULE = Rule("LL611", "type-mismatch", Severity.ERROR)
_WITH_HEADER = frozenset(("geometry_msgs/msg/Twist", "geometry_msgs/msg/TwistStamped"))
_NUMBER = late(r"\d+")
"""Programs and names for each of several robots are told together."""
_WHAT_HAPPENS_2 = {
    "topic": "in ROS 2 ends of different types do not find each other: no message ever arrives",
    "service": "in ROS 2 ends of different types do not find each other: the client waits for the service for ever",
    "action": "in ROS 2 ends of different types do not find each other: the client waits for the server for ever",
}
_WHAT_HAPPENS = {
    "topic": "the MD5 sums of the two differ, so the publisher refuses the connection: no message ever arrives",
    "service": "the MD5 sums of the two differ, so the server refuses every call",
    "action": "the MD5 sums of their messages differ, so that no goal arrives and no result comes back",
}


def check(view: GraphView) -> Iterator[Finding]:
    """Look at every name that nodes of both sides certainly have."""
    if view.dialect.name == ROS2:
        for channel in view.graph.channels.values():
            for offer, use in _mismatches(channel, view, _have_one_name):
                yield _finding(channel, offer, use, view, alike=False, effect=_WHAT_HAPPENS_2[channel.kind])
        return
    for channel in view.graph.channels.values():
        for offer, use in _mismatches(channel, view, may_be_alike):
            known = bool(offer.declaration.md5 and use.declaration.md5)
            alike = not known and are_written_alike(offer.type, use.type, channel.kind, view.packages, view.launch.entry.file)
            if not alike:
                yield _finding(channel, offer, use, view, alike, _WHAT_HAPPENS[channel.kind])


def _have_one_name(left: str, right: str, *_: str) -> bool:
    """DDS matches topics whose types are called alike, and rmw makes their names of those of the types."""
    return left == right


def _mismatches(channel: Channel, view: GraphView, are_alike: Callable[[str, str, str, str], bool]) -> Iterator[tuple[Endpoint, Endpoint]]:
    """One pair of ends for each pair of types that cannot talk to each other."""
    if not channel.offers or not channel.uses:
        return
    offers, uses = _by_type(channel.offers), _by_type(channel.uses)
    if not offers or not uses or (len(offers) == 1 and offers.keys() == uses.keys()):
        return
    for (offered, offered_md5), givers in offers.items():
        for (used, used_md5), takers in uses.items():
            if are_alike(offered, used, offered_md5, used_md5):
                continue
            pair = next(((giver, taker) for giver in givers[:2] for taker in takers[:2] if giver.node != taker.node), None)
            if pair is not None and not is_given_by_file(pair[1], view.once(owners)[id(pair[1])], view.graph.parameters):
                yield pair


def _by_type(endpoints: list[Endpoint]) -> dict[tuple[str, str], list[Endpoint]]:
    found: dict[tuple[str, str], list[Endpoint]] = {}
    for endpoint in endpoints:
        if endpoint.certain and is_known(endpoint.type) and not endpoint.action:
            found.setdefault((endpoint.type, endpoint.declaration.md5), []).append(endpoint)
    return found


def _finding(channel: Channel, offer: Endpoint, use: Endpoint, view: GraphView, alike: bool | None, effect: str) -> Finding:
    owner = view.once(owners)
    giver, taker = owner[id(offer)], owner[id(use)]
    acting = offer if remap_origin(offer) is not None and remap_origin(use) is None else use
    other = use if acting is offer else offer
    mine, theirs = owner[id(acting)], owner[id(other)]
    copies = alike is None and may_be_copies(offer.type, use.type, channel.kind)
    notes = [effect]
    if copies:
        notes = [f"unless the two are defined alike, field by field: {effect}"]
    notes.extend(text for text in (how(acting, mine), how(other, theirs)) if text)
    old = (_other_version(offer, use, view) or _other_version(use, offer, view)) if copies else ""
    if not old and view.dialect.name == ROS2:
        old = _other_release(offer, use, view) or _other_release(use, offer, view) or _other_state(offer, use)
    if old:
        notes.append(old)
    found = RULE.at(
        acting_origin(acting, mine),
        f"{giver.name} {TALKS[offer.role]} {channel.name} as {offer.type}, but {taker.name} {TALKS[use.role]} it as {use.type}",
        severity=Severity.INFO if old else Severity.WARNING if copies or _meet_by_chance(offer, use, view) else None,
        label=f"{acting.type} here",
        related=((node_origin(theirs).place, f"{theirs.name} {TALKS[other.role]} it as {other.type}"),),
        notes=tuple(notes),
        help="give one of the two another name, or put a node between them that converts",
        topic=f"{channel.kind} {channel.name} {offer.type} {use.type}",
        cause=f"{offer.type} {use.type}"
        if copies
        else _NUMBER.sub("#", f"{giver.program} {taker.program} {channel.kind} {channel.name.rpartition('/')[2]}")
        + f" {offer.type} {use.type}",
        about=(giver.program, taker.program),
    )
    return with_sources(found, acting, other)


def of_copies(findings: Sequence[Finding]) -> Iterator[Finding]:
    """One for all that one program of another type than theirs is told of: it is that one to which something was done."""
    ends = Counter((end, each.topic) for each in findings for end in enumerate(each.about))

    def other(finding: Finding) -> object:
        own = [(end, finding.topic) for end in enumerate(finding.about)]
        return max(own, key=lambda end: ends[end], default=id(finding))

    for several in alike(findings, other):
        yield joined(several) if len(several) > 1 else several[0]


def idea(finding: Finding) -> tuple[object, ...]:
    """One node has several names with a type that another package's programs do not know: what its code says of their kind is wrong."""
    kind, _, *types = finding.topic.split(" ")
    return (finding.location, finding.label, kind, *types)


def _meet_by_chance(offer: Endpoint, use: Endpoint, view: GraphView) -> bool:
    """Whether two public programs of different packages have a name in common that nothing gave to them: that of the code of each."""
    packages = {view.once(owners)[id(end)].program.partition("/")[0].partition("::")[0] for end in (offer, use)}
    as_said = not any(end.applied or end.is_read_here or not _is_as_coded(end) for end in (offer, use))
    return as_said and len(packages) > 1 and all(is_in_library(each, view.dialect.name) for each in packages)


def _is_as_coded(end: Endpoint) -> bool:
    """Whether the name is what it is where neither args nor params say another one."""
    if not is_template(end.declaration.name):
        return True
    defaults = [(part,) if isinstance(part, str) else part.default or () for part in parse(end.declaration.name)]
    return end.declared == "".join(text for each in defaults for text in each if isinstance(text, str))


def _other_release(own: Endpoint, other: Endpoint, view: GraphView) -> str:
    """Why the type of ``other``, a public program, may be that of ``own``, which is read here, in the release that this is written for:
    their messages moved to a package of their own (turtlesim, turtlesim_msgs), or those for speeds got a header (since Jazzy). Empty where
    nothing says so.
    """
    if not own.is_read_here or other.is_read_here:
        return ""
    program = view.once(owners)[id(other)].program
    if {own.type, other.type} == _WITH_HEADER:
        return f"with Jazzy the speeds got a header, and what is known of {program} is what one release does"
    (mine, _, message), (theirs, _, same) = own.type.partition("/"), other.type.partition("/")
    short, long = sorted((mine, theirs), key=len)
    if message != same:
        return ""
    package = program.partition("/")[0].partition("::")[0]
    if package not in (mine, theirs) and mine in (f"{package}_msgs", f"{package}_interfaces"):
        return f"{mine} has the messages of {package}, and what is known of {program} is what a release with others does"
    if long not in (f"{short}_msgs", f"{short}_interfaces"):
        return ""
    return f"messages of {short} and {long} are of different releases, and what is known of {program} is what one of them does"


def _other_state(offer: Endpoint, use: Endpoint) -> str:
    """Why the two, of public programs, may go together: their types are known from two states of one repository. Empty where not."""
    if offer.is_read_here or use.is_read_here:
        return ""
    given, taken = (dict(sorted(_states(end))) for end in (offer, use))
    for repository, state in given.items():
        if taken.get(repository, state) != state:
            return f"the two are known from two states of {repository.rpartition('/')[2]}: those of one release may have the same type"
    return ""


def _states(end: Endpoint) -> Iterator[tuple[str, str]]:
    """The repositories, with their owners, and the state of each, from which something public is known."""
    for fact in end.declaration.evidence:
        repository, at, rest = fact.get("at", "").partition("@")
        if at:
            yield repository, rest.partition(":")[0]


def _other_version(own: Endpoint, other: Endpoint, view: GraphView) -> str:
    """Why what is known of ``other``, a public program, may not hold beside ``own``, which is read here; empty where nothing says so."""
    if not own.is_read_here or other.is_read_here:
        return ""
    mine, public = (view.once(owners)[id(end)].program.partition("/")[0] for end in (own, other))
    if is_of_rosbuild(view.packages.get(mine, view.launch.entry.file)):
        return SINCE
    found = view.packages.get(public, view.launch.entry.file)
    if found is not None and is_inside(found.directory, view.packages.workspaces):
        return f"{public} lies in this workspace, and what is known of its programs is what a release does"
    return ""
