"""Which files are launch files."""

from __future__ import annotations

import os
from collections.abc import Callable, Mapping
from pathlib import Path

import pytest

from launchlint.errors import UsageError
from launchlint.workspace.discovery import discover
from launchlint.workspace.patterns import matches

Grow = Callable[[Mapping[str, str | None]], Path]


@pytest.mark.parametrize(
    ("files", "expected"),
    [
        (
            {"a.launch": "", "b.test": "<launch/>", "c.launch.xml": "", "d.xml": "<launch/>"},
            ["a.launch", "b.test", "c.launch.xml", "d.xml"],
        ),
        (
            {"a.xml": "<robot/>", "b.test": "words", "c.txt": "<launch/>", "d.py": "", "package.xml": "<launch/>", "e.launch~": ""},
            [],
        ),
        (
            {"a.launch.yaml": "launch:\n", "b_launch.yml": "# x\nlaunch: []\n", "c.launch.yaml": "a: b\n", "d.yaml": "launch:\n"},
            ["a.launch.yaml", "b_launch.yml"],
        ),
        ({"a_launch.xml": "<launch/>", "b.launch.py": "", "c_launch.py": ""}, ["a_launch.xml", "b.launch.py", "c_launch.py"]),
        (
            {
                "test/test_a_launch.py": "import pytest\n\ndef test_names():\n    pass\n",
                "test/test_b_launch.py": "def generate_test_description():\n    pass\n\nclass TestIt:\n    pass\n",
                "test/test_c_launch.py": "def generate_launch_description():\n    pass\n\ndef test_it():\n    pass\n",
            },
            ["test/test_b_launch.py", "test/test_c_launch.py"],
        ),
        ({"broken.test": "<!-- x -- -->\n<launch>", "broken.xml": "words <launch>"}, ["broken.test"]),
        ({"a.launch": None, "a.launch/b.launch": ""}, ["a.launch/b.launch"]),
        ({".hidden/a.launch": "", ".a.launch": "", "b/.git/x.launch": ""}, [".a.launch"]),
        ({"build/CMakeCache.txt": "", "build/a.launch": "", "install/setup.sh": "", "install/b.launch": ""}, ["install/b.launch"]),
        ({"devel/.catkin": "", "devel/share/a.launch": "", "build_isolated/COLCON_IGNORE": "", "build_isolated/b.launch": ""}, []),
        ({"x/.colcon_install_layout": "", "x/a.launch": "", "log/COLCON_IGNORE": "", "log/b.launch": ""}, []),
        ({"ws/.catkin_workspace": "", "ws/install/share/a.launch": "", "ws/src/install/b.launch": ""}, ["ws/src/install/b.launch"]),
        ({"p/CMakeCache.txt": "", "p/a.launch": "", "q/CATKIN_IGNORE": "", "q/b.launch": ""}, ["p/a.launch", "q/b.launch"]),
        ({"a/x.launch": "", "link": "-> a", "up": "-> .", "dead": "-> nowhere", "dead.launch": "-> nowhere"}, ["a/x.launch"]),
        ({"a/x.launch": "", "y.launch": "-> a/x.launch"}, ["a/x.launch", "y.launch"]),
        ({"b.launch": "", "a/b.launch": "", "a.launch": ""}, ["a.launch", "a/b.launch", "b.launch"]),
    ],
)
def test_discovery(files: Mapping[str, str | None], expected: list[str], grow: Grow, monkeypatch: pytest.MonkeyPatch) -> None:
    root = grow(files)
    assert discover([str(root)]) == [f"{root}/{each}" for each in expected]
    monkeypatch.chdir(root)
    assert discover(["."]) == expected


def test_links_to_other_places_are_followed_once(grow: Grow) -> None:
    root = grow(
        {
            "elsewhere/p/x.launch": "",
            "ws/a": "-> ../elsewhere",
            "ws/b": "-> ../elsewhere/p",
            "ws/all": "-> /",
            "elsewhere/p/back": "-> ../..",
        }
    )
    assert discover([f"{root}/ws"]) == [f"{root}/ws/a/p/x.launch"]


def test_paths_are_taken_once_and_as_they_are_spelled(grow: Grow, monkeypatch: pytest.MonkeyPatch) -> None:
    root = grow({"a/x.launch": "", "a/build/y.launch": "", "a/build/CMakeCache.txt": "", "notes.txt": ""})
    monkeypatch.chdir(root)
    assert discover(["a", "./a/x.launch", f"{root}/a/x.launch", "notes.txt", "a/build/y.launch"]) == [
        "a/build/y.launch",
        "a/x.launch",
        "notes.txt",
    ]
    assert discover(["a/build"]) == ["a/build/y.launch"]
    assert discover([]) == []


@pytest.mark.parametrize(
    ("exclude", "expected"),
    [
        ([], ["p/launch/a.launch", "p/launch/old/b.launch", "test/c.launch"]),
        (["old"], ["p/launch/a.launch", "test/c.launch"]),
        (["test/"], ["p/launch/a.launch", "p/launch/old/b.launch"]),
        (["p/*.launch"], ["p/launch/a.launch", "p/launch/old/b.launch", "test/c.launch"]),
        (["p/**/*.launch"], ["test/c.launch"]),
        (["*.launch"], []),
        (["/launch"], ["p/launch/a.launch", "p/launch/old/b.launch", "test/c.launch"]),
    ],
)
def test_exclude(exclude: list[str], expected: list[str], grow: Grow, monkeypatch: pytest.MonkeyPatch) -> None:
    root = grow({"p/launch/a.launch": "", "p/launch/old/b.launch": "", "test/c.launch": ""})
    monkeypatch.chdir(root)
    assert discover(["."], exclude) == expected
    monkeypatch.chdir("/")
    assert discover([str(root)], exclude, base=str(root)) == [f"{root}/{each}" for each in expected]


def test_an_excluded_file_that_is_named_is_taken(grow: Grow) -> None:
    root = grow({"a.launch": ""})
    assert discover([f"{root}/a.launch"], ["*.launch"]) == [f"{root}/a.launch"]


def test_a_path_that_does_not_exist(tmp_path: Path) -> None:
    with pytest.raises(UsageError) as caught:
        discover([f"{tmp_path}/no.launch"])
    assert str(caught.value) == f"{tmp_path}/no.launch: No such file or directory; give launch files, or directories to search for them"
    with pytest.raises(UsageError) as caught:
        discover(["a\0b"])
    assert str(caught.value).endswith("embedded null byte; give launch files, or directories to search for them")


def test_hostile_names_and_files(tmp_path: Path) -> None:
    odd = ["\x1b[31m.launch", "new\nline.launch", "::error::.launch", "\u202egnp.launch"]
    for name in odd:
        (tmp_path / name).write_text("")
    raw = os.path.join(os.fsencode(tmp_path), b"\xff.launch")
    with open(raw, "w"):
        pass
    os.mkfifo(tmp_path / "pipe.launch")
    os.mkfifo(tmp_path / "pipe.xml")
    found = discover([str(tmp_path)])
    assert found == sorted([*(f"{tmp_path}/{each}" for each in odd), os.fsdecode(raw)])


@pytest.mark.parametrize(
    ("pattern", "path", "expected"),
    [
        ("*.launch", "a.launch", True),
        ("*.launch", "x/y/a.launch", True),
        ("a", "x/a/b.launch", True),
        ("a", "x/ab/b.launch", False),
        ("x/*", "x/a", True),
        ("x/*", "x/a/b", True),
        ("x/*", "y/x/a", False),
        ("x/*.launch", "x/a/b.launch", False),
        ("x/**/b.launch", "x/b.launch", True),
        ("x/**/b.launch", "x/y/z/b.launch", True),
        ("x/**", "x/y/z", True),
        ("x/**", "x", False),
        ("**/b", "a/b", True),
        ("./x", "x/a", True),
        ("/x", "x/a", True),
        ("/x", "y/x", False),
        ("[ab].launch", "b.launch", True),
        ("[!ab].launch", "b.launch", False),
        ("[", "[", True),
        ("?.launch", "a.launch", True),
        ("?.launch", "ab.launch", False),
        ("a.launch", "aXlaunch", False),
        ("(a|b)", "a", False),
        ("a\nb", "a\nb", True),
    ],
)
def test_patterns(pattern: str, path: str, expected: bool) -> None:
    assert matches(pattern, path) is expected
