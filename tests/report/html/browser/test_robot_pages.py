"""The page of a whole public repository: its cards, what it knows, how quick it is; and what only ROS 2 has."""

from __future__ import annotations

import re
import shutil
from pathlib import Path
from typing import Any
from urllib.parse import quote

import pytest
from playwright.sync_api import Browser, Page

from tests.bench.report_drawing import ready
from tests.conftest import find_corpus
from tests.report.html.browser.reading import drawn, lines
from tests.report.html.browser.robots import ROBOTS, RobotPages, add_newcomer, opened, written
from tests.report.html.browser.test_landing import COUNTED, titles
from tests.report.html.browser.writing import commit
from tests.report.html.pages import data_of

pytestmark = [pytest.mark.chromium, pytest.mark.corpus]

REPOSITORIES = [name for name in ROBOTS if name != "ros2/autowarefoundation+autoware.universe"]
"""Of 14 to 56 launch files; a page of 200 is made for its largest one only, in the other tests."""
SLOW = 2_500
"""Milliseconds of the processor until the largest launch file is drawn that are too many on any machine.

The aim is 1,000 on one that has nothing else to do. Machines differ too much for that to be a test: here what grows out of all
measure is seen.
"""


class Repository:
    """The page of a repository; ``data`` is what it holds, ``main`` the number of its largest launch file."""

    def __init__(self, browser: Browser, target: Path, name: str) -> None:
        self.browser, self.target, self.name = browser, target, name
        self.data: dict[str, Any] = data_of(target.read_text(encoding="utf-8"))
        self.entries: list[dict[str, Any]] = self.data["entries"]
        self.main = next(each for each in self.entries if self.data["files"][each["file"]] == ROBOTS[name])

    def open(self, fragment: str = "") -> Page:
        return opened(self.browser, self.target, fragment)

    @property
    def entry(self) -> str:
        """The address of the largest launch file."""
        title = f"{ROBOTS[self.name]} {self.main['configurations'][0]}".rstrip()
        return f"#entry={quote(title, safe='')}"


@pytest.fixture(scope="module", params=REPOSITORIES)
def repository(request: pytest.FixtureRequest, browser: Browser, robot_pages: RobotPages) -> Repository:
    return Repository(browser, robot_pages.of(request.param, "."), request.param)


def test_a_card_for_each_launch_file_what_needs_attention_first(repository: Repository) -> None:
    page = repository.open()
    page.locator("details.card-group").evaluate_all("all => all.forEach(each => { each.open = true })")
    assert len(titles(page)) == len(repository.entries)
    groups = [page.locator(where).all() for where in (":scope .landing-cards > ol > .card", ".card-group .card")]
    for cards in groups:
        said = [str(card.locator(".card-verdict").text_content()) for card in cards]
        refused = ["refused" in each for each in said]
        assert refused == sorted(refused, reverse=True)
    # The head says of all of them what each card says of one.
    numbers = [re.match(r"(\d+) node", str(card.locator(".card-facts").text_content())) for card in page.locator(".card").all()]
    shown = sum(int(each[1]) for each in numbers if each)
    more = sum(len(each["nodes"]) for each in repository.entries if not each["sight"][1])
    head = " ".join(page.locator("#counts li").all_inner_texts())
    assert f"{shown - more} nodes started" in head
    # A card opens its launch file, whose head has the number of the card.
    card = page.locator(f".card[data-entry='{repository.entries.index(repository.main)}']")
    (number,) = re.findall(r"\d+ nodes", str(card.locator(".card-facts").text_content()))
    card.get_by_role("link").click()
    drawn(page)
    assert number in page.locator("#counts li").all_inner_texts()
    page.close()


def test_what_is_not_known_says_so_in_head_panel_and_table(repository: Repository) -> None:
    page = repository.open(repository.entry)
    unknown = [each["name"] for each in repository.main["nodes"] if each["knowledge"] == "unknown"]
    counts = page.locator("#counts li").all_inner_texts()
    assert (f"{len(unknown)} not known" in counts) == (len(unknown) > 0)
    ends = {(each["channel"], each["offers"]) for each in repository.main["connections"]}
    channels = [
        channel
        for number, channel in enumerate(repository.main["channels"])
        if channel["kind"] == "topic" and not channel["plumbing"] and any((number, each[0]) not in ends for each in channel["may"])
    ]
    for name in unknown[:1]:
        page.goto(f"{repository.target.as_uri()}{repository.entry}&node={quote(name, safe='')}")
        drawn(page)
        assert "What it does is not known" in lines(page.locator("#panel"))
    for channel in channels[:1]:
        page.goto(f"{repository.target.as_uri()}{repository.entry}&topic={quote(channel['name'], safe='')}")
        drawn(page)
        assert re.search(r"\bmay\b", page.locator("#panel").inner_text())
        page.locator(".openers").get_by_role("button", name="Topics").click()
        row = page.locator("#table-topics tr[data-index]").filter(has_text=channel["name"]).first
        assert re.search(r"nobody here, but .* may\b", row.inner_text())
    page.close()


def test_only_what_is_opened_is_unpacked_and_that_is_quick(repository: Repository) -> None:
    page = repository.browser.new_page()
    page.add_init_script(COUNTED)
    page.goto(repository.target.as_uri())
    drawn(page)
    assert page.evaluate("window.parsed") == 1
    page.goto(f"{repository.target.as_uri()}{repository.entry}")
    drawn(page)
    assert page.evaluate("window.parsed") == 2
    page.close()
    # The least of three: other programs on the machine make caches cold.
    assert min(ready(repository.browser, repository.target, repository.entry)[1] for _ in range(3)) <= SLOW


@pytest.mark.parametrize(
    "name", [each for each in REPOSITORIES if "spencer" in each or "PR2" in each or "AirStack" in each or "rotors" in each]
)
def test_a_pull_request_shows_what_changed_first(browser: Browser, tmp_path: Path, name: str) -> None:
    directory, target, picture = tmp_path / "robot", tmp_path / "report.html", tmp_path / "change.svg"
    shutil.copytree(Path(str(find_corpus())) / name, directory, symlinks=True)
    shutil.rmtree(directory / ".git", ignore_errors=True)
    commit(directory)
    add_newcomer(directory / ROBOTS[name], name, "topic_tools", "relay", "newcomer_in newcomer_out")
    written(directory, ".", target, "--base", "HEAD", "--picture", str(picture))
    data = data_of(target.read_text(encoding="utf-8"))
    changed = [data["files"][each["file"]] for each in data["entries"] if each["changes"] or each.get("mark")]
    assert ROBOTS[name] in changed
    page = opened(browser, target, "")
    assert page.locator(".landing-cards h2").first.inner_text() == f"Changed since HEAD {len(changed)}"
    shown = page.locator(".cards.changed .card").evaluate_all("all => all.map(each => Number(each.dataset.entry))")
    assert sorted(data["files"][data["entries"][each]["file"]] for each in shown) == sorted(changed)
    # What did not change is folded, and of its findings none is new.
    assert page.locator(".card-group").evaluate_all("all => all.every(each => !each.open)")
    assert "+1 node" in page.locator(".cards.changed").inner_text()
    of_changed = {finding for each in data["entries"] if each["changes"] or each.get("mark") for finding in each["findings"]}
    assert {index for index, each in enumerate(data["findings"]) if each.get("since")} <= of_changed
    assert "newcomer" in picture.read_text(encoding="utf-8")
    page.close()


@pytest.mark.parametrize("name", [each for each in ROBOTS if each.startswith("ros2/")])
def test_what_only_ros_2_has(browser: Browser, robot_pages: RobotPages, name: str) -> None:
    target = robot_pages.of(name, ROBOTS[name])
    entry = data_of(target.read_text(encoding="utf-8"))["entries"][0]
    page = opened(browser, target, f"#entry={quote(ROBOTS[name], safe='')}")

    def panel_of(name: str) -> str:
        page.goto(f"{target.as_uri()}#node={quote(name, safe='')}")
        drawn(page)
        page.locator("#panel").get_by_role("heading", name=name.rpartition("/")[2]).first.wait_for()
        return page.locator("#panel").inner_text()

    component = next((each for each in entry["nodes"] if each["kind"] == "component"), None)
    if component is not None:
        assert component["host"] in panel_of(component["name"])
    profile = next((each for each in entry["connections"] if each.get("qos")), None)
    if profile is not None:
        assert f"QoS: {profile['qos']}" in panel_of(entry["nodes"][profile["node"]]["name"])
    param = next((each for each in entry["params"] if each["readers"]), None)
    if param is not None:
        panel = panel_of(entry["nodes"][param["readers"][0]]["name"])
        assert param["name"].rpartition("/")[2] in panel
    assert [each for each in (component, profile, param) if each is not None]
    page.close()
