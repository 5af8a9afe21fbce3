"""Which distributions of ROS 2 a repository names, and for which one its launch files are read."""

from __future__ import annotations

from pathlib import Path

import pytest

from launchlint.workspace.looking import noted
from launchlint.workspace.named_distributions import named_distributions
from launchlint.workspace.ros2_distributions import DISTRIBUTIONS, READ_AS, Meant, distribution


def named(directory: Path) -> dict[str, str]:
    return {name: Path(file).relative_to(directory).as_posix() for name, file in named_distributions([str(directory)], []).items()}


@pytest.mark.parametrize(
    ("file", "text", "names"),
    [
        ("README.md", "An arm for ROS 2 Humble.\n", {"humble"}),
        ("README.md", "It is my humble opinion, and I have an iron will.\n", set()),
        ("README.md", "See https://docs.ros.org/en/foxy/Tutorials.html about ROS.\n", set()),
        ("README.md", "| Rolling | main |\n|---|---|\n| Jazzy | jazzy |\n", {"rolling", "jazzy"}),
        ("README.md", "The foxyglove of ROS\n", set()),
        ("Dockerfile.robot", "FROM osrf/ros:foxy-desktop\n", {"foxy"}),
        ("docker/arm/Dockerfile", "FROM ros:galactic\n", {"galactic"}),
        (".devcontainer/devcontainer.json", '{"image": "ros:jazzy"}\n', {"jazzy"}),
        (".github/workflows/ci.yaml", "distro:\n  - humble\n  - rolling\n", {"humble", "rolling"}),
        ("arm.repos", "repositories:\n  arm:\n    version: humble-devel\n", {"humble"}),
        ("run.sh", "docker run -it --net=host maker/ros-foxy:3.4 /bin/bash\n", {"foxy"}),
        ("scripts/run.sh", "docker run -it ros:foxy\n", set()),
        ("docs/old.md", "For ROS 2 Foxy\n", set()),
        ("src/main.cpp", "// ROS 2 Foxy\n", set()),
    ],
)
def test_what_a_file_names(tmp_path: Path, file: str, text: str, names: set[str]) -> None:
    place = tmp_path / file
    place.parent.mkdir(parents=True, exist_ok=True)
    place.write_text(text)
    assert named(tmp_path) == dict.fromkeys(names, file)


def test_packages_are_asked_where_the_top_says_nothing(tmp_path: Path) -> None:
    package = tmp_path / "arm"
    package.mkdir()
    (package / "README.md").write_text("For ROS 2 Iron\n")
    assert named_distributions([str(tmp_path)], [str(package)]) == {"iron": str(package / "README.md")}


def test_what_was_read_is_noted_for_the_cache(tmp_path: Path) -> None:
    (tmp_path / "README.md").write_text("For ROS 2 Iron\n")
    noted()
    named(tmp_path)
    looked = set(noted().all())
    assert str(tmp_path) in looked
    assert f"{tmp_path}/README.md//distributions" in looked


@pytest.mark.parametrize(
    ("said", "variables", "names", "meant"),
    [
        ("humble", {"ROS_DISTRO": "jazzy"}, ["rolling"], Meant("humble", ("humble",))),
        ("", {"ROS_DISTRO": "humble"}, ["rolling"], Meant("humble", ("humble",))),
        ("", {"ROS_DISTRO": "noetic"}, [], Meant("jazzy")),
        ("", {"ROS_DISTRO": "foxy"}, [], Meant("humble", ("foxy",))),
        ("", {}, ["foxy"], Meant("humble", ("foxy",), "/foxy")),
        ("", {}, ["jazzy", "foxy", "humble"], Meant("jazzy", ("foxy", "humble", "jazzy"), "/jazzy")),
        ("", {}, ["iron"], Meant("jazzy", ("iron",), "/iron")),
    ],
)
def test_the_newest_counts(said: str, variables: dict[str, str], names: list[str], meant: Meant) -> None:
    assert distribution(said, variables, lambda: {name: f"/{name}" for name in names}) == meant


def test_what_is_older() -> None:
    assert Meant("jazzy", ("foxy", "humble", "jazzy")).before("galactic") == ("foxy",)
    assert set(READ_AS.values()) == set(DISTRIBUTIONS)
