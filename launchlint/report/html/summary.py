"""What the page says in words: the verdict, the counts, what is drawn at first, and what to do where there is nothing to see."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence

from launchlint.named_tuple import NamedTuple
from launchlint.sight import Sight, reason_beside

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

MOST_GROUPS = 40
"""Namespaces that the text in place of the drawing lists."""


HELPS = {"probe": "the command above", "sources": "its sources", "": ""}
"""What makes a program known → how the table says it."""


class Count(NamedTuple):
    """A number with its word."""

    number: int
    word: str


def _count(number: int, one: str, many: str = "") -> Count:
    return Count(number, one if number == 1 else many or f"{one}s")


def verdict(data: Mapping[str, Any]) -> tuple[str, str]:
    """``error``, ``warning`` or ``ok``, and a sentence."""
    severities = [each["severity"] for each in data["findings"]]
    entries = data["entries"]
    if not entries:
        return "warning", "there is no launch file"
    words = [entry["verdict"] for entry in entries]
    refused, untold = words.count("refused"), words.count("cannot be told")
    elsewhere = sum(entry["withArgs"] != "" for entry in entries)
    level = "error" if refused or elsewhere or "error" in severities else "warning" if untold or "warning" in severities else "ok"
    if len(entries) == 1:
        (entry,) = entries
        said = "loads" if words == ["loads"] else f"{_said(entry)}: {entry['why']}"
        return level, "; ".join(filter(None, (said, entry["withArgs"])))
    others = [f"{refused} refused by {_launchers(entries)}"] if refused else []
    others += [f"{untold} cannot be told"] if untold else []
    others += [f"{elsewhere} of these refused with other args"] if elsewhere else []
    loads = len(entries) - refused - untold
    return level, ", ".join([f"{loads} of {len(entries)} launch files load", *others])


def _said(entry: Mapping[str, Any]) -> str:
    return f"refused by {entry['launcher']}" if entry["verdict"] == "refused" else "cannot be told"


def _launchers(entries: Sequence[Mapping[str, Any]]) -> str:
    return " or ".join(sorted({entry["launcher"] for entry in entries if entry["verdict"] == "refused"}))


def counts(data: Mapping[str, Any]) -> list[Count]:
    """How many launch files, findings of each severity and nodes there are, as ``check`` says it; of one launch file alone its topics."""
    severities = [each["severity"] for each in data["findings"]]
    found = [_count(severities.count(word), word) for word in ("error", "warning", "info") if word in severities]
    known, nodes = data["sight"]
    if len(data["entries"]) > 1:
        found.insert(0, _count(len(data["entries"]), "launch file"))
        found += [Count(nodes, f"{'node' if nodes == 1 else 'nodes'} started"), Count(known, "known")] if nodes else []
    elif data["entries"]:
        first = data["entries"][0]
        present = sum(each.get("mark") != "removed" for each in first["nodes"])
        started = min(first["sight"][1], present) or present
        found.append(_count(started, "node"))
        if present > started:
            found.append(Count(present - started, "more with other args"))
        found.append(_count(sum(each["kind"] == "topic" and not each["plumbing"] for each in first["channels"]), "topic"))
    return found


class Wrong(NamedTuple):
    """Findings of the same words: the first of them by its number, and how many there are."""

    first: Mapping[str, Any]
    times: int


def wrong(data: Mapping[str, Any]) -> list[Wrong]:
    """All findings, those of the same words once, the worst first, and the new ones before those that were there."""
    groups: dict[tuple[str, str, str, str], list[Mapping[str, Any]]] = {}
    for each in data["findings"]:
        groups.setdefault((each["severity"], each.get("since", ""), each["rule"], each["message"]), []).append(each)
    order = ("error", "warning", "info")
    ranked = sorted(groups.items(), key=lambda group: (data["base"] is not None and not group[0][1], order.index(group[0][0])))
    return [Wrong(those[0], len(those)) for _, those in ranked]


def overview(data: Mapping[str, Any]) -> list[tuple[str, int, int]]:
    """The namespaces right below the root of what the first entry file starts: name, nodes, and how many of them are not known."""
    if not data["entries"]:
        return []
    groups: dict[str, tuple[int, int]] = {}
    for node in data["entries"][0]["nodes"]:
        top = "/".join(node["namespace"].split("/")[:2]) or "/"
        nodes, unknown = groups.get(top, (0, 0))
        groups[top] = (nodes + 1, unknown + (node["knowledge"] == "unknown"))
    return [(name, *groups[name]) for name in sorted(groups)][:MOST_GROUPS]


def empty_states(data: Mapping[str, Any]) -> Mapping[str, Any]:
    """What is to be said where something is missing: ``unknown`` programs with the reason, whether nodes, channels or entries lack."""
    unknown: dict[str, tuple[int, str, str]] = {}
    for node in _nodes(data):
        if node["knowledge"] == "unknown":
            count, _, _ = unknown.get(node["program"], (0, "", ""))
            unknown[node["program"]] = (count + 1, reason_beside(node["program"], node["reason"]), HELPS[node["learn"]])
    entries = data["entries"]
    return {
        "entries": not entries,
        "nodes": bool(entries) and not any(entry["nodes"] for entry in entries),
        "open": any(not entry["complete"] and entry["verdict"] != "refused" for entry in entries),
        "sight": Sight(data["sight"][1], data["sight"][0]).brief if data["sight"][1] else "",
        "refused": [entry for entry in entries if entry["verdict"] != "loads"],
        "unknown": [(program, *unknown[program]) for program in sorted(unknown, key=lambda each: (-unknown[each][0], each))],
        "findings": not data["findings"],
    }


def _nodes(data: Mapping[str, Any]) -> Iterator[Mapping[str, Any]]:
    for entry in data["entries"]:
        yield from entry["nodes"]
