"""What is looked for in texts is found in a time that grows with them, whatever they are made of."""

from __future__ import annotations

import os
import resource
from pathlib import Path

import pytest

from launchlint.workspace import contents
from launchlint.workspace.given_args import NOTHING, Uses, uses_of
from launchlint.workspace.text_parts import LARGEST, PARTS, known_state, part_of, part_state

BEGINNING = "<launch> lifecycle_manager node_names ros humble writes output "
"""What makes every part look closer."""
PIECES = (
    *("[", "[a", "['a', ", '["', "a", "a/", '"a/', "'", "- a ", "- ", " ", "\t", "\n", "value='a", "<arg ", "<arg name=", "arg: name: "),
    *("find ", "find(", "pkg='", "humble ", "humble,", "for ", "Publisher", "Publisher<", "advertise<a<", "Publisher(a, ", "subscribe   "),
    *("<node ", "<node>", "<node a='", "<node><remap", "<remap from='", "<!--", "<!---->", "</node"),
    *(
        "$(env ",
        "$(env a ",
        "$(optenv a",
        "env",
        "<machine ",
        "<machine name='",
        "args='",
        "a:=",
        "a.launch ",
        "<include ",
        "file='",
        "-->",
    ),
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


def test_what_a_text_gives_to_launch_files() -> None:
    launch = """<launch>
      <!-- <include file="$(find demo)/off.launch"><arg name="off" value="1"/></include> -->
      <include file="$(find demo)/my arm.launch"><arg name="side" value="left"/><arg name="base" value="1"/></include>
      <include file="$(arg file)"><arg name="any" value="1"/></include>
      <node name="n" pkg="demo" type="n" args="roslaunch demo hand.launch side:=left"/>
    </launch>"""
    assert uses_of(PARTS["given in launch"](launch)) == Uses(
        (("hand.launch", frozenset(("side",))), ("arm.launch", frozenset(("side",)))),
        (("my arm.launch", frozenset(("side", "base"))), ("", frozenset(("any",)))),
    )
    assert uses_of(PARTS["given"]("roslaunch demo arm.launch side:=left\nroslaunch demo hand.launch\n")) == Uses(
        (("arm.launch", frozenset(("side",))),), ()
    )
    assert uses_of(PARTS["given"]("nothing")) == NOTHING
    assert uses_of(["", "x", ":"]) == Uses((("", frozenset()),), ())


def test_the_variables_of_a_launch_file() -> None:
    text = "<!-- $(env OFF) $(env OFF) --> $(env ROBOT) $( env ROBOT ) $(optenv SIDE left) $(env BASE base)"
    assert PARTS["variables"](text) == ["!OFF", "!ROBOT", "+ROBOT", "?BASE", "?SIDE"]


def test_the_machines_of_a_launch_file() -> None:
    assert PARTS["machines"]("<machine name=' a ' address='b'/><machine address='x' name='c'/><machine name='$(arg d)'/>") == ["a", "c"]


@pytest.mark.parametrize("part", PARTS)
def test_what_is_kept_of_a_part(part: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """It is what is in the file, whatever somebody else has kept."""
    monkeypatch.setattr(contents, "RACY", 0)
    monkeypatch.setattr(contents, "WORTH_WRITING", 1)
    file = tmp_path / "a.launch"
    for text in ("<launch/>", "<launch><arg name='a'/><machine name='m'/> $(env A) $(var a) out humble ros</launch>"):
        file.write_text(text)
        for broken in (False, True):
            held = contents.Contents(str(tmp_path / "kept"))
            if broken:
                for facts in held._facts.values():
                    facts.update((kind, 7) for kind in facts)
            assert list(part_of(str(file), part, held)) == list(part_of(str(file), part))
            assert known_state(str(file), part, held) == part_state(file.read_bytes(), part)
            held.keep()
