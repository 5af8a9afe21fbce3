"""Names that have one side only, as loose ends look at them, and what was found to be at the other end."""

from __future__ import annotations

from collections.abc import Callable, Iterable

from launchlint.graph.connections import OFFERS, Channel, Endpoint
from launchlint.named_tuple import NamedTuple
from launchlint.rules.judging.same_definition import is_known, stands_for
from launchlint.rules.judging.signs import hears_itself

Others = list[tuple[Channel, list[Endpoint]]]
"""Names on the other side, with the ends there."""


class Shown(NamedTuple):
    """The other end that more than the names shows to be meant: its name, the ends there and what shows it.

    ``written``: a remap says both names; ``misspelt``: one in a node of the two. ``sure``: that node has none of the names, or others of
    their kind meet so: be it that one of the two nodes is at both ends.
    """

    channel: Channel
    ends: list[Endpoint]
    sign: str
    written: bool = False
    misspelt: bool = False
    sure: bool = False


def is_one_sided(channel: Channel, *, offers: bool) -> bool:
    """Whether a name is only offered (``offers``) or only used, by all that is known, and is none that everybody has.

    What a node says to itself since a remap makes one name of two is only used.
    """
    lone = not (channel.uses if offers else channel.offers) or (not offers and hears_itself(channel))
    return lone and not channel.is_hub and not channel.is_plumbing


def is_as_said(others: tuple[Channel, list[Endpoint]]) -> bool:
    """Whether the launch file gives none of those ends its name."""
    return not any(each.applied or each.declared != each.declaration.name for each in others[1])


def given_and_taken(ends: list[Endpoint], others: list[Endpoint]) -> tuple[list[Endpoint], list[Endpoint]]:
    """The two sides of names that were meant for each other, who gives first."""
    return (ends, others) if ends[0].role in OFFERS else (others, ends)


def signed(end: Endpoint, others: Iterable[tuple[Channel, list[Endpoint]]], sign: Callable[[Endpoint, Endpoint], str]) -> list[Shown]:
    """Those of ``others`` of which a sign says that ``end`` was meant for them, and what it says."""
    said = [(channel, ends, [text for each in ends if (text := sign(end, each))]) for channel, ends in others]
    return [Shown(channel, ends, texts[0]) for channel, ends, texts in said if texts]


def speak_alike(end: Endpoint, other: Endpoint) -> bool:
    """Whether both have one type, or ``end`` takes any, and they are not the two ways of one line to the outside."""
    return (not is_known(end.type) or stands_for(other.type) == stands_for(end.type)) and not _lead_outside(end, other)


def _lead_outside(end: Endpoint, other: Endpoint) -> bool:
    """Whether one says what comes from outside, ``audio_in``, and the other hears what is to go there, ``audio_out``."""
    giver, taker = (end, other) if end.role in OFFERS else (other, end)
    said, heard = (each.declared.replace("put", "") for each in (giver, taker))
    return said != heard and said.endswith("_in") and heard == f"{said[:-3]}_out"


def types(ends: Iterable[Endpoint]) -> set[str]:
    """The types that some of ``ends`` certainly have."""
    return {stands_for(end.type) for end in ends if end.certain and is_known(end.type)}
