"""What is exported, through the real roslaunch: the tricky launch files of the evaluator's tests, and random ones."""

from __future__ import annotations

import json
import re
from pathlib import Path
from random import Random
from typing import Any

import pytest

from launchlint.export.flatten import flatten
from launchlint.export.written import CannotExport
from launchlint.fix.format.style import Style
from tests.evaluate.comparison import MAIN, Case, difference, inside, launch_of, session_in, theirs, write
from tests.evaluate.random_launch import random_case
from tests.evaluate.test_against_roslaunch import CASES

# What a flat file cannot say, each for a reason of its own; the export refuses, and nothing is written.
IMPOSSIBLE = {
    "arguments: a substitution on the command line": "a literal $(arg x) as a value",
    "parameters: a name from an arg": "a name with blanks around it",
    "substitutions: args that hold substitutions": "a literal $ in front of a parenthesis",
    "substitutions: an arg that comes out of an arg": "a literal $ in front of a parenthesis",
    "substitutions: anonymous names and includes": "two names of one $(anon) in one value",
}
RANDOM = {f"random {seed}": random_case(Random(seed), 0.97) for seed in range(40)}
PARTS = ("verdict", "nodes", "tests", "params", "clear_params", "machines", "executables")


def export_all(cases: dict[str, Case], directory: Path, *, args_kept: bool) -> tuple[dict[str, tuple[Case, Path]], dict[str, str]]:
    """Put each case that loads into a folder of its own, and next to it what is exported of it; and the names of those that cannot be, with
    the reason.
    """
    placed, refused = {}, {}
    for number, (name, each) in enumerate(cases.items()):
        folder = directory / str(number)
        write(each, folder)
        if launch_of(each, folder).refused is not None:
            continue
        with inside(folder):
            try:
                arguments = tuple(each.arguments.items())
                export = flatten(session_in(folder, each.environment), str(folder / MAIN), arguments, Style(), args_kept=args_kept)
            except CannotExport as error:
                refused[name] = error.reason
                continue
        placed[name] = (each, folder)
        (folder / "exported").write_bytes(export.data)
    return placed, refused


def without_files(answer: dict[str, Any]) -> dict[str, Any]:
    """The answer without the launch files that it comes from, and with anonymous names numbered as they come."""
    for node in (*answer.get("nodes", ()), *answer.get("tests", ())):
        node.pop("file", None)
    numbers: dict[str, int] = {}
    text = json.dumps({part: answer.get(part) for part in PARTS}, sort_keys=True)
    text = re.sub(r"_anon(\d+)", lambda match: f"_anon#{numbers.setdefault(match[1], len(numbers) + 1)}", text)
    answer = json.loads(text)
    answer["executables"] = [step.rstrip("/") for step in answer["executables"] or ()]
    return answer


def differences(cases: dict[str, Case], ros_python: str, directory: Path, *, args_kept: bool) -> tuple[dict[str, str], dict[str, str]]:
    """What roslaunch says to be different, by case; and what was not exported."""
    placed, refused = export_all(cases, directory, args_kept=args_kept)
    before = theirs(ros_python, list(placed.values()))
    alone = []
    for each, folder in placed.values():
        for file in folder.rglob("*.launch"):
            file.unlink()
        (folder / "exported").rename(folder / MAIN)
        alone.append((each._replace(arguments={}), folder))
    after = theirs(ros_python, alone)
    found = {
        name: difference(without_files(first), without_files(second)) for name, first, second in zip(placed, before, after, strict=True)
    }
    return {name: text for name, text in found.items() if text}, refused


@pytest.mark.ros
@pytest.mark.parametrize("args_kept", [False, True], ids=["flatten", "args-kept"])
def test_roslaunch_starts_the_same(args_kept: bool, ros_python: str, tmp_path: Path) -> None:
    found, refused = differences(CASES, ros_python, tmp_path, args_kept=args_kept)
    assert found == {}
    assert sorted(refused) == sorted(IMPOSSIBLE)


@pytest.mark.ros
@pytest.mark.parametrize("args_kept", [False, True], ids=["flatten", "args-kept"])
def test_roslaunch_starts_the_same_of_random_files(args_kept: bool, ros_python: str, tmp_path: Path) -> None:
    found, refused = differences(RANDOM, ros_python, tmp_path, args_kept=args_kept)
    assert found == {}
    assert {name: reason for name, reason in refused.items() if "_anon" not in reason} == {}
