"""The tables agree with themselves, and with the real roslaunch where it is installed."""

from __future__ import annotations

import json
import subprocess
from pathlib import Path

import pytest

from launchlint.syntax.ros1.dialect import CONDITIONS, OWNERS, ROS2_ATTRIBUTES, ROS2_TAGS, TAGS, TEST_REFUSES, tag_for

_PYTHON = Path("/usr/bin/python3")
_ROSLAUNCH = Path("/usr/lib/python3/dist-packages/roslaunch")


def test_parents_and_children_say_the_same() -> None:
    below = {(rule.tag, child) for rule in TAGS.values() for child in rule.children}
    above = {(parent, rule.tag) for rule in TAGS.values() for parent in rule.parents}
    assert below == above


def test_every_tag_but_launch_and_master_takes_a_condition() -> None:
    assert [tag for tag, rule in TAGS.items() if set(CONDITIONS) <= set(rule.known)] == [
        tag for tag in TAGS if tag not in ("launch", "master")
    ]


def test_required() -> None:
    assert {tag: rule.required for tag, rule in TAGS.items() if rule.required} == {
        "node": ("name", "pkg", "type"),
        "test": ("test-name", "pkg", "type"),
        "param": ("name",),
        "arg": ("name",),
        "include": ("file",),
        "remap": ("from", "to"),
        "env": ("name", "value"),
        "machine": ("name", "address"),
    }


def test_owners() -> None:
    assert OWNERS["output"] == ("node",)
    assert OWNERS["value"] == ("param", "arg", "env")
    assert OWNERS["ns"] == ("group", "node", "test", "rosparam", "include")
    assert "ros-root" not in OWNERS


def test_case_of_tags() -> None:
    node, group = TAGS["node"], TAGS["group"]
    assert tag_for("Param", node) is TAGS["param"]
    assert tag_for("Param", group) is None
    assert tag_for("launch", None) is TAGS["launch"]


def test_ros2_names_are_not_ours() -> None:
    assert set(ROS2_TAGS).isdisjoint(TAGS)
    assert [(tag, name) for tag, names in ROS2_ATTRIBUTES.items() for name in names if TAGS[tag].attribute(name)] == []


@pytest.mark.ros
@pytest.mark.skipif(not _ROSLAUNCH.is_dir(), reason="roslaunch is not installed (Debian: python3-roslaunch)")
def test_attributes_are_those_of_the_real_roslaunch() -> None:
    program = (
        "import json; from roslaunch.xmlloader import XmlLoader as L;"
        "names = [n for n in dir(L) if n.endswith('_ATTRS') and not n.endswith('_OPT_ATTRS')];"
        "print(json.dumps({n[:-6].lower(): sorted(set(getattr(L, n))) for n in names} | {'rosparam': sorted(L.ROSPARAM_OPT_ATTRS)}))"
    )
    answer = subprocess.run([str(_PYTHON), "-c", program], capture_output=True, text=True, check=True)
    real = json.loads(answer.stdout)
    mine = {
        tag: sorted(
            attribute.name
            for attribute in rule.attributes
            if attribute.name not in CONDITIONS and not (attribute.status == "refused" and tag == "machine")
        )
        for tag, rule in TAGS.items()
        if tag not in ("launch", "master")
    }
    assert mine == real
    assert set(TEST_REFUSES) <= set(real["node"])
