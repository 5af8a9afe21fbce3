"""What is new on a page that is written over a former one, or that compares with a revision: for it nothing else moves.

A node or connection that the former page did not have gets a number, ``late``: the turn in which it came. The page lays out what has
none as if the rest were not there, and puts the rest where there is room. Where more than a part is new, all of it is laid out afresh.
"""

from __future__ import annotations

import json
from collections.abc import Collection, Mapping, Sequence

from launchlint.report.html.pack import DIGITS

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    Turns = dict[tuple[str, ...], int]

LARGEST = 64_000_000
"""Characters of a former page that is read."""
MOST_ROWS = 100_000
"""Nodes or connections of an entry file that are read from it."""
PART = 4
"""One in so many may be new."""
DATA = '<script type="application/json" id="launchlint-data">'


def mark_late(data: Mapping[str, Any], former: str) -> None:
    """Write into the page's ``data`` what came late, in comparison with the text of a ``former`` page; empty: there is none.

    What cannot be read as a page of launchlint is none.
    """
    if data["base"] is not None:
        for entry in data["entries"]:
            _mark(entry, {key: 0 for key, item in _keyed(entry) if item.get("mark") != "added"})
        return
    known = _turns(former, {data["files"][entry["file"]] for entry in data["entries"]})
    for entry in data["entries"]:
        before = known.get(data["files"][entry["file"]])
        if before is not None:
            _mark(entry, before)


def _mark(entry: Mapping[str, Any], before: Turns) -> None:
    turn = 1 + max(before.values(), default=0)
    found = [(item, before.get(key, turn)) for key, item in _keyed(entry)]
    nodes = sum(bool(late) for _, late in found[: len(entry["nodes"])])
    lines = sum(bool(late) for _, late in found)
    if nodes * PART <= len(entry["nodes"]) and lines * PART <= len(found):
        for item, late in found:
            if late:
                item["late"] = late


def _keyed(entry: Mapping[str, Any]) -> list[tuple[tuple[str, ...], dict[str, Any]]]:
    """The nodes, then the connections of an entry file, each with what tells it from others whatever else is there."""
    nodes, channels = entry["nodes"], entry["channels"]
    names: list[tuple[tuple[str, ...], dict[str, Any]]] = [((each["name"],), each) for each in nodes]
    for each in entry["connections"]:
        channel = channels[each["channel"]]
        names.append(((nodes[each["node"]]["name"], each["role"], channel["kind"], channel["name"]), each))
    return names


def _turns(former: str, shown: Collection[str]) -> dict[str, Turns]:
    """Of each launch file on a page that is ``shown`` on the new one, too, the turns of its nodes and connections."""
    start = former.find(DATA) + len(DATA)
    end = former.find("</script>", start)
    if len(former) > LARGEST or start < len(DATA) or end < 0:
        return {}
    try:
        head, *lines = former[start:end].split("\n")
        page = json.loads(head)
        files = [_list(page["files"])[file] for file in _cells(page["entries"], "file")]
        return {file: _entry(json.loads(line)) for file, line in zip(files, lines, strict=False) if file in shown}
    except (ValueError, KeyError, IndexError, TypeError, AttributeError, RecursionError):
        return {}


def _entry(parts: Mapping[str, Any]) -> Turns:
    names, kinds, channels = _cells(parts["nodes"], "name"), _cells(parts["channels"], "kind"), _cells(parts["channels"], "name")
    turns: Turns = {(str(name),): int(late or 0) for name, late in zip(names, _cells(parts["nodes"], "late"), strict=True)}
    connections = parts["connections"]
    columns = [_cells(connections, key) for key in ("node", "channel", "role", "late")]
    for node, channel, role, late in zip(*columns, strict=True):
        turns[str(names[node]), str(role), str(kinds[channel]), str(channels[channel])] = int(late or 0)
    return turns


def _cells(table: Any, key: str) -> Sequence[Any]:
    """One key of all objects of a list, as :mod:`launchlint.report.html.pack` writes it; None where an object lacks it.

    Raises:
        ValueError, KeyError, IndexError, TypeError or AttributeError: where it is something else.
    """
    if isinstance(table, list):
        return [row.get(key) for row in table]
    count, column = table["$rows"], table["columns"].get(key)
    if not 0 <= count <= MOST_ROWS:
        raise ValueError(f"{count} rows")
    if column is None:
        return [None] * count
    if isinstance(column, dict) and "$all" in column:
        return [column["$all"]] * count
    if isinstance(column, list) or "$of" not in column:
        return _list(column)
    distinct = _list(column["$of"])
    at = [DIGITS.find(each) for each in column["$at"]] if isinstance(column["$at"], str) else column["$at"]
    return [None if index < 0 else distinct[index] for index in at]


def _list(value: Any) -> Sequence[Any]:
    if isinstance(value, list):
        return value
    texts: list[str] = []
    before = ""
    for text in value["$front"]:
        before = before[: DIGITS.index(text[0])] + text[1:]
        texts.append(before)
    return texts
