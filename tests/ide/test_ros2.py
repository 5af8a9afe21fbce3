"""Every row of what an editor may ask, for each way to write a launch file of ROS 2: the same launch file, and the same answers."""

from __future__ import annotations

from pathlib import Path
from typing import NamedTuple

import pytest

from launchlint.ide import calls, drawing, hints, hover, navigation, outline
from launchlint.ide.drawing import Shown
from launchlint.ide.view import View
from launchlint.project.workspace import OpenWorkspace
from tests.ide.questions import view_of
from tests.server.workspace import PACKAGE2

PART = """<launch>
  <arg name="speed"/>
  <node pkg="turtlesim" exec="turtle_teleop_key" name="teleop">
    <param name="a" value="$(var speed)"/>
  </node>
</launch>
"""
XML = """<launch>
  <arg name="world" default="empty"/>
  <let name="where" value="$(var world)"/>
  <include file="$(find-pkg-share demo2)/launch/part.launch.xml">
    <arg name="speed" value="$(var world)"/>
  </include>
  <node pkg="turtlesim" exec="turtlesim_node" name="turtle">
    <param name="background_r" value="$(var where)"/>
    <remap from="turtle1/cmd_vel" to="/cmd_vel"/>
  </node>
</launch>
"""
YAML = """launch:
- arg:
    name: world
    default: empty
- let:
    name: where
    value: $(var world)
- include:
    file: $(find-pkg-share demo2)/launch/part.launch.xml
    arg:
    - name: speed
      value: $(var world)
- node:
    pkg: turtlesim
    exec: turtlesim_node
    name: turtle
    param:
    - name: background_r
      value: $(var where)
    remap:
    - from: turtle1/cmd_vel
      to: /cmd_vel
"""
PYTHON = """import os
from ament_index_python.packages import get_package_share_directory
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument, IncludeLaunchDescription, SetLaunchConfiguration
from launch.substitutions import LaunchConfiguration
from launch_ros.actions import Node
from launch_xml.launch_description_sources import XMLLaunchDescriptionSource


def generate_launch_description():
    return LaunchDescription([
        DeclareLaunchArgument('world', default_value='empty'),
        SetLaunchConfiguration('where', LaunchConfiguration('world')),
        IncludeLaunchDescription(
            XMLLaunchDescriptionSource(os.path.join(get_package_share_directory('demo2'), 'launch', 'part.launch.xml')),
            launch_arguments={'speed': LaunchConfiguration('world')}.items(),
        ),
        Node(
            package='turtlesim',
            executable='turtlesim_node',
            name='turtle',
            parameters=[{'background_r': LaunchConfiguration('where')}],
            remappings=[('turtle1/cmd_vel', '/cmd_vel')],
        ),
    ])
"""


class Written(NamedTuple):
    """A launch file, and where in it the words stand, at ``|``."""

    name: str
    text: str
    words: dict[str, str]


WRITTEN = (
    Written("t.launch.xml", XML, {
        "declared": 'name="w|orld', "read": 'value="$(var w|orld)"/>\n  </inc', "let": 'name="w|here"', "passed": 'name="s|peed"',
        "file": "/l|aunch/part", "package": "share d|emo2", "program": 'exec="t|urtlesim_node', "node": 'name="t|urtle"',
        "from": 'from="t|urtle1', "to": 'to="/|cmd', "param": 'name="b|ackground_r',
    }),
    Written("t.launch.yaml", YAML, {
        "declared": "name: w|orld", "read": "value: $(var w|orld)\n- node", "let": "name: w|here", "passed": "name: s|peed",
        "file": "/l|aunch/part", "package": "share d|emo2", "program": "exec: t|urtlesim_node", "node": "name: t|urtle",
        "from": "from: t|urtle1", "to": "to: /|cmd", "param": "name: b|ackground_r",
    }),
    Written("t.launch.py", PYTHON, {
        "declared": "Argument('w|orld", "read": "'speed': LaunchConfiguration('w|orld'", "let": "SetLaunchConfiguration('w|here",
        "passed": "{'s|peed", "file": "'p|art.launch", "package": "directory('d|emo2", "program": "executable='t|urtlesim_node",
        "node": "name='t|urtle", "from": "('t|urtle1/", "to": "'/|cmd", "param": "'b|ackground_r",
    }),
)  # fmt: skip


class Asked(NamedTuple):
    """A view of a written launch file."""

    view: View
    written: Written

    def at(self, word: str) -> int:
        """The offset of a word."""
        before, _, after = self.written.words[word].partition("|")
        return self.written.text.index(before + after) + len(before)

    def line(self, offset: int) -> str:
        """The line around an offset, without what is around it."""
        return self.written.text[: self.written.text.find("\n", offset)].rpartition("\n")[2].strip()


@pytest.fixture(params=WRITTEN, ids=[each.name for each in WRITTEN])
def asked(request: pytest.FixtureRequest, tmp_path: Path) -> Asked:
    launch = tmp_path / "ws" / "demo2" / "launch"
    launch.mkdir(parents=True)
    (tmp_path / "ws" / ".git").mkdir()
    (launch.parent / "package.xml").write_text(PACKAGE2, encoding="utf-8")
    (launch / "part.launch.xml").write_text(PART, encoding="utf-8")
    written: Written = request.param
    return Asked(view_of(OpenWorkspace(str(tmp_path / "ws")), launch / written.name, written.text), written)


@pytest.mark.parametrize(
    ("word", "said"),
    [
        ("declared", "default: empty"),
        ("read", "**arg** `world`"),
        ("let", "set to"),
        ("passed", "part.launch.xml`, required"),
        ("file", "takes these args"),
        ("package", "**package** `demo2`"),
        ("program", "**program** `turtlesim/turtlesim_node`"),
        ("node", "publisher `/turtle1/pose`"),
        ("from", "**remap**"),
        ("to", "turtle1/cmd_vel → subscriber `/cmd_vel`"),
        ("param", "read by `/turtle`"),
    ],
)
def test_hover(asked: Asked, word: str, said: str) -> None:
    found = hover.hover(asked.view, asked.at(word))
    assert found is not None
    assert said in found.markdown


@pytest.mark.parametrize(
    ("word", "files"),
    [("read", {None}), ("passed", {"part.launch.xml"}), ("file", {"part.launch.xml"}), ("package", {"package.xml"}), ("declared", {None})],
)
def test_definition(asked: Asked, word: str, files: set[str | None]) -> None:
    found = navigation.definition(asked.view, asked.at(word))
    assert {Path(each.file).name for each in found} == {asked.written.name if each is None else each for each in files}


def test_references_highlights_and_renaming(asked: Asked) -> None:
    text = asked.written.text
    references = navigation.references(asked.view, asked.at("declared"))
    assert [text[each.span.start : each.span.end] for each in references] == ["world"] * 3
    assert len(navigation.highlights(asked.view, asked.at("read"))) == 3
    changes = navigation.rename(asked.view, asked.at("read"), "land")
    assert [text[each.target.span.start : each.target.span.end] for each in changes] == ["world"] * 3
    through = navigation.rename(asked.view, asked.at("passed"), "pace")
    assert sorted(Path(each.target.file).name for each in through) == sorted(["part.launch.xml", "part.launch.xml", asked.written.name])
    assert navigation.renamable(asked.view, asked.at("node")) is not None


def test_links_and_calls(asked: Asked) -> None:
    assert [Path(each.file).name for each in navigation.links(asked.view)] == ["part.launch.xml"]
    assert [Path(each.file).name for each in calls.outgoing(asked.view.snapshot, asked.view.file)] == ["part.launch.xml"]
    part = str(Path(asked.view.file).parent / "part.launch.xml")
    assert [each.file for each in calls.incoming(asked.view.snapshot, part)] == [asked.view.file]


def test_symbols(asked: Asked) -> None:
    found = outline.symbols(asked.view)
    assert [each.what for each in found][:4] == ["arg", "arg", "include", "node"]
    assert [each.name for each in found if each.what != "include"][:3] == ["world", "where", "turtle"]
    names = {each.name for each in outline.workspace_symbols(asked.view.snapshot, "")}
    assert {"/turtle", "/teleop", "/cmd_vel", "world"} <= names


def test_hints_and_lenses(asked: Asked) -> None:
    found = hints.hints(asked.view, 0, len(asked.written.text))
    assert [each.text for each in found] == [" = empty", " = empty", " /cmd_vel ← 0 publishers"]
    assert [each.text for each in hints.lenses(asked.view)] == ["2 nodes, 1 connection", "2 topics out, 1 topic in"]


def test_folding_and_selections(asked: Asked) -> None:
    folded = {asked.line(span.start) for span, _ in outline.folding(asked.view)}
    assert folded & {'<node pkg="turtlesim" exec="turtlesim_node" name="turtle">', "- node:", "Node("}
    spans = outline.selections(asked.view, asked.at("program"))
    assert len(spans) >= 3
    assert asked.written.text[spans[0].start : spans[0].end] == "turtlesim_node"
    assert spans[-1] == (0, len(asked.written.text))


def test_the_drawing_follows(asked: Asked) -> None:
    assert drawing.shown_at(asked.view, asked.at("node")) == Shown("node", "/turtle")
    assert drawing.shown_at(asked.view, asked.at("to")) == Shown("topic", "/cmd_vel")
    target = drawing.place_of(asked.view, Shown("node", "/turtle"))
    assert target is not None
    assert "turtle" in asked.line(target.span.start)
