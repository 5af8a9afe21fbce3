"""The rows of the page's tables, made from its data: they are there without JavaScript, too."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from html import escape

from launchlint.graph.doubts import MayBe
from launchlint.named_tuple import NamedTuple
from launchlint.report.graph.words import doubted
from launchlint.report.html.links import source_link

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

MOST_NAMES = 8
"""Names of nodes in one cell."""
MOST_ROWS = 3_000
"""Rows of all entry files in one table: entry files whose rows do not fit any more have none, but for the first. Scripts show all."""
SEVERITIES = ("error", "warning", "info")


class Link(NamedTuple):
    """A place as shown, and its address; empty where there is none."""

    text: str
    address: str

    def __html__(self) -> str:
        """What templates write for it."""
        text = escape(self.text)
        return f'<a href="{escape(self.address)}">{text}</a>' if self.address else text


class Row(NamedTuple):
    """One row: the number of what it shows in the data, and its cells: text, numbers or a :class:`Link`."""

    number: int
    cells: tuple[Any, ...]
    mark: str = ""


class Body(NamedTuple):
    """The rows of one entry file."""

    entry: int
    title: str
    rows: list[Row]


class Table(NamedTuple):
    """One table. ``empty`` is said where it has no rows, ``more`` counts rows that are not on the page."""

    id: str
    caption: str
    columns: tuple[str, ...]
    bodies: list[Body]
    empty: str
    more: int

    @property
    def rows(self) -> int:
        """How many rows it has."""
        return sum(len(body.rows) for body in self.bodies)


def tables(data: Mapping[str, Any]) -> list[Table]:
    """All tables but that of the findings, which belong to no single entry file."""
    parties = [_parties(entry) for entry in data["entries"]]
    channels = {kind: (lambda entry, number, kind=kind: _channels(entry, kind, parties[number])) for kind in ("topic", "service", "action")}
    return [
        _table(
            data, "nodes", "Nodes", ("Node", "Program", "Known", "Place", "Findings"), "No node is started.",
            lambda entry, _: _nodes(data, entry),
        ),
        _table(data, "topics", "Topics", ("Topic", "Type", "Publishers", "Subscribers"), "No topic is known.", channels["topic"]),
        _table(data, "services", "Services", ("Service", "Type", "Servers", "Clients"), "No service is known.", channels["service"]),
        _table(data, "actions", "Actions", ("Action", "Type", "Servers", "Clients"), "No action is known.", channels["action"]),
        _table(
            data, "params", "Params", ("Param", "Value", "Place", "Overrides", "Read by"), "No param is set.",
            lambda entry, _: _params(data, entry),
        ),
    ]  # fmt: skip


def findings(data: Mapping[str, Any]) -> list[Row]:
    """The rows of the findings."""
    return [
        Row(index, (each["severity"], each["rule"], each["name"], each["message"], place(data, each["place"]), each["help"]))
        for index, each in enumerate(data["findings"])
    ]


def place(data: Mapping[str, Any], at: Sequence[int] | None) -> Link:
    """``file:line`` and its address."""
    if at is None:
        return Link("", "")
    path = data["files"][at[0]]
    there = "" if at[0] in data["baseFiles"] else source_link(data["sourceUrl"] or "", path, at[1])
    return Link(f"{path}:{at[1]}", there)


def entry_title(data: Mapping[str, Any], entry: Mapping[str, Any]) -> str:
    """The launch file, with the args it is started with."""
    return f"{data['files'][entry['file']]} {entry['configurations'][0]}".rstrip()


def _table(data: Mapping[str, Any], id_: str, caption: str, columns: tuple[str, ...], empty: str, rows: Any) -> Table:
    bodies: list[Body] = []
    total = more = 0
    for number, entry in enumerate(data["entries"]):
        found = list(rows(entry, number))
        if bodies and total + len(found) > MOST_ROWS:
            more += len(found)
            continue
        total += len(found)
        bodies.append(Body(number, entry_title(data, entry), found))
    return Table(id_, caption, columns, bodies, empty, more)


def _nodes(data: Mapping[str, Any], entry: Mapping[str, Any]) -> Iterator[Row]:
    for index, node in enumerate(entry["nodes"]):
        cells = (
            node["name"],
            node["program"],
            "unknown" if node["knowledge"] == "unknown" else "known",
            place(data, node["place"]),
            len(node["findings"]) or "",
        )
        yield Row(index, cells, node.get("mark", ""))


def _channels(entry: Mapping[str, Any], kind: str, parties: Mapping[int, tuple[list[str], list[str]]]) -> Iterator[Row]:
    for index, channel in enumerate(entry["channels"]):
        if channel["kind"] == kind and not channel["plumbing"]:
            offers, uses = parties.get(index, ([], []))
            sides = [_some(names) or _nobody(channel, offers=side) for side, names in ((True, offers), (False, uses))]
            yield Row(index, (channel["name"], ", ".join(channel["types"]), *sides), channel.get("mark", ""))


def _nobody(channel: Mapping[str, Any], *, offers: bool) -> str:
    """What is said of an empty end: that nobody is there, with the doubt that there is; nothing of what everybody uses or has gone."""
    if channel.get("mark") == "removed":
        return ""
    who = doubted(MayBe(*each[1:]) for each in channel["may"] if each[0] == offers)
    return f"nobody here, but {who} may" if who else "" if channel["hub"] else "nobody"


def _parties(entry: Mapping[str, Any]) -> Mapping[int, tuple[list[str], list[str]]]:
    """Index of a channel → names of the nodes that publish or serve, and of those that subscribe or call."""
    found: dict[int, tuple[dict[str, None], dict[str, None]]] = {}
    for each in entry["connections"]:
        if each.get("mark") != "removed":
            sides = found.setdefault(each["channel"], ({}, {}))
            sides[not each["offers"]][entry["nodes"][each["node"]]["name"]] = None
    return {channel: (list(offers), list(uses)) for channel, (offers, uses) in found.items()}


def _params(data: Mapping[str, Any], entry: Mapping[str, Any]) -> Iterator[Row]:
    for index, param in enumerate(entry["params"]):
        readers = _some(dict.fromkeys(entry["nodes"][number]["name"] for number in param["readers"]))
        earlier = "; ".join(f"{value} at {place(data, at).text}" for value, at in param["overrides"])
        yield Row(index, (param["name"], param["value"], place(data, param["place"]), earlier, readers), param.get("mark", ""))


def _some(names: Iterable[str]) -> str:
    """The first names, and how many more there are."""
    listed = sorted(names)
    more = len(listed) - MOST_NAMES
    return ", ".join(listed[:MOST_NAMES]) + (f" and {more} more" if more > 0 else "")
