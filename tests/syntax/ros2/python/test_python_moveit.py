"""Launch files that use moveit_configs_utils or launch_param_builder where neither is in the workspace: models stand for them."""

from __future__ import annotations

import json
from collections.abc import Callable, Mapping
from pathlib import Path
from typing import Any

import pytest

from launchlint.cli import main
from launchlint.syntax.ros2.python.bundled import DIRECTORY, model_of

Asked = Callable[..., dict[str, Any]]

PACKAGE = (
    '<package format="3"><name>arm_moveit_config</name><version>0.0.1</version><description>d</description>'
    '<maintainer email="a@b.c">m</maintainer><license>Apache-2.0</license></package>'
)
CONFIG: Mapping[str, str] = {
    "config/arm.urdf.xacro": "<robot/>",
    "config/arm.srdf": "<robot/>",
    "config/kinematics.yaml": "arm: {kinematics_solver: kdl}\n",
    "config/joint_limits.yaml": "joint_limits: {a: {max_velocity: 1.5}}\n",
    "config/pilz_cartesian_limits.yaml": "cartesian_limits: {max_trans_vel: 2.0}\n",
    "config/moveit_controllers.yaml": "moveit_simple_controller_manager: {controller_names: [arm_controller]}\n",
    "config/ompl_planning.yaml": "planning_plugins: [p]\nplanner_configs: {a: {type: t}}\n",
}
ALL = "return LaunchDescription([Node(package='arm_moveit_config', executable='drive', parameters=[{}.to_dict()])])"
BUILT = "MoveItConfigsBuilder('arm').planning_pipelines(pipelines=['ompl']).to_moveit_configs()"


@pytest.fixture
def asked(tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> Asked:
    """What ``launchlint model`` says of a launch file of a MoveIt configuration, without some of its files, for a distribution."""

    def ask(body: str, *, without: str = "", distro: str = "jazzy", more: Mapping[str, str] = {}) -> dict[str, Any]:
        launch_file = (
            "from launch import LaunchDescription\nfrom launch_ros.actions import Node\n"
            "from launch_param_builder import ParameterBuilder\nfrom moveit_configs_utils import MoveItConfigsBuilder, launches\n\n\n"
            f"def generate_launch_description():\n    {body}\n"
        )
        for name, content in {"package.xml": PACKAGE, **CONFIG, "launch/a.launch.py": launch_file, **more}.items():
            path = tmp_path / name[3:] if name.startswith("../") else tmp_path / "arm" / name
            path.parent.mkdir(parents=True, exist_ok=True)
            if name != without:
                path.write_text(content, encoding="utf-8")
        monkeypatch.setenv("ROS_DISTRO", distro)
        monkeypatch.setenv("DISPLAY", ":0")
        main(["model", "--format", "jsonl", "--workspace", str(tmp_path), str(tmp_path / "arm/launch/a.launch.py")], standalone_mode=False)
        found: dict[str, Any] = json.loads(capsys.readouterr().out.splitlines()[0])
        return found

    return ask


def params(found: dict[str, Any]) -> dict[str, Any]:
    (node,) = found["nodes"]
    made: dict[str, Any] = node["params"][0]["content"]["/**"]["ros__parameters"]
    return made


def test_all_params_of_a_moveit_configuration(asked: Asked, tmp_path: Path) -> None:
    found = asked(ALL.format(BUILT))
    assert (found["verdict"], found["error"]) == ("ok", None)
    assert params(found) == {
        "robot_description": f"$(xacro {tmp_path}/arm/config/arm.urdf.xacro)",
        "robot_description_semantic": f"$(xacro {tmp_path}/arm/config/arm.srdf)",
        "robot_description_kinematics.arm.kinematics_solver": "kdl",
        "planning_pipelines": ["ompl"],
        "default_planning_pipeline": "ompl",
        "ompl.planning_plugins": ["p"],
        "ompl.planner_configs.a.type": "t",
        "moveit_manage_controllers": True,
        "moveit_simple_controller_manager.controller_names": ["arm_controller"],
        "publish_planning_scene": True,
        "publish_geometry_updates": True,
        "publish_state_updates": True,
        "publish_transforms_updates": True,
        "publish_robot_description": False,
        "publish_robot_description_semantic": False,
        "robot_description_planning.joint_limits.a.max_velocity": 1.5,
    }


def test_what_setup_assistant_says(asked: Asked, tmp_path: Path) -> None:
    said = (
        "moveit_setup_assistant_config:\n  URDF: {package: arm_moveit_config, relative_path: my.urdf}\n  SRDF: {relative_path: my.srdf}\n"
    )
    found = asked(
        f"made = {BUILT}\n    return LaunchDescription([Node(package='arm_moveit_config', executable='drive', "
        "arguments=[str(made.package_path)], parameters=[{**made.robot_description, **made.robot_description_semantic}])])",
        without="config/arm.urdf.xacro",
        more={".setup_assistant": said, "my.urdf": "<robot/>", "my.srdf": "<robot/>"},
    )
    assert params(found) == {
        "robot_description": f"$(xacro {tmp_path}/arm/my.urdf)",
        "robot_description_semantic": f"$(xacro {tmp_path}/arm/my.srdf)",
    }
    assert found["nodes"][0]["arguments"] == [str(tmp_path / "arm")]


@pytest.mark.parametrize(
    ("without", "told"),
    [
        ("config/kinematics.yaml", True),
        ("config/joint_limits.yaml", True),
        ("config/arm.srdf", True),
        ("config/arm.urdf.xacro", False),
        ("config/moveit_controllers.yaml", False),
    ],
)
def test_a_file_that_is_missing(without: str, told: bool, asked: Asked) -> None:
    found = asked(
        ALL.format(BUILT),
        without=without,
    )
    assert found["verdict"] == ("error" if told else "ok"), found
    if told:
        assert "ends with an exception: ParameterBuilderFileNotFoundError: File /" in found["error"]["message"]
        assert DIRECTORY not in json.dumps(found)  # the place is that of the call in the launch file


def test_pipelines_that_the_library_brings_are_not_known(asked: Asked) -> None:
    found = asked(
        ALL.format("MoveItConfigsBuilder('arm')"),
    )
    assert found["verdict"] == "ok"
    assert found["python"][0]["reasons"] == [
        {"line": 8, "reason": "what is in the planning pipelines that moveit_configs_utils brings depends on its version"}
    ]


def test_two_files_of_controllers_and_none_that_is_meant(asked: Asked) -> None:
    found = asked(
        ALL.format(BUILT),
        without="config/moveit_controllers.yaml",
        more={"config/a_controllers.yaml": "a: 1\n", "config/b_controllers.yaml": "b: 1\n"},
    )
    assert found["verdict"] == "error"
    assert "Unable to guess" in found["error"]["message"]


def test_move_group_is_started_in_two_ways(asked: Asked, tmp_path: Path) -> None:
    found = asked(f"return launches.generate_move_group_launch({BUILT})")
    (node,) = found["nodes"]
    assert (node["package"], node["executable"], node["output"]) == ("moveit_ros_move_group", "move_group", "screen")
    assert node["conditions"] == [["unless", "False"]]
    assert [each["name"] for each in found["args"]] == [
        "debug",
        "allow_trajectory_execution",
        "publish_monitored_planning_scene",
        "capabilities",
        "disable_capabilities",
        "monitor_dynamics",
    ]


def test_controllers_are_spawned_by_their_names(asked: Asked) -> None:
    found = asked(f"return launches.generate_spawn_controllers_launch({BUILT})")
    assert [each["arguments"] for each in found["nodes"]] == [["arm_controller"], ["joint_state_broadcaster"]]


@pytest.mark.parametrize(("distro", "count"), [("humble", 2), ("jazzy", 1)])
def test_what_a_distribution_does_otherwise(distro: str, count: int, asked: Asked) -> None:
    included = {
        f"launch/{name}.launch.py": "from launch import LaunchDescription\n\n\ndef generate_launch_description():\n    "
        "return LaunchDescription([])\n"
        for name in ("rsp", "move_group", "moveit_rviz", "warehouse_db", "spawn_controllers")
    }
    more = {**included, "config/ros2_controllers.yaml": "/**: {ros__parameters: {a: 1}}\n"}
    (node,) = asked(f"return launches.generate_demo_launch({BUILT})", distro=distro, more=more)["nodes"]
    assert node["executable"] == "ros2_control_node"
    assert len(node["params"]) == count


def test_params_that_are_collected_one_after_the_other(asked: Asked, tmp_path: Path) -> None:
    body = (
        "made = ParameterBuilder('arm_moveit_config').yaml('config/kinematics.yaml', 'deep').parameter('rate', 5)"
        ".path_parameter('file', 'config/arm.srdf').file_parameter('text', 'config/arm.srdf').to_dict()\n"
        "    return LaunchDescription([Node(package='arm_moveit_config', executable='drive', parameters=[made])])"
    )
    assert params(asked(body)) == {
        "deep.arm.kinematics_solver": "kdl",
        "rate": 5,
        "file": f"{tmp_path}/arm/config/arm.srdf",
        "text": "<robot/>",
    }


def test_the_source_in_the_workspace_comes_first(asked: Asked) -> None:
    own = (
        "launches = None\n\n\nclass MoveItConfigsBuilder:\n    def __init__(self, name):\n        pass\n\n"
        "    def to_dict(self):\n        return {'own': 1}\n"
    )
    body = ALL.format("MoveItConfigsBuilder('arm')")
    more = {"../moveit/package.xml": PACKAGE.replace("arm_moveit_config", "moveit_configs_utils")}
    assert "'own'" not in str(asked(body, more=more)["nodes"])  # a package without its source: the model
    assert params(asked(body, more={**more, "../moveit/moveit_configs_utils/__init__.py": own})) == {"own": 1}


def test_every_model_is_read() -> None:
    files = {path.name for path in Path(DIRECTORY).iterdir()}
    names = {path.removesuffix(".model") for path in files}
    assert {model_of(name) for name in names} == {DIRECTORY + file for file in files}
