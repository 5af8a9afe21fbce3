"""What the panel says of each kind of thing."""

from __future__ import annotations

import pytest

from tests.report.html.browser.reading import drawn, lines

pytestmark = pytest.mark.chromium


THINGS = {
    "node": "#node=/perception/detector",
    "conditional-node": "#node=/base/driver",
    "unknown-node": "#node=/mystery",
    "topic": "#topic=/base/ticks",
    "dangling-topic": "#topic=/perception/right/image_raw",
    "param": "#param=/base/driver/rate_limit",
    "namespace": "#container=/perception",
}


def test_what_the_panel_says_of_each_thing(open_report, snapshot):
    page = open_report()
    for name, address in THINGS.items():
        page.evaluate("address => { location.hash = address; }", address)
        drawn(page)
        page.locator("#panel details").evaluate_all("all => all.forEach(each => { each.open = true; })")
        snapshot(f"panel-{name}.txt", "\n".join(lines(page.locator("#panel"))) + "\n")


def test_only_many_names_that_it_may_have_and_nobody_uses_are_folded(open_report):
    page = open_report("perhaps", "#node=/talk")
    told = lines(page.locator("#panel"))
    said, heard = told.index("Publishes"), told.index("Subscribes to")
    assert [line for line in told[said:heard] if line.startswith("/")] == ["/left_said", "/right_said"]
    assert [line for line in told[heard:] if line.startswith("/")] == ["/heard"]
    summary = "9 more that it may have, and nobody is known to use"
    assert summary in told
    page.get_by_text(summary).click()
    assert "/heard_8" in lines(page.locator("#panel"))


def test_finding_with_its_lines_and_its_fix(open_report, snapshot):
    page = open_report(fragment="#entry=tools.launch")
    page.locator("#panel .findings a").first.click()
    snapshot("panel-finding.txt", "\n".join(lines(page.locator("#panel"))) + "\n")
    assert page.locator("#panel mark").all_inner_texts() == ["camera"]


def test_a_line_of_the_drawing_says_what_runs_along_it(open_report):
    page = open_report(fragment="#open=")
    page.locator("#drawing > svg .name").first.click()
    assert lines(page.locator("#panel"))[1] in ("Line", "Topic", "Action", "Service")


def test_places_are_links_to_the_repository(open_report):
    page = open_report(fragment="#node=/base/driver")
    assert page.locator("#panel a.place").evaluate_all("all => all.map(each => each.href)") == [
        f"https://example.org/robot/blob/main/robot.launch#L{line}" for line in (7, 6, 7, 5, 4)
    ]


def test_files_that_start_nothing_and_nodes_that_nobody_knows_are_explained(open_report, snapshot):
    for name in ("empty", "unknown"):
        page = open_report(name)
        snapshot(f"overview-{name}.txt", "\n".join(lines(page.locator("#panel"))) + "\n")
    assert open_report("empty").locator(".stage-empty").inner_text() == (
        "This launch file starts no nodes, so there is nothing to draw. Its params and findings are in the tables below."
    )


def test_what_stands_in_no_node_has_its_place_and_the_verdict_says_what_is_missing(open_report):
    page = open_report("between", "#group=file&open=0&container=0")
    assert page.locator("#verdict").inner_text() == "cannot be told: it needs the environment variable SITE"
    box = page.locator('#drawing > svg .box.open[data-id="g:file:0"]')
    assert box.locator(":scope > .badge > title").text_content() == "2 findings"
    assert lines(page.locator("#panel h2").first) == ["part.launch"]
    told = " ".join(lines(page.locator("#panel .findings")))
    assert [rule for rule in ("LL103", "LL104", "LL206") if rule in told] == ["LL104", "LL206"]
