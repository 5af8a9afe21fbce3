"""The files of the bundled library in memory: what tools found is taken out, put in, and written back; what people wrote stays."""

from __future__ import annotations

from collections.abc import Container, Iterator, Mapping, Sequence
from pathlib import Path
from typing import Any

from launchlint.library.file import parse, read
from launchlint.library.format import FORMAT, LISTS
from launchlint.library.merge import merge_programs
from launchlint.library.shipped import INDEX
from launchlint.library.template import default_text
from launchlint.library.terms import TABLES, VERSION, VERSION_2
from launchlint.library.write import canonical
from launchlint.model import ROS1, DialectName
from launchlint.rules.judging.params_read import UNIVERSAL

Program = dict[str, Any]
Packages = Mapping[str, Mapping[str, Any]]
"""The ``packages`` of a library document."""


class Shelf:
    """The library in a directory, one document for each package."""

    def __init__(self, directory: Path, middleware: DialectName = ROS1) -> None:
        self._directory = directory
        self._middleware = middleware
        self._tables = TABLES[middleware]
        paths = sorted(path for path in directory.glob("*.json") if path.name != INDEX)
        self._documents: dict[str, dict[str, Any]] = {path.stem: parse(read(str(path)), str(path)) for path in paths}
        self._dropped: set[str] = set()
        self._added: set[tuple[str, str, str]] = set()

    def take_out(self, kind: str, repositories: frozenset[str] | None = None) -> None:
        """Remove what evidence of a kind says: all of it, or that of some repositories (``owner/name``)."""
        for document in self._documents.values():
            for package in document["packages"].values():
                for programs in (package.get(table, {}) for table in self._tables):
                    for name, program in list(programs.items()):
                        sources = source_ids(program)
                        if repositories is not None and not {source.partition("@")[0] for source in sources} & repositories:
                            continue
                        left = without(program, kind)
                        if left is None:
                            del programs[name]
                        else:
                            programs[name] = left
                        if left != program:
                            self._dropped |= sources

    def add_read(self, found: Packages, sources: Sequence[Mapping[str, Any]], again: bool = False) -> int:
        """Put in what source code says of programs that nobody has described or read yet; ``again``: or that was read from these sources
        alone. Returns how many those are.
        """
        places = {source["id"].partition("@")[0] for source in sources}
        added = 0
        for package, tables in found.items():
            for table in self._tables:
                known = self._table(package, table)
                new = {
                    name: merge_programs([known[name], program]) if "dynamic" in kinds_of(known.get(name, {})) else program
                    for name, program in tables.get(table, {}).items()
                    if name not in known
                    or kinds_of(known[name]) == {"dynamic"}
                    or (again and (package, table, name) not in self._added and is_read_from(known[name], places))
                }
                self._added.update((package, table, name) for name in new)
                known.update(new)
                added += len(new)
                used = {source for program in new.values() for source in source_ids(program)}
                listed = self._document(package).setdefault("sources", []) if used else []
                there = {source["id"] for source in listed}
                listed.extend(source for source in sources if source["id"] in used - there)
        return added

    def add_seen(self, found: Packages) -> tuple[int, list[str]]:
        """Put in what a probe saw. Returns how many programs it saw, and the names that descriptions of people lack."""
        seen = 0
        missing: list[str] = []
        for package, tables in found.items():
            for table in self._tables:
                for name, program in tables.get(table, {}).items():
                    if "variants" not in program:
                        continue
                    known = self._table(package, table)
                    seen += 1
                    if name not in known:
                        known[name] = program
                    elif "manual" in kinds_of(known[name]):
                        if "variants" in known[name]:
                            missing += [f"{package}: {name}: {entry}" for entry in _confirm(known[name], program)]
                    else:
                        known[name] = merge_programs([program, known[name]])
        return seen, missing

    def write(self) -> int:
        """Write the files that have changed. Returns how many those were."""
        changed = 0
        for package, document in self._documents.items():
            tables = document["packages"][package]
            for table in self._tables:
                if not tables.get(table, True):
                    del tables[table]
            used = {source for table in self._tables for program in tables.get(table, {}).values() for source in source_ids(program)}
            if "sources" in document:
                kept = [source for source in document["sources"] if source["id"] in used or source["id"] not in self._dropped]
                document["sources"] = kept
            path = self._directory / f"{package}.json"
            text = canonical(document) if any(table in tables for table in self._tables) else ""
            if text != (path.read_text(encoding="utf-8") if path.exists() else ""):
                changed += 1
                path.write_text(text, encoding="utf-8") if text else path.unlink()
        return changed

    def _document(self, package: str) -> dict[str, Any]:
        if self._middleware == ROS1:
            return self._documents.setdefault(package, {"format": FORMAT, "version": VERSION, "packages": {package: {}}})
        packages = {package: {"middleware": self._middleware}}
        return self._documents.setdefault(package, {"format": FORMAT, "version": VERSION_2, "packages": packages})

    def _table(self, package: str, table: str) -> dict[str, Program]:
        found: dict[str, Program] = self._document(package)["packages"][package].setdefault(table, {})
        return found


def entries_of(program: Mapping[str, Any]) -> Iterator[tuple[str, dict[str, Any]]]:
    """All interface entries of a program, each with its category."""
    for variant in program.get("variants", {}).values():
        for category in LISTS:
            for entry in variant.get(category, ()):
                yield category, entry


def kinds_of(program: Mapping[str, Any]) -> set[str]:
    """Who says what is known of a program; one without evidence is a person's word."""
    return {evidence["by"] for _, entry in entries_of(program) for evidence in entry.get("evidence", ())} or {"manual"}


def source_ids(program: Mapping[str, Any]) -> set[str]:
    """The sources that the evidence of a program names."""
    places = (evidence.get("at", "") for _, entry in entries_of(program) for evidence in entry.get("evidence", ()))
    return {place.partition(":")[0] for place in places if "@" in place}


def is_read_from(program: Mapping[str, Any], repositories: Container[str]) -> bool:
    """Whether all that is known of a program is from the source code of some repositories (``owner/name``)."""
    return kinds_of(program) == {"static"} and all(source.partition("@")[0] in repositories for source in source_ids(program))


def without(program: Program, kind: str) -> Program | None:
    """A program without what evidence of a kind says; None where nothing else is known of it."""
    kinds = kinds_of(program)
    if kind not in kinds:
        return program
    if kinds == {kind}:
        return None
    variants = {}
    for name, variant in program["variants"].items():
        variants[name] = dict(variant)
        for category in set(LISTS) & set(variant):
            left = [_less(entry, kind) for entry in variant[category]]
            variants[name][category] = [entry for entry in left if entry is not None]
            if not variants[name][category]:
                del variants[name][category]
    return {**program, "variants": variants}


def _less(entry: Mapping[str, Any], kind: str) -> dict[str, Any] | None:
    if "evidence" not in entry:
        return dict(entry)
    left = [evidence for evidence in entry["evidence"] if evidence["by"] != kind]
    return {**entry, "evidence": left} if left else None


def _confirm(described: Program, seen: Program) -> list[str]:
    """Add to a description the evidence, and the MD5 sums, of what a probe saw of it. Returns the names that it lacks, apart
    from those of categories that it leaves open and from params that libraries read in any node.
    """
    known: dict[tuple[str, str, str], list[dict[str, Any]]] = {}
    for category, entry in entries_of(described):
        known.setdefault((category, default_text(entry["name"]), entry.get("role", "")), []).append(entry)
    missing = []
    opened = {category for variant in described["variants"].values() for category in variant.get("open", ())}
    for category, entry in entries_of(seen):
        same = known.get((category, default_text(entry["name"]), entry.get("role", "")), [])
        for each in same[:1] if len(same) == 1 else ():
            if "evidence" in each:
                each["evidence"] = [*each["evidence"], *(one for one in entry["evidence"] if one not in each["evidence"])]
            if "md5" in entry and each.get("type") == entry.get("type"):
                each.setdefault("md5", entry["md5"])
        if not same and category not in opened and not (category == "params" and entry["name"].rpartition("/")[2].lstrip("~") in UNIVERSAL):
            missing.append(f"{category}: {entry['name']} {entry.get('type', '')}".rstrip())
    return missing
