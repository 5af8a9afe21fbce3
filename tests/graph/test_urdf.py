"""Reading robot descriptions: what hangs from what, and what cannot be read as it stands."""

from __future__ import annotations

import pytest

from launchlint.graph.urdf import LARGEST, Joint, joints

JOINT = '<joint name="j" type="fixed"><parent link="base"/><child link="laser"/></joint>'


def test_joints() -> None:
    text = f'<?xml version="1.0"?><!-- {JOINT.replace("laser", "no")} --><robot name="r"><link name="base"/>{JOINT}'
    text += '<joint name="k" type="revolute">'
    text += '<child link="arm"/><parent link="base"/><limit/></joint><joint name="half" type="fixed"><child link="x"/></joint></robot>'
    assert joints(text) == {"laser": Joint("base", fixed=True), "arm": Joint("base", fixed=False)}


def test_a_joint_of_something_else_is_none_of_the_robot() -> None:
    assert joints(f'<robot name="r"><transmission>{JOINT}</transmission><link name="base"/></robot>') == {}


@pytest.mark.parametrize(
    "text",
    [
        "",
        "no xml",
        "<robot>",
        f"<launch>{JOINT}</launch>",
        f'<robot xmlns:xacro="http://www.ros.org/wiki/xacro"><xacro:include filename="x"/>{JOINT}</robot>',
        f"<robot>{JOINT.replace('laser', '${name}_laser')}</robot>",
        f'<!DOCTYPE robot [<!ENTITY a "b">]><robot>{JOINT}</robot>',
        "<robot>" + " " * LARGEST + "</robot>",
        "<robot>\ud800</robot>",
    ],
)
def test_what_cannot_be_told(text: str) -> None:
    assert joints(text) is None


def test_origin_of_a_joint() -> None:
    text = '<robot><joint type="fixed"><parent link="a"/><child link="b"/><origin xyz="0.10 -0 1" rpy="0 0 3"/></joint></robot>'
    assert joints(text) == {"b": Joint("a", fixed=True, origin=("0.1", "0.0", "1.0", "0.0", "0.0", "3.0"))}
