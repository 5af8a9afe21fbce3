"""Directories that the containers of a workspace have."""

from __future__ import annotations

from pathlib import Path

import pytest

from launchlint.workspace.container_homes import read_homes


@pytest.mark.parametrize(
    ("name", "text"),
    [
        ("Dockerfile", "FROM ros\nWORKDIR /home/ada/ws\n"),
        ("docker/Dockerfile.ros1", "FROM ros\nUSER ada\n"),
        ("docker-compose.yml", "services:\n  robot:\n    volumes: ['.:/home/ada/ws']\n"),
        (".devcontainer/devcontainer.json", '{"workspaceFolder": "/home/ada/ws"}'),
        ("run.sh", "docker run -v $PWD:/home/ada/ws image\n"),
        ("run.sh", "docker run --mount type=bind,source=.,target=/home/ada/ws image\n"),
    ],
)
def test_a_container_has_a_home(tmp_path: Path, name: str, text: str) -> None:
    file = tmp_path / name
    file.parent.mkdir(exist_ok=True)
    file.write_text(text)
    homes = read_homes([str(tmp_path)])
    assert homes.users == {"ada"}
    assert str(file) in homes.looked


@pytest.mark.parametrize(
    ("name", "text"),
    [
        ("README.md", "docker run -v .:/home/ada/ws\n"),
        ("docker-compose.yml", "services:\n  robot:\n    volumes: ['/home/ada/ws:/data']\n"),
        ("run.sh", "export PATH=$PATH:/home/ada/bin\n"),
        ("run.sh", "docker run -v /home/ada/ws:/data image\n"),
    ],
)
def test_the_home_of_a_person_is_none(tmp_path: Path, name: str, text: str) -> None:
    (tmp_path / name).write_text(text)
    assert read_homes([str(tmp_path)]).users == frozenset()


@pytest.mark.parametrize(
    ("name", "text", "made"),
    [
        ("Dockerfile", "FROM ros\nWORKDIR /ws/src\n", {"/ws"}),
        ("Dockerfile", "FROM ros\nWORKDIR /root/ws\n", {"/root"}),
        ("Dockerfile", "FROM ros\nRUN mkdir -p /catkin_ws/src && true\n", {"/catkin_ws"}),
        ("docker-compose.yml", "services:\n  robot:\n    volumes: ['.:/workspace:rw']\n", {"/workspace"}),
        (".devcontainer/devcontainer.json", '{"workspaceFolder": "/workspaces/robot"}', {"/workspaces"}),
        ("Dockerfile", "FROM ros\nWORKDIR /opt/ros/noetic\nWORKDIR /\n# WORKDIR /commented\n", set()),
        ("docker-compose.yml", "services:\n  robot:\n    image: registry://host/image\n    volumes: ['/data/ws:/home/ada']\n", set()),
        ("run.sh", "export PATH=$PATH:/tools/bin\n", set()),
    ],
)
def test_other_directories_of_containers(tmp_path: Path, name: str, text: str, made: set[str]) -> None:
    file = tmp_path / name
    file.parent.mkdir(exist_ok=True)
    file.write_text(text)
    assert read_homes([str(tmp_path)]).directories == made
