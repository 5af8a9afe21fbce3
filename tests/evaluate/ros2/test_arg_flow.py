"""Every configuration of a ROS 2 launch file: which args are given which values, so that each side of each condition is seen."""

from __future__ import annotations

from pathlib import Path

import pytest

from launchlint.dialects.ros2 import DIALECT
from tests.evaluate.ros2.launching import Workspace

NODE = '<node pkg="pk" exec="e" name="{}"/>'


def given(directory: Path, body: str, *args: tuple[str, str], others: dict[str, str] | None = None) -> list[tuple[tuple[str, str], ...]]:
    """The args of each configuration, the one that is asked for left out."""
    workspace = Workspace(directory, body, others)
    found = DIALECT.configurations(workspace.session(), str(workspace.launch_files / "main.launch.xml"), args)
    return [each.launch.given for each in found][1:]


@pytest.mark.parametrize(
    ("default", "condition", "expected"),
    [
        ("false", "$(var a)", "true"),
        ("True", "$(var a)", "False"),
        ("0", "$(var a)", "1"),
        ("true", "$(not $(var a))", "false"),
        ("fast", "$(equals $(var a) slow)", "slow"),
        ("fast", "$(eval &quot;'$(var a)' == 'slow'&quot;)", "slow"),
        ("false", "$(eval &quot;'$(var a)' == 'true'&quot;)", "true"),
        ("2", "$(eval '$(var a) > 3')", "4"),
    ],
)
def test_a_condition_is_turned(tmp_path: Path, default: str, condition: str, expected: str) -> None:
    body = f'<arg name="a" default="{default}"/><group if="{condition}">{NODE.format("n")}</group>'
    assert given(tmp_path, body) == [(("a", expected),)]


def test_choices_are_values(tmp_path: Path) -> None:
    choices = '<arg name="a" default="x"><choice value="x"/><choice value="y"/></arg>'
    body = choices + '<include file="$(dirname)/$(var a).launch.xml"/>'
    others = {
        "x.launch.xml": "<let name='b' value='$(equals $(var a) y)'/>" + '<group if="$(var b)"/>',
        "y.launch.xml": NODE.format("n"),
    }
    assert given(tmp_path, body, others=others) == []
    body = (
        choices
        + '<let name="b" value="$(eval &quot;\'$(var a)\'[0] in \'yz\'&quot;)"/><group if="$(var b)">'
        + NODE.format("n")
        + "</group>"
    )
    assert given(tmp_path / "2", body) == [(("a", "y"),)]


def test_values_come_through_includes(tmp_path: Path) -> None:
    body = '<arg name="a" default="false"/><include file="$(dirname)/inc.launch.xml"><arg name="b" value="$(var a)"/></include>'
    others = {"inc.launch.xml": '<arg name="b"/><group if="$(var b)">' + NODE.format("n") + "</group>"}
    assert given(tmp_path, body, others=others) == [(("a", "true"),)]


def test_what_is_given_stays_and_what_is_fixed_turns_nothing(tmp_path: Path) -> None:
    body = '<arg name="a" default="false"/><group if="$(var a)">' + NODE.format("n") + "</group>"
    assert given(tmp_path / "1", body, ("a", "false")) == []
    assert given(tmp_path / "2", '<let name="a" value="false"/>' + body) == []


def test_text_gets_no_boolean(tmp_path: Path) -> None:
    body = '<arg name="a" default="name"/><group if="$(eval &quot;\'$(var a)\' != \'\'&quot;)">' + NODE.format("$(var a)") + "</group>"
    assert all(value not in ("true", "false") for changes in given(tmp_path, body) for _, value in changes)


def test_one_inside_another(tmp_path: Path) -> None:
    inner = '<group if="$(var b)">' + NODE.format("n") + "</group>"
    body = '<arg name="a" default="false"/><arg name="b" default="false"/><group if="$(var a)">' + inner + "</group>"
    assert given(tmp_path, body) == [(("a", "true"),), (("a", "true"), ("b", "true"))]


def test_truth_is_given_as_the_default_writes_it(tmp_path: Path) -> None:
    body = '<group if="$(var a {})">' + NODE.format("n") + "</group>"
    assert given(tmp_path / "1", body.format("False")) == [(("a", "True"),)]
    assert given(tmp_path / "2", body.format("false")) == [(("a", "true"),)]
