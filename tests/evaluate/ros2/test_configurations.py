"""Every configuration of a ROS 2 launch file that shows something new."""

from __future__ import annotations

from pathlib import Path

import pytest

from launchlint.evaluate.configurations import MOST_EVALUATIONS, configurations
from launchlint.evaluate.ros2.arg_flow import ros2_launch
from tests.evaluate.ros2.launching import Workspace

NODE = '<node pkg="pk" exec="{}"/>'


def shown(directory: Path, main: str, *given: tuple[str, str], **others: str) -> list[tuple[str, list[str]]]:
    """The args of each configuration, and what it starts."""
    workspace = Workspace(directory, main, {f"{name}.launch.xml": text for name, text in others.items()})
    found = configurations(workspace.session(), str(workspace.launch_files / "main.launch.xml"), given, ros2_launch())
    return [
        (" ".join(f"{name}:={value}" for name, value in each.launch.given), [node.executable for node in each.launch.nodes])
        for each in found
    ]


@pytest.mark.parametrize(
    ("main", "expected"),
    [
        (f'<arg name="a" default="x"/>{NODE.format("n")}', [("", ["n"])]),
        (
            '<arg name="sim" default="false"/><node pkg="pk" exec="n" if="$(var sim)"/><node pkg="pk" exec="m" unless="$(var sim)"/>',
            [("", ["m"]), ("sim:=true", ["n"])],
        ),
        (
            '<arg name="sim" default="True"/><let name="real" value="$(not $(var sim))"/><node pkg="pk" exec="n" if="$(var real)"/>',
            [("", []), ("sim:=False", ["n"])],
        ),
        (
            '<arg name="mode" default="a"/><node pkg="pk" exec="n" if="$(eval &quot;\'$(var mode)\' == \'b\'&quot;)"/>',
            [("", []), ("mode:=b", ["n"])],
        ),
        (
            '<arg name="mode" default="a"/><let name="on" value="$(equals $(var mode) b)"/><node pkg="pk" exec="n" if="$(var on)"/>',
            [("", []), ("mode:=b", ["n"])],
        ),
        (
            '<arg name="m" default="a"><choice value="a"/><choice value="b"/></arg><node pkg="pk" exec="n" if="$(equals $(var m) b)"/>',
            [("", []), ("m:=b", ["n"])],
        ),
        (
            '<arg name="a" default="0"/><arg name="b" default="0"/><group if="$(var a)"><node pkg="pk" exec="n" if="$(var b)"/></group>',
            [("", []), ("a:=1", []), ("a:=1 b:=1", ["n"])],
        ),
        ('<arg name="a" default="text"/><node pkg="pk" exec="n" if="$(var a)"/>', [("", [])]),
        ('<node pkg="pk" exec="n" if="false"/>', [("", [])]),
    ],
)
def test_what_shows_something_new(tmp_path: Path, main: str, expected: list[tuple[str, list[str]]]) -> None:
    assert shown(tmp_path, main) == expected


def test_a_comparison_in_an_included_file_counts(tmp_path: Path) -> None:
    main = '<arg name="mode" default="a"/><include file="$(dirname)/b.launch.xml"><arg name="how" value="$(var mode)"/></include>'
    included = '<arg name="how"/><node pkg="pk" exec="n" if="$(equals $(var how) odd)"/>'
    assert shown(tmp_path, main, b=included) == [("", []), ("mode:=odd", ["n"])]


def test_what_is_given_stays(tmp_path: Path) -> None:
    main = '<arg name="sim" default="false"/><node pkg="pk" exec="n" if="$(var sim)"/>'
    assert shown(tmp_path, main, ("sim", "true")) == [("sim:=true", ["n"])]


def test_many_conditions_come_to_an_end(tmp_path: Path) -> None:
    names = [f"a{number}" for number in range(200)]
    main = "".join(f'<arg name="{name}" default="false"/><node pkg="pk" exec="n" if="$(var {name})"/>' for name in names)
    assert len(shown(tmp_path, main)) <= MOST_EVALUATIONS
