"""Random launch files in Python through the evaluator and through the real front end: what they keep and put back by themselves."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from launchlint.evaluate.ros2.launch import evaluate
from launchlint.evaluate.session import Session
from launchlint.report.launched import as_object
from launchlint.workspace.packages import Packages
from tests.conformance.ros2.front_end import WHY_NOT, Answer, FrontEnd, Question, front_end
from tests.conformance.ros2.random_program import RandomProgram


def own_answer(real: FrontEnd, corpus: Path, file: Path) -> Answer:
    variables = real.environment()
    session = Session(Packages([str(file.parents[2])], variables, explicit=True), variables, str(corpus), distro=real.distro)
    launch = evaluate(session, str(file), ()).launch
    answer: Answer = json.loads(json.dumps(as_object(launch, str(file), None if launch.refused is None else ("", launch.refused.kind))))
    return answer


@pytest.mark.slow
def test_they_are_what_launch_says(tmp_path: Path) -> None:
    real = front_end()
    if real is None:
        pytest.skip(WHY_NOT)
    files = [RandomProgram(seed).write(tmp_path / f"w{seed:05}") for seed in range(60)]
    answers = real.answers(tmp_path, [Question(str(file.relative_to(tmp_path))) for file in files])
    found = {
        str(file): real.difference(tmp_path, answer, own_answer(real, tmp_path, file))
        for file, answer in zip(files, answers, strict=True)
        if answer["verdict"] in ("ok", "error")
    }
    assert {file: each for file, each in found.items() if each} == {}
    verdicts = [answer["verdict"] for answer in answers]
    assert verdicts.count("ok") > 30
    assert verdicts.count("error") > 3
