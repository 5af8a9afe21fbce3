"""Conditions in a package.xml, and what is left of a package under them."""

from __future__ import annotations

import pytest

from launchlint.workspace.ament.conditions import holds
from launchlint.workspace.manifest import parse_manifest

CONTEXT = {"ROS_VERSION": "2", "ROS_DISTRO": "jazzy"}

CASES = {
    "$ROS_VERSION == 2": True,
    "$ROS_VERSION==1": False,
    "$ROS_VERSION != '1'": True,
    '"2" == $ROS_VERSION': True,
    "$ROS_DISTRO >= humble": True,
    "$ROS_DISTRO < humble": False,
    "$UNSET == ''": True,
    "$UNSET == 1": False,
    "$ROS_VERSION == 1 and $ROS_DISTRO == jazzy or a == a": True,  # "and" binds more tightly
    "$ROS_VERSION == 1 and ($ROS_DISTRO == jazzy or a == a)": False,
    "((1 == 1))": True,
    " 10 < 9 ": True,  # as text
}
REFUSED = [
    "",
    "$ROS_VERSION",
    "1 == 1 == 1",
    "1 = 1",
    "(1 == 1",
    "1 == 1)",
    "1 == 1 or",
    "a.b == c",
    "'a == a",
    "not 1 == 1",
    "(" * 50 + "1 == 1",
]


@pytest.mark.parametrize("condition", CASES)
def test_a_condition(condition: str) -> None:
    assert holds(condition, CONTEXT) is CASES[condition]


@pytest.mark.parametrize("condition", REFUSED)
def test_what_is_no_condition_is_refused(condition: str) -> None:
    with pytest.raises(ValueError, match="condition"):
        holds(condition, CONTEXT)


def test_a_very_long_condition_is_refused_at_once() -> None:
    with pytest.raises(ValueError, match="not understood"):
        holds("1 == 1 or " * 100_000 + "1 == 1", {})


BOTH = b"""<package format="3"><name>rover</name>
  <depend condition="$ROS_VERSION == 1">roscpp</depend>
  <depend condition="$ROS_VERSION == 2">rclcpp</depend>
  <depend condition="not a condition">odd</depend>
  <exec_depend>tf2</exec_depend>
  <export>
    <build_type condition="$ROS_VERSION == 1">catkin</build_type>
    <build_type condition="$ROS_VERSION == 2">ament_cmake</build_type>
  </export>
</package>"""


def test_what_is_left_of_a_manifest() -> None:
    manifest = parse_manifest(BOTH, "/w/package.xml")
    assert manifest.depends() == {"roscpp", "rclcpp", "odd", "tf2"}
    left = manifest.under({"ROS_VERSION": "2"})
    assert (left.depends(), left.build_types) == ({"rclcpp", "odd", "tf2"}, ("ament_cmake",))
    assert manifest.under({"ROS_VERSION": "1"}).build_types == ("catkin",)


@pytest.mark.parametrize(
    ("export", "versions"),
    [
        ("", {"1"}),
        ("<build_type>catkin</build_type>", {"1"}),
        ("<build_type>cmake</build_type>", {"1", "2"}),
        ("<build_type>ament_python</build_type>", {"2"}),
        ("<build_type>catkin</build_type><build_type>ament_cmake</build_type>", {"1", "2"}),
        ('<build_type condition="$ROS_VERSION == 2">ament_cmake</build_type>', {"1", "2"}),
    ],
)
def test_for_which_ros_a_package_is_built(export: str, versions: set[str]) -> None:
    text = f"<package><name>rover</name><export>{export}</export></package>"
    assert parse_manifest(text.encode(), "/w/package.xml").ros_versions == versions
    assert parse_manifest(BOTH, "/w/package.xml").ros_versions == {"1", "2"}
