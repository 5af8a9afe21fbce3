"""A workspace held open says what a fresh check of the same texts says, whatever was typed before."""

from __future__ import annotations

import sys
from pathlib import Path

import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from launchlint.evaluate.ros1.launch import DEEPEST_STACK
from launchlint.finding import Edit, Finding
from launchlint.project.workspace import OpenWorkspace
from tests.server.workspace import MAIN, PACKAGE, PART

TURTLE = "background_r: 10\nbackground_r: 20\n"
FILES = {"package.xml": PACKAGE, "launch/main.launch": MAIN, "launch/part.launch": PART, "config/turtle.yaml": TURTLE}
PIECES = ("", "x", "<", ">", '"', "/>", "$(arg ", "$(arg sim)", " name=", "\n", "</node>", "<group>", "<!--", "rate", ":", "  - a", "é😀")


PACKAGE_ROS2 = PACKAGE.replace("catkin", "ament_cmake").replace(
    "</package>", "<export><build_type>ament_cmake</build_type></export></package>"
)
MAIN_ROS2 = """<launch>
  <arg name="sim" default="false"/>
  <group>
    <push_ros_namespace namespace="robot"/>
    <node pkg="turtlesim" exec="turtlesim_node" name="turtle"><param from="$(find-pkg-share demo)/config/turtle.yaml"/></node>
  </group>
  <include file="$(dirname)/part.launch.yaml"><arg name="speed" value="2"/></include>
  <include file="$(dirname)/program.launch.py" if="$(var sim)"/>
</launch>
"""
PART_ROS2 = """launch:
  - arg: {name: speed, default: '1'}
  - arg: {name: unused}
  - node: {pkg: turtlesim, exec: turtle_teleop_key, name: teleop, namespace: robot, args: $(var speed)}
"""
PROGRAM_ROS2 = """from launch import LaunchDescription
from launch_ros.actions import Node

def generate_launch_description():
    return LaunchDescription([Node(package="turtlesim", executable="turtlesim_node", name="turtle", namespace="robot")])
"""
FILES_ROS2 = {
    "package.xml": PACKAGE_ROS2,
    "launch/main.launch.xml": MAIN_ROS2,
    "launch/part.launch.yaml": PART_ROS2,
    "launch/other_launch.yaml": PART_ROS2.replace("teleop", "other"),
    "launch/program.launch.py": PROGRAM_ROS2,
    "launch/plain.xml": MAIN_ROS2,
    "config/turtle.yaml": "/robot/turtle:\n  ros__parameters: {background_r: 10}\n",
}
PIECES_ROS2 = (*PIECES, "launch:", "- node: {", "    ", "$(var ", "def ", "])", "<launch>", "return ")


def make(directory: Path, files: dict[str, str] = FILES) -> OpenWorkspace:
    directory.mkdir(exist_ok=True)
    (directory / ".git").mkdir(exist_ok=True)
    for name, text in files.items():
        (directory / name).parent.mkdir(exist_ok=True, parents=True)
        (directory / name).write_text(text, encoding="utf-8")
    return OpenWorkspace(str(directory))


def told(workspace: OpenWorkspace) -> list[Finding]:
    """What is found in files that can be read, and what is wrong with those that cannot."""
    workspace.settle()
    broken = {workspace.checker.session.shown(file) for file in workspace.broken}
    findings = workspace.outcome().findings
    return [each for each in findings if each.location.path not in broken or each.rule == "LL101"]


def fresh(workspace: OpenWorkspace, directory: Path) -> list[Finding]:
    """The same texts, saved and checked anew."""
    before = {}
    for file, data in workspace.texts.items():
        before[file] = Path(file).read_bytes()
        Path(file).write_bytes(data)
    try:
        other = OpenWorkspace(str(directory))
        other.hold(workspace.texts)  # what is open was asked for by name, whatever its root is
        return told(other)
    finally:
        for file, data in before.items():
            Path(file).write_bytes(data)


@pytest.fixture(autouse=True)
def _deep_stack() -> None:
    """As an evaluation sets it: Hypothesis warns where it changes meanwhile."""
    sys.setrecursionlimit(DEEPEST_STACK)


Edited = tuple[str, float, int, str, bool]
"""A file, where in it something is changed, how much is taken away, what comes there, and whether findings are asked for then."""
edit = st.tuples(st.sampled_from(sorted(FILES)), st.floats(0, 1), st.integers(0, 12), st.sampled_from(PIECES), st.booleans())


@settings(max_examples=20, deadline=None, suppress_health_check=list(HealthCheck))
@given(edits=st.lists(edit, min_size=1, max_size=8))
def test_after_any_edits_the_findings_are_those_of_a_fresh_check(edits: list[Edited], tmp_path: Path) -> None:
    check_edits(edits, FILES, tmp_path / "ws")


def check_edits(edits: list[Edited], files: dict[str, str], directory: Path) -> None:
    workspace = make(directory, files)
    texts = dict(files)
    for name, at, length, piece, look in edits:
        text = texts[name]
        start = int(at * len(text))
        texts[name] = text[:start] + piece + text[start + length :]
        workspace.hold({str(directory / name): texts[name].encode()})
        if look:
            told(workspace)
    assert told(workspace) == fresh(workspace, directory)
    workspace.hold(dict.fromkeys(list(workspace.texts)))
    assert told(workspace) == told(OpenWorkspace(str(directory)))


edit_ros2 = st.tuples(st.sampled_from(sorted(FILES_ROS2)), st.floats(0, 1), st.integers(0, 12), st.sampled_from(PIECES_ROS2), st.booleans())


@settings(max_examples=20, deadline=None, suppress_health_check=list(HealthCheck))
@given(edits=st.lists(edit_ros2, min_size=1, max_size=8))
def test_after_any_edits_of_ros2_the_findings_are_those_of_a_fresh_check(edits: list[Edited], tmp_path: Path) -> None:
    check_edits(edits, FILES_ROS2, tmp_path / "ws")


def test_what_is_wrong_with_a_text_that_is_broken_in_several_places_is_told_of_the_text_itself(tmp_path: Path) -> None:
    """What stands in for it is broken, too, where nothing was readable before; or the last text that was."""
    name = "launch/main.launch"
    edits = [(name, 0.1, 0, "<", False), (name, 0.0, 1, "", False), (name, 0.96875, 4, "", False)]
    check_edits(edits, FILES, tmp_path / "ws")


@pytest.mark.parametrize("name", ["launch/part.launch.yaml", "launch/other_launch.yaml"])
def test_a_yaml_file_whose_root_is_damaged(name: str, tmp_path: Path) -> None:
    check_edits([(name, 0.0, 3, "x", True)], FILES_ROS2, tmp_path / "ws")
    check_edits([(name, 0.0, 3, "x", True), (name, 0.0, 1, "lau", True)], FILES_ROS2, tmp_path / "other")


def test_what_is_saved_reaches_exactly_the_entries_that_read_it(tmp_path: Path) -> None:
    workspace = make(tmp_path)
    workspace.settle()
    file = tmp_path / "config" / "turtle.yaml"
    file.write_text("background_r: 10\n", encoding="utf-8")
    workspace.reread([str(file)])
    assert [Path(each.at).name for each in workspace.waiting()] == ["main.launch"]
    assert told(workspace) == told(OpenWorkspace(str(tmp_path)))


OTHER = '<launch>\n  <arg name="unused"/>\n</launch>\n'


def with_another_package(directory: Path) -> tuple[OpenWorkspace, Path]:
    """Packages own and other: own starts its own program, and other the same one."""
    for name in ("own", "other"):
        (directory / name / "launch").mkdir(parents=True)
        manifest = directory / name / "package.xml"
        manifest.write_text(PACKAGE.replace("demo", name).replace("turtlesim", "own" if name == "other" else "rospy"), encoding="utf-8")
        starting = '<launch>\n  <node name="turtle" pkg="own" type="run.py"/>\n</launch>\n'
        (directory / name / "launch" / f"{name}.launch").write_text(starting, encoding="utf-8")
    (directory / ".git").mkdir()
    (directory / ".launchlint.yaml").write_text("extract: false\n", encoding="utf-8")  # to read a program is to look at many manifests
    (directory / "other" / "launch" / "plain.launch").write_text(OTHER, encoding="utf-8")
    (directory / "own" / "run.py").write_text("#!/usr/bin/env python3\n", encoding="utf-8")
    (directory / "own" / "run.py").chmod(0o755)
    workspace = OpenWorkspace(str(directory))
    workspace.settle()
    return workspace, manifest


def test_a_package_xml_reaches_exactly_the_entries_that_read_it(tmp_path: Path) -> None:
    workspace, manifest = with_another_package(tmp_path)
    manifest.write_text(manifest.read_text().replace("<exec_depend>own</exec_depend>", ""), encoding="utf-8")
    workspace.reread([str(manifest)])
    waiting = {Path(each.at).name for each in workspace.waiting()}
    assert "other.launch" in waiting
    assert "own.launch" not in waiting
    assert told(workspace) == told(OpenWorkspace(str(tmp_path)))
    assert [each.rule for each in told(workspace) if each.rule == "LL701"] == ["LL701"]


def test_an_unsaved_package_xml_counts(tmp_path: Path) -> None:
    workspace, manifest = with_another_package(tmp_path)
    before = told(workspace)
    workspace.hold({str(manifest): manifest.read_bytes().replace(b"<exec_depend>own</exec_depend>", b"")})
    assert "own.launch" not in {Path(each.at).name for each in workspace.waiting()}
    assert {each.rule for each in set(told(workspace)) - set(before)} == {"LL701"}
    workspace.hold({str(manifest): None})
    assert told(workspace) == before


def test_another_name_of_a_package_reaches_everybody(tmp_path: Path) -> None:
    workspace, manifest = with_another_package(tmp_path)
    manifest.write_text(manifest.read_text().replace("<name>other", "<name>third"), encoding="utf-8")
    workspace.reread([str(manifest)])
    assert set(workspace.waiting()) == set(workspace.requests)
    assert told(workspace) == told(OpenWorkspace(str(tmp_path)))


def test_what_is_told_of_some_files_is_what_is_told_of_them_among_all(tmp_path: Path) -> None:
    workspace, _ = with_another_package(tmp_path)
    everything = workspace.outcome().findings
    for request in workspace.requests:
        shown = workspace.checker.session.shown(request.at)
        assert workspace.outcome([request.at]).findings == tuple(each for each in everything if each.location.path == shown)


def test_args_that_another_file_begins_to_pass_count_at_once(tmp_path: Path) -> None:
    workspace, _ = with_another_package(tmp_path)
    plain = [each for each in told(workspace) if each.location.path.endswith("plain.launch")]
    assert [each.rule for each in plain] == ["LL206"]
    text = '<launch>\n  <include file="$(find other)/launch/plain.launch">\n    <arg name="unused" value="1"/>\n  </include>\n</launch>\n'
    file = tmp_path / "other" / "launch" / "other.launch"
    workspace.hold({str(file): text.encode()})
    after = told(workspace)
    assert after == fresh(workspace, tmp_path)
    assert [each for each in after if each.location.path.endswith("plain.launch")] != plain


def test_a_fix_is_proved_as_on_the_command_line(tmp_path: Path) -> None:
    workspace = make(tmp_path)
    workspace.settle()
    (finding,) = [each for each in told(workspace) if each.rule == "LL206" and each.fix is not None]
    assert finding.fix is not None
    assert workspace.refusal(finding) == ""
    start = MAIN.index('name="turtle"') + 6
    other = finding._replace(fix=finding.fix._replace(changes="", edits=(Edit(finding.location.path, start, start, "sea_"),)))
    assert workspace.refusal(other)
    useless = finding._replace(fix=finding.fix._replace(edits=(Edit(finding.location.path, start, start, "sea_"),)))
    assert workspace.refusal(useless) == "LL206 unused-arg would still be found"


def test_all_safe_fixes_of_a_file_are_made_together(tmp_path: Path) -> None:
    workspace = make(tmp_path)
    part = tmp_path / "launch" / "part.launch"
    line = '    <remap from="turtle1/pose" to="turtle1/pose"/>\n'
    text = PART.replace("  </node>", f"{line}  </node>")
    workspace.hold({str(part): text.encode()})
    workspace.settle()
    assert workspace.repaired(str(part)) == PART.encode()
    assert workspace.repaired(str(tmp_path / "launch" / "main.launch")) is None


def test_blocks_that_did_not_touch_what_changed_are_kept(tmp_path: Path) -> None:
    workspace = make(tmp_path)
    workspace.settle()
    before = {id(each) for each in workspace.checker.session.blocks.values()}
    main = tmp_path / "launch" / "main.launch"
    workspace.hold({str(main): MAIN.replace("unused", "other").encode()})
    kept = {id(each) for each in workspace.checker.session.blocks.values()} & before
    assert kept
    assert {Path(each.document.source.path).name for each in workspace.checker.session.blocks.values()} == {"part.launch"}


def test_a_half_written_line_takes_nothing_else_away(tmp_path: Path) -> None:
    workspace = make(tmp_path)
    workspace.settle()
    before = [each for each in workspace.outcome().findings if each.location.path == "launch/main.launch"]
    assert [each.rule for each in before if each.rule == "LL301"] == ["LL301"]
    text = MAIN.replace('default="1"/>', 'default="1"/>\n  <remap from="a" to="$(arg ')
    workspace.hold({str(tmp_path / "launch" / "main.launch"): text.encode()})
    workspace.settle()
    after = [each for each in workspace.outcome().findings if each.location.path == "launch/main.launch"]
    assert {(each.rule, each.location.text) for each in after} >= {(each.rule, each.location.text) for each in before}
    assert "LL101" in {each.rule for each in after}


def test_files_that_come_and_go(tmp_path: Path) -> None:
    workspace = make(tmp_path)
    workspace.settle()
    new = tmp_path / "launch" / "new.launch"
    new.write_text("<launch>\n  <nod/>\n</launch>\n", encoding="utf-8")
    workspace.reread([str(new)])
    assert told(workspace) == told(OpenWorkspace(str(tmp_path)))
    (tmp_path / "launch" / "part.launch").unlink()
    workspace.reread([str(tmp_path / "launch" / "part.launch")])
    assert told(workspace) == told(OpenWorkspace(str(tmp_path)))


def test_what_the_given_configuration_shows_is_told_before_the_others_have_been_looked_at(tmp_path: Path) -> None:
    workspace = make(tmp_path)
    main = tmp_path / "launch" / "main.launch"
    text = MAIN.replace(
        "</launch>", '  <group unless="$(arg sim)">\n    <node name="turtle" pkg="turtlesim" type="none"/>\n  </group>\n</launch>'
    )
    workspace.hold({str(main): text.encode()})
    before = told(workspace)
    assert any(each.arguments for each in before if each.location.path == "launch/main.launch")
    workspace.hold({str(main): text.replace('default="1"', 'default="12"').encode()})
    interim: list[list[tuple[str, int, int]]] = []
    (request,) = [each for each in workspace.waiting() if each.at == str(main)]
    workspace.work(request, lambda: interim.append(places(list(workspace.outcome().findings))))
    assert interim == [places(told(workspace))]
    assert [each[:2] for each in places(before)] == [each[:2] for each in interim[0]]


def places(findings: list[Finding]) -> list[tuple[str, int, int]]:
    return [(each.rule, each.location.line, each.location.start) for each in findings]


def test_a_file_that_is_opened_is_told_of_before_its_other_configurations_have_been_looked_at(tmp_path: Path) -> None:
    make(tmp_path)
    workspace = OpenWorkspace(str(tmp_path))
    main = str(tmp_path / "launch" / "main.launch")
    (request,) = [each for each in workspace.waiting([main]) if each.at == main]
    interim: list[list[tuple[str, int, int]]] = []
    workspace.work(request, lambda: interim.append(places(list(workspace.outcome([main]).findings))))
    (found,) = interim
    assert {rule for rule, _, _ in found} == {"LL206", "LL301"}
    assert places(list(workspace.outcome([main]).findings)) == found


def test_to_prove_a_fix_tells_nobody_what_would_be_found_after_it(tmp_path: Path) -> None:
    make(tmp_path)
    workspace = OpenWorkspace(str(tmp_path))
    main = str(tmp_path / "launch" / "main.launch")
    (request,) = [each for each in workspace.waiting([main]) if each.at == main]
    told_first: list[str] = []
    workspace.work(request, lambda: told_first.append("first"))
    before = workspace.outcome([main]).findings
    (finding,) = [each for each in before if each.rule == "LL206" and each.fix is not None]
    assert workspace.refusal(finding) == ""
    assert workspace.outcome([main]).findings == before
    assert told_first == ["first"]
