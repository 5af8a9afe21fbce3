"""Which distributions of ROS a workspace names."""

from __future__ import annotations

from pathlib import Path

import pytest

from launchlint.workspace.packages import Packages
from launchlint.workspace.releases import never_released


@pytest.mark.parametrize(
    ("files", "older"),
    [
        ({}, False),
        ({"README.md": "Runs on ROS Hydro and Indigo."}, True),
        ({"README.md": "Runs on ROS Indigo."}, True),
        ({"README.md": "Runs on ROS Indigo.", "docker/Dockerfile": "FROM ros:noetic-ros-base\n"}, False),
        ({".github/workflows/ci.yml": "ROS_DISTRO: melodic\n"}, True),
        ({".travis.yml": "env: ROS_DISTRO=NOETIC\n"}, False),
        ({"scripts/install.sh": "apt-get install ros-kinetic-amcl\n"}, True),
        ({"README.md": "Get a computer with Ubuntu 18.04."}, True),
        ({"README.md": "Get a computer with ubuntu 20.04, or Ubuntu 18.04."}, False),
        ({"README.md": "Runs on ROS Noetic. Formerly Ubuntu 18.04."}, False),
        ({"README.md": "Ubuntu 118.04 and Ubuntu 18.041"}, False),
        ({"notes.txt": "indigo is a colour"}, False),
        ({"README.md": "mindigos and kinetics"}, False),
        ({"CMakeLists.txt": "# See http://ros.org/doc/groovy/api/catkin\n"}, True),
        ({"README.md": "Runs on ROS Noetic.", "CMakeLists.txt": "# See http://ros.org/doc/groovy/api/catkin\n"}, False),
        ({"CMakeLists.txt": "cmake_minimum_required(VERSION 3.0.2)\n# See http://ros.org/doc/groovy/api/catkin\n"}, False),
    ],
)
def test_older(tmp_path: Path, files: dict[str, str], older: bool) -> None:
    for name, text in files.items():
        (tmp_path / name).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / name).write_text(text, encoding="utf-8")
    packages = Packages([str(tmp_path)], {}, explicit=True)
    assert packages.distributions().are_older_than("noetic") is older


@pytest.mark.parametrize(
    ("text", "installs"),
    [
        ("catkin_make install\n", True),
        ("catkin config --init --install", True),
        ("catkin build\n", False),
        ("make install", False),
        ("./src/catkin/bin/catkin_make_isolated --install --install-space /opt/ros/noetic", False),
        ("colcon build\n", True),
        (". /opt/ros/foxy/setup.sh && colcon build\n", False),
    ],
)
def test_install_step(tmp_path: Path, text: str, installs: bool) -> None:
    (tmp_path / "README.md").write_text(text, encoding="utf-8")
    assert Packages([str(tmp_path)], {}, explicit=True).distributions().installs == ({str(tmp_path)} if installs else set())


@pytest.mark.parametrize(
    ("text", "fetched"),
    [
        ("git clone https://github.com/example/my_arm.git\n", True),
        ("  - mv -v arm/my_arm .\n", True),
        ("# git clone https://github.com/example/my_arm.git\n", False),
        ("roslaunch my_arm arm.launch\n", False),
        ("git clone https://github.com/example/my_arm_2.git\n", False),
    ],
)
def test_what_is_fetched(tmp_path: Path, text: str, fetched: bool) -> None:
    (tmp_path / "install.sh").write_text(text, encoding="utf-8")
    packages = Packages([str(tmp_path)], {}, explicit=True)
    assert packages.documented_in("my_arm") == (str(tmp_path / "install.sh") if fetched else None)


def test_never_released() -> None:
    assert never_released(["amcl", "turtlebot_bringup", "no_such_package"], "noetic") == "turtlebot_bringup"
    assert never_released(["amcl", "no_such_package"], "noetic") == ""
    assert never_released(["turtlebot_bringup"], "kinetic") == ""
