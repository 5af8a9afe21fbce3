"""How much of a hand-written library ``launchlint extract`` finds in the sources that were read for it.

``python -m tests.bench.extraction CORPUS [--client rospy] [--only NAME] [--show N] [--probe LIBRARY.json]``. CORPUS holds a directory
``owner+name@commit`` (the first twelve digits) for each source checked out; the bundled library is the ground truth for programs whose
evidence is from there. Two names are equal where their templates at their defaults are. Recall counts all entries of the ground truth
that are in that commit, precision leaves conditional entries out, and so it does with categories that the ground truth leaves open.
``unseen`` counts the names of programs that extraction does not see at all; the last line but one takes them for missed. Programs whose
package is in none of the checkouts that the ground truth cites for it are not measured, and the last line tells their number. With
``--probe`` the ground truth is a library that ``launchlint probe`` wrote of programs of the same packages.
"""

from __future__ import annotations

import argparse
import json
import re
import time
from collections import Counter
from collections.abc import Iterator
from pathlib import Path
from typing import Any

from launchlint.errors import UsageError
from launchlint.extract.package import extract
from launchlint.library.template import default_text

BUNDLED = Path(__file__).resolve().parents[2] / "launchlint" / "library" / "bundled"
CATEGORIES = ("publishers", "subscribers", "services", "clients", "actions", "params")
NO_INTERFACE = ("like", "status")

Key = tuple[str, str, str]


Program = tuple[str, str, str, dict[str, Any]]

STRANGE = "a source that is not there"
_NAME = re.compile(r"<name>\s*([^<\s]+)\s*</name>")


def ground_truth(corpus: Path) -> dict[str, list[Program]]:
    """Source id → (package, kind, program name, program) of what the bundled library says of packages in that checkout."""
    holds: dict[str, set[str]] = {}
    for directory in sorted(corpus.iterdir()):
        manifests = (path.read_text(encoding="utf-8", errors="replace") for path in directory.rglob("package.xml"))
        holds[directory.name] = {name for text in manifests for name in _NAME.findall(text)[:1]}
    found: dict[str, list[Program]] = {}
    for path in sorted(BUNDLED.glob("*.json")):
        for package, known in json.loads(path.read_text(encoding="utf-8")).get("packages", {}).items():
            for kind in ("executables", "nodelets"):
                for name, program in known.get(kind, {}).items():
                    sources = Counter(source for entry in all_entries(program) for source in sources_of(entry))
                    if sources and not any(key in program for key in NO_INTERFACE):
                        cited = [source for source, _ in sources.most_common() if source.replace("/", "+") in holds]
                        home = next((source for source in cited if package in holds[source.replace("/", "+")]), STRANGE)
                        if cited:
                            found.setdefault(home, []).append((package, kind, name, program))
    return found


def all_entries(program: dict[str, Any]) -> Iterator[dict[str, Any]]:
    for variant in program.get("variants", {}).values():
        for category in CATEGORIES:
            yield from variant.get(category, ())


def sources_of(entry: dict[str, Any]) -> Iterator[str]:
    for evidence in entry.get("evidence", ()):
        if evidence["by"] == "manual" and "@" in evidence.get("at", ""):  # what was extracted is no measure of extraction
            yield evidence["at"].split(":")[0]


def keyed(program: dict[str, Any]) -> dict[Key, dict[str, Any]]:
    """(category, name, role) → entry, over all variants."""
    found: dict[Key, dict[str, Any]] = {}
    for variant in program.get("variants", {}).values():
        for category in CATEGORIES:
            for entry in variant.get(category, ()):
                key = (category, default_text(entry["name"]), entry.get("role", ""))
                if key not in found or "condition" not in entry:
                    found[key] = entry
    return found


def is_older(entry: dict[str, Any]) -> bool:
    """An entry for releases other than the one that was read."""
    return "before " in json.dumps(entry.get("condition", "")) or "until " in json.dumps(entry.get("condition", ""))


def opened(program: dict[str, Any]) -> set[str]:
    return {category for variant in program.get("variants", {}).values() for category in variant.get("open", ())}


class Score:
    """Counts of one comparison."""

    def __init__(self) -> None:
        self.counts: Counter[str] = Counter()

    def miss(self, truth: dict[str, Any]) -> None:
        """A program that was not seen at all."""
        self.counts["names unseen"] += sum(key[0] != "params" and not is_older(entry) for key, entry in keyed(truth).items())

    def compare(self, label: str, truth: dict[str, Any], found: dict[str, Any], show: list[str]) -> None:
        wanted, got = keyed(truth), keyed(found)
        open_truth, open_found = opened(truth), opened(found)
        for key, entry in wanted.items():
            if key not in got and is_older(entry):
                continue
            part = "params" if key[0] == "params" else "names"
            self.counts[part] += 1
            if key in got:
                self.counts[f"{part} found"] += 1
                if key[0] != "params" and entry.get("type") and got[key].get("type"):
                    self.counts["types"] += 1
                    if entry["type"] == got[key]["type"]:
                        self.counts["types right"] += 1
                    else:
                        show.append(f"  type    {label} {key} {entry['type']} != {got[key]['type']} {at(got[key])}")
            else:
                self.counts[f"{part} open"] += key[0] in open_found
                said = " (open)" if key[0] in open_found else ""
                show.append(f"  missing {label} {key}{said} {at(entry)} {json.dumps(entry.get('condition', ''))}")
        for key, entry in got.items():
            part = "params" if key[0] == "params" else "names"
            if "condition" in entry or (key[0] in open_truth and key not in wanted) or "{any}" in key[1]:
                continue
            self.counts[f"{part} said"] += 1
            if key not in wanted:
                self.counts[f"{part} false"] += 1
                show.append(f"  false   {label} {key} {entry.get('type', '')} {at(entry)}")

    def row(self) -> str:
        c = self.counts
        return (
            f"{percent(c['names found'], c['names'])} {c['names found']:4}/{c['names']:<4} {percent(c['names false'], c['names said'])} "
            f"{percent(c['types right'], c['types'])}  {percent(c['params found'], c['params'])} {c['params found']:4}/{c['params']:<4} "
            f"{percent(c['params false'], c['params said'])} {c['names unseen']:6}"
        )


def at(entry: dict[str, Any]) -> str:
    return next((evidence.get("at", "") for evidence in entry.get("evidence", ())), "").partition(":")[2]


def percent(part: int, whole: int) -> str:
    return f"{100 * part / whole:5.1f}" if whole else "    –"


HEAD = f"{'':44} names found     false types  params found     false unseen"


def against_library(corpus: Path, client: str, only: str, show: int, jobs: int) -> None:
    total = Score()
    lines: list[str] = []
    print(HEAD)
    truth = ground_truth(corpus)
    chosen = {
        source: [each for each in listed if not client or each[3].get("class") in client.split(",")] for source, listed in truth.items()
    }
    strangers = chosen.pop(STRANGE, [])
    for source, programs in sorted(chosen.items()):
        directory = corpus / source.replace("/", "+")
        if not programs or only not in source:
            continue
        begin = time.monotonic()
        try:
            packages = extract([str(directory)], (), jobs).document["packages"]
        except UsageError as error:
            print(f"{source:44} {error}")
            continue
        score = Score()
        absent = []
        for package, kind, name, program in programs:
            found = packages.get(package, {}).get(kind, {}).get(name)
            if found is None:
                absent.append(f"{package}/{name}")
            for each in (score, total):
                if found is None:
                    each.miss(program)
                else:
                    each.compare(f"{package}/{name}", program, found, lines if each is total else [])
        print(f"{source:44} {score.row()}  {time.monotonic() - begin:5.1f} s{'  not there: ' + ', '.join(absent) if absent else ''}")
    print(f"{'total':44} {total.row()}")
    c = total.counts
    print(f"{'with what is unseen':44} {percent(c['names found'], c['names'] + c['names unseen'])}")
    print(f"not measured, since their package is not in these checkouts: {len(strangers)} programs")
    print("\n".join(lines[:show]))


def against_probe(corpus: Path, probe: Path, show: int, jobs: int) -> None:
    """Topics and services that nodes had in a run, held against what their sources say, source by source."""
    probed = json.loads(probe.read_text(encoding="utf-8"))["packages"]
    total = Score()
    lines: list[str] = []
    print(HEAD)
    for directory in sorted(corpus.iterdir()):
        manifests = [path.read_text(encoding="utf-8", errors="replace") for path in directory.rglob("package.xml")]
        if not any(f"<name>{name}</name>" in manifest for name in probed for manifest in manifests):
            continue
        score = Score()
        for package, found in extract([str(directory)], (), jobs).document["packages"].items():
            for kind in ("executables", "nodelets"):
                for name, program in found.get(kind, {}).items():
                    ran = probed.get(package, {}).get(kind, {}).get(name, {})
                    if ran.get("status", "ok") == "ok" and any(all_entries(ran)):
                        for each in (score, total):
                            each.compare(f"{package}/{name}", ran, program, lines if each is total else [])
        print(f"{directory.name:44} {score.row()}")
    print(f"{'total':44} {total.row()}")
    print("\n".join(lines[:show]))


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("corpus", type=Path)
    parser.add_argument("--client", default="", help="rospy, roscpp, nodelet; several with commas; default: all")
    parser.add_argument("--only", default="", help="sources whose id has this in it")
    parser.add_argument("--show", type=int, default=0, help="differences to print")
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("--probe", type=Path)
    given = parser.parse_args()
    if given.probe is not None:
        against_probe(given.corpus, given.probe, given.show, given.jobs)
    else:
        against_library(given.corpus, given.client, given.only, given.show, given.jobs)


if __name__ == "__main__":
    main()
