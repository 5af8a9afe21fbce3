"""What a process gets on its command line."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest

from launchlint.graph.command_line import command_line, plain_value, split_options
from launchlint.graph.connections import ConnectionGraph
from launchlint.graph.names import Rule
from launchlint.model import Node
from tests.graph.sample import graph


def node(directory: Path, args: str, inside: str = "") -> Node:
    found: ConnectionGraph = graph(directory, f'<node pkg="p" type="t" name="n" args="{args}">{inside}</node>', {})
    return found.launch.nodes[0]


@pytest.mark.parametrize(
    ("args", "words", "rules", "params"),
    [
        ("", (), [], {}),
        ("a b", ("a", "b"), [], {}),
        ("'a b' c", ("a b", "c"), [], {}),
        ("a b:=c d", ("a", "d"), [("b", "c")], {}),
        ("b:=c b:=d", (), [("b", "c"), ("b", "d")], {}),
        ("~b:=/c", (), [("~b", "/c")], {}),
        ("_rate:=5 _name:=five", (), [], {"rate": 5, "name": "five"}),
        ("_rate:=5 _rate:=6", (), [], {"rate": 6}),
        ("_a/b:=1", (), [], {"a/b": 1}),
        ("__name:=x __log:=y", (), [], {}),
        ("b:= :=c", (), [], {}),
        ("-1 --x=y _x=y", ("-1", "--x=y", "_x=y"), [], {}),
    ],
)
def test_words_remappings_and_params(
    args: str, words: tuple[str, ...], rules: list[tuple[str, str]], params: dict[str, Any], tmp_path: Path
) -> None:
    line = command_line(node(tmp_path, args))
    assert (line.words, [(rule.source, rule.target) for rule in line.rules], line.params, line.known) == (words, rules, params, True)


def test_remaps_come_after_the_args(tmp_path: Path) -> None:
    found = node(tmp_path, "a:=b", '<remap from="a" to="c"/>')
    assert command_line(found).rules == (Rule("a", "b"), Rule("a", "c", found.remaps[0]))


def test_a_namespace_in_the_args(tmp_path: Path) -> None:
    assert (command_line(node(tmp_path, "__ns:=x a")).namespace, command_line(node(tmp_path, "a")).namespace) == ("x", None)


@pytest.mark.parametrize("args", ["'a", "$(optenv NOT_HERE)'"])
def test_args_that_no_shell_reads(args: str, tmp_path: Path) -> None:
    line = command_line(node(tmp_path, args, '<remap from="a" to="b"/>'))
    assert (line.words, line.known, [rule.target for rule in line.rules]) == ((), False, ["b"])


@pytest.mark.parametrize(
    ("text", "value"),
    [
        ("5", 5), ("-5", -5), ("+5", 5), ("--5", "--5"), ("5.5", 5.5), ("1e3", 1000.0), ("true", True), ("False", False), ("TRUE", True),
        ("tRue", "tRue"), ("", ""), ("1_000", "1_000"), ("٣", "٣"), (" 5", " 5"), ("0x10", "0x10"), ("yes", "yes"), ("/a", "/a"),
    ],
)  # fmt: skip
def test_plain_value(text: str, value: Any) -> None:
    found = plain_value(text)
    assert (found, type(found)) == (value, type(value))


@pytest.mark.parametrize(
    ("words", "options", "positional", "found"),
    [
        ("a -r 5", None, "a -r 5", {}),
        ("-r 5 a", {"-r": 1}, "a", {"-r": "5"}),
        ("--rate=5 a", {"--rate": 1}, "a", {"--rate": "5"}),
        ("-1 a", {"-1": 0}, "a", {"-1": True}),
        ("-1 a", {"-r": 1}, "-1 a", {}),
        ("-.5 a", {"-r": 1}, "-.5 a", {}),
        ("-x a", {"-r": 1}, "a", {"-x": True}),
        ("-p 1 2 a", {"-p": 2}, "a", {"-p": ["1", "2"]}),
        ("a -p 1", {"-p": 2}, "a", {"-p": "1"}),
        ("a -p", {"-p": 1}, "a", {"-p": []}),
        ("-- -r 5", {"-r": 1}, "-r 5", {}),
        ("- a", {"-r": 1}, "- a", {}),
    ],
)
def test_options(words: str, options: dict[str, int] | None, positional: str, found: dict[str, Any]) -> None:
    assert split_options(tuple(words.split()), options) == (tuple(positional.split()), found)
