"""``export --flatten`` of launch files of ROS 2: what goes in, and the whole file that comes out."""

from __future__ import annotations

from pathlib import Path

import pytest

from launchlint.evaluate.session import Session
from launchlint.export.ros2 import flattening
from launchlint.export.ros2.flattening import Flat, flatten, language_of
from launchlint.export.written import CannotExport
from launchlint.fix.format.style import Style
from launchlint.workspace.packages import Packages
from tests.export.ros2.converting import PACKAGE, VARIABLES

BASE = """\
<launch>
  <!-- what it is asked for -->
  <arg name="port"/>
  <!-- it turns -->
  <node pkg="demo" exec="wheels" args="--port $(var port)"/>
  <!-- the end of the base -->
</launch>
"""


def flat(directory: Path, files: dict[str, str], *given: str, language: str = "", **variables: str) -> Flat:
    """The first of ``files`` as one file."""
    (directory / "demo/launch").mkdir(parents=True)
    (directory / "demo/package.xml").write_text(PACKAGE)
    for name, text in files.items():
        (directory / "demo/launch" / name).write_text(text, encoding="utf-8")
    file = str(directory / "demo/launch" / next(iter(files)))
    environment = {**VARIABLES, **variables}
    session = Session(Packages([str(directory)], environment, explicit=True), environment, str(directory), distro="jazzy")
    pairs = tuple((key, value) for key, _, value in (each.partition(":=") for each in given))
    return flatten(session, file, pairs, Style(), language or language_of(file))


def inside(result: Flat) -> str:
    """The flat file without its first and last line and the comment that says where it comes from."""
    lines = result.data.decode().splitlines()
    assert lines[1].startswith("  <!-- Flattened by launchlint from ")
    return "\n".join(line[2:] for line in lines[3:-1])


ROBOT = """\
<launch>
  <!-- The whole robot. -->

  <!-- which one -->
  <arg name="name" default="r1"/>
  <arg name="sim" default="false"/>
  <!-- wheels first -->
  <group>
    <push_ros_namespace namespace="$(var name)"/>
    <include file="$(find-pkg-share demo)/launch/base.launch.xml">
      <arg name="port" value="/dev/$(var name)"/>
    </include>
    <node pkg="demo" exec="arm"/>
  </group>
  <group>
    <let name="rate" value="5"/>
    <node pkg="demo" exec="planner" name="planner"> <!-- beside -->
      <!-- the goal -->
      <remap from="goal" to="/goal"/>
      <param name="map" value="$(dirname)/maps/$(var name).yaml"/>
      <param name="rate" value="$(var rate)"/>
      <param name="level" value="$(env LEVEL info)"/>
    </node>
  </group>
  <node pkg="demo" exec="drive" unless="$(var sim)"/> <!-- the driver -->
  <!-- the simulator -->
  <node pkg="demo" exec="simulate" if="$(var sim)"/> <!-- slow -->
  <timer period="$(eval '1 + 2')">
    <node pkg="demo" exec="late" args="--of $(var name) 'a b'"/>
  </timer>
  <!-- at the end -->
</launch>
"""


def test_a_robot(tmp_path: Path) -> None:
    result = flat(tmp_path, {"robot.launch.xml": ROBOT, "base.launch.xml": BASE})
    assert (
        result.data.decode()
        == """\
<launch>
  <!-- Flattened by launchlint from robot.launch.xml. -->

  <!-- The whole robot. -->

  <!-- wheels first -->
  <group>
    <push_ros_namespace namespace="r1"/>
    <!-- from demo/launch/base.launch.xml -->
    <!-- it turns -->
    <node pkg="demo" exec="wheels" args="--port /dev/r1"/>
    <!-- the end of the base -->

    <!-- back in demo/launch/robot.launch.xml -->
    <node pkg="demo" exec="arm"/>
  </group>
  <node name="planner" pkg="demo" exec="planner"> <!-- beside -->
    <!-- the goal -->
    <remap from="goal" to="/goal"/>
    <param name="map" value="$(find-pkg-share demo)/launch/maps/r1.yaml"/>
    <param name="rate" value="5"/>
    <param name="level" value="$(env LEVEL info)"/>
  </node>
  <node pkg="demo" exec="drive"/> <!-- the driver -->
  <timer period="3.0">
    <node pkg="demo" exec="late" args="--of r1 'a b'"/>
  </timer>
  <!-- at the end -->
</launch>
"""
    )
    assert result[1:] == ((), (), ())


def test_a_robot_in_yaml(tmp_path: Path) -> None:
    result = flat(tmp_path, {"robot.launch.xml": ROBOT, "base.launch.xml": BASE}, "sim:=true", language="yaml")
    assert (
        result.data.decode()
        == """\
launch:
# Flattened by launchlint from robot.launch.xml, started with sim:=true.

# The whole robot.

# wheels first
- group:
  - push_ros_namespace:
      namespace: r1
  # from demo/launch/base.launch.xml
  # it turns
  - node:
      pkg: demo
      exec: wheels
      args: --port /dev/r1
  # the end of the base

  # back in demo/launch/robot.launch.xml
  - node:
      pkg: demo
      exec: arm
- node:  # beside
    name: planner
    pkg: demo
    exec: planner
    remap:
    # the goal
    - from: goal
      to: /goal
    param:
    - name: map
      value: $(find-pkg-share demo)/launch/maps/r1.yaml
    - name: rate
      value: 5
    - name: level
      value: $(env LEVEL info)
# the simulator
- node:  # slow
    pkg: demo
    exec: simulate
- timer:
    period: 3.0
    children:
    - node:
        pkg: demo
        exec: late
        args: --of r1 'a b'
# at the end
"""
    )


IN_YAML = """\
launch:
# what it is called
- arg:
    name: name
    default: r1
# gone with its node
- node:
    pkg: demo
    exec: never
    if: "false"
- group:
  - let: {name: speed, value: "3"}
  # kept
  - node:
      pkg: demo
      exec: $(var name)
- include:
    file: $(dirname)/base.launch.xml
    arg:
    - name: port
      value: $(var name)
"""


def test_from_yaml_with_an_include_in_xml(tmp_path: Path) -> None:
    result = flat(tmp_path, {"a.launch.yaml": IN_YAML, "base.launch.xml": BASE})
    assert (
        result.data.decode()
        == """\
launch:
# Flattened by launchlint from a.launch.yaml.

# kept
- node:
    pkg: demo
    exec: r1
# from demo/launch/base.launch.xml
# it turns
- node:
    pkg: demo
    exec: wheels
    args: --port r1
# the end of the base
"""
    )


@pytest.mark.parametrize(
    ("given", "expected"),
    [
        # what launch reads itself stays a launch configuration
        (
            '<let name="launch-prefix" value="nice -n 5"/>\n<node pkg="demo" exec="a"/>',
            '<let name="launch-prefix" value="nice -n 5"/>\n<node pkg="demo" exec="a"/>',
        ),
        # a group that keeps something to itself stays, the one inside does not
        (
            '<group><group><let name="x" value="1"/><node pkg="demo" exec="a$(var x)"/></group><set_env name="A" value="1"/></group>',
            '<group>\n  <node pkg="demo" exec="a1"/>\n  <set_env name="A" value="1"/>\n</group>',
        ),
        # a group that forgets what is in force stays
        (
            '<push_ros_namespace namespace="a"/>\n<group forwarding="false"><node pkg="demo" exec="a"/></group>',
            '<push_ros_namespace namespace="a"/>\n<group forwarding="false">\n  <node pkg="demo" exec="a"/>\n</group>',
        ),
        ('<group forwarding="false"><node pkg="demo" exec="a"/></group>', '<node pkg="demo" exec="a"/>'),
        # a set_remap leaks out of a group that it is made in
        (
            '<set_remap from="a" to="b"/>\n<group><set_remap from="c" to="d"/></group>\n<node pkg="demo" exec="a"/>',
            '<set_remap from="a" to="b"/>\n<group>\n  <set_remap from="c" to="d"/>\n</group>\n<node pkg="demo" exec="a"/>',
        ),
        # a list that was the text of an arg, and texts that look like something else
        (
            (
                '<arg name="l" default="[1, 2]"/>\n<arg name="t" default="1e3"/>\n'
                '<node pkg="demo" exec="a"><param name="l" value="$(var l)"/><param name="t" value="$(var t)" type="str"/></node>'
            ),
            '<node pkg="demo" exec="a">\n  <param name="l" value="[1, 2]"/>\n  <param name="t" type="str" value="1e3"/>\n</node>',
        ),
        # made-up names, of one ID in two groups, too
        (
            (
                '<arg name="n" default="$(anon n)"/>\n<node pkg="demo" exec="a" name="$(var n)"/>\n'
                '<group><node pkg="demo" exec="a" name="$(anon m)"/></group>\n<group><node pkg="demo" exec="a" name="$(anon m)"/></group>'
            ),
            (
                '<node name="$(anon n)" pkg="demo" exec="a"/>\n<group>\n  <node name="$(anon m)" pkg="demo" exec="a"/>\n</group>\n'
                '<group>\n  <node name="$(anon m)" pkg="demo" exec="a"/>\n</group>'
            ),
        ),
        # what a command says is not known, and handed on
        (
            '<arg name="d" default="$(command \'c $(dirname)/a\')"/>\n<node pkg="demo" exec="a"><param name="d" value="$(var d)"/></node>',
            '<node pkg="demo" exec="a">\n  <param name="d" value="$(command \'c $(find-pkg-share demo)/launch/a\')"/>\n</node>',
        ),
        # only the side that is taken is written
        (
            '<arg name="a" default="1"/>\n<node pkg="demo" exec="a" args="$(if $(var a) $(env X x) $(var nothing))"/>',
            '<node pkg="demo" exec="a" args="$(env X x)"/>',
        ),
        # $(dirname) is that of the file that was included last
        (
            (
                '<include file="$(dirname)/base.launch.xml"><arg name="port" value="1"/></include>\n'
                '<node pkg="demo" exec="a" cwd="$(filename)"/>'
            ),
            (
                '<!-- from demo/launch/base.launch.xml -->\n<!-- it turns -->\n<node pkg="demo" exec="wheels" args="--port 1"/>\n'
                "<!-- the end of the base -->\n\n<!-- back in demo/launch/a.launch.xml -->\n"
                '<node pkg="demo" exec="a" cwd="$(find-pkg-share demo)/launch/base.launch.xml"/>'
            ),
        ),
    ],
)
def test_what_is_written(tmp_path: Path, given: str, expected: str) -> None:
    result = flat(tmp_path, {"a.launch.xml": f"<launch>\n{given}\n</launch>\n", "base.launch.xml": BASE})
    assert (inside(result), result.lost, result.fixed) == (expected, (), ())


def test_params_that_ask_for_args_find_them(tmp_path: Path) -> None:
    text = (
        '<launch>\n<arg name="rate" default="$(env RATE 3)"/>\n'
        '<node pkg="demo" exec="a"><param from="$(dirname)/p.yaml" allow_substs="true"/></node>\n</launch>\n'
    )
    result = flat(tmp_path, {"a.launch.xml": text, "p.yaml": "/**:\n  ros__parameters:\n    rate: $(var rate)\n"})
    assert inside(result) == (
        '<let name="rate" value="$(env RATE 3)"/>\n<node pkg="demo" exec="a">\n'
        '  <param from="$(find-pkg-share demo)/launch/p.yaml" allow_substs="true"/>\n</node>'
    )


def test_the_environment_that_decides_is_told(tmp_path: Path) -> None:
    text = (
        '<launch>\n<arg name="sim" default="$(env SIM false)"/>\n<node pkg="demo" exec="a" unless="$(var sim)"/>\n'
        '<node pkg="demo" exec="b" if="$(var sim)"/>\n</launch>\n'
    )
    result = flat(tmp_path, {"a.launch.xml": text})
    assert result.fixed == (
        "the environment variable SIM, not set here, since 2 conditions ask for it, the first in demo/launch/a.launch.xml:3",
    )
    assert f"<!-- Fixed: {result.fixed[0]} -->" in result.data.decode()


def test_a_variable_that_cannot_stay_open_says_what_it_says_here(tmp_path: Path) -> None:
    """What was read before it was changed is not what is read behind."""
    text = (
        '<launch>\n<arg name="a" default="$(env LEVEL)"/>\n<set_env name="LEVEL" value="9"/>\n'
        '<node pkg="demo" exec="a" args="$(var a) $(env LEVEL)"/>\n</launch>\n'
    )
    result = flat(tmp_path, {"a.launch.xml": text}, LEVEL="5")
    assert inside(result).splitlines()[-2:] == ['<set_env name="LEVEL" value="9"/>', '<node pkg="demo" exec="a" args="5 9"/>']


PROGRAM = """\
from launch import LaunchDescription
from launch.actions import *
from launch.event_handlers import *
from launch.substitutions import *
from launch_ros.actions import *


def more(context):
    return [Node(package="demo", executable=context.launch_configurations["n"] + str(i)) for i in range(2)]


def generate_launch_description():
    n = LaunchConfiguration("n")
    late = Node(package="demo", executable="late", name=n)
    return LaunchDescription([
        DeclareLaunchArgument("n", default_value="a"),
        OpaqueFunction(function=more),
        IncludeLaunchDescription("%s/part.launch.xml" % __file__.rsplit("/", 1)[0], launch_arguments={"m": ["x", n]}.items()),
        RegisterEventHandler(OnShutdown(on_shutdown=[late])),
    ])
"""


def test_a_program_with_all_that_its_functions_give(tmp_path: Path) -> None:
    part = '<launch>\n  <arg name="m"/>\n  <node pkg="demo" exec="$(var m)"/>\n</launch>\n'
    result = flat(tmp_path, {"a.launch.py": PROGRAM, "part.launch.xml": part}, "n:=b")
    lost = "an event handler: what follows an event (OnShutdown) cannot be said in XML and YAML"
    assert inside(result) == (
        '<node pkg="demo" exec="b0"/>\n<node pkg="demo" exec="b1"/>\n<!-- from demo/launch/part.launch.xml -->\n'
        f'<node pkg="demo" exec="xb"/>\n<!-- not carried over (line 19): {lost} -->'
    )
    assert [words for _, words in result.lost] == [lost]


def test_an_include_that_is_not_known_is_refused(tmp_path: Path) -> None:
    with pytest.raises(CannotExport) as refused:
        flat(tmp_path, {"a.launch.xml": '<launch>\n  <include file="$(command where)"/>\n</launch>\n'})
    assert refused.value.reason == "not all that demo/launch/a.launch.xml includes is known"


def test_nothing_is_written_that_was_not_proved(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(flattening, "text_of", lambda root, language, style: b'<launch><node pkg="demo" exec="b"/></launch>')
    monkeypatch.setattr(flattening, "require_same", lambda *given: None)
    with pytest.raises(CannotExport) as refused:
        flat(tmp_path, {"a.launch.xml": '<launch><node pkg="demo" exec="a"/></launch>'})
    assert refused.value.reason.startswith("the exported file would not start the same: node 1 would differ")


def test_a_text_that_doubles_and_doubles_is_refused(tmp_path: Path) -> None:
    doubling = '<let name="a" value="$(var a)$(var a)"/>\n' * 40
    text = f'<launch>\n<let name="a" value="0123456789"/>\n{doubling}<node pkg="demo" exec="a" args="$(var a)"/>\n</launch>\n'
    with pytest.raises(CannotExport) as refused:
        flat(tmp_path, {"a.launch.xml": text})
    assert refused.value.reason == "it includes more than can be written into one file"
