"""One verdict on an entry file, the same in every output: it loads, roslaunch refuses it, or what is missing here."""

from __future__ import annotations

import json
from collections.abc import Callable, Mapping
from pathlib import Path
from typing import Any

import pytest

from launchlint.report.escape import markdown
from launchlint.verdict import LOADS, Verdict
from tests.cli.running import run
from tests.report.html.pages import data_of

Make = Callable[[Mapping[str, str]], Path]

NODE = '<node name="{}" pkg="demo" type="talk.py"/>'
LOADED = {"word": "loads", "rule": "", "reason": "", "missing": []}
TWICE = {"word": "refused", "rule": "LL301", "reason": "two nodes are named /a", "missing": []}


def untold(rule: str, *missing: str, reason: str = "") -> dict[str, Any]:
    return {"word": "cannot be told", "rule": rule, "reason": reason, "missing": list(missing)}


CASES = {
    "in order": (NODE.format("a"), LOADED),
    "a node that cannot start stops no other": ('<node name="a" pkg="demo" type="nothing.py"/>', LOADED),
    "what roslaunch merely warns about": ('<nod name="a"/>' + NODE.format("b"), LOADED),
    "two nodes of one name": (NODE.format("a") * 2, TWICE),
    "an error behind what is missing here": (f'<param name="p" value="$(env SITE)"/>{NODE.format("a") * 2}', TWICE),
    "a variable of the machine": ('<param name="p" value="$(env SITE)"/>', untold("LL209", "the environment variable SITE")),
    "an arg of the command line": ('<arg name="map"/>' + NODE.format("$(arg map)"), untold("LL202", "the arg map")),
    "a package that is not here": (
        '<include file="$(find turtlebot3_bringup)/launch/robot.launch"/>',
        untold("LL210", "the package turtlebot3_bringup"),
    ),
    "several of them, each once": (
        '<param name="p" value="$(env SITE)$(env SITE)"/><param name="q" value="$(find turtlebot3_bringup)$(env SITE)"/>',
        untold("LL209", "the environment variable SITE", "the package turtlebot3_bringup"),
    ),
}


@pytest.mark.parametrize(("text", "expected"), CASES.values(), ids=CASES.keys())
def test_every_output_gives_the_same(text: str, expected: dict[str, Any], make: Make) -> None:
    directory = make({"a.launch": f"<launch>{text}</launch>\n", "entries.json": json.dumps([{"file": "a.launch"}])})
    checked = json.loads(run(directory, "check", "--format", "json", "a.launch").output)
    assert checked["verdicts"] == [{"file": "a.launch", **expected}]
    again = json.loads(run(directory, "check", "--format", "json", "a.launch").output)
    assert again == checked, "from the cache"
    (line,) = run(directory, "check", "--format", "jsonl", "--entries", "entries.json").output.splitlines()
    assert (json.loads(line)["outcome"], json.loads(line)["verdict"]) == (expected, "ok" if expected["word"] == "loads" else "error")
    assert json.loads(run(directory, "model", "--format", "json", "a.launch").output)["outcome"] == expected
    sarif = json.loads(run(directory, "check", "--format", "sarif", "a.launch").output)["runs"][0]
    assert sarif.get("properties", {"verdicts": []})["verdicts"] == [
        {"file": "a.launch", **expected} for _ in range(expected["word"] != "loads")
    ]
    verdict = Verdict(expected["word"], expected["rule"], expected["reason"], tuple(expected["missing"]))
    (entry,) = data_of(run(directory, "report", "-o", "-", "a.launch").output)["entries"]
    assert (entry["verdict"], entry["why"]) == (verdict.word, verdict.why)
    ending = {"loads": "", "refused": "; refused by roslaunch"}.get(verdict.word, f"; {verdict.sentence}")
    for format_, escaped in (("text", str), ("markdown", markdown)):
        (said,) = [row for row in run(directory, "check", "--format", format_, "a.launch").output.splitlines() if "in 1 launch file" in row]
        assert said.endswith(escaped(ending)), said
        assert ending or ";" not in said, said


def test_rules_that_are_switched_off_change_no_verdict(make: Make) -> None:
    directory = make({"a.launch": f"<launch>{NODE.format('a') * 2}</launch>\n"})
    checked = json.loads(run(directory, "check", "--format", "json", "--ignore", "LL301").output)
    assert (checked["findings"], checked["verdicts"]) == ([], [{"file": "a.launch", **TWICE}])
    assert "verdicts" not in json.loads(run(directory, "check", "--format", "json", "--select", "LL206").output), "few rules were asked for"


def test_several_entry_files_are_counted(make: Make) -> None:
    texts = {"a": NODE.format("a"), "b": NODE.format("a") * 2, "c": '<param name="p" value="$(env SITE)"/>', "d": NODE.format("d")}
    directory = make({f"{name}.launch": f"<launch>{text}</launch>\n" for name, text in texts.items()})
    said = run(directory, "check").output.splitlines()[-1]
    assert said.endswith("in 4 launch files; of 4 entry files 2 load, 1 is refused by roslaunch, 1 cannot be told")


def test_words() -> None:
    assert LOADS.sentence == "loads"
    assert LOADS.why == ""
    assert Verdict("refused", "LL301", "two nodes").sentence == "refused by roslaunch: two nodes"
    assert Verdict("cannot be told", "LL208", "too hard").sentence == "cannot be told: too hard"
    assert Verdict("cannot be told", "LL202", "", ("the arg a",)).why == "it needs the arg a"
    assert Verdict("cannot be told", "LL202", "", ("a", "b")).why == "it needs a and b"
    assert Verdict("cannot be told", "LL202", "", tuple("abcde")).why == "it needs a, b, c and 2 more"
