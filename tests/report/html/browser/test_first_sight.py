"""What can be read before anything is touched, on the example and on public robots."""

from __future__ import annotations

from pathlib import Path

import pytest
from playwright.sync_api import Browser, Page

from tests.conftest import find_corpus
from tests.report.html.browser.reading import drawn
from tests.report.html.browser.robots import ROBOTS, RobotPages
from tests.report.html.browser.writing import write_report

pytestmark = pytest.mark.chromium

SMALLEST = """() => {
  const svg = document.querySelector("#drawing > svg");
  const frame = svg.getBoundingClientRect();
  const sizes = [];
  for (const text of svg.querySelectorAll("text")) {
    const box = text.getBoundingClientRect();
    const isSeen = text.checkVisibility() && box.width && box.right > frame.left && box.left < frame.right;
    const scale = text.getScreenCTM();
    if (isSeen) sizes.push(parseFloat(getComputedStyle(text).fontSize) * Math.hypot(scale.a, scale.b));
  }
  return Math.min(...sizes);
}"""
OVERLAPPING = """() => {
  const frame = document.querySelector("#drawing > svg").getBoundingClientRect();
  const seen = [...document.querySelectorAll("#drawing > svg text")].filter((text) => text.checkVisibility());
  const placed = seen.map((text) => [text.textContent, text.getBoundingClientRect()]);
  const all = placed.filter(([, box]) => box.width && box.right > frame.left && box.left < frame.right);
  const isOver = (a, b) => {
    const [high, low] = [0.2 * a.height, 0.2 * b.height]; // above and below its letters a line of text is empty
    return a.left + 1 < b.right && b.left + 1 < a.right && a.top + high < b.bottom - low && b.top + low < a.bottom - high;
  };
  return all.flatMap(([one, a], at) => all.slice(at + 1).filter(([, b]) => isOver(a, b)).map(([other]) => `${one} and ${other}`));
}"""
"""Names that lie over each other."""
USED = """() => {
  const frame = document.querySelector("#drawing > svg").getBoundingClientRect();
  const boxes = [...document.querySelectorAll("#drawing > svg .box")].map((each) => each.getBoundingClientRect());
  const [left, right] = [Math.min(...boxes.map((box) => box.left)), Math.max(...boxes.map((box) => box.right))];
  const [top, bottom] = [Math.min(...boxes.map((box) => box.top)), Math.max(...boxes.map((box) => box.bottom))];
  return Math.max((right - left) / frame.width, (bottom - top) / frame.height);
}"""

CUT = """() => {
  const frame = document.querySelector("#drawing > svg").getBoundingClientRect();
  const boxes = [...document.querySelectorAll("#drawing > svg .box")].map((each) => each.getBoundingClientRect());
  const beyond = (box) => Math.max(frame.left - box.left, box.right - frame.right, frame.top - box.top, box.bottom - frame.bottom);
  return boxes.filter((box) => beyond(box) > 1).length;
}"""
"""Boxes of which a part is beyond the edge."""


@pytest.mark.parametrize("size", [(1440, 900), (1920, 1080)])
def test_every_name_of_the_example_can_be_read_and_it_fills_the_stage(open_report, size):
    page = open_report(viewport={"width": size[0], "height": size[1]})
    assert page.evaluate(SMALLEST) >= 9
    assert page.evaluate(USED) >= 0.75
    assert page.evaluate(OVERLAPPING) == []


@pytest.mark.corpus
@pytest.mark.parametrize("robot", ROBOTS)
def test_every_name_of_a_public_robot_can_be_read(browser: Browser, robot_pages: RobotPages, robot: str) -> None:
    target = robot_pages.of(robot, ROBOTS[robot])
    for width, height in ((1440, 900), (1920, 1080), (390, 844)):
        page = browser.new_page(viewport={"width": width, "height": height}, reduced_motion="reduce")
        page.goto(f"{target.as_uri()}#entry={ROBOTS[robot]}")
        drawn(page)
        smallest, used, note = page.evaluate(SMALLEST), page.evaluate(USED), page.locator(".stage-note").text_content()
        folded = page.locator("#drawing > svg .box.folded").count()
        overlapping = page.evaluate(OVERLAPPING)
        cut = page.evaluate(CUT)
        page.close()
        assert smallest >= 9
        assert cut == 0 or width == 390
        assert overlapping == []
        assert (f"in {folded} folded" in str(note)) == (folded > 0)
        # What a narrow screen cannot hold says so.
        assert used <= 1 or width == 390
        assert used <= 1 or "beyond the edge" in str(note)


def _places(page: Page) -> dict[str, object]:
    read = "all => Object.fromEntries(all.map(each => [each.dataset.id, each.getAttribute('transform')]))"
    found: dict[str, object] = page.locator("#drawing > svg .box").evaluate_all(read)
    return found


def test_what_is_switched_off_moves_nothing(open_report):
    page = open_report()
    before = _places(page)
    for toggle in ("Services", "Unconnected", "Topics"):
        page.get_by_role("group", name="Show").get_by_role("button", name=toggle, exact=True).click()
        drawn(page)
        after = _places(page)
        assert after
        assert after.items() <= before.items()


def test_sides_fold_and_keep_their_width(open_report):
    page = open_report()
    wide = page.locator("#stage").bounding_box()["width"]
    page.get_by_role("separator", name="Width of the tree").press("ArrowRight")
    assert page.locator("#tree").bounding_box()["width"] == 280
    page.get_by_role("button", name="Fold the details").click()
    assert page.locator("#panel").is_hidden()
    assert page.locator("#stage").bounding_box()["width"] > wide
    page.reload()
    drawn(page)
    assert page.locator("#tree").bounding_box()["width"] == 280
    assert page.locator("#panel").is_hidden()


@pytest.mark.corpus
def test_nodes_in_a_circle_stand_in_as_many_rows_as_can_be_read(browser: Browser, tmp_path: Path) -> None:
    directory, launch = (
        Path(str(find_corpus())) / "ros1/HKUST-Aerial-Robotics+Fast-Planner",
        "fast_planner/plan_manage/launch/kino_replan.launch",
    )
    target = tmp_path / "report.html"
    write_report(directory, target, launch, "--workspace", ".")
    page = browser.new_page(viewport={"width": 1440, "height": 900}, reduced_motion="reduce")
    page.goto(target.as_uri())
    drawn(page)
    assert page.locator("#drawing > svg .box.node").count() == 9
    assert page.evaluate(SMALLEST) >= 9
    assert page.evaluate(OVERLAPPING) == []
    assert page.evaluate(CUT) == 0
    page.close()


@pytest.mark.corpus
def test_what_is_too_much_even_so_has_its_names_only(browser: Browser, tmp_path: Path) -> None:
    directory, launch = Path(str(find_corpus())) / "ros1/ipa320+cob_robots", "cob_bringup/robots/cob4-16.xml"
    target = tmp_path / "report.html"
    write_report(directory, target, launch, "--workspace", ".")
    page = browser.new_page(viewport={"width": 1440, "height": 900}, reduced_motion="reduce")
    page.goto(target.as_uri())
    drawn(page)
    assert page.locator("#drawing > svg .box").count() > 25
    assert page.evaluate(SMALLEST) >= 9
    assert page.evaluate(CUT) == 0
    assert page.evaluate(OVERLAPPING) == []
    page.close()
