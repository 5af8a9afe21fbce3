"""What sources say of programs: what is read for it, what is kept, and what makes it be read again."""

from __future__ import annotations

import json
import os
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from launchlint.knowledge import reading
from launchlint.knowledge.own import OwnSources
from launchlint.library.lookup import Library
from launchlint.workspace import reading as disk
from launchlint.workspace.packages import Packages
from tests.cli.running import PACKAGE, write

TALKER = ("demo", "executables", "talker.py")
OTHER = ("other", "executables", "other_node")


def own(workspace: Path, cache: Path | None = None, root: Path | None = None) -> OwnSources:
    packages = Packages([str(workspace)], {}, explicit=True)
    return OwnSources(packages, str(root or workspace), None if cache is None else str(cache))


def names(program: Any, category: str = "publishers") -> list[tuple[str, str, str]]:
    """Name, type and place of each entry."""
    assert program is not None
    entries = program["variants"]["default"].get(category, [])
    return [(entry["name"], entry.get("type", ""), entry["evidence"][0]["at"]) for entry in entries]


@pytest.fixture
def readings(monkeypatch: pytest.MonkeyPatch) -> list[tuple[str, str, str]]:
    """The programs that are read from source, in order."""
    found: list[tuple[str, str, str]] = []
    real = reading.SourceReader.read

    def read(self: reading.SourceReader, key: tuple[str, str, str], *others: Any) -> Any:
        found.append(key)
        return real(self, key, *others)

    monkeypatch.setattr(reading.SourceReader, "read", read)
    return found


def test_a_script_and_a_program_of_cpp(workspace: Path) -> None:
    sources = own(workspace)
    assert names(sources.program(*TALKER)) == [("chatter", "std_msgs/String", "demo/scripts/talker.py:7")]
    assert names(sources.program(*OTHER)) == [("spoken", "std_msgs/String", "other/src/other.cpp:9")]
    assert sources.program("elsewhere", "executables", "x") is None
    assert sources.reason("elsewhere", "executables", "x") == ""
    assert sources.program("demo", "executables", "missing.py") is None
    assert sources.reason("demo", "executables", "missing.py") == "its package has no source of it"


def test_places_are_told_from_where_people_stand(workspace: Path) -> None:
    assert names(own(workspace, root=workspace / "demo").program(*TALKER))[0][2] == "scripts/talker.py:7"
    assert names(own(workspace, root=workspace / "demo").program(*OTHER))[0][2] == "../other/src/other.cpp:9"


def test_only_what_one_program_needs_is_read(workspace: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    read: set[str] = set()
    real = disk.read_bytes

    def watched(path: str, largest: int = disk.LARGEST_FILE) -> bytes:
        if os.path.isfile(path):
            read.add(os.path.relpath(path, workspace))
        return real(path, largest)

    sources = own(workspace)
    sources.names()
    monkeypatch.setattr(disk, "read_bytes", watched)
    assert sources.program(*OTHER) is not None
    assert read <= {f"other/{path}" for path in ("package.xml", "setup.py", "CMakeLists.txt", "src/other.cpp", "include/other/name.h")}
    read.clear()
    assert sources.program(*TALKER) is not None
    assert "demo/src/demo/names.py" in read
    assert not {path for path in read if path.startswith("other/") and not path.endswith("setup.py")}
    assert not {"demo/scripts/listener.py", "demo/scripts/counter.py"} & read


def test_a_second_run_reads_nothing_and_says_the_same(workspace: Path, tmp_path: Path, readings: list[Any]) -> None:
    first = [own(workspace, tmp_path / "kept").program(*key) for key in (TALKER, OTHER)]
    assert readings == [TALKER, OTHER]
    assert [own(workspace, tmp_path / "kept").program(*key) for key in (TALKER, OTHER)] == first
    assert readings == [TALKER, OTHER]


def append(path: str) -> Callable[[Path], None]:
    def change(workspace: Path) -> None:
        with open(workspace / path, "a", encoding="utf-8") as file:
            file.write("\n")

    return change


def make(path: str, text: str = "") -> Callable[[Path], None]:
    return lambda workspace: write(workspace, {path: text})


@pytest.mark.parametrize(
    ("change", "again"),
    [
        (append("demo/scripts/talker.py"), [TALKER]),
        (append("demo/src/demo/names.py"), [TALKER]),
        (append("demo/scripts/listener.py"), []),
        (append("other/src/other.cpp"), [OTHER]),
        (append("other/include/other/name.h"), [OTHER]),
        (append("other/CMakeLists.txt"), [OTHER]),
        (append("other/package.xml"), [OTHER]),
        (append("demo/launch/talk.launch"), []),
        (make("other/include/other/new.h"), [OTHER]),  # a pattern may take it
        (make("demo/scripts/std_msgs.py"), [TALKER]),  # a module that was not there
        (lambda workspace: (workspace / "demo/src/demo/names.py").unlink(), [TALKER]),
        (lambda workspace: (workspace / "demo/scripts/talker.py").chmod(0o644), [TALKER]),
        (make("third/package.xml", PACKAGE.format(name="third")), [TALKER, OTHER]),  # it may have modules and headers
    ],
)
def test_what_is_kept_is_used_as_long_as_nothing_it_hangs_on_has_changed(
    workspace: Path, tmp_path: Path, readings: list[Any], change: Callable[[Path], None], again: list[Any]
) -> None:
    before = own(workspace, tmp_path / "kept")
    digests = [before.digest(key) for key in (TALKER, OTHER) if before.program(*key)]
    readings.clear()
    change(workspace)
    after = own(workspace, tmp_path / "kept")
    changed = [key for key, digest in zip((TALKER, OTHER), digests, strict=True) if after.digest(key) != digest]
    assert changed == again
    for key in (TALKER, OTHER):
        assert own(workspace, tmp_path / "kept").known(key) == own(workspace).known(key)
    assert [key for key in (TALKER, OTHER) if readings.count(key) > 1] == again  # once for the run without a cache


def test_what_is_kept_holds_wherever_the_workspace_lies(workspace: Path, tmp_path: Path, readings: list[Any]) -> None:
    own(workspace, tmp_path / "kept").program(*TALKER)
    elsewhere = workspace.rename(tmp_path / "elsewhere")
    assert names(own(elsewhere, tmp_path / "kept").program(*TALKER))[0][2] == "demo/scripts/talker.py:7"
    assert readings == [TALKER]


def test_a_kept_file_that_is_broken_is_as_if_it_were_not_there(workspace: Path, tmp_path: Path, readings: list[Any]) -> None:
    expected = own(workspace, tmp_path / "kept").program(*TALKER)
    (file,) = (tmp_path / "kept").glob("*.json")
    for broken in (b"", b"\xff\0", file.read_bytes()[:-3], json.dumps([None, "", []]).encode(), b"[" * 100_000):
        file.write_bytes(broken)
        assert own(workspace, tmp_path / "kept").program(*TALKER) == expected
    assert len(readings) == 6


def test_a_cache_that_cannot_be_written_is_none(workspace: Path, tmp_path: Path) -> None:
    (tmp_path / "kept").write_text("a file")
    assert own(workspace, tmp_path / "kept").program(*TALKER) is not None


def test_who_asks_is_told_what_it_hangs_on(workspace: Path) -> None:
    sources = own(workspace)
    sources.program(*TALKER)
    sources.program("elsewhere", "executables", "x")
    assert sources.asked() == {TALKER}
    assert sources.asked() == frozenset()


def test_two_packages_of_one_name_are_not_told_apart(workspace: Path) -> None:
    write(workspace, {"copy/package.xml": PACKAGE.format(name="demo"), "copy/CMakeLists.txt": "project(demo)\n"})
    sources = own(workspace)
    assert sources.program(*TALKER) is None
    assert sources.reason(*TALKER) == "2 packages of the workspace are called demo"


def test_an_installed_copy_of_a_package_has_no_sources(workspace: Path) -> None:
    write(workspace, {"a_copy/share/demo/package.xml": PACKAGE.format(name="demo")})
    assert own(workspace).program(*TALKER) is not None


def test_a_nodelet_is_found_by_its_class(workspace: Path) -> None:
    manifest = PACKAGE.format(name="other").replace("</package>", '<export><nodelet plugin="${prefix}/nodelets.xml"/></export></package>')
    described = '<library path="lib/libours"><class name="{name}" type="ours::Sink" base_class_type="nodelet::Nodelet"/></library>\n'
    source = (
        "#include <nodelet/nodelet.h>\n#include <std_msgs/String.h>\nnamespace ours { class Sink : public nodelet::Nodelet {\n"
        'void onInit() { sub_ = getNodeHandle().subscribe("sunk", 1, &Sink::heard, this); }\n'
        "void heard(const std_msgs::String::ConstPtr& message) {}\nros::Subscriber sub_;\n}; }\n"
    )
    write(
        workspace, {"other/package.xml": manifest, "other/src/sink.cpp": source, "other/CMakeLists.txt": "add_library(ours src/sink.cpp)\n"}
    )
    for name in ("other/Sink", "strange/Sink"):
        write(workspace, {"other/nodelets.xml": described.format(name=name)})
        sources = own(workspace)
        assert sources.packages_of_class(name, everywhere=True) == ["other"]
        assert names(sources.program("other", "nodelets", name), "subscribers")[0][:2] == ("sunk", "std_msgs/String")
    assert own(workspace).packages_of_class("strange/Sink", everywhere=False) == []


def test_a_copy_of_a_public_package_is_what_runs(workspace: Path) -> None:
    text = """\
#include <ros/ros.h>
#include <nav_msgs/GetMap.h>
#include <nav_msgs/OccupancyGrid.h>

bool answer(nav_msgs::GetMap::Request&, nav_msgs::GetMap::Response&) { return true; }

int main(int argc, char** argv)
{
  ros::init(argc, argv, "map_server");
  ros::NodeHandle node;
  ros::ServiceServer service = node.advertiseService("static_map", answer);
  ros::Publisher publisher = node.advertise<nav_msgs::OccupancyGrid>("map", 1, true);
  ros::spin();
}
"""
    cmake = "cmake_minimum_required(VERSION 3.0)\nproject(map_server)\nfind_package(catkin)\nadd_executable(map_server main.cpp)\n"
    files = {"package.xml": PACKAGE.format(name="map_server"), "CMakeLists.txt": cmake, "main.cpp": text}
    write(workspace, {f"map_server/{name}": content for name, content in files.items()})
    found = [Library(own=each).executable("map_server", "map_server") for each in (None, own(workspace))]
    names = [sorted(each.name for each in program.variants[0].declarations if each.category != "params") for program in found if program]
    assert names == [["change_map", "map", "map_metadata", "static_map"], ["map", "static_map"]]
