"""What $(find-pkg-share PKG)/path leads to, where the package is not built."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from pathlib import Path

import pytest

from launchlint.workspace.ament.shares import installed_source, may_be_installed, shared
from launchlint.workspace.packages import Packages

MANIFEST = '<package format="3"><name>rover</name><export><build_type>ament_cmake</build_type></export></package>'
CMAKE = (
    "project(rover)\ninstall(DIRECTORY bringup/launch DESTINATION share/rover)\ninstall(FILES gone.yaml DESTINATION share/rover/config)\n"
)


@pytest.fixture
def rover(grow: Callable[[Mapping[str, str | None]], Path]) -> Callable[[str], tuple[Packages, Path]]:
    def make(cmake: str) -> tuple[Packages, Path]:
        root = grow(
            {"src/package.xml": MANIFEST, "src/CMakeLists.txt": cmake, "src/bringup/launch/a.launch.xml": "", "src/config/c.yaml": ""}
        )
        return Packages([str(root)], {}, explicit=True), root / "src"

    return make


def test_a_file_that_is_installed_from_another_directory(rover: Callable[[str], tuple[Packages, Path]]) -> None:
    packages, directory = rover(CMAKE)
    assert installed_source(packages, str(directory / "launch/a.launch.xml")) == str(directory / "bringup/launch/a.launch.xml")
    assert installed_source(packages, str(directory / "launch/b.launch.xml")) is None
    assert installed_source(packages, str(directory / "config/gone.yaml")) is None


def test_what_may_be_there(rover: Callable[[str], tuple[Packages, Path]]) -> None:
    packages, directory = rover(CMAKE)
    assert may_be_installed(packages, str(directory / "config/gone.yaml")) == "it installs files whose names are not known here"
    assert may_be_installed(packages, str(directory / "config/c.yaml")) == ""
    assert may_be_installed(packages, str(directory / "launch/b.launch.xml")) == ""
    packages, directory = rover(CMAKE + "some_command()\n")
    assert may_be_installed(packages, str(directory / "launch/b.launch.xml")) == "the command some_command (line 4) is not known"
    (directory / "CMakeLists.txt").unlink()
    packages = Packages([str(directory)], {}, explicit=True)
    assert may_be_installed(packages, str(directory / "launch/b.launch.xml")) == ""


def test_what_lies_in_no_package(rover: Callable[[str], tuple[Packages, Path]]) -> None:
    packages, directory = rover(CMAKE)
    assert shared(packages, str(directory.parent / "launch/a.launch.xml")) is None
    assert shared(packages, str(directory)) is None
