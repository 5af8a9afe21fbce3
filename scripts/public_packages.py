#!/usr/bin/env python3
"""Regenerate launchlint/workspace/public_packages.txt from a checkout of https://github.com/ros/rosdistro.

    scripts/public_packages.py CHECKOUT_OF_ROSDISTRO --commit COMMIT [--output FILE]

Taken are facts only: the names of all packages released into any distribution of ROS 1 or ROS 2 that the index lists (REP 143, REP 153),
and for which distributions. A repository released without a package list is one package of the same name (REP 141).
"""

from __future__ import annotations

import argparse
import re
import sys
from pathlib import Path
from typing import Any

import yaml

SOURCE = "https://github.com/ros/rosdistro"
OUTPUT = Path(__file__).resolve().parent.parent / "launchlint" / "workspace" / "public_packages.txt"
NAME = re.compile(r"[A-Za-z0-9][A-Za-z0-9_-]*")


def load(path: Path) -> Any:
    """The content of a YAML file."""
    with path.open(encoding="utf-8") as file:
        return yaml.load(file, Loader=getattr(yaml, "CSafeLoader", yaml.SafeLoader))


def distributions(checkout: Path) -> dict[str, list[Path]]:
    """Every distribution of the index with its files, those of ROS 1 first, each group by name (which is by age)."""
    index = load(checkout / "index-v4.yaml")["distributions"]
    ordered = sorted(index, key=lambda name: (index[name].get("distribution_type", "ros1"), name))
    return {name: [checkout / each for each in index[name]["distribution"]] for name in ordered}


def packages(path: Path) -> set[str]:
    """Names of the packages that one distribution file releases."""
    names: set[str] = set()
    for repository, entry in load(path)["repositories"].items():
        release = (entry or {}).get("release")
        if release:
            names.update(release.get("packages") or [repository])
    return {name for name in names if NAME.fullmatch(name)}


def main() -> int:
    """Write the list."""
    parser = argparse.ArgumentParser(description=(__doc__ or "").split("\n", 1)[0])
    parser.add_argument("checkout", type=Path, help="work tree of ros/rosdistro")
    parser.add_argument("--commit", required=True, help="the commit that is checked out, for the header")
    parser.add_argument("--output", type=Path, default=OUTPUT)
    options = parser.parse_args()
    where: dict[str, list[str]] = {}
    for distribution, files in distributions(options.checkout).items():
        for name in sorted({name for file in files for name in packages(file)}):
            where.setdefault(name, []).append(distribution)
    lines = [
        "# Public ROS packages: name, tab, the distributions that released it. Sorted by name in byte order.",
        f"# Facts from {SOURCE} at commit {options.commit}, written by scripts/public_packages.py.",
        *(f"{name}\t{' '.join(where[name])}" for name in sorted(where)),
    ]
    options.output.write_text("\n".join(lines) + "\n", encoding="utf-8")
    print(f"{len(where)} packages written to {options.output.name}", file=sys.stderr)
    return 0


if __name__ == "__main__":
    sys.exit(main())
