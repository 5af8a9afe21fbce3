"""What $(find-pkg-share PKG)/… leads to where a package installs its files to other places than they have in its sources."""

from __future__ import annotations

from pathlib import Path

from tests.evaluate.ros2.launching import Workspace, loaded, refusal

MANIFEST = '<package format="3"><name>pk</name><export><build_type>ament_cmake</build_type></export></package>'
INCLUDE = '<include file="$(find-pkg-share pk)/launch/inner/a.launch.xml"/>'
NODE = '<node pkg="pk" exec="e" name="n"><param from="$(find-pkg-share pk)/config/c.yaml"/></node>'


def _grown(directory: Path, main: str, cmake: str) -> Workspace:
    workspace = Workspace(directory, main)
    for name, text in {
        "package.xml": MANIFEST,
        "CMakeLists.txt": f"project(pk)\n{cmake}\n",
        "bringup/inner/a.launch.xml": "<launch/>",
        "bringup/config/c.yaml": "n: {ros__parameters: {a: 1}}",
    }.items():
        path = directory / "pk" / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text)
    return workspace


def test_an_include_is_found_where_its_package_installs_it_from(tmp_path: Path) -> None:
    launch = loaded(_grown(tmp_path, INCLUDE, "install(DIRECTORY bringup/inner DESTINATION share/pk/launch)").launch())
    assert [each.file for each in launch.includes] == [str(tmp_path / "pk/bringup/inner/a.launch.xml")]


def test_params_are_found_likewise(tmp_path: Path) -> None:
    launch = loaded(_grown(tmp_path, NODE, "install(DIRECTORY bringup/ DESTINATION share/${PROJECT_NAME})").launch())
    assert launch.nodes[0].own == {"a": ("int", 1)}


def test_what_is_installed_nowhere_is_not_found(tmp_path: Path) -> None:
    workspace = _grown(tmp_path, INCLUDE, "install(DIRECTORY bringup/inner DESTINATION share/pk)")
    assert refusal(workspace.launch()) == "include-not-found main.launch.xml:1"


def test_what_stands_there_in_the_sources_counts_first(tmp_path: Path) -> None:
    workspace = _grown(tmp_path, INCLUDE, "install(DIRECTORY bringup/inner DESTINATION share/pk/launch)")
    there = tmp_path / "pk/launch/inner/a.launch.xml"
    there.parent.mkdir()
    there.write_text("<launch/>")
    assert [each.file for each in loaded(workspace.launch()).includes] == [str(there)]
