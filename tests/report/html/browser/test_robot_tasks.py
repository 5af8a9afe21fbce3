"""What people come to the page for, on robots of the corpus: each in at most three steps, as on the example."""

from __future__ import annotations

import re
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
from playwright.sync_api import Browser, Page

from tests.report.html.browser.paper import PAPERS, ink, sheets
from tests.report.html.browser.reading import boxes, drawn, fragment
from tests.report.html.browser.robots import ROBOTS, RobotPages
from tests.report.html.browser.test_tasks import MOST, Steps
from tests.report.html.pages import data_of

pytestmark = [pytest.mark.chromium, pytest.mark.corpus]


class Robot:
    """The page of one robot, opened anew for each task; ``entry`` is what the page holds of its launch file."""

    def __init__(self, browser: Browser, launch: str, target: Path) -> None:
        self._browser = browser
        self._address = f"{target.as_uri()}#entry={launch}"
        self.entry: dict[str, Any] = data_of(target.read_text(encoding="utf-8"))["entries"][0]
        self.tasks: list[Steps] = []

    def task(self, address: str = "") -> Steps:
        context = self._browser.new_context(
            viewport={"width": 1440, "height": 900}, reduced_motion="reduce", permissions=["clipboard-read", "clipboard-write"]
        )
        page = context.new_page()
        page.goto(address or self._address)
        drawn(page)
        self.tasks.append(Steps(page))
        return self.tasks[-1]

    def ends(self, channel: int, *, offers: bool) -> list[int]:
        return [each["node"] for each in self.entry["connections"] if each["channel"] == channel and each["offers"] is offers]

    def topics(self) -> list[tuple[str, int]]:
        """Those that are published and heard, and that not everybody has."""
        return [
            (each["name"], number)
            for number, each in enumerate(self.entry["channels"])
            if each["kind"] == "topic" and not each["hub"] and not each["plumbing"]
            if self.ends(number, offers=True) and self.ends(number, offers=False)
        ]


@pytest.fixture(scope="module", params=ROBOTS)
def robot(request: pytest.FixtureRequest, browser: Browser, robot_pages: RobotPages) -> Iterator[Robot]:
    launch = ROBOTS[request.param]
    made = Robot(browser, launch, robot_pages.of(request.param, launch))
    yield made
    assert [each.taken for each in made.tasks if each.taken > MOST] == []


@pytest.fixture(autouse=True)
def _close(robot: Robot) -> Iterator[None]:
    yield
    for each in robot.tasks:
        each.page.context.close()


def test_who_exchanges_a_topic(robot: Robot) -> None:
    (name, channel), *_ = robot.topics()
    task = robot.task()
    task.search(name)
    assert f"Publishers: {len(set(robot.ends(channel, offers=True)))}" in task.panel


def test_find_a_node_and_where_it_is_made(robot: Robot) -> None:
    name = robot.entry["nodes"][0]["name"]
    task = robot.task()
    task.search(name)
    assert name in task.panel
    assert task.page.locator("#panel .place").count() > 0


def test_why_one_does_not_hear_the_other(robot: Robot) -> None:
    one, *_, other = (each["name"] for each in robot.entry["nodes"])
    task = robot.task()
    task.search(one)
    task.do(lambda page: page.locator("#panel input.pair").fill(other))
    assert fragment(task.page).startswith("pair=n(")
    assert other in " ".join(task.panel)


def test_what_is_wrong_and_where(robot: Robot) -> None:
    if not robot.entry["findings"]:
        pytest.skip("nothing is wrong with it")
    task = robot.task()
    task.do(lambda page: page.locator("#panel .findings a").first.click())
    assert task.page.locator("#panel pre.source mark").count() > 0  # one for each of the same findings


def test_an_include_and_its_ports(robot: Robot) -> None:
    task = robot.task()
    task.press("Launch file", "Group nodes by")
    include = task.page.locator("#tree .row.include:visible").first
    if not include.count():  # all of it stands in a group
        task.do(lambda page: page.locator("#tree .twisty").first.click())
    task.do(lambda _: include.click())
    assert task.panel[1] == "Include"


def test_share_exactly_this_view(robot: Robot) -> None:
    task = robot.task()
    task.search(robot.entry["nodes"][0]["name"])
    task.do(lambda page: page.get_by_role("button", name="Zoom in").click())
    task.press("Copy link")
    again = robot.task(task.page.evaluate("navigator.clipboard.readText()"))
    assert boxes(again.page) == boxes(task.page)
    assert again.panel[:3] == task.panel[:3]


def test_without_the_noise(robot: Robot) -> None:
    (name, _), *_ = robot.topics()
    task = robot.task()
    before = boxes(task.page)
    task.do(lambda page: (page.locator("#filter").fill(name), page.wait_for_timeout(400)))
    assert 0 < len(boxes(task.page)) <= len(before)
    assert "filter=" in fragment(task.page)


def test_params_and_where_they_come_from(robot: Robot) -> None:
    names = {each["name"] for each in robot.entry["params"]}
    node = next((each["name"] for each in robot.entry["nodes"] if any(name.startswith(f"{each['name']}/") for name in names)), None)
    if node is None:
        pytest.skip("none of its nodes has params of its own")
    task = robot.task()
    task.search(node)
    assert task.page.locator("#panel .params .place").count() > 0


def test_save_a_picture(robot: Robot) -> None:
    task = robot.task()
    task.do(lambda page: page.locator("summary", has_text="Export").click())
    with task.page.expect_download() as download:
        task.press("PNG picture")
    assert download.value.path().read_bytes().startswith(b"\x89PNG")


def test_why_is_this_node_alone(robot: Robot) -> None:
    shared = {number for _, number in robot.topics()}
    talks = {each["node"] for each in robot.entry["connections"] if each["channel"] in shared}
    own = [number for number, _ in enumerate(robot.entry["nodes"]) if number not in talks]
    if not own:
        pytest.skip("each of its nodes shares a topic")
    alone = robot.entry["nodes"][own[0]]
    task = robot.task()
    task.search(alone["name"])
    assert alone["name"] in task.panel
    if alone["knowledge"] == "unknown":
        assert "What it does is not known" in task.panel
    else:
        # What a manager of nodelets says and hears, its nodelets do.
        reasons = ("nobody", "not known", "everybody", "Nothing is known of it", "shares", "known only in part", "Nodelet manager")
        assert any(word in line for line in task.panel for word in reasons), task.panel


def test_print(robot: Robot, tmp_path: Path) -> None:
    page = robot.task().page
    for paper, landscape in (PAPERS[0], PAPERS[-1]):  # each size and each direction once: of a robot that is hundreds of sheets
        printed = sheets(page, tmp_path, paper, landscape=landscape)
        assert all(sheet.strip() for sheet in printed)
        # The drawing takes one sheet, and no line of it is cut at the edge of the paper.
        left, top, right, bottom = ink(tmp_path, 1)
        assert min(left, top) > 0.01
        assert max(right, bottom) < 0.99
        assert right - left > 0.5
        assert "Nodes" not in printed[0].split()
        heads = [sheet for sheet in printed if re.search(r"^ *Node +Program +Known +Place +Findings *$", sheet, re.MULTILINE)]
        titles = [sheet for sheet in printed if re.search(r"^ *Nodes *$", sheet, re.MULTILINE)]
        assert (len(titles), len(heads) > 0) == (1, True)


def test_another_configuration(robot: Robot) -> None:
    if len(robot.entry["configurations"]) < 2:
        pytest.skip("it has one")
    task = robot.task()

    def choose(page: Page) -> None:
        page.get_by_label("Configuration").select_option(robot.entry["configurations"][1])

    task.do(choose)
    assert "config" in fragment(task.page)
