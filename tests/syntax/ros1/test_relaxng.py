"""The schema made from the tables accepts what roslaunch accepts, and sees what is wrong."""

from __future__ import annotations

import pytest
from lxml import etree

from launchlint.syntax.parse import parse
from launchlint.syntax.ros1.dialect import TAGS
from launchlint.syntax.ros1.relaxng import relaxng
from launchlint.syntax.ros1.validate import validate

SCHEMA = etree.RelaxNG(etree.fromstring(relaxng().encode()))

GOOD = [
    "<launch/>",
    '<launch deprecated="no"><arg name="a" default="1" doc="x"/><arg name="b" value="$(arg a)" if="$(arg a)"/></launch>',
    """<launch>
      <!-- a robot -->
      <group ns="robot" unless="false">
        <remap from="scan" to="base_scan"/>
        <env name="A" value="b"/>
        <machine name="m" address="a" default="never" ssh-port="22" timeout="10.5" env-loader="e"/>
        <include file="$(find p)/a.launch" pass_all_args="true"><arg name="x" value="y"/></include>
        <node name="n" pkg="p" type="t" output="screen" respawn="$(arg respawn)" respawn_delay="2.5" launch-prefix="gdb">
          <param name="p" value="1" type="int"/>
          <param name="q" command="cat a"/>
          <rosparam subst_value="true">a: 1</rosparam>
          <rosparam file="a.yaml" command="load" ns="b"/>
        </node>
      </group>
      <test test-name="t" pkg="p" type="t" time-limit="30.0" retry="2"/>
      <master auto="start"/>
    </launch>""",
]
BAD = {
    "unknown tag": "<launch><nod/></launch>",
    "unknown attribute": '<launch><node name="n" pkg="p" type="t" ouput="log"/></launch>',
    "missing attribute": '<launch><node name="n" pkg="p"/></launch>',
    "misplaced tag": '<launch><include file="f"><param name="a" value="b"/></include></launch>',
    "text": "<launch><group>a</group></launch>",
    "if and unless": '<launch><arg name="a" if="true" unless="true"/></launch>',
    "value": '<launch><node name="n" pkg="p" type="t" output="Screen"/></launch>',
    "type": '<launch><param name="n" value="1" type="$(arg t)"/></launch>',
    "two sources": '<launch><param name="n" value="1" textfile="f"/></launch>',
    "no source": '<launch><param name="n"/></launch>',
    "value and default": '<launch><arg name="a" value="1" default="2"/></launch>',
    "test output": '<launch><test test-name="t" pkg="p" type="t" output="log"/></launch>',
    "other root": "<robot><launch/></robot>",
}


@pytest.mark.parametrize("text", GOOD)
def test_accepts(text: str) -> None:
    assert SCHEMA.validate(etree.fromstring(text)), SCHEMA.error_log
    kinds = {problem.kind for problem in validate(parse(text.encode(), "a.launch"))}
    assert kinds <= {"deprecated-construct"}


@pytest.mark.parametrize("name", BAD)
def test_refuses(name: str) -> None:
    assert not SCHEMA.validate(etree.fromstring(BAD[name]))


def test_deterministic_and_complete() -> None:
    text = relaxng()
    assert text == relaxng()
    names = [element.get("name") for element in etree.fromstring(text.encode()).iter("{*}define")]
    assert names == list(TAGS)
