"""Did you mean: what is near, what only looks so, and what somebody switched off."""

from __future__ import annotations

import pytest

from launchlint.spelling import closest, differs_in_meaning, one_slip, surely, switched_off

TAGS = ("arg", "group", "include", "machine", "node", "test", "param", "rosparam", "remap", "env")
ATTRIBUTES = ("pkg", "type", "name", "ns", "args", "if", "unless", "launch-prefix")


@pytest.mark.parametrize(
    ("name", "other"),
    [
        ("laser_1", "laser_2"),
        ("camera", "camera2"),
        ("min_range", "max_range"),
        ("rangeMin", "rangeMax"),
        ("xmin", "xmax"),
        ("goal_x", "goal_y"),
        ("offset_dx", "offset_dz"),
        ("arm_l", "arm_r"),
        ("left_arm", "right_arm"),
        ("leftWheel", "rightWheel"),
        ("upper", "lower"),
        ("front_laser", "rear_laser"),
        ("known", "unknown"),
        ("inside", "outside"),
    ],
)
def test_what_says_something_else_is_never_offered(name: str, other: str) -> None:
    for one, another in ((name, other), (other, name)):
        assert differs_in_meaning(one, another)
        assert closest(one, [another]) is None
        assert one_slip(one, [another]) is None
        assert surely(one, [another]) is None


@pytest.mark.parametrize(
    ("name", "other"),
    [
        ("acml", "amcl"),
        ("max_velocty", "max_velocity"),
        ("robot-name", "robot_name"),
        ("lazer_1", "laser_1"),
        ("lef_arm", "left_arm"),
        ("goalx", "goal_x"),
        ("nodes", "node"),
    ],
)
def test_slips_are_near(name: str, other: str) -> None:
    assert not differs_in_meaning(name, other)
    assert closest(name, [other]) == other


@pytest.mark.parametrize(
    ("name", "other"),
    [("min_height", "scan_height"), ("meta_topic_over_network", "map_topic_over_network")],
)
def test_another_word_is_not_near(name: str, other: str) -> None:
    assert closest(name, [other]) is None


@pytest.mark.parametrize(
    ("name", "other"),
    [("publish_pose_stamp", "publish_pose_stamped"), ("inflation_rad", "inflation_radius"), ("dead_zone_x", "deadzone_x")],
)
def test_a_word_cut_short_is_near(name: str, other: str) -> None:
    assert closest(name, [other]) == other


def test_a_slip_is_for_the_name_that_says_the_same() -> None:
    assert closest("min_velocty", ["max_velocity", "min_velocity"]) == "min_velocity"


@pytest.mark.parametrize(
    ("name", "tag"),
    [
        ("anode", "node"),
        ("xxnode", "node"),
        ("_node", "node"),
        ("node_", "node"),
        ("nodex", "node"),
        ("node2", "node"),
        ("off:node", "node"),
        ("DISABLED_node", "node"),
        ("param-x", "param"),
        ("xrosparam", "rosparam"),
        ("nnode", None),
        ("nodee", None),
        ("nodes", None),
        ("noder", None),
        ("ndoe", None),
        ("Node", None),
        ("node_name", None),
        ("node", None),
    ],
)
def test_tags_that_are_switched_off(name: str, tag: str | None) -> None:
    assert switched_off(name, TAGS) == tag


@pytest.mark.parametrize(
    ("name", "attribute"),
    [
        ("_if", "if"),
        ("xargs", "args"),
        ("alaunch-prefix", "launch-prefix"),
        ("launch-prefix-off", "launch-prefix"),
        ("old_args", "args"),
        ("iff", None),
        ("iif", None),
        ("node_name", None),
        ("argss", None),
    ],
)
def test_attributes_that_are_switched_off(name: str, attribute: str | None) -> None:
    assert switched_off(name, ATTRIBUTES) == attribute
