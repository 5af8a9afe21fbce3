"""axe-core finds nothing, in both themes and in the states of the page that look most different."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.report.html.browser.reading import drawn

pytestmark = [pytest.mark.chromium, pytest.mark.axe]

STATES = {
    "landing": ("robot", "#"),
    "pull request": ("pull", "#"),
    "overview": ("robot", ""),
    "node": ("robot", "#node=/base/driver&open=/base"),
    "unknown node": ("robot", "#node=/mystery"),
    "refused": ("robot", "#entry=tools.launch"),
    "changed": ("changed", ""),
    "empty": ("empty", ""),
}


@pytest.fixture
def problems(axe_core):
    """A function: what axe-core complains of on a page: rule, and the elements."""
    source = Path(axe_core, "node_modules", "axe-core", "axe.min.js").read_text(encoding="utf-8")

    def found(page) -> list[str]:
        page.evaluate(source)
        result = page.evaluate("axe.run(document, {resultTypes: ['violations']})")
        return [f"{each['id']}: {node['target']} {node['failureSummary']}" for each in result["violations"] for node in each["nodes"]]

    return found


@pytest.mark.parametrize("state", STATES)
def test_state_in_both_themes(open_report, problems, state):
    name, fragment = STATES[state]
    page = open_report(name, fragment)
    found = {}
    for scheme in ("light", "dark"):
        page.emulate_media(color_scheme=scheme)
        found[scheme] = problems(page)
    assert found == {"light": [], "dark": []}


def test_what_opens(open_report, problems):
    page = open_report(color_scheme="dark")
    page.locator(".openers").get_by_role("button", name="Nodes").click()
    page.get_by_role("combobox", name="Search names").fill("camera")
    assert problems(page) == []
    page.get_by_role("combobox", name="Search names").press("Escape")
    page.locator(".menu summary").click()
    page.locator(".ll-legend summary").click()
    assert problems(page) == []
    page.locator(".popup summary").click()
    assert problems(page) == []
    page.locator("#tree [tabindex='0']").focus()
    page.keyboard.press("?")
    assert problems(page) == []


def test_narrow(open_report, problems):
    page = open_report(viewport={"width": 390, "height": 760})
    found = {}
    for label in ("Drawing", "Tree", "Details", "Tables"):
        page.locator("#sheets").get_by_role("button", name=label).click()
        found[label] = problems(drawn(page))
    assert found == {"Drawing": [], "Tree": [], "Details": [], "Tables": []}
