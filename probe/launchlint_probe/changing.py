"""Names that differ from one run of a node to the next: found by running it twice, written with ``{any}`` for what changes."""

import re
import socket
import time
from typing import Any, Dict, List, Tuple

Entry = Dict[str, Any]

SHORTEST_HOST = 4
"""Characters: a shorter name of a machine may be a word of the node's own."""


def common(one: Dict[str, List[Entry]], other: Dict[str, List[Entry]]) -> Tuple[Dict[str, List[Entry]], List[str]]:
    """The interface that two runs of one node show: what either has, and what only its names tell apart, joined. Then the names that one
    run had and the other had nothing like.
    """
    found: Dict[str, List[Entry]] = {}
    alone: List[str] = []
    for category in sorted(set(one) | set(other)):
        found[category], left = _joined(one.get(category, []), other.get(category, []))
        if category not in ("clients", "params"):  # when those show is a matter of time
            alone += left
    return found, alone


def steady(interface: Dict[str, List[Entry]], host: str, day: time.struct_time) -> Dict[str, List[Entry]]:
    """An interface without what two runs on one machine and one day cannot show: the name of the machine and the date."""
    dates = [time.strftime(form, day) for form in ("%Y%m%d", "%Y_%m_%d", "%Y-%m-%d", "%y%m%d")]
    names = [name for name in (host, re.sub(r"\W", "_", host)) if len(name) >= SHORTEST_HOST and name not in ("localhost", "robot")]
    pattern = re.compile("|".join(r"(?<![A-Za-z0-9]){}(?![A-Za-z0-9])".format(re.escape(each)) for each in dict.fromkeys(names + dates)))
    return {
        category: [dict(entry, name=pattern.sub("{any}", entry["name"])) for entry in entries] for category, entries in interface.items()
    }


def today(interface: Dict[str, List[Entry]]) -> Dict[str, List[Entry]]:
    """:func:`steady` for this machine and day."""
    return steady(interface, socket.gethostname(), time.localtime())


def _joined(one: List[Entry], other: List[Entry]) -> Tuple[List[Entry], List[str]]:
    there = {_key(entry) for entry in other}
    here = {_key(entry) for entry in one}
    waiting = [entry for entry in other if _key(entry) not in here]
    found: Dict[Tuple[str, str], Entry] = {}
    alone: List[str] = []
    for entry in one:
        if _key(entry) not in there:
            partner = next(
                (each for each in waiting if _same_but_name(each, entry) and "{any}" in merged_name(entry["name"], each["name"])), None
            )
            if partner is not None:
                waiting.remove(partner)
                entry = dict(entry, name=merged_name(entry["name"], partner["name"]))
            else:
                alone.append(entry["name"])
        found.setdefault(_key(entry), entry)
    patterns = [_pattern(entry["name"]) for entry in found.values() if "{any}" in entry["name"]]
    for entry in waiting:  # how many there are may change, too
        if not any(pattern.fullmatch(entry["name"]) for pattern in patterns):
            alone.append(entry["name"])
            found.setdefault(_key(entry), entry)
    return [found[key] for key in sorted(found)], alone


def _pattern(name: str) -> Any:
    return re.compile("[^/]+".join(re.escape(part) for part in name.split("{any}")))


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
