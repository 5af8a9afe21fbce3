"""From what a library declares to the names that one node has on the graph."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from functools import lru_cache

from launchlint.graph.connections import CATEGORY, Doubt, Endpoint, Reading
from launchlint.graph.names import Namer, Resolved, absolute, clean, matches
from launchlint.graph.situation import Start
from launchlint.library.condition import holds, things
from launchlint.library.program import Declaration, Program
from launchlint.library.template import UNKNOWN, Undetermined, fill, is_template, parse
from launchlint.named_tuple import NamedTuple

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

_ROLES = {"publishers": "publisher", "subscribers": "subscriber", "services": "server", "clients": "client"}
_ACTION_TOPICS = (
    ("goal", False, "Goal"),
    ("cancel", False, "actionlib_msgs/GoalID"),
    ("status", True, "actionlib_msgs/GoalStatusArray"),
    ("feedback", True, "Feedback"),
    ("result", True, "Result"),
)
"""The topics of an action (actionlib): name, whether the server publishes it, and its type or what is appended to that of the action."""


class Interface(NamedTuple):
    """The names of one program in one situation."""

    endpoints: list[Endpoint]
    readings: list[Reading]
    open: dict[str, str]
    doubts: list[Doubt]
    has_template: bool
    literals: tuple[str, ...] = ()


def instantiate(program: Program, start: Start, namer: Namer, process: str, *, certain: bool) -> Interface:
    """What ``program`` says and hears when it is started so.

    Where it cannot be known which variant it is in, everything in any of them may be there.
    """
    variants = program.variant(start)
    literals = tuple(dict.fromkeys(text for variant in variants for text in variant.literals))
    interface = Interface([], [], {}, [], any(variant.has_template for variant in program.variants), literals)
    for variant in variants:
        for category, reason in variant.open.items():
            interface.open.setdefault(category, reason)
        for declaration in variant.declarations:
            known = holds(declaration.condition, start) if declaration.condition is not None else True
            if known is False:
                continue
            sure = certain and known is True and len(variants) == 1
            its_namer = namer if not declaration.node else namer.of_node(fill(parse(declaration.node), start))
            for name, type_ in _names(declaration, start):
                if its_namer is None:  # which of its nodes has the name is not known: its private names may lie anywhere
                    pattern = name.pattern if isinstance(name, Undetermined) else name
                    known_end = pattern if pattern.startswith("/") else f"*/{pattern.lstrip('~/')}"
                    interface.doubts.append(Doubt(declaration.category, known_end, declaration.name, type_))
                elif isinstance(name, Undetermined):
                    interface.doubts.extend(_doubts(declaration, name.pattern, type_, its_namer))
                elif not (_is_usable(name) or (declaration.category == "params" and namer.is_param(name))):
                    interface.doubts.append(Doubt(declaration.category, "*", declaration.name, type_))
                else:
                    _add(interface, declaration, name, type_, its_namer, start, process, sure)
    if not variants:
        for category in (*CATEGORY.values(), "params"):
            interface.open[category] = "it is started in a way that the library does not know"
    return interface


def _doubts(declaration: Declaration, pattern: str, type_: str, namer: Namer) -> Iterator[Doubt]:
    """What is known of a name that is not: its pattern, what remappings may make of it, and what follows from it (images, actions)."""
    pattern = pattern[1:] if pattern.startswith("~*") else pattern
    known = "*" if pattern.startswith("*") and not pattern.startswith("*/") else absolute(pattern, namer.namespace, namer.private)
    targets = (applied.target for applied in namer.remappings.values() if matches(known, applied.source))
    for each in (known, *targets):
        yield from _around(declaration, each, type_, namer)


def _around(declaration: Declaration, pattern: str, type_: str, namer: Namer) -> Iterator[Doubt]:
    """A name of which only ``pattern`` is known, and those that follow from it, whose types are not known here."""
    yield Doubt(declaration.category, pattern, declaration.name, type_)
    if declaration.category == "actions":
        yield Doubt(declaration.category, f"{pattern}/*", declaration.name)
    for suffix, its_type in namer.image_topics if declaration.transport == "image" else ():
        yield Doubt(declaration.category, f"{pattern}/{suffix}", declaration.name, its_type)


@lru_cache(maxsize=4096)  # the names of one program are asked for with each of its nodes
def _is_usable(name: str) -> bool:
    """Whether a filled-in template is a name at all: what is not is as good as unknown."""
    return name.replace("/", "a").replace("_", "a").replace("~", "a", 1).isalnum() and name.isascii()


def _names(declaration: Declaration, start: Start) -> Iterable[tuple[str | Undetermined, str]]:
    """The names (and types) of a declaration; nothing where a part of it has no value."""
    if declaration.each is None and declaration.name and not (is_template(declaration.name) or is_template(declaration.type)):
        return ((declaration.name, declaration.type),)
    return _filled(declaration, start)


def _filled(declaration: Declaration, start: Start) -> Iterator[tuple[str | Undetermined, str]]:
    if declaration.each is None:
        items: list[Any] = [None]
    else:
        found = things(declaration.each, start)
        items = [UNKNOWN] if isinstance(found, Undetermined) else list(found)
    for item in items:
        name = fill(parse(declaration.name), start, item) if is_template(declaration.name) else declaration.name
        if name is None or name == "":
            continue
        if isinstance(name, str) and name.startswith("~/") and declaration.name.startswith("~{"):
            name = name[1:]  # a private NodeHandle is asked for a name that a param or an argument makes global
        type_ = fill(parse(declaration.type), start, item) if is_template(declaration.type) else declaration.type
        yield name, type_ if isinstance(type_, str) else ""


def _add(
    interface: Interface, declaration: Declaration, name: str, type_: str, namer: Namer, start: Start, process: str, certain: bool
) -> None:
    category = declaration.category
    if category in ("publishers", "subscribers"):
        resolved = namer.topic(name)
    else:
        resolved = namer.action(name) if category == "actions" else namer.param(name) if category == "params" else namer.resolve(name)
    patterns, moved = namer.elsewhere(resolved.unremapped, handles=category != "params")  # nobody remaps the namespace of a param
    for pattern in patterns:
        interface.doubts.extend(_around(declaration, pattern, type_, namer))
    if moved:
        return
    certain = certain and not patterns
    if category == "params":
        interface.readings.append(Reading(namer.node, resolved.name, name, resolved.unremapped, resolved.applied, certain, declaration))
        return

    def endpoint(role: str, at: Resolved, its_type: str, *, sure: bool = True, action: str = "") -> None:
        qos = namer.qos(declaration, at.name, start)
        node = namer.node
        interface.endpoints.append(
            Endpoint(node, role, at.name, name, at.unremapped, at.applied, its_type, certain and sure, process, declaration, action, qos)
        )

    if category == "actions":
        start.looked_up[resolved.unremapped] = name
        serves = declaration.role == "server"
        endpoint(f"action {declaration.role}", resolved, type_)
        for topic, server_publishes, its_type in _ACTION_TOPICS if namer.has_action_topics else ():
            full = its_type if "/" in its_type else f"{type_}{its_type}" if type_ else ""
            role = "publisher" if server_publishes == serves else "subscriber"
            endpoint(role, namer.beneath(resolved, topic), full, action=resolved.name)
    elif declaration.transport == "image":
        start.looked_up[resolved.unremapped] = name
        _image(declaration, resolved, type_, namer, start, endpoint)
    else:
        endpoint(_ROLES[category], resolved, type_)


def _image(declaration: Declaration, base: Resolved, type_: str, namer: Namer, start: Start, endpoint: Any) -> None:
    """The topics of image_transport: the code resolves the base topic and makes the others from that."""
    if declaration.category == "publishers":
        endpoint("publisher", namer.again(base), type_)
        for suffix, its_type in namer.image_topics:
            endpoint("publisher", namer.beneath(base, suffix), its_type, sure=False)
        return
    transport = start.param("~image_transport")
    if transport is None or transport == "raw":
        endpoint("subscriber", namer.again(base), type_)
    elif isinstance(transport, str) and transport:
        its_type = dict(namer.image_topics).get(transport, "")
        endpoint("subscriber", namer.beneath(base, clean(transport)), its_type)
    else:
        endpoint("subscriber", namer.again(base), type_, sure=False)
        for suffix, its_type in namer.image_topics:
            endpoint("subscriber", namer.beneath(base, suffix), its_type, sure=False)
