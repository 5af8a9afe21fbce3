"""Reports in a real browser: one Chromium for all tests, a fresh page for each, and no trouble tolerated in any."""

from __future__ import annotations

import json
import os
import shutil
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest
from playwright.sync_api import Browser, BrowserContext, Page, sync_playwright

from tests.bench.report import write_launch
from tests.conftest import find_chromium
from tests.report.html.browser.hostile import write_hostile
from tests.report.html.browser.reading import drawn
from tests.report.html.browser.robots import RobotPages
from tests.report.html.browser.writing import commit, write_report

HERE = Path(__file__).parent

Open = Callable[..., Page]
FIRST = {"robot": "#entry=robot.launch"}
"""What is opened where a test does not say it; ``#``: the landing page."""


@pytest.fixture(scope="session")
def browser() -> Iterator[Browser]:
    """Debian's Chromium, or whichever there is; Playwright's own is never downloaded."""
    with sync_playwright() as playwright:
        started = playwright.chromium.launch(executable_path=find_chromium(), args=["--no-sandbox"])
        yield started
        started.close()


@pytest.fixture(scope="session")
def robot_pages(tmp_path_factory: pytest.TempPathFactory) -> RobotPages:
    """The pages of robots of the corpus."""
    own = tmp_path_factory.getbasetemp()
    return RobotPages((own.parent if "PYTEST_XDIST_WORKER" in os.environ else own) / "robot-pages")


@pytest.fixture(scope="session")
def reports(tmp_path_factory: pytest.TempPathFactory) -> Callable[[str], Path]:
    """A function: the page of the robot, of ``hostile`` names, of what ``changed``, of an ``empty`` file, of an ``unknown`` robot.

    Or of findings ``between`` nodes, of a file that is refused ``otherwise``, of ``fifty`` or ``three_hundred`` nodes.
    """
    made: dict[str, Path] = {}
    directory = tmp_path_factory.mktemp("reports")

    def report(name: str) -> Path:
        if name not in made:
            made[name] = MAKERS[name](directory / name)
        return made[name]

    return report


def _written(directory: Path, *words: str) -> Path:
    page = directory / "report.html"
    write_report(directory, page, *words, "--ignore", "LL303")
    return page


def _robot(directory: Path) -> Path:
    shutil.copytree(HERE / "robot", directory)
    words = (
        "robot.launch",
        "tools.launch",
        "--library",
        "library.json",
        "--title",
        "robot",
        "--source-url",
        "https://example.org/robot/blob/main/",
    )
    return _written(directory, *words)


def _changed(directory: Path) -> Path:
    shutil.copytree(HERE / "robot", directory)
    commit(directory)
    launch = directory / "robot.launch"
    before = launch.read_text()
    after = before.replace('to="left/image_raw"', 'to="right/image_raw"').replace('name="mystery"', 'name="riddle"')
    assert after != before
    launch.write_text(after)
    return _written(directory, "robot.launch", "--library", "library.json", "--title", "changed", "--base", "HEAD")


def _pull(directory: Path) -> Path:
    """A pull request: one launch file with other connections, one that a finding was fixed in, one as it was, one new."""
    shutil.copytree(HERE / "robot", directory)
    (directory / "calm.launch").write_text('<launch><node pkg="vision" type="camera" name="eye"/></launch>')
    commit(directory)
    launch, tools = directory / "robot.launch", directory / "tools.launch"
    launch.write_text(launch.read_text().replace('to="left/image_raw"', 'to="right/image_raw"').replace('name="mystery"', 'name="riddle"'))
    tools.write_text(tools.read_text().replace('name="camera"', 'name="second"', 1))
    (directory / "fresh.launch").write_text('<launch><node pkg="drive" type="driver" name="fresh"/></launch>')
    return _written(directory, "--library", "library.json", "--title", "pull", "--base", "HEAD")


def _choices(directory: Path) -> Path:
    """Nodes that depend on one arg, on another one, and on both."""
    directory.mkdir()
    (directory / "package.xml").write_text("<package><name>demo</name><version>1.0.0</version></package>")
    args = "".join(f'<arg name="{each}" default="false"/>' for each in ("sim", "gui", "log"))
    node = '<node pkg="demo" type="talk" name="{}"/>'
    both = f'<group if="$(arg gui)">{node.format("both")}<group unless="$(arg log)">{node.format("quiet")}</group></group>'
    text = f'{args}{node.format("always")}<group if="$(arg sim)">{node.format("sim")}{both}</group>'
    alone = f'<group if="$(arg log)">{node.format("log")}<param name="level" value="1"/></group>'
    (directory / "choices.launch").write_text(f"<launch>{text}{alone}</launch>")
    return _written(directory, "choices.launch")


def _copies(directory: Path) -> Path:
    """Forty copies of one mistake, and another one."""
    directory.mkdir()
    wrong = '<node pkg="demo" type="talk" name="n{}"><remap from="a" to="a"/></node>'
    nodes = "".join(wrong.format(number) for number in range(40))
    (directory / "copies.launch").write_text(f"<launch>{nodes}<wrong/></launch>")
    return _written(directory, "copies.launch")


def _hostile(directory: Path) -> Path:
    write_hostile(directory)
    return _written(directory, "hostile.launch", "--library", "library.json", "--title", "<b>hostile</b>")


def _hostile_cards(directory: Path) -> Path:
    """The same beside another launch file whose own name is hostile: a page that begins with a card of each."""
    write_hostile(directory)
    node = '<node pkg="demo" type="&lt;b&gt;talk&lt;/b&gt;" name="a"/>'
    (directory / "<img src=x onerror=alert(1)>.launch").write_text(f"<launch>{node}</launch>")
    return _written(directory, "--library", "library.json", "--title", "<b>hostile</b>")


def _empty(directory: Path) -> Path:
    directory.mkdir()
    (directory / "empty.launch").write_text('<launch><param name="a" value="1"/></launch>')
    return _written(directory, "empty.launch")


def _between(directory: Path) -> Path:
    """Findings that stand in no node: at an include, in the file that it includes, and beside everything."""
    directory.mkdir()
    node = '<node pkg="demo" type="talk" name="{}"/>'
    (directory / "part.launch").write_text(f'<launch><arg name="unread" default="1"/>{node.format("a")}</launch>')
    include = '<include file="$(dirname)/part.launch" oops=""/>'
    (directory / "main.launch").write_text(f'<launch><param name="p" value="$(env SITE)"/>{include}{node.format("b")}<wrong/></launch>')
    return _written(directory, "main.launch")


def _otherwise(directory: Path) -> Path:
    """A launch file that loads as it stands, and that roslaunch refuses with other args."""
    directory.mkdir()
    node = '<node pkg="demo" type="talk" name="a"/>'
    (directory / "main.launch").write_text(f'<launch><arg name="sim" default="false"/>{node}<group if="$(arg sim)">{node}</group></launch>')
    return _written(directory, "main.launch")


def _unknown(directory: Path) -> Path:
    shutil.copytree(HERE / "robot", directory)
    return _written(directory, "robot.launch", "--title", "unknown")


ROS2 = """\
from launch import LaunchDescription
from launch_ros.actions import ComposableNodeContainer, LifecycleNode, Node
from launch_ros.descriptions import ComposableNode


def generate_launch_description():
    eye = ComposableNode(package="vision", plugin="vision::Eye", name="eye", parameters=[{"rate": 30}])
    return LaunchDescription([
        Node(package="lidar", executable="driver", name="driver", parameters=[{"frame": "laser"}]),
        Node(package="mapping", executable="mapper", name="mapper"),
        LifecycleNode(package="mapping", executable="keeper", name="keeper", namespace=""),
        ComposableNodeContainer(
            package="rclcpp_components", executable="component_container", name="box", namespace="", composable_node_descriptions=[eye]
        ),
    ])
"""


def _ros2(directory: Path) -> Path:
    """ROS 2 in Python: two ends whose quality of service keeps them apart, a lifecycle node, a component in a container, params."""
    directory.mkdir()
    (directory / "main.launch.py").write_text(ROS2)

    def known(name: str, kind: str, type_: str, **qos: str) -> dict[str, object]:
        return {kind: [{"name": name, "type": type_, **({"qos": qos} if qos else {})}]}

    def program(class_: str, interface: dict[str, object]) -> dict[str, object]:
        return {"class": class_, "variants": {"default": interface}}

    scan, map_, image = "sensor_msgs/msg/LaserScan", "nav_msgs/msg/OccupancyGrid", "sensor_msgs/msg/Image"
    mapping = known("map", "publishers", map_, durability="transient_local")
    mapper = {**known("scan", "subscribers", scan, reliability="reliable"), **mapping}
    packages = {
        "lidar": {
            "middleware": "ros2",
            "executables": {"driver": program("rclcpp", known("scan", "publishers", scan, reliability="best_effort"))},
        },
        "mapping": {
            "middleware": "ros2",
            "executables": {
                "mapper": program("rclcpp", mapper),
                "keeper": program("rclcpp", {"lifecycle": True, **known("map", "subscribers", map_)}),
            },
        },
        "vision": {"middleware": "ros2", "components": {"vision::Eye": program("component", known("image", "publishers", image))}},
        "rclcpp_components": {"middleware": "ros2", "executables": {"component_container": program("container", {})}},
    }
    (directory / "library.json").write_text(json.dumps({"format": "launchlint-library", "version": 2, "packages": packages}))
    return _written(directory, "main.launch.py", "--library", "library.json")


def _perhaps(directory: Path) -> Path:
    """A node that may say two things and hear nine, and nobody does the other."""
    directory.mkdir()
    (directory / "package.xml").write_text("<package><name>demo</name><version>1.0.0</version></package>")
    (directory / "main.launch").write_text('<launch><node pkg="demo" type="talk" name="talk"/></launch>')
    may = {"type": "std_msgs/String", "condition": {"text": "if (debug_)"}}
    said = [{"name": f"{side}_said", **may} for side in ("left", "right")]
    heard = [{"name": "heard", "type": "std_msgs/String"}, *({"name": f"heard_{each}", **may} for each in range(9))]
    program = {"class": "roscpp", "variants": {"default": {"publishers": said, "subscribers": heard}}}
    packages = {"demo": {"executables": {"talk": program}}}
    (directory / "library.json").write_text(json.dumps({"format": "launchlint-library", "version": 1, "packages": packages}))
    return _written(directory, "main.launch", "--library", "library.json")


def _fifty(directory: Path, size: int = 50) -> Path:
    """A robot of fifty nodes, or of so many."""
    directory.mkdir()
    write_launch(directory, size)
    return _written(directory, "main.launch", "--library", "library.json")


MAKERS: dict[str, Callable[[Path], Path]] = {
    "robot": _robot,
    "changed": _changed,
    "hostile": _hostile,
    "hostile_cards": _hostile_cards,
    "empty": _empty,
    "unknown": _unknown,
    "between": _between,
    "otherwise": _otherwise,
    "pull": _pull,
    "choices": _choices,
    "copies": _copies,
    "ros2": _ros2,
    "perhaps": _perhaps,
    "fifty": _fifty,
    "three_hundred": lambda directory: _fifty(directory, 300),
}


@pytest.fixture
def open_report(browser: Browser, reports: Callable[[str], Path]) -> Iterator[Open]:
    """A function that opens a report, with a fragment and with the options of a browser context, and waits until it is drawn.

    Whatever the page complains of, and any dialog, is a failure.
    """
    contexts: list[BrowserContext] = []
    trouble: list[str] = []

    def opened(name: str = "robot", fragment: str = "", script: str = "", **options: object) -> Page:
        chosen = {"viewport": {"width": 1280, "height": 800}, "reduced_motion": "reduce", **options}
        context = browser.new_context(**chosen)  # type: ignore[arg-type]  # the options of a context, by name
        context.set_default_timeout(10_000)
        contexts.append(context)
        if script:  # of whatever shows the page
            context.add_init_script(script)
        page = context.new_page()
        page.on("console", lambda message: trouble.append(f"console: {message.text}"))
        page.on("pageerror", lambda error: trouble.append(f"error: {error}"))
        page.on("dialog", lambda dialog: (trouble.append(f"dialog: {dialog.message}"), dialog.dismiss()))
        page.on("request", lambda request: request.url.startswith(("file:", "blob:")) or trouble.append(f"request: {request.url}"))
        # Where there are several launch files, the page opens with all of them: most tests are about the one that is named here.
        page.goto(f"{reports(name).as_uri()}{fragment or FIRST.get(name, '')}")
        if chosen.get("java_script_enabled", True):
            drawn(page)
        return page

    yield opened
    for context in contexts:
        context.close()
    assert trouble == []
