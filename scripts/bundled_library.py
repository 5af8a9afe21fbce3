"""Write the bundled library in canonical form, with its index, or check that it is.

``python scripts/bundled_library.py`` rewrites every file of ``launchlint/library/bundled`` (same content, canonical text) and makes
``index.json``: the package of each nodelet class whose name does not begin with it; the same in ``ros2/``, for components. ``--check``
writes nothing, says what is not as it should be, and exits with status 1 where something is not. A file with a fault is never rewritten:
``launchlint library validate`` names the same faults.
"""

from __future__ import annotations

import argparse
import json
import sys
from pathlib import Path
from typing import Any, NamedTuple

from launchlint.library.inspection import inspect_file
from launchlint.library.shipped import DIRECTORY, INDEX, ROS2_SHELF, SEPARATORS
from launchlint.library.terms import TABLES
from launchlint.library.write import canonical
from launchlint.model import ROS1, ROS2
from launchlint.report.library import faults

_CALLED = {ROS1: "ROS 1", ROS2: "ROS 2"}


class Expected(NamedTuple):
    """File name to content for the whole directory, and what is wrong with the files that are there."""

    texts: dict[str, str]
    complaints: list[str]


def expected_files(directory: Path, middleware: str) -> Expected:
    """What every file of the directory, the shelf of a middleware, should be."""
    texts: dict[str, str] = {}
    complaints: list[str] = []
    owners: dict[str, str] = {}
    for path in sorted(directory.glob("*.json")):
        if path.name == INDEX:
            continue
        document, found = inspect_file(shown(path))
        if not found and list(document["packages"]) != [path.stem]:
            found = [f"{shown(path)}: it must hold the package {path.stem}, and holds {', '.join(document['packages']) or 'none'}"]
        if found:
            complaints += found
            continue
        known = document["packages"][path.stem]
        if known.get("middleware", ROS1) != middleware:
            complaints.append(f"{shown(path)}: packages of {_CALLED[known.get('middleware', ROS1)]} have a directory of their own")
        texts[path.name] = canonical(document)
        for name in known.get(TABLES[middleware][1], ()):
            if name in owners and middleware == ROS1:  # a component is always asked for with its package
                complaints.append(f"{shown(path)}: the nodelet class {name} is in {owners[name]}.json already; only one can be right")
            owners.setdefault(name, path.stem)
    texts[INDEX] = index_text(owners, middleware)
    return Expected(texts, complaints)


def index_text(owners: dict[str, str], middleware: str) -> str:
    """The index: nodelet class or component to package, where its name does not tell."""
    separator = SEPARATORS[middleware]
    index: dict[str, Any] = {name: owners[name] for name in sorted(owners) if name.partition(separator)[0] != owners[name]}
    return json.dumps({TABLES[middleware][1]: index}, indent=1, ensure_ascii=False) + "\n"


def shown(path: Path) -> str:
    """A path as people see it: relative where it lies below the current directory."""
    return str(path.relative_to(Path.cwd()) if path.is_relative_to(Path.cwd()) else path)


def main() -> int:
    """Write or check the files; return the exit status."""
    parser = argparse.ArgumentParser(description="Write the bundled library in canonical form, with its index.")
    parser.add_argument("--check", action="store_true", help="write nothing; exit with status 1 where a file is not what it should be")
    parser.add_argument("--directory", type=Path, default=Path(DIRECTORY), help="where the files are (default: the package's own)")
    arguments = parser.parse_args()
    directory: Path = arguments.directory.resolve()
    shelves = {directory: ROS1, **({directory / ROS2_SHELF: ROS2} if (directory / ROS2_SHELF).is_dir() else {})}
    return max([_shelf(each, middleware, check=arguments.check) for each, middleware in shelves.items()])


def _shelf(directory: Path, middleware: str, *, check: bool) -> int:
    """Write or check the files of a directory; the exit status."""
    expected = expected_files(directory, middleware)
    present = {path.name: path.read_text(encoding="utf-8") for path in directory.glob("*.json")}
    changed = [name for name, text in sorted(expected.texts.items()) if present.get(name) != text]
    complaints = expected.complaints
    if check:
        complaints = [*complaints, *(f"{shown(directory / name)} is not in canonical form" for name in changed)]
    sys.stdout.write(faults(complaints))
    if check:
        if complaints:
            print("run: python scripts/bundled_library.py")
            return 1
        print(f"{shown(directory)}: {len(present) - 1} packages, all in canonical form, and the index")
        return 0
    for name in changed:
        (directory / name).write_text(expected.texts[name], encoding="utf-8")
    print(f"{shown(directory)}: wrote {len(changed)} of {len(expected.texts)} files")
    return int(bool(complaints))


if __name__ == "__main__":
    sys.exit(main())
