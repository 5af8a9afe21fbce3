"""Grow the bundled library by what launchlint's own tools find in public source code and in probes.

``scripts/library_sources.yaml`` lists public repositories, each at one commit. ``python scripts/grow_library.py`` fetches each with git
(``--checkouts DIRECTORY`` takes the clones ``DIRECTORY/owner/name`` in place of the network), reads it as ``launchlint extract`` does,
together with those that it is to be read beside, and writes what it finds into ``launchlint/library/bundled``. ``--probed FILE`` adds a
library that ``launchlint probe`` made; ``--no-sources`` does nothing else. What the script wrote earlier is taken out first, so the same
list and the same probes always give the same files. ``--ros2`` does the same for ROS 2: ``scripts/library_sources_ros2.yaml``, and the
directory ``ros2`` beside the files of ROS 1.

Nothing is executed but git. What a person wrote wins: source code adds nothing to a program that somebody has read and described. A probe
adds its evidence to such a program, and the MD5 sums it has seen; the names that the description lacks are printed, for a person to see to.
"""

from __future__ import annotations

import argparse
import json
import re
import subprocess
import sys
import tempfile
from collections.abc import Iterator, Mapping, Sequence
from concurrent.futures import ProcessPoolExecutor
from itertools import repeat
from pathlib import Path
from typing import Any, NamedTuple

from library_repositories import Place, Wanted, read_list, unpack
from library_second_look import open_what_was_missed
from library_shelf import Program, Shelf, entries_of

from launchlint.check.run import default_directory
from launchlint.errors import LaunchlintError
from launchlint.extract.package import extract
from launchlint.library.file import parse, read
from launchlint.library.format import CATEGORIES
from launchlint.library.shipped import DIRECTORY, ROS2_SHELF
from launchlint.library.terms import KINDS, TABLES
from launchlint.model import ROS1, ROS2, DialectName
from launchlint.workspace.packages import Packages
from launchlint.workspace.public_packages import public_names

HERE = Path(__file__).resolve().parent

MORE_PARAMS = "read from source code by a program, which may miss some"
_QUOTED = re.compile(r"(?<=before it runs): .*?(?= \([\w./+-]+:\d+\)|$)")
"""The source text in a reason why names are not known."""
_TESTS = frozenset(("test", "tests"))
_GROUP = "repositories"
"""The directory with the repositories that are read together; evidence begins with its name."""


class Found(NamedTuple):
    """What source code says: package → table → name → program, and where it is from."""

    packages: dict[str, dict[str, dict[str, Program]]]
    sources: list[dict[str, Any]]


def read_sources(group: Sequence[Wanted], place: Place) -> Found:
    """What the source code of the first of some repositories says of programs worth knowing, all of them being read together."""
    wanted = group[0]
    found = Found({}, [{"id": each.id, "url": each.address, "commit": each.commit} for each in group])
    with tempfile.TemporaryDirectory() as directory:
        root = Path(directory) / _GROUP
        unpack(wanted, place, root / wanted.name)
        own = packages_in(root)
        names = sorted(name for name in own if name not in wanted.skip and is_taken(name, wanted))
        if not names:
            return found
        for each in group[1:]:
            unpack(each, place, root / each.name)
            for name, manifest in packages_in(root / each.name).items():
                if name in own:
                    manifest.unlink()  # the repository's own copy of the package is the one that it uses
        context = {"ROS_VERSION": "2"} if wanted.middleware == ROS2 else None
        known = extract([str(root)], names, context=context).document["packages"]
        places = {each.id: root / each.name for each in group}

        def text_of(file: str) -> str:
            source, _, path = file.partition(":")
            return (places[source] / path).read_text(encoding="utf-8", errors="replace")

        for package in names:
            if known.get(package, {}).get("middleware", ROS1) != wanted.middleware:
                continue
            for table in TABLES[wanted.middleware]:
                programs = {
                    name: located(in_own_words(program), group)
                    for name, program in known[package].get(table, {}).items()
                    if not wanted.skip.intersection((name, f"{package}/{name}"))
                    and any(entries_of(program))
                    and not (wanted.middleware == ROS2 and is_of_tests(program))
                }
                for program in programs.values():
                    open_what_was_missed(program, text_of)
                found.packages.setdefault(package, {})[table] = programs
    return found


def is_taken(name: str, wanted: Wanted) -> bool:
    """Whether a package of a repository is worth knowing: it is listed, or its name means the same to everybody."""
    return name in wanted.packages or (not wanted.packages if wanted.middleware == ROS2 else name in public_names())


def is_of_tests(program: Program) -> bool:
    """Whether all that is known of a program stands in files of tests: no launch file of others starts it."""
    places = [evidence["at"].partition(":")[2] for _, entry in entries_of(program) for evidence in entry["evidence"]]
    return all(_TESTS.intersection(place.split("/")[:-1]) for place in places)


def packages_in(directory: Path) -> dict[str, Path]:
    """The packages in a directory and their manifests; metapackages and broken ones are none."""
    packages = Packages([str(directory)], {}, explicit=True).places[0].everything
    return {each.name: Path(each.manifest_path) for each in packages if not each.broken and not each.is_metapackage}


def located(program: Program, group: Sequence[Wanted]) -> Program:
    """A program whose evidence and reasons name places in the repositories, not in the directory that they were read from."""
    for _, entry in entries_of(program):
        for evidence in entry["evidence"]:
            path = evidence["at"].removeprefix(f"{_GROUP}:")
            each = next(each for each in group if path.startswith(f"{each.name}/"))
            evidence["at"] = f"{each.id}:{path.removeprefix(f'{each.name}/')}"
        entry["evidence"].sort(key=lambda evidence: str(evidence["at"]))
    for variant in program["variants"].values():
        for category, why in variant["open"].items():
            for each in group:
                why = why.replace(f"({each.name}/", "(")
            variant["open"][category] = why
    return program


def in_own_words(program: Program) -> Program:
    """A program without what is quoted from its source: the library holds facts, and the evidence says where they are from.

    Its params are open: held against what people have read, some are missing where nothing says so, and silence is better than a
    false alarm.
    """
    for variant in program["variants"].values():
        variant.pop("literals", None)
        variant["open"] = {
            "params": MORE_PARAMS,
            **{name: _QUOTED.sub("", why).partition("; ")[0] for name, why in variant.get("open", {}).items()},
        }
        for category in set(CATEGORIES) & set(variant):
            variant[category] = joined([{**entry, **_undecided_of(entry)} for entry in variant[category]])
        for entry in variant.get("params", ()) if program["class"] == "rospy" else ():
            entry.pop("type", None)  # Python takes what there is: the type of a default does not bind anybody
    return program


def joined(entries: list[dict[str, Any]]) -> list[dict[str, Any]]:
    """Entries of one name under the same condition as one; where they disagree, nothing is said."""
    found: dict[str, dict[str, Any]] = {}
    for entry in entries:
        same = json.dumps([entry.get(key) for key in ("name", "role", "condition", "each")], sort_keys=True)
        known = found.setdefault(same, entry)
        if known is not entry:
            evidence = [*known["evidence"], *(each for each in entry["evidence"] if each not in known["evidence"])]
            found[same] = {**{key: known[key] for key in known if known[key] == entry.get(key)}, "evidence": evidence}
    return list(found.values())


def _undecided_of(entry: Mapping[str, Any]) -> dict[str, Any]:
    return {"condition": undecided(entry["condition"])} if "condition" in entry else {}


def undecided(condition: dict[str, Any]) -> dict[str, Any]:
    """A condition with one phrase for whatever only the source says."""
    if "text" in condition:
        return {"text": "a condition in the source"}
    if "not" in condition:
        inner = undecided(condition["not"])
        return inner if "text" in inner else {"not": inner}
    for key in set(condition) & {"all", "any"}:
        parts = [undecided(each) for each in condition[key]]
        parts = [each for number, each in enumerate(parts) if each not in parts[:number]]
        return parts[0] if len(parts) == 1 else {key: parts}
    return condition


def read_probe(path: Path) -> dict[str, Any]:
    """The packages of a library that a probe made; its evidence names the version that ran."""
    packages: dict[str, Any] = parse(read(str(path)), str(path))["packages"]
    for package, known in packages.items():
        for table in KINDS:
            for program in known.get(table, {}).values():
                program.pop("hash", None)
                for _, entry in entries_of(program):
                    entry["evidence"] = [
                        {**one, "run": f"{one['run']}, {package} {known.get('version', '')}".rstrip()} for one in entry["evidence"]
                    ]
    return packages


def read_all(groups: Sequence[Sequence[Wanted]], place: Place, jobs: int) -> Iterator[Found]:
    """What each group says, in order; several are read at once."""
    if jobs < 2 or len(groups) < 2:
        yield from map(read_sources, groups, repeat(place))
        return
    with ProcessPoolExecutor(jobs) as pool:
        yield from pool.map(read_sources, groups, repeat(place))


def main() -> int:
    """Grow the library; return the exit status."""
    parser = argparse.ArgumentParser(description="Grow the bundled library from public source code and from probes.")
    parser.add_argument("--ros2", action="store_true", help="grow the files of ROS 2")
    parser.add_argument("--list", type=Path, help="the repositories (default: library_sources.yaml, library_sources_ros2.yaml for ROS 2)")
    parser.add_argument("--checkouts", type=Path, help="a directory with owner/name for each repository, in place of the network")
    parser.add_argument("--only", action="append", metavar="OWNER/NAME", help="read this repository anew and leave the others as they are")
    parser.add_argument("--no-sources", action="store_true", help="read no repository; leave what was read earlier as it is")
    parser.add_argument("--probed", type=Path, action="append", metavar="FILE", help="add this library, which launchlint probe made")
    parser.add_argument("--jobs", type=int, default=2, help="processes (default: 2)")
    parser.add_argument("--directory", type=Path, default=Path(DIRECTORY), help="where the files are (default: the package's own)")
    options = parser.parse_args()
    middleware: DialectName = ROS2 if options.ros2 else ROS1
    shelf = Shelf(options.directory / ROS2_SHELF if options.ros2 else options.directory, middleware)
    place = Place(options.checkouts, str(Path(default_directory()) / "probe"))
    if options.probed:
        shelf.take_out("dynamic")
    try:
        if not options.no_sources:
            listed = read_list(options.list or HERE / ("library_sources_ros2.yaml" if options.ros2 else "library_sources.yaml"), middleware)
            only = frozenset(options.only or (each.name for each in listed.values()))
            shelf.take_out("static", only if options.only else None)
            groups = [
                [each, *(listed[other] for other in each.beside)]
                for each in listed.values()
                if only.intersection((each.name, *each.beside))
            ]
            for group, found in zip(groups, read_all(groups, place, options.jobs), strict=True):
                print(f"{group[0].name}: {shelf.add_read(found.packages, found.sources, bool(options.only))} programs", flush=True)
        for path in options.probed or ():
            seen, missing = shelf.add_seen(read_probe(path))
            print(f"{path}: {seen} programs")
            for line in missing:
                print(f"  seen, but not described: {line}")
    except LaunchlintError as error:
        print(f"grow_library: {error}", file=sys.stderr)
        return 2
    print(f"{options.directory}: changed {shelf.write()} files", flush=True)
    return subprocess.run([sys.executable, str(HERE / "bundled_library.py"), "--directory", str(options.directory)], check=False).returncode


if __name__ == "__main__":
    sys.exit(main())
