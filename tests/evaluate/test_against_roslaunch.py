"""Tricky launch files, one thing each: what the evaluator makes of them, and the same files through the real roslaunch."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.evaluate.cases.arguments import ARGUMENTS
from tests.evaluate.cases.nodes import NODES
from tests.evaluate.cases.parameters import PARAMETERS
from tests.evaluate.cases.scopes import SCOPES
from tests.evaluate.cases.substitutions import SUBSTITUTIONS
from tests.evaluate.comparison import Case, difference, launch_of, ours, theirs, write

ROOMS = {"scopes": SCOPES, "arguments": ARGUMENTS, "parameters": PARAMETERS, "substitutions": SUBSTITUTIONS, "nodes": NODES}
CASES = {f"{room}: {name}": each for room, cases in ROOMS.items() for name, each in cases.items()}


@pytest.mark.parametrize("each", [pytest.param(each, id=name) for name, each in CASES.items()])
def test_verdict_and_reason(each: Case, tmp_path: Path) -> None:
    write(each, tmp_path)
    launch = launch_of(each, tmp_path)
    assert tuple(problem.kind for problem in launch.problems if problem.refused) == each.refused


@pytest.mark.ros
@pytest.mark.parametrize("room", ROOMS)
def test_the_real_roslaunch_says_the_same(room: str, ros_python: str, tmp_path: Path) -> None:
    placed = []
    for number, each in enumerate(ROOMS[room].values()):
        directory = tmp_path / str(number)
        write(each, directory)
        placed.append((each, directory))
    answers = theirs(ros_python, placed)
    differences = {
        name: difference(answer, ours(each, directory))
        for name, (each, directory), answer in zip(ROOMS[room], placed, answers, strict=True)
    }
    assert {name: text for name, text in differences.items() if text} == {}
