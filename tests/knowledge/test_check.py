"""The commands with sources beside the launch files: what is found without any library, in which state, and the same however it is run."""

from __future__ import annotations

import json
import re
import shutil
from pathlib import Path

import pytest

from tests.cli.running import ROOT, run, write
from tests.knowledge.conftest import FILES, LAUNCH
from tests.workspace.repositories import Repository

COUNTER = '<node name="counter" pkg="demo" type="counter.py"/>'
BAD_TYPE = LAUNCH.replace("</launch>", f"  {COUNTER}\n</launch>")
BAD_NAME = LAUNCH.replace('type="listener.py"/>', 'type="listener.py">\n    <remap from="chatter" to="chater"/>\n  </node>')
BAD_PARAM = '<launch>\n  <node name="r" pkg="demo" type="rate.py">\n    <param name="rat" value="1"/>\n  </node>\n</launch>\n'
MISMATCH = "/talker publishes /chatter as std_msgs/String, but /counter subscribes to it as std_msgs/Int32"


def told(directory: Path, *words: str, seed: str = "0") -> list[str]:
    ran = run(directory, "check", "--format", "concise", *words, environment={"PYTHONHASHSEED": seed})
    assert ran.errors == ""
    return ran.output.splitlines()


def test_a_type_a_name_and_a_param_that_are_wrong(workspace: Path) -> None:
    write(
        workspace,
        {
            "demo/scripts/rate.py": "#!/usr/bin/env python3\nimport rospy\nrospy.init_node('r')\nrospy.Rate(rospy.get_param('~rate'))\n",
            "demo/launch/talk.launch": BAD_TYPE,
            "demo/launch/name.launch": BAD_NAME,
            "demo/launch/param.launch": BAD_PARAM,
        },
    )
    lines = told(workspace, ".")
    assert [line for line in lines if MISMATCH in line] == [f"demo/launch/talk.launch:4:15: error LL611 type-mismatch: {MISMATCH}"]
    assert any(line.startswith("demo/launch/name.launch:4:") and "chater" in line for line in lines)
    assert any(line.startswith("demo/launch/param.launch:3:") and "rat" in line for line in lines)
    assert not any(MISMATCH in line or "name.launch" in line or "param.launch" in line for line in told(workspace, "--no-extract", "."))


def test_the_configuration_switches_it_off(workspace: Path) -> None:
    write(workspace, {"demo/launch/talk.launch": BAD_TYPE})
    assert MISMATCH in "\n".join(told(workspace, "."))
    write(workspace, {".launchlint.yaml": "extract: false\n"})
    assert MISMATCH not in "\n".join(told(workspace, "."))


def test_the_example_tells_all_without_a_library(tmp_path: Path) -> None:
    shutil.copytree(ROOT / "examples/turtles/turtle_parade", tmp_path / "repository/turtle_parade")
    write(tmp_path, {"repository/.git/HEAD": "ref: refs/heads/main\n"})
    with_library = told(tmp_path / "repository", "turtle_parade")
    (tmp_path / "repository/turtle_parade/library.json").unlink()
    (tmp_path / "repository/turtle_parade/.launchlint.yaml").unlink()
    assert [line.partition(":")[2] for line in told(tmp_path / "repository", "turtle_parade")] == [
        line.partition(":")[2] for line in with_library
    ]
    assert len(with_library) >= 4


def test_where_a_name_was_read_is_told(workspace: Path) -> None:
    write(workspace, {"demo/launch/talk.launch": BAD_TYPE})
    ran = run(workspace, "check", "--format", "json", ".")
    (finding,) = [each for each in json.loads(ran.output)["findings"] if each["rule"] == "LL611"]
    places = [(each["path"], each["line"], each["label"]) for each in finding["related"]]
    assert ("demo/scripts/counter.py", 6, "read from demo/scripts/counter.py:6: /counter subscribes to chatter") in places
    assert ("demo/scripts/talker.py", 7, "read from demo/scripts/talker.py:7: /talker publishes chatter") in places
    graph = run(workspace, "graph", "demo/launch/talk.launch").output
    assert "(std_msgs/String, read from demo/scripts/talker.py:7)" in graph


def test_how_much_is_known_and_why_not_the_rest(workspace: Path) -> None:
    more = '  <node name="tool" pkg="demo" type="tool.sh"/>\n  <node name="x" pkg="nobody_has_it" type="x"/>\n</launch>'
    write(workspace, {"demo/launch/talk.launch": LAUNCH.replace("</launch>", more), "demo/scripts/tool.sh": "#!/bin/sh\n"})
    (workspace / "demo/scripts/tool.sh").chmod(0o755)
    assert run(workspace, "check", ".").output.endswith("; 2 of 4 nodes known\n")
    told_why = "  demo/tool.sh (1 node): it is a script, but not Python\n  nobody_has_it/x (1 node): no library knows it\n"
    assert told_why in run(workspace, "check", "-v", ".").output
    assert json.loads(run(workspace, "check", "--format", "json", ".").output)["sight"] == {
        "nodes": 4,
        "known": 2,
        "unknown": [
            {"program": "demo/tool.sh", "reason": "it is a script, but not Python", "nodes": 1},
            {"program": "nobody_has_it/x", "reason": "no library knows it", "nodes": 1},
        ],
    }


def mismatches(lines: list[str]) -> int:
    """At how many places the mismatch is told, which is one finding."""
    more = (re.search(r" \(and at (\d+) more places?\)$", line) for line in lines if MISMATCH in line)
    return sum(1 if each is None else 1 + int(each[1]) for each in more)


def many(workspace: Path) -> None:
    """More launch files than from which results are kept."""
    write(workspace, {f"demo/launch/{number:02}.launch": BAD_TYPE if number % 3 else BAD_NAME for number in range(90)})
    for number in range(10):
        text = FILES["demo/scripts/listener.py"].replace("chatter", f"topic_{number}")
        write(workspace, {f"demo/scripts/n{number}.py": text})
        node = f'<launch>\n  <node name="n" pkg="demo" type="n{number}.py"/>\n  {COUNTER}\n</launch>\n'
        write(workspace, {f"demo/launch/n{number}.launch": node})


def test_the_same_with_any_number_of_processes_and_any_seed(workspace: Path) -> None:
    many(workspace)
    expected = told(workspace, "-v", "--jobs", "1", "--no-cache", ".")
    assert mismatches(expected) == 60
    assert told(workspace, "-v", "--jobs", "3", "--no-cache", ".", seed="1") == expected
    assert told(workspace, "-v", "--jobs", "2", ".", seed="2") == expected
    assert told(workspace, "-v", ".", seed="3") == expected


def test_a_kept_result_knows_the_sources_it_hangs_on(workspace: Path) -> None:
    many(workspace)
    assert mismatches(told(workspace, ".")) == 60
    assert mismatches(told(workspace, ".")) == 60
    write(workspace, {"demo/scripts/counter.py": FILES["demo/scripts/listener.py"]})
    assert mismatches(told(workspace, ".")) == 0
    write(workspace, {"demo/src/demo/names.py": 'TOPIC = "chater"\n', "demo/scripts/counter.py": FILES["demo/scripts/counter.py"]})
    lines = told(workspace, ".")
    assert mismatches(lines) == 0
    assert any("/chater" in line and "01.launch" in line for line in lines)


@pytest.fixture
def repository(tmp_path: Path) -> Repository:
    """The workspace with a talker and a counter that agree, committed."""
    made = Repository(tmp_path / "repository")
    agreed = {**FILES, "demo/scripts/counter.py": FILES["demo/scripts/listener.py"], "demo/launch/talk.launch": BAD_TYPE}
    write(made.directory, {name: text for name, text in agreed.items() if not name.startswith(".git")})
    made.commit()
    return made


def test_staged_sources_count_and_others_do_not(repository: Repository) -> None:
    counter = repository.directory / "demo/scripts/counter.py"
    agreed = counter.read_text()
    counter.write_text(FILES["demo/scripts/counter.py"])
    assert MISMATCH in "\n".join(told(repository.directory, "."))
    assert told(repository.directory, "--staged") == []
    repository.git("add", "-A")
    counter.write_text(agreed)
    assert told(repository.directory, ".") == []
    (line,) = told(repository.directory, "--staged")
    assert MISMATCH in line
    ran = run(repository.directory, "check", "--staged", "--format", "json")
    (finding,) = json.loads(ran.output)["findings"]
    assert {"demo/scripts/talker.py", "demo/scripts/counter.py"} <= {each["path"] for each in finding["related"]}


def test_a_source_that_git_does_not_know_does_not_count(repository: Repository) -> None:
    launch = BAD_TYPE.replace("counter.py", "new.py")
    write(repository.directory, {"demo/launch/talk.launch": launch})
    repository.git("add", "-A")
    write(repository.directory, {"demo/scripts/new.py": FILES["demo/scripts/counter.py"]})
    assert "std_msgs/Int32" in "\n".join(told(repository.directory, "."))
    assert "std_msgs/Int32" not in "\n".join(told(repository.directory, "--staged"))


def test_a_revision_is_compared_with_its_own_sources(repository: Repository) -> None:
    assert told(repository.directory, "--base", "HEAD", ".") == []
    write(repository.directory, {"demo/src/demo/names.py": 'TOPIC = "news"\n'})
    lines = told(repository.directory, "--base", "HEAD", ".")
    assert any("LL620" in line and "/chatter" in line for line in lines), lines
    diff = run(repository.directory, "graph", "diff", "HEAD").output
    assert "/news" in diff
    assert "/chatter" in diff
    assert run(repository.directory, "graph", "diff", "HEAD", "--no-extract").output == "no connection changed\n"
