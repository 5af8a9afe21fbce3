"""In an editor's panel: the page follows what it is told, says what was chosen in it, and opens where it stood."""

from __future__ import annotations

import pytest

from tests.report.html.browser.reading import fragment, lines

pytestmark = pytest.mark.chromium

HOST = """
window.said = [];
window.acquireVsCodeApi = () => ({
  postMessage: (message) => window.said.push(message),
  getState: () => JSON.parse(sessionStorage.getItem("state") ?? "null"),
  setState: (state) => sessionStorage.setItem("state", JSON.stringify(state)),
});
"""


def test_the_page_follows_and_answers(open_report):
    page = open_report(fragment="#entry=robot.launch", script=HOST)
    page.evaluate("window.postMessage({ launchlint: ['node', '/base/odometry'] })")
    page.wait_for_function("location.hash.includes('node=/base/odometry')")
    assert lines(page.locator("#panel"))[1:3] == ["Node", "/base/odometry"]
    assert page.evaluate("window.said") == []
    for bad in ("null", "3", "{ launchlint: 'node' }", "{ launchlint: ['node', '/nobody'] }", "{ launchlint: ['__proto__', '&entry=x'] }"):
        page.evaluate(f"window.postMessage({bad})")
    page.evaluate("window.postMessage({ launchlint: ['topic', '/base/ticks'] })")
    page.wait_for_function("location.hash.includes('topic=/base/ticks')")
    assert page.evaluate("JSON.parse(sessionStorage.getItem('state'))") == fragment(page)
    page.locator("#panel").get_by_text("/base/odometry", exact=True).first.click()
    assert page.evaluate("window.said") == [{"launchlint": ["node", "/base/odometry"]}]


def test_the_page_opens_where_it_stood(open_report):
    page = open_report(fragment="#node=/base/odometry", script=HOST)
    page.evaluate("sessionStorage.setItem('state', JSON.stringify('node=/base/odometry'))")
    page.evaluate("location.hash = ''")
    page.reload()
    page.wait_for_function("document.documentElement.classList.contains('interactive')")
    assert lines(page.locator("#panel"))[1:3] == ["Node", "/base/odometry"]
