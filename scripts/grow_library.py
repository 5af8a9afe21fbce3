"""Grow the bundled library by what launchlint's own tools find in public source code and in probes.

``scripts/library_sources.yaml`` lists public repositories, each at one commit. ``python scripts/grow_library.py`` fetches each with git
(``--checkouts DIRECTORY`` takes the clones ``DIRECTORY/owner/name`` in place of the network), reads it as ``launchlint extract`` does, and
writes what it finds into ``launchlint/library/bundled``. ``--probed FILE`` adds a library that ``launchlint probe`` made; ``--no-sources``
does nothing else. What the script wrote earlier is taken out first, so the same list and the same probes always give the same files.

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
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Any, NamedTuple

import yaml
from library_shelf import TABLES, Program, Shelf, entries_of

from launchlint.check.run import default_directory
from launchlint.errors import LaunchlintError, UsageError
from launchlint.extract.package import extract
from launchlint.library.file import parse, read
from launchlint.library.format import CATEGORIES
from launchlint.library.shipped import DIRECTORY
from launchlint.probe.configuration import Repository
from launchlint.probe.sources import Tree, fetch, members
from launchlint.workspace.public_packages import public_names

HERE = Path(__file__).resolve().parent
_TEST = re.compile(r"(?:^|[^a-z])(?:unit|integration|ros|g|py)?_?tests?(?:[^a-z]|$)|mock")
"""Names of programs and packages that are there to test others: no robot starts them."""


MORE_PARAMS = "read from source code by a program, which may miss some"
_QUOTED = re.compile(r"(?<=before it runs): .*?(?= \([\w./+-]+:\d+\)|$)")
"""The source text in a reason why names are not known."""


class Wanted(NamedTuple):
    """A line of the list: a repository and commit, the packages to take besides those of the public index, and what to leave out."""

    name: str
    commit: str
    packages: tuple[str, ...]
    skip: frozenset[str]


class Found(NamedTuple):
    """What source code says: package → table → name → program, and where it is from."""

    packages: dict[str, dict[str, dict[str, Program]]]
    sources: list[dict[str, Any]]


def read_list(path: Path) -> list[Wanted]:
    """The repositories of the list, in its order: of a program that several have, the first one counts."""
    document = yaml.load(path.read_text(encoding="utf-8"), Loader=yaml.BaseLoader)  # a commit may look like a number
    return [
        Wanted(name, entry["commit"], tuple(entry.get("packages", ())), frozenset(entry.get("skip", ())))
        for name, entry in (document or {}).items()
    ]


def unpack(wanted: Wanted, checkouts: Path | None, cache: str, directory: Path) -> None:
    """Write the files of a repository at its commit into ``directory``, which ``launchlint extract`` then takes for a clone of it."""
    address = f"https://github.com/{wanted.name}"
    if checkouts is None:
        files = files_of_tree(fetch(Repository(address, wanted.commit), cache))
    else:
        files = files_of_clone(checkouts / wanted.name, wanted.commit)
    for path, runs, data in files:
        target = directory / path
        target.parent.mkdir(parents=True, exist_ok=True)
        target.write_bytes(data)
        target.chmod(0o755 if runs else 0o644)
    git = directory / ".git"
    git.mkdir()
    (git / "HEAD").write_text(f"{wanted.commit}\n")
    (git / "config").write_text(f'[remote "origin"]\n\turl = {address}\n')


def files_of_tree(tree: Tree) -> Iterator[tuple[str, bool, bytes]]:
    """Path, whether it is a program, and content of the files that were fetched."""
    for member in members(tree):
        if member.source is not None:
            yield member.path, member.runs, member.source.read()


def files_of_clone(clone: Path, commit: str) -> Iterator[tuple[str, bool, bytes]]:
    """The same of a commit in a clone. Files that a partial clone lacks are left out."""
    git = ["git", "-c", "safe.directory=*", "-C", str(clone)]
    listed = subprocess.run([*git, "ls-tree", "-r", "-z", commit], capture_output=True, check=False)
    if listed.returncode:
        raise UsageError(f"{clone}: there is no commit {commit}")
    with subprocess.Popen([*git, "cat-file", "--batch"], stdin=subprocess.PIPE, stdout=subprocess.PIPE) as reading:
        if reading.stdin is None or reading.stdout is None:
            raise AssertionError("pipes were asked for")
        for line in listed.stdout.decode("utf-8", "surrogateescape").split("\0")[:-1]:
            (mode, kind, name), path = line.partition("\t")[0].split(), line.partition("\t")[2]
            if kind != "blob" or mode == "120000":
                continue
            reading.stdin.write(f"{name}\n".encode())
            reading.stdin.flush()
            head = reading.stdout.readline().split()
            if head[-1:] != [b"missing"]:
                data = reading.stdout.read(int(head[2]))
                reading.stdout.readline()
                yield path, mode == "100755", data


def read_sources(wanted: Wanted, checkouts: Path | None, cache: str, jobs: int) -> Found:
    """What the source code of a repository says of programs worth knowing."""
    with tempfile.TemporaryDirectory() as directory:
        unpack(wanted, checkouts, cache, Path(directory))
        document = extract([directory], (), jobs).document
    found = Found({}, document["sources"])
    for package, known in document["packages"].items():
        if _TEST.search(package) or package in wanted.skip or not (package in wanted.packages or package in public_names()):
            continue
        for table in TABLES:
            programs = {
                name: in_own_words(program)
                for name, program in known.get(table, {}).items()
                if not wanted.skip.intersection((name, f"{package}/{name}")) and is_worth_knowing(name, program)
            }
            found.packages.setdefault(package, {})[table] = programs
    return found


def in_own_words(program: Program) -> Program:
    """A program without what is quoted from its source: the library holds facts, and the evidence says where they are from.

    Its params are open: held against what people have read, some are missing where nothing says so, and silence is better than a
    false alarm.
    """
    for variant in program["variants"].values():
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


def is_worth_knowing(name: str, program: Mapping[str, Any]) -> bool:
    """Whether a program that was read from source has any name that is known, and is not a test."""
    places = [evidence["at"].split(":")[1] for _, entry in entries_of(program) for evidence in entry["evidence"]]
    return bool(places) and not _TEST.search(name) and not all({"test", "tests"}.intersection(place.split("/")[:-1]) for place in places)


def read_probe(path: Path) -> dict[str, Any]:
    """The packages of a library that a probe made; its evidence names the version that ran."""
    packages: dict[str, Any] = parse(read(str(path)), str(path))["packages"]
    for package, known in packages.items():
        for table in TABLES:
            for program in known.get(table, {}).values():
                program.pop("hash", None)
                for _, entry in entries_of(program):
                    entry["evidence"] = [
                        {**one, "run": f"{one['run']}, {package} {known.get('version', '')}".rstrip()} for one in entry["evidence"]
                    ]
    return packages


def main() -> int:
    """Grow the library; return the exit status."""
    parser = argparse.ArgumentParser(description="Grow the bundled library from public source code and from probes.")
    parser.add_argument("--list", type=Path, default=HERE / "library_sources.yaml", help="the repositories (default: library_sources.yaml)")
    parser.add_argument("--checkouts", type=Path, help="a directory with owner/name for each repository, in place of the network")
    parser.add_argument("--only", action="append", metavar="OWNER/NAME", help="read this repository anew and leave the others as they are")
    parser.add_argument("--no-sources", action="store_true", help="read no repository; leave what was read earlier as it is")
    parser.add_argument("--probed", type=Path, action="append", metavar="FILE", help="add this library, which launchlint probe made")
    parser.add_argument("--jobs", type=int, default=2, help="processes (default: 2)")
    parser.add_argument("--directory", type=Path, default=Path(DIRECTORY), help="where the files are (default: the package's own)")
    options = parser.parse_args()
    shelf = Shelf(options.directory)
    wanted = [] if options.no_sources else [each for each in read_list(options.list) if not options.only or each.name in options.only]
    if not options.no_sources:
        shelf.take_out("static", frozenset(options.only) if options.only else None)
    if options.probed:
        shelf.take_out("dynamic")
    try:
        for each in wanted:
            found = read_sources(each, options.checkouts, str(Path(default_directory()) / "probe"), options.jobs)
            print(f"{each.name}: {shelf.add_read(found.packages, found.sources)} programs", flush=True)
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
