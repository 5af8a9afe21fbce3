"""Many entry files, one list of findings: each once, at its own place, with the plainest way to it."""

from __future__ import annotations

import json
from collections.abc import Callable, Mapping
from pathlib import Path
from typing import Any

from tests.cli.running import run

Make = Callable[[Mapping[str, str]], Path]

NODE = '<node name="{name}" pkg="demo" type="talk.py"/>'
TWICE = f"<launch>\n{NODE.format(name='a')}\n{NODE.format(name='a')}\n</launch>\n"


def include(name: str, *args: str) -> str:
    """An include of a file beside it, with ``name=value`` args."""
    inner = "".join(f'<arg name="{arg.split("=")[0]}" value="{arg.split("=")[1]}"/>' for arg in args)
    return f'<include file="$(dirname)/{name}.launch">{inner}</include>'


def launch(*lines: str) -> str:
    return "\n".join(["<launch>", *lines, "</launch>", ""])


def findings(directory: Path, *words: str) -> list[dict[str, Any]]:
    found: list[dict[str, Any]] = json.loads(run(directory, "check", "--format", "json", *words).output)["findings"]
    return found


def brief(found: list[dict[str, Any]]) -> list[str]:
    return [f"{each['path']}:{each['line']} {each['severity']} {each['rule']}" for each in found]


def test_a_finding_that_many_entries_reach_is_told_once_with_the_shortest_chain(make: Make) -> None:
    directory = make(
        {
            "a.launch": launch(include("middle")),
            "b.launch": launch("", include("part")),
            "c.launch": launch(include("middle")),
            "middle.launch": launch("", include("part")),
            "part.launch": launch('<arg name="x"/>', NODE.format(name="$(arg x)"), '<param name="p" value="$(arg missing)"/>'),
        }
    )
    found = findings(directory, "--select", "LL201")
    assert brief(found) == ["part.launch:4 error LL201"]
    assert [(step["path"], step["line"]) for step in found[0]["chain"]] == [("b.launch", 3)]
    assert (found[0]["entry"], found[0]["entries"]) == ("b.launch", 4), "a, b, c and middle lead to it; part.launch alone is no entry file"


def test_the_plainest_command_is_shown(make: Make) -> None:
    """Of two configurations that show it, the one that needs no args."""
    doubled = launch('<arg name="twice" default="{twice}"/>', f'<group if="$(arg twice)">{include("twice")}</group>')
    directory = make({"a.launch": doubled.format(twice="false"), "b.launch": doubled.format(twice="true"), "twice.launch": TWICE})
    found = findings(directory, "--select", "LL301")
    assert brief(found) == ["twice.launch:3 error LL301"]
    assert (found[0]["entry"], found[0]["configuration"], found[0]["entries"]) == ("twice.launch", {}, 3)
    found = findings(directory, "--select", "LL301", "a.launch")
    assert (found[0]["entry"], found[0]["configuration"]) == ("a.launch", {"twice": "true"})


def test_what_is_in_order_in_any_entry_is_no_finding(make: Make) -> None:
    """A remap below all nodes of its own file acts on nothing, unless some other configuration has a node behind it."""
    part = launch(
        '<arg name="more" default="false"/>', NODE.format(name="a"), '<remap from="x" to="y"/>', include("tail", "on=$(arg more)")
    )
    tail = launch('<arg name="on"/>', f'<group if="$(arg on)">{NODE.format(name="b")}</group>')
    directory = make({"part.launch": part, "tail.launch": tail})
    assert findings(directory, "--select", "LL602") == []
    directory = make({"part.launch": part.replace('<arg name="more" default="false"/>', ""), "tail.launch": launch()})
    directory = make({"part.launch": launch(NODE.format(name="a"), '<remap from="x" to="y"/>')})
    assert brief(findings(directory, "--select", "LL602")) == ["part.launch:3 warning LL602"]


def test_a_mistake_in_what_is_never_evaluated_is_no_more_than_a_warning(make: Make) -> None:
    off = '<group if="$(eval 1 == 2)"><node name="a" pkg="demo"/></group>'
    directory = make({"off.launch": launch(off, '<node name="b" pkg="demo"/>')})
    found = findings(directory, "--select", "LL105")
    assert brief(found) == ["off.launch:2 warning LL105", "off.launch:3 error LL105"]
    assert found[0]["notes"][-1] == "no configuration that was found evaluates this element, so that nobody is stopped by it yet"


def test_it_is_an_error_as_soon_as_one_entry_evaluates_it(make: Make) -> None:
    part = launch('<arg name="on" default="false"/>', '<group if="$(eval arg(\'on\') == 7)"><node name="a" pkg="demo"/></group>')
    directory = make({"part.launch": part.replace("== 7", "== 8 and False")})
    assert brief(findings(directory, "--select", "LL105")) == ["part.launch:3 warning LL105"]
    directory = make({"part.launch": part, "on.launch": launch(include("part", "on=7"))})
    assert brief(findings(directory, "--select", "LL105")) == ["part.launch:3 error LL105"]


def test_a_file_that_others_start_is_no_entry_file(make: Make) -> None:
    directory = make(
        {"part.launch": launch('<arg name="robot"/>', NODE.format(name="$(arg robot)")), "all.launch": launch(include("part", "robot=a"))}
    )
    assert findings(directory) == []
    assert brief(findings(directory, "part.launch")) == ["part.launch:2 info LL202"], "alone it lacks its arg"
    assert findings(directory, "--arg", "unrelated:=1") == []


def test_a_circle_of_files_that_all_lack_args_is_told_of(make: Make) -> None:
    """Each is included by the other, but no file starts either of them."""
    needs = '<arg name="robot"/>'
    directory = make(
        {
            "one.launch": launch(needs, NODE.format(name="$(arg robot)"), include("two", "robot=a")),
            "two.launch": launch(needs, NODE.format(name="$(arg robot)2"), include("one", "robot=a")),
        }
    )
    assert "LL402" in [each["rule"] for each in findings(directory)]


def test_what_one_include_leaves_out_is_one_finding(make: Make) -> None:
    directory = make(
        {
            "part.launch": launch('<arg name="x"/>', '<arg name="y"/>', '<param name="p" value="$(arg x)$(arg y)"/>'),
            "all.launch": launch(include("part")),
        }
    )
    found = findings(directory, "--select", "LL404")
    assert brief(found) == ["all.launch:2 error LL404"]
    assert found[0]["message"] == "part.launch needs the args x, y, which are not passed"


def test_worse_of_two_ways_to_say_the_same_counts(make: Make) -> None:
    """Under a condition of unknown value it may never come to pass; another entry shows that it does."""
    directory = make(
        {
            "maybe.launch": launch(f'<group if="$(env MAYBE)">{include("twice")}</group>'),
            "sure.launch": launch("", include("twice")),
            "twice.launch": launch('<param name="p" value="$(arg missing)"/>'),
        }
    )
    found = [each for each in findings(directory) if each["rule"] == "LL201"]
    assert [each["severity"] for each in findings(directory, "maybe.launch") if each["rule"] == "LL201"] == ["warning"]
    assert [each["severity"] for each in found] == ["error"]
