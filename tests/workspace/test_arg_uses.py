"""Args that files of a workspace give to launch files by name."""

from __future__ import annotations

import time
from pathlib import Path

from launchlint.workspace.arg_uses import read_arg_uses


def test_a_line_gives_what_stands_in_it(tmp_path: Path) -> None:
    (tmp_path / "start.sh").write_text("roslaunch robot base.launch \\\n  map:=hall\nroslaunch robot arm.launch side:=left\n")
    uses = read_arg_uses([str(tmp_path)])
    given = str(tmp_path / "start.sh")
    assert uses.giver("/elsewhere/base.launch", "map") == given
    assert uses.giver("/elsewhere/arm.launch", "side") == given
    assert uses.giver("/elsewhere/base.launch", "side") is None
    assert {str(tmp_path), f"{tmp_path}/start.sh//given"} <= uses.looked


def test_a_launch_file_gives_what_its_nodes_are_given(tmp_path: Path) -> None:
    (tmp_path / "start.launch").write_text(
        '<launch><!-- <node args="old:=1"/> -->\n'
        '<node args="a:=1\n b:=2"/><param command="xacro c:=3"/><include file="$(find robot)/base.launch"/></launch>'
    )
    uses = read_arg_uses([str(tmp_path)])
    assert [name for name in ("a", "b", "c", "old") if uses.giver("/elsewhere/base.launch", name)] == ["a", "b"]


def test_a_file_that_gives_to_itself_is_no_giver(tmp_path: Path) -> None:
    (tmp_path / "base.launch").write_text('<launch><node args="base.launch map:=1"/></launch>')
    assert read_arg_uses([str(tmp_path)]).giver(str(tmp_path / "base.launch"), "map") is None


def test_includes_pass_args_to_a_file_or_to_any_file(tmp_path: Path) -> None:
    (tmp_path / "all.launch").write_text(
        '<launch><arg name="own"/><include file="a.launch"><arg name="x" value="1"/></include>'
        '<include file="$(arg part).launch"><arg name="y" value="1"/></include><arg name="after"/></launch>'
    )
    uses = read_arg_uses([str(tmp_path)])
    passed = {name for name in ("own", "x", "y", "after") if uses.is_passed("/elsewhere/a.launch", name)}
    assert passed == {"x", "y"}
    assert not uses.is_passed("/elsewhere/b.launch", "x")


def test_hostile_files_take_no_time(tmp_path: Path) -> None:
    (tmp_path / "a.sh").write_text("a" * 150_000 + ":=" + "x.launch" * 5_000)
    (tmp_path / "b.launch").write_text('<include file="' * 6_000 + "<arg name " * 6_000)
    (tmp_path / "c.launch").write_text("<!--" * 40_000 + ":=")
    (tmp_path / "d.launch").write_text('args="' * 30_000 + ":=")
    begin = time.process_time()
    read_arg_uses([str(tmp_path), str(tmp_path / "missing")])
    assert time.process_time() - begin < 2
