"""A repository with many launch files that lean on each other: includes, circles, args, parameter files, names that clash."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

from tests.cli.running import PACKAGE, run_program, write

COUNTED = """
import sys
from launchlint.check.entry import EntryChecker
from launchlint.cli import main

real, count = EntryChecker.check, 0

def check(self, request):
    global count
    count += 1
    return real(self, request)

EntryChecker.check = check
main(["check", "-q", "--jobs", "1", *sys.argv[1:]], standalone_mode=False)
print(count)
"""


def computed(directory: Path, *words: str, cache: Path) -> int:
    """How many entry files of a repository are computed anew in one run with the cache."""
    ran = run_program(directory, COUNTED, *words, cache=cache)
    assert (ran.status, ran.errors) == (0, "")
    return int(ran.output)


def many(directory: Path, count: int = 120) -> Path:
    """Write it; the same for the same ``count``."""
    write(directory, dict(_files(count)))
    return directory


def _files(count: int) -> Iterator[tuple[str, str]]:
    yield ".git/HEAD", ""
    for package in ("arm", "base"):
        yield f"{package}/package.xml", PACKAGE.format(name=package)
        yield f"{package}/CMakeLists.txt", "project(x)\nfind_package(catkin REQUIRED)\ncatkin_package()\nadd_executable(drive drive.cpp)\n"
        yield f"{package}/scripts/talk.py", "#!/usr/bin/env python3\n"
        yield f"{package}/config/wheel.yaml", "radius: 0.1\nname: wheel\nradius: 0.2\n"
        yield f"{package}/launch/part.launch", PART
        yield f"{package}/launch/ring_a.launch", '<launch><include file="$(dirname)/ring_b.launch"/></launch>\n'
        yield f"{package}/launch/ring_b.launch", '<launch><include file="$(dirname)/ring_a.launch"/></launch>\n'
    for number in range(count):
        package = ("arm", "base")[number % 2]
        yield (
            f"{package}/launch/entry{number:03}.launch",
            ENTRY.format(
                package=package,
                number=number,
                turn=number % 3,
                missing="" if number % 7 else '<include file="$(find arm)/launch/prt.launch"/>',
            ),
        )


PART = """\
<launch>
  <arg name="robot"/>
  <arg name="unused" default="1"/>
  <group ns="$(arg robot)">
    <rosparam file="$(dirname)/../config/wheel.yaml"/>
    <node name="drive" pkg="arm" type="drive"/>
    <node name="talk" pkg="base" type="talk.py" output="$(env TALK_OUTPUT)"/>
    <remap from="x" to="y"/>
  </group>
</launch>
"""
ENTRY = """\
<launch>
  <arg name="sim" default="false"/>
  <!-- launchlint: ignore[LL206] not yet -->
  <arg name="later" default="{number}"/>
  <include file="$(find {package})/launch/part.launch">
    <arg name="robot" value="robot{turn}"/>
  </include>
  {missing}
  <group if="$(arg sim)">
    <include file="$(find base)/launch/part.launch" pass_all_args="true">
      <arg name="robot" value="robot{number}"/>
    </include>
    <node name="twice" pkg="arm" type="drve"/>
    <node name="twice" pkg="armm" type="drive"/>
    <include file="$(dirname)/ring_a.launch"/>
  </group>
  <param name="p" value="$(arg nothing{turn})"/>
</launch>
"""
