"""What is said of a loose end and the end it was probably meant for: one wording for publishers, subscribers and clients."""

from __future__ import annotations

from collections.abc import Iterable

from launchlint.finding import Finding, Severity
from launchlint.graph.connections import Instance
from launchlint.graph.names import kind
from launchlint.rules.judging.loose_ends import Missed
from launchlint.rules.judging.met import topic_of
from launchlint.rules.judging.misplaced import moved_include
from launchlint.rules.judging.misspelt import Repairs
from launchlint.rules.judging.name_places import TALKS, acting_origin, how, in_namespace, node_origin, remap_origin, with_sources
from launchlint.rules.judging.near_names import NAMESPACE, SLIP
from launchlint.rules.judging.one_cause import Cause, is_node
from launchlint.rules.judging.signs import Standing
from launchlint.rules.judging.stray import STRAY
from launchlint.rules.rule import Rule
from launchlint.source import Origin

_ALONE = {
    "publisher": ("nobody subscribes to", "reaches nobody"),
    "subscriber": ("nobody publishes", "hears nobody"),
    "client": ("nobody serves", "finds no server"),
    "action client": ("nobody serves the action", "finds no server"),
}
_PLURAL = {"publisher": "publish", "subscriber": "subscribe to", "server": "serve", "action server": "serve"}
_MOST_NODES = 5


def tell(rule: Rule, cause: Cause, consequence: str, repairs: Repairs) -> Finding:
    """The finding of ``rule`` about the loose ends of one cause; ``consequence`` says why they matter."""
    missed, others = cause.first, cause.others
    end, other = missed.end, missed.other
    label = "hears itself alone" if missed.heard else _ALONE[end.role][1]
    at_partner = _is_at_partner(missed)
    origin = _origin(missed)
    shown, place = (missed.instance, end) if at_partner else (missed.partner, other)
    related = [(node_origin(shown).place, f"{shown.name} {TALKS[place.role]} {place.name}")]
    related.extend(
        (node_origin(each).place, f"{each.name} is at the other end of {other.name}")
        for each in missed.feeding[:2]
        if len(missed.alike) > 1
    )
    related.extend((_origin(each).place, _what(each)) for each in others)
    if isinstance(missed.sign, Standing):
        related.append((missed.sign.place, STRAY))
    notes = [text for text in (how(end, missed.instance), how(other, missed.partner)) if text]
    if len(missed.alike) > 1:
        notes.append(f"{_listed(missed.alike)} all {_PLURAL[other.role]} {other.name}" + _fed(missed))
    if missed.sign:
        notes.append(missed.sign)
    idle = next((each for each in (missed.instance, missed.partner) if each.kind == "nodelet" and not each.host), None)
    notes.append(consequence if idle is None else f"no message arrives, and the manager of the nodelet {idle.name} is not started here")
    if missed.doubts:
        notes.append(f"unless another node is at the other end: {missed.doubts[0].reason}")
    more = f" (and {len(others)} more name{'s' if len(others) > 1 else ''} for the same reason)" if others else ""
    found = rule.at(
        origin,
        f"{_what(missed)}{more}",
        severity=missed.level,
        label=f"{other.name} here" if at_partner else label,
        related=tuple(related),
        notes=tuple(notes),
        help=_help_for_all(cause) if cause.hub is not None else _help(missed, repairs, at_partner=at_partner),
        topic=topic_of(end) if cause.hub is None else " ".join((_program_of(cause.hub[0], missed), *map("/".join, cause.hub[1]))),
        fix=None if others else repairs.of(missed),
        cause=_cause_of_all(cause),
        about=(end.name if missed.how == SLIP else end.declared, other.declared, other.name, missed.how),
    )
    return with_sources(found, end, other)


def _cause_of_all(cause: Cause) -> str:
    """What is the same in all launch files that start the programs of the two ends alike, whatever they call the nodes."""
    if cause.hub is None:
        return "" if cause.others else _cause(cause.first)
    said = sorted(f"{each.instance.program} {each.end.declared} {each.partner.program}" for each in (cause.first, *cause.others))
    return " ".join((_program_of(cause.hub[0], cause.first), *map("/".join, cause.hub[1]), *said))


def _cause(missed: Missed) -> str:
    """What is the same for all nodes of a ``<node>`` that several includes start: its place, and what it says and hears."""
    place, program, partner = missed.instance.node.origin.place, missed.instance.program, missed.partner.program
    return " ".join((place.source.path, str(place.span.start), program, missed.end.declared, partner, missed.other.declared))


def _program_of(node: str, missed: Missed) -> str:
    """The program of one of the two nodes: in launch files that are alike it may have another name."""
    return next((each.program for each in (missed.instance, missed.partner) if each.name == node), node)


def _is_at_partner(missed: Missed) -> bool:
    """Whether the remap that parts the two ends is that of the other one."""
    return missed.loose and remap_origin(missed.end) is None and remap_origin(missed.other) is not None


def _origin(missed: Missed) -> Origin:
    """Where the name is made that parts the two ends."""
    return acting_origin(missed.other, missed.partner) if _is_at_partner(missed) else acting_origin(missed.end, missed.instance)


def _what(missed: Missed) -> str:
    end, other = missed.end, missed.other
    nobody = _ALONE[end.role][0].replace("nobody", "nobody else", 1) if missed.heard else _ALONE[end.role][0]
    alone = f"{nobody} {end.name}, which {missed.instance.name} {TALKS[end.role]}"
    return f"{alone}; {missed.partner.name} {TALKS[other.role]} {other.name}"


def _help_for_all(cause: Cause) -> str:
    """What joins all the ends that have the ``hub`` of the cause in common."""
    assert cause.hub is not None
    node, (mine, theirs) = cause.hub
    wrong, right = ("/".join(each) or "no namespace" for each in (mine, theirs))
    doubt = "if these belong together, " if cause.first.level is Severity.INFO else ""
    if not is_node(node):
        where = f"{in_namespace(cause.first.instance, right)}" if theirs and not mine else "another namespace"
        return f"{doubt}put the include at {node} into {where}: what it starts is in {wrong} where the others have {right}"
    if len(theirs) == 1 and mine == (node.rpartition("/")[2],) and all(_is_private(each, node) for each in (cause.first, *cause.others)):
        return f'call {node} {theirs[0]}, below which its names are looked for: name="{theirs[0]}"'
    around = moved_include(cause.first, node)
    if around is not None:
        return doubt + around
    return f"{doubt}start {node} in another namespace, or remap its names: they are in {wrong} where the others have {right}"


def _is_private(missed: Missed, node: str) -> bool:
    """Whether the end of ``node`` has a private name, which no remap acts on."""
    end = missed.end if missed.instance.name == node else missed.other
    return kind(end.declared) == "private" and not end.applied


def _help(missed: Missed, repairs: Repairs, *, at_partner: bool) -> str:
    end, other = missed.end, missed.other
    around = moved_include(missed)
    advice = repairs.written(end, missed.instance, other.name) if around is None else around
    if at_partner and around is None:
        return f"{advice} as well, or {repairs.written(other, missed.partner, end.name)}"
    if (not missed.how and not missed.sign) or missed.level is Severity.INFO:
        return f"if these two belong together, {advice}"
    if around is not None:
        return advice
    if missed.how == SLIP:
        return f"did you mean {other.name}? Then {advice}"
    if len(missed.alike) > 1 and other.role == "subscriber":
        group = in_namespace(missed.instance, "…")
        return f"{advice}, and give it a {group} of its own together with {missed.partner.name}, so that the others do not hear it"
    same = end.declared == other.declared and kind(end.declared) == "relative" and not end.applied and not other.applied
    if missed.how == NAMESPACE and same:
        namespace = missed.partner.namer.namespace.strip("/")
        return f"{advice}, or start it in {f'the namespace {namespace}' if namespace else 'no namespace'} as {missed.partner.name} is"
    return advice


def _fed(missed: Missed) -> str:
    if missed.other.role != "subscriber":
        return ""
    feeding = f", and {_listed(missed.feeding)} publishes to all of them" if len(missed.feeding) == 1 else ""
    return f"{feeding}: each needs a {in_namespace(missed.instance, '…')} of its own with the node that it is to hear"


def _listed(instances: Iterable[Instance]) -> str:
    names = list(dict.fromkeys(each.name for each in instances))
    if len(names) > _MOST_NODES:
        return f"{', '.join(names[:_MOST_NODES])} and {len(names) - _MOST_NODES} more"
    return names[0] if len(names) == 1 else f"{', '.join(names[:-1])} and {names[-1]}"
