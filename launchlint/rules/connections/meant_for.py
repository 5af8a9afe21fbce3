"""What is said of a loose end and the end it was probably meant for: one wording for publishers, subscribers and clients."""

from __future__ import annotations

from collections.abc import Iterable

from launchlint.finding import Finding, Severity
from launchlint.graph.connections import Instance
from launchlint.graph.names import kind
from launchlint.rules.connections.loose_ends import Missed
from launchlint.rules.connections.misspelt import Repairs
from launchlint.rules.connections.near_names import NAMESPACE, SLIP
from launchlint.rules.connections.places import TALKS, acting_origin, how, node_origin, remap_origin, write_remap
from launchlint.rules.rule import Rule

_ALONE = {
    "publisher": ("nobody subscribes to", "reaches nobody"),
    "subscriber": ("nobody publishes", "hears nobody"),
    "client": ("nobody serves", "finds no server"),
    "action client": ("nobody serves the action", "finds no server"),
}
_PLURAL = {"publisher": "publish", "subscriber": "subscribe to", "server": "serve", "action server": "serve"}
_MOST_NODES = 5


def tell(rule: Rule, missed: Missed, consequence: str, repairs: Repairs) -> Finding:
    """The finding of ``rule`` about a loose end; ``consequence`` says why it matters."""
    end, other = missed.end, missed.other
    nobody, label = _ALONE[end.role]
    at_partner = missed.loose and remap_origin(end) is None and remap_origin(other) is not None
    origin = acting_origin(other, missed.partner) if at_partner else acting_origin(end, missed.instance)
    shown, place = (missed.instance, end) if at_partner else (missed.partner, other)
    related = [(node_origin(shown).place, f"{shown.name} {TALKS[place.role]} {place.name}")]
    related.extend(
        (node_origin(each).place, f"{each.name} is at the other end of {other.name}")
        for each in missed.feeding[:2]
        if len(missed.alike) > 1
    )
    notes = [text for text in (how(end, missed.instance), how(other, missed.partner)) if text]
    if len(missed.alike) > 1:
        notes.append(f"{_listed(missed.alike)} all {_PLURAL[other.role]} {other.name}" + _fed(missed))
    notes.append(consequence)
    return rule.at(
        origin,
        f"{nobody} {end.name}, which {missed.instance.name} {TALKS[end.role]}; {missed.partner.name} {TALKS[other.role]} {other.name}",
        severity=missed.level,
        label=f"{other.name} here" if at_partner else label,
        related=tuple(related),
        notes=tuple(notes),
        help=_help(missed, at_partner=at_partner),
        topic=f"{end.node} {end.role} {end.name}",
        fix=repairs.of(missed),
    )


def _help(missed: Missed, *, at_partner: bool) -> str:
    end, other = missed.end, missed.other
    advice = write_remap(end, missed.instance, other.name)
    if at_partner:
        return f"{advice} as well, or {write_remap(other, missed.partner, end.name)}"
    if not missed.how or missed.level is Severity.INFO:
        return f"if these two belong together, {advice}"
    if missed.how == SLIP:
        return f"did you mean {other.name}? Then {advice}"
    if len(missed.alike) > 1 and other.role == "subscriber":
        return f'{advice}, and give it a <group ns="…"> of its own together with {missed.partner.name}, so that the others do not hear it'
    same = end.declared == other.declared and kind(end.declared) == "relative" and not end.applied and not other.applied
    if missed.how == NAMESPACE and same:
        namespace = missed.partner.namer.namespace.strip("/")
        return f"{advice}, or start it in {f'the namespace {namespace}' if namespace else 'no namespace'} as {missed.partner.name} is"
    return advice


def _fed(missed: Missed) -> str:
    if missed.other.role != "subscriber":
        return ""
    feeding = f", and {_listed(missed.feeding)} publishes to all of them" if len(missed.feeding) == 1 else ""
    return f'{feeding}: each needs a <group ns="…"> of its own with the node that it is to hear'


def _listed(instances: Iterable[Instance]) -> str:
    names = list(dict.fromkeys(each.name for each in instances))
    if len(names) > _MOST_NODES:
        return f"{', '.join(names[:_MOST_NODES])} and {len(names) - _MOST_NODES} more"
    return names[0] if len(names) == 1 else f"{', '.join(names[:-1])} and {names[-1]}"
