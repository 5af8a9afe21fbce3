"""The way from one package to another, as catkin's topological order has it."""

from __future__ import annotations

from pathlib import Path

import pytest

from launchlint.workspace.build_order import Way, ways_to
from launchlint.workspace.packages import Packages


def ways(tmp_path: Path, **needs: str) -> dict[str, Way]:
    for name, text in needs.items():
        (tmp_path / name).mkdir()
        (tmp_path / name / "package.xml").write_text(f'<package format="2"><name>{name}</name>{text}</package>')
    return ways_to("a", Packages([str(tmp_path)], {}, explicit=True))


@pytest.mark.parametrize("tag", ["build_depend", "buildtool_depend", "test_depend", "depend"])
def test_what_is_built_after_it(tmp_path: Path, tag: str) -> None:
    assert ways(tmp_path, a="", b=f"<{tag}>a</{tag}>")["b"] == Way(("b", "a"), built=True)


@pytest.mark.parametrize("tag", ["exec_depend", "build_export_depend"])
def test_what_needs_it_to_run(tmp_path: Path, tag: str) -> None:
    assert ways(tmp_path, a="", b=f"<{tag}>a</{tag}>")["b"] == Way(("b", "a"), built=False)


def test_what_catkin_does_not_ask_for(tmp_path: Path) -> None:
    assert not ways(tmp_path, a="", b="<doc_depend>a</doc_depend><buildtool_export_depend>a</buildtool_export_depend>")


def test_one_step_that_is_built_is_enough(tmp_path: Path) -> None:
    found = ways(
        tmp_path,
        a="",
        b="<exec_depend>a</exec_depend>",
        c="<build_depend>b</build_depend>",
        d="<exec_depend>c</exec_depend>",
    )
    assert found == {"b": Way(("b", "a"), False), "c": Way(("c", "b", "a"), True), "d": Way(("d", "c", "b", "a"), True)}


def test_the_way_that_is_built_goes_before_the_shorter_one(tmp_path: Path) -> None:
    found = ways(
        tmp_path,
        a="",
        b="<exec_depend>a</exec_depend><exec_depend>c</exec_depend>",
        c="<build_depend>a</build_depend>",
    )
    assert found["b"] == Way(("b", "c", "a"), True)


def test_a_ring_that_is_there_and_nobody_who_needs_it(tmp_path: Path) -> None:
    found = ways(tmp_path, a="<exec_depend>b</exec_depend>", b="<exec_depend>a</exec_depend>", c="<exec_depend>d</exec_depend>", d="")
    assert found == {"b": Way(("b", "a"), False)}


def test_who_may_yet_declare_it(tmp_path: Path) -> None:
    ways(tmp_path, a="", b="<build_depend>c</build_depend>", c="", d="")
    (tmp_path / "c" / "launch").mkdir()
    (tmp_path / "c" / "launch" / "c.launch").write_text('<launch><node pkg="a" type="t" name="n"/></launch>')
    (tmp_path / "d" / "d.launch").write_text('<launch><include file="$(find d)/e.launch"/></launch>')
    packages = Packages([str(tmp_path)], {}, explicit=True)
    assert ways_to("a", packages) == {}
    assert ways_to("a", packages, lacking=True) == {"c": Way(("c", "a"), False), "b": Way(("b", "c", "a"), True)}
