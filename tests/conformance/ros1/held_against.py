"""Random launch trees: what the real roslaunch makes of them, held against launchlint's model; differences are made small.

``python -m tests.conformance.ros1.held_against [--count N] [--seed N] [--jobs N] [--python COMMAND]``: each tree is evaluated by
both. Every fifth one that loads is formatted, has all fixes made that are said to change nothing, is flattened, and flattened with its
args kept, and evaluated again: it has to mean the same. ``--python`` is a Python that can import roslaunch. Exit status 1 where anything
differs.
"""

from __future__ import annotations

import argparse
import collections
import functools
import multiprocessing
import os
import sys
import tempfile
from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path
from random import Random
from typing import Any, NamedTuple

from launchlint.export.flatten import flatten
from launchlint.export.written import CannotExport
from launchlint.fix.format.formatting import formatted
from launchlint.fix.format.style import Style
from tests.conformance import fixes
from tests.conformance.ros1.smaller import smaller
from tests.evaluate.comparison import ENVIRONMENT, MAIN, Case, difference, inside, ours, session_in, theirs, write
from tests.evaluate.random_launch import random_case
from tests.export.test_against_roslaunch import without_files

AT_ONCE = 250
"""Trees that one process of the real roslaunch is asked about."""
CUTS_AT_ONCE = 25
"""Smaller trees that it is asked about at once."""
MOST_TRIES = 60
"""How often a difference is tried to be made smaller."""
REWRITTEN = 5
"""One tree in so many is rewritten, too: that takes longer than both evaluations together."""
SIZES = ((4, 7), (1, 12), (7, 4), (3, 20))
"""Most launch files in a tree, and most elements in one, in turn."""


def tree(seed: int) -> Case:
    """The random tree of that number: a third holds mistakes, the sizes take turns."""
    files, elements = SIZES[seed % len(SIZES)]
    return random_case(Random(seed), 0.35, files, elements)


def rewritten(case: Case, directory: Path) -> Iterator[tuple[str, Case]]:
    """The tree after each command that must not change what it means. The tree has been written to ``directory`` and loads."""
    files = {}
    for name, text in case.files.items():
        data = text.encode() if isinstance(text, str) else text
        result = formatted(data, name, Style(60)) if name.endswith(".launch") else None
        files[name] = data if result is None or result.problem is not None or result.refusal else result.data
    yield "format", case._replace(files=files)
    with inside(directory):
        done = fixes.changing_nothing(directory, MAIN, {**ENVIRONMENT, **case.environment})
    if done.files:
        texts = {str(Path(file).relative_to(directory)): after for file, (_, after) in done.files.items()}
        yield "fix", case._replace(files={**case.files, **texts})
    for args_kept in (False, True):
        with inside(directory):
            try:
                session = session_in(directory, case.environment)
                export = flatten(session, str(directory / MAIN), tuple(case.arguments.items()), Style(), args_kept=args_kept)
            except CannotExport:
                continue
        kept = {name: text for name, text in case.files.items() if not name.endswith(".launch")}
        yield f"flatten{' with args' * args_kept}", case._replace(files={MAIN: export.data, **kept}, arguments={})


def compared(name: str, answer: dict[str, Any], directory: Path) -> dict[str, Any]:
    """The parts of an answer that a command has to leave: a flat file comes from one file, and counts anonymous names anew; a fix may write
    the name of an included file in another way, and remove a remap that does nothing.
    """
    if name == "format" or answer["verdict"] != "ok":
        return answer
    return without_files(answer) if name != "fix" else without_spelling(answer, directory)


def without_spelling(answer: Mapping[str, Any], directory: Path) -> dict[str, Any]:
    """The answer with all names of files from the root on, and without the remaps of nodes that do nothing."""

    def placed(file: str) -> str:
        return os.path.normpath(directory / file)

    def started(node: Mapping[str, Any]) -> dict[str, Any]:
        sources = [resolved(source, node) for source, _ in node["remaps"]]
        pairs = zip(node["remaps"], sources, strict=True)
        kept = [pair for pair, source in pairs if source != resolved(pair[1], node) or sources.count(source) > 1]
        return {**node, "remaps": kept, "file": placed(node["file"])}

    return {
        **answer,
        **{kind: [started(node) for node in answer[kind]] for kind in ("nodes", "tests")},
        "files": [placed(file) for file in answer["files"]],
        "includes": [{**include, "file": placed(include["file"])} for include in answer["includes"]],
    }


def resolved(name: str, node: Mapping[str, Any]) -> str:
    """What a name on the command line of a node stands for."""
    if name.startswith("~"):
        name = f"{node['fqn']}/{name[1:]}"
    return "/" + "/".join(filter(None, (name if name.startswith("/") else f"{node['ns']}/{name}").split("/")))


def judged(ros_python: str, cases: Sequence[Case], rewritten_each: int = 1) -> list[tuple[str, str]]:
    """For each tree roslaunch's verdict and the first difference, in words; empty where there is none. One in ``rewritten_each`` is
    rewritten, too.
    """
    with tempfile.TemporaryDirectory() as name:
        placed = []
        for number, case in enumerate(cases):
            directory = Path(name).resolve() / str(number)
            write(case, directory)
            placed.append((case, directory))
        answers = theirs(ros_python, placed)
        found = []
        for number, ((case, directory), real) in enumerate(zip(placed, answers, strict=True)):
            own = ours(case, directory)
            differs = difference(real, own)
            if not differs and own["verdict"] == "ok" and number % rewritten_each == 0:
                differs = changed(case, directory, own)
            found.append((real["verdict"], differs))
    return found


def changed(case: Case, directory: Path, before: dict[str, Any]) -> str:
    """What a command that rewrites the tree changed of its meaning, in words; empty if nothing."""
    for name, other in rewritten(case, directory):
        for file in directory.rglob("*.launch"):
            file.unlink()
        write(other, directory)
        differs = difference(compared(name, dict(before), directory), compared(name, ours(other, directory), directory))
        write(case, directory)
        if differs:
            return f"{name}: {differs}"
    return ""


def kind_of(differs: str) -> str:
    """What a difference is about, without the values: two of one kind have one cause, most likely."""
    return differs.split(": roslaunch ")[0].split("; launchlint:")[0].translate({ord(digit): None for digit in "0123456789"})[:60]


def shrunk(ros_python: str, case: Case, differs: str) -> tuple[Case, str]:
    """A tree with as little as possible in it that still differs in the same way."""
    start = 0
    for _ in range(MOST_TRIES):
        cuts = list(smaller(case))
        cuts = cuts[start:] + cuts[:start]
        for first in range(0, len(cuts), CUTS_AT_ONCE):
            tried = cuts[first : first + CUTS_AT_ONCE]
            found = judged(ros_python, tried)
            hit = next((number for number, (_, each) in enumerate(found) if each and kind_of(each) == kind_of(differs)), None)
            if hit is not None:
                case, differs = tried[hit], found[hit][1]
                start = (start + first + hit) % len(cuts)
                break
        else:
            break
    return case, differs


class Part(NamedTuple):
    """What came of some trees: how many had each verdict, and the numbers of those that differ, with the difference."""

    verdicts: dict[str, int]
    different: list[tuple[int, str]]


def part(ros_python: str, seeds: range) -> Part:
    """Judge the trees of those numbers."""
    found = judged(ros_python, [tree(seed) for seed in seeds], REWRITTEN)
    verdicts = collections.Counter(verdict for verdict, _ in found)
    return Part(dict(verdicts), [(seed, differs) for seed, (_, differs) in zip(seeds, found, strict=True) if differs])


def main() -> int:
    """See the module."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--count", type=int, default=1000)
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--jobs", type=int, default=os.cpu_count() or 1)
    parser.add_argument("--python", default="/usr/bin/python3")
    options = parser.parse_args()
    last = options.seed + options.count
    parts = [range(first, min(first + AT_ONCE, last)) for first in range(options.seed, last, AT_ONCE)]
    verdicts: collections.Counter[str] = collections.Counter()
    kinds: dict[str, tuple[int, str]] = {}
    different = 0
    with multiprocessing.Pool(options.jobs) as pool:
        for done in pool.imap(functools.partial(part, options.python), parts):
            verdicts.update(done.verdicts)
            different += len(done.different)
            for seed, differs in done.different:
                kinds.setdefault(kind_of(differs), (seed, differs))
    print(f"{options.count} trees from {options.seed} on, {dict(verdicts)}; {different} differ, in {len(kinds)} ways", flush=True)
    for seed, differs in kinds.values():
        case, why = shrunk(options.python, tree(seed), differs)
        print(f"\n== {seed}: {why}\nargs {dict(case.arguments)}, environment {dict(case.environment)}")
        for name, text in case.files.items():
            print(f"-- {name}\n{text if isinstance(text, str) else text.decode()}", flush=True)
    return 1 if different else 0


if __name__ == "__main__":
    sys.exit(main())
