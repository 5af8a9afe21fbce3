"""Two nodes serve one service or action name.

What it does: it looks for services and actions with two servers in different processes. It is an error where some node of the launch
calls the service, and for every action; a warning where a node may call it, or not, and an info where none is known to. It is a warning
at most where one of two servers is known only from reading its source, which nobody saw run. Servers that run
one program with the same args and remaps answer alike: that the program is started several times is a warning at most. Names that
belong to the machinery of nodes, and servers that may or may not be there, do not count. The same nodes in several launch files are told of
once.

## Why it matters

The ROS master keeps one server for each service name: the one that registered last. Which one that is changes from start to start, and
nobody is told. Two servers of one action both take every goal, and the client hears two answers. In ROS 2 all servers carry out every
call, and who called takes the answer that comes first.

## Example

```xml
<launch>
  <node pkg="map_server" type="map_server" name="map_server" args="floor.yaml"/>
  <node pkg="map_server" type="map_server" name="zones_server" args="zones.yaml">
    <remap from="map" to="zones"/>
  </node>
  <node pkg="amcl" type="amcl" name="amcl"/>
</launch>
```

## Use instead

```xml
<launch>
  <node pkg="map_server" type="map_server" name="map_server" args="floor.yaml"/>
  <node pkg="map_server" type="map_server" name="zones_server" args="zones.yaml">
    <remap from="map" to="zones"/>
    <remap from="static_map" to="static_zones"/>
  </node>
  <node pkg="amcl" type="amcl" name="amcl"/>
</launch>
```
"""

from __future__ import annotations

from collections.abc import Iterator

from launchlint.finding import Finding, Severity
from launchlint.graph.connections import Channel, Endpoint
from launchlint.rules.judging.name_places import Owners, acting_origin, how, is_of_ros1, node_origin, owners
from launchlint.rules.rule import Rule
from launchlint.rules.view import GraphView

RULE = Rule("LL615", "several-servers", Severity.ERROR)


Clash = tuple[Channel, list[Endpoint]]


def check(view: GraphView) -> Iterator[Finding]:
    """Look at every service and action (rosmaster's registerService, actionlib's ActionServer).

    What the same servers share is told once: two copies of a node share all that they serve.
    """
    clashes: dict[tuple[str, ...], list[Clash]] = {}
    for channel in view.graph.channels.values():
        if channel.kind == "topic" or len(channel.offers) < 2:
            continue
        known = view.once(owners)
        servers: dict[str, Endpoint] = {}
        for endpoint in channel.offers:
            # Tests run one after another, so that a test is never there beside another one.
            if endpoint.certain and not endpoint.is_plumbing and endpoint.process and not known[id(endpoint)].node.is_test:
                servers.setdefault(endpoint.process, endpoint)
        if len(servers) > 1:
            clashes.setdefault(tuple(servers), []).append((channel, list(servers.values())))
    for shared in clashes.values():
        yield _finding(shared, view.once(owners))


def _is_called(channel: Channel) -> bool:
    """Whether the clash does harm in this launch: an action's servers hear each goal, a service's matter when somebody calls it."""
    return channel.kind == "action" or any(use.certain for use in channel.uses)


def _is_sure(server: Endpoint) -> bool:
    """Whether a person wrote the name down, or a node was seen with it: what is only read from source may not be reached."""
    evidence = server.declaration.evidence
    return not evidence or any(each["by"] != "static" for each in evidence)


def _are_one_program(servers: list[Endpoint], known: Owners) -> bool:
    """Whether the servers are one program that is started several times in the same way."""
    nodes = [known[id(server)] for server in servers]
    ways = {(each.node.package, each.node.executable, each.node.arguments) for each in nodes}
    remaps = [{source: applied.target for source, applied in each.namer.remappings.items()} for each in nodes]
    return len(ways) == 1 and all(each == remaps[0] for each in remaps)


def _finding(shared: list[Clash], known: Owners) -> Finding:
    channel, servers = next((clash for clash in shared if _is_called(clash[0])), shared[0])
    first, *_, last = servers
    names = ", ".join(sorted(server.node for server in servers)[:4]) + (" …" if len(servers) > 4 else "")
    if channel.kind == "action":
        effect = "each of them takes every goal, and clients hear all of them"
    elif not is_of_ros1(known[id(first)]):
        caller = next((use.node for use in channel.uses if use.certain), "who calls it")
        effect = f"each of them carries out every call, and {caller} takes the answer that comes first"
    else:
        caller = next((use.node for use in channel.uses if use.certain), "who calls it")
        effect = f"{caller} gets the one that registers last, which changes from start to start"
    others = [other.name for other, _ in shared if other is not channel]
    also = []
    if others:
        more = f" and {len(others) - 6} more" if len(others) > 6 else ""
        also.append(f"they share {', '.join(others[:6])}{more}, too")
    notes = [words for words in (how(server, known[id(server)]) for server in (first, last)) if words]
    severity = RULE.severity if _is_called(channel) else Severity.WARNING if channel.uses else Severity.INFO
    if severity is Severity.ERROR and sum(map(_is_sure, servers)) < 2:
        severity = Severity.WARNING
    message = f"the {channel.kind} {channel.name} has {len(servers)} servers: {names}"
    if _are_one_program(servers, known):
        severity = Severity.WARNING if severity is Severity.ERROR else severity
        message = f"the same node {known[id(first)].program} is started {len(servers)} times, and each serves {channel.name}: {names}"
    return RULE.at(
        acting_origin(last, known[id(last)]),
        message,
        severity=severity,
        label="serves it, too",
        related=((node_origin(known[id(first)]).place, f"{first.node} serves it"),),
        notes=(effect, *also, *notes),
        help="remap it for all but one of them, put them into namespaces of their own, or start only one",
        topic=f"{channel.kind} {channel.name}",
        cause=f"{severity.word} {' '.join(sorted(f'{each.node} {known[id(each)].program}' for each in servers))} {channel.name}",
    )
