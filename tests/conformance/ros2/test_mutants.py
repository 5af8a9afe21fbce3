"""Launch files with one mistake each, and what the real front ends said of them: what launchlint says must fit.

``recorded.json`` was written by :mod:`.mutant_audit`, from the launch files in ``originals``; it needs nothing to be held against.
"""

from __future__ import annotations

import json
import os
import subprocess
import sys
from collections import Counter
from pathlib import Path
from typing import Any

import pytest

from tests.conformance.ros2.elements import read
from tests.conformance.ros2.mutant_audit import Judged, draw, launch_files, new_findings
from tests.conformance.ros2.mutations import Mutant

HERE = Path(__file__).parent
ORIGINALS = HERE / "originals"
RECORDED: list[dict[str, Any]] = json.loads((HERE / "recorded.json").read_text("utf-8"))
# The front ends were given what the files cannot be started without.
GIVEN = {"own/robot_pk/launch/camera.launch.xml": {"camera": "guess_camera"}}


@pytest.fixture(scope="module")
def judged(tmp_path_factory: pytest.TempPathFactory) -> list[Judged]:
    """Each recorded mutant with what launchlint says of it."""
    directory = tmp_path_factory.mktemp("mutants")
    files = sorted({each["file"] for each in RECORDED})
    entries = [{"file": str(ORIGINALS / file), "args": GIVEN.get(file, {})} for file in files]
    texts = []
    for number, each in enumerate(RECORDED):
        text = (ORIGINALS / each["file"]).read_text("utf-8")
        (start, end), name = each["at"], f"{number}_{os.path.basename(each['file'])}"
        texts.append(text[:start] + each["text"] + text[end:])
        (directory / name).write_text(texts[-1], "utf-8")
        entry = {"file": str(directory / name), "as": str(ORIGINALS / each["file"]), "args": GIVEN.get(each["file"], {})}
        entries.append(entry)
    (directory / "entries.json").write_text(json.dumps(entries), "utf-8")
    command = [sys.executable, "-m", "launchlint", "check", "--format", "jsonl", "--exit-zero", "--no-cache"]
    command += ["--workspace", str(ORIGINALS / "own"), "--entries", str(directory / "entries.json")]
    variables = {"HOME": "/home/user", "USER": "user", "PATH": os.environ["PATH"], "ROS_VERSION": "2", "ROS_DISTRO": "jazzy"}
    run = subprocess.run(command, env=variables, cwd=HERE.parents[2], capture_output=True, text=True, check=True)
    answers = [json.loads(line) for line in run.stdout.splitlines()]
    clean = {file: answer["findings"] for file, answer in zip(files, answers, strict=False)}
    found = []
    for each, text, answer in zip(RECORDED, texts, answers[len(files) :], strict=True):
        mutant = Mutant(text, tuple((first, last) for first, last in each["lines"]))
        real = {"error": {"kind": each["reason"]}, "deferred_errors": each["late"]}
        findings = new_findings(answer["findings"], clean[each["file"]])
        found.append(Judged("", each["kind"], each["file"], mutant, each["outcome"], real, answer["verdict"], {}, findings))
    return found


def names(judged: list[Judged]) -> list[str]:
    return [f"{each.kind} of {each.original}: {each.reason}: {each.findings}" for each in judged]


def test_the_verdict_is_that_of_launch(judged: list[Judged]) -> None:
    assert not names([each for each in judged if (each.outcome == "refused") != (each.verdict == "error")])


def test_what_is_refused_is_told_by_the_rule_for_it(judged: list[Judged]) -> None:
    refused = [each for each in judged if each.outcome == "refused"]
    assert len(refused) > 80
    assert not names([each for each in refused if not each.told or not each.by_the_rule])


def test_it_is_told_at_its_place(judged: list[Judged]) -> None:
    refused = [each for each in judged if each.outcome == "refused"]
    assert not names([each for each in refused if not any(each.is_told_by(finding) for finding in each.at_the_place)])


def test_what_loads_has_no_error(judged: list[Judged]) -> None:
    assert not names([each for each in judged if each.wrongly_refused])


def test_of_what_starts_something_else_the_half_is_told(judged: list[Judged]) -> None:
    told = Counter(each.told for each in judged if each.outcome == "changed")
    assert told[True] >= told[False]


def test_a_seed_gives_the_same_mutants_again() -> None:
    files = launch_files(ORIGINALS)
    first, second = (list(draw(ORIGINALS, files, 60, 1)) for _ in range(2))
    assert first == second
    assert len({(group, kind) for group, kind, _, _ in first}) > 40


@pytest.mark.parametrize("file", launch_files(ORIGINALS))
def test_the_mutator_knows_where_things_stand(file: str) -> None:
    text = (ORIGINALS / file).read_text("utf-8")
    for element in read(text, file).elements:
        assert text[slice(*element.name_at)] == element.tag or element.tag in ("param", "remap", "arg")
        for name, attribute in element.attributes.items():
            assert text[slice(*attribute.name_at)] == name
            assert attribute.value in text[slice(*attribute.value_at)].replace("&quot;", '"')
