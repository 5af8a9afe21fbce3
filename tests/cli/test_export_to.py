"""``launchlint export --to``."""

from __future__ import annotations

from pathlib import Path

from tests.cli.running import run, write

IN_XML = """\
<launch>
  <!-- how fast -->
  <arg name="rate" default="5"/>
  <node pkg="demo" exec="talk.py" name="talker">
    <param name="rate" value="$(var rate)"/>
  </node>
</launch>
"""
IN_YAML = """\
launch:
# how fast
- arg:
    name: rate
    default: '5'
- node:
    name: talker
    pkg: demo
    exec: talk.py
    param:
    - name: rate
      value: $(var rate)
"""
IN_PYTHON = """\
from launch import LaunchDescription
from launch_ros.actions import Node
from launch.substitutions import LaunchConfiguration


def generate_launch_description():
    return LaunchDescription([Node(package="demo", executable="talk.py", name="talker", emulate_tty=LaunchConfiguration("tty"))])
"""
LOST = "emulate_tty: it takes true or false, and nothing that is computed"
ROS1 = '<launch>\n  <node name="talker" pkg="demo" type="talk.py"/>\n</launch>\n'


def test_xml_in_yaml_and_back(repository: Path) -> None:
    write(repository, {"demo/launch/robot.launch.xml": IN_XML})
    assert run(repository, "export", "demo/launch/robot.launch.xml", "--to", "yaml", "-o", "demo/launch/robot.launch.yaml") == (0, "", "")
    assert (repository / "demo/launch/robot.launch.yaml").read_text() == IN_YAML
    ran = run(repository, "export", "demo/launch/robot.launch.yaml", "--to", "xml")
    assert (ran.status, ran.errors) == (0, "")
    assert ran.output == IN_XML.replace('pkg="demo" exec="talk.py" name="talker"', 'name="talker" pkg="demo" exec="talk.py"')


def test_what_is_lost_is_told_with_its_place(repository: Path) -> None:
    write(repository, {"demo/launch/robot.launch.py": IN_PYTHON})
    ran = run(repository, "export", "demo/launch/robot.launch.py", "--to", "xml")
    assert (ran.status, ran.errors) == (
        0,
        f"launchlint: demo/launch/robot.launch.py:7:101: not carried over: {LOST}\n",
    )
    assert "<!-- not carried over (line 7): emulate_tty" in ran.output
    assert '<node name="talker" pkg="demo" exec="talk.py"/>' in ran.output


def test_what_cannot_be_told_without_running_it_is_not_written(repository: Path) -> None:
    write(repository, {"demo/launch/robot.launch.py": "import sys\nsys.exit(1)\n", "out.xml": "mine"})
    ran = run(repository, "export", "demo/launch/robot.launch.py", "--to", "xml", "-o", "out.xml")
    assert (ran.status, ran.output) == (1, "")
    assert "demo/launch/robot.launch.py is not converted" in ran.errors
    assert (repository / "out.xml").read_text() == "mine"


def test_a_file_that_launch_cannot_read_is_not_written(repository: Path) -> None:
    write(repository, {"demo/launch/robot.launch.xml": '<launch>\n  <node pkg="demo" exec="a"/>\n  <nod pkg="demo"/>\n</launch>\n'})
    ran = run(repository, "export", "demo/launch/robot.launch.xml", "--to", "yaml")
    assert (ran.status, ran.output) == (1, "")
    assert ran.errors.startswith("demo/launch/robot.launch.xml:3:4: error LL103 unknown-tag: ")
    assert ran.errors.endswith("launchlint: demo/launch/robot.launch.xml is not converted, since ros2 launch cannot read it\n")


def test_options_that_clash(repository: Path) -> None:
    write(repository, {"demo/launch/robot.launch": ROS1})
    said = {
        ("--from", "ros2"): "launchlint: --from goes with --to\n",
        ("--distro", "humble"): "launchlint: --distro goes with --to\n",
        ("--to", "xml", "--flatten"): (
            "launchlint: demo/launch/robot.launch is a launch file of ROS 1; --to with --flatten is for those of ROS 2\n"
        ),
        ("--to", "ros2", "--flatten"): (
            "launchlint: a launch file of ROS 1 is translated without --flatten: flatten it before, or what is written behind\n"
        ),
        ("--to", "yaml"): "launchlint: demo/launch/robot.launch is a launch file of ROS 1; say --from ros1 to have it translated\n",
    }
    assert {words: run(repository, "export", "demo/launch/robot.launch", *words).errors for words in said} == said


def test_flattened(repository: Path) -> None:
    text = '<launch>\n  <arg name="n" default="a"/>\n  <node pkg="demo" exec="$(var n)"/>\n</launch>\n'
    write(repository, {"demo/launch/robot.launch.xml": text})
    comment = "Flattened by launchlint from robot.launch.xml"
    ran = run(repository, "export", "demo/launch/robot.launch.xml", "--flatten", "n:=b")
    assert ran == (0, f'<launch>\n  <!-- {comment}, started with n:=b. -->\n\n  <node pkg="demo" exec="b"/>\n</launch>\n', "")
    ran = run(repository, "export", "demo/launch/robot.launch.xml", "--flatten", "--to", "yaml")
    assert ran == (0, f"launch:\n# {comment}.\n\n- node:\n    pkg: demo\n    exec: a\n", "")
    program = (
        "from launch import LaunchDescription\nfrom launch_ros.actions import Node\n\n\ndef generate_launch_description():\n"
        '    return LaunchDescription([Node(package="demo", executable="a", on_exit=[Node(package="demo", executable="b")])])\n'
    )
    write(repository, {"demo/launch/a.launch.py": program})
    ran = run(repository, "export", "demo/launch/a.launch.py", "--flatten")
    assert (ran.status, ran.errors) == (
        0,
        "launchlint: demo/launch/a.launch.py:6:77: not carried over: on_exit: only shutdown can follow the end of a process\n",
    )


def test_args_are_kept_for_ros1_only(repository: Path) -> None:
    write(repository, {"demo/launch/robot.launch.xml": '<launch>\n  <node pkg="demo" exec="a"/>\n</launch>\n'})
    ran = run(repository, "export", "demo/launch/robot.launch.xml", "--flatten", "--args-kept")
    assert (ran.status, ran.output) == (2, "")
    assert ran.errors.startswith("launchlint: --args-kept is for launch files of ROS 1: ")


def test_from_ros1(repository: Path) -> None:
    text = ROS1.replace("/>", ' machine="m"/>').replace("<launch>", '<launch>\n  <machine name="m" address="a"/>')
    write(repository, {"demo/launch/robot.launch": text})
    for words in (("--from", "ros1", "--to", "ros2"), ("--to", "ros2"), ("--from", "ros1", "--to", "xml")):
        ran = run(repository, "export", "demo/launch/robot.launch", *words)
        assert (ran.status, ran.errors.splitlines()) == (
            0,
            [
                f"launchlint: demo/launch/robot.launch:{place}: ROS 2 launch starts nothing on other machines"
                for place in ("2:3: not carried over: the machine m", "3:3: not carried over: machine")
            ],
        )
        assert '  <node name="talker" pkg="demo" exec="talk.py"/>\n' in ran.output
