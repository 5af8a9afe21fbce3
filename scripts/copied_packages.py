#!/usr/bin/env python3
"""Regenerate launchlint/workspace/copied_packages.txt from repositories that are laid out here.

    scripts/copied_packages.py --project DIRECTORY … --seen DIRECTORY … [--output FILE]

Each directory holds one repository per directory, called ``owner+name``. Taken are facts only: the name of each package, and
a mark of the addresses of its maintainers and authors (REP 127, REP 140). Of the public projects (``--project``) all packages are taken, of
the others those that the repositories of two owners or more hold with the same people. What the list has already is kept: not
all of what it was made from is laid out any more.
"""

from __future__ import annotations

import argparse
import re
import sys
from collections.abc import Iterator
from pathlib import Path

from launchlint.workspace.copied_packages import mark
from launchlint.workspace.manifest import read_manifest
from launchlint.workspace.public_packages import PublicPackages

OUTPUT = Path(__file__).resolve().parent.parent / "launchlint" / "workspace" / "copied_packages.txt"
NAME = re.compile(r"[A-Za-z0-9][A-Za-z0-9_.-]*")
NOBODY = re.compile(
    r"(?:root|robot|ros\d?|pi|ubuntu|nvidia|jetson|odroid|me|test)@todo\.todo"
    r"|(?:todo|user|you|your.*|name|someone|somebody)@.*|.*@(?:example|email|mail|domain|xxx)\.\w+"
)
"""Addresses that a template has, or the login of a machine: whose such a package is they do not tell."""
SEVERAL = 2

Key = tuple[str, frozenset[str]]


def packages(directory: Path) -> Iterator[tuple[str, Key]]:
    """The owner of each repository below ``directory``, with the name and the people of each package in it."""
    for path in sorted(directory.glob("*+*/**/package.xml")):
        owner = path.relative_to(directory).parts[0].partition("+")[0].lower()
        try:
            manifest = read_manifest(str(path))
        except (OSError, ValueError):
            continue
        if NAME.fullmatch(manifest.name) and any(not NOBODY.fullmatch(each) for each in manifest.people):
            yield owner, (manifest.name, manifest.people)


def main() -> int:
    """Write the list."""
    parser = argparse.ArgumentParser(description=(__doc__ or "").split("\n", 1)[0])
    parser.add_argument("--project", type=Path, action="append", default=[], help="holds public projects")
    parser.add_argument("--seen", type=Path, action="append", default=[], help="holds repositories of anybody")
    parser.add_argument("--output", type=Path, default=OUTPUT)
    options = parser.parse_args()
    owners: dict[Key, set[str]] = {}
    taken: set[Key] = set()
    for directory in (*options.project, *options.seen):
        for owner, key in packages(directory):
            owners.setdefault(key, set()).add(owner)
            if directory in options.project:
                taken.add(key)
    taken |= {key for key, several in owners.items() if len(several) >= SEVERAL}
    known = PublicPackages(str(options.output)).items() if options.output.exists() else ()
    marks = {name: set(each) for name, each in known}
    for name, people in taken:
        marks.setdefault(name, set()).add(mark(name, people))
    lines = [
        "# Packages that are copied: name, tab, marks of whose they are. Sorted by name in byte order.",
        "# Facts from public repositories, written by scripts/copied_packages.py.",
        *(f"{name}\t{' '.join(sorted(marks[name]))}" for name in sorted(marks)),
    ]
    options.output.write_text("\n".join(lines) + "\n", encoding="utf-8")
    print(f"{sum(map(len, marks.values()))} packages of {len(marks)} names written to {options.output.name}", file=sys.stderr)
    return 0


if __name__ == "__main__":
    sys.exit(main())
