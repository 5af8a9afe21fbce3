"""``launchlint extract`` as a user runs it."""

from __future__ import annotations

import json
from pathlib import Path

from tests.cli.running import PACKAGE, run, write

TALKER = (
    "#!/usr/bin/env python3\nimport sys\nimport rospy\nfrom std_msgs.msg import String\n"
    "rospy.Publisher('chatter', String, queue_size=1)\nrospy.Publisher(sys.argv[1], String)\nrospy.Subscriber(input(), String)\n"
)
LIBRARY = """\
   "executables": {
    "talker.py": {
     "class": "rospy",
     "variants": {
      "default": {
       "publishers": [
        {"name": "chatter", "type": "std_msgs/String", "queue": 1, "evidence": [{"by": "static", "at": "repository:src/demo/talker.py:5"}]},
        {"name": "{arg:1}", "type": "std_msgs/String", "evidence": [{"by": "static", "at": "repository:src/demo/talker.py:6"}]}
       ],
       "subscribers": [
        {"name": "{any}", "type": "std_msgs/String", "evidence": [{"by": "static", "at": "repository:src/demo/talker.py:7"}]}
       ],
       "literals": ["chatter"]
"""


def workspace(repository: Path) -> None:
    files = {"src/demo/package.xml": PACKAGE.format(name="demo"), "src/demo/talker.py": TALKER, "src/demo/run.sh": "#!/bin/sh\n"}
    write(repository, files)
    for name in ("talker.py", "run.sh"):
        (repository / "src" / "demo" / name).chmod(0o755)


def test_a_library_that_the_other_commands_take(repository: Path) -> None:
    workspace(repository)
    ran = run(repository, "extract", "src", "-o", "demo.json")
    assert (ran.status, ran.output) == (0, "")
    assert ran.errors == (
        "1 program, 2 names, 1 not known as a whole\n1 program not read:\n  demo/run.sh (src/demo/run.sh): it is a script, but not Python\n"
    )
    assert LIBRARY in (repository / "demo.json").read_text(encoding="utf-8")
    assert run(repository, "library", "validate", "demo.json").output == "demo.json: ok: 1 package, 1 executable, 0 nodelet classes\n"
    assert "{arg:1}" in run(repository, "library", "show", "--no-bundled", "--library", "demo.json", "demo/talker.py").output


def test_programs_that_cannot_be_read_are_named_by_reason(repository: Path) -> None:
    workspace(repository)
    (repository / "src" / "demo" / "also.sh").write_text("#!/bin/sh\n")
    (repository / "src" / "demo" / "also.sh").chmod(0o755)
    assert run(repository, "extract", "src", "-o", "demo.json").errors == (
        "1 program, 2 names, 1 not known as a whole\n"
        "2 programs not read:\n"
        "  demo/also.sh (src/demo/also.sh), demo/run.sh (src/demo/run.sh): it is a script, but not Python\n"
    )


def test_standard_output_and_quiet(repository: Path) -> None:
    workspace(repository)
    ran = run(repository, "extract", "--quiet", "--package", "demo", "src")
    assert (ran.status, ran.errors) == (0, "")
    assert list(json.loads(ran.output)["packages"]) == ["demo"]
    assert run(repository, "extract", "-q", "src").output == ran.output


def test_what_cannot_be_done(repository: Path) -> None:
    workspace(repository)
    nowhere = "cannot write the library to 'no/where.json': the directory 'no' does not exist; create it first"
    for words, message in (
        (["extract", "missing"], "cannot read sources from 'missing': it does not exist"),
        (["extract", "src", "--package", "dmeo"], "--package dmeo: there is no such package in these sources; did you mean demo?"),
        (["extract", "src", "-o", "no/where.json"], nowhere),
    ):
        ran = run(repository, *words)
        assert (ran.status, ran.output, ran.errors) == (2, "", f"launchlint: {message}\n")


NODE = """\
import rclpy
from rclpy.node import Node
from std_msgs.msg import String


class Talker(Node):
    def __init__(self):
        super().__init__('talker')
        self.declare_parameter('topic', 'chatter')
        self.create_publisher(String, self.get_parameter('topic').value, rclpy.qos.qos_profile_sensor_data)


def main():
    rclpy.init()
    rclpy.spin(Talker())


def nothing():
    rclpy.init()
"""
SPOKEN = """\
    "talker": {
     "class": "rclpy",
     "variants": {
      "default": {
       "node": "talker",
       "publishers": [
        {"name": "{param:~topic|chatter}", "type": "std_msgs/msg/String", "qos": {"reliability": "best_effort", "durability": "volatile", \
"history": "keep_last", "depth": 5}, "evidence": [{"by": "static", "at": "repository:demo/demo/node.py:10"}]}
       ],
       "params": [
        {"name": "~topic", "type": "string", "declared": true, "default": "chatter", \
"evidence": [{"by": "static", "at": "repository:demo/demo/node.py:9"}]}
       ]
"""


def test_programs_of_ros2_and_what_was_not_understood(repository: Path) -> None:
    manifest = PACKAGE.format(name="demo").replace("</package>", "<export><build_type>ament_python</build_type></export></package>")
    points = "['talker = demo.node:main', 'empty = demo.node:nothing']"
    setup = f"from setuptools import setup\nsetup(packages=['demo'], entry_points={{'console_scripts': {points}}})"
    write(repository, {"demo/package.xml": manifest, "demo/setup.py": setup, "demo/demo/__init__.py": "", "demo/demo/node.py": NODE})
    ran = run(repository, "extract", "demo", "-o", "demo.json")
    assert ran.errors == "2 programs, 2 names, 0 not known as a whole; 1 program may have more\n"
    text = (repository / "demo.json").read_text(encoding="utf-8")
    assert SPOKEN in text
    library = json.loads(text)
    assert (library["version"], library["packages"]["demo"]["middleware"]) == (2, "ros2")
    opened = library["packages"]["demo"]["executables"]["empty"]["variants"]["default"]["open"]
    assert set(opened.values()) == {"it uses rclpy, and no node of it was found (demo/demo/node.py:1)"}
    assert run(repository, "library", "validate", "demo.json").status == 0


def test_a_setup_that_is_not_understood_is_told(repository: Path) -> None:
    manifest = PACKAGE.format(name="demo").replace("</package>", "<export><build_type>ament_python</build_type></export></package>")
    write(repository, {"demo/package.xml": manifest, "demo/setup.py": "import somebody\nsomebody.install()\n"})
    assert run(repository, "extract", "demo", "-o", "demo.json").errors == (
        "0 programs, 0 names, 0 not known as a whole\n1 program not read:\n"
        "  demo (demo): it may have more programs: setup.py cannot be followed to a call of setup()\n"
    )
