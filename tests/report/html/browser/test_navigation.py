"""Moving through a report: expand, focus, search, select, hide, and what is shown at all."""

from __future__ import annotations

import pytest

from tests.report.html.browser.reading import boxes, drawn, fragment, lines

pytestmark = pytest.mark.chromium

UNREAD = "drive/driver does not read the param rate_limit, which is set for /base/driver"


def names(page) -> list[str]:
    """The first words of what is drawn: names."""
    return [label.split(",")[0] for label in boxes(page)]


def test_expanding_a_namespace_shows_its_nodes_in_place(open_report):
    page = open_report(fragment="#open=")
    assert names(page) == ["/base", "/docking", "/mystery", "/perception"]
    page.locator('[data-fold="g:namespace:/base"]').click()
    assert names(page) == ["/base", "/base/driver", "/base/odometry", "/base/simulator", "/docking", "/mystery", "/perception"]
    assert fragment(page) == "open=/base"
    page.locator('[data-fold="g:namespace:/base"]').click()
    assert names(page) == ["/base", "/docking", "/mystery", "/perception"]


def test_focus_draws_one_namespace_with_what_it_talks_to(open_report):
    page = open_report(fragment="#container=/perception")
    page.get_by_role("button", name="Focus on it").click()
    assert {"/perception/detector", "/perception/tracker"} <= set(names(page))
    assert "/mystery" not in names(page)
    assert lines(page.locator(".scope"))[0].startswith("Focus: /perception")
    page.locator(".scope").get_by_role("button", name="Leave").click()
    assert "/mystery" in names(page)


def test_search_finds_names_types_programs_params_and_files(open_report):
    page = open_report()
    field = page.get_by_role("combobox", name="Search names")
    found = {}
    for words in ("detec", "Ticks", "drive/odo", "rate_limit", "camera.launch", "Odometry", "dock action", "no such thing"):
        field.fill(words)
        found[words] = [" | ".join(lines(option)) for option in page.get_by_role("option").all() if option.is_visible()]
    assert found == {
        "detec": [
            "node | /perception/detector | vision/detector",
            "topic | /perception/detections | vision_msgs/Detection2DArray",
            "topic | /detections | in tools.launch",
            "node | /camera | in tools.launch",
        ],
        "Ticks": ["topic | /base/ticks | drive_msgs/Ticks"],
        "drive/odo": ["node | /base/odometry | drive/odometry"],
        "rate_limit": [
            "param | /base/driver/rate_limit | 1.5",
            f"finding | {UNREAD} | LL507 param-never-read robot.launch:7",
        ],
        "camera.launch": ["file | camera.launch | included by robot.launch"],
        "Odometry": ["node | /base/odometry | drive/odometry", "topic | /base/odom | nav_msgs/Odometry"],
        "dock action": ["action | /dock | drive_msgs/DockAction"],
        "no such thing": ["Nothing on this page is called that."],
    }


def test_a_result_is_selected_and_brought_into_view(open_report):
    page = open_report(fragment="#open=")
    field = page.get_by_role("combobox", name="Search names")
    field.fill("left/camera")
    field.press("Enter")
    assert lines(page.locator("#panel"))[1:3] == ["Node", "/perception/left/camera"]
    assert "/perception/left/camera" in names(page)
    assert page.get_by_role("treeitem", selected=True).get_attribute("data-id") == "n:6"


def test_searching_dims_what_does_not_fit(open_report):
    page = open_report()
    page.get_by_role("combobox", name="Search names").fill("odometry")
    page.wait_for_selector("#drawing > svg.searching")
    assert page.locator("#drawing > svg .box.match").evaluate_all("all => all.map(each => each.dataset.id)") == ["n:1"]
    page.get_by_role("combobox", name="Search names").press("Escape")
    page.wait_for_selector("#drawing > svg:not(.searching)")


def test_clicking_a_node_selects_it(open_report):
    page = open_report()
    page.locator('#drawing > svg [data-id="n:1"]').click()
    assert lines(page.locator("#panel"))[1:3] == ["Node", "/base/odometry"]
    assert fragment(page) == "node=/base/odometry"


def test_hiding_a_namespace_in_the_tree_takes_it_out_of_the_drawing(open_report):
    page = open_report()
    page.locator('#tree [data-id="g:namespace:/perception"] .hide').click()
    assert "/perception" not in names(page)
    assert fragment(page) == "hide=g%3Anamespace%3A/perception"
    page.get_by_role("button", name="Show all").click()
    assert "/perception" in names(page)


def test_the_tree_groups_by_launch_file_and_by_package(open_report):
    page = open_report()
    top = {}
    for label in ("Launch file", "Package", "Namespace"):
        page.get_by_role("group", name="Group nodes by").get_by_role("button", name=label).click()
        drawn(page)
        top[label] = page.locator('#tree [aria-level="1"]').all_text_contents()
    by_namespace = ["/base 1 finding 3 nodes", "/perception 4 nodes", "docking", "mystery not known"]
    assert top == {
        "Launch file": by_namespace,
        "Package": ["drive 1 finding 3 nodes", "mystery 1 node", "vision 5 nodes"],
        "Namespace": by_namespace,
    }


def test_layers_and_filters_change_what_is_drawn(open_report):
    page = open_report(fragment="#open=/base")
    everything = names(page)
    page.get_by_role("button", name="With findings").click()
    assert names(page) == ["/base", "/base/driver"]
    page.get_by_role("button", name="With findings").click()
    page.get_by_role("button", name="Not connected").click()
    assert names(page) == ["/base", "/base/driver", "/perception"]
    page.get_by_role("button", name="Not connected").click()
    assert names(page) == everything
    page.get_by_role("button", name="Topics as boxes").click()
    assert "/base/ticks" in names(page)
    for layer in ("Topics", "Services", "Actions"):
        page.get_by_role("group", name="Show").get_by_role("button", name=layer, exact=True).click()
    drawn(page)
    assert page.locator("#drawing > svg .line").count() == 0
    assert fragment(page) == "open=/base&layers=&topicsAsNodes=yes"


def test_a_configuration_leaves_out_what_it_does_not_start(open_report):
    page = open_report(fragment="#open=/base")
    page.get_by_label("Configuration").select_option("sim:=true")
    assert names(page) == ["/base", "/base/odometry", "/base/simulator", "/docking", "/mystery", "/perception"]
    page.locator(".openers").get_by_role("button", name="Nodes").click()
    assert page.locator("#table-nodes tr[data-index]:visible td:first-child").all_inner_texts() == [
        "/base/odometry",
        "/base/simulator",
        "/docking",
        "/mystery",
        "/perception/detector",
        "/perception/left/camera",
        "/perception/right/camera",
        "/perception/tracker",
    ]


def test_another_launch_file_is_shown_whole(open_report):
    page = open_report()
    page.get_by_label("Launch file", exact=True).first.select_option(label="tools.launch (refused, 1 finding)")
    assert page.locator("#verdict").inner_text() == "refused by roslaunch: two nodes are named /camera"
    assert lines(page.locator("#panel"))[:3] == [
        "Launch file",
        "tools.launch",
        "refused roslaunch does not load it: two nodes are named /camera",
    ]
    assert fragment(page) == "entry=tools.launch"


@pytest.mark.parametrize("script", [True, False])
def test_what_is_refused_with_other_args_is_said_at_the_top(open_report, script):
    page = open_report("otherwise", java_script_enabled=script)
    assert page.locator("#verdict").inner_text() == "loads; refused with sim:=true: two nodes are named /a"
    assert page.locator("#verdict").get_attribute("class") == "error"
    if script:
        assert lines(page.locator("#panel"))[2] == "refused with other args with sim:=true: two nodes are named /a"
    else:
        assert page.locator("p.empty").first.inner_text() == "refused with sim:=true: two nodes are named /a"
