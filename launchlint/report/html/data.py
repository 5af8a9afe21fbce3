"""``ReportData`` of ``js/data.d.ts``: all that the page shows, as plain JSON values, the same for the same input."""

from __future__ import annotations

from launchlint.finding import Finding, Location
from launchlint.report.html.entry import entry_data, mend
from launchlint.report.html.material import EntryMaterial, Material
from launchlint.report.html.places import AROUND, Place, Places
from launchlint.report.html.plain import Plain
from launchlint.report.html.programs import md5s, program_data
from launchlint.report.text import command

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

MOST_STEPS = 20
"""Includes on the way to a finding that are shown."""


def report_data(material: Material) -> dict[str, Any]:
    """The data of the page."""
    plain = Plain(material.roots)
    places = Places(plain, material.source, material.base_source)
    findings = [finding for finding, _ in material.findings]
    new = frozenset(index for index, (_, mark) in enumerate(material.findings) if mark in material.new)
    entries = [entry_data(each, findings, new, material.learn, plain, places, compared=bool(material.base)) for each in in_order(material)]
    told = [
        {**_finding(each, mark, plain, places), **_since("new" if at in new else "")} for at, (each, mark) in enumerate(material.findings)
    ]
    fixed = [{**_finding(each, mark, plain, places, base=True), **_since("fixed")} for each, mark in material.fixed]
    return {
        "format": 1,
        "title": plain.text(material.title),
        "version": material.version,
        "sourceUrl": material.source_url or None,
        "base": plain.text(material.base) if material.base else None,
        "files": places.files(),
        "baseFiles": places.base_files(),
        "lines": places.lines(),
        "md5s": md5s(material.programs),
        "findings": told,
        "fixed": fixed,
        "entries": entries,
        "library": [program_data(each, plain) for each in material.programs],
        "libraryLeftOut": material.left_out,
        "notices": [plain.text(each) for each in material.notices],
        "sight": [material.sight.known, material.sight.nodes],
        "mend": mend(material.learn, plain.text(material.probe), plain),
    }


def in_order(material: Material) -> list[EntryMaterial]:
    """What changed since the revision first, then what nobody includes, then the larger ones, then those with more findings."""
    included = {path for entry in material.entries for path in entry.includes if path != entry.path}

    def rank(entry: EntryMaterial) -> tuple[object, ...]:
        topology = entry.topology or entry.before
        nodes, configuration = (0, "") if topology is None else (len(topology.nodes), topology.configurations[0])
        both = entry.topology is not None and entry.before is not None
        change = 0 if not material.base else 0 if both and entry.topology != entry.before else 1 if not both else 2
        return (change, entry.topology is None, entry.path in included, -nodes, -len(entry.findings), entry.path, configuration)

    return sorted(material.entries, key=rank)


def _since(word: str) -> dict[str, str]:
    return {"since": word} if word else {}


def _finding(finding: Finding, fingerprint: str, plain: Plain, places: Places, *, base: bool = False) -> dict[str, Any]:
    at = finding.location
    return {
        "id": fingerprint[:16],
        "rule": finding.rule,
        "name": finding.name,
        "severity": finding.severity.word,
        "message": plain.text(finding.message),
        "label": plain.text(finding.label),
        "place": places.at(at.path, at.line, at.column, last_line=at.end_line, around=AROUND, base=base),
        "endLine": at.end_line,
        "endColumn": at.end_column,
        "help": plain.text(finding.help),
        "notes": [plain.text(note) for note in finding.notes],
        "related": [[_place(related.location, places, base=base), plain.text(related.label)] for related in finding.related],
        "chain": [_place(step, places, base=base) for step in finding.chain[-MOST_STEPS:]],
        "show": plain.text(command(finding)),
        "fix": "" if finding.fix is None else plain.text(finding.fix.message),
        "fixSafe": finding.fix is not None and finding.fix.safe,
    }


def _place(location: Location, places: Places, *, base: bool) -> Place:
    return places.at(location.path, location.line, location.column, base=base)
