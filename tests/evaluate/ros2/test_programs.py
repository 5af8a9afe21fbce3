"""Launch files in Python, executed: functions that launch calls, events, includes all ways, and what is known only in part."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest

from launchlint.evaluate.problems import UndeclaredArg
from launchlint.evaluate.ros2.launch import evaluate
from launchlint.model import Launch
from launchlint.report.launched import as_object
from tests.evaluate.ros2.launching import Workspace

HEAD = """import os
from launch import LaunchDescription, LaunchContext
from launch.actions import *
from launch.conditions import *
from launch.event_handlers import *
from launch.launch_description_sources import *
from launch.substitutions import *
from launch_ros.actions import *
from launch_ros.descriptions import ComposableNode


def node(name):
    return Node(package='pk', executable='e', name=name)


"""


def launched(tmp_path: Path, body: str, files: dict[str, str] | None = None, **given: str) -> Launch:
    """The launch of ``main.launch.py``, whose module ends with ``body``."""
    workspace = Workspace(tmp_path, "", {"main.launch.py": HEAD + body, **(files or {})})
    session = workspace.session()
    return evaluate(session, str(workspace.launch_files / "main.launch.py"), tuple(given.items())).launch


def described(items: str, before: str = "") -> str:
    return f"{before}\ndef generate_launch_description():\n    return LaunchDescription([{items}])\n"


def names(launch: Launch) -> list[str]:
    return [node.name for node in launch.nodes]


def test_a_function_is_called_with_the_context(tmp_path: Path) -> None:
    before = (
        "def setup(context, prefix, *, end):\n"
        "    count = int(LaunchConfiguration('count').perform(context))\n"
        "    context.launch_configurations['told'] = 'yes'\n"
        "    return [node(prefix + str(n) + context.launch_configurations['x'] + end) for n in range(count)]\n"
    )
    items = (
        "DeclareLaunchArgument('count', default_value='2'), SetLaunchConfiguration('x', 'y'),"
        "OpaqueFunction(function=setup, args=['a'], kwargs={'end': 'z'}), node(LaunchConfiguration('told'))"
    )
    launch = launched(tmp_path, described(items, before))
    assert names(launch) == ["a0yz", "a1yz", "yes"]
    assert (launch.complete, launch.refused) == (True, None)
    assert names(launched(tmp_path / "again", described(items, before), count="1")) == ["a0yz", "yes"]


def test_what_a_function_changes_stays_for_one_launch(tmp_path: Path) -> None:
    before = "made = []\ndef add(context):\n    made.append('n' + str(len(made)))\n    return [node(made[-1])]\n"
    workspace = Workspace(
        tmp_path, "", {"main.launch.py": HEAD + described("OpaqueFunction(function=add), OpaqueFunction(function=add)", before)}
    )
    session = workspace.session()
    for _ in range(2):
        launch = evaluate(session, str(workspace.launch_files / "main.launch.py")).launch
        assert names(launch) == ["n0", "n1"]


def test_a_condition_is_asked_in_a_function(tmp_path: Path) -> None:
    before = (
        "def setup(context):\n    if IfCondition(LaunchConfiguration('x')).evaluate(context):\n"
        "        return [node('a')]\n    return [node('b')]\n"
    )
    items = "DeclareLaunchArgument('x', default_value='true'), OpaqueFunction(function=setup)"
    assert names(launched(tmp_path, described(items, before))) == ["a"]
    assert names(launched(tmp_path / "again", described(items, before), x="false")) == ["b"]


def test_launch_stops_at_what_a_function_asks(tmp_path: Path) -> None:
    before = "def setup(context):\n    LaunchConfiguration('x').perform(context)\n"
    launch = launched(tmp_path, described("OpaqueFunction(function=setup)", before))
    assert isinstance(launch.refused, UndeclaredArg)
    assert launch.refused.place.text.startswith("LaunchConfiguration")


@pytest.mark.parametrize(
    ("handler", "kind"),
    [
        ("OnProcessExit(target_action=n, on_exit=[m])", "OnProcessExit"),
        ("OnProcessStart(target_action=n, on_start=lambda event, context: [m])", "OnProcessStart"),
        ("OnShutdown(on_shutdown=m)", "OnShutdown"),
        ("OnProcessIO(target_action=n, on_stdout=lambda event: m)", "OnProcessIO"),
    ],
)
def test_events_lead_to_actions_later(handler: str, kind: str, tmp_path: Path) -> None:
    body = (
        f"def generate_launch_description():\n    n = node('n')\n    m = node(LaunchConfiguration('x'))\n"
        f"    return LaunchDescription([RegisterEventHandler({handler}), n, SetLaunchConfiguration('x', 'late')])\n"
    )
    launch = launched(tmp_path, body)
    assert [(node.name, node.deferred) for node in launch.nodes] == [("n", None), ("late", kind)]


@pytest.mark.parametrize(
    ("condition", "taken"),
    [
        ("LaunchConfigurationEquals('x', '1')", True),
        ("LaunchConfigurationEquals('x', '2')", False),
        ("LaunchConfigurationEquals('y', None)", True),
        ("LaunchConfigurationEquals('y', '1')", False),
        ("LaunchConfigurationNotEquals('x', '2')", True),
        ("LaunchConfigurationNotEquals('x', LaunchConfiguration('x'))", False),
    ],
)
def test_comparing_conditions(condition: str, taken: bool, tmp_path: Path) -> None:
    items = f"SetLaunchConfiguration('x', '1'), GroupAction([node('n')], condition={condition})"
    assert names(launched(tmp_path, described(items))) == (["n"] if taken else [])


XML = "<launch>\n<arg name='who'/>\n<node pkg='pk' exec='e' name='$(var who)'/>\n</launch>\n"
YAML = "launch:\n- arg: {name: who}\n- node: {pkg: pk, exec: e, name: $(var who)}\n"
PYTHON = HEAD + described("DeclareLaunchArgument('who'), node(LaunchConfiguration('who'))")


@pytest.mark.parametrize(("file", "text"), [("a.launch.xml", XML), ("a.launch.yaml", YAML), ("a.launch.py", PYTHON)])
@pytest.mark.parametrize("passed", ["{'who': 'me'}.items()", "[('who', 'me')]", "(('who', ['m', 'e']),)"])
def test_a_program_includes_what_there_is(file: str, text: str, passed: str, tmp_path: Path) -> None:
    source = f"AnyLaunchDescriptionSource(os.path.join(os.path.dirname(__file__), '{file}'))"
    items = f"IncludeLaunchDescription({source}, launch_arguments={passed}), LogInfo(msg=LaunchConfiguration('who'))"
    launch = launched(tmp_path, described(items), {file: text})
    assert (names(launch), launch.refused, launch.complete) == (["me"], None, True)


@pytest.mark.parametrize("yaml", [False, True])
def test_what_a_program_sets_is_seen_by_who_includes_it(yaml: bool, tmp_path: Path) -> None:
    setter = HEAD + described("SetLaunchConfiguration('x', 'set'), SetEnvironmentVariable('E', 'there'), PushROSNamespace('ns')")
    node = "<node pkg='pk' exec='e' name='$(var x)_$(env E)'/>"
    files = {"a.launch.py": setter}
    body = f"<include file='$(dirname)/a.launch.py'/>{node}"
    if yaml:
        files["b.launch.yaml"] = "launch:\n- include: {file: $(dirname)/a.launch.py}\n- node: {pkg: pk, exec: e, name: $(var x)_$(env E)}\n"
        body = "<include file='$(dirname)/b.launch.yaml'/>"
    launch = Workspace(tmp_path, body, files).launch()
    assert [node.full_name for node in launch.nodes] == ["/ns/set_there"]
    assert launch.complete


def told(tmp_path: Path, body: str) -> dict[str, Any]:
    return as_object(launched(tmp_path, "import other\n" + body), "main.launch.py", None)


def test_what_is_not_known_is_said_in_the_model(tmp_path: Path) -> None:
    model = told(tmp_path, described("node(other.name()), node('n'), other.action()"))
    first, second = model["nodes"]
    assert first["name"] == {"unknown": "other.name is not looked into"}
    assert second["name"] == "n"
    assert (model["complete"], model["verdict"], model["declared"]) == (False, "unknown", None)
    (python,) = model["python"]
    assert python["state"] == "partly"
    assert {each["reason"] for each in python["reasons"]} >= {"other.name is not looked into", "other.action is not looked into"}


def test_what_may_be_there(tmp_path: Path) -> None:
    body = "def generate_launch_description():\n    ld = LaunchDescription([node('a')])\n"
    body += "    if other.asks():\n        ld.add_action(SetLaunchConfiguration('x', '1'))\n        ld.add_action(node('b'))\n"
    body += "    ld.add_action(node(LaunchConfiguration('x', default='c')))\n    return ld\n"
    model = told(tmp_path, body)
    assert [each.get("maybe", False) for each in model["nodes"]] == [False, True, False]
    assert model["nodes"][2]["name"] == {"unknown": "other.asks()"}
    assert model["complete"]


def test_a_condition_of_its_own_is_not_known(tmp_path: Path) -> None:
    model = told(tmp_path, described("Node(package='pk', executable='e', name='n', condition=other.Asking())"))
    (node,) = model["nodes"]
    assert (node["maybe"], node["conditions"]) == (True, {"unknown": "other.Asking is not looked into"})


def test_what_a_program_sets_while_it_is_loaded_is_there_from_the_beginning(tmp_path: Path) -> None:
    setter = HEAD + described("", "os.environ['E'] = 'early'\n")
    items = "node(EnvironmentVariable('E')), IncludeLaunchDescription(os.path.dirname(__file__) + '/a.launch.py')"
    launch = launched(tmp_path, described(items), {"a.launch.py": setter})
    assert names(launch) == ["early"]


def test_a_container_as_an_object(tmp_path: Path) -> None:
    body = (
        "def generate_launch_description():\n"
        "    box = ComposableNodeContainer(package='pk', executable='e', name='box', namespace='in')\n"
        "    part = ComposableNode(package='pk', plugin='P', name='p')\n"
        "    load = LoadComposableNodes(target_container=box, composable_node_descriptions=[part])\n"
        "    return LaunchDescription([PushROSNamespace('ns'), box, load])\n"
    )
    launch = launched(tmp_path, body)
    assert [(node.name, node.container) for node in launch.nodes] == [("box", None), ("p", "/ns/in/box")]


def test_a_context_that_a_program_makes_itself_knows_what_every_launch_knows(tmp_path: Path) -> None:
    body = (
        "def generate_launch_description():\n    fresh = LaunchContext()\n"
        "    name = EnvironmentVariable('USER').perform(fresh) + LaunchConfiguration('x', default='_y').perform(fresh)\n"
        "    return LaunchDescription([node(name)])\n"
    )
    launch = launched(tmp_path, body)
    assert (names(launch), launch.refused) == (["somebody_y"], None)


def test_a_context_that_a_program_makes_itself_has_no_configurations(tmp_path: Path) -> None:
    body = "def generate_launch_description():\n    return LaunchDescription([node(LaunchConfiguration('x').perform(LaunchContext()))])\n"
    assert isinstance(launched(tmp_path, body).refused, UndeclaredArg)


@pytest.mark.parametrize(
    "items",
    [
        "GroupAction(node(each) for each in ('a', 'b'))",
        "GroupAction(made())",
        "TimerAction(period=1.0, actions=(node(each) for each in 'ab'))",
        "GroupAction(map(node, ['a', 'b']))",
        "OpaqueFunction(function=lambda context: made())",
        "OpaqueFunction(function=lambda context: (node(each) for each in 'ab'))",
    ],
)
def test_launch_takes_all_that_a_generator_gives(items: str, tmp_path: Path) -> None:
    launch = launched(tmp_path, described(items, "def made():\n    for each in 'ab':\n        yield node(each)\n"))
    assert (names(launch), launch.complete, launch.settled) == (["a", "b"], True, True)


def test_a_generator_gives_the_args_of_an_include(tmp_path: Path) -> None:
    before = "def made():\n    yield 'name', 'passed'\n"
    include = "IncludeLaunchDescription(os.path.join(os.path.dirname(__file__), 'other.launch.xml'), launch_arguments=made())"
    other = '<launch><arg name="name" default="own"/><node pkg="pk" exec="e" name="$(var name)"/></launch>'
    assert names(launched(tmp_path, described(include, before), {"other.launch.xml": other})) == ["passed"]


def test_a_function_is_followed_however_often_launches_have_called_it(tmp_path: Path) -> None:
    before = "def one(context):\n    return [node('n' + str(sum(range(2000)) + sum(n for n in range(2000))))]\n"
    workspace = Workspace(tmp_path, "", {"main.launch.py": HEAD + described("OpaqueFunction(function=one)", before)})
    session = workspace.session()
    for _ in range(6):
        assert evaluate(session, str(workspace.launch_files / "main.launch.py")).launch.complete


SHARE = "from ament_index_python.packages import get_package_share_directory\n"


@pytest.mark.parametrize("asked", ["get_package_share_directory('nowhere')", "os.environ['NOWHERE']", "context.environment['NOWHERE']"])
def test_behind_what_is_not_here_a_function_goes_on(tmp_path: Path, asked: str) -> None:
    before = f"{SHARE}def setup(context):\n    asked = {asked}\n    return [node('first'), node(asked + '_second')]\n"
    launch = launched(tmp_path, described("OpaqueFunction(function=setup), node('third')", before))
    first, second, third = launch.nodes
    assert (first.name, third.name) == ("first", "third")
    assert "name" in second.unknown
    assert launch.refused is not None
    assert launch.refused.kind == ("package-not-found" if "share" in asked else "env-unset")
    assert launch.refused.place.text == asked


def test_launch_stops_at_what_is_not_here_before_it_executes_anything(tmp_path: Path) -> None:
    before = f"{SHARE}WHERE = get_package_share_directory('nowhere')\n"
    launch = launched(tmp_path, described("node('a'), LogInfo(msg=LaunchConfiguration('nothing'))", before))
    assert names(launch) == ["a"]
    assert [problem.kind for problem in launch.problems if problem.refused] == ["package-not-found", "undeclared-arg"]
    assert launch.refused is launch.problems[0]


@pytest.mark.parametrize("spelled", ["os.environ['ROS_DISTRO']", "os.environ.get('ROS_DISTRO')", "EnvironmentVariable('ROS_DISTRO')"])
def test_the_distribution_is_in_the_environment(tmp_path: Path, spelled: str) -> None:
    workspace = Workspace(tmp_path, "", {"main.launch.py": HEAD + described(f"node({spelled})")})
    launch = evaluate(workspace.session(distro="humble"), str(workspace.launch_files / "main.launch.py")).launch
    assert (names(launch), launch.refused) == (["humble"], None)
