"""Robots of the corpus, and their pages."""

from __future__ import annotations

import fcntl
import os
from hashlib import sha256
from pathlib import Path

from playwright.sync_api import Browser, Page

from tests.conftest import find_corpus
from tests.report.html.browser.reading import drawn
from tests.report.html.browser.writing import write_report

ROBOTS = {
    "ros1/PR2+pr2_robot": "pr2_bringup/pr2.launch",
    "ros1/ethz-asl+rotors_simulator": "rotors_gazebo/launch/firefly_swarm_hovering_example.launch",
    "ros1/spencer-project+spencer_people_tracking": "launch/spencer_people_tracking_launch/launch/tracking_on_bagfile.launch",
    "ros1/ZJU-FAST-Lab+ego-planner-swarm": "src/planner/plan_manage/launch/swarm_large.launch",
    "ros2/autowarefoundation+autoware.universe": "launch/tier4_localization_launch/launch/localization.launch.xml",
    "ros2/autowarefoundation+autoware_launch": "autoware_launch/launch/logging_simulator.launch.xml",
    "ros2/castacks+AirStack": "common/ros_packages/desktop_bringup/launch/robot.launch.xml",
}
"""Of 29 to 106 nodes."""


class RobotPages:
    """Pages of robots as they stand in the corpus, in a directory that all processes of a run of tests share: each is written once."""

    def __init__(self, directory: Path) -> None:
        self._directory = directory

    def of(self, robot: str, launch: str) -> Path:
        """The page of a launch file of a robot, or (``.``) of all of them."""
        self._directory.mkdir(exist_ok=True)
        page = self._directory / f"{sha256(f'{robot} {launch}'.encode()).hexdigest()[:16]}.html"
        with page.with_suffix(".lock").open("w") as lock:
            fcntl.flock(lock, fcntl.LOCK_EX)
            if not page.exists():
                unfinished = page.with_suffix(".unfinished")
                written(Path(str(find_corpus())) / robot, launch, unfinished)
                os.replace(unfinished, page)
        return page


def written(directory: Path, launch: str, target: Path, *words: str) -> None:
    """Write the page of a robot, which is a workspace of its own."""
    write_report(directory, target, launch, "--workspace", ".", *words)


def add_newcomer(launch: Path, robot: str, package: str, program: str, words: str = "") -> None:
    """Add a node of the name *newcomer* to a launch file of a robot."""
    program_is = "exec" if robot.startswith("ros2/") else "type"
    node = f'<node pkg="{package}" {program_is}="{program}" name="newcomer" args="{words}"/>'
    before, _, after = launch.read_text(encoding="utf-8").rpartition("</launch>")
    launch.write_text(f"{before}{node}</launch>{after}", encoding="utf-8")


def opened(browser: Browser, target: Path, fragment: str) -> Page:
    page = browser.new_page(viewport={"width": 1440, "height": 900}, reduced_motion="reduce")
    page.goto(f"{target.as_uri()}{fragment}")
    drawn(page)
    return page
