"""Names from launch files are shown, and nothing else: no dialog, no element, no request, no complaint (see ``open_report``)."""

from __future__ import annotations

import pytest

from tests.report.html.browser.hostile import NAMES
from tests.report.html.browser.reading import drawn, fragment, lines

pytestmark = pytest.mark.chromium

INJECTED = "img, iframe, object, embed, form, [onerror], [onload], [style], a[href^='javascript' i], script:nth-of-type(4)"


def test_nothing_is_injected_anywhere(open_report):
    page = open_report("hostile")
    assert page.locator(INJECTED).count() == 0
    for group in ("Launch file", "Package", "Namespace"):
        page.get_by_role("group", name="Group nodes by").get_by_role("button", name=group).click()
    for toggle in ("Params", "Hub topics", "Topics as boxes"):
        page.get_by_role("group", name="Show").get_by_role("button", name=toggle).click()
    drawn(page)
    for opener in page.locator(".openers button").all():
        opener.click()
    page.locator("details:not([open]) > summary").evaluate_all("all => all.forEach(each => { each.parentElement.open = true; })")
    assert page.locator(INJECTED).count() == 0
    assert page.title() == "<b>hostile</b> – launchlint"


def test_every_thing_can_be_selected_and_linked_to(open_report):
    page = open_report("hostile")
    rows = {}
    for table in ("nodes", "topics", "services", "params", "findings"):
        page.locator(".openers").get_by_role("button", name=table.capitalize()).click()
        links = page.locator(f"#table-{table} a[href^='#']")
        rows[table] = links.count()
        for at in range(0, links.count(), 9):
            links.nth(at).dispatch_event("click")
            drawn(page)
            heading = lines(page.locator("#panel"))[2]
            address = fragment(page)
            page.evaluate("location.hash = ''")
            page.evaluate("address => { location.hash = address; }", address)
            page.wait_for_function("address => location.hash === '#' + address", arg=address)
            assert lines(page.locator("#panel"))[2] == heading
    assert page.locator(INJECTED).count() == 0
    assert all(rows.values())


def test_names_can_be_searched_for(open_report):
    page = open_report("hostile")
    field = page.get_by_role("combobox", name="Search names")
    for name in NAMES:
        field.fill(name[:200])
        field.press("Enter")
        drawn(page)
    assert page.locator(INJECTED).count() == 0


def test_cards_of_hostile_launch_files(open_report):
    page = open_report("hostile_cards", "#")
    cards = page.locator("#landing .card")
    assert cards.count() > 1
    assert any("<img src=x onerror=alert(1)>.launch" in each for each in cards.all_text_contents())
    assert page.locator("#landing img, #landing script").count() == 0
