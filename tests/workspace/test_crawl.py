"""Which packages a crawl finds: the rules of rospkg.rospack.list_by_path, and what hostile trees do to it."""

from __future__ import annotations

import json
import os
import subprocess
from collections.abc import Callable, Mapping
from pathlib import Path

import pytest

from launchlint.workspace.crawl import COLCON, crawl

Grow = Callable[[Mapping[str, str | None]], Path]

META = "<package><name>meta</name><export><metapackage/></export></package>"

# Case → (files, name → directory as $(find) sees it). None of them is broken, so that the real rospkg can be asked the same.
RULES: dict[str, tuple[Mapping[str, str | None], dict[str, str]]] = {
    "plain": ({"a/package.xml": "package one", "b/c/package.xml": "package two"}, {"one": "a", "two": "b/c"}),
    "the root itself": ({"package.xml": "package top", "below/package.xml": "package below"}, {"top": "."}),
    "a package is a leaf": ({"a/package.xml": "package a", "a/inner/package.xml": "package inner"}, {"a": "a"}),
    "the name is what the file says": ({"directory/package.xml": "package  other\n"}, {"other": "directory"}),
    "manifest.xml has the name of its directory": ({"old/manifest.xml": "<package/>"}, {"old": "old"}),
    "package.xml goes before manifest.xml": ({"x/manifest.xml": "<package/>", "x/package.xml": "package y"}, {"y": "x"}),
    "a metapackage does not count and is a leaf": ({"m/package.xml": META, "m/inner/package.xml": "package inner"}, {}),
    "a metapackage beside its packages": ({"s/m/package.xml": META, "s/p/package.xml": "package p"}, {"p": "s/p"}),
    "a metapackage with a manifest.xml": ({"m/package.xml": META, "m/manifest.xml": "<package/>"}, {"m": "m"}),
    "CATKIN_IGNORE": ({"a/CATKIN_IGNORE": "", "a/package.xml": "package a", "a/b/package.xml": "package b"}, {}),
    "a directory called CATKIN_IGNORE ignores nothing": ({"a/CATKIN_IGNORE": None, "a/package.xml": "package a"}, {"a": "a"}),
    "rospack_nosubdirs": ({"a/rospack_nosubdirs": "", "a/b/package.xml": "package b"}, {}),
    "rospack_nosubdirs in a package": ({"a/rospack_nosubdirs": "", "a/package.xml": "package a"}, {"a": "a"}),
    "hidden directories": ({".git/package.xml": "package hidden", "a/package.xml": "package a"}, {"a": "a"}),
    "a directory called package.xml": ({"a/package.xml": None, "a/b/package.xml": "package b"}, {"b": "a/b"}),
    "other ignore files mean nothing": ({"a/COLCON_IGNORE": "", "a/AMENT_IGNORE": "", "a/package.xml": "package a"}, {"a": "a"}),
    "links are followed": ({"real/x/package.xml": "package x", "ws/link": "-> ../real/x", "real/CATKIN_IGNORE": ""}, {"x": "ws/link"}),
    "a dangling link": ({"a/package.xml": "package a", "b": "-> nowhere"}, {"a": "a"}),
    "odd names": ({"a b/ü/package.xml": "package x y", "-/package.xml": "package -"}, {"x y": "a b/ü", "-": "-"}),
}

# As above, for colcon.
COLCON_RULES: dict[str, tuple[Mapping[str, str | None], dict[str, str]]] = {
    "a package is a leaf": ({"a/package.xml": "package a", "a/inner/package.xml": "package inner"}, {"a": "a"}),
    "COLCON_IGNORE": ({"a/COLCON_IGNORE": "", "a/package.xml": "package a", "a/b/package.xml": "package b"}, {}),
    "AMENT_IGNORE above": ({"a/AMENT_IGNORE": "", "a/b/package.xml": "package b", "c/package.xml": "package c"}, {"c": "c"}),
    "CATKIN_IGNORE and rospack_nosubdirs mean nothing": (
        {"a/CATKIN_IGNORE": "", "a/rospack_nosubdirs": "", "a/b/package.xml": "package b"},
        {"b": "a/b"},
    ),
    "manifest.xml means nothing": ({"old/manifest.xml": "<package/>", "old/new/package.xml": "package new"}, {"new": "old/new"}),
    "a metapackage is one as any other": ({"m/package.xml": META, "m/inner/package.xml": "package inner"}, {"meta": "m"}),
    "hidden directories": ({".git/package.xml": "package hidden", "a/package.xml": "package a"}, {"a": "a"}),
}


def _found(root: Path) -> dict[str, str]:
    found: dict[str, str] = {}
    for each in crawl(str(root)):
        if not each.metapackage and not each.reason:
            found.setdefault(each.name, os.path.relpath(each.directory, root))
    return found


@pytest.mark.parametrize("case", RULES)
def test_rules(case: str, grow: Grow) -> None:
    files, expected = RULES[case]
    assert _found(grow(files)) == expected


@pytest.mark.parametrize("case", COLCON_RULES)
def test_rules_of_colcon(case: str, grow: Grow) -> None:
    files, expected = COLCON_RULES[case]
    root = grow(files)
    assert {each.name: os.path.relpath(each.directory, root) for each in crawl(str(root), COLCON)} == expected


@pytest.mark.ros
@pytest.mark.parametrize("case", RULES)
def test_the_real_rospkg_finds_the_same(case: str, grow: Grow, ros_python: str) -> None:
    files, expected = RULES[case]
    root = grow(files)
    program = "import json, rospkg, sys; r = rospkg.RosPack([sys.argv[1]]); print(json.dumps({n: r.get_path(n) for n in r.list()}))"
    answer = subprocess.run([ros_python, "-c", program, str(root)], capture_output=True, text=True, check=True).stdout
    assert {name: os.path.relpath(path, root) for name, path in json.loads(answer).items()} == expected


@pytest.mark.ros
@pytest.mark.corpus
def test_the_real_rospkg_finds_the_same_in_public_repositories(corpus: Path, ros_python: str) -> None:
    program = (
        "import json, rospkg, sys\n"
        "def names(path):\n"
        "    r = rospkg.RosPack([path])\n"
        "    return sorted(r.list())\n"
        "print(json.dumps([names(p) for p in sys.argv[1:]]))\n"
    )
    repositories = sorted(each for each in (corpus / "ros1").iterdir() if each.is_dir())
    answer = subprocess.run([ros_python, "-c", program, *map(str, repositories)], capture_output=True, text=True, check=True).stdout
    ours = [sorted(_found(each)) for each in repositories]
    assert ours == json.loads(answer)


def test_broken_files_are_recorded_and_the_crawl_goes_on(grow: Grow) -> None:
    root = grow(
        {"a/package.xml": "<package", "a/inner/package.xml": "package inner", "b/package.xml": "package b", "c/package.xml": "<package/>"}
    )
    assert [(os.path.relpath(each.manifest_path, root), each.name, each.reason) for each in crawl(str(root))] == [
        ("a/package.xml", "", "not well-formed XML: unclosed token, line 1, column 0"),
        ("b/package.xml", "b", ""),
        ("c/package.xml", "", "it has no <name>"),
    ]


def test_order_is_that_of_a_sorted_depth_first_walk(grow: Grow) -> None:
    root = grow({f"{each}/package.xml": "package p" for each in ("b", "a/z", "a/y/x", "a-b", "B")})
    assert [os.path.relpath(each.directory, root) for each in crawl(str(root))] == ["B", "a/y/x", "a/z", "a-b", "b"]


@pytest.mark.parametrize(
    ("files", "expected"),
    [
        ({"a/package.xml": "package a", "b/loop": "-> ../b"}, {"a": "a"}),
        ({"a/package.xml": "package a", "b/up": "-> .."}, {"a": "a"}),
        ({"a/package.xml": "package a", "b/root": "-> /"}, {"a": "a"}),
        ({"a/b/c/up": "-> ../..", "a/p/package.xml": "package p"}, {"p": "a/p"}),
        ({"x/to_y": "-> ../y", "y/to_x": "-> ../x", "z/package.xml": "package z"}, {"z": "z"}),
        ({"self": "-> self", "z/package.xml": "package z"}, {"z": "z"}),
    ],
)
def test_links_that_lead_back(files: Mapping[str, str | None], expected: dict[str, str], grow: Grow) -> None:
    assert _found(grow(files)) == expected


def test_links_that_spell_a_million_paths(grow: Grow) -> None:
    files: dict[str, str | None] = {"d20/p/package.xml": "package p"}
    for number in range(20):
        files |= {f"d{number:02}/a": f"-> ../d{number + 1:02}", f"d{number:02}/b": f"-> ../d{number + 1:02}"}
    assert set(_found(grow(files))) == {"p"}


def test_what_cannot_be_read_is_passed_over(grow: Grow, tmp_path: Path) -> None:
    grow({"a/package.xml": "package a", "shut/b/package.xml": "package b", "c/package.xml": "package c"})
    os.mkfifo(tmp_path / "pipe")
    (tmp_path / "d").mkdir()
    os.mkfifo(tmp_path / "d" / "package.xml")
    shut = tmp_path / "shut"
    shut.chmod(0)
    try:
        found = crawl(str(tmp_path))
        readable = {"b"} if os.access(shut, os.R_OK) else set()
    finally:
        shut.chmod(0o755)
    assert {each.name for each in found if not each.reason} == {"a", "c"} | readable
    assert [each.reason for each in found if each.reason] == ["it cannot be read: it is not a plain file"]
    assert crawl(str(tmp_path / "nowhere")) == []
    assert crawl(str(tmp_path / "a" / "package.xml")) == []


def test_deep_directories(tmp_path: Path) -> None:
    directory = tmp_path
    for _ in range(300):
        directory /= "deep"
    directory.mkdir(parents=True)
    (directory / "package.xml").write_text("<package><name>p</name></package>")
    assert _found(tmp_path) == {"p": "/".join(["deep"] * 300)}
