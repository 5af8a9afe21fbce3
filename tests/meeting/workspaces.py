"""Workspaces for runs that are disturbed, and what is looked at afterwards."""

from __future__ import annotations

from pathlib import Path

from launchlint.check.run import CACHE_PAYS
from tests.cli.running import PACKAGE, write

FILES = CACHE_PAYS + 2
"""Launch files: as many as it takes for results to be kept."""
TALKER = """<launch>
  <arg name="rate" default="10"/>
  <node name="talker" pkg="demo" type="talk.py" outptu="screen">
      <param name="rate" value="$(arg rate)"/>
  </node>
  <include file="$(find demo)/launch/part.launch"/>
</launch>
"""
"""A launch file with a mistake that ``--fix`` mends, and lines that ``format`` moves."""
PART = '<launch>\n  <node name="part" pkg="demo" type="talk.py"/>\n</launch>\n'
SOURCE = """#!/usr/bin/env python3
import rospy
from std_msgs.msg import String
rospy.init_node("talk")
publisher = rospy.Publisher("chatter", String, queue_size=1)
rate = rospy.get_param("~rate", 10)
while not rospy.is_shutdown():
    publisher.publish("a")
"""


def make(directory: Path, files: int = 3) -> Path:
    """Write a repository of one package with that many launch files, and one that they include."""
    launch = {f"demo/launch/entry{number:02}.launch": TALKER for number in range(files)}
    standing = {
        ".git/HEAD": "",
        "demo/package.xml": PACKAGE.format(name="demo"),
        "demo/scripts/talk.py": SOURCE,
        "demo/launch/part.launch": PART,
    }
    write(directory, {**standing, **launch})
    return directory


def content(directory: Path) -> dict[str, bytes]:
    """The files of a repository by name, without what an ended process may leave: temporary files, which no command takes for anything."""
    return {
        str(file.relative_to(directory)): file.read_bytes()
        for file in sorted(directory.rglob("*"))
        if file.is_file() and not (file.name[0] == "." and file.name.endswith(".tmp"))
    }
