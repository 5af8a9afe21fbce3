"""The result cache with launch files of ROS 2: what makes which of them work again."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.check.many import computed
from tests.cli.ferry import BROKEN, GOOD, HELM, LAUNCH, SEA, Ferry

DOCK = (
    '<launch><node pkg="joy" exec="dock" name="dock"><param from="$(find-pkg-share ferry_bringup)/config/dock{}.yaml"/></node></launch>\n'
)
COPIES = 20
ALL = COPIES + 3


class Counted(Ferry):
    """The example and many launch files beside it, each with a parameter file of its own."""

    def __init__(self, directory: Path) -> None:
        super().__init__(directory)
        for number in range(COPIES):
            self.write(**{f"{LAUNCH}/dock{number}.launch.xml": DOCK.format(number)})
            self.write(**{f"ferry_bringup/config/dock{number}.yaml": "/dock:\n  ros__parameters:\n    depth: 1\n"})

    def computed(self) -> int:
        """How many entry files are computed anew in one run with the cache; what is told must be what is told without it."""
        count = computed(self.directory, cache=self.directory.parent / f"{self.directory.name}-cache")
        assert self.run("check", "--format", "json").output == self.run("check", "--format", "json", "--no-cache").output
        return count


@pytest.fixture
def ferry(tmp_path: Path) -> Counted:
    made = Counted(tmp_path / "ferry")
    assert made.computed() == ALL
    assert made.computed() == 0
    return made


def test_a_launch_file_that_nobody_includes(ferry: Counted) -> None:
    ferry.change(f"{LAUNCH}/dock1.launch.xml", 'name="dock"', 'name="other"')
    assert ferry.computed() == 1
    assert "LL901" in ferry.run("check").output


def test_an_included_file_in_yaml(ferry: Counted) -> None:
    ferry.change(HELM, "turtle1/cmd_vel", "turtle1/cmd_vel/")
    assert ferry.computed() == 3  # itself, and the two that include it
    assert f"{HELM}:22:11: error LL947" in ferry.run("check").output


def test_a_parameter_file(ferry: Counted) -> None:
    ferry.change("ferry_bringup/config/dock3.yaml", "/dock:", "/pier:")
    assert ferry.computed() == 1
    assert f"{LAUNCH}/dock3.launch.xml:1:49: warning LL901" in ferry.run("check").output


def test_a_parameter_file_that_is_gone(ferry: Counted) -> None:
    (ferry.directory / SEA).unlink()
    assert ferry.computed() > 0
    assert f"{GOOD}:8:" in ferry.run("check").output


def test_a_manifest(ferry: Counted) -> None:
    ferry.change("ferry_bringup/package.xml", "<name>ferry_bringup</name>", "<name>ferry_launch</name>")
    assert ferry.computed() == ALL
    assert "0 load, 1 is refused by ros2 launch, 22 cannot be told" in ferry.run("check").output


def test_a_build_file(ferry: Counted) -> None:
    ferry.change("ferry_bringup/CMakeLists.txt", "DIRECTORY launch config", "DIRECTORY launch")
    assert ferry.computed() > 0
    assert "LL945" in ferry.run("check").output


def test_another_distribution(ferry: Counted) -> None:
    ferry.write(**{".launchlint.yaml": "distro: humble\n"})
    assert ferry.computed() == ALL


def test_what_is_fixed_is_not_told_again(ferry: Counted) -> None:
    ferry.run("check", "--fix")
    assert "LL112" not in ferry.run("check", BROKEN).output
