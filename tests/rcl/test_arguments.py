"""A node's command line: what rcl takes from it, which parameters reach which node, and what it refuses."""

from __future__ import annotations

import pytest

from launchlint.rcl import arguments, parameter_files
from launchlint.rcl.arguments import CommandLine
from launchlint.rcl.refused import Refused
from launchlint.rcl.table import Table, overrides, reaches
from launchlint.source import Source, Span

FILES = {
    "exact.yaml": "n:\n  ros__parameters: {a: 1, b: 1}\n",
    "any.yaml": "/**:\n  ros__parameters: {a: 2, c: 2}\n",
    "bad.yaml": "n:\n  ros__parameters: {a: }\n",
}


def files(name: str, table: Table) -> Refused | None:
    return parameter_files.add(Source(name, FILES[name]), table)


def parsed(*words: str) -> CommandLine:
    line = arguments.parse(words, files)
    assert isinstance(line, CommandLine), line.reason
    return line


def test_what_is_for_ros_and_what_is_the_programs_own() -> None:
    line = parsed(
        "--x", "a:=b", "--ros-args", "-r", "c:=d", "-e", "/safe", "--log-level", "n:=debug", "--disable-stdout-logs", "--y", "--", "z"
    )
    assert (line.own, line.unknown, line.enclave, line.log_levels) == (("--x", "z"), ("--y",), "/safe", ("n:=debug",))
    assert [(rule.match, rule.replacement) for rule in line.rules] == [("a", "b"), ("c", "d")]


def test_a_key_that_came_first_is_overridden_by_one_that_came_later() -> None:
    found = {
        order: {name: value.data for name, value in overrides(parsed("--ros-args", *order).parameters, "/n").items()}
        for order in (
            ("--params-file", "exact.yaml", "--params-file", "any.yaml"),
            ("--params-file", "any.yaml", "--params-file", "exact.yaml"),
            ("-p", "a:=9", "--params-file", "exact.yaml", "-p", "a:=8"),
            ("--params-file", "exact.yaml", "-p", "n:a:=8"),
        )
    }
    assert list(found.values()) == [{"a": 2, "b": 1, "c": 2}, {"a": 1, "b": 1, "c": 2}, {"a": 1, "b": 1}, {"a": 8, "b": 1}]


@pytest.mark.parametrize(
    ("key", "name", "reached"),
    [
        ("/**", "/s/n", True),
        ("n", "/n", True),
        ("n", "/s/n", False),
        ("s/n", "/s/n", True),
        ("/*/n", "/s/n", True),
        ("/*/n", "/n", False),
        ("/**/n", "/n", True),
        ("/**/n", "/s/t/n", True),
        ("*", "/n", True),
        ("*", "/s/n", False),
        ("**", "/s/n", True),
        ("/s/*", "/s/t/n", False),
        ("/s/**", "/s/t/n", True),
        ("/s/**", "/t/n", False),
    ],
)
def test_which_nodes_a_key_reaches(key: str, name: str, reached: bool) -> None:
    assert reaches(key, name) == reached


@pytest.mark.parametrize(
    ("rule", "type_", "value"),
    [
        ("a:=1", "int", 1),
        ("a:=(1, 2)", "str", "(1, 2)"),
        ("a:=[1, 2]", "int[]", (1, 2)),
        ("a:=''", "str", ""),
        ("a:='1'", "str", "1"),
        ("a.b/c:=on", "bool", True),
        ("a:=# nothing", "none", None),
    ],
)
def test_rules_for_parameters(rule: str, type_: str, value: object) -> None:
    (found,) = overrides(parsed("--ros-args", "-p", rule).parameters, "/n").values()
    assert found == (type_, value)


@pytest.mark.parametrize(
    ("words", "word", "start", "reason"),
    [
        (("-p", "a:="), 2, 3, "the value is empty"),
        (("-p", "a-b:=1"), 2, 1, "a parameter's name cannot hold '-' here"),
        (("-p", "a.:=1"), 2, 2, "a parameter's name cannot end with a point"),
        (("-p", ":=1"), 2, 0, "a parameter's name is missing"),
        (("-p", "a"), 2, 1, ":= and a value are missing"),
        (("-p", "2d:=1"), 2, 0, "no part of a parameter's name can begin with a digit here"),
        (("-p", "a:={b: 1}"), 2, 3, "the value can be no mapping and no alias"),
        (("-p", "a:=[1, b]"), 2, 7, "all items of a list must be of one type: the first is a whole number, this is a text"),
        (("-p",), 1, 0, "-p is the last word, and what it is about must follow"),
        (("-r", "a:="), 2, 3, "the name is empty"),
        (("--log-level", "loud"), 2, 0, "the log levels are unset, debug, info, warn, error, fatal"),
        (("--log-level", ":=info"), 2, 0, "the name of the logger is empty"),
    ],
)
def test_what_rcl_refuses_and_where(words: tuple[str, ...], word: int, start: int, reason: str) -> None:
    refused = arguments.parse(("--ros-args", *words), files)
    assert isinstance(refused, Refused)
    assert (refused.word, refused.span.start, refused.reason) == (word, start, reason)


def test_a_file_that_is_refused_is_named_with_its_place() -> None:
    refused = arguments.parse(("--ros-args", "--params-file", "bad.yaml"), files)
    assert isinstance(refused, Refused)
    assert refused.source is not None
    assert (refused.word, refused.source.path, refused.span) == (2, "bad.yaml", Span(26, 26))
