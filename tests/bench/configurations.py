"""What does a launch file with many configurations cost, whose args go down through many includes? And what does each file of a repository?

``python -m tests.bench.configurations [--runs N]`` writes vendors' workspaces: an entry file with switches, which hands every arg on to an
include, which hands them on. The search for configurations turns one condition after the other, so that switches add up and do not
multiply: a file costs (switches + 1) times the elements of one evaluation, and both are bounded (48 evaluations, 400,000 elements each).

``python -m tests.bench.configurations --corpus DIRECTORY`` checks every repository in the directory alone and prints those whose launch
files take most, each also as a ratio to the median repository, since machines differ and are busy.
"""

from __future__ import annotations

import argparse
import os
import resource
import sys
import tempfile
from pathlib import Path
from statistics import median

from tests.bench.timing import launchlint, milliseconds, table, timed

LIMIT = 0.040
"""Seconds of processor a launch file of a real repository may take on a machine of 2024."""
SHAPES = ((4, 0, 30), (4, 5, 30), (4, 20, 30), (4, 45, 30), (4, 90, 30), (8, 20, 30), (16, 20, 30), (4, 20, 120))
"""How deep the includes go, switches, and args that are handed on."""
FEWEST = 10
"""Repositories of fewer launch files measure the start of Python."""


def write(directory: Path, level: int, depth: int, switches: int, handed_on: int) -> None:
    """Write the file of one ``level``: ``switches`` conditions on args, and an include of the next level with all args."""
    names = [f"use_{number}" for number in range(switches)] + [f"arg_{number}" for number in range(handed_on)]
    lines = [f'  <arg name="{name}" default="{"false" if name.startswith("use") else name}"/>' for name in names]
    lines.extend(
        f'  <node name="n{level}_{number}" pkg="demo_nodes" type="worker" if="$(arg use_{number})" ns="$(arg arg_0)"/>'
        for number in range(switches)
    )
    if level < depth:
        lines.append(f'  <include file="$(dirname)/f{level + 1}.launch">')
        lines.extend(f'    <arg name="{name}" value="$(arg {name})"/>' for name in names)
        lines.append("  </include>")
    text = "<launch>\n" + "\n".join(lines) + "\n</launch>\n"
    (directory / f"f{level}.launch").write_text(text, encoding="utf-8")


def processor(*arguments: str) -> float:
    """Seconds of processor that one ``launchlint check`` takes."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    run = timed(launchlint("check", "--no-cache", "--jobs", "1", "--exit-zero", "-q", *arguments))
    if run.status:
        raise SystemExit(f"launchlint check ended with status {run.status}")
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return after.ru_utime - before.ru_utime + after.ru_stime - before.ru_stime


def shape(depth: int, switches: int, handed_on: int, runs: int) -> float:
    """Median seconds of processor for the check of the entry file of one workspace."""
    with tempfile.TemporaryDirectory() as directory:
        for level in range(depth + 1):
            write(Path(directory), level, depth, switches, handed_on)
        return median(processor(str(Path(directory, "f0.launch"))) for _ in range(runs))


def shapes(runs: int) -> None:
    """Print what the written workspaces cost."""
    idle = shape(0, 0, 1, runs)
    rows = []
    for depth, switches, handed_on in SHAPES:
        work = max(shape(depth, switches, handed_on, runs) - idle, 0.0)
        evaluations = min(switches + 1, 48)
        elements = (depth + 1) * (2 * (switches + handed_on) + switches)
        each = f"{work * 1e6 / evaluations / elements:,.1f}"
        rows.append([str(depth), str(switches), str(handed_on), str(evaluations), f"{elements:,}", milliseconds(work), each])
    print(f"medians of {runs} runs, in processor time; the start alone takes {milliseconds(idle)} ms\n")
    headings = ["includes deep", "switches", "args handed on", "evaluations", "elements each", "ms without start", "µs per element"]
    print(table(headings, rows))
    print("\nHow to read it: the last column must stay level (small shapes are noise). A file costs at most 48 evaluations of its whole")
    print("tree of includes, whatever the number of switches; an include that is entered as before is not evaluated again.")


def corpus(directory: Path, shown: int) -> int:
    """Print which repositories take most for each launch file; return how many are above the limit."""
    costs = []
    for repository in sorted(path for path in directory.iterdir() if path.is_dir()):
        files = sum(name.endswith((".launch", ".test", ".launch.xml")) for _, _, names in os.walk(repository) for name in names)
        if files >= FEWEST:
            costs.append((processor(str(repository)) / files, files, repository.name))
    if not costs:
        raise SystemExit(f"no repository in {directory} holds {FEWEST} launch files")
    costs.sort(reverse=True)
    middle = median(cost for cost, _, _ in costs)
    rows = [[name, str(files), milliseconds(cost), f"{cost / middle:.1f}"] for cost, files, name in costs[:shown]]
    print(table(["repository", "launch files", "ms a file", "times the median"], rows))
    above = sum(cost > LIMIT for cost, _, _ in costs)
    print(f"\n{len(costs)} repositories; {above} take more than {milliseconds(LIMIT)} ms of processor a launch file")
    return above


def main() -> int:
    """Measure, print, and return the exit status: 1 where a repository is above the limit."""
    parser = argparse.ArgumentParser(description="Time launchlint check over launch files with many configurations.")
    parser.add_argument("--runs", type=int, default=3, help="runs of each written workspace (default: 3)")
    parser.add_argument("--corpus", type=Path, help="a directory of repositories to measure instead")
    parser.add_argument("--shown", type=int, default=15, help="repositories to print (default: 15)")
    arguments = parser.parse_args()
    if arguments.corpus is None:
        shapes(arguments.runs)
        return 0
    return 1 if corpus(arguments.corpus, arguments.shown) else 0


if __name__ == "__main__":
    sys.exit(main())
