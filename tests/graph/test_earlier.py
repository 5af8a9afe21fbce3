"""Configurations of one entry file: a node is worked out once where nothing that it hangs on differs, and again where something does."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest

from launchlint.evaluate.ros1.launch import evaluate
from launchlint.evaluate.ros2.launch import evaluate as evaluate_ros2
from launchlint.evaluate.ros2.repeating import Repeats
from launchlint.evaluate.session import Session
from launchlint.graph.connect import connect
from launchlint.graph.connections import ConnectionGraph
from launchlint.graph.earlier import DEEPEST, Earlier
from launchlint.workspace.packages import Packages
from tests.graph.sample import ENVIRONMENT, STRING, channels, edges, library, program

PROGRAMS: dict[str, Any] = {
    "my_pkg": {
        "executables": {
            "talker": program(publishers=[{"name": "out", "type": STRING}]),
            "chosen": program(publishers=[{"name": "{param:~topic|chatter}", "type": STRING}]),
        }
    }
}
MAIN = """
<arg name="x" default="1"/>
{before}
<node pkg="my_pkg" type="talker" name="same"/>
<node pkg="my_pkg" type="chosen" name="node">{inside}</node>
"""


def both(directory: Path, before: str = "", inside: str = "", around: str = "{}") -> tuple[list[ConnectionGraph], list[ConnectionGraph]]:
    """The graphs with x:=1 and x:=2, made one after the other with a memory, and each alone."""
    file = directory / "main.launch"
    file.write_text(f"<launch>{around.replace('{}', MAIN.format(before=before, inside=inside))}</launch>", encoding="utf-8")
    known, memory = library(directory, PROGRAMS), Earlier()
    session = Session(Packages([str(directory)], ENVIRONMENT, explicit=True), ENVIRONMENT, str(directory))
    launches = [evaluate(session, str(file), (("x", value),)).launch for value in ("1", "2")]
    return [connect(launch, known, memory) for launch in launches], [connect(launch, known) for launch in launches]


@pytest.mark.parametrize(
    ("before", "inside"),
    [
        ("", ""),
        ("", '<remap from="chatter" to="other$(arg x)"/>'),
        ("", '<param name="topic" value="topic$(arg x)"/>'),
        ('<param name="/node/topic" value="topic$(arg x)"/>', ""),
        ("<rosparam>node: {topic: topic$(arg x)}</rosparam>".replace("<rosparam>", '<rosparam subst_value="true">'), ""),
    ],
    ids=["nothing", "remap", "own_param", "param_before", "yaml"],
)
def test_each_graph_is_the_one_that_it_is_alone(before: str, inside: str, tmp_path: Path) -> None:
    together, alone = both(tmp_path, before, inside)
    assert [(edges(each), channels(each)) for each in together] == [(edges(each), channels(each)) for each in alone]
    differs = channels(together[0]) != channels(together[1])
    assert differs == bool(before or inside)


def test_an_equal_node_is_the_same_object_and_another_one_is_not(tmp_path: Path) -> None:
    (first, second), _ = both(tmp_path, '<param name="/node/topic" value="topic$(arg x)"/>')
    same = [one is other for one, other in zip(first.instances, second.instances, strict=True)]
    assert dict(zip((each.name for each in first.instances), same, strict=True)) == {"/same": True, "/node": False}


def test_values_that_python_takes_for_equal_are_told_apart(tmp_path: Path) -> None:
    (first, second), alone = both(tmp_path, '<param name="/node/topic" value="$(eval 1 if x == 1 else True)"/>')
    assert [channels(each) for each in (first, second)] == [channels(each) for each in alone]
    assert first.instances[1] is not second.instances[1]


def test_nodes_below_many_groups_are_not_compared(tmp_path: Path) -> None:
    (first, second), alone = both(tmp_path, around="<group>" * (DEEPEST + 1) + "{}" + "</group>" * (DEEPEST + 1))
    assert [edges(each) for each in (first, second)] == [edges(each) for each in alone]
    assert not any(one is other for one, other in zip(first.instances, second.instances, strict=True))


def ros2(directory: Path, nodes: str) -> list[ConnectionGraph]:
    """The graphs of a launch file of ROS 2 with x:=1 and x:=2, made one after the other with a memory."""
    file = directory / "main.launch.xml"
    file.write_text(f'<launch><arg name="x" default="1"/>{nodes}</launch>', encoding="utf-8")
    known, memory = library(directory, PROGRAMS), Earlier()
    session = Session(Packages([str(directory)], ENVIRONMENT, explicit=True), ENVIRONMENT, str(directory))
    repeats = Repeats()
    launches = [evaluate_ros2(session, str(file), (("x", value),), repeats=repeats).launch for value in ("1", "2")]
    return [connect(launch, known, memory) for launch in launches]


def test_a_node_of_ros2_is_worked_out_again_only_where_it_differs(tmp_path: Path) -> None:
    first, second = ros2(
        tmp_path,
        '<node pkg="my_pkg" exec="talker" name="same"/>'
        '<node pkg="my_pkg" exec="talker" name="led"><remap from="out" to="o$(var x)"/></node>',
    )
    same = [one is other for one, other in zip(first.instances, second.instances, strict=True)]
    assert dict(zip((each.name for each in first.instances), same, strict=True)) == {"/same": True, "/led": False}


def test_what_nobody_names_is_called_by_its_number_in_each_configuration(tmp_path: Path) -> None:
    first, second = ros2(
        tmp_path,
        '<group if="$(eval \'$(var x) == 1\')"><node pkg="my_pkg" exec="other"/></group><node pkg="my_pkg" exec="other"/>',
    )
    assert [each.name for each in first.instances] == ["/(other)", "/(other 2)"]
    assert [each.name for each in second.instances] == ["/(other)"]


def test_nodes_of_one_place_and_name_are_instances_of_their_own(tmp_path: Path) -> None:
    (tmp_path / "twice.launch.py").write_text(
        "from launch import LaunchDescription\nfrom launch_ros.actions import Node\n"
        "def generate_launch_description():\n"
        "    return LaunchDescription([Node(package='my_pkg', executable='talker', name='n') for _ in range(2)])\n",
        encoding="utf-8",
    )
    session = Session(Packages([str(tmp_path)], ENVIRONMENT, explicit=True), ENVIRONMENT, str(tmp_path))
    launch = evaluate_ros2(session, str(tmp_path / "twice.launch.py")).launch
    one, other = connect(launch, library(tmp_path, PROGRAMS), Earlier()).instances
    assert one is not other
    assert one.endpoints == other.endpoints
