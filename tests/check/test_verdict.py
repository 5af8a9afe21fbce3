"""One verdict on an entry file, the same in every output: it loads, roslaunch refuses it, or what is missing here."""

from __future__ import annotations

import json
from collections.abc import Callable, Mapping
from pathlib import Path
from typing import Any

import pytest

from launchlint.report.escape import markdown
from launchlint.verdict import LOADS, Refusal, Verdict
from tests.cli.running import run
from tests.report.html.pages import data_of

Make = Callable[[Mapping[str, str]], Path]

NODE = '<node name="{}" pkg="demo" type="talk.py"/>'
SIM = '<arg name="sim" default="false"/>'
ONLY_SIM = '<group if="$(arg sim)">{}</group>'
LOADED: dict[str, Any] = {"word": "loads", "rule": "", "reason": "", "missing": [], "elsewhere": []}
TWICE: dict[str, Any] = {"word": "refused", "rule": "LL301", "reason": "two nodes are named /a", "missing": [], "elsewhere": []}


def untold(rule: str, *missing: str, reason: str = "") -> dict[str, Any]:
    return {"word": "cannot be told", "rule": rule, "reason": reason, "missing": list(missing), "elsewhere": []}


def refused_with(rule: str, reason: str, **arguments: str) -> dict[str, Any]:
    return {"configuration": arguments, "rule": rule, "reason": reason}


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
    "refused with other args only": (
        SIM + NODE.format("a") + ONLY_SIM.format(NODE.format("a")),
        {**LOADED, "elsewhere": [refused_with("LL301", "two nodes are named /a", sim="true")]},
    ),
    "untold, and refused with other args": (
        SIM + '<arg name="map"/>' + NODE.format("$(arg map)") + ONLY_SIM.format(NODE.format("a") * 2),
        {**untold("LL202", "the arg map"), "elsewhere": [refused_with("LL301", "two nodes are named /a", sim="true")]},
    ),
    "refused as it stands, and with other args": (SIM + NODE.format("a") * 2 + ONLY_SIM.format(NODE.format("b") * 2), TWICE),
    "with other args something is missing here": (SIM + ONLY_SIM.format('<include file="$(env SITE)/a.launch"/>'), LOADED),
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
    assert json.loads(run(directory, "graph", "--format", "json", "a.launch").output)["verdict"] == expected
    sarif = json.loads(run(directory, "check", "--format", "sarif", "a.launch").output)["runs"][0]
    assert sarif.get("properties", {"verdicts": []})["verdicts"] == [
        {"file": "a.launch", **expected} for _ in range(expected["word"] != "loads" or bool(expected["elsewhere"]))
    ]
    elsewhere = (Refusal(tuple(each["configuration"].items()), each["rule"], each["reason"]) for each in expected["elsewhere"])
    verdict = Verdict(expected["word"], expected["rule"], expected["reason"], tuple(expected["missing"]), tuple(elsewhere))
    (entry,) = data_of(run(directory, "report", "-o", "-", "a.launch").output)["entries"]
    assert (entry["verdict"], entry["why"], entry["withArgs"]) == (verdict.word, verdict.why, verdict.with_args)
    drawn = run(directory, "graph", "a.launch").output.splitlines()
    assert (drawn[1] if len(drawn) > 1 else "").strip().startswith(verdict.notice)
    unseen = "; 0 of 1 node known" if "nothing.py" in text else ""
    ending = (f"; {verdict.brief}" if verdict.brief else "") + unseen
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
    (directory / "d.launch").write_text(f"<launch>{SIM}{NODE.format('d')}{ONLY_SIM.format(NODE.format('d'))}</launch>\n", encoding="utf-8")
    said = run(directory, "check").output.splitlines()[-1]
    assert said.endswith("of 4 entry files 2 load, 1 is refused by roslaunch, 1 cannot be told, 1 of these is refused with other args")


def test_words() -> None:
    assert LOADS.sentence == "loads"
    assert (LOADS.why, LOADS.notice, LOADS.brief, LOADS.with_args) == ("", "", "", "")
    assert Verdict("refused", "LL301", "two nodes").sentence == "refused by roslaunch: two nodes"
    assert Verdict("cannot be told", "LL208", "too hard").sentence == "cannot be told: too hard"
    assert Verdict("cannot be told", "LL202", "", ("the arg a",)).why == "it needs the arg a"
    assert Verdict("cannot be told", "LL202", "", ("a", "b")).why == "it needs a and b"
    assert Verdict("cannot be told", "LL202", "", tuple("abcde")).why == "it needs a, b, c and 2 more"


FOLLOWED = "from launch import LaunchDescription\n\n\ndef generate_launch_description():\n    return LaunchDescription([])\n"
NOT_FOLLOWED = FOLLOWED.replace("[]", "requests.get('http://example.org').json()").replace("\n\n\n", "\nimport requests\n\n\n")


@pytest.mark.parametrize(("text", "word"), [(FOLLOWED, "loads"), (NOT_FOLLOWED, "cannot be told")])
def test_of_a_program_that_is_not_known_nobody_says_that_it_loads(text: str, word: str, make: Make) -> None:
    """Nor does one output say so while another says that it is not known."""
    directory = make({"a.launch.py": text})
    told = json.loads(run(directory, "model", "--format", "json", "a.launch.py").output)
    assert (told["verdict"], told["outcome"]["word"]) == ("ok" if word == "loads" else "unknown", word)
    (entry,) = data_of(run(directory, "report", "-o", "-", "a.launch.py").output)["entries"]
    why = "" if word == "loads" else "a.launch.py is not known as a whole: line 6: requests.get is not looked into"
    assert (entry["verdict"], entry["why"]) == (word, why)
    assert run(directory, "check", "a.launch.py").output.strip().endswith(f"cannot be told: {why}" if why else "1 launch file")


def test_words_of_other_configurations() -> None:
    twice = Verdict("refused", "LL301", "two nodes")
    once = LOADS.beside([((("sim", "true"),), twice), ((("sim", "true"), ("gui", "1")), twice), ((("gui", "1"),), LOADS)])
    assert once.elsewhere == (Refusal((("sim", "true"),), "LL301", "two nodes"),), "one reason is told once, with the args found first"
    assert once.sentence == once.notice == "loads; refused with sim:=true: two nodes"
    assert once.brief == "refused by roslaunch with sim:=true"
    several = LOADS.beside([((("sim", "true"),), twice), ((("gui", "1"),), Verdict("refused", "LL207", "broken"))])
    assert several.sentence == "loads; refused with sim:=true: two nodes; with other args for 1 more reason"
    untold = Verdict("cannot be told", "LL202", "", ("the arg a",)).beside([((("sim", "true"),), twice)])
    assert untold.brief == "cannot be told: it needs the arg a; refused by roslaunch with sim:=true"
    assert twice.beside([((("sim", "true"),), Verdict("refused", "LL207", "broken"))]) == twice
