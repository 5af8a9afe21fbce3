"""Results hang on what was asked for them: after a change only those are computed whose questions could be answered differently, and all
that is told is what a run without a cache tells.
"""

from __future__ import annotations

import shutil
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest

from tests.check.test_trusted import Trusting
from tests.cli.running import PACKAGE, write

PACKAGES = ("alpha", "beta", "gamma")
EACH = 7
CMAKE = """\
cmake_minimum_required(VERSION 3.0.2)
project({name})
find_package(catkin REQUIRED)
catkin_package()
add_executable(drive_{name} src/drive.cpp)
install(TARGETS drive_{name} DESTINATION ${{CATKIN_PACKAGE_BIN_DESTINATION}})
install(DIRECTORY launch config DESTINATION ${{CATKIN_PACKAGE_SHARE_DESTINATION}})
"""
ENTRY = """\
<launch>
  <arg name="speed" default="{number}"/>
  <node name="drive" pkg="{name}" type="drive_{name}"><param name="speed" value="$(arg speed)"/></node>
  <node name="talk" pkg="{name}" type="talk.py"/>
  <rosparam file="$(find {name})/config/wheel.yaml"/>
</launch>
"""
OTHER = {
    "across": '<launch><include file="$(find alpha)/launch/e0.launch"/><node name="t" pkg="beta" type="talk.py"/></launch>\n',
    "lost": '<launch><node name="l" pkg="lost" type="l"/><node name="b" pkg="bet" type="t"/></launch>\n',
    "wrong": '<launch><node name="w" pkg="beta" type="drive_bet"/><include file="$(find gamma)/launch/e00.launch"/></launch>\n',
    "outside": '<launch><param name="p" value="$(env WHERE_IT_IS)"/><node machine="pc" name="t" pkg="alpha" type="talk.py"/></launch>\n',
    "made": '<launch><rosparam file="$(find alpha)/config/made.yaml"/></launch>\n',
    "elsewhere": '<launch><include file="$(find alpha)/launch/moved.launch"/></launch>\n',
}
TALK = "#!/usr/bin/env python3\nimport rospy\nfrom std_msgs.msg import String\n\nrospy.init_node('talk')\nrospy.Publisher('said', String)\n"


@pytest.fixture
def workspace(tmp_path: Path) -> Trusting:
    trusting = Trusting(tmp_path)
    shutil.rmtree(trusting.directory)
    write(trusting.directory, dict(_files()))
    for name in PACKAGES:
        (trusting.directory / name / "scripts/talk.py").chmod(0o755)
    return trusting


def _files() -> Iterator[tuple[str, str]]:
    yield ".git/HEAD", ""
    for name in PACKAGES:
        yield f"{name}/package.xml", PACKAGE.format(name=name)
        yield f"{name}/CMakeLists.txt", CMAKE.format(name=name)
        yield f"{name}/scripts/talk.py", TALK
        yield f"{name}/config/wheel.yaml", "radius: 0.1\n"
        for number in range(EACH):
            yield f"{name}/launch/e{number}.launch", ENTRY.format(name=name, number=number)
    yield "delta/package.xml", PACKAGE.format(name="delta")
    for name, text in OTHER.items():
        yield f"delta/launch/{name}.launch", text


def replace(file: str, old: str, new: str) -> Callable[[Path], None]:
    def change(directory: Path) -> None:
        text = (directory / file).read_text()
        assert old in text
        (directory / file).write_text(text.replace(old, new))

    return change


def put(file: str, text: str) -> Callable[[Path], None]:
    return lambda directory: write(directory, {file: text})


def remove(file: str) -> Callable[[Path], None]:
    return lambda directory: shutil.rmtree(directory / file) if (directory / file).is_dir() else (directory / file).unlink()


def rename(file: str, other: str) -> Callable[[Path], None]:
    return lambda directory: (directory / file).rename(directory / other) and None


def mode(file: str, bits: int) -> Callable[[Path], None]:
    return lambda directory: (directory / file).chmod(bits)


FEW = 4
OF_ONE = EACH + len(OTHER) + 2
"""Entry files that may hang on the files of one package, with one that is new."""
OF_TWO = OF_ONE + EACH
ALL = 100
DEPEND = "<exec_depend>{}</exec_depend></package>"
CHANGES: dict[str, tuple[Callable[[Path], None], int]] = {
    # name: what changes, and how many entry files may be computed for it
    "a launch file that nobody names": (put("gamma/launch/more.launch", "<launch/>\n"), OF_ONE),
    "a launch file that was missing": (put("gamma/launch/e00.launch", "<launch/>\n"), OF_ONE),
    "a launch file is removed": (remove("gamma/launch/e00.launch"), OF_ONE),
    "a launch file is renamed": (rename("gamma/launch/more.launch", "gamma/launch/most.launch"), OF_ONE),
    "a launch file that is missing elsewhere": (put("beta/launch/moved.launch", "<launch/>\n"), OF_ONE),
    "a README at the top": (put("README.md", "the robot\n"), FEW),
    "a README that names a package": (put("README.md", "roslaunch lost l.launch, and WHERE_IT_IS\n"), FEW),
    "a script that sets a variable": (put("env.sh", "export WHERE_IT_IS=here\n"), FEW),
    "a machine": (put("alpha/launch/machines.xml", '<launch><machine name="pc" address="pc"/></launch>\n'), OF_ONE),
    "git ignores a file": (put(".gitignore", "made.yaml\n"), FEW),
    "git ignores it no more": (put(".gitignore", "*.bag\n"), FEW),
    "a list of sources": (put(".rosinstall", "- git: {local-name: lost, uri: https://example.com/lost.git}\n"), FEW),
    "a parameter file": (replace("beta/config/wheel.yaml", "0.1", "[0.1"), OF_ONE),
    "a parameter file is removed": (remove("beta/config/wheel.yaml"), OF_ONE),
    "a parameter file is added": (put("beta/config/wheel.yaml", "radius: 0.2\n"), OF_ONE),
    "a dependency": (replace("beta/package.xml", "</package>", DEPEND.format("alpha")), OF_ONE),
    "a dependency of the one that starts it": (replace("delta/package.xml", "</package>", DEPEND.format("beta")), len(OTHER)),
    "a licence": (replace("alpha/package.xml", "<license>", "<license>Other "), OF_TWO),
    "a target": (replace("beta/CMakeLists.txt", "add_executable(drive_beta", "add_executable(drive_bet"), OF_ONE),
    "a target again": (replace("beta/CMakeLists.txt", "add_executable(drive_bet", "add_executable(drive_beta"), OF_ONE),
    "what is installed": (replace("gamma/CMakeLists.txt", "launch config", "config"), OF_ONE),
    "a made file": (put("alpha/CMakeLists.txt", CMAKE.format(name="alpha") + "configure_file(a config/made.yaml)\n"), OF_TWO),
    "a script loses its bit": (mode("alpha/scripts/talk.py", 0o644), OF_TWO),
    "a script gets its bit": (mode("alpha/scripts/talk.py", 0o755), OF_TWO),
    "a script loses its first line": (replace("beta/scripts/talk.py", "#!/usr/bin/env python3\n", ""), OF_ONE),
    "what a node says": (replace("gamma/scripts/talk.py", "'said'", "'says'"), OF_ONE),
    "a source that was missing": (put("gamma/src/drive.cpp", "#include <ros/ros.h>\nint main() {}\n"), ALL),
    "a package that was missing": (put("lost/package.xml", PACKAGE.format(name="lost")), ALL),
    "a package that is hidden": (put("lost/CATKIN_IGNORE", ""), ALL),
    "a package with another name": (replace("gamma/package.xml", "<name>gamma<", "<name>gamna<"), ALL),
    "a second package of one name": (put("copy/beta/package.xml", PACKAGE.format(name="beta")), ALL),
    "a package is removed": (remove("copy"), ALL),
    "a package inside of another": (put("beta/launch/package.xml", PACKAGE.format(name="inner")), ALL),
    "a package that builds for the other ROS": (
        replace("gamma/package.xml", "</package>", "<export><build_type>ament_cmake</build_type></export></package>"), ALL,
    ),
    "a configuration": (put(".launchlint.yaml", "args:\n  speed: ['3']\n"), ALL),
}  # fmt: skip


def test_whatever_changes(workspace: Trusting) -> None:
    workspace.agrees()
    for name, (change, most) in CHANGES.items():
        change(workspace.directory)
        first, again = workspace.agrees()
        assert first[0] <= most, name
        assert again[0] == 0, name
