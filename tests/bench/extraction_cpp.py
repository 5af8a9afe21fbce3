"""Holds `launchlint extract` for C++ against the library that people wrote by hand from the same sources.

    python tests/bench/extraction_cpp.py CHECKOUTS [--only REPOSITORY] [--differences] [--library DIRECTORY]

CHECKOUTS holds one directory for each source of the library, named as its id with ``+`` for ``/`` (``ros-drivers+usb_cam@addab4a65fdf``):
the repository at that commit. The table says, for each repository: how many names the library has and how many of them were found under the
same category and kind (templates compared at their defaults), how many names without a condition were found that the library does not have,
and how many types are the same where both say one. Names that nobody can know before a run (``{any}``, ``each``) are left out.
"""

from __future__ import annotations

import argparse
import json
import os
import re
import sys
import time
from collections import Counter, defaultdict
from collections.abc import Iterator
from pathlib import Path
from typing import Any, NamedTuple

from launchlint.extract.cpp import cpp_program
from launchlint.extract.fact import Fact
from launchlint.library.template import TemplateError, default_text
from launchlint.workspace.cmake import Command
from launchlint.workspace.cmake_facts import CMAKE_FILE, _Reader

_CATEGORIES = ("publishers", "subscribers", "services", "clients", "actions", "params")
_ENDS = (".cpp", ".cc", ".cxx", ".c++", ".cu")
_OF_TRANSPORTS = ("/compressed/mode", "~compressed/mode", "theora/post_processing_level")
"""Params that plugins of image_transport read, where they are installed."""
_BUNDLED = Path(__file__).resolve().parents[2] / "launchlint/library/bundled"


class Targets(_Reader):
    """Which sources each target of a package is made of."""

    __slots__ = ("directories", "links", "sources")

    def __init__(self, directory: str) -> None:
        files = [os.path.relpath(os.path.join(at, name), directory) for at, _, names in os.walk(directory) for name in names]
        super().__init__(directory, lambda: files)
        self.sources: dict[str, list[str]] = {}
        self.links: dict[str, list[str]] = defaultdict(list)
        self.directories: list[str] = []
        self.read(os.path.join(directory, CMAKE_FILE), 0)

    def _command(self, command: Command, depth: int) -> None:
        words = [each for each in self.scope.expand(command.arguments) if each]
        words = [part for each in words for part in each.split(";")]
        if re.fullmatch(r"(\w+_)?add_(executable|library|nodelet)|target_sources", command.name) and words:
            self.sources.setdefault(words[0], []).extend(self.scope.path(each) for each in words[1:] if each.endswith(_ENDS))
        elif command.name in ("target_link_libraries", "rosbuild_link_boost") and words:
            self.links[words[0]] += words[1:]
        elif command.name == "include_directories":
            self.directories += [self.scope.path(each) for each in words if not each.startswith(("/usr", "$"))]
        super()._command(command, depth)

    def of(self, target: str) -> list[str]:
        """The sources of a target and of those of the package that it links."""
        target = next((target for target, name in self.renamed.items() if name == target), target) if target not in self.sources else target
        found: dict[str, None] = {}
        pending, seen = [target], set()
        while pending:
            each = pending.pop(0)
            if each in seen:
                continue
            seen.add(each)
            found.update(dict.fromkeys(self.sources.get(each, [])))
            pending += self.links.get(each, [])
        return [each for each in found if os.path.isfile(each)]


class Package:
    """One package of a checkout."""

    def __init__(self, directory: str, name: str, manifest: str) -> None:
        self.directory = directory
        self.name = name
        self.depends = set(re.findall(r"<\w*depend[^>]*>\s*([\w-]+)\s*<", manifest)) | set(
            re.findall(r'<depend package="([\w-]+)"', manifest)
        )
        self.targets = Targets(directory)

    def classes(self) -> dict[str, tuple[str, str]]:
        """Nodelet classes: name to C++ type and library."""
        found: dict[str, tuple[str, str]] = {}
        for at, _, names in os.walk(self.directory):
            for name in names:
                if not name.endswith(".xml") or name in ("package.xml", "manifest.xml"):
                    continue
                text = Path(at, name).read_text("utf-8", "replace")
                text = re.sub(r"<!--.*?-->", "", text, flags=re.S)
                library = ""
                for tag in re.finditer(r"<library\s[^>]*path\s*=\s*\"([^\"]*)\"|<class\s([^>]*)>", text):
                    if tag[1] is not None:
                        library = os.path.basename(tag[1]).removeprefix("lib")
                    else:
                        given = dict(re.findall(r'(\w+)\s*=\s*"([^"]*)"', tag[2]))
                        if given.get("type"):
                            found[given.get("name") or given["type"]] = (given["type"], library)
        return found


def packages(root: str) -> dict[str, Package]:
    """The packages of a checkout by name."""
    found: dict[str, Package] = {}
    for at, directories, names in os.walk(root):
        directories.sort()
        for manifest in ("package.xml", "manifest.xml"):
            if manifest in names and CMAKE_FILE in names:
                text = Path(at, manifest).read_text("utf-8", "replace")
                match = re.search(r"<name>\s*([\w-]+)\s*</name>", text)
                name = match[1] if match else os.path.basename(at).partition("@")[0]
                found.setdefault(name, Package(at, name, text))
                break
    return found


class Case(NamedTuple):
    """One program of the library, with what is known of it."""

    package: str
    kind: str
    name: str
    truth: dict[str, list[dict[str, Any]]]


def cases(library: Path) -> Iterator[tuple[str, Case]]:
    """The C++ programs of the library, each with the source its evidence points to."""
    for file in sorted(library.glob("*.json")):
        data = json.loads(file.read_text())
        for package, content in data.get("packages", {}).items():
            for kind in ("executables", "nodelets"):
                for name, program in content.get(kind, {}).items():
                    if program.get("class") not in ("roscpp", "nodelet") or "variants" not in program:
                        continue
                    truth: dict[str, list[dict[str, Any]]] = {each: [] for each in _CATEGORIES}
                    ids: Counter[str] = Counter()
                    for variant in program["variants"].values():
                        for category in _CATEGORIES:
                            truth[category] += variant.get(category, [])
                            for entry in variant.get(category, []):
                                ids.update(each["at"].split(":")[0] for each in entry.get("evidence", []) if "at" in each)
                    for source in ids:
                        yield source, Case(package, kind, name, truth)


def normal(name: str) -> str:
    """A name with its templates at their defaults; what cannot be known as ``{any}``."""
    name = re.sub(r"\{each[^}]*\}", "{any}", name)
    try:
        text = default_text(name)
    except TemplateError:
        return f"not well formed: {name}"
    if name.startswith("{parent:"):
        text = text.lstrip("/")
    return text


class Score:
    """Counts of one repository."""

    def __init__(self) -> None:
        self.counts: Counter[str] = Counter()
        self.by_category: dict[str, Counter[str]] = {each: Counter() for each in _CATEGORIES}
        self.differences: list[str] = []

    def add(self, category: str, what: str) -> None:
        """Count one."""
        self.counts[what] += 1
        self.by_category[category][what] += 1


def compare(case: Case, source: str, facts: tuple[Fact, ...], score: Score, shown: str) -> None:
    """Count what one program has in common with the library, and what not."""
    for category in _CATEGORIES:
        mine: dict[str, list[Fact]] = defaultdict(list)
        for fact in facts:
            if fact.category == category:
                mine[normal(fact.name)].append(fact)
        patterns = [each for each in mine if "{any}" in each]
        known: dict[str, dict[str, Any]] = {}
        for entry in case.truth[category]:
            known.setdefault(normal(entry["name"]), entry)
        wild = [re.compile(re.escape(each).replace(re.escape("{any}"), ".*")) for each in known if "{any}" in each]
        for name, entry in known.items():
            if "{any}" in name or "each" in entry or (category == "params" and name.endswith(_OF_TRANSPORTS)):
                continue
            if not any(each.get("at", "").startswith(source + ":") for each in entry.get("evidence", [])):
                continue
            score.add(category, "known")
            if name in mine:
                score.add(category, "found")
                kinds = {each.value_type if category == "params" else each.type for each in mine[name]} - {""}
                if kinds and entry.get("type") and not (entry["type"] == "*" and category == "params"):
                    score.add(category, "typed")
                    if entry["type"] in kinds:
                        score.add(category, "right type")
                    else:
                        score.differences.append(
                            f"{shown} TYPE {category} {name}: {entry['type']} here {sorted(kinds)} {places(mine[name])}"
                        )
            else:
                part = any(re.fullmatch(re.escape(each).replace(re.escape("{any}"), ".*"), name) for each in patterns)
                if part:
                    score.add(category, "partly")
                at = [each.get("at", "").partition(":")[2] for each in entry.get("evidence", [])]
                score.differences.append(
                    f"{shown} {'PARTLY' if part else 'MISSED'} {category} {entry['name']} {entry.get('type', '')} {at}"
                )
        for name, found in mine.items():
            if "{any}" in name:
                continue
            score.add(category, "extracted")
            if name in known or any(each.fullmatch(name) for each in wild):
                continue
            if all(each.condition for each in found):
                score.add(category, "false conditional")
                score.differences.append(f"{shown} MAYBE {category} {found[0].name} {found[0].type} [{found[0].condition}] {places(found)}")
            else:
                score.add(category, "false")
                score.differences.append(f"{shown} FALSE {category} {found[0].name} {found[0].type} {places(found)}")


def places(facts: list[Fact]) -> list[str]:
    """Where facts were found."""
    return [f"{each.path}:{each.line}" for each in facts]


def sources_of(case: Case, found: dict[str, Package]) -> tuple[list[str], list[str], str | None] | None:
    """Sources, include directories and entry of a program; None where the checkout does not build it."""
    package = found.get(case.package)
    if package is None:
        return None
    entry: str | None = None
    if case.kind == "executables":
        sources = package.targets.of(case.name)
    else:
        classes = package.classes()
        if case.name not in classes:
            return None
        entry, library = classes[case.name]
        sources = package.targets.of(library) or [each for target in package.targets.sources for each in package.targets.of(target)]
    if not sources:
        return None
    directories = [os.path.join(package.directory, "include"), package.directory, *package.targets.directories]
    pending, seen = [package], {package.name}
    while pending:
        for name in sorted(pending.pop(0).depends):
            other = found.get(name)
            if other is not None and name not in seen:
                seen.add(name)
                pending.append(other)
                directories += [os.path.join(other.directory, "include"), *other.targets.directories]
                libraries = [target for target in other.targets.sources if target not in other.targets.facts.executables]
                sources += [each for target in libraries for each in other.targets.of(target)]
    return list(dict.fromkeys(sources)), list(dict.fromkeys(directories)), entry


def table(scores: dict[str, Score]) -> Iterator[str]:
    """The table."""
    yield f"{'':45} {'known':>6} {'found':>6} {'':>6} {'partly':>6} {'extracted':>9} {'false':>6} {'':>6} {'cond.':>6} {'types':>6} {'right':>7} {'s':>6}"
    total = Score()
    for name, score in scores.items():
        yield line(name, score.counts)
        total.counts.update(score.counts)
        for category in _CATEGORIES:
            total.by_category[category].update(score.by_category[category])
    for category in _CATEGORIES:
        yield line(f"all {category}", total.by_category[category])
    yield line("all but params", sum((total.by_category[each] for each in _CATEGORIES if each != "params"), Counter()))
    yield line("all", total.counts)


def line(name: str, counts: Counter[str]) -> str:
    """One line of the table."""

    def share(part: str, whole: str) -> str:
        return f"{100 * counts[part] / counts[whole]:5.1f}%" if counts[whole] else "     -"

    return (
        f"{name:45} {counts['known']:6} {counts['found']:6} {share('found', 'known')} {counts['partly']:6} {counts['extracted']:9} {counts['false']:6} "
        f"{share('false', 'extracted')} {counts['false conditional']:6} {counts['typed']:6} {share('right type', 'typed')} {counts['ms'] / 1000:6.1f}"
    )


def main() -> int:
    """Print the table."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("checkouts", type=Path)
    parser.add_argument("--only", default="", help="repositories whose id contains this")
    parser.add_argument("--program", default="", help="programs whose package/name contains this")
    parser.add_argument("--library", type=Path, default=_BUNDLED)
    parser.add_argument("--differences", action="store_true", help="print each difference")
    options = parser.parse_args()
    by_source: dict[str, list[Case]] = defaultdict(list)
    for source, case in cases(options.library):
        if options.only in source and options.program in f"{case.package}/{case.name}":
            by_source[source].append(case)
    scores: dict[str, Score] = {}
    unbuilt = programs = loading = 0
    for source, listed in sorted(by_source.items()):
        root = options.checkouts / source.replace("/", "+")
        if not root.is_dir():
            continue
        found = packages(str(root))
        score = Score()
        for case in listed:
            built = sources_of(case, found)
            if built is None:
                unbuilt += 1
                continue
            programs += 1
            start = time.monotonic()
            try:
                facts, doubts = cpp_program(built[0], built[1], str(root), built[2])
            except Exception:
                print(f"{source} {case.package}/{case.name}", file=sys.stderr)
                raise
            score.counts["ms"] += int(1000 * (time.monotonic() - start))
            shown = f"{source.partition('@')[0]} {case.package}/{case.name}"
            if any("nodelet::Loader" in each.reason for each in doubts):
                loading += 1
                continue
            compare(case, source, facts, score, shown)
            if options.differences and options.program:
                for fact in facts:
                    print(fact)
                for doubt in doubts:
                    print(doubt)
        if score.counts["known"]:
            scores[source] = score
            if options.differences:
                print("\n".join(score.differences), flush=True)
    print("\n".join(table(scores)))
    print(f"{programs} programs, {loading} of them load nodelets and are left out; {unbuilt} more that these sources do not build")
    return 0


if __name__ == "__main__":
    sys.exit(main())
