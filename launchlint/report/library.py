"""Libraries for people and programs: what is known, and what is wrong with a file. All that a library says is hostile text."""

from __future__ import annotations

import json
from collections.abc import Iterable, Iterator, Mapping, Sequence
from typing import Any

from launchlint.graph.qos import qos_text
from launchlint.library.catalogue import Entry, Row
from launchlint.library.format import CATEGORIES, FRAMES, KINDS, LISTS, TABLES
from launchlint.model import ROS1, ROS2
from launchlint.plural import counted
from launchlint.report.escape import line_start, visible

_VERBS = {
    "publishers": "publishes",
    "subscribers": "subscribes",
    "services": "serves",
    "clients": "calls",
    "actions": "acts",
    "params": "reads",
    "frames": "frame",
}
_LOADABLE = {"nodelets": "nodelet", "components": "component"}
_MARKS = {ROS1: "", ROS2: "  ROS 2"}
_EXISTS = {"configured": "once it is configured", "active": "while it is active"}
_WHEN = {"subscriber": "while somebody listens", "message": "after a first message or call"}


def faults(lines: Iterable[str]) -> str:
    """What is wrong with a library, one line for each."""
    return "".join(f"{line_start(line)}\n" for line in lines)


def summary(path: str, library: Mapping[str, Any]) -> str:
    """One line: a library that is in order, and how much it knows."""
    packages = library["packages"].values()
    numbers = {table: sum(len(package.get(table, ())) for package in packages) for table in KINDS}
    return f"{line_start(path)}: ok: {counted(len(packages), 'package')}, {_numbers(numbers)}\n"


def canonical_json(text: str) -> str:
    """A library's canonical text for standard output: ``##[`` would be a command to GitHub's log, and stands in strings only."""
    return text.replace("##[", "##\\u005b")


def listing(rows: Sequence[Row]) -> str:
    """All packages with how many programs of them are known."""
    if not rows:
        return "no package is known\n"
    width = min(40, max(len(row.package) for row in rows))
    counts = [_counts(row) for row in rows]
    lines = [f"{visible(row.package):{width}}  {_numbers(each)}{_MARKS[row.middleware]}\n" for row, each in zip(rows, counts, strict=True)]
    total = {table: sum(each.get(table, 0) for each in counts) for table in KINDS}
    return f"{''.join(lines)}\n{counted(len({row.package for row in rows}), 'package')}, {_numbers(total)}\n"


def listing_json(rows: Sequence[Row]) -> str:
    """The same as JSON."""
    return json.dumps([{"package": row.package, "middleware": row.middleware, **_counts(row)} for row in rows], indent=2) + "\n"


def entries(found: Sequence[Entry], *, verbose: bool = False) -> str:
    """What is known of some programs, with the evidence for it where ``verbose``."""
    return "\n".join("".join(f"{line}\n" for line in _entry(entry, verbose)) for entry in found)


def entries_json(found: Sequence[Entry]) -> str:
    """The same as JSON, in the words of the library format."""
    return json.dumps(
        [
            {
                "package": entry.package,
                "middleware": entry.middleware,
                "kind": KINDS[entry.table],
                "name": entry.name,
                "said": entry.said,
                "interface": entry.interface,
            }
            for entry in found
        ],
        indent=2,
    ) + "\n"  # fmt: skip


def title(package: str, table: str, name: str) -> str:
    """How a program is called in a heading; the class of a nodelet or component names its package itself."""
    return visible(f"{package}/{name}") if table == "executables" else f"{visible(name)} ({_LOADABLE[table]} of {visible(package)})"


def condition_words(condition: Any) -> str:
    """A condition in words, not yet :func:`visible`."""
    if "text" in condition:
        return f"«{condition['text']}»"
    if "not" in condition:
        return f"not ({condition_words(condition['not'])})"
    for kind, word in (("all", " and "), ("any", " or ")):
        if kind in condition:
            parts = [condition_words(each) for each in condition[kind]]
            return parts[0] if len(parts) == 1 else word.join(f"({part})" if " " in part else part for part in parts)
    if "remap" in condition:
        return f"{condition['remap']} is remapped"
    subject = f"argument {condition['arg']}" if "arg" in condition else condition["param" if "param" in condition else "option"]
    default = f" (default {_plain(condition['default'])})" if "default" in condition else ""
    if "set" in condition:
        return f"{subject} is {'' if condition['set'] else 'not '}{'set' if 'param' in condition else 'given'}"
    if "is" in condition:
        return f"{subject} is {_plain(condition['is'])}{default}"
    if "in" in condition:
        return f"{subject} is one of {', '.join(map(_plain, condition['in']))}{default}"
    return f"{subject} is {'true' if 'param' in condition else 'given'}{default}"


def value_words(value: Any) -> str:
    """A JSON value, not yet :func:`visible`: text as it is, all else as JSON."""
    return value if isinstance(value, str) and value else json.dumps(value, ensure_ascii=False)


def _entry(entry: Entry, verbose: bool) -> Iterator[str]:
    said = entry.said
    client = f"  {said['class']}" if "class" in said and entry.table == "executables" else ""
    yield f"{title(entry.package, entry.table, entry.name)}{client}{_MARKS[entry.middleware]}"
    if "like" in said:
        yield f"  the same program as {visible(said['like'])}"
    for problem in said.get("problems", ()):
        yield f"  problem: {visible(': '.join(filter(None, (problem['code'], problem.get('detail', '')))))}"
    interface = entry.interface
    if interface is None:
        yield "  its interface is not known: it could not be run" if said.get("status") == "failed" else "  its interface is not known"
        return
    if interface.get("options"):
        takes = (f"{name} ({counted(number, 'value')})" if number else name for name, number in interface["options"].items())
        yield f"  options: {visible(', '.join(takes))}"
    variants = interface.get("variants", {"default": {}})
    for name in sorted(variants, key=lambda name: (name == "default", name)):
        yield from _variant(name, variants[name], verbose, alone=len(variants) == 1)


def _variant(name: str, variant: Mapping[str, Any], verbose: bool, *, alone: bool) -> Iterator[str]:
    if not alone or name != "default":
        match = f", where {condition_words(variant['match'])}" if "match" in variant and name != "default" else ""
        yield f"  variant {visible(name + match)}"
    for said in _of_node(variant):
        yield f"  {visible(said)}"
    table = [(category, entry) for category in LISTS for entry in variant.get(category, ())]
    kind = {FRAMES: "role"}
    cells = [(_VERBS[category], visible(entry["name"]), visible(entry.get(kind.get(category, "type"), "?"))) for category, entry in table]
    widths = [min(48, max((len(row[column]) for row in cells), default=0)) for column in range(3)]
    for (category, entry), row in zip(table, cells, strict=True):
        plain = "  ".join(f"{cell:{width}}" for cell, width in zip(row, widths, strict=True))
        yield f"  {plain}  {visible(', '.join(notes(category, entry)))}".rstrip()
        for evidence in entry.get("evidence", ()) if verbose else ():
            yield f"      {evidence['by']}  {visible(evidence.get('at', evidence.get('run', '')))}".rstrip()
    for category in CATEGORIES:
        if category in variant.get("open", {}):
            yield f"  {_VERBS[category]} more than is listed: {visible(variant['open'][category])}"
    if not table and not variant.get("open"):
        yield "  no names of its own"


def _of_node(variant: Mapping[str, Any]) -> Iterator[str]:
    """What is said of the node as a whole in ROS 2, not yet :func:`visible`."""
    if "node" in variant:
        yield f"calls itself {variant.get('namespace', '').rstrip('/')}{'/' if 'namespace' in variant else ''}{variant['node']}"
    if variant.get("lifecycle"):
        yield "has a lifecycle: somebody has to configure and activate it"
    if variant.get("undeclared"):
        yield "takes params that it does not declare"


def notes(category: str, entry: Mapping[str, Any]) -> Iterator[str]:
    """What is said of one name of a program beside its type, in words, not yet :func:`visible`."""
    if category == "actions":
        yield entry["role"]
    if entry.get("latched"):
        yield "latched"
    if "qos" in entry:
        yield qos_text(entry["qos"])
    if entry.get("overrides"):
        yield "QoS as params say"
    if "node" in entry:
        yield f"of its node {entry['node']}"
    if entry.get("by_hand"):
        yield "while a person acts"
    if "transport" in entry:
        yield "by image_transport"
    if "parent" in entry:
        yield f"under {entry['parent']}"
    if "urdf" in entry:
        yield f"each link of the URDF in {entry['urdf']}"
    if "upon" in entry:
        yield f"upon a message on {entry['upon']}"
    if "through" in entry:
        yield f"through {entry['through']}"
    if "default" in entry:
        yield f"default {_plain(entry['default'])}"
    if "min" in entry or "max" in entry:
        yield f"{_plain(entry.get('min', '…'))} to {_plain(entry.get('max', '…'))}"
    if "one_of" in entry:
        yield f"one of {', '.join(map(_plain, entry['one_of']))}"
    if entry.get("read_only"):
        yield "read-only"
    if entry.get("declared") is False:
        yield "not declared"
    if entry.get("exists") in _EXISTS:
        yield _EXISTS[entry["exists"]]
    if "each" in entry:
        yield _each_words(entry["each"])
    if entry.get("when", "start") in _WHEN:
        yield _WHEN[entry["when"]]
    if "condition" in entry:
        yield f"where {condition_words(entry['condition'])}"


def _each_words(each: Mapping[str, Any]) -> str:
    default = f" (default {' '.join(each['default']) or 'none'})" if "default" in each else ""
    if "args" in each:
        return f"for each argument from {each['args']} on"
    return (f"for each item of {each['param']}" if "param" in each else f"for each word of {each['words']}") + default


def _plain(value: Any) -> str:
    text = value_words(value)
    return text if len(text) <= 60 else f"{text[:59]}…"


def _counts(row: Row) -> dict[str, int]:
    return dict(zip(TABLES[row.middleware], (row.executables, row.loadable), strict=True))


def _numbers(counts: Mapping[str, int]) -> str:
    """How many programs there are of each kind; nodelet classes are named even where there are none, unless there are components."""
    words = [counted(counts.get("executables", 0), "executable")]
    if counts.get("nodelets") or not counts.get("components"):
        words += [counted(counts.get("nodelets", 0), "nodelet class", "nodelet classes")]
    if counts.get("components"):
        words += [counted(counts["components"], "component")]
    return ", ".join(words)
