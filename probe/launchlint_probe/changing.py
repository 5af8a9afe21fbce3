"""Names that differ from one run of a node to the next: found by running it twice, written with ``{any}`` for what changes."""

import re
from typing import Any, Dict, List, Tuple

Entry = Dict[str, Any]

_SUSPICIOUS = re.compile(r"\d{4,}|(?<![A-Za-z])(?=[a-f_]*\d)[0-9a-f]{6,}")
"""What a random number, a process id, a time or a part of a UUID looks like."""


def is_suspicious(interface: Dict[str, List[Entry]]) -> bool:
    """Whether a name of an interface looks made up on the spot, so that another run would show another one."""
    return any(_SUSPICIOUS.search(entry["name"]) for entries in interface.values() for entry in entries)


def common(one: Dict[str, List[Entry]], other: Dict[str, List[Entry]]) -> Dict[str, List[Entry]]:
    """The interface that two runs of one node show: what both have, and what only its names tell apart, joined."""
    return {category: _joined(entries, other.get(category, [])) for category, entries in one.items()}


def _joined(one: List[Entry], other: List[Entry]) -> List[Entry]:
    there = {_key(entry) for entry in other}
    here = {_key(entry) for entry in one}
    waiting = [entry for entry in other if _key(entry) not in here]
    found: Dict[Tuple[str, str], Entry] = {}
    for entry in one:
        if _key(entry) not in there:
            partner = next(
                (each for each in waiting if _same_but_name(each, entry) and "{any}" in merged_name(entry["name"], each["name"])), None
            )
            if partner is not None:
                waiting.remove(partner)
                entry = dict(entry, name=merged_name(entry["name"], partner["name"]))
        found.setdefault(_key(entry), entry)
    return [found[key] for key in sorted(found)]


def _key(entry: Entry) -> Tuple[str, str]:
    return entry["name"], entry.get("role", "")


def _same_but_name(one: Entry, other: Entry) -> bool:
    return all(one.get(key) == other.get(key) for key in ("type", "role"))


def merged_name(one: str, other: str) -> str:
    """Two names as one, with ``{any}`` for the words in which they differ; where nothing is left of them, the first."""
    left, right = _words(one), _words(other)
    ahead = 0
    while ahead < min(len(left), len(right)) and left[ahead] == right[ahead]:
        ahead += 1
    behind = 0
    while behind < min(len(left), len(right)) - ahead and left[-1 - behind] == right[-1 - behind]:
        behind += 1
    if not ahead and not behind:
        return one
    return "".join(left[:ahead]) + "{any}" + "".join(left[len(left) - behind :])


def _words(name: str) -> List[str]:
    """The parts of a name between ``/`` and ``_``, and those themselves: a random word is replaced whole."""
    return [part for part in re.split(r"([/_~]|\{[^{}]*\})", name) if part]
