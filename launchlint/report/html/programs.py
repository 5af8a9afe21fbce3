"""What is known of programs, as the page's library shows it."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence

from launchlint.library.catalogue import Entry
from launchlint.library.terms import CATEGORIES, evidence_text
from launchlint.report.html.plain import Plain
from launchlint.report.library import notes

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any


def program_data(entry: Entry, plain: Plain) -> dict[str, Any]:
    """The ``Program`` of ``js/data.d.ts``."""
    interface = entry.interface or {}
    variants = interface.get("variants", {})
    open_ = {(category, why) for name in sorted(variants) for category, why in sorted(variants[name].get("open", {}).items())}
    return {
        "package": plain.name(entry.package),
        "name": plain.name(entry.name),
        "kind": "executable" if entry.table == "executables" else "nodelet",
        "status": plain.text(_status(entry)),
        "interface": [row for name in _in_order(variants) for row in _rows(name, variants[name], plain, alone=len(variants) == 1)],
        "open": [[category, plain.text(why)] for category, why in sorted(open_)],
    }


def md5s(programs: Iterable[Entry]) -> list[list[str]]:
    """The types of messages, services and actions whose MD5 a library says, each with it; several where libraries differ."""
    declared = (
        each
        for program in programs
        for variant in (program.interface or {}).get("variants", {}).values()
        for category in CATEGORIES
        for each in variant.get(category, ())
    )
    return [list(pair) for pair in sorted({(each["type"], each["md5"]) for each in declared if each.get("type") and each.get("md5")})]


def _status(entry: Entry) -> str:
    """What is to be said of the program as a whole; empty: nothing."""
    if entry.interface is None:
        return "could not be run: its interface is not known" if entry.said.get("status") == "failed" else "its interface is not known"
    if "like" in entry.said:
        return f"the same program as {entry.said['like']}"
    return "no ROS node: it says and hears nothing" if entry.said.get("class") == "none" else ""


def _in_order(variants: Mapping[str, Any]) -> Sequence[str]:
    return sorted(variants, key=lambda name: (name == "default", name))


def _rows(variant: str, data: Mapping[str, Any], plain: Plain, *, alone: bool) -> Iterator[dict[str, Any]]:
    for category in CATEGORIES:
        for declared in data.get(category, ()):
            words = [*notes(category, declared), *([] if alone and variant == "default" else [f"variant {variant}"])]
            yield {
                "category": category,
                "name": plain.name(declared["name"]),
                "type": plain.name(declared.get("type", "")),
                "detail": plain.text(", ".join(words)),
                "evidence": [plain.text(evidence_text(each)) for each in declared.get("evidence", ())],
            }
