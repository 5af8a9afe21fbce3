"""The page that opens where there are several launch files."""

from __future__ import annotations

import pytest
from playwright.sync_api import expect

from tests.report.html.browser.reading import boxes, drawn, fragment, lines

pytestmark = pytest.mark.chromium

COUNTED = """(() => {
  const parse = JSON.parse;
  window.parsed = 0;
  JSON.parse = (...given) => ((window.parsed += 1), parse(...given));
})()"""


def titles(page) -> list[str]:
    shown = page.locator(".card:visible h3")
    # What was out of sight (content-visibility) shows no text before the next frame.
    expect(shown.first).not_to_have_text("", use_inner_text=True)
    return shown.all_inner_texts()


def test_a_card_for_each_launch_file_the_worst_first(open_report):
    page = open_report(fragment="#")
    assert titles(page) == ["tools.launch", "robot.launch"]
    refused, loads = page.locator(".card").all()
    assert lines(refused)[1:] == ["refused by roslaunch: two nodes are named /camera", "2 nodes", "all known", "1 error"]
    assert lines(loads)[1:] == ["loads", "8 nodes", "7 of 8 known", "1 info"]
    assert page.locator(".card svg.thumbnail path").count() > 0
    assert page.locator("#verdict").inner_text() == "1 of 2 launch files load, 1 refused by roslaunch"
    assert page.locator("#counts li").all_inner_texts() == ["2 launch files", "1 error", "1 info", "10 nodes started", "9 known"]
    assert page.locator("#tree, #panel, #tables, #drawing").evaluate_all("all => all.some(each => each.checkVisibility())") is False


def test_a_card_opens_its_launch_file_and_there_is_a_way_back(open_report):
    page = open_report(fragment="#")
    page.get_by_role("link", name="robot.launch").click()
    assert "/docking" in [label.split(",")[0] for label in boxes(page)]
    assert fragment(page) == "entry=robot.launch"
    page.go_back()
    assert titles(page) == ["tools.launch", "robot.launch"]
    page.get_by_label("Launch file", exact=True).select_option(label="tools.launch (refused, 1 finding)")
    assert lines(page.locator("#panel"))[1] == "tools.launch"
    page.keyboard.press("Escape")
    assert fragment(page) == ""
    assert titles(page) == ["tools.launch", "robot.launch"]
    page.get_by_role("link", name="two nodes are named /camera").click()
    drawn(page)
    assert lines(page.locator("#panel"))[1:3] == ["LL301 duplicate-node-name", "two nodes are named /camera"]


def test_what_nobody_opens_is_not_read(open_report, browser, reports):
    page = browser.new_page()
    page.add_init_script(COUNTED)
    page.goto(reports("robot").as_uri())
    drawn(page)
    assert page.evaluate("window.parsed") == 1
    page.get_by_role("link", name="tools.launch").click()
    drawn(page)
    assert page.evaluate("window.parsed") == 2
    page.close()


@pytest.mark.parametrize("script", [True, False])
def test_a_pull_request_shows_what_changed_first(open_report, script):
    page = open_report("pull", "#", java_script_enabled=script)
    groups = page.locator(".landing-cards h2").all_inner_texts()
    assert groups == ["Changed since HEAD 3", "Not changed 1"]
    assert titles(page) == ["tools.launch", "robot.launch", "fresh.launch"]
    changes = [each.locator(".card-changes li").all_inner_texts() for each in page.locator(".card:visible").all()]
    assert changes == [
        ["refused → loads", "\N{MINUS SIGN}1 node", "+1 node", "1 new finding", "1 finding fixed"],
        ["\N{MINUS SIGN}1 connection", "+1 connection", "\N{MINUS SIGN}1 node", "+1 node", "1 new finding"],
        ["new launch file"],
    ]
    assert page.locator(".landing-findings .fixed li").all_inner_texts() == ["fixed LL301 two nodes are named /camera"]


def test_changes_are_stepped_through(open_report):
    page = open_report("pull", "#")
    seen = []
    for _ in range(4):
        page.keyboard.press("]")
        drawn(page)
        seen.append(fragment(page).partition("&")[0])
    page.keyboard.press("[")
    assert fragment(page).partition("&")[0] == seen[-2]
    assert len(set(seen)) == 4
    options = page.get_by_label("Launch file", exact=True).locator("option").all_inner_texts()
    assert "calm.launch" in options
    assert any(each.startswith("robot.launch (\N{MINUS SIGN}1 connection, +1 connection") for each in options)


def test_findings_of_the_same_words_are_one_line(open_report):
    page = open_report("copies")
    assert page.locator("#counts li").all_inner_texts()[:2] == ["1 warning", "40 infos"]
    items = page.locator("#panel .findings > li").all_inner_texts()
    assert len(items) < 8
    assert any("and at 39 more places" in each for each in items)
    page.locator(".openers").get_by_role("button", name="Findings").click()
    assert page.locator("#table-findings tr[data-index]").count() < 8
    assert page.locator("#table-findings").get_by_text("39 more places").count() == 1
