"""The tables: of what is shown, sorted, filtered, and linked with the drawing both ways."""

from __future__ import annotations

import pytest

from tests.report.html.browser.reading import fragment, lines

pytestmark = pytest.mark.chromium


def column(page, table: str, number: int) -> list[str]:
    """The visible cells of a column."""
    read = f"all => all.filter(each => each.offsetParent).map(each => each.cells[{number}].innerText)"
    return page.locator(f"#table-{table} tr[data-index]").evaluate_all(read)


def opener(page, name: str):
    return page.locator(".openers").get_by_role("button", name=name)


def test_openers_count_what_belongs_to_the_launch_file(open_report):
    page = open_report()
    assert page.locator(".openers button").all_text_contents() == [
        "Findings1",
        "Nodes9",
        "Topics6",
        "Services3",
        "Actions1",
        "Params3",
        "Unknown programs1",
        "Library",
    ]
    page.get_by_label("Launch file", exact=True).first.select_option(index=2)
    assert page.locator(".openers button").all_text_contents() == [
        "Findings1",
        "Nodes2",
        "Topics3",
        "Services1",
        "Actions0",
        "Params0",
        "Unknown programs1",
        "Library",
    ]


def test_heads_sort(open_report):
    page = open_report()
    opener(page, "Nodes").click()
    assert column(page, "nodes", 0) == [
        "/base/driver",
        "/base/odometry",
        "/base/simulator",
        "/docking",
        "/mystery",
        "/perception/detector",
        "/perception/left/camera",
        "/perception/right/camera",
        "/perception/tracker",
    ]
    page.locator("#table-nodes").get_by_role("button", name="Program").click()
    programs = ["drive/driver", "drive/odometry", "drive/simulator", "mystery/box"]
    programs += ["vision/camera", "vision/camera", "vision/detector", "vision/dock_client", "vision/tracker"]
    assert column(page, "nodes", 1) == programs
    page.locator("#table-nodes").get_by_role("button", name="Program").click()
    assert page.locator("#table-nodes th[aria-sort]").all_inner_texts() == ["Program"]
    assert column(page, "nodes", 1) == programs[::-1]


def test_rows_are_filtered(open_report):
    page = open_report()
    opener(page, "Topics").click()
    page.get_by_role("searchbox", name="Filter rows").fill("image left")
    assert column(page, "topics", 0) == ["/perception/left/image_raw"]


def test_a_row_selects_and_the_selection_marks_its_row(open_report):
    page = open_report()
    opener(page, "Topics").click()
    page.locator("#table-topics").get_by_role("link", name="/base/ticks").click()
    assert fragment(page) == "topic=/base/ticks"
    assert lines(page.locator("#panel"))[1:3] == ["Topic", "/base/ticks"]
    page.get_by_role("treeitem", name="docking").click()
    opener(page, "Nodes").click()
    assert page.locator("#table-nodes tr[aria-current=true] td").first.inner_text() == "/docking"


def test_rows_of_all_launch_files_on_demand(open_report):
    page = open_report()
    opener(page, "Findings").click()
    assert column(page, "findings", 1) == ["LL507 param-never-read"]
    page.get_by_label("all launch files").check()
    assert column(page, "findings", 1) == ["LL507 param-never-read", "LL301 duplicate-node-name"]
    page.locator("#table-findings").get_by_role("link", name="two nodes are named /camera").click()
    assert fragment(page).endswith("&entry=tools.launch")


def test_the_library_is_a_drawer_too(open_report):
    page = open_report()
    opener(page, "Library").click()
    assert page.locator("#library .program summary").first.is_visible()
    opener(page, "Library").click()
    assert page.locator("#library").is_hidden()
