"""A workspace of two packages: scripts that share a module, and a C++ program."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.cli.running import PACKAGE, write

TALKER = """\
#!/usr/bin/env python3
import rospy
from std_msgs.msg import String
from demo.names import TOPIC

rospy.init_node("talker")
publisher = rospy.Publisher(TOPIC, String, queue_size=1)
rospy.spin()
"""
LISTENER = """\
#!/usr/bin/env python3
import rospy
from std_msgs.msg import String

rospy.init_node("listener")
rospy.Subscriber("chatter", String, print)
rospy.spin()
"""
COUNTER = LISTENER.replace("String", "Int32").replace("listener", "counter")
CPP = """\
#include <ros/ros.h>
#include <std_msgs/String.h>
#include "other/name.h"

int main(int argc, char** argv)
{
  ros::init(argc, argv, "other");
  ros::NodeHandle node;
  ros::Publisher publisher = node.advertise<std_msgs::String>(NAME, 1);
  ros::spin();
}
"""
CMAKE = """\
cmake_minimum_required(VERSION 3.0)
project(other)
find_package(catkin REQUIRED)
catkin_package()
add_executable(other_node src/other.cpp)
"""
LAUNCH = """\
<launch>
  <node name="talker" pkg="demo" type="talker.py"/>
  <node name="listener" pkg="demo" type="listener.py"/>
</launch>
"""
FILES = {
    ".git/HEAD": "ref: refs/heads/main\n",
    "demo/package.xml": PACKAGE.format(name="demo"),
    "demo/setup.py": "from catkin_pkg.python_setup import generate_distutils_setup\nd = dict(packages=['demo'], package_dir={'': 'src'})\n",
    "demo/src/demo/__init__.py": "",
    "demo/src/demo/names.py": 'TOPIC = "chatter"\n',
    "demo/scripts/talker.py": TALKER,
    "demo/scripts/listener.py": LISTENER,
    "demo/scripts/counter.py": COUNTER,
    "demo/launch/talk.launch": LAUNCH,
    "other/package.xml": PACKAGE.format(name="other"),
    "other/CMakeLists.txt": CMAKE,
    "other/include/other/name.h": '#define NAME "spoken"\n',
    "other/src/other.cpp": CPP,
}


@pytest.fixture
def workspace(tmp_path: Path) -> Path:
    """The directory of the workspace."""
    directory = tmp_path / "workspace"
    write(directory, FILES)
    return directory
