"""What a report shows before anything is touched."""

from __future__ import annotations

import pytest

from tests.report.html.browser.reading import boxes, lines

pytestmark = pytest.mark.chromium


def test_header_says_whether_it_loads_and_how_much_there_is(open_report):
    page = open_report()
    assert page.locator("#verdict").inner_text() == "loads"
    assert page.locator("#counts li").all_inner_texts() == ["1 info", "8 nodes", "1 more with other args", "1 not known", "6 topics"]
    assert page.get_by_label("Launch file", exact=True).first.locator("option").all_inner_texts() == [
        "All 2 launch files",
        "robot.launch (1 finding)",
        "tools.launch (refused, 1 finding)",
    ]
    assert page.get_by_label("Configuration").locator("option").all_inner_texts() == ["All 2 configurations", "default args", "sim:=true"]


def test_tree_shows_namespaces_with_their_nodes(open_report):
    page = open_report()
    read = "all => all.map(each => `${each.ariaLevel} ${each.textContent}`)"
    assert page.get_by_role("treeitem").evaluate_all(read) == [
        "1 /base 1 finding 3 nodes",
        "2 driver 1 finding",
        "2 odometry",
        "2 simulator",
        "1 /perception 4 nodes",
        "2 left 1 node",
        "3 camera",
        "2 right 1 node",
        "3 camera",
        "2 detector",
        "2 tracker",
        "1 docking",
        "1 mystery not known",
    ]


def test_panel_answers_what_is_wrong_and_what_is_not_connected(open_report):
    page = open_report()
    assert lines(page.locator("#panel")) == [
        "Launch file",
        "robot.launch",
        "What is wrong (1)",
        "info LL507 drive/driver does not read the param rate_limit, which is set for /base/driver",
        "robot.launch:7",
        "Does it connect?",
        "4 of 6 topics have both ends. 7 of 8 nodes known when it is started without args.",
        "Nobody here is known to publish, yet somebody may:",
        "/base/cmd_vel",
        "Nobody here is known to subscribe, yet somebody may:",
        "/perception/right/image_raw",
        "1 node not known",
        "Nothing is drawn from or to these, because nothing says what they do:",
        "/mystery",
        "mystery/box: no library knows it",
        (
            "mystery is not in the workspace: put the sources there, or name their directory with --workspace, "
            "and launchlint reads it by itself."
        ),
    ]


def test_drawing_shows_every_node_or_what_holds_it(open_report):
    page = open_report()
    assert boxes(page) == [
        "/base, 3 nodes",
        '/base/driver, drive/driver, only where unless="$(arg sim)"',
        "/base/odometry, drive/odometry",
        '/base/simulator, drive/simulator, only where if="$(arg sim)"',
        "/docking, vision/dock_client",
        "/mystery, mystery/box, unknown: no library knows mystery/box",
        "/perception, 4 nodes",
    ]
    assert page.locator(".stage-empty").is_hidden()
