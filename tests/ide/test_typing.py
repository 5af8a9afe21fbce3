"""Files that are typed, one key after another: nothing fails, no stretch lies outside, nothing flickers elsewhere."""

from __future__ import annotations

import random
import re
from pathlib import Path

import pytest

from launchlint.finding import Finding
from launchlint.ide.view import View
from launchlint.project.workspace import OpenWorkspace
from tests.ide.questions import ask_everything, ask_what_is_shown, snapshot_of, view_of
from tests.server.workspace import FILES, MAIN, PART, make

LINES = 60
"""Of each file that is written from nothing."""
ROBOT = """
  <group ns="$(arg name){number}" if="$(arg sim)">
    <node name="sim" pkg="turtlesim" type="turtlesim_node" output="screen">
      <param name="background_r" value="{number}"/>
      <remap from="turtle1/cmd_vel" to="cmd_vel"/>
    </node>
  </group>
"""
ROS1 = f"""<?xml version="1.0"?>
<!-- Starts turtles, and what steers them. -->
<launch>
  <arg name="name" default="turtle"/>
  <arg name="sim" default="true" doc="whether there is no robot"/>
{"".join(ROBOT.format(number=number) for number in range(7))}
  <include file="$(find demo)/launch/part.launch">
    <arg name="rate" value="$(eval 5 * 2)"/>
  </include>
  <!-- What is written down -->
  <rosparam command="load" file="$(find demo)/config/turtle.yaml"/>
  <param name="rate" value="10"/>
</launch>
"""
TURTLE = """- node:
    pkg: turtlesim
    exec: turtlesim_node
    name: turtle{number}
    namespace: $(var name)
    param:
    - name: background_r
      value: {number}
    remap:
    - from: turtle1/cmd_vel
      to: cmd_vel{number}
"""
ROS2 = f"""# Starts turtles.
launch:
- arg:
    name: name
    default: turtle
    description: what they are called
{"".join(TURTLE.format(number=number) for number in range(5))}"""


@pytest.fixture
def workspace(tmp_path: Path) -> OpenWorkspace:
    opened = OpenWorkspace(str(make(tmp_path / "ws")))
    opened.settle()
    return opened


@pytest.mark.parametrize(("name", "text"), [("demo/launch/new.launch", ROS1), ("demo2/launch/new.launch.yaml", ROS2)], ids=["ros1", "ros2"])
def test_a_file_is_written_from_nothing(workspace: OpenWorkspace, name: str, text: str) -> None:
    assert len(text.splitlines()) >= LINES
    file = Path(workspace.root) / name
    known = elsewhere(workspace, name)
    for end in range(len(text) + 1):
        typed = text[:end]
        workspace.hold({str(file): typed.encode()})
        for request in workspace.waiting([str(file)]):
            workspace.work(request)
        view = View(snapshot_of(workspace), str(file), typed)
        if end % 7 == 0 or typed.endswith(("(", '"', "<", " ", ":")):  # where people stop to ask
            ask_everything(view, end)
        else:
            ask_what_is_shown(view, end)
        findings = workspace.outcome([str(file)]).findings
        assert [each for each in findings if each.rule == "LL000"] == []
        assert all(0 <= each.location.start <= each.location.end <= end for each in findings), typed[-80:]
        if end % 97 == 0:
            assert elsewhere(workspace, name) == known, typed[-80:]
    assert [each.rule for each in workspace.outcome([str(file)]).findings if each.rule == "LL101"] == []


def elsewhere(workspace: OpenWorkspace, name: str) -> list[Finding]:
    """What is found in all files but one."""
    return [each for each in workspace.outcome().findings if each.location.path != name]


@pytest.mark.parametrize("name", [name for name in FILES if "/launch/" in name])
def test_every_place_of_every_file_can_be_asked_about(workspace: OpenWorkspace, name: str) -> None:
    view = view_of(workspace, Path(workspace.root) / name, FILES[name])
    for offset in range(len(FILES[name]) + 1):
        ask_everything(view, offset)


def told(workspace: OpenWorkspace, line: int) -> set[tuple[str, str]]:
    """What is found in main.launch on other lines than ``line`` (from 1)."""
    findings: tuple[Finding, ...] = workspace.outcome().findings
    return {
        (each.rule, each.location.text) for each in findings if each.location.path.endswith("main.launch") and each.location.line != line
    }


LINE = '  <remap from="scan" to="$(arg sim)/scan"/>'


def test_nothing_flickers_elsewhere_while_a_line_is_typed(workspace: OpenWorkspace) -> None:
    file = Path(workspace.root) / "demo" / "launch" / "main.launch"
    lines = MAIN.split("\n")
    workspace.hold({str(file): MAIN.encode()})
    workspace.settle()
    before = told(workspace, 0)
    assert {rule for rule, _ in before} >= {"LL206", "LL301"}
    for end in range(len(LINE) + 1):
        text = "\n".join([*lines[:2], LINE[:end], *lines[2:]])
        view = view_of(workspace, file, text)
        ask_everything(view, len("\n".join(lines[:2])) + 1 + end)
        assert told(workspace, 3) >= before, LINE[:end]


@pytest.mark.corpus
def test_files_of_robots_are_edited(corpus: Path, tmp_path: Path) -> None:
    """A line in the middle of each is taken away key by key, or typed: what is told of other lines stays."""
    chance = random.Random(3)
    files = sorted(path for path in corpus.glob("ros1/*/*/launch/*.launch") if 1_000 < path.stat().st_size < 3_000)
    (tmp_path / "ws" / "demo" / "launch").mkdir(parents=True)
    (tmp_path / "ws" / ".git").mkdir()
    workspace = OpenWorkspace(str(tmp_path / "ws"))
    file = tmp_path / "ws" / "demo" / "launch" / "robot.launch"
    for path, is_typed in zip(chance.sample(files, 4), (True, False, True, False), strict=True):
        text = path.read_text(encoding="utf-8", errors="replace")
        start, end = chance.choice(whole_elements(text))
        number = text.count("\n", 0, start)
        stays: set[tuple[str, str]] | None = None
        for whole in (text, text[:start] + text[end:]):
            ask_everything(view_of(workspace, file, whole), start)
            told_of = on_other_lines(workspace, number)
            stays = told_of if stays is None else stays & told_of
        assert stays is not None
        keys = range(end - start + 1)
        for typed in keys if is_typed else reversed(keys):
            ask_everything(view_of(workspace, file, text[: start + typed] + text[end:]), start + typed)
            assert on_other_lines(workspace, number) >= stays, text[start : start + typed]


def whole_elements(text: str) -> list[tuple[int, int]]:
    """Where the elements stand that are a line of their own and that no other line hangs on: remaps, params."""
    return [match.span(1) for match in re.finditer(r"^[ \t]*(<(?:remap|param) [^<>\n]*/>)[ \t]*$", text, re.MULTILINE)]


def on_other_lines(workspace: OpenWorkspace, number: int) -> set[tuple[str, str]]:
    """What is told of the robot's other lines than the one (from 0) that is typed."""
    findings = workspace.outcome().findings
    return {(each.rule, each.location.text) for each in findings if each.location.line != number + 1}


@pytest.mark.parametrize(
    "change",
    [
        lambda text: text.replace("\n", "\r\n"),
        lambda text: text.replace("  ", "\t"),
        lambda text: text.replace("<launch>", "<launch> <!-- 😀é -->"),
    ],
    ids=["crlf", "tabs", "astral"],
)
def test_places_in_other_texts(workspace: OpenWorkspace, change: object) -> None:
    assert callable(change)
    text = change(PART)
    view = view_of(workspace, Path(workspace.root) / "demo" / "launch" / "part.launch", text)
    for offset in range(0, len(text), 3):
        ask_everything(view, offset)
    mention = view.mention_at(text.index("arg rate)") + 5)
    assert mention is not None
    seen = view.seen(mention.span)
    assert text[seen.start : seen.end] == "rate"
