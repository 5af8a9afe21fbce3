"""Addresses: everything that is shown can be linked to, and back and forward work."""

from __future__ import annotations

import pytest

from tests.report.html.browser.reading import boxes, drawn, fragment, lines

pytestmark = pytest.mark.chromium

BAD = (
    "#node=/nobody",
    "#node=%",
    "#finding=__proto__",
    "#entry=constructor&configuration=x&group=__proto__&focus=/none&open=,,%00&hide=n:,g:",
    "#edge=e:1&layers=topics,&hubs=maybe",
    "#node=/camera~~99999",
    "#=&&==&#",
    f"#node={'/a' * 5000}",
)


@pytest.mark.parametrize(
    ("address", "heading"),
    [
        ("#node=/base/odometry", ["Node", "/base/odometry"]),
        ("#topic=/base/ticks", ["Topic", "/base/ticks"]),
        ("#service=/base/driver/stop", ["Service", "/base/driver/stop"]),
        ("#action=/dock", ["Action", "/dock"]),
        ("#param=/robot_name", ["Param", "/robot_name"]),
        ("#container=/perception/left", ["Namespace", "/perception/left"]),
        ("#container=vision&group=package", ["Package", "vision"]),
        ("#node=/camera~~2", ["Node", "/camera"]),
    ],
)
def test_a_link_opens_what_it_names(open_report, address, heading):
    page = open_report(fragment=address)
    assert lines(page.locator("#panel"))[1:3] == heading


def test_a_link_to_a_finding_opens_the_launch_file_it_is_in(open_report):
    page = open_report(fragment="#entry=tools.launch")
    page.locator("#panel .findings a").first.click()
    found = fragment(page)
    assert found.startswith("finding=")
    again = open_report(fragment=f"#{found.split('&')[0]}")
    assert lines(again.locator("#panel"))[1:3] == ["LL301 duplicate-node-name", "two nodes are named /camera"]
    assert fragment(again) == found.split("&")[0]


def test_the_view_is_in_the_address_and_comes_back_from_it(open_report):
    page = open_report(fragment="#open=")
    page.get_by_label("Configuration").select_option("sim:=true")
    page.get_by_role("button", name="Hub topics").click()
    page.get_by_role("button", name="Not connected").click()
    page.get_by_role("treeitem", name="docking").click()
    drawn(page)
    address = fragment(page)
    assert address == "node=/docking&configuration=sim:=true&open=&hubs=yes&danglingOnly=yes"
    again = open_report(fragment=f"#{address}")
    assert boxes(again) == boxes(page)
    assert again.get_by_label("Configuration").input_value() == "1"
    assert again.get_by_role("button", name="Not connected").get_attribute("aria-pressed") == "true"


def test_back_and_forward_go_through_what_was_selected(open_report):
    page = open_report()
    for name in ("docking", "mystery"):
        page.get_by_role("treeitem", name=name).click()
    seen = [lines(page.locator("#panel"))[2]]
    for _ in range(2):
        page.go_back()
        seen.append(lines(page.locator("#panel"))[1 if fragment(page) == "entry=robot.launch" else 2])
    page.go_forward()
    seen.append(lines(page.locator("#panel"))[2])
    assert seen == ["/mystery", "/docking", "robot.launch", "/docking"]


def test_a_bad_address_shows_what_would_be_shown_without_it(open_report):
    page = open_report(fragment=BAD[0])
    seen = {}
    for address in BAD:
        page.evaluate("address => { location.hash = address; }", address)
        drawn(page)
        seen[address] = (page.locator("#panel .kind").inner_text(), page.locator("#panel h2").inner_text(), boxes(page) != [])
    nothing = ("Launch file", "robot.launch", True)
    assert seen == {address: ("Node", "/camera", True) if "camera" in address else nothing for address in BAD}


def test_links_in_the_panel_are_addresses(open_report):
    page = open_report(fragment="#node=/perception/detector")
    assert page.locator("#panel a[href^='#']").evaluate_all("all => all.map(each => each.getAttribute('href'))") == [
        "#topic=/perception/detections",
        "#node=/perception/tracker",
        "#topic=/perception/left/image_raw",
        "#node=/perception/left/camera",
    ]
