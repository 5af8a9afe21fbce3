"""The whole page without a mouse."""

from __future__ import annotations

import pytest

from tests.report.html.browser.reading import drawn, fragment, lines

pytestmark = pytest.mark.chromium

FOCUSED = "document.activeElement.textContent"
PLACE = "(({x, y, width, height}) => ({x: x + width / 2, y: y + height / 2}))(document.activeElement.getBoundingClientRect())"


def test_from_search_to_the_panel(open_report):
    page = open_report()
    page.keyboard.press("/")
    page.keyboard.type("camera")
    page.keyboard.press("ArrowDown")
    page.keyboard.press("ArrowDown")
    page.keyboard.press("Enter")
    assert page.evaluate(FOCUSED) == "/perception/right/camera"
    page.keyboard.press("Escape")
    assert lines(page.locator("#panel"))[0] == "Launch file"


def test_the_tree_is_walked_with_arrows(open_report):
    page = open_report(fragment="#open=")
    page.keyboard.press("t")
    seen = [page.evaluate(FOCUSED)]
    for key in (
        "ArrowRight",
        "ArrowDown",
        "End",
        "ArrowUp",
        "ArrowUp",
        "ArrowUp",
        "ArrowUp",
        "ArrowLeft",
        "Home",
        "ArrowLeft",
        "ArrowDown",
        "h",
    ):
        page.keyboard.press(key)
        seen.append(page.evaluate(FOCUSED))
    assert seen == [
        "/base 1 finding 3 nodes",
        "driver 1 finding",
        "odometry",
        "mystery not known",
        "docking",
        "tracker",
        "detector",
        "camera",
        "right 1 node",
        "/base 1 finding 3 nodes",
        "/base 1 finding 3 nodes",
        "/perception 4 nodes",
        "/perception 4 nodes",
    ]
    page.keyboard.press("Enter")
    assert fragment(page) == "container=/perception&open=&hide=g%3Anamespace%3A/perception"


def test_the_drawing_is_walked_with_arrows(open_report):
    page = open_report(fragment="#open=")
    page.keyboard.press("d")
    for key, axis, sign in (("ArrowDown", "y", 1), ("ArrowUp", "y", -1), ("ArrowLeft", "x", -1), ("ArrowRight", "x", 1)):
        before = page.evaluate(PLACE)
        page.keyboard.press(key)
        after = page.evaluate(PLACE)
        assert (after[axis] - before[axis]) * sign > 0 or after == before
    ends = []
    for key in ("Home", "End"):
        page.keyboard.press(key)
        ends.append(page.evaluate("document.activeElement.dataset.id"))
    assert len({*ends, None}) == 3
    page.locator('#drawing > svg [data-id="g:namespace:/base"]').focus()
    page.keyboard.press("Space")
    drawn(page)
    assert fragment(page) == "open=/base"
    assert page.evaluate("document.activeElement.dataset.id") == "g:namespace:/base"
    page.keyboard.press("Enter")
    assert lines(page.locator("#panel"))[1:3] == ["Namespace", "/base"]
    page.keyboard.press("f")
    drawn(page)
    assert "focus=/base" in fragment(page)
    page.keyboard.press("Escape")
    page.keyboard.press("Escape")
    assert fragment(page) == "open=/base"


def test_findings_one_after_the_other(open_report):
    page = open_report()
    page.keyboard.press("n")
    first = lines(page.locator("#panel"))[1]
    page.keyboard.press("N")
    assert [first, lines(page.locator("#panel"))[1]] == ["LL507 param-never-read", "LL507 param-never-read"]


def test_help_lists_the_keys_and_can_turn_single_ones_off(open_report):
    page = open_report()
    page.keyboard.press("?")
    help = page.get_by_role("dialog", name="Keyboard")
    assert help.get_by_role("row").first.inner_text().split() == ["/", "search"]
    help.get_by_label("Keys that are single letters or signs").uncheck()
    page.keyboard.press("Escape")
    assert help.is_hidden()
    page.keyboard.press("?")
    assert help.is_hidden()


def test_keys_typed_into_a_field_stay_there(open_report):
    page = open_report()
    page.keyboard.press("/")
    page.keyboard.type("n?b")
    assert page.get_by_role("combobox", name="Search names").input_value() == "n?b"
    assert page.get_by_role("dialog").count() == 0
