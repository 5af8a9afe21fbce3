"""Random launch trees through the evaluator and through the real roslaunch, and what must hold for any tree whatever."""

from __future__ import annotations

import tempfile
from pathlib import Path
from random import Random
from typing import Any

import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from launchlint.evaluate.configurations import configurations
from launchlint.evaluate.ros1.launch import evaluate
from launchlint.evaluate.session import Session
from launchlint.problem import Problem
from launchlint.report.model import as_object
from tests.evaluate.comparison import MAIN, Case, difference, inside, ours, session_in, theirs, write
from tests.evaluate.random_launch import random_case

PROPERTY = settings(max_examples=60, deadline=None, derandomize=True, suppress_health_check=[HealthCheck.too_slow])
CASES = st.builds(random_case, st.randoms(use_true_random=False), st.just(0.8))


class NoBlocks(dict[Any, Any]):
    """Forgets what it is given: with it in the place of ``session.blocks`` every include is evaluated anew."""

    def __setitem__(self, key: Any, block: Any) -> None:
        pass


def without_blocks(directory: Path, case: Case) -> Session:
    """A session that never uses a block again."""
    session = session_in(directory, case.environment)
    session.blocks = NoBlocks()
    return session


def outcome(session: Session, case: Case, directory: Path) -> tuple[object, ...]:
    """Everything that comes out of a case, in a form that can be compared: the model, the problems with their places, conditions,
    settings.
    """
    with inside(directory):
        evaluation = evaluate(session, str(directory / MAIN), tuple(case.arguments.items()))
    launch = evaluation.launch
    return (
        as_object(evaluation.launch, MAIN, None),
        [shown(problem) for problem in launch.problems],
        [(branch.origin.place.span, branch.taken, sorted(branch.steered_by), branch.open) for branch in launch.branches],
        [(setting.kind, setting.key, setting.reached, len(setting.before)) for setting in launch.settings],
        [(setting.name, setting.origin.place.span, setting.node, len(setting.origin.chain)) for setting in launch.parameter_settings],
        sorted((path, sorted(indices)) for path, indices in evaluation.visited.items()),
        launch.complete,
    )


def shown(problem: Problem) -> tuple[object, ...]:
    """A problem as something that can be compared: kind, file, offsets, and the includes that led there."""
    place = problem.place
    return (problem.kind, place.source.path, place.span, problem.refused, problem.assumed, [step.span for step in problem.origin.chain])


@pytest.mark.ros
@pytest.mark.parametrize("seed", [1, 2])
def test_random_trees_are_what_roslaunch_says(seed: int, ros_python: str, tmp_path: Path) -> None:
    placed = []
    for number in range(100):
        case = random_case(Random(seed * 1000 + number))
        directory = tmp_path / str(number)
        write(case, directory)
        placed.append((case, directory))
    answers = theirs(ros_python, placed)
    differences = {
        number: difference(answer, ours(case, directory))
        for number, ((case, directory), answer) in enumerate(zip(placed, answers, strict=True))
    }
    assert {number: text for number, text in differences.items() if text} == {}
    # Both kinds are among them, else the comparison would say nothing.
    verdicts = [answer["verdict"] for answer in answers]
    assert verdicts.count("ok") > 50
    assert verdicts.count("error") > 5


@PROPERTY
@given(CASES)
def test_two_sessions_say_the_same_and_so_does_one_asked_twice(case: Case) -> None:
    with tempfile.TemporaryDirectory() as name:
        directory = Path(name)
        write(case, directory)
        session = session_in(directory, case.environment)
        first = outcome(session, case, directory)
        assert outcome(session, case, directory) == first
        assert outcome(session_in(directory, case.environment), case, directory) == first


@PROPERTY
@given(CASES)
def test_blocks_used_again_change_nothing(case: Case) -> None:
    with tempfile.TemporaryDirectory() as name:
        directory = Path(name)
        write(case, directory)
        with_blocks = session_in(directory, case.environment)
        # A session that has evaluated the other files as entry files before, as a run over a directory has.
        for each in case.files:
            if each.endswith(".launch"):
                with inside(directory):
                    evaluate(with_blocks, str(directory / each))
        assert outcome(with_blocks, case, directory) == outcome(without_blocks(directory, case), case, directory)


@PROPERTY
@given(CASES)
def test_every_configuration_is_concrete_and_new(case: Case) -> None:
    with tempfile.TemporaryDirectory() as name, inside(Path(name)):
        directory = Path(name)
        write(case, directory)
        given_pairs = tuple(case.arguments.items())
        found = list(configurations(session_in(directory, case.environment), str(directory / MAIN), given_pairs))
        launched = [evaluation.launch.given for evaluation in found]
        assert launched[0] == given_pairs
        assert len(set(launched)) == len(launched)
        for evaluation in found:
            again = evaluate(session_in(directory, case.environment), str(directory / MAIN), evaluation.launch.given)
            assert as_object(again.launch, MAIN, None) == as_object(evaluation.launch, MAIN, None)
