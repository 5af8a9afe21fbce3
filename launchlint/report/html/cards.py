"""The landing page: a card for each entry file, sorted by what needs attention."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from launchlint.graph.difference import Difference, difference
from launchlint.graph.topology import EMPTY
from launchlint.named_tuple import NamedTuple
from launchlint.plural import counted
from launchlint.report.graph.drawing import draw
from launchlint.report.html.material import EntryMaterial
from launchlint.report.html.tables import SEVERITIES, entry_title
from launchlint.report.picture.thumbnail import MOST, thumbnail

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any


class Count(NamedTuple):
    """Findings of one severity."""

    severity: str
    words: str


class Card(NamedTuple):
    """One entry file. ``level`` is ``error``, ``warning`` or ``ok``; ``changes`` are words with their looks; ``sight`` the share known."""

    entry: int
    directory: str
    title: str
    address: str
    level: str
    verdict: str
    why: str
    nodes: str
    sight: str
    doubtful: bool
    counts: Sequence[Count]
    changes: Sequence[tuple[str, str]]
    picture: str


class Group(NamedTuple):
    """Cards below one heading; ``folded`` where most people look for something else first, ``changed`` where they are compared."""

    title: str
    cards: Sequence[Card]
    folded: bool
    said: str
    changed: bool = False


def groups(data: Mapping[str, Any], materials: Sequence[EntryMaterial]) -> list[Group]:
    """All cards. ``materials`` are in the order of the data's entries. None where there is one entry file, which is shown at once."""
    entries = data["entries"]
    if len(entries) < 2:
        return []
    included = {path for each in materials for path in each.includes if path != each.path}
    order = sorted(range(len(entries)), key=lambda at: _rank(data, entries[at], at))
    changed = [at for at in order if entries[at]["changes"] or entries[at].get("mark")] if data["base"] is not None else []
    rest = [at for at in order if at not in set(changed)]
    own = [at for at in rest if materials[at].path not in included]
    parts = [at for at in rest if materials[at].path in included]
    if not own:
        own, parts = parts, []

    def cards(those: Sequence[int]) -> list[Card]:
        return [_card(data, entries[at], materials[at], at) for at in those]

    same = bool(changed)
    found = []
    if changed:
        found.append(Group(f"Changed since {data['base']}", cards(changed), False, "", changed=True))
    found.append(Group("Not changed" if same else "Launch files", cards(own), same, _troubles(data, entries, own)))
    found.append(Group("Parts that other launch files include", cards(parts), True, _troubles(data, entries, parts)))
    return [each for each in found if each.cards]


def _rank(data: Mapping[str, Any], entry: Mapping[str, Any], at: int) -> tuple[int, ...]:
    """What is refused first, then by findings, then what cannot be told; else as on the rest of the page."""
    severities = [data["findings"][each]["severity"] for each in entry["findings"]]
    verdict = {"refused": 0, "cannot be told": 2, "loads": 3}[entry["verdict"]] if not entry["withArgs"] else 1
    return (min(verdict, 2), -severities.count("error"), -severities.count("warning"), verdict, at)


def _card(data: Mapping[str, Any], entry: Mapping[str, Any], material: EntryMaterial, at: int) -> Card:
    severities = [data["findings"][each]["severity"] for each in entry["findings"]]
    gone = entry.get("mark") == "removed"
    refused = entry["verdict"] == "refused" or bool(entry["withArgs"])
    level = "error" if refused or "error" in severities else "warning" if entry["verdict"] != "loads" or "warning" in severities else "ok"
    verdict = f"refused by {entry['launcher']}" if entry["verdict"] == "refused" else entry["verdict"]
    if entry["verdict"] == "loads" and entry["withArgs"]:
        verdict = "refused with other args"
    known, nodes = entry["sight"]
    seen = [f"{known} of {nodes} known" if known != nodes else "all known"] if nodes else []
    seen += [] if entry["complete"] else ["not all could be followed"]
    path = data["files"][entry["file"]]
    directory, title = path[: path.rfind("/") + 1], entry_title(data, entry)[path.rfind("/") + 1 :]
    return Card(
        at,
        directory,
        title,
        path,
        "" if gone else level,
        "gone" if gone else verdict,
        entry["why"] or entry["withArgs"],
        counted(nodes or sum(each.get("mark") != "removed" for each in entry["nodes"]), "node"),
        ", ".join(seen),
        known != nodes or not entry["complete"],
        [Count(each, counted(severities.count(each), each)) for each in SEVERITIES if each in severities],
        [("added", "new launch file")] if entry.get("mark") == "added" else entry["changes"],
        _picture(material),
    )


def _picture(material: EntryMaterial) -> str:
    before, after = material.before, material.topology
    if after is None and before is None:
        return ""
    change: Difference | None = None
    if before is not None and after is not None and before != after:
        found = difference(before, after)
        change = None if found.is_empty else found
    return thumbnail(draw(after or before or EMPTY, MOST, change))


def _troubles(data: Mapping[str, Any], entries: Sequence[Mapping[str, Any]], those: Sequence[int]) -> str:
    """What a folded group must not hide."""
    refused = sum(entries[at]["verdict"] == "refused" for at in those)
    wrong = sum(any(data["findings"][each]["severity"] == "error" for each in entries[at]["findings"]) for at in those)
    return ", ".join(filter(None, (f"{refused} refused" if refused else "", f"{wrong} with errors" if wrong else "")))
