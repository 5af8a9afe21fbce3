"""A package of three rospy scripts and no library: what is wrong about names, types and params in its launch files is told."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from tests.cli.running import run, write

MANIFEST = (
    '<package format="2"><name>chat</name><version>1.0.0</version><description>Three scripts.</description>'
    '<maintainer email="a@example.com">A</maintainer><license>MIT</license><buildtool_depend>catkin</buildtool_depend>'
    "<exec_depend>rospy</exec_depend><exec_depend>std_msgs</exec_depend></package>\n"
)
BUILD = (
    "cmake_minimum_required(VERSION 3.0)\nproject(chat)\nfind_package(catkin REQUIRED COMPONENTS rospy std_msgs)\ncatkin_package()\n"
    "catkin_install_python(PROGRAMS scripts/talker.py scripts/listener.py scripts/counter.py\n"
    "  DESTINATION ${CATKIN_PACKAGE_BIN_DESTINATION})\n"
    "install(DIRECTORY launch DESTINATION ${CATKIN_PACKAGE_SHARE_DESTINATION})\n"
)
TALKER = """\
#!/usr/bin/env python3
import rospy
from std_msgs.msg import String

def main():
    rospy.init_node("talker")
    publisher = rospy.Publisher("chatter", String, queue_size=10)
    rate = rospy.Rate(rospy.get_param("~rate", 10.0))
    text = rospy.get_param("~text", "hello")
    while not rospy.is_shutdown():
        publisher.publish(text)
        rate.sleep()

if __name__ == "__main__":
    main()
"""
LISTENER = """\
#!/usr/bin/env python3
import rospy
from std_msgs.msg import String

def heard(message):
    rospy.loginfo(message.data)

rospy.init_node("listener")
rospy.Subscriber("chatter", String, heard)
rospy.spin()
"""
COUNTER = """\
#!/usr/bin/env python3
import rospy
from std_msgs.msg import Int32

class Counter:
    def __init__(self):
        self.step = rospy.get_param("~step", 1)
        self.publisher = rospy.Publisher("total", Int32, queue_size=1)
        rospy.Subscriber("count", Int32, self.counted)

    def counted(self, message):
        self.publisher.publish(message.data * self.step)

rospy.init_node("counter")
Counter()
rospy.spin()
"""


def node(script: str, inside: str = "", name: str = "", more: str = "") -> str:
    return f'<node pkg="chat" type="{script}.py" name="{name or script}"{more}>{inside}</node>\n'


def remap(source: str, target: str) -> str:
    return f'<remap from="{source}" to="{target}"/>'


SPEECH = remap("chatter", "speech")
MISTAKES = {
    "from is misspelt": (node("talker", remap("chater", "speech")) + node("listener", SPEECH), "LL601"),
    "to is misspelt": (node("talker", SPEECH) + node("listener", remap("chatter", "spech")), "LL612"),
    "one of two is remapped": (node("talker", SPEECH) + node("listener"), "LL612"),
    "the other one is remapped": (node("talker") + node("listener", SPEECH), "LL612"),
    "one is in a namespace": (node("talker", more=' ns="robot"') + node("listener"), "LL612"),
    "one is in a group": (f'<group ns="robot">{node("talker")}</group>\n' + node("listener"), "LL612"),
    "the remap comes late": (node("talker") + node("listener") + SPEECH, "LL602"),
    "the name is private": (node("talker", remap("~chatter", "speech")) + node("listener", SPEECH), "LL601"),
    "to and from are exchanged": (node("talker", remap("speech", "chatter")) + node("listener", SPEECH), "LL601"),
    "another type is heard": (node("talker") + node("counter", remap("count", "chatter")), "LL611"),
    "another type is said": (node("listener") + node("counter", remap("total", "chatter")), "LL611"),
    "a param is misspelt": (node("talker", '<param name="rat" value="5"/>') + node("listener"), "LL507"),
    "a program is misspelt": (node("talkr") + node("listener"), "LL304"),
    "a package is misspelt": (node("talker").replace('"chat"', '"chta"') + node("listener"), "LL303"),
    "two have one name": (node("talker") + node("listener", name="talker"), "LL301"),
}
FINE = {
    "as in the code": node("talker") + node("listener"),
    "both remapped": node("talker", SPEECH) + node("listener", SPEECH),
    "params": node("talker", '<param name="rate" value="5"/><param name="text" value="hi"/>') + node("listener"),
    "in one namespace": f'<group ns="robot">{node("talker")}{node("listener")}</group>\n',
    "a part of a whole": node("counter"),
}


@pytest.fixture(scope="module")
def package(tmp_path_factory: pytest.TempPathFactory) -> Path:
    directory = tmp_path_factory.mktemp("scripts")
    write(directory, {"chat/package.xml": MANIFEST, "chat/CMakeLists.txt": BUILD})
    scripts = {"talker": TALKER, "listener": LISTENER, "counter": COUNTER}
    write(directory, {f"chat/scripts/{name}.py": text for name, text in scripts.items()})
    return directory


def told(package: Path, text: str) -> set[str]:
    """The rules of the warnings and errors that a plain check tells of a launch file."""
    write(package, {"chat/launch/a.launch": f"<launch>\n{text}</launch>\n"})
    done = run(package, "check", "--format", "json", "chat/launch/a.launch")
    return {each["rule"] for each in json.loads(done.output)["findings"] if each["severity"] in ("warning", "error")}


@pytest.mark.parametrize(("text", "rule"), MISTAKES.values(), ids=MISTAKES)
def test_a_mistake_is_told(text: str, rule: str, package: Path) -> None:
    assert told(package, text) == {rule}


@pytest.mark.parametrize("text", FINE.values(), ids=FINE)
def test_nothing_is_said_of_what_is_right(text: str, package: Path) -> None:
    assert told(package, text) == set()
