"""What does a launch file of ROS 2 cost, against the same one of ROS 1?

``python -m tests.bench.ros2 [--runs N]`` writes the same workspaces in both dialects: an entry file with switches, which hands every arg on
to an include, which hands them on. Both are checked one after the other, so that what the machine does besides falls on both. All files of
ROS 2 share one set of args, so that a change of one arg may reach any of them; what it does not reach is taken over.

``python -m tests.bench.ros2 --corpus DIRECTORY`` checks all repositories in the directory in one run, and each alone: milliseconds of
processor for each launch file. What the sources of the repositories' own nodes take is told apart (``--no-extract``): that grows with the
sources and not with the launch files, and has a bench of its own (:mod:`tests.bench.extraction_speed`).
"""

from __future__ import annotations

import argparse
import sys
import tempfile
from pathlib import Path
from statistics import median

from tests.bench.configurations import SHAPES, processor, write
from tests.bench.timing import milliseconds, table

LIMIT = 0.015
"""Seconds of processor for each launch file of a corpus, as it is with ROS 1, without the sources of nodes."""
MOST = 3.0
"""How much longer than the same file of ROS 1 one may take."""


def write_ros2(directory: Path, level: int, depth: int, switches: int, handed_on: int) -> None:
    """As :func:`tests.bench.configurations.write`, in the words of ROS 2."""
    names = [f"use_{number}" for number in range(switches)] + [f"arg_{number}" for number in range(handed_on)]
    lines = [f'  <arg name="{name}" default="{"false" if name.startswith("use") else name}"/>' for name in names]
    lines.extend(
        f'  <node name="n{level}_{number}" pkg="demo_nodes" exec="worker" if="$(var use_{number})" namespace="$(var arg_0)"/>'
        for number in range(switches)
    )
    if level < depth:
        lines.append(f'  <include file="$(dirname)/f{level + 1}.launch.xml">')
        lines.extend(f'    <arg name="{name}" value="$(var {name})"/>' for name in names)
        lines.append("  </include>")
    text = "<launch>\n" + "\n".join(lines) + "\n</launch>\n"
    (directory / f"f{level}.launch.xml").write_text(text, encoding="utf-8")


def shape(depth: int, switches: int, handed_on: int, runs: int) -> tuple[float, float]:
    """Median seconds of processor for the entry file in ROS 1 and in ROS 2."""
    with tempfile.TemporaryDirectory() as one, tempfile.TemporaryDirectory() as two:
        for level in range(depth + 1):
            write(Path(one), level, depth, switches, handed_on)
            write_ros2(Path(two), level, depth, switches, handed_on)
        pairs = [(processor(str(Path(one, "f0.launch"))), processor(str(Path(two, "f0.launch.xml")))) for _ in range(runs)]
    return median(first for first, _ in pairs), median(second for _, second in pairs)


def shapes(runs: int) -> int:
    """Print what the written workspaces cost; return how many take too long against ROS 1."""
    rows, above = [], 0
    for depth, switches, handed_on in SHAPES:
        first, second = shape(depth, switches, handed_on, runs)
        above += second > MOST * first
        rows.append([str(depth), str(switches), str(handed_on), milliseconds(first), milliseconds(second), f"{second / first:.2f}"])
    print(f"medians of {runs} runs, in processor time, with the start\n")
    print(table(["includes deep", "switches", "args handed on", "ms ROS 1", "ms ROS 2", "ROS 2 / ROS 1"], rows))
    return above


def corpus(directory: Path, shown: int) -> int:
    """Print what the launch files of a directory cost; return 1 where that is too much."""
    costs = []
    for repository in sorted(path for path in directory.iterdir() if path.is_dir()):
        files = _count(repository)
        if files:
            costs.append((processor(str(repository)) / files, files, repository.name))
    costs.sort(reverse=True)
    print(
        table(["repository", "launch files", "ms a file"], [[name, str(files), milliseconds(cost)] for cost, files, name in costs[:shown]])
    )
    files = max(_count(directory), 1)
    whole, read = processor(str(directory)) / files, processor("--no-extract", str(directory)) / files
    print(f"\nall {files} in one run: {milliseconds(whole)} ms a launch file, {milliseconds(read)} ms without reading sources of nodes")
    return int(read > LIMIT)


def _count(directory: Path) -> int:
    """The launch files below a directory, in any language."""
    ends = (".launch", ".launch.xml", "launch.yaml", "launch.yml", "launch.py", "_launch.xml")
    return sum(path.name.endswith(ends) for path in directory.rglob("*"))


def main() -> int:
    """Measure, print, and return the exit status: 1 where something takes too long."""
    parser = argparse.ArgumentParser(description="Time launchlint check over launch files of ROS 2.")
    parser.add_argument("--runs", type=int, default=3, help="runs of each written workspace (default: 3)")
    parser.add_argument("--corpus", type=Path, help="a directory of repositories to measure instead")
    parser.add_argument("--shown", type=int, default=10, help="repositories to print (default: 10)")
    arguments = parser.parse_args()
    if arguments.corpus is not None:
        return corpus(arguments.corpus, arguments.shown)
    return min(shapes(arguments.runs), 1)


if __name__ == "__main__":
    sys.exit(main())
