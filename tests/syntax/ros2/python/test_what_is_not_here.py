"""Packages and variables that a launch file in Python asks for and that are not here: launch stops, the rest is still told."""

from __future__ import annotations

from pathlib import Path

import pytest

from launchlint.syntax.ros2 import description as described
from tests.syntax.ros2.python.test_python_reading import HEAD, actions, kinds, reading, spelled

LEG = "get_package_share_directory('leg')"
NODE = "Node(package='p', executable='e', name={})"


def test_launch_stops_first_and_the_rest_is_told(tmp_path: Path) -> None:
    stop, include, node = actions(
        f"leg = {LEG}\nreturn LaunchDescription([IncludeLaunchDescription(PythonLaunchDescriptionSource([leg, '/launch/a.launch.py'])),\n"
        f"    {NODE.format(repr('n'))}])",
        tmp_path,
    )
    assert isinstance(stop, described.Log)
    assert (spelled(stop.message), stop.place.text) == ("$(find-pkg-share leg)", LEG)
    assert isinstance(include, described.Include)
    assert spelled(include.file) == "$(find-pkg-share leg)/launch/a.launch.py"
    assert isinstance(node, described.Node)
    assert spelled(node.name) == "n"


@pytest.mark.parametrize(
    ("value", "expected"),
    [
        (f"os.path.join({LEG}, 'a', 'b')", "$(find-pkg-share leg)/a/b"),
        (f"os.path.dirname(os.path.join({LEG}, 'a', 'b'))", "$(find-pkg-share leg)/a"),
        (f"str(Path({LEG}) / 'a')", "$(find-pkg-share leg)/a"),
        ("str(get_package_share_path('leg') / 'a')", "$(find-pkg-share leg)/a"),
        ("FindPackageShare('leg').find('leg') + '/a'", "$(find-pkg-share leg)/a"),
        ("get_package_prefix('leg') + '/lib'", "/opt/ros/jazzy/lib"),
        (f"'--in:' + {LEG} + '/a'", "--in:$(find-pkg-share leg)/a"),
        (f"'file://' + {LEG}", "file://$(find-pkg-share leg)"),
        (f"{LEG} + ':' + get_package_share_directory('arm') + '/b'", "$(find-pkg-share leg):$(find-pkg-share arm)/b"),
        (f"{LEG} + '_more'", "/opt/ros/jazzy/share/leg_more"),
        (f"'/chroot' + {LEG}", "/chroot/opt/ros/jazzy/share/leg"),
        ("os.environ['NOT']", "$(env NOT)"),
        ("'a_' + os.environ['NOT'] + '_b'", "a_$(env NOT)_b"),
        ("f\"a_{os.environ['NOT']}\"", "a_$(env NOT)"),
        ("os.environ.get('NOT', 'there')", "there"),
    ],
)
def test_what_is_made_of_it(value: str, expected: str, tmp_path: Path) -> None:
    head = "from pathlib import Path\nfrom ament_index_python.packages import get_package_prefix, get_package_share_path\n"
    *stops, node = actions(f"{head}return LaunchDescription([{NODE.format(value)}])", tmp_path)
    assert isinstance(node, described.Node)
    assert spelled(node.name) == expected
    assert kinds(tuple(stops)) == ([] if "get('NOT'" in value else ["Log"])


def test_it_is_asked_for_once(tmp_path: Path) -> None:
    found = actions(f"a = {LEG}\nb = {LEG}\nc = os.environ['NOT']\nreturn LaunchDescription()", tmp_path)
    assert [spelled(each.message) for each in found if isinstance(each, described.Log)] == ["$(find-pkg-share leg)", "$(env NOT)"]


def test_a_handler_that_takes_the_exception_is_followed(tmp_path: Path) -> None:
    body = f"try:\n    name = {LEG}\nexcept KeyError:\n    name = 'other'\nreturn LaunchDescription([{NODE.format('name')}])"
    (node,) = actions(body, tmp_path)
    assert isinstance(node, described.Node)
    assert spelled(node.name) == "other"


def test_where_the_program_may_not_get_nothing_is_certain(tmp_path: Path) -> None:
    body = f"name = 'arm'\nif os.path.exists('/somewhere'):\n    name = {LEG}\nreturn LaunchDescription([{NODE.format(repr('n'))}])"
    found = reading(f"{HEAD}def generate_launch_description():\n" + "".join(f"    {line}\n" for line in body.splitlines()), tmp_path)
    assert kinds(found.description.actions) == ["Unsettled", "Node"]


def test_what_stops_the_program_later_is_told_behind_it(tmp_path: Path) -> None:
    found = actions(f"leg = {LEG}\nraise ValueError('no')", tmp_path)
    assert kinds(found) == ["Log", "Fails", "Open"]
