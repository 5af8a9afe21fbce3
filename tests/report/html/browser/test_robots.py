"""Robots of the corpus: found, narrowed, shared, switched; and written again with one node more, everything stays where it was."""

from __future__ import annotations

import shutil
from pathlib import Path

import pytest
from playwright.sync_api import Browser

from tests.conftest import find_corpus
from tests.report.html.browser.reading import drawn
from tests.report.html.browser.robots import ROBOTS, RobotPages, add_newcomer, opened, written
from tests.report.html.browser.test_tasks import MOST, Steps
from tests.report.html.browser.writing import commit
from tests.report.html.pages import data_of

pytestmark = [pytest.mark.chromium, pytest.mark.corpus]

NEAR = 10
PLACES = """() => Object.fromEntries([...document.querySelectorAll("#drawing > svg .box:not(.pill)")].map(box => {
  const [x, y] = box.getAttribute("transform").match(/-?[0-9.]+/g).map(Number);
  return [box.matches(".node") ? box.querySelector("title").textContent.split("\\n")[0] : box.dataset.id, [x, y]];
}))"""


@pytest.mark.parametrize("robot", ROBOTS)
def test_a_robot(browser: Browser, robot_pages: RobotPages, tmp_path: Path, robot: str) -> None:
    target = tmp_path / "report.html"
    shutil.copyfile(robot_pages.of(robot, ROBOTS[robot]), target)
    page = opened(browser, target, f"#entry={ROBOTS[robot]}")
    places = page.evaluate(PLACES)
    assert len(places) > 5

    # What is switched off or filtered away leaves its place.
    page.get_by_role("group", name="Show").get_by_role("button", name="Services", exact=True).click()
    drawn(page)
    assert page.evaluate(PLACES).items() <= places.items()
    page.get_by_role("group", name="Show").get_by_role("button", name="Services", exact=True).click()
    name = data_of(target.read_text())["entries"][0]["nodes"][0]["name"]

    # Found by a part of its name, and shared.
    page.locator("#drawing > svg").click(position={"x": 4, "y": 4})
    page.keyboard.press("/")
    page.keyboard.type(name)
    page.keyboard.press("Enter")
    page.locator("#panel").get_by_text(name).first.wait_for()
    shared = page.url
    page.close()
    page = opened(browser, target, shared[shared.index("#") :])
    page.locator("#panel").get_by_text(name).first.wait_for()
    page.close()

    # The page that is written over says which nodes are new.
    directory = tmp_path / "robot"
    shutil.copytree(Path(str(find_corpus())) / robot, directory, symlinks=True)
    add_newcomer(directory / ROBOTS[robot], robot, "rosout", "rosout")
    written(directory, ROBOTS[robot], target)
    page = opened(browser, target, f"#entry={ROBOTS[robot]}")
    after = page.evaluate(PLACES)
    page.close()
    both = [(was, after[title]) for title, was in places.items() if title in after]
    stayed = sum(abs(was[0] - now[0]) <= NEAR and abs(was[1] - now[1]) <= NEAR for was, now in both)
    assert len(both) >= 0.95 * len(places)
    assert stayed >= 0.95 * len(both)


@pytest.mark.parametrize("robot", ROBOTS)
def test_what_a_change_did(browser: Browser, tmp_path: Path, robot: str) -> None:
    directory, target, launch = tmp_path / "robot", tmp_path / "report.html", ROBOTS[robot]
    shutil.copytree(Path(str(find_corpus())) / robot, directory, symlinks=True)
    shutil.rmtree(directory / ".git", ignore_errors=True)
    commit(directory)
    add_newcomer(directory / launch, robot, "topic_tools", "relay", "newcomer_in newcomer_out")
    written(directory, launch, target, "--base", "HEAD")
    page = opened(browser, target, f"#entry={launch}")
    task = Steps(page)
    assert any(line.startswith("Gained since HEAD") for line in task.panel)
    page.locator("#drawing > svg").focus()
    # What is new of the findings comes before the nodes, where there is any.
    while not any("newcomer" in line for line in task.panel):
        task.do(lambda page: page.keyboard.press("]"))
        assert task.taken <= MOST
    page.close()
