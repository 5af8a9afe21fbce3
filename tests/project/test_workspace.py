"""A workspace held open says what a fresh check of the same texts says, whatever was typed before."""

from __future__ import annotations

import sys
from pathlib import Path

import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from launchlint.evaluate.ros1.launch import DEEPEST_STACK
from launchlint.finding import Finding
from launchlint.project.workspace import OpenWorkspace
from tests.server.workspace import MAIN, PACKAGE, PART

TURTLE = "background_r: 10\nbackground_r: 20\n"
FILES = {"package.xml": PACKAGE, "launch/main.launch": MAIN, "launch/part.launch": PART, "config/turtle.yaml": TURTLE}
PIECES = ("", "x", "<", ">", '"', "/>", "$(arg ", "$(arg sim)", " name=", "\n", "</node>", "<group>", "<!--", "rate", ":", "  - a", "é😀")


def make(directory: Path) -> OpenWorkspace:
    directory.mkdir(exist_ok=True)
    (directory / ".git").mkdir(exist_ok=True)
    for name, text in FILES.items():
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


edit = st.tuples(st.sampled_from(sorted(FILES)), st.floats(0, 1), st.integers(0, 12), st.sampled_from(PIECES), st.booleans())


@settings(max_examples=20, deadline=None, suppress_health_check=list(HealthCheck))
@given(edits=st.lists(edit, min_size=1, max_size=8))
def test_after_any_edits_the_findings_are_those_of_a_fresh_check(edits: list[tuple[str, float, int, str, bool]], tmp_path: Path) -> None:
    directory = tmp_path / "ws"
    workspace = make(directory)
    texts = dict(FILES)
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


def test_what_is_saved_reaches_exactly_the_entries_that_read_it(tmp_path: Path) -> None:
    workspace = make(tmp_path)
    workspace.settle()
    file = tmp_path / "config" / "turtle.yaml"
    file.write_text("background_r: 10\n", encoding="utf-8")
    workspace.reread([str(file)])
    assert [Path(each.at).name for each in workspace.waiting()] == ["main.launch"]
    assert told(workspace) == told(OpenWorkspace(str(tmp_path)))


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
