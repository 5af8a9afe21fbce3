"""Random launch trees through roslaunch, through the evaluator, and through the commands that must not change what they mean."""

from __future__ import annotations

from typing import Any

import pytest

from tests.conformance.ros1 import held_against
from tests.conformance.ros1.smaller import smaller
from tests.evaluate.comparison import MAIN, Case, content


@pytest.mark.ros
def test_they_are_what_roslaunch_says_before_and_after_they_are_rewritten(ros_python: str) -> None:
    seeds = range(500_000, 500_060)
    judged = held_against.judged(ros_python, [held_against.tree(seed) for seed in seeds])
    assert {seed: differs for seed, (_, differs) in zip(seeds, judged, strict=True) if differs} == {}
    verdicts = [verdict for verdict, _ in judged]
    assert verdicts.count("ok") > 30
    assert verdicts.count("error") > 5


@pytest.mark.ros
def test_a_difference_is_found_and_made_small(ros_python: str, monkeypatch: pytest.MonkeyPatch) -> None:
    def without_output(case: Case, directory: Any) -> dict[str, Any]:
        model = real(case, directory)
        for node in model.get("nodes", ()):
            node["output"] = None
        return model

    real = held_against.ours
    monkeypatch.setattr(held_against, "ours", without_output)
    group = '<group ns="g"><param name="p" value="1"/><node pkg="p" type="t" name="n" output="screen" args="a"/></group>'
    case = Case({MAIN: f'<launch><arg name="a" default="1"/>{group}</launch>', "other.txt": "x"}, (), {"a": "2"}, {"SET": "1"})
    [(verdict, differs)] = held_against.judged(ros_python, [case])
    assert (verdict, ".output:" in differs) == ("ok", True)
    small, why = held_against.shrunk(ros_python, case, differs)
    assert ".output:" in why
    assert small == Case({MAIN: b'<launch><node pkg="p" type="t" name="n" output="screen"/></launch>'}, (), {}, {})


def test_smaller_trees_have_one_thing_less() -> None:
    case = held_against.tree(8)
    size = sum(len(content(name, text)) for name, text in case.files.items())
    cuts = list(smaller(case))
    assert len(cuts) > 20
    assert all(
        len(cut.arguments) + len(cut.environment) + len(cut.files) <= len(case.arguments) + len(case.environment) + len(case.files)
        for cut in cuts
    )
    assert min(sum(len(content(name, text)) for name, text in cut.files.items()) for cut in cuts) < size
