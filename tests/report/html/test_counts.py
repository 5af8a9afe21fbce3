"""The page says what ``check`` says: every finding, every verdict, every number."""

from __future__ import annotations

import json
import os
import shutil
from pathlib import Path
from typing import Any

import pytest

from tests.cli.running import run
from tests.report.html.pages import data_of
from tests.report.html.test_page import text_of

EXAMPLES = Path(__file__).resolve().parents[3] / "examples"
OF_CORPUS = ("ros1/ros-planning+moveit_resources", "ros1/RobotnikAutomation+summit_xl_common", "ros1/ros-industrial+fanuc")


def compared(directory: Path) -> tuple[Any, Any, str]:
    """What ``check`` says of a directory as JSON, the page's data, and the page."""
    said = json.loads(run(directory, "check", "--format", "json", "--exit-zero", "--no-cache", ".").output)
    page = run(directory, "report", "-o", "-", "--quiet", ".").output
    return said, data_of(page), page


def assert_same(said: Any, data: Any, page: str) -> None:
    assert [each["fingerprint"][:16] for each in said["findings"]] == [each["id"] for each in data["findings"]]
    rules = [[(each["rule"], each["severity"]) for each in side["findings"]] for side in (said, data)]
    assert rules[0] == rules[1]
    verdicts = sorted((each["file"], each["word"], bool(each["elsewhere"])) for each in said["verdicts"])
    assert verdicts == sorted((data["files"][each["file"]], each["verdict"], each["withArgs"] != "") for each in data["entries"])
    sight = said.get("sight", {"known": 0, "nodes": 0})
    assert data["sight"] == [sight["known"], sight["nodes"]]
    # No finding is behind a filter: every one is in the list of some launch file, and on the first page.
    reached = {index for each in data["entries"] for index in each["findings"]}
    assert reached == set(range(len(data["findings"])))
    counted = {word: sum(each["severity"] == word for each in said["findings"]) for word in ("error", "warning", "info")}
    told = dict(each.split(" ", 1)[::-1] for each in lines(text(page, "counts")))
    assert {word: int(told.get(word, told.get(f"{word}s", "0"))) for word in counted} == counted
    assert len(text_of(page, "table-findings").splitlines()) == len(said["findings"]) + 1


def text(page: str, id_: str) -> str:
    start = page.index(f'id="{id_}"')
    return page[start : page.index("</ul>", start)]


def lines(markup: str) -> list[str]:
    return [each.partition("<b>")[2].replace("</b>", "").partition("</li>")[0] for each in markup.split("<li")[1:]]


@pytest.mark.parametrize("name", ["turtles", "ferry"])
def test_of_an_example(name: str, tmp_path: Path) -> None:
    shutil.copytree(EXAMPLES / name, tmp_path / name)
    assert_same(*compared(tmp_path / name))


@pytest.mark.skipif("LAUNCHLINT_CORPUS" not in os.environ, reason="LAUNCHLINT_CORPUS names no directory of launch files")
@pytest.mark.parametrize("name", OF_CORPUS)
def test_of_a_public_robot(name: str, tmp_path: Path) -> None:
    shutil.copytree(Path(os.environ["LAUNCHLINT_CORPUS"], name), tmp_path / "robot", symlinks=True)
    assert_same(*compared(tmp_path / "robot"))


def test_nodes_are_those_started_without_other_args_as_on_cards_and_in_check(tmp_path: Path) -> None:
    node = '<node pkg="demo" type="talk" name="{}"/>'
    group = f'<group if="$(arg sim)">{node.format("sim")}</group>'
    launch = f'<launch><arg name="sim" default="false"/>{node.format("always")}{group}</launch>'
    (tmp_path / "choices.launch").write_text(launch, encoding="utf-8")
    said, _, page = compared(tmp_path)
    assert said["sight"]["nodes"] == 1
    assert [each for each in lines(text(page, "counts")) if "node" in each or "args" in each] == ["1 node", "1 more with other args"]
