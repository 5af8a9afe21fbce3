"""ROS 1 or ROS 2, by what stands in a launch file."""

from __future__ import annotations

import time
from pathlib import Path

import pytest

from launchlint.workspace.dialect import dialect, has_launch_root, other_root
from launchlint.workspace.discovery import is_launch_file

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
        ("<robot/>", None, None),
        ("", None, None),
        ("<launchpad/>", None, None),
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
def test_dialect(text: str, package: str | None, expected: str | None) -> None:
    assert dialect(text.encode(), package) == expected
    assert dialect(text.encode("utf-16"), package) == expected


def test_bytes_that_are_no_utf8() -> None:
    assert dialect(b'<launch><!-- \xe9 --><node pkg="a" type="\xff"/></launch>') == "ros1"


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("<launch>", True),
        ("\ufeff <launch/>", True),
        ('<?xml version="1.0"?>\n<!-- a\n<robot> -->\n<launch\n a="b">', True),
        ('<!DOCTYPE launch [\n<!ENTITY a "b">\n]>\n<launch>', True),
        ("<!DOCTYPE launch SYSTEM 'x'><?y?><launch>", True),
        ("<robot><launch/></robot>", False),
        ("<launchpad>", False),
        ("<!-- <launch> -->", False),
        ("words <launch>", False),
        ("", False),
    ],
)
def test_root(text: str, expected: bool) -> None:
    assert has_launch_root(text.encode()) is expected


@pytest.mark.parametrize(
    "text",
    [
        "<node " * 200_000,
        "<launch>" + "<node a='" * 200_000,
        "<!--" * 200_000,
        "<!DOCTYPE " * 100_000,
        "<launch>" + "$(eval " * 200_000,
        "<?" * 300_000,
    ],
)
def test_hostile_text_takes_little_time(text: str) -> None:
    start = time.process_time()
    dialect(text.encode())
    has_launch_root(text.encode())
    assert time.process_time() - start < 3


@pytest.mark.corpus
def test_public_files(corpus: Path) -> None:
    def told(root: Path, *endings: str) -> dict[str | None, list[str]]:
        found: dict[str | None, list[str]] = {}
        for path in sorted(root.rglob("*")):
            if path.name.endswith(endings) and path.is_file() and is_launch_file(str(path)):
                found.setdefault(dialect(path.read_bytes()), []).append(str(path.relative_to(root)))
        return found

    ros1 = told(corpus / "ros1", ".launch", ".test", ".xml")
    assert ros1.get("ros2", []) == []
    assert len(ros1.get(None, [])) <= 1  # a template without a root
    ros2 = told(corpus / "ros2", ".launch.xml")
    # Files with nothing but includes or comments in them, which are the same in both.
    assert len(ros2.get("ros1", [])) <= 6


@pytest.mark.parametrize(
    ("text", "root"),
    [
        ("<concert><launch/></concert>", "concert"),
        ('<?xml version="1.0"?>\n<!-- <launch> -->\n<my:concert name="a"><launch a="b"/></my:concert>', "my:concert"),
        ("<launch><launch/></launch>", None),
        ("<Launch><launch/></Launch>", None),
        ("<lanch><launch/></lanch>", None),
        ("<concert><!-- <launch/> --></concert>", "concert"),
        ("<robot/>", "robot"),
        ('<launchConfiguration type="a"/>', "launchConfiguration"),
        ("<node/>", None),
        ("<group><launch/></group>", "group"),
        ("no XML <launch/>", None),
        ("", None),
    ],
)
def test_root_of_another_program(text: str, root: str | None) -> None:
    assert other_root(text.encode()) == root
    assert other_root(text.encode("utf-16")) == root
