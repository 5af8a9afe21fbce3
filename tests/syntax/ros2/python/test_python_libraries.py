"""Launch files in Python that use libraries around launch: nav2_common's substitutions, evaluated."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest

from launchlint.cli import main

PACKAGE = (
    '<package format="3"><name>robot</name><version>0.0.1</version><description>d</description>'
    '<maintainer email="a@b.c">m</maintainer><license>Apache-2.0</license></package>'
)
HEAD = """\
import os
from pathlib import Path
import yaml
from ament_index_python.packages import get_package_share_directory
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument, OpaqueFunction
from launch.conditions import IfCondition
from launch.substitutions import LaunchConfiguration
from launch_ros.actions import Node
from launch_ros.descriptions import ParameterFile
from nav2_common.launch import HasNodeParams, LaunchConfigAsBool, ReplaceString, RewrittenYaml

share = get_package_share_directory('robot')
params = os.path.join(share, 'params.yaml')


def node(**given):
    return Node(package='robot', executable='drive', name='drive', namespace='', **given)


def generate_launch_description():
"""
Asked = tuple[pytest.MonkeyPatch, pytest.CaptureFixture[str]]
PARAMS = "drive:\n  ros__parameters:\n    rate: 10\n    frame: <base>\n    deep: {er: 1}\nother:\n  ros__parameters: {rate: 20}\n"


@pytest.fixture
def asked(monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> Asked:
    return monkeypatch, capsys


def model(tmp_path: Path, body: str, asked: Asked, **files: str) -> dict[str, Any]:
    """What ``launchlint model`` says of a launch file."""
    (tmp_path / "launch").mkdir()
    (tmp_path / "package.xml").write_text(PACKAGE, encoding="utf-8")
    (tmp_path / "params.yaml").write_text(PARAMS, encoding="utf-8")
    for name, content in files.items():
        path = tmp_path / name.replace("__", "/")
        path.parent.mkdir(exist_ok=True)
        path.with_suffix(".py").write_text(content, encoding="utf-8")
    file = tmp_path / "launch" / "a.launch.py"
    file.write_text(HEAD + "".join(f"    {line}\n" for line in body.splitlines()), encoding="utf-8")
    monkeypatch, capsys = asked
    monkeypatch.setenv("ROS_DISTRO", "jazzy")
    main(["model", "--format", "jsonl", "--workspace", str(tmp_path), str(file)], standalone_mode=False)
    found: dict[str, Any] = json.loads(capsys.readouterr().out.splitlines()[0])
    return found


def test_yaml_that_is_rewritten(tmp_path: Path, asked: Asked) -> None:
    body = (
        "made = RewrittenYaml(source_file=params, root_key='', param_rewrites={'rate': LaunchConfiguration('rate'), "
        "'drive.ros__parameters.deep.er': '7'}, convert_types=True)\n"
        "return LaunchDescription([DeclareLaunchArgument('rate', default_value='30'), "
        "node(parameters=[ParameterFile(made, allow_substs=True)])])"
    )
    (found,) = model(tmp_path, body, asked)["nodes"]
    assert found["params"][0]["content"]["drive"]["ros__parameters"] == {"rate": 30, "frame": "<base>", "deep": {"er": 7}}
    assert found["params"][0]["content"]["other"]["ros__parameters"] == {"rate": 30}


def test_texts_that_are_replaced(tmp_path: Path, asked: Asked) -> None:
    body = "return LaunchDescription([node(parameters=[ReplaceString(source_file=params, replacements={'<base>': 'a'})])])"
    (found,) = model(tmp_path, body, asked)["nodes"]
    assert found["params"][0]["content"]["drive"]["ros__parameters"]["frame"] == "a"


@pytest.mark.parametrize(("value", "count"), [("yes", 1), ("1", 1), ("off", 0)])
def test_a_configuration_as_a_truth_value(value: str, count: int, tmp_path: Path, asked: Asked) -> None:
    body = (
        f"return LaunchDescription([DeclareLaunchArgument('on', default_value='{value}'), "
        "node(condition=IfCondition(LaunchConfigAsBool('on')))])"
    )
    assert len(model(tmp_path, body, asked)["nodes"]) == count


def test_whether_a_file_has_params_of_a_node(tmp_path: Path, asked: Asked) -> None:
    body = "return LaunchDescription([node(arguments=[HasNodeParams(params, 'drive'), HasNodeParams(params, 'none')])])"
    (found,) = model(tmp_path, body, asked)["nodes"]
    assert found["arguments"] == ["True", "False"]


def test_a_file_of_the_workspace_is_read(tmp_path: Path, asked: Asked) -> None:
    body = (
        "with open(Path(share) / 'params.yaml') as stream:\n"
        "    rate = yaml.safe_load(stream)['drive']['ros__parameters']['rate']\n"
        "return LaunchDescription([node(arguments=[str(rate), Path(params).stem, str(os.path.exists(params))])])"
    )
    (found,) = model(tmp_path, body, asked)["nodes"]
    assert found["arguments"] == ["10", "params", "True"]


def test_a_file_outside_of_the_workspace_is_not(tmp_path: Path, asked: Asked) -> None:
    body = "return LaunchDescription([node(arguments=[open('/etc/hostname').read()])])"
    (found,) = model(tmp_path, body, asked)["nodes"]
    assert "unknown" in str(found["arguments"])


def test_modules_of_packages_are_followed(tmp_path: Path, asked: Asked) -> None:
    module = (
        "from launch_ros.actions import Node\n\n\ndef twice(name):\n    return [Node(package='robot', executable=name) for _ in range(2)]\n"
    )
    body = "from robot.making import twice\nreturn LaunchDescription(twice('spin'))"
    found = model(tmp_path, body, asked, robot____init__="", robot__making=module)["nodes"]
    assert [each["executable"] for each in found] == ["spin", "spin"]


@pytest.mark.parametrize(
    ("substitution", "said"),
    [
        ("AnySubstitution('false', 'on')", "true"),
        ("AnySubstitution('false', LaunchConfiguration('off'))", "false"),
        ("AnySubstitution()", "false"),
        ("AllSubstitution()", "true"),
        ("AllSubstitution('1', 'True', LaunchConfiguration('off'))", "false"),
        ("AllSubstitution('true', 'yes')", "true"),
    ],
)
def test_any_and_all(substitution: str, said: str, tmp_path: Path, asked: Asked) -> None:
    body = (
        "from launch.substitutions import AllSubstitution, AnySubstitution\n"
        f"return LaunchDescription([DeclareLaunchArgument('off', default_value='false'), node(arguments=[{substitution}])])"
    )
    found = model(tmp_path, body, asked)
    assert (found["verdict"], found["nodes"][0]["arguments"]) == ("ok", [said])


def test_all_configurations_are_forgotten_but_those_that_are_kept(tmp_path: Path, asked: Asked) -> None:
    body = (
        "from launch.actions import ResetLaunchConfigurations\n"
        "a, b = LaunchConfiguration('a', default='-'), LaunchConfiguration('b', default='-')\n"
        "return LaunchDescription([DeclareLaunchArgument('a', default_value='1'), DeclareLaunchArgument('b', default_value='2'),\n"
        "    ResetLaunchConfigurations({'b': [b, 'x']}), node(arguments=[a, b]), ResetLaunchConfigurations(), node(arguments=[a, b])])"
    )
    found = model(tmp_path, body, asked)
    assert found["verdict"] == "ok"
    assert [each["arguments"] for each in found["nodes"]] == [["-", "2x"], ["-", "-"]]


def test_actions_that_start_nothing_leave_a_file_wholly_known(tmp_path: Path, asked: Asked) -> None:
    body = (
        "from launch.actions import OpaqueCoroutine\nfrom launch_ros.actions import LifecycleTransition, SetROSLogDir\n"
        "from launch_testing.actions import ReadyToTest\n"
        "async def wait(context):\n    pass\n"
        "return LaunchDescription([node(), LifecycleTransition(lifecycle_node_names=['drive'], transition_ids=[1]),\n"
        "    SetROSLogDir('logs'), OpaqueCoroutine(coroutine=wait), ReadyToTest()])"
    )
    found = model(tmp_path, body, asked)
    assert (found["verdict"], found["complete"], [each["state"] for each in found["python"]]) == ("ok", True, ["resolved"])
