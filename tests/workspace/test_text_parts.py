"""What is looked for in texts is found in a time that grows with them, whatever they are made of."""

from __future__ import annotations

import os
import resource

import pytest

from launchlint.workspace.text_parts import LARGEST, PARTS

BEGINNING = "<launch> lifecycle_manager node_names ros humble writes output "
"""What makes every part look closer."""
PIECES = (
    *("[", "[a", "['a', ", '["', "a", "a/", '"a/', "'", "- a ", "- ", " ", "\t", "\n", "value='a", "<arg ", "<arg name=", "arg: name: "),
    *("find ", "find(", "pkg='", "humble ", "humble,", "for ", "Publisher", "Publisher<", "advertise<a<", "Publisher(a, ", "subscribe   "),
    *("<node ", "<node>", "<node a='", "<node><remap", "<remap from='", "<!--", "<!---->", "</node"),
    *("lifecycle set ", "$(var ", "LaunchConfiguration( ", "DeclareLaunchArgument( ", "docs.ros.org/", "out", "save_", "-", "_", "`|"),
)
HEADS = ("", "[", '"', "'", "<arg name='", "find(", "Publisher<", "value='")
"""What stands once before them."""
SECONDS = 60
"""Of processor for all pieces; each takes some hundredths."""


@pytest.mark.slow
@pytest.mark.parametrize("part", PARTS)
def test_hostile_texts(part: str) -> None:
    child = os.fork()
    if child == 0:
        resource.setrlimit(resource.RLIMIT_CPU, (SECONDS, SECONDS))
        status = 1
        try:
            for head in HEADS:
                for piece in PIECES:
                    PARTS[part]((BEGINNING + head + piece * LARGEST)[:LARGEST])
            status = 0
        finally:
            os._exit(status)
    _, status = os.waitpid(child, 0)
    assert status == 0


def test_the_lists_of_a_text_with_a_lifecycle_manager() -> None:
    text = "lifecycle_manager: {node_names: ['map_server', \"amcl\", bt/navigator]}\nservers:\n  - planner_server\nargs: [1 + 2]\n"
    assert set(PARTS["lifecycle"](text)) >= {"amcl", "map_server", "navigator", "planner_server"}


def test_the_remaps_of_programs() -> None:
    text = """<launch>
      <!-- <node pkg="demo" type="viewer" name="off"><remap from="image" to="off"/></node> -->
      <remap from="image" to="around"/>
      <node pkg="demo" type="viewer" name="viewer">
        <remap from="image" to="$(arg camera)/image"/>
        <remap to='picture' from='image'/>
        <remap from="image"/>
      </node>
      <node pkg="demo" type="camera" name="camera"/>
      <node pkg="nodelet" type="nodelet" name="filter" args="load demo/Filter manager">
        <remap from="~input"
               to="points"/>
      </node>
    </launch>"""
    assert PARTS["remaps"](text) == [
        "demo/Filter\t~input\tpoints",
        "demo/viewer\timage\t$(arg camera)/image",
        "demo/viewer\timage\tpicture",
    ]
    assert PARTS["remaps"]("<node pkg='demo' type='viewer'><remap from='image' to='picture'/></node>") == ()
