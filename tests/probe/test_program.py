"""The program that runs beside the nodes: old Pythons can read it, it needs nothing but itself, and its parts do what they say."""

from __future__ import annotations

import ast
import json
import subprocess
import sys
import time
from pathlib import Path
from typing import Any

import pytest

PROBE = Path(__file__).resolve().parent.parent.parent / "probe"
FILES = sorted(PROBE.rglob("*.py"))

COMPARE_SUMS = """
import glob, json, os, sys
sys.path.insert(0, sys.argv[1])
from launchlint_probe.messages import Definitions
import roslib.message
modules = "/usr/lib/python3/dist-packages"
definitions = Definitions({}, [modules])
found = {}
for path in sorted(glob.glob(modules + "/*/msg/_*.py")):
    name = os.path.basename(path)[1:-3]
    if not name.startswith("_"):
        kind = path.split("/")[-3] + "/" + name
        known = roslib.message.get_message_class(kind)
        if known is not None:
            found[kind] = [known._md5sum, definitions.md5(kind)]
print(json.dumps(found))
"""


@pytest.mark.parametrize("path", FILES, ids=lambda path: path.relative_to(PROBE).as_posix())
def test_python_3_6_can_read_it(path: Path) -> None:
    tree = ast.parse(path.read_text(encoding="utf-8"), feature_version=(3, 6))
    newer = [node.lineno for node in ast.walk(tree) if isinstance(node, ast.NamedExpr | ast.Match)]
    assert newer == []
    words = {"capture_output", "text"} & {keyword.arg for node in ast.walk(tree) if isinstance(node, ast.Call) for keyword in node.keywords}
    assert words == set(), "subprocess of Python 3.6 does not know these"
    assert not any(isinstance(node, ast.ImportFrom) and node.module == "__future__" for node in ast.walk(tree)), (
        "3.6 has no postponed annotations"
    )


@pytest.mark.parametrize("path", FILES, ids=lambda path: path.relative_to(PROBE).as_posix())
def test_it_needs_the_standard_library_only(path: Path) -> None:
    found = set()
    for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
        if isinstance(node, ast.Import):
            found |= {alias.name.split(".")[0] for alias in node.names}
        elif isinstance(node, ast.ImportFrom):
            found.add((node.module or "").split(".")[0])
    assert found - set(sys.stdlib_module_names) <= {"launchlint_probe"}


@pytest.mark.parametrize("name", ["setup/ros.sh", "setup/enter.sh", "setup/compile.sh"])
def test_shell_can_read_it(name: str) -> None:
    assert subprocess.run(["sh", "-n", str(PROBE / name)], capture_output=True, check=False).stderr == b""


def load(name: str) -> Any:
    """A module of the program, or of its setup, as the container sees it."""
    import importlib
    import importlib.util

    if name.startswith("setup/"):
        spec = importlib.util.spec_from_file_location(f"probe_{Path(name).stem}", PROBE / f"{name}.py")
        assert spec is not None
        assert spec.loader is not None
        module = importlib.util.module_from_spec(spec)
        spec.loader.exec_module(module)
        return module
    sys.path.insert(0, str(PROBE))
    try:
        return importlib.import_module(f"launchlint_probe.{name}")
    finally:
        sys.path.remove(str(PROBE))


def test_sums_of_messages(tmp_path: Path) -> None:
    messages = load("messages")
    folder = tmp_path / "demo" / "msg"
    folder.mkdir(parents=True)
    (folder / "Reading.msg").write_text("# text\nuint8 COLD=0\nHeader header\nfloat64 value  # in degrees\nstring[] notes\n")
    (folder / "Loop.msg").write_text("Loop self\n")
    (folder / "Lacks.msg").write_text("other/Thing x\n")
    (folder / "Odd.msg").write_text("three words here\n")
    (folder / "Words.msg").write_text('string A="# kept" # all of it\nint32   B = 3   # cut\n')
    std = tmp_path / "std_msgs" / "msg"
    std.mkdir(parents=True)
    (std / "Header.msg").write_text("uint32 seq\ntime stamp\nstring frame_id\n")
    definitions = messages.Definitions({"demo": [str(tmp_path / "demo")], "std_msgs": [str(tmp_path / "std_msgs")]}, [])
    assert definitions.md5("std_msgs/Header") == "2176decaecbce78abc3b96ef049fabed"
    assert definitions.md5("demo/Reading") == "68d16538d80a70e69e20338c58a09ca5"
    assert definitions.text("demo/Words") == 'string A="# kept" # all of it\nint32 B = 3'
    assert [definitions.md5(f"demo/{name}") for name in ("Loop", "Lacks", "Odd", "Nowhere", "../../x")] == [None] * 5


@pytest.mark.ros
def test_sums_of_messages_are_those_of_genpy(ros_python: str) -> None:
    done = subprocess.run([ros_python, "-c", COMPARE_SUMS, str(PROBE)], capture_output=True, text=True, timeout=120, check=True)
    found = json.loads(done.stdout)
    assert "std_msgs/Header" in found
    assert {kind: sums for kind, sums in found.items() if sums[0] != sums[1]} == {}


COMPARE_VALUES = """
import glob, io, json, os, sys
sys.path.insert(0, sys.argv[1])
from launchlint_probe.messages import SENSIBLE, Definitions
import roslib.message
modules = "/usr/lib/python3/dist-packages"
definitions = Definitions({}, [modules])
wrong, count = [], 0
def look(kind, folder):
    known = roslib.message.get_message_class(kind) if folder == "msg" else roslib.message.get_service_class(kind)
    if known is None:
        return
    if folder == "msg":
        value = definitions.empty(kind)
        good = value is not None and known().deserialize(value) is not None
    else:
        value = definitions.empty_answer(kind)
        good = value is not None and known._response_class().deserialize(value) is not None
        twin = definitions.service_of(known._md5sum)
        good = good and definitions.service_md5(kind) == known._md5sum and definitions.service_md5(twin) == known._md5sum
    written = io.BytesIO()
    if good:
        again = (known() if folder == "msg" else known._response_class()).deserialize(value)
        again.serialize(written)
    if not good or written.getvalue() != value:
        wrong.append(kind)
for folder in ("msg", "srv"):
    for path in sorted(glob.glob(modules + "/*/" + folder + "/_*.py")):
        name = os.path.basename(path)[1:-3]
        if not name.startswith("_"):
            count += 1
            look(path.split("/")[-3] + "/" + name, folder)
print(json.dumps([count, wrong, sorted(set(SENSIBLE) - {kind for kind in SENSIBLE if definitions.md5(kind) == SENSIBLE[kind][0]})]))
"""


@pytest.mark.ros
def test_empty_values_are_what_genpy_reads(ros_python: str) -> None:
    done = subprocess.run([ros_python, "-c", COMPARE_VALUES, str(PROBE)], capture_output=True, text=True, timeout=120, check=True)
    count, wrong, unknown = json.loads(done.stdout)
    assert count > 100
    assert (wrong, unknown) == ([], [])


def test_empty_values(tmp_path: Path) -> None:
    folder = tmp_path / "demo"
    for name, text in (
        ("msg/Pair.msg", "uint8 A=1\nint16 one\nfloat64[3] three\n"),
        ("msg/All.msg", "Pair[2] pairs\nPair[] more\nstring name\ntime stamp\nbool good\n"),
        ("msg/Huge.msg", "float64[999999999] x\n"),
        ("msg/Longer.msg", "float64[99999999999999999999] x\n"),
        ("msg/Lacks.msg", "other/Thing x\n"),
        ("msg/Loop.msg", "Loop x\n"),
        ("srv/Ask.srv", "Pair pair\n---\nint8 code\nstring[] names\n"),
        ("srv/Odd.srv", "int8 only\n"),
    ):
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
        (folder / name).write_text(text)
    definitions = load("messages").Definitions({"demo": [str(folder)]}, [])
    assert definitions.empty("demo/Pair") == bytes(26)
    assert definitions.empty("demo/All") == bytes(2 * 26 + 4 + 4 + 8 + 1)
    assert [definitions.empty(f"demo/{name}") for name in ("Huge", "Longer", "Lacks", "Loop", "Nothing", "../x")] == [None] * 6
    assert definitions.empty_answer("demo/Ask") == bytes(5)
    assert definitions.empty_answer("demo/Odd") is None
    assert definitions.service_of(definitions.service_md5("demo/Ask")) == "demo/Ask"
    assert definitions.service_of("0" * 32) is None


def test_names_that_hold_the_machine_or_the_day() -> None:
    changing = load("changing")
    day = time.strptime("2026-11-22", "%Y-%m-%d")
    names = ["/rover-7/scan", "log_20261122", "run_2026_11_22/state", "rover/scan", "cell_2026"]
    found = changing.steady({"publishers": [{"name": name} for name in names]}, "rover-7", day)
    assert [entry["name"] for entry in found["publishers"]] == ["/{any}/scan", "log_{any}", "run_{any}/state", "rover/scan", "cell_2026"]


def test_what_one_run_has_alone_is_kept_and_told() -> None:
    one = {"publishers": [{"name": "a"}, {"name": "item_1"}, {"name": "item_2"}], "params": [{"name": "~x"}]}
    other = {"publishers": [{"name": "a"}, {"name": "item_8"}, {"name": "b", "type": "std_msgs/String"}], "params": [{"name": "rate"}]}
    found, alone = load("changing").common(one, other)
    assert [entry["name"] for entry in found["publishers"]] == ["a", "b", "item_2", "item_{any}"]
    assert [entry["name"] for entry in found["params"]] == ["rate", "~x"]
    assert alone == ["item_2", "b"]


@pytest.mark.parametrize(
    ("one", "other", "merged"),
    [
        ("session_123/status", "session_9/status", "session_{any}/status"),
        ("/worker_4711", "/worker_4712", "/worker_{any}"),
        ("~id_a1b2", "~id_c3d4", "~id_{any}"),
        ("a_1_b_2_c", "a_3_b_4_c", "a_{any}_c"),
        ("one", "two", "one"),
        ("{node}_12", "{node}_34", "{node}_{any}"),
    ],
)
def test_names_that_change(one: str, other: str, merged: str) -> None:
    assert load("changing").merged_name(one, other) == merged


@pytest.mark.parametrize(
    ("name", "distro", "packages"),
    [
        ("std_msgs", "", ["libstd-msgs-dev", "python3-std-msgs", "ros-std-msgs"]),
        ("roscpp", "", ["libroscpp-dev"]),
        ("nodelet", "", ["libnodelet-dev", "libnodeletlib-tools"]),
        ("eigen", "", ["libeigen3-dev"]),
        ("python-numpy", "", ["python3-numpy"]),
        ("libsdl-dev", "", ["libsdl-dev"]),
        ("nowhere", "", []),
        ("std_msgs", "noetic", ["ros-noetic-std-msgs"]),
        ("python3-numpy", "noetic", ["python3-numpy"]),
        ("only_debian", "noetic", []),
    ],
)
def test_dependencies(name: str, distro: str, packages: list[str]) -> None:
    known = {
        *("libstd-msgs-dev", "python3-std-msgs", "ros-std-msgs", "libroscpp-dev", "libnodelet-dev", "libnodeletlib-tools"),
        *("libeigen3-dev", "python3-numpy", "libsdl-dev", "ros-noetic-std-msgs"),
    }
    assert load("setup/dependencies").packages_for(name, known, distro) == packages


def test_manifests_say_what_is_needed(tmp_path: Path) -> None:
    for name, needs in (("a", ("b", "roscpp", "roslint", "--evil", "x;id")), ("b", ("roscpp",))):
        (tmp_path / name).mkdir()
        tags = "".join(f"<depend>{need}</depend>" for need in needs)
        (tmp_path / name / "package.xml").write_text(f"<package><name>{name}</name>{tags}<test_depend>gtest</test_depend></package>")
    (tmp_path / "broken").mkdir()
    (tmp_path / "broken" / "package.xml").write_text("<package>")
    assert load("setup/dependencies").needed(str(tmp_path)) == {"roscpp": ["a", "b"]}


def test_packages_are_built_behind_those_they_need(tmp_path: Path) -> None:
    build = load("setup/build")
    for name, needs in (("a", ["c"]), ("b", ["a"]), ("c", []), ("x", ["y"]), ("y", ["x"])):
        (tmp_path / name).mkdir()
        tags = "".join(f"<depend>{need}</depend>" for need in needs)
        (tmp_path / name / "package.xml").write_text(f"<package><name>{name}</name>{tags}</package>")
    (tmp_path / "left_out").mkdir()
    (tmp_path / "left_out" / "CATKIN_IGNORE").touch()
    (tmp_path / "left_out" / "package.xml").write_text("<package><name>left_out</name></package>")
    assert build.ordered(build.packages(str(tmp_path))) == ["c", "a", "b", "x", "y"]


HOSTILE_NAMES = ("../../evil", "-rf", "a;id", "$(id)", "a b", "/abs", "\u202egnorw", "")


def test_packages_with_hostile_names_are_not_built_and_not_looked_into(tmp_path: Path) -> None:
    for number, name in enumerate((*HOSTILE_NAMES, "good")):
        (tmp_path / "src" / str(number)).mkdir(parents=True)
        (tmp_path / "src" / str(number) / "package.xml").write_text(f"<package><name>{name}</name></package>")
    assert list(load("setup/build").packages(str(tmp_path / "src"))) == ["good"]
    assert sorted(load("discover").see([], [str(tmp_path / "src")]).programs) == ["good"]


def test_programs_and_nodelets_with_hostile_names_are_not_run(tmp_path: Path) -> None:
    discover = load("discover")
    names = ("-rf", "a;id", "$(id)", "a b", "new\nline", "\x1b[31m", "`id`")
    for name in (*names, "good"):
        (tmp_path / name).write_text("#!/usr/bin/env python3\nimport rospy\n")
        (tmp_path / name).chmod(0o755)
    assert [found.name for found in discover.executables("demo", [str(tmp_path)])] == ["good"]
    classes = "".join(f'<class name="{name}" base_class_type="nodelet::Nodelet"/>' for name in ("../x", "a b", "-x", "$(id)", "demo/Good"))
    (tmp_path / "plugins.xml").write_text(f"<library>{classes}</library>")
    (tmp_path / "package.xml").write_text('<package><export><nodelet plugin="${prefix}/plugins.xml"/></export></package>')
    assert [found.command for found in discover.nodelets("demo", [str(tmp_path)], "loader")] == [["loader", "standalone", "demo/Good"]]


def test_what_a_build_says_is_cut_and_made_harmless(tmp_path: Path) -> None:
    log = tmp_path / "log"
    lines = [
        "fine",
        "/ws/src/ws/a.cpp:1: error: \x1b]0;owned\x07 bell",
        "CMake Error at x:1:",
        "  \u202egnorw " + "x" * 1000,
        *["error: again"] * 9,
    ]
    log.write_text("\n".join([*lines, *(f"error: number {number}" for number in range(9))]))
    said = load("setup/build")._errors(str(log), "/ws")
    assert said == [
        "src/ws/a.cpp:1: error:  ]0;owned  bell",
        "CMake Error at x:1:  gnorw " + "x" * 273,
        "error: again",
        "error: number 0",
        "error: number 1",
    ]


def test_why_a_script_of_the_build_has_failed_comes_first(tmp_path: Path) -> None:
    log = tmp_path / "log"
    log.write_text(
        "-- Using empy\n"
        "Traceback (most recent call last):\n"
        '  File "/usr/share/catkin/cmake/parse_package_xml.py", line 100, in main\n'
        "    raise InvalidPackage()\n"
        "catkin_pkg.package.InvalidPackage: Error(s) in package '/ws/src/demo/package.xml':\n"
        'Invalid email "nobody" for person "somebody"\n'
        "CMake Error at safe_execute_process.cmake:11 (message):\n"
        "  execute_process(parse_package_xml.py) returned error code 1\n"
    )
    assert load("setup/build")._errors(str(log), "/ws") == [
        'catkin_pkg.package.InvalidPackage: Error(s) in package \'src/demo/package.xml\': Invalid email "nobody" for person "somebody"',
        "CMake Error at safe_execute_process.cmake:11 (message): execute_process(parse_package_xml.py) returned error code 1",
    ]


def test_the_compiler_is_told_what_debian_needs(tmp_path: Path) -> None:
    compiler = tmp_path / "c++"
    compiler.write_text('#!/bin/sh\nprintf "%s\\n" "$@"\n')
    compiler.chmod(0o755)
    script = (
        (PROBE / "setup" / "compile.sh")
        .read_text()
        .replace("/usr/bin/c++", str(compiler))
        .replace("/usr/include/boost/bind.hpp", str(compiler))
    )
    (tmp_path / "compile.sh").write_text(script)

    def called(*words: str) -> list[str]:
        return subprocess.run(["sh", str(tmp_path / "compile.sh"), *words], capture_output=True, text=True, check=True).stdout.splitlines()

    assert called("-std=c++11", "-DTEXT=two words", "-c", "a b.cpp") == [
        "-DTEXT=two words",
        "-c",
        "a b.cpp",
        "-std=gnu++17",
        "-w",
        "-DBOOST_BIND_GLOBAL_PLACEHOLDERS",
        "-include",
        "boost/bind.hpp",
    ]
    assert called("a.o", "-o", "a") == ["a.o", "-o", "a"]


def test_packages_of_ros_2_are_told_by_their_conditions(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    package = tmp_path / "both"
    package.mkdir()
    (package / "package.xml").write_text(
        "<package format='3'><name>both</name><depend condition='$ROS_VERSION == 1'>roscpp</depend>"
        "<depend condition='$ROS_VERSION == 2'>rclcpp</depend><depend>std_msgs</depend>"
        "<export><build_type condition='$ROS_VERSION == 1'>catkin</build_type>"
        "<build_type condition='$ROS_VERSION == 2'>ament_cmake</build_type></export></package>"
    )
    found = {}
    for version, prefix in (("1", ""), ("2", "/opt/ros/jazzy")):
        monkeypatch.setenv("AMENT_PREFIX_PATH", prefix)
        known = load("setup/build").packages(str(tmp_path))["both"]
        found[version] = (known.kind, sorted(known.depends))
    assert found == {"1": ("catkin", ["roscpp", "std_msgs"]), "2": ("ament_cmake", ["rclcpp", "std_msgs"])}


def test_what_was_built_is_installed_although_something_was_not(tmp_path: Path) -> None:
    script = tmp_path / "src" / "cmake_install.cmake"
    script.parent.mkdir()
    script.write_text(
        '  file(INSTALL DESTINATION "/i/lib" TYPE EXECUTABLE FILES "/b/x")\n  file(INSTALL DESTINATION "/i" TYPE FILE FILES "/b/y z")\n'
    )
    load("setup/build")._take_what_is_there(str(tmp_path))
    assert script.read_text() == (
        '  file(INSTALL DESTINATION "/i/lib" TYPE EXECUTABLE OPTIONAL FILES "/b/x")\n'
        '  file(INSTALL DESTINATION "/i" TYPE FILE OPTIONAL FILES "/b/y z")\n'
    )


def test_components_are_those_of_the_index(tmp_path: Path) -> None:
    index = tmp_path / "share" / "ament_index" / "resource_index" / "rclcpp_components"
    index.mkdir(parents=True)
    (index / "robot").write_text("robot::Filter;lib/libfilter.so\n\n../evil;x\nrobot::Filter;lib/other.so\n")
    found = load("discover").components("robot", [str(tmp_path)], "/loader")
    assert [(each.label, each.command, each.path) for each in found] == [("robot::Filter", ["/loader"], str(index / "robot"))]
    assert list(load("discover").components("robot", [str(tmp_path)], None)) == []


ENTRY = """#!/usr/bin/python3
# EASY-INSTALL-ENTRY-SCRIPT: '{0}==1.0.0','console_scripts','{1}'
import sys
"""


def test_a_script_of_setuptools_is_what_its_package_is(tmp_path: Path) -> None:
    site = tmp_path / "lib" / "python3.12" / "site-packages"
    (site / "my_robot").mkdir(parents=True)
    (site / "my_robot-1.0.0-py3.12.egg-info").mkdir()
    (site / "my_robot-1.0.0-py3.12.egg-info" / "entry_points.txt").write_text("[console_scripts]\ndrive = my_robot.main:main\n")
    (site / "my_robot" / "main.py").write_text("from .drive import run\n")
    program = tmp_path / "lib" / "my_robot" / "drive"
    program.parent.mkdir(parents=True)
    program.write_text(ENTRY.format("my-robot", "drive"))
    program.chmod(0o755)
    discover = load("discover")
    (site / "my_robot" / "drive.py").write_text("import numpy\n")
    assert discover.classify(str(program), discover.ROS2) == "none"
    (site / "my_robot" / "drive.py").write_text("import rclpy\n")
    assert discover.classify(str(program), discover.ROS2) == "rclpy"
    assert discover.classify(str(program)) == "none"
    (site / "my_robot-1.0.0-py3.12.egg-info" / "entry_points.txt").write_text("[console_scripts]\ndrive = my_robot.lost.main:main\n")
    assert discover.classify(str(program), discover.ROS2) == "rclpy"  # its module was not installed: running it tells
