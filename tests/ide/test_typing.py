"""Files that are typed, one key after another: nothing fails, no stretch lies outside, nothing flickers elsewhere."""

from __future__ import annotations

import random
from pathlib import Path

import pytest

from launchlint.finding import Finding
from launchlint.project.workspace import OpenWorkspace
from tests.ide.questions import ask_everything, view_of
from tests.server.workspace import FILES, MAIN, PART, make

WRITTEN = """<?xml version="1.0"?>
<!-- Starts a turtle, and what steers it. -->
<launch>
  <arg name="name" default="turtle"/>
  <arg name="sim" default="true" doc="whether there is no robot"/>
  <group ns="$(arg name)" if="$(arg sim)">
    <node name="sim" pkg="turtlesim" type="turtlesim_node" output="screen">
      <param name="background_r" value="10"/>
      <remap from="turtle1/cmd_vel" to="cmd_vel"/>
    </node>
  </group>
  <include file="$(find demo)/launch/part.launch">
    <arg name="rate" value="$(eval 5 * 2)"/>
  </include>
</launch>
"""


@pytest.fixture
def workspace(tmp_path: Path) -> OpenWorkspace:
    opened = OpenWorkspace(str(make(tmp_path / "ws")))
    opened.settle()
    return opened


def test_a_file_is_written_from_nothing(workspace: OpenWorkspace) -> None:
    file = Path(workspace.root) / "demo" / "launch" / "new.launch"
    for end in range(len(WRITTEN) + 1):
        view = view_of(workspace, file, WRITTEN[:end])
        ask_everything(view, end)
    assert [each for each in workspace.outcome().findings if each.location.path.endswith("new.launch") and each.rule == "LL101"] == []


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
    chance = random.Random(3)
    files = sorted(path for path in corpus.glob("ros1/*/*/launch/*.launch") if 1_000 < path.stat().st_size < 3_000)
    (tmp_path / "ws" / "demo" / "launch").mkdir(parents=True)
    (tmp_path / "ws" / ".git").mkdir()
    workspace = OpenWorkspace(str(tmp_path / "ws"))
    file = tmp_path / "ws" / "demo" / "launch" / "robot.launch"
    for path in chance.sample(files, 3):
        text = path.read_text(encoding="utf-8", errors="replace")
        start = chance.randrange(len(text))
        for length in range(40):  # taken away key by key, and typed again
            ask_everything(view_of(workspace, file, text[:start] + text[start + length :]), start)
        for length in range(40):
            ask_everything(view_of(workspace, file, text[: start + length] + text[start + 40 :]), start + length)


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
