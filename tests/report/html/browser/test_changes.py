"""A page that compares two revisions."""

from __future__ import annotations

import pytest

from tests.report.html.browser.reading import boxes, lines

pytestmark = pytest.mark.chromium


def test_panel_lists_what_is_lost_and_gained(open_report, snapshot):
    page = open_report("changed")
    snapshot("overview-changed.txt", "\n".join(lines(page.locator("#panel"))) + "\n")


def test_only_what_changed_is_expanded(open_report):
    page = open_report("changed")
    drawn = [label.split(",")[0] for label in boxes(page)]
    assert drawn == ["/base", "/docking", "/mystery", "/perception", "/riddle"]
    assert page.locator("#drawing > svg .box.added, #drawing > svg .box.removed").evaluate_all(
        "all => all.map(each => [...each.classList].at(-1))"
    ) == ["removed", "added"]


def test_tree_and_tables_mark_it(open_report):
    page = open_report("changed")
    assert page.locator("#tree .removed .label, #tree .added .label").all_inner_texts() == ["mystery", "riddle"]
    page.locator(".openers").get_by_role("button", name="Nodes").click()
    assert page.locator("#table-nodes tr.removed td:first-child, #table-nodes tr.added td:first-child").all_inner_texts() == [
        "/riddle",
        "/mystery",
    ]
