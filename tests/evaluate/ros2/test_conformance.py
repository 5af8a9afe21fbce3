"""What the real front ends made of small files, held against the model."""

from __future__ import annotations

import importlib.util
import json
import lzma
import os
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path
from types import ModuleType
from typing import Any

import pytest

from launchlint.evaluate.ros2.launch import evaluate
from launchlint.evaluate.session import Session
from launchlint.report.launched import as_object
from launchlint.workspace.packages import Packages

PYTHON = {"scope_include_python"}
"""Cases with a launch file in Python, which is not looked into."""


@pytest.fixture(scope="module")
def oracle() -> Path:
    directory = Path(os.environ.get("LAUNCHLINT_ORACLE", ""), "ros2")
    if not (directory / "make_cases.py").is_file():
        pytest.skip("LAUNCHLINT_ORACLE does not name a directory with recorded answers")
    return directory


@pytest.fixture(scope="module")
def cases(oracle: Path, tmp_path_factory: pytest.TempPathFactory) -> Path:
    directory = tmp_path_factory.mktemp("cases")
    subprocess.run([sys.executable, str(oracle / "make_cases.py"), str(directory)], check=True, capture_output=True)
    return directory


@pytest.fixture(scope="module")
def comparison(oracle: Path) -> ModuleType:
    """The comparison of the oracle itself."""
    spec = importlib.util.spec_from_file_location("agree_ros2", oracle / "agree_ros2.py")
    assert spec is not None
    assert spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def answers(oracle: Path, distro: str) -> Iterator[dict[str, Any]]:
    found: dict[str, dict[str, Any]] = {}
    for each in dict.fromkeys(("jazzy", distro)):
        with lzma.open(oracle / f"cases.{each}.jsonl.xz", "rt", encoding="utf-8") as lines:
            for line in lines:
                answer = json.loads(line)
                found[answer["file"]] = answer
    return (answer for file, answer in found.items() if not file.endswith(".py"))


@pytest.mark.parametrize("distro", ["humble", "jazzy", "rolling"])
def test_the_model_is_that_of_launch(oracle: Path, cases: Path, comparison: ModuleType, distro: str) -> None:
    different: list[str] = []
    count = 0
    root = str(cases)
    for answer in answers(oracle, distro):
        case = answer["file"].split("/")[0]
        if case in PYTHON:
            continue
        count += 1
        variables = {**comparison.ENV, "ROS_DISTRO": distro}
        session = Session(Packages([str(cases / case)], variables, explicit=True), variables, root)
        launch = evaluate(session, str(cases / answer["file"]), tuple((answer.get("given_args") or {}).items())).launch
        error = None if launch.refused is None else ("", launch.refused.kind)
        ours = json.loads(json.dumps(as_object(launch, answer["file"], error)))
        if ours["verdict"] != answer["verdict"]:
            different.append(f"{case}: launch {answer['verdict']}, here {ours['error']}")
        if answer["verdict"] != "ok" or launch.refused is not None:
            continue
        for part in ("nodes", "includes", "executables", "args"):
            keys = comparison.LISTS.get(part) or sum(comparison.GROUPS.values(), ())
            theirs, mine = ([comparison.item(each, keys, root, distro) for each in side.get(part) or []] for side in (answer, ours))
            if comparison.compare(theirs, mine) != "equal":
                different.append(f"{case}: {part}: {comparison.first_difference(theirs, mine)}")
        listed = [comparison.canonical(side.get("declared"), root, distro) for side in (answer, ours)]
        if comparison.compare(*listed) != "equal" or len(answer.get("deferred_errors") or []) != len(ours["deferred_errors"]):
            different.append(f"{case}: declared or deferred")
    assert count > 700
    assert not different


def test_the_model_of_python_is_that_of_launch_or_says_what_is_not_known(oracle: Path, cases: Path, comparison: ModuleType) -> None:
    """What is said of a file in Python is what launch does, or that it is not known."""
    different: list[str] = []
    known = 0
    root = str(cases)
    with lzma.open(oracle / "cases.jazzy.jsonl.xz", "rt", encoding="utf-8") as lines:
        recorded = [answer for answer in map(json.loads, lines) if answer["file"].endswith(".py")]
    for answer in recorded:
        case = answer["file"].split("/")[0]
        variables = {**comparison.ENV, "ROS_DISTRO": "jazzy"}
        session = Session(Packages([str(cases / case)], variables, explicit=True), variables, root)
        launch = evaluate(session, str(cases / answer["file"]), tuple((answer.get("given_args") or {}).items())).launch
        error = None if launch.refused is None else ("", launch.refused.kind)
        ours = json.loads(json.dumps(as_object(launch, answer["file"], error)))
        if ours["verdict"] not in (answer["verdict"], "unknown"):
            different.append(f"{case}: launch {answer['verdict']}, here {ours['error']}")
        if answer["verdict"] != "ok" or launch.refused is not None:
            known += ours["verdict"] == answer["verdict"]
            continue
        everything = ours["complete"]
        for part in ("nodes", "includes", "executables", "args"):
            keys = comparison.LISTS.get(part) or sum(comparison.GROUPS.values(), ())
            theirs, mine = ([comparison.item(each, keys, root, "jazzy") for each in side.get(part) or []] for side in (answer, ours))
            found = comparison.compare(theirs, mine)
            everything = everything and found == "equal"
            if found == "wrong" and ours["complete"]:
                different.append(f"{case}: {part}: {comparison.first_difference(theirs, mine)}")
        known += everything
    assert known >= 115
    assert not different
