"""The drawing as it stands on the screen: nothing hides anything, what was opened stays in its place, and the picture can be taken away."""

from __future__ import annotations

import re
from typing import Any

import pytest
from lxml import etree
from playwright.sync_api import Page

from tests.report.html.browser.reading import drawn

pytestmark = pytest.mark.chromium

AREAS = """() => {
  const area = (each) => { const { x, y, width, height } = each.getBoundingClientRect(); return [x, y, width, height]; };
  const all = (selector) => [...document.querySelectorAll(`#drawing > svg.ll-drawing ${selector}`)];
  const named = (each) => each.querySelector("title").textContent.split("\\n")[0];
  return {
    boxes: all(".box:not(.open)").map((each) => [named(each), area(each.querySelector(".shape"))]),
    containers: all(".box.open").map((each) => [named(each), area(each.querySelector(".shape"))]),
    names: all(".names text").map((each) => [each.textContent, area(each)]),
    inBoxes: all(".box:not(.open)").flatMap((box) =>
      [...box.querySelectorAll(":scope > text")].map((each) =>
        [named(box), each.textContent, area(each), area(box.querySelector(".shape"))])),
  };
}"""

Area = tuple[float, float, float, float]


def overlap(one: Area, other: Area, by: float = 1.5) -> bool:
    """Whether two areas share more than their border."""
    sides = zip(one[:2], one[2:], other[:2], other[2:], strict=True)
    return all(a + by < b + d and b + by < a + c for a, c, b, d in sides)


def within(one: Area, other: Area) -> bool:
    """Whether an area lies in another one."""
    return all(b - 1 <= a and a + c <= b + d + 1 for a, c, b, d in zip(one[:2], one[2:], other[:2], other[2:], strict=True))


def place(page: Page, name: str) -> Area:
    """Where a box stands on the screen."""
    found: dict[str, Any] = page.evaluate(AREAS)
    return next(tuple(area) for title, area in [*found["boxes"], *found["containers"]] if title == name)


@pytest.mark.parametrize("report", ["robot", "changed", "hostile", "unknown"])
@pytest.mark.parametrize("view", ["", "#topicsAsNodes=yes", "#group=file", "#hubs=yes"])
def test_nothing_hides_a_name(open_report, report, view):
    page = open_report(report, view)
    found = page.evaluate(AREAS)
    areas = found["boxes"]
    assert len(areas) > 1
    assert [(a, b) for at, (a, one) in enumerate(areas) for b, other in areas[at + 1 :] if overlap(one, other)] == []
    assert [(name, box) for name, one in found["names"] for box, other in areas if overlap(one, other, 3)] == []
    assert [(box, text) for box, text, area, shape in found["inBoxes"] if not within(area, shape)] == []


def test_what_is_opened_stays_where_it_is(open_report):
    page = open_report("robot", "#open=")
    left, top, *_ = place(page, "/perception")
    page.locator("#drawing .box.folded", has_text="/perception").locator(".fold").first.click()
    page.locator("#drawing .box.open .head", has_text="/perception").wait_for()
    after = place(drawn(page), "/perception")
    assert (round(after[0]), round(after[1])) == (round(left), round(top))


SIGNS = """() => {
  window.signs = [];
  const host = document.getElementById("drawing");
  new MutationObserver(() => window.signs.push(getComputedStyle(host, "::after").content))
    .observe(host, { attributes: true, attributeFilter: ["class"] });
}"""


def test_a_drawing_that_takes_long_says_so(open_report):
    page = open_report("robot")
    page.evaluate(SIGNS)
    page.evaluate("() => { const now = performance.now.bind(performance); performance.now = () => 10_000 * now(); }")  # all takes long
    for name in ("Topics as boxes", "Services"):  # the first says how long the second is likely to take
        page.get_by_role("button", name=name, exact=True).click()
        drawn(page)
    assert '"Drawing …"' in page.evaluate("() => window.signs")
    assert page.locator("#drawing.waiting").count() == 0


def test_hub_topics_of_three_hundred_nodes_are_there_soon_or_it_says_that_they_come(open_report):
    page = open_report("three_hundred", "#entry=main.launch")
    page.evaluate(SIGNS)
    page.context.new_cdp_session(page).send("Emulation.setCPUThrottlingRate", {"rate": 4})  # so that it takes long anywhere
    took = page.evaluate("""() => new Promise((done) => {
      const host = document.getElementById("drawing");
      const from = performance.now();
      [...document.querySelectorAll("button")].find((each) => each.textContent === "Hub topics").click();
      const look = () => host.ariaBusy === "false" ? done(performance.now() - from) : requestAnimationFrame(look);
      look();
    })""")
    assert took <= 150 or '"Drawing …"' in page.evaluate("() => window.signs")
    assert page.locator("#drawing.waiting").count() == 0


def test_a_drag_moves_and_selects_nothing(open_report):
    page = open_report("robot", "#open=")
    left, top, *_ = place(page, "/base")
    page.mouse.move(left + 20, top + 20)
    page.mouse.down()
    page.mouse.move(left + 70, top + 50, steps=8)
    page.mouse.up()
    page.wait_for_timeout(100)
    after = place(page, "/base")
    assert (round(after[0] - left), round(after[1] - top)) == (pytest.approx(50, abs=10), pytest.approx(30, abs=10))
    assert page.locator("#drawing .chosen").count() == 0


def test_the_wheel_enlarges_around_the_pointer(open_report):
    page = open_report("robot", "#open=")
    left, top, width, _ = place(page, "/base")
    page.mouse.move(left, top)
    page.mouse.wheel(0, -300)
    page.wait_for_timeout(100)
    after = place(page, "/base")
    assert after[2] > 1.3 * width
    assert (round(after[0]), round(after[1])) == (pytest.approx(left, abs=2), pytest.approx(top, abs=2))


def test_selecting_a_node_lights_what_it_talks_to_and_the_way_there(open_report):
    page = open_report("robot", "#open=/base,/perception&node=/perception/tracker")
    lit = page.evaluate("""() => {
      const all = (selector) => [...document.querySelectorAll(`#drawing > svg.ll-drawing ${selector}`)];
      const titles = (selector) => all(selector).map((each) => each.querySelector("title").textContent);
      return { chosen: titles(".box.chosen"), boxes: titles(".box.lit").sort(), lines: titles(".line.lit").sort() };
    }""")
    assert lit == {
        "boxes": [
            '/base/driver\ndrive/driver\nonly where unless="$(arg sim)"',
            "/base/odometry\ndrive/odometry",
            "/perception/detector\nvision/detector",
            "/perception/tracker\nvision/tracker",
        ],
        "chosen": ["/perception/tracker\nvision/tracker"],
        # The way from container to container is three lines: to the border, between the borders, and from the border.
        "lines": [
            *["/base/driver/stop  std_srvs/Trigger"] * 3,
            *["/base/odom  nav_msgs/Odometry"] * 3,
            "/perception/detections  vision_msgs/Detection2DArray",
        ],
    }


def test_the_picture_is_a_document_of_its_own(open_report, tmp_path):
    page = open_report("robot", "#open=/base")
    page.locator(".menu summary").click()
    with page.expect_download() as download:
        page.get_by_role("button", name="SVG picture").click()
    file = tmp_path / "robot.svg"
    download.value.save_as(file)
    text = file.read_text(encoding="utf-8")
    tree = etree.fromstring(text.encode())
    titles = tree.xpath("//*[local-name()='g' and contains(concat(' ', @class, ' '), ' box ')]/*[local-name()='title']/text()")
    assert sorted(each.split("\n")[0] for each in titles) == [
        "/base",
        "/base/driver",
        "/base/odometry",
        "/base/simulator",
        "/docking",
        "/mystery",
        "/perception",
    ]
    assert re.findall(r"var\(--ll-(?!own)|https?://(?!www\.w3\.org/)|\sstyle=|<script|data-id=.{0,3}undefined", text) == []
    alone = page.context.new_page()
    alone.goto(file.as_uri())
    assert alone.evaluate("() => getComputedStyle(document.querySelector('.box.node .shape')).fill") == "rgb(255, 255, 255)"
