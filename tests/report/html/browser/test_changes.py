"""A page that compares two revisions."""

from __future__ import annotations

import pytest

from tests.report.html.browser.reading import boxes, lines

pytestmark = pytest.mark.chromium

DRAWN = ["/base", "/docking", "/mystery", "/perception", "/perception/detector", "/perception/tracker", "/riddle", "left", "right"]
"""What is drawn at first: the detector listens to another camera now, so what is around it is open."""
MARKED = ["/perception changed", "8 added", "9 removed"]


def test_panel_lists_what_is_lost_and_gained(open_report, snapshot):
    page = open_report("changed")
    snapshot("overview-changed.txt", "\n".join(lines(page.locator("#panel"))) + "\n")


@pytest.mark.parametrize("width", [390, 1280, 1920])
def test_only_what_changed_is_expanded(open_report, width):
    page = open_report("changed", viewport={"width": width, "height": 800})
    drawn = [label.split(",")[0] for label in boxes(page)]
    assert drawn == DRAWN
    marks = "all => all.map(each => `${each.dataset.id.split(':').at(-1)} ${each.classList[each.classList.length - 1]}`)"
    assert page.locator("#drawing > svg .box:is(.added, .removed, .changed)").evaluate_all(marks) == MARKED


def test_tree_and_tables_mark_it(open_report):
    page = open_report("changed")
    assert page.locator("#tree .removed .label, #tree .added .label").all_inner_texts() == ["mystery", "riddle"]
    page.locator(".openers").get_by_role("button", name="Nodes").click()
    assert page.locator("#table-nodes tr.removed td:first-child, #table-nodes tr.added td:first-child").all_inner_texts() == [
        "/riddle",
        "/mystery",
    ]
