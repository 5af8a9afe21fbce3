"""What people come to the page for, each in at most three steps: a step is a click, a choice, or words typed with Enter."""

from __future__ import annotations

from collections.abc import Callable

import pytest
from playwright.sync_api import Page

from tests.report.html.browser.paper import PAPERS, ink, sheets
from tests.report.html.browser.reading import boxes, drawn, fragment, lines

pytestmark = pytest.mark.chromium

MOST = 3


class Steps:
    """A page on which every step is counted."""

    def __init__(self, page: Page) -> None:
        self.page = page
        self.taken = 0

    def search(self, words: str) -> None:
        field = self.page.get_by_role("combobox", name="Search names")
        field.fill(words)
        field.press("Enter")
        self._step()

    def press(self, name: str, group: str = "") -> None:
        within = self.page.get_by_role("group", name=group) if group else self.page
        within.get_by_role("button", name=name, exact=True).click()
        self._step()

    def row(self, name: str) -> None:
        self.page.get_by_role("treeitem", name=name).first.click()
        self._step()

    def do(self, act: Callable[[Page], object]) -> None:
        act(self.page)
        self._step()

    @property
    def panel(self) -> list[str]:
        return lines(self.page.locator("#panel"))

    def _step(self) -> None:
        self.taken += 1
        drawn(self.page)


@pytest.fixture
def steps(open_report):
    opened: list[Steps] = []

    def start(name: str = "robot", address: str = "#entry=robot.launch", **options: object) -> Steps:
        opened.append(Steps(open_report(name, address, **options)))
        return opened[-1]

    yield start
    assert [each.taken for each in opened if each.taken > MOST] == []


def test_who_exchanges_this_topic(steps):
    task = steps()
    task.search("image_raw")
    assert "Publishers: 1" in task.panel


def test_why_is_this_node_alone(steps):
    task = steps()
    task.row("mystery")
    assert "What it does is not known" in task.panel


def test_why_does_one_not_hear_the_other(steps):
    task = steps()
    task.row("docking")
    task.do(lambda page: page.locator("#panel input.pair").fill("/perception/tracker"))
    assert "/perception/tracker does not hear /docking" in task.panel
    assert fragment(task.page).startswith("pair=n(/docking)")


def test_why_does_a_node_not_hear_this_topic(steps):
    task = steps()
    task.search("/base/ticks")
    task.do(lambda page: page.locator("#panel input.pair").fill("/mystery"))
    assert fragment(task.page).startswith("pair=n(/mystery)")
    assert any("/base/ticks" in line for line in task.panel)


def test_where_is_this_name_made(steps):
    task = steps()
    task.search("detector")
    assert any(line.startswith("in the code: ") for line in task.panel)
    assert any("robot.launch:" in line for line in task.panel)


def test_what_is_wrong_and_where(steps):
    task = steps()
    task.do(lambda page: page.locator("#panel .findings a").first.click())
    assert task.page.locator("#panel pre.source mark").count() == 1


def test_what_did_this_change_do(steps):
    task = steps("changed")
    assert any(line.startswith("Lost since") for line in task.panel)
    assert any(line.startswith("Gained since") for line in task.panel)


@pytest.mark.parametrize("typed", ["tracker", "trckr", "trakcer"])
def test_find_a_node_even_where_it_is_misspelt(steps, typed):
    task = steps()
    task.search(typed)
    assert task.panel[2] == "/perception/tracker"


def test_fold_an_include_and_see_its_ports(steps):
    task = steps(address="#entry=robot.launch&group=file")
    task.do(lambda page: page.locator("#tree .row.include").first.click())
    assert task.panel[1] == "Include"
    titles = ("Comes in", "Goes out", "Waits for what nobody here is known to offer", "Offers what nobody here is known to use")
    assert any(line in titles for line in task.panel)
    assert task.page.locator("#drawing .told text, #drawing .port.own, #drawing .name.lit").count() > 0


def test_share_exactly_this_view(steps):
    task = steps(permissions=["clipboard-read", "clipboard-write"])
    task.row("docking")
    task.do(lambda page: page.get_by_role("button", name="Zoom in").click())
    task.press("Copy link")
    link = task.page.evaluate("navigator.clipboard.readText()")
    place = (
        "document.querySelector('#drawing > svg > g').getAttribute('transform').replace(/[0-9.]+/g, (each) => Math.round(each * 10) / 10)"
    )
    seen, transform = boxes(task.page), task.page.evaluate(place)
    again = steps(address=f"#{link.partition('#')[2]}")
    assert boxes(again.page) == seen
    assert again.panel[2] == "/docking"
    number = "text => text.match(/[0-9.]+/g).map(Number)"
    before, after = (again.page.evaluate(number, each) for each in (transform, again.page.evaluate(place)))
    # The bar above may be higher, as the link says what is open: the middle of the screen stays.
    assert [round(abs(one - other) / 3) for one, other in zip(before[::2], after[::2], strict=True)] == [0, 0]


def test_save_a_picture(steps):
    task = steps()
    task.do(lambda page: page.locator("summary", has_text="Export").click())
    with task.page.expect_download() as download:
        task.press("PNG picture")
    content = download.value.path().read_bytes()
    assert content.startswith(b"\x89PNG")
    assert len(content) > 5000


@pytest.mark.parametrize(("paper", "landscape"), PAPERS)
def test_print(steps, tmp_path, paper, landscape):
    printed = sheets(steps().page, tmp_path, paper, landscape=landscape)
    assert len(printed) <= 5
    assert all(sheet.strip() for sheet in printed)
    left, _, right, _ = ink(tmp_path, 1)
    assert 0 < left < right < 1


def test_params_and_where_they_come_from(steps):
    task = steps()
    task.row("driver")
    assert any("param" in line for line in task.panel)
    assert task.page.locator("#panel .params .place").count() > 0


def test_without_the_noise(steps):
    task = steps()
    task.do(lambda page: (page.locator("#filter").fill("perception -camera"), page.wait_for_timeout(400)))
    assert boxes(task.page) == ["/perception, 2 nodes"]
    assert "filter=perception%20-camera" in fragment(task.page)


def test_another_configuration(steps):
    task = steps()
    task.do(lambda page: page.get_by_label("Configuration").select_option("sim:=true"))
    assert not any(box.startswith("/base/driver") for box in boxes(task.page))


def test_a_link_survives_a_new_node(steps):
    task = steps(address="#node=/perception/tracker&at=10,10,90,n(/perception/tracker)&open=/perception&hide=n:/docking")
    assert task.panel[2] == "/perception/tracker"
    assert not any(box.startswith("/docking") for box in boxes(task.page))
