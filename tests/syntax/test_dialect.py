"""ROS 1 or ROS 2, by what stands in a launch file."""

from __future__ import annotations

import time
from collections.abc import Iterator, Mapping

import pytest

from launchlint.model import DialectName
from launchlint.syntax.dialect import told
from launchlint.syntax.parse import parse
from launchlint.syntax.ros1.dialect import ROS2_ATTRIBUTES, ROS2_SUBSTITUTIONS, ROS2_TAGS
from launchlint.syntax.ros1.dialect import TAGS as TAGS1
from launchlint.syntax.ros1.substitutions import COMMANDS
from launchlint.syntax.ros2 import of_ros1
from launchlint.syntax.ros2.tables import SUBSTITUTIONS, Children, Tag
from launchlint.syntax.ros2.tables import TAGS as TAGS2

NODE_1 = '<node pkg="a" type="b" name="c"/>'


@pytest.mark.parametrize(
    ("text", "package", "expected"),
    [
        ("<launch/>", None, "ros1"),
        ("<launch/>", "ros1", "ros1"),
        ("<launch/>", "ros2", "ros2"),
        (f"<launch>{NODE_1}</launch>", None, "ros1"),
        (f"<launch>{NODE_1}{NODE_1}{NODE_1}</launch>", "ros2", "ros1"),
        ('<launch><node pkg="a" exec="b"/></launch>', None, "ros2"),
        ('<launch><node pkg="a" exec="b"/></launch>', "ros2", "ros2"),
        ('<launch><arg name="x" default="$(find-pkg-share p)/y"/><include file="$(var x)"/></launch>', None, "ros2"),
        ('<launch><push-ros-namespace namespace="a"/></launch>', None, "ros2"),
        ("<!-- <node exec='x'/> $(var y) --><launch/>", None, "ros1"),
        ("", None, "ros1"),
        ("", "ros2", "ros2"),
        ('<launch><param name="a" value="$(eval \'1 + 1\')"/></launch>', None, "ros2"),
        ('<launch><param name="a" value="$(eval 1 + 1)"/></launch>', "ros2", "ros2"),
        ('<launch><param name="a" value="$(eval x == \'y\')"/></launch>', None, "ros1"),
        ('<launch><param name="a" type="double" value="1.5"/></launch>', None, "ros1"),
        ("<launch><rosparam>a: $(var x)</rosparam></launch>", None, "ros1"),
        ('<launch><test test-name="a" pkg="b" type="c"/></launch>', "ros2", "ros1"),
        # One slip in a ROS 1 file.
        (f'<launch>{NODE_1}<node pkg="a" exec="b" name="d"/></launch>', None, "ros1"),
        ('<launch><node pkg="a" exec="b" name="d"/></launch>', "ros1", "ros1"),
        ('<launch><arg name="x"/><include file="$(find p)/$(var x).launch"/></launch>', None, "ros1"),
        (f"<launch>{NODE_1}<include file='$(find-pkg-share p)/x'/></launch>", None, "ros1"),
        ('<launch><node pkg="a" type="b" name="c" namespace="d"/></launch>', None, "ros1"),
        # Not well-formed.
        (f"<launch>{NODE_1}", None, "ros1"),
        ("<launch><node exec='a' <node exec='b'/> $(var x)", None, "ros2"),
    ],
)
def test_dialect(text: str, package: DialectName | None, expected: str | None) -> None:
    assert told(parse(text.encode(), "a.launch"), package) == expected
    assert told(parse(text.encode("utf-16"), "a.launch"), package) == expected


@pytest.mark.parametrize(
    ("text", "name", "expected"),
    [
        (f"<launch>{NODE_1}</launch>", "a.launch", "ros1"),
        ('<launch><include file="$(find p)/b.launch"/></launch>', "a.launch", "ros1"),
        ('<launch><param name="a" value="b"/></launch>', "a.launch", "ros1"),
        ('<launch><arg name="a"/></launch>', "a.launch", "ros2"),
        # A slip, not a file of ROS 1: it is called as those of ROS 2 are, or has words of ROS 2.
        (f"<launch>{NODE_1}</launch>", "a.launch.xml", "ros2"),
        (f'<launch>{NODE_1}<node pkg="a" exec="b"/></launch>', "a.launch", "ros2"),
    ],
)
def test_one_word_of_ros1_in_a_package_that_is_for_ros2_only(text: str, name: str, expected: str) -> None:
    assert told(parse(text.encode(), name), "ros2", of_ros2_only=True) == expected


@pytest.mark.parametrize(
    ("text", "asked", "expected"),
    [
        ('<launch><node pkg="a" type="b" name="c"/></launch>', "ros2", "ros1"),
        ('<launch><node pkg="a" exec="b" name="c"/></launch>', "ros1", "ros2"),
        ("<launch/>", "ros2", "ros2"),
        ("<launch/>", "ros1", "ros1"),
        ("<launch/>", None, "ros1"),
    ],
)
def test_one_word_says_it_in_a_package_that_is_built_for_both(text: str, asked: DialectName | None, expected: str) -> None:
    assert told(parse(text.encode(), "a.launch"), asked, only_where_equal=True) == expected


def test_bytes_that_are_no_utf8() -> None:
    data = b'<launch><!-- \xe9 --><node pkg="a" type="\xff"/></launch>'
    assert told(parse(data, "a.launch"), None) == "ros1"


@pytest.mark.parametrize(
    "text",
    [
        "<node " * 200_000,
        "<launch>" + "<node a='" * 200_000,
        "<!--" * 200_000,
        "<launch>" + "$(eval " * 200_000,
        "<launch a='" + "$(var x) " * 200_000 + "'/>",
    ],
)
def test_hostile_text_takes_little_time(text: str) -> None:
    document = parse(text.encode(), "a.launch")
    start = time.process_time()
    told(document, None)
    assert time.process_time() - start < 3


def test_what_one_dialect_is_told_to_have_of_the_other_is_there() -> None:
    """The ways of the other dialect are written by hand; what they are written for is in the metamodels."""
    tags2 = {tag.replace("_", "-") for tag in TAGS2} | {each.name.replace("_", "-") for each in nested(TAGS2)}
    assert {tag.replace("_", "-") for tag in ROS2_TAGS} - tags2 == {
        "on-exit",
        "push-namespace",
    }  # of Python, and of nearly all who misspell it
    assert {tag for tag in ROS2_ATTRIBUTES if tag not in TAGS1} == set()
    assert set(ROS2_SUBSTITUTIONS) - set(SUBSTITUTIONS) == {"exec-in-package", "parameter"}  # names that people take them for
    assert set(of_ros1.TAGS) - set(TAGS1) == set()
    assert set(of_ros1.SUBSTITUTIONS) - set(COMMANDS) == set()
    for tag, names in of_ros1.ATTRIBUTES.items():
        assert set(names) - {each.name for each in TAGS1[tag].attributes} == set()


def nested(tags: Mapping[str, Tag]) -> Iterator[Children]:
    waiting = [read for tag in tags.values() for read in tag.reads]
    while waiting:
        read = waiting.pop()
        if isinstance(read, Children):
            yield read
            waiting.extend(read.reads)
