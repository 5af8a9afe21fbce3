"""Nodes that only send on what they hear (relays, throttles, muxes): what they publish comes from whoever publishes their input."""

from __future__ import annotations

from collections.abc import Iterator

from launchlint.graph.connections import ConnectionGraph, Endpoint, Instance
from launchlint.library.template import is_template
from launchlint.rules.judging.name_places import Owners

ANY = "*"


def forwarded(endpoint: Endpoint, known: Owners, graph: ConnectionGraph) -> tuple[Endpoint, ...] | None:
    """Who publishes for certain what comes out of the publisher ``endpoint`` in the end; None where it speaks on its own account."""
    if _inputs(endpoint, known[id(endpoint)]) is None:
        return None
    found: list[Endpoint] = []
    seen: set[str] = set()
    waiting = [endpoint]
    while waiting:
        each = waiting.pop()
        inputs = _inputs(each, known[id(each)])
        if inputs is None:
            found.append(each)
            continue
        for name in inputs:
            if name not in seen:
                seen.add(name)
                waiting += reversed(list(_published(name, graph)))
    return tuple({each.node: each for each in found}.values())


def _published(name: str, graph: ConnectionGraph) -> Iterator[Endpoint]:
    channel = graph.channels.get(("topic", name))
    return (each for each in (channel.offers if channel is not None else ()) if each.certain)


def _inputs(endpoint: Endpoint, instance: Instance) -> list[str] | None:
    """The topics of which the publisher sends on the messages; None where it does more than that.

    It does no more where it publishes upon messages of its own type, or where it is all that the node publishes, of the type of all that
    the node hears, and its name is not fixed.
    """
    heard = [each for each in instance.endpoints if each.role == "subscriber" and not each.is_plumbing]
    alike = [each.name for each in heard if each.type and (each.type == endpoint.type or ANY in (each.type, endpoint.type))]
    if not alike:
        return None
    if endpoint.declaration.when == "message":
        return alike
    said = [each for each in instance.endpoints if each.role == "publisher" and not each.is_plumbing]
    only = len(said) == len(heard) == 1 and is_template(endpoint.declaration.name)
    return alike if only and not (instance.may_have_more("publishers") or instance.may_have_more("subscribers")) else None
