"""Packages by name and place: order of the search, copies of one name, resources, completeness."""

from __future__ import annotations

import os
from collections.abc import Callable, Mapping
from pathlib import Path

import pytest

from launchlint.workspace.packages import Packages
from launchlint.workspace.public_packages import public_names

Grow = Callable[[Mapping[str, str | None]], Path]

PLACES = {
    "one/p/package.xml": "package p",
    "two/p/package.xml": "package p",
    "two/q/package.xml": "package q",
    "path/q/package.xml": "package q",
    "path/r/package.xml": "package r",
    "prefix/share/r/package.xml": "package r",
    "prefix/share/s/package.xml": "package s",
    "prefix/.catkin": "",
}


def test_order_of_the_search(grow: Grow) -> None:
    root = grow(PLACES)
    environment = {"ROS_PACKAGE_PATH": f"{root}/path::{root}/missing", "CMAKE_PREFIX_PATH": f"{root}/prefix"}
    packages = Packages([f"{root}/one", f"{root}/two"], environment, explicit=True)
    near = f"{root}/one/p/a.launch"
    assert {name: os.path.relpath(packages.find(name, near) or "/", root) for name in "pqrs"} == {
        "p": "one/p",
        "q": "two/q",
        "r": "path/r",
        "s": "prefix/share/s",
    }
    assert packages.find("t", near) is None
    assert packages.find("", near) is None
    assert packages.names() == ["p", "q", "r", "s"]
    assert packages.has("s")
    assert not packages.has("t")


def test_later_places_are_not_crawled_before_they_are_needed(grow: Grow) -> None:
    root = grow(PLACES)
    packages = Packages([f"{root}/one", f"{root}/two"], {}, explicit=True)
    assert packages.find("p", str(root)) == f"{root}/one/p"
    grow({"two/late/package.xml": "package late", "one/late/package.xml": "package late"})
    assert packages.find("late", str(root)) == f"{root}/two/late"


def test_usr_share_only_where_no_workspace_was_given(grow: Grow) -> None:
    root = grow(PLACES)
    assert [each.root for each in Packages([f"{root}/one"], {}, explicit=False).places] == [f"{root}/one", "/usr/share"]
    assert [each.root for each in Packages([f"{root}/one"], {}, explicit=True).places] == [f"{root}/one"]


def test_the_source_of_a_package_counts_before_an_installed_copy(grow: Grow) -> None:
    root = grow({"install/share/p/package.xml": "package p", "src/p/package.xml": "package p", "install/share/q/package.xml": "package q"})
    packages = Packages([str(root)], {}, explicit=True)
    assert packages.find("p", f"{root}/install/share/p/a.launch") == f"{root}/src/p"
    assert packages.find("q", f"{root}/a.launch") == f"{root}/install/share/q"
    assert packages.duplicates() == {}


def test_a_source_may_lie_in_a_directory_called_share(grow: Grow) -> None:
    built = {"share/p/package.xml": "package p", "share/p/CMakeLists.txt": "project(p)", "src/p/package.xml": "package p"}
    packages = Packages([str(grow(built))], {}, explicit=True)
    assert list(packages.duplicates()) == ["p"]


def test_of_several_copies_the_nearest_is_taken_then_the_first(grow: Grow) -> None:
    root = grow({f"{each}/package.xml": "package p" for each in ("a/p", "b/c/p", "b/p", "pp")})
    packages = Packages([str(root)], {}, explicit=True)
    nearest = {
        "a/x.launch": "a/p",
        "a/p/launch/x.launch": "a/p",
        "b/c/x.launch": "b/c/p",
        "b/x.launch": "b/c/p",
        "b/p/x.launch": "b/p",
        "pp/x.launch": "pp",
        "x.launch": "a/p",
        "ppp/x.launch": "a/p",
    }
    assert {file: os.path.relpath(packages.find("p", f"{root}/{file}") or "/", root) for file in nearest} == nearest
    assert {name: [os.path.relpath(each.directory, root) for each in copies] for name, copies in packages.duplicates().items()} == {
        "p": ["a/p", "b/c/p", "b/p", "pp"]
    }


def test_one_directory_under_two_names_is_no_duplicate(grow: Grow) -> None:
    root = grow({"ws/p/package.xml": "package p", "ws/q": "-> p"})
    packages = Packages([f"{root}/ws"], {}, explicit=True)
    assert [each.directory for each in packages.places[0].by_name["p"]] == [f"{root}/ws/p", f"{root}/ws/q"]
    assert packages.duplicates() == {}


def test_links_stay_in_the_spelling_of_the_directory(grow: Grow) -> None:
    root = grow({"real/p/package.xml": "package p", "ws/link": "-> ../real"})
    assert Packages([f"{root}/ws"], {}, explicit=True).find("p", f"{root}/ws/a.launch") == f"{root}/ws/link/p"


def test_package_of_a_file(grow: Grow) -> None:
    root = grow(
        {
            "repo/p/package.xml": "package p",
            "repo/p/launch/deep/x.launch": "",
            "repo/old/manifest.xml": "<package/>",
            "repo/meta/package.xml": "<package><name>m</name><export><metapackage/></export></package>",
            "repo/bad/package.xml": "<package>",
            "repo/x.launch": "",
        }
    )
    packages = Packages([], {}, explicit=True)

    def of(path: str) -> tuple[str, bool, str] | None:
        package = packages.package_of(f"{root}/repo/{path}")
        return None if package is None else (package.name, package.is_metapackage, package.broken)

    assert of("p/launch/deep/x.launch") == ("p", False, "")
    assert of("p/launch") == ("p", False, "")
    assert of("p/not/there.launch") == ("p", False, "")
    assert of("old/x.launch") == ("old", False, "")
    assert of("meta/x.launch") == ("m", True, "")
    assert of("bad/x.launch") == ("", False, "not well-formed XML: no element found, line 1, column 9")
    assert of("x.launch") is None
    assert packages.package_of(f"{root}/repo/p/launch") is packages.package_of(f"{root}/repo/p")


def test_manifest_is_read_when_it_is_asked_for(grow: Grow) -> None:
    root = grow(
        {"p/package.xml": "<package format='2'><name>p</name><exec_depend>amcl</exec_depend><test_depend>rostest</test_depend></package>"}
    )
    package = Packages([str(root)], {}, explicit=True).get("p", str(root))
    assert package is not None
    assert package.manifest is not None
    assert package.manifest.source.path == f"{root}/p/package.xml"
    assert (package.run_dependencies, package.test_dependencies, package.is_catkin) == (frozenset({"amcl"}), frozenset({"rostest"}), True)


def test_broken_packages(grow: Grow) -> None:
    root = grow({"a/package.xml": "<package>", "b/package.xml": "package b"})
    packages = Packages([str(root)], {}, explicit=True)
    assert [(os.path.relpath(each.manifest_path, root), each.broken) for each in packages.broken()] == [
        ("a/package.xml", "not well-formed XML: no element found, line 1, column 9")
    ]
    assert packages.names() == ["b"]
    assert (packages.broken()[0].manifest, packages.broken()[0].run_dependencies) == (None, frozenset())


@pytest.mark.parametrize(
    ("environment", "expected"),
    [
        ({}, False),
        ({"ROS_DISTRO": "no-such-distribution"}, False),
        ({"ROS_DISTRO": "../../tmp"}, False),
        ({"ROS_PACKAGE_PATH": "/somewhere"}, True),
        ({"ROS_PACKAGE_PATH": ":"}, False),
        ({"CMAKE_PREFIX_PATH": "{root}/plain"}, False),
        ({"CMAKE_PREFIX_PATH": "{root}/nowhere"}, False),
        ({"CMAKE_PREFIX_PATH": "{root}/plain:{root}/devel"}, True),
        ({"CMAKE_PREFIX_PATH": "{root}/install"}, True),
    ],
)
def test_complete(environment: dict[str, str], expected: bool, grow: Grow) -> None:
    root = grow({"plain/share/doc": None, "devel/.catkin": "", "install/share/roscpp": None})
    filled = {name: value.replace("{root}", str(root)) for name, value in environment.items()}
    assert Packages([], filled, explicit=True).complete is expected
    assert Packages([], filled, explicit=True, complete=not expected).complete is not expected


RESOURCES = {
    "src/p/package.xml": "package p",
    "src/p/tool": "+x #!/bin/sh",
    "src/p/launch/a.launch": "",
    "src/p/only_source": "",
    "devel/.catkin": "{root}/src;{root}/other",
    "devel/lib/p/tool": "+x #!/bin/sh",
    "devel/lib/p/plain": "",
    "devel/share/p/launch/b.launch": "",
    "install/.catkin": "",
    "install/share/p/launch/a.launch": "",
}


@pytest.mark.parametrize(
    ("path", "expected"),
    [
        ("", "src/p"),
        ("/", "src/p"),
        ("/tool", "devel/lib/p/tool"),
        ("/scripts/tool", "devel/lib/p/tool"),
        ("/plain", "src/p/plain"),
        ("/launch/a.launch", "src/p/launch/a.launch"),
        ("/launch/b.launch", "devel/share/p/launch/b.launch"),
        ("launch/a.launch", "src/p/launch/a.launch"),
        ("\\launch\\a.launch", "src/p/launch/a.launch"),
        ("/nowhere", "src/p/nowhere"),
        ("//etc/passwd", "/etc/passwd"),
        ("/../x", "src/p/../x"),
    ],
)
def test_resources_with_a_devel_space(path: str, expected: str, grow: Grow) -> None:
    root = grow(RESOURCES)
    (root / "devel" / ".catkin").write_text(f"{root}/src;{root}/other")
    packages = Packages([f"{root}/src"], {"CMAKE_PREFIX_PATH": f"{root}/devel:{root}/install"}, explicit=True)
    assert packages.resolve_resource(f"{root}/src/p", path) == (expected if expected.startswith("/") else f"{root}/{expected}")


def test_resources_come_from_the_first_space_that_has_them(grow: Grow) -> None:
    root = grow(RESOURCES)
    packages = Packages([f"{root}/src"], {"CMAKE_PREFIX_PATH": f"{root}/install"}, explicit=True)
    assert packages.resolve_resource(f"{root}/src/p", "/launch/a.launch") == f"{root}/install/share/p/launch/a.launch"


def test_resources_without_any_space(grow: Grow) -> None:
    root = grow(RESOURCES)
    packages = Packages([f"{root}/src"], {}, explicit=True)
    assert packages.resolve_resource(f"{root}/src/p", "/launch/b.launch") == f"{root}/src/p/launch/b.launch"
    assert packages.resolve_resource("/stub/find/p", "/x//y.launch") == "/stub/find/p/x//y.launch"


def test_public_packages() -> None:
    public = public_names()
    assert Packages([], {}, explicit=True).public is public
    assert "noetic" in public["amcl"]
    assert "melodic" in public["amcl"]
    assert public.get("no_such_package_anywhere") is None
    assert [name for name in ("", "#", "# Public ROS packages", "amcl\tx", "amc", "\namcl") if name in public] == []
    names = list(public)
    assert names == sorted(names)
    assert names[0] != ""
    assert {"tf2_ros", "rviz2", "move_base"} <= set(names)
    assert len(public) == len(names)


def test_a_package_that_catkin_ignore_hides(grow: Grow) -> None:
    root = grow(
        {
            "a/CATKIN_IGNORE": "", "a/b/package.xml": "package hidden", "a/c/CATKIN_IGNORE": "", "a/c/package.xml": "package deeper",
            "twice/package.xml": "package twice", "a/twice/package.xml": "package twice",
            "other/COLCON_IGNORE": "", "other/package.xml": "package other",
        }
    )  # fmt: skip
    packages = Packages([str(root)], {}, explicit=True)
    assert packages.hidden("hidden") == ("hidden", f"{root}/a/b", f"{root}/a/CATKIN_IGNORE")
    assert packages.hidden("deeper") == ("deeper", f"{root}/a/c", f"{root}/a/CATKIN_IGNORE")
    assert packages.hidden("twice") is None, "another one of that name is not hidden"
    assert packages.hidden("other") is None, "rospack finds it"
    assert packages.has("other")
    assert packages.is_hidden(f"{root}/a/b/launch")
    assert not packages.is_hidden(f"{root}/ab")


def test_the_same_places_as_colcon_sees_them(grow: Grow) -> None:
    root = grow(
        {
            "ws/a/package.xml": "package a",
            "ws/b/COLCON_IGNORE": "",
            "ws/b/package.xml": "package b",
            "ws/c/CATKIN_IGNORE": "",
            "ws/c/package.xml": "package c",
            "path/d/package.xml": "package d",
            "install/share/e/package.xml": "package e",
        }
    )
    environment = {"ROS_PACKAGE_PATH": str(root / "path"), "AMENT_PREFIX_PATH": str(root / "install")}
    packages = Packages([str(root / "ws")], environment, explicit=True)
    colcon = packages.colcon
    assert (packages.names(), colcon.names()) == (["a", "b", "d"], ["a", "c", "e"])
    assert packages.colcon is colcon
    assert colcon.colcon is colcon
    hidden = colcon.hidden("b")
    assert hidden is not None
    assert hidden.marker == str(root / "ws/b/COLCON_IGNORE")
    assert colcon.is_hidden(str(root / "ws/b"))
    assert not colcon.is_hidden(str(root / "ws/c"))
    assert colcon.complete
    assert not Packages([str(root / "ws")], {}, explicit=True).colcon.complete
