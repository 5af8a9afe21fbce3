"""What ROS 2 has and ROS 1 has not: quality of service, components, lifecycles, params of a node, launch files in Python."""

from __future__ import annotations

import pytest

from tests.report.html.browser.reading import drawn

pytestmark = pytest.mark.chromium


def test_a_robot_of_ros_2(open_report):
    page = open_report("ros2")
    drawing, panel = page.locator("#drawing > svg"), page.locator("#panel")
    names = drawing.locator(".name").all_text_contents()

    # Which two ends do not fit is seen at once, and what is unusual stands on the line.
    assert any("best_effort ≠ reliable" in each for each in names)
    assert any("transient_local" in each and "≠" not in each for each in names)
    colour = "all => all.map(each => getComputedStyle(each).stroke)"
    clashing = drawing.locator(".line.clash .course").evaluate_all(colour)
    assert len(set(clashing)) == 1
    assert clashing[0] not in drawing.locator(".line:not(.clash) .course").evaluate_all(colour)

    def panel_of(name: str) -> str:
        page.goto(page.url.split("#")[0] + f"#node={name}")
        drawn(page)
        panel.get_by_role("heading", name=name.rpartition("/")[2]).first.wait_for()
        return panel.inner_text()

    driver = panel_of("/driver")
    assert "QoS: best_effort" in driver
    assert "main.launch.py:9" in driver
    assert "frame" in driver
    assert "laser" in driver
    keeper = panel_of("/keeper")
    assert "lifecycle" in keeper.lower()
    assert drawing.locator(".box.lifecycle").count() == 1
    eye = panel_of("/eye")
    assert "/box" in eye
    assert "vision::Eye" in eye
    assert "30" in eye
    assert drawing.locator(".box.host").count() == 1
    assert any("in /box" in each for each in drawing.locator(".box").all_text_contents())
