"""Did you mean: what is near, what only looks so, and what somebody switched off."""

from __future__ import annotations

from itertools import product

import pytest

from launchlint.spelling import MOST_COMPARED, closest, differs_in_meaning, distance, one_slip, surely, switched_off

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
        ("from_can_bus", "to_can_bus"),
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


def test_distances_are_those_of_the_textbook() -> None:
    """Whatever is cut off first, and wherever it is given up: insert, delete, replace, swap neighbours, by the whole table."""
    words = ["".join(letters) for length in range(5) for letters in product("ab_", repeat=length)]
    for left, right in product(words, words[::3]):
        assert min(distance(left, right, 2), 3) == min(textbook(left, right), 3), (left, right)


def textbook(left: str, right: str) -> int:
    """The restricted Damerau-Levenshtein distance, all of the table."""
    table = {(row, -1): row + 1 for row in range(-1, len(left))} | {(-1, column): column + 1 for column in range(-1, len(right))}
    for row, column in product(range(len(left)), range(len(right))):
        least = min(
            table[row - 1, column] + 1, table[row, column - 1] + 1, table[row - 1, column - 1] + (left[row] != right[column])
        )  # fmt: skip
        if row and column and left[row] == right[column - 1] and left[row - 1] == right[column]:
            least = min(least, table[row - 2, column - 2] + 1)
        table[row, column] = least
    return table[len(left) - 1, len(right) - 1]


def test_among_too_many_names_that_look_alike_none_is_near() -> None:
    names = [f"abcd_{number:05}_efgh" for number in range(MOST_COMPARED + 1)]
    assert closest("abcd_00007_efhg", names[:100]) == "abcd_00007_efgh"
    assert closest("abcd_00007_efhg", names) is None
