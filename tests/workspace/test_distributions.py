"""Which distributions of ROS a workspace names."""

from __future__ import annotations

from pathlib import Path

import pytest

from launchlint.workspace.packages import Packages


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
        ({"notes.txt": "indigo is a colour"}, False),
        ({"README.md": "mindigos and kinetics"}, False),
    ],
)
def test_older(tmp_path: Path, files: dict[str, str], older: bool) -> None:
    for name, text in files.items():
        (tmp_path / name).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / name).write_text(text, encoding="utf-8")
    packages = Packages([str(tmp_path)], {}, explicit=True)
    assert packages.is_older_than("noetic") is older
