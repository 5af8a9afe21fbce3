"""Whether a file is a launch file, by its outermost element or key."""

from __future__ import annotations

import time

import pytest

from launchlint.workspace.launch_root import has_launch_key, has_launch_root, other_root


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
    has_launch_key(text.encode())
    other_root(text.encode())
    has_launch_root(text.encode())
    assert time.process_time() - start < 3


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


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("launch:\n- node: {pkg: a, exec: b}\n", True),
        ("%YAML 1.2\n---\n# a robot\nlaunch:\n", True),
        ("\ufeff'launch' :\r\n", True),
        ('{"launch": []}', True),
        ("lunch:\n", False),
        ("a:\n  launch:\n", False),
        ("launcher: x\n", False),
        ("launch:x\n", False),
        ("<launch/>", False),
        ("", False),
    ],
)
def test_key(text: str, expected: bool) -> None:
    assert has_launch_key(text.encode()) is expected
