"""scripts/grow_library.py, on a small library and a small clone."""

from __future__ import annotations

import json
import os
import subprocess
import sys
from pathlib import Path
from typing import Any

import pytest

from tests.library.samples import library, written

ROOT = Path(__file__).resolve().parents[2]
PERSON = "some/where@0123456789ab:node.py:1"
MANIFEST = "<package format='2'><name>{}</name></package>\n"
NODE = """#!/usr/bin/env python3
import rospy
from std_msgs.msg import String

rospy.init_node("node")
rate = rospy.get_param("~rate", 10)
rospy.Publisher("chatter", String, queue_size=1)
if rospy.myargv()[1:]:
    rospy.Subscriber(input(), String, print)
"""


def git(directory: Path, *words: str) -> str:
    identity = ["-c", "user.name=t", "-c", "user.email=t@example.org", "-c", "commit.gpgsign=false", "-c", "init.defaultBranch=main"]
    environment = {**os.environ, "GIT_CONFIG_GLOBAL": "/dev/null", "GIT_CONFIG_NOSYSTEM": "1"}
    done = subprocess.run(["git", "-C", str(directory), *identity, *words], capture_output=True, text=True, env=environment, check=True)
    return done.stdout.strip()


class Place:
    """A library of one described program, a clone with two packages, and a list that names it."""

    def __init__(self, directory: Path) -> None:
        self.directory = directory
        self.bundled = directory / "bundled"
        self.bundled.mkdir()
        described = {"publishers": [{"name": "out", "type": "std_msgs/String", "evidence": [{"by": "manual", "at": PERSON}]}]}
        source = {"id": "some/where@0123456789ab", "url": "https://github.com/some/where", "commit": "0123456789ab" + 28 * "0"}
        document = {**library(robot={"executables": {"described": self.program(described)}}), "sources": [source]}
        written(self.bundled / "robot.json", document)
        clone = directory / "clones" / "team" / "robots"
        for package, names in (("robot", ("described", "node", "test_node")), ("secret_package", ("node",)), ("turtlesim", ("node",))):
            (clone / package / "scripts").mkdir(parents=True)
            (clone / package / "package.xml").write_text(f"<package format='2'><name>{package}</name></package>\n")
            for name in names:
                (clone / package / "scripts" / name).write_text(NODE)
                (clone / package / "scripts" / name).chmod(0o755)
        git(clone, "init", "--quiet")
        git(clone, "add", "-A")
        git(clone, "commit", "--quiet", "-m", "all")
        self.commit = git(clone, "rev-parse", "HEAD")
        (directory / "list.yaml").write_text(f"team/robots: {{commit: {self.commit}, packages: [robot]}}\n")

    def clone(self, name: str, files: dict[str, str]) -> str:
        """Another clone; the commit in it."""
        clone = self.directory / "clones" / name
        for path, text in files.items():
            (clone / path).parent.mkdir(parents=True, exist_ok=True)
            (clone / path).write_text(text)
            (clone / path).chmod(0o755 if text.startswith("#!") else 0o644)
        git(clone, "init", "--quiet")
        git(clone, "add", "-A")
        git(clone, "commit", "--quiet", "-m", "all")
        return git(clone, "rev-parse", "HEAD")

    @staticmethod
    def program(interface: dict[str, Any]) -> dict[str, Any]:
        return {"class": "rospy", "variants": {"default": interface}}

    def grow(self, *words: str) -> tuple[int, str]:
        command = [sys.executable, str(ROOT / "scripts" / "grow_library.py"), "--list", "list.yaml", "--directory", "bundled", *words]
        done = subprocess.run(
            command, cwd=self.directory, capture_output=True, text=True, check=False, env={**os.environ, "PYTHONPATH": str(ROOT)}
        )
        assert done.stderr == ""
        return done.returncode, done.stdout

    def known(self, package: str) -> dict[str, Any]:
        document: dict[str, Any] = json.loads((self.bundled / f"{package}.json").read_text())
        return document

    def files_of_ros1(self) -> list[str]:
        return [path.name for path in self.bundled.glob("*.json")]

    def files(self) -> dict[str, str]:
        return {path.name: path.read_text() for path in sorted(self.bundled.iterdir())}


@pytest.fixture
def place(tmp_path: Path) -> Place:
    return Place(tmp_path)


def test_source_code_adds_programs_that_nobody_has_described(place: Place) -> None:
    before = place.known("robot")["packages"]["robot"]["executables"]["described"]
    assert place.grow("--checkouts", "clones") == (
        0,
        "team/robots: 3 programs\nbundled: changed 2 files\nbundled: wrote 1 of 3 files\n",
    )
    assert sorted(place.files()) == ["index.json", "robot.json", "turtlesim.json"]
    document = place.known("robot")
    where = f"team/robots@{place.commit[:12]}"
    assert document["sources"] == [
        {"id": "some/where@0123456789ab", "url": "https://github.com/some/where", "commit": "0123456789ab" + 28 * "0"},
        {"id": where, "url": "https://github.com/team/robots", "commit": place.commit},
    ]

    def read(name: str) -> dict[str, Any]:
        return place.program(
            {
                "publishers": [
                    {
                        "name": "chatter",
                        "type": "std_msgs/String",
                        "queue": 1,
                        "evidence": [{"by": "static", "at": f"{where}:robot/scripts/{name}:7"}],
                    }
                ],
                "params": [{"name": "~rate", "default": 10, "evidence": [{"by": "static", "at": f"{where}:robot/scripts/{name}:6"}]}],
                "subscribers": [
                    {
                        "name": "{any}",
                        "type": "std_msgs/String",
                        "condition": {"text": "a condition in the source"},
                        "evidence": [{"by": "static", "at": f"{where}:robot/scripts/{name}:9"}],
                    }
                ],
                "open": {"params": "read from source code by a program, which may miss some"},
            }
        )

    assert document["packages"]["robot"]["executables"] == {
        "described": before,
        **{name: read(name) for name in ("node", "test_node")},
    }


def test_the_same_list_gives_the_same_files_and_an_empty_one_takes_all_away(place: Place) -> None:
    place.grow("--checkouts", "clones")
    first = place.files()
    assert place.grow("--checkouts", "clones")[1].splitlines()[1] == "bundled: changed 0 files"
    assert place.files() == first
    assert place.grow("--no-sources")[1].splitlines()[0] == "bundled: changed 0 files"
    (place.directory / "list.yaml").write_text("{}")
    place.grow("--checkouts", "clones")
    assert sorted(place.files()) == ["index.json", "robot.json"]
    assert list(place.known("robot")["packages"]["robot"]["executables"]) == ["described"]
    assert [source["id"] for source in place.known("robot")["sources"]] == ["some/where@0123456789ab"]


def test_repositories_are_read_beside_those_that_they_use(place: Place) -> None:
    module = "import rospy\nfrom std_msgs.msg import String\n\n\ndef start():\n    rospy.Publisher('shared', String, queue_size=1)\n"
    commit = place.clone(
        "team/shared",
        {"shared/package.xml": MANIFEST.format("shared"), "shared/src/shared/__init__.py": "", "shared/src/shared/talk.py": module},
    )
    using = place.clone(
        "team/using",
        {
            "robot/package.xml": MANIFEST.format("robot").replace("</package>", "<exec_depend>shared</exec_depend></package>"),
            "robot/scripts/talker": "#!/usr/bin/env python3\nfrom shared.talk import start\n\nstart()\n",
            "shared/package.xml": MANIFEST.format("shared_too"),
        },
    )
    listed = f"team/using: {{commit: {using}, packages: [robot], beside: [team/shared]}}\nteam/shared: {{commit: {commit}}}\n"
    (place.directory / "list.yaml").write_text(listed)
    for words in (("--jobs", "1"), ("--jobs", "2"), ("--only", "team/shared"), ("--only", "team/using")):
        assert "team/using: 1 programs\n" in place.grow("--checkouts", "clones", *words)[1]
        known = place.known("robot")
        assert known["packages"]["robot"]["executables"]["talker"]["variants"]["default"]["publishers"] == [
            {
                "name": "shared",
                "type": "std_msgs/String",
                "queue": 1,
                "evidence": [{"by": "static", "at": f"team/shared@{commit[:12]}:shared/src/shared/talk.py:6"}],
            }
        ]
        assert [source["id"] for source in known["sources"]] == ["some/where@0123456789ab", f"team/shared@{commit[:12]}"]
    (place.directory / "list.yaml").write_text(listed.partition("\n")[0])
    with pytest.raises(AssertionError, match="team/using is read beside team/shared, which is not in the list"):
        place.grow("--checkouts", "clones")


@pytest.mark.parametrize("words", [(), ("--only", "team/two")])
def test_an_earlier_version_adds_what_the_later_one_lacks(place: Place, words: tuple[str, ...]) -> None:
    """The package has no manifest where its build script makes one."""
    hears = "#!/usr/bin/env python3\nimport rospy\nfrom std_msgs.msg import String\n\nrospy.Subscriber('{}', String)\n"
    files = {"two/package_ros1.xml": MANIFEST.format("two"), "two/scripts/old": hears.format("a"), "two/scripts/both": hears.format("a")}
    first = place.clone("team/two", files)
    git(place.directory / "clones/team/two", "rm", "--quiet", "two/scripts/old")
    second = place.clone("team/two", {"two/scripts/both": hears.format("b")})
    line = "{}: {{commit: {}, packages: [two], manifest: two/package_ros1.xml}}\n"
    (place.directory / "list.yaml").write_text(line.format("team/two", second) + line.format("team/two@first", first))
    place.grow("--checkouts", "clones")
    _, told = place.grow("--checkouts", "clones", *words)
    assert told.splitlines()[:2] == ["team/two: 1 programs", "team/two: 1 programs"]
    known = place.known("two")
    heard = {
        name: [(each["name"], each["evidence"][0]["at"][:21]) for each in program["variants"]["default"]["subscribers"]]
        for name, program in known["packages"]["two"]["executables"].items()
    }
    assert heard == {"both": [("b", f"team/two@{second[:12]}")], "old": [("a", f"team/two@{first[:12]}")]}
    assert {source["id"] for source in known["sources"]} == {f"team/two@{each[:12]}" for each in (first, second)}


def test_a_call_that_was_not_followed_leaves_the_program_open(place: Place) -> None:
    node = NODE.partition("if rospy")[0] + "# rospy.Service('no', String)\n\n\ndef never():\n    rospy.Subscriber('~late', String, print)\n"
    commit = place.clone("team/late", {"robot/package.xml": MANIFEST.format("robot"), "robot/scripts/late": node})
    (place.directory / "list.yaml").write_text(f"team/late: {{commit: {commit}, packages: [robot]}}\n")
    place.grow("--checkouts", "clones")
    variant = place.known("robot")["packages"]["robot"]["executables"]["late"]["variants"]["default"]
    assert [entry["name"] for entry in variant["publishers"]] == ["chatter"]
    assert variant["open"] == {
        "subscribers": "a call that was not followed (robot/scripts/late:12)",
        "params": "read from source code by a program, which may miss some",
    }


def test_a_probe_confirms_what_is_described_and_says_what_is_missing(place: Place) -> None:
    seen = [{"by": "dynamic", "run": "debian"}]
    md5 = "992ce8a1687cec8c8bd883ec73ca41d1"
    interface = {
        "publishers": [
            {"name": "out", "type": "std_msgs/String", "md5": md5, "evidence": seen},
            {"name": "more", "type": "std_msgs/String", "evidence": seen},
        ],
        "open": {"clients": "why"},
    }
    other = {"publishers": [{"name": "x", "evidence": seen}]}
    programs = {"described": place.program(interface), "other": place.program(other), "broken": {"class": "rospy", "status": "failed"}}
    written(place.directory / "probed.json", library(robot={"version": "1.2.3", "executables": programs}))
    assert place.grow("--no-sources", "--probed", "probed.json") == (
        0,
        (
            "probed.json: 2 programs\n"
            "  seen, but not described: robot: described: publishers: more std_msgs/String\n"
            "bundled: changed 1 files\n"
            "bundled: wrote 1 of 2 files\n"
        ),
    )
    run = [{"by": "dynamic", "run": "debian, robot 1.2.3"}]
    assert place.known("robot")["packages"]["robot"]["executables"] == {
        "described": place.program(
            {"publishers": [{"name": "out", "type": "std_msgs/String", "md5": md5, "evidence": [{"by": "manual", "at": PERSON}, *run]}]}
        ),
        "other": place.program({"publishers": [{"name": "x", "evidence": run}]}),
    }
    first = place.files()
    place.grow("--no-sources", "--probed", "probed.json")
    assert place.files() == first


def test_a_commit_that_is_not_there(place: Place) -> None:
    (place.directory / "list.yaml").write_text(f"team/robots: {{commit: {40 * '0'}}}\n")
    command = [
        sys.executable,
        str(ROOT / "scripts" / "grow_library.py"),
        "--list",
        "list.yaml",
        "--directory",
        "bundled",
        "--checkouts",
        "clones",
    ]
    done = subprocess.run(
        command, cwd=place.directory, capture_output=True, text=True, check=False, env={**os.environ, "PYTHONPATH": str(ROOT)}
    )
    assert (done.returncode, done.stderr) == (2, f"grow_library: clones/team/robots: there is no commit {40 * '0'}\n")


NODE_2 = """#!/usr/bin/env python3
import rclpy
from std_msgs.msg import String

rclpy.init()
node = rclpy.create_node("talker")
node.declare_parameter("rate", 10)
publisher = node.create_publisher(String, "chatter", 5)
rclpy.spin(node)
"""
MANIFEST_2 = "<package format='3'><name>{}</name><export><build_type>ament_cmake</build_type></export></package>\n"
CMAKE_2 = """project({})
find_package(ament_cmake REQUIRED)
install(PROGRAMS scripts/talker.py test/checker.py DESTINATION lib/${{PROJECT_NAME}})
ament_package()
"""


def test_packages_of_ros2_are_put_on_a_shelf_of_their_own(place: Place) -> None:
    """All packages of the list's repositories but those of ROS 1, and no program that only tests start."""
    name = "turtlesim"
    commit = place.clone(
        "team/robots2",
        {
            f"{name}/package.xml": MANIFEST_2.format(name),
            f"{name}/CMakeLists.txt": CMAKE_2.format(name),
            f"{name}/scripts/talker.py": NODE_2,
            f"{name}/test/checker.py": NODE_2,
            "old/package.xml": MANIFEST.format("old"),
            "old/node.py": NODE,
        },
    )
    (place.directory / "list.yaml").write_text(f"team/robots2: {{commit: {commit}}}\n")
    (place.bundled / "ros2").mkdir()
    before = set(place.files_of_ros1())
    status, output = place.grow("--ros2", "--checkouts", "clones")
    assert (status, output.splitlines()[0]) == (0, "team/robots2: 1 programs")
    assert set(place.files_of_ros1()) == before | {"index.json"}
    assert sorted(path.name for path in (place.bundled / "ros2").iterdir()) == ["index.json", f"{name}.json"]
    document = json.loads((place.bundled / "ros2" / f"{name}.json").read_text())
    package = document["packages"][name]
    assert (document["version"], package["middleware"], list(package["executables"])) == (2, "ros2", ["talker.py"])
    variant = package["executables"]["talker.py"]["variants"]["default"]
    (publisher,), (param,) = variant["publishers"], variant["params"]
    assert (publisher["name"], publisher["type"], publisher["qos"]["depth"], variant["node"]) == (
        "chatter",
        "std_msgs/msg/String",
        5,
        "talker",
    )
    assert (param["name"], param["type"], param["default"]) == ("~rate", "integer", 10)
    assert publisher["evidence"] == [{"by": "static", "at": f"team/robots2@{commit[:12]}:{name}/scripts/talker.py:8"}]
