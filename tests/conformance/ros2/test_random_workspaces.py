"""Random workspaces through the evaluator and through the real front ends, and what must hold for any workspace whatever."""

from __future__ import annotations

from pathlib import Path

import pytest

from launchlint.evaluate.ros2.launch import evaluate
from launchlint.evaluate.session import Session
from launchlint.report.launched import as_object
from launchlint.workspace.packages import Packages
from tests.conformance.ros2.front_end import WHY_NOT, front_end
from tests.conformance.ros2.held_against import differences, kind_of
from tests.conformance.ros2.random_workspace import Workspace, random_workspace
from tests.conformance.ros2.tree import Tag, as_xml, as_yaml

VARIABLES = {"HOME": "/home/user", "USER": "user", "ROS_DISTRO": "jazzy"}


def answer(directory: Path, workspace: Workspace) -> object:
    session = Session(Packages([str(directory)], VARIABLES, explicit=True), VARIABLES, str(directory), distro="jazzy")
    launch = evaluate(session, str(directory / workspace.entry), tuple(workspace.arguments.items())).launch
    told = [(problem.kind, problem.place.source.path, problem.place.span, problem.refused) for problem in launch.problems]
    return as_object(launch, workspace.entry, None), told


@pytest.mark.slow
def test_they_are_what_launch_says() -> None:
    real = front_end()
    if real is None:
        pytest.skip(WHY_NOT)
    workspaces = [random_workspace(seed) for seed in range(10_000, 10_100)]
    judged = differences(real, workspaces)
    assert [(seed, found) for seed, (found, _) in enumerate(judged, 10_000) if found] == []
    verdicts = [answer["verdict"] for _, answer in judged]
    assert verdicts.count("ok") > 30
    assert verdicts.count("error") > 10


def test_they_come_to_the_same_twice(tmp_path: Path) -> None:
    for seed in range(60):
        workspace = random_workspace(seed)
        workspace.write(tmp_path / str(seed))
        first = answer(tmp_path / str(seed), workspace)
        assert answer(tmp_path / str(seed), random_workspace(seed)) == first


def test_the_shrinker_only_takes_away() -> None:
    workspace = random_workspace(3)
    whole = sum(len(as_xml(tag)) for tag in workspace.launch_files.values())
    smaller = workspace.smaller()
    assert len(smaller) > 20
    sizes = [sum(len(as_xml(tag)) for tag in each.launch_files.values()) for each in smaller]
    assert min(sizes) < whole
    assert max(sizes) <= whole


def test_one_tree_is_written_in_both_dialects() -> None:
    node = Tag("node", {"pkg": "p", "exec": "e"}, (Tag("param", {"name": "a", "value": 1.5}),))
    launch = Tag("launch", {}, (Tag("group", {}, (node,)),))
    assert as_xml(launch) == (
        '<launch>\n  <group>\n    <node pkg="p" exec="e">\n      <param name="a" value="1.5"/>\n    </node>\n  </group>\n</launch>\n'
    )
    assert as_yaml(launch) == 'launch:\n- group: [{"node": {"pkg": "p", "exec": "e", "param": [{"name": "a", "value": 1.5}]}}]\n'


def test_two_differences_of_one_kind_are_one() -> None:
    assert kind_of("nodes[3].params: ROS 1, launchlint 2") == kind_of("nodes[12].params: ROS 7, launchlint null")
