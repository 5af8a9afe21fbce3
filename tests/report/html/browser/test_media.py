"""On paper, on a narrow screen, in both themes, and without JavaScript."""

from __future__ import annotations

import re

import pytest

from tests.report.html.browser.paper import PAPERS, ink, sheets
from tests.report.html.browser.reading import drawn, lines

pytestmark = pytest.mark.chromium

TABLES = [
    "table-findings",
    "table-nodes",
    "table-topics",
    "table-services",
    "table-actions",
    "table-params",
    "table-unknown",
]


def test_print_shows_all_of_the_drawing_and_all_tables(open_report):
    page = open_report(fragment="#open=/base")
    page.evaluate("dispatchEvent(new Event('beforeprint'))")
    page.emulate_media(media="print")
    shown = page.evaluate(
        """() => {
          const frame = document.querySelector("#drawing > svg").getBoundingClientRect();
          const boxes = [...document.querySelectorAll("#drawing > svg .box")].map((each) => each.getBoundingClientRect());
          const inside = (box) => box.left >= frame.left && box.right <= frame.right && box.top >= frame.top && box.bottom <= frame.bottom;
          return boxes.length > 0 && boxes.every(inside);
        }"""
    )
    assert shown
    assert page.locator("#tables table:visible").evaluate_all("all => all.map(each => each.id)") == TABLES
    assert page.locator("#controls, #tree, #view-bar, .drawer-bar").evaluate_all("all => all.filter(each => each.offsetParent).length") == 0
    page.emulate_media(media="screen")
    page.evaluate("dispatchEvent(new Event('afterprint'))")
    assert page.locator("#drawing > svg").get_attribute("viewBox") is None


@pytest.mark.parametrize(("paper", "landscape"), PAPERS)
def test_fifty_nodes_take_one_sheet_and_each_sheet_of_a_table_has_its_heads(open_report, tmp_path, paper, landscape):
    printed = sheets(open_report("fifty"), tmp_path, paper, landscape=landscape)
    assert all(sheet.strip() for sheet in printed)
    left, top, right, bottom = ink(tmp_path, 1)
    assert 0.01 < left < 0.4 < 0.6 < right < 0.99
    assert 0.01 < top < bottom < 0.99
    titles = [number for number, sheet in enumerate(printed) if re.search(r"^ *Topics *$", sheet, re.MULTILINE)]
    heads = [
        number for number, sheet in enumerate(printed) if re.search(r"^ *Topic +Type +Publishers +Subscribers *$", sheet, re.MULTILINE)
    ]
    assert len(titles) == 1
    assert heads == list(range(titles[0], titles[0] + len(heads)))
    assert len(heads) > 1


def test_the_first_sheet_says_what_it_shows(open_report, tmp_path):
    printed = sheets(open_report("robot", "#entry=tools.launch"), tmp_path, "A4", landscape=False)
    assert "tools.launch" in printed[0]
    landing = sheets(open_report("robot", "#"), tmp_path, "A4", landscape=False)
    assert "tools.launch" in landing[0]  # its card stands below the head


def test_narrow_screens_show_one_part_at_a_time(open_report):
    page = open_report(viewport={"width": 390, "height": 760})
    parts = ("stage", "tree", "panel", "tables")
    shown = {}
    for label in ("Drawing", "Tree", "Details", "Tables"):
        page.locator("#sheets").get_by_role("button", name=label).click()
        shown[label] = [part for part in parts if page.locator(f"#{part}").is_visible()]
        assert page.evaluate("document.documentElement.scrollWidth") <= 390
    assert shown == {"Drawing": ["stage"], "Tree": ["tree"], "Details": ["panel"], "Tables": ["tables"]}
    page.locator("#sheets").get_by_role("button", name="Tree").click()
    page.get_by_role("treeitem", name="docking").click()
    assert lines(page.locator("#panel"))[1:3] == ["Node", "/docking"]


def test_the_theme_follows_the_system_until_it_is_chosen(open_report):
    page = open_report(color_scheme="dark")
    ground = "getComputedStyle(document.querySelector('#stage')).backgroundColor"
    dark = page.evaluate(ground)
    seen = [dark]
    for _ in range(3):
        page.get_by_role("button", name="Theme").click()
        seen.append(page.evaluate(ground))
    light = seen[1]
    assert light != dark
    assert seen == [dark, light, dark, dark]
    page.get_by_role("button", name="Theme").click()
    page.reload()
    drawn(page)
    assert page.evaluate(ground) == light


def test_without_javascript_everything_is_in_tables(open_report):
    page = open_report(java_script_enabled=False)
    assert page.locator("#tables table:visible").evaluate_all("all => all.map(each => each.id)") == TABLES
    assert page.locator("#table-topics tr[data-index] td:first-child").all_inner_texts() == [
        "/base/cmd_vel",
        "/base/odom",
        "/base/ticks",
        "/perception/detections",
        "/perception/left/image_raw",
        "/perception/right/image_raw",
        "/detections",
        "/image",
        "/image_raw",
    ]
    assert page.locator("#verdict").inner_text() == "1 of 2 launch files load, 1 refused by roslaunch"
    assert page.locator("#controls").inner_text() == ""
