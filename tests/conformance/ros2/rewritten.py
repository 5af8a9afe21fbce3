"""Random workspaces, rewritten by each command that must not change what they mean, and launched again.

``python -m tests.conformance.ros2.rewritten [--count N] [--seed N]``: each workspace that loads is formatted, converted to the other
language, and flattened; and mistakes are made in it, the safe fixes of which have to bring back what was meant. What is launched then has
to be what was launched before, by launchlint's evaluator and, where :mod:`.front_end` finds them, by the real front ends. The workspace's
own args are given both times; what the commands prove by themselves is of other args. Exit status 1 where anything differs.
"""

from __future__ import annotations

import argparse
import collections
import json
import re
import sys
import tempfile
from collections.abc import Iterator, Mapping, Sequence
from functools import partial
from pathlib import Path
from random import Random
from typing import Any, NamedTuple

from launchlint.evaluate.session import Session
from launchlint.export.ros2.converting import ENDS, XML, YAML, convert
from launchlint.export.ros2.flattening import flatten
from launchlint.export.written import CannotExport
from launchlint.fix.format.formatting import formatted
from launchlint.fix.format.style import Style
from launchlint.workspace.packages import Packages
from tests.conformance import fixes
from tests.conformance.ros2.elements import read
from tests.conformance.ros2.front_end import Answer, FrontEnd, Question, front_end
from tests.conformance.ros2.held_against import launched
from tests.conformance.ros2.mutant_audit import KINDS, mutants
from tests.conformance.ros2.random_workspace import Workspace, random_workspace
from tests.evaluate import comparison

DISTRO = "jazzy"
VARIABLES = {"HOME": "/home/user", "USER": "user", "ROS_DISTRO": DISTRO}
STARTED = ("verdict", "nodes", "executables", "deferred_errors")
"""What a flat file has to leave: it comes from one file, and declares no args."""
KEPT = (*STARTED, "args", "declared", "includes")
LOSING_NOTHING = frozenset(
    "substitution_misspelt bracket_lost bracket_twice blank_after_bracket blank_before_bracket two_blanks tab_in_substitution "
    "blank_before_substitution braces dollar_lost variable_misspelt package_misspelt executable_misspelt plugin_misspelt target_misspelt "
    "included_file_misspelt included_file_in_wrong_folder package_in_path_misspelt passed_arg_misspelt include_called_value "
    "condition_without_dollar file_misspelt attribute_upper tag_misspelt attribute_misspelt exec_called_type tag_of_ros1 "
    "root_misspelt blank_after_colon_lost".split()
)
"""Mistakes that leave what was meant: a safe fix of one has to bring it back."""
MISTAKES = [each for each in KINDS if each.name in LOSING_NOTHING]
COPIES = "abcdefghijklm"
"""First letters of directories: names of one length, which an expression may count."""
AT_A_TIME = 6
"""Kinds of mistakes that are made in each workspace, one after the other."""
BY_LAUNCH = ", by ros2 launch"
AT_ONCE = 100
"""Workspaces that one process of the real front end is asked about."""
NARROW = Style(60)


class Rewritten(NamedTuple):
    """``files``: what each file, by its path in the directory, holds now; ``entry``: the one to be launched; ``given``: with these args."""

    command: str
    files: Mapping[str, bytes]
    entry: str
    given: Mapping[str, str]


def session_in(directory: Path, variables: Mapping[str, str]) -> Session:
    """A session that sees the packages in ``directory`` and nothing of this machine."""
    return Session(Packages([str(directory)], variables, explicit=True), variables, str(directory), distro=DISTRO)


def repaired(directory: Path, workspace: Workspace, seed: int, variables: Mapping[str, str]) -> Iterator[Rewritten]:
    """The workspace after the safe fixes of a mistake in its entry file, where a mistake has such a fix."""
    random = Random(seed)
    file, entry = directory / workspace.entry, workspace.entry
    before = file.read_bytes()
    document = read(before.decode("utf-8"), entry)
    for each in random.sample(MISTAKES, AT_A_TIME):
        mutant = next(mutants(document, each, random), None)
        if mutant is None:
            continue
        file.write_bytes(mutant.text.encode("utf-8"))
        done = fixes.safe(directory, entry, variables, DISTRO)
        file.write_bytes(before)
        if done.made:
            texts = {str(Path(name).relative_to(directory)): after for name, (_, after) in done.files.items()}
            yield Rewritten(f"fix of {each.name}", texts, entry, workspace.arguments)


def rewritten(directory: Path, workspace: Workspace, seed: int, variables: Mapping[str, str]) -> Iterator[Rewritten]:
    """The workspace, which stands in ``directory``, after each command."""
    texts = {f"pk/{name}": (directory / "pk" / name).read_bytes() for name in workspace.launch_files}
    entry, given = workspace.entry, workspace.arguments
    yield Rewritten("format", {name: formatted(text, name, NARROW).data for name, text in texts.items()}, entry, given)
    yield from repaired(directory, workspace, seed, variables)
    session, file, pairs = session_in(directory, variables), str(directory / entry), tuple(given.items())
    language = XML if entry.endswith("yaml") else YAML
    there = f"{entry.removesuffix('.yaml').removesuffix('.xml').removesuffix('.launch')}{ENDS[language]}"
    if there not in texts and b"$(filename)" not in texts[entry]:  # it has another name then
        try:
            converted = convert(session, file, (), Style(), language)
        except CannotExport:
            pass
        else:
            if not converted.lost:
                yield Rewritten(f"to {language}", {there: converted.data}, there, given)
    try:
        flat = flatten(session, file, pairs, Style(), language)
    except CannotExport:
        return
    if not flat.lost:
        there = f"pk/flat{ENDS[language]}"
        yield Rewritten("flatten", {there: flat.data}, there, {})


def compared(answer: Answer, command: str, entry: str, directory: Path) -> Any:
    """What of an answer a command has to leave, wherever the workspace is and however the entry file is called; a flat file comes from one
    file, and counts names anew.
    """
    kept = {part: answer.get(part) for part in (STARTED if command == "flatten" else KEPT)}
    if command == "flatten":
        for each in (each for part in STARTED[1:] for each in kept[part] or () if isinstance(each, dict)):
            each.pop("conditions", None)  # they have been met
            each.pop("file", None)
    text = json.dumps(kept, sort_keys=True).replace(f"{directory.parent}/", "").replace("$WS/", "")
    if command != "flatten":
        text = text.replace(f"{directory.name}/{entry}", "ENTRY")
    text = text.replace(f"{directory.name}/", "")
    if command == "flatten":
        numbers: dict[str, int] = {}
        text = re.sub(r"(?<=anon)\d+", lambda match: str(numbers.setdefault(match[0], len(numbers))), text)
    return json.loads(text)


first_difference = partial(comparison.first_difference, sides=("before", "after"))


class Judged(NamedTuple):
    """One command, applied to one workspace: what it changed, in words; empty where nothing."""

    seed: int
    command: str
    difference: str


def workspace_of(seed: int) -> Workspace:
    """Every other workspace holds mistakes: most of those that do are refused, and there is nothing to be kept."""
    return random_workspace(seed, 0.35 if seed % 2 else 0.0)


def judged(seeds: Sequence[int], real: FrontEnd | None) -> list[Judged]:
    """Rewrite the workspaces of those numbers that load, and launch them before and after."""
    variables = VARIABLES if real is None else real.environment()
    found, asked = [], []
    with tempfile.TemporaryDirectory() as name:
        corpus = Path(name).resolve()
        for seed in seeds:
            workspace = workspace_of(seed)
            directory = corpus / f"w{seed}"
            workspace.write(directory)
            before = launched(directory, directory, workspace.entry, workspace.arguments, variables, DISTRO)
            if before["verdict"] != "ok":
                continue
            for number, each in enumerate(rewritten(directory, workspace, seed, variables)):
                copy = directory if each.command == "flatten" else corpus / f"{COPIES[number]}{seed}"  # it may hold the directory's name
                if copy != directory:
                    workspace.write(copy)
                for file, data in each.files.items():
                    (copy / file).write_bytes(data)
                after = launched(copy, copy, each.entry, each.given, variables, DISTRO)
                found.append(Judged(seed, each.command, _difference(before, after, workspace, directory, each, copy)))
                asked.append((seed, workspace, directory, each, copy))
        if real is not None:
            found += _really(real, corpus, asked)
    return found


def _difference(before: Answer, after: Answer, workspace: Workspace, directory: Path, each: Rewritten, copy: Path) -> str:
    sides = (compared(before, each.command, workspace.entry, directory), compared(after, each.command, each.entry, copy))
    return first_difference(*sides)


def _really(real: FrontEnd, corpus: Path, asked: Sequence[tuple[int, Workspace, Path, Rewritten, Path]]) -> Iterator[Judged]:
    """The same by the real front end."""
    first = [Question(f"{directory.name}/{workspace.entry}", workspace.arguments) for _, workspace, directory, _, _ in asked]
    second = [Question(f"{copy.name}/{each.entry}", each.given) for *_, each, copy in asked]
    answers = real.answers(corpus, [*first, *second])
    for (seed, workspace, directory, each, copy), before, after in zip(asked, answers, answers[len(asked) :], strict=False):
        if before["verdict"] == "ok":
            yield Judged(seed, f"{each.command}{BY_LAUNCH}", _difference(before, after, workspace, directory, each, copy))


def main() -> int:
    """See the module."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--count", type=int, default=1000)
    parser.add_argument("--seed", type=int, default=0)
    options = parser.parse_args()
    real, last = front_end(DISTRO), options.seed + options.count
    done: collections.Counter[str] = collections.Counter()
    different = 0
    for start in range(options.seed, last, AT_ONCE):
        for each in judged(range(start, min(start + AT_ONCE, last)), real):
            done[each.command] += 1
            if each.difference:
                different += 1
                print(f"{each.seed}: {each.command}: {each.difference[:300]}", flush=True)
    print(f"{options.count} workspaces from {options.seed} on, {dict(sorted(done.items()))}; {different} differ", flush=True)
    return 1 if different else 0


if __name__ == "__main__":
    sys.exit(main())
