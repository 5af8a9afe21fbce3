"""Parameter files, as rcl reads and refuses them: keys, values, types, places."""

from __future__ import annotations

import hashlib
import json
import math
import os
from pathlib import Path
from typing import Any

import pytest

from launchlint.rcl import parameter_files
from launchlint.rcl.refused import Refused
from launchlint.rcl.table import Table
from launchlint.source import Source
from launchlint.yaml.events import read
from launchlint.yaml.tree import YamlBeyond
from tests.rcl.conftest import Answers


def table(text: str) -> Table:
    read = parameter_files.read(Source("params.yaml", text))
    assert isinstance(read, Table), read.reason
    return read


def values(text: str) -> dict[str, dict[str, tuple[str, Any]]]:
    return {key.name: {each.name: tuple(each.value) for each in key.parameters} for key in table(text).keys.values()}


def under(text: str) -> dict[str, tuple[str, Any]]:
    """The parameters of a node that has only these."""
    return values(f"n:\n  ros__parameters: {text}\n")["n"]


def test_keys_are_joined_and_keep_their_order() -> None:
    text = "b:\n  n:\n    ros__parameters: {x: 1}\n  m:\n    ros__parameters: {x: 2}\n/**:\n  ros__parameters: {x: 3}\n"
    assert list(values(text)) == ["b/n", "b/m", "/**"]


def test_names_of_parameters_are_joined() -> None:
    assert under("{a: {b: {c: 1}, d: 2}, e: 3}") == {"a.b.c": ("int", 1), "a.d": ("int", 2), "e": ("int", 3)}


@pytest.mark.parametrize(
    ("written", "type_", "value"),
    [
        ("1", "int", 1),
        ("+1", "int", 1),
        ("010", "int", 8),
        ("08", "double", 8.0),
        ("0x1F", "int", 31),
        ("0x1p3", "double", 8.0),
        ("9223372036854775808", "double", 2.0**63),
        ("1.", "double", 1.0),
        ("1e3", "double", 1000.0),
        ("1e999", "str", "1e999"),
        ("inf", "double", math.inf),
        ("-.inf", "double", -math.inf),
        ("infinite", "str", "infinite"),
        ("1_000", "str", "1_000"),
        ("0o10", "str", "0o10"),
        ("12:30", "str", "12:30"),
        ("y", "bool", True),
        ("Off", "bool", False),
        ("tRUE", "str", "tRUE"),
        ('"1"', "str", "1"),
        ("''", "str", ""),
        ("!!str 1", "str", "1"),
        ("[1, 2]", "int[]", (1, 2)),
        ("[[1, 2]]", "int[]", (1, 2)),
        ("[a, '1']", "str[]", ("a", "1")),
        ("[]", "none", None),
    ],
)
def test_what_a_value_is_taken_for(written: str, type_: str, value: Any) -> None:
    assert under(f"{{a: {written}}}") == {"a": (type_, value)}


def test_a_list_of_mappings_gives_one_list_with_a_longer_name() -> None:
    assert under("{a: [{b: 1}]}") == {"a.b": ("int[]", (1,))}


def test_a_parameter_that_is_set_twice_has_the_last_value_of_a_type_and_the_first_type() -> None:
    assert under("{a: 1, a: 2}") == {"a": ("int", 2)}
    assert under("{a: 1, a: 2.5}") == {"a": ("int", 1)}


def test_all_documents_count() -> None:
    assert values("n:\n  ros__parameters: {a: 1}\n---\nn:\n  ros__parameters: {b: 2}\n") == {"n": {"a": ("int", 1), "b": ("int", 2)}}


def test_places() -> None:
    text = "n:\n  ros__parameters:\n    a:\n      ä: [1, 2]\n    b: |\n      x\n"
    (key,) = table(text).keys.values()
    written = [each.written for each in key.parameters]
    assert [(text[slice(*each.name)], text[slice(*each.value)]) for each in written] == [("ä", "[1, 2]"), ("b", "|\n      x")]


@pytest.mark.parametrize(
    ("text", "line", "column", "reason"),
    [
        ("n:\n  a: 1\n", 2, 6, "a value stands here where a node name, or ros__parameters below one, must be"),
        ("n:\n  ros__parameters: {a: [1, 2.0]}\n", 2, 28, "the first is a whole number, this is a number with a point"),
        ("n:\n  ros__parameters:\n    a:\n", 3, 7, "a value is missing"),
        ("n:\n  ros__parameters: {a: &x 1, b: *x}\n", 2, 33, "rcl takes no aliases, and *x is one"),
        ("n:\n\tros__parameters: {a: 1}\n", 2, 1, "a tab stands here"),
        ("- a\n", 1, 1, "a list stands here where a name must be"),
        ("n: [a]\n", 1, 4, "a list stands outside of ros__parameters"),
        ("ros__parameters: {a: 1}\n", 1, 1, "ros__parameters must stand below the name of a node"),
        ("n-1:\n  ros__parameters: {a: 1}\n", 1, 1, "n-1 is no name of a node"),
        ("a//n:\n  ros__parameters: {a: 1}\n", 1, 1, "two slashes stand side by side"),
        ("n:\n  ros__parameters: 5\n", 2, 20, "ros__parameters must hold names with values, and has itself a value"),
    ],
)
def test_what_rcl_refuses_and_where(text: str, line: int, column: int, reason: str) -> None:
    source = Source("params.yaml", text)
    refused = parameter_files.read(source)
    assert isinstance(refused, Refused)
    assert reason in refused.reason
    assert source.position(refused.span.start) == (line, column)


def test_names_without_measure_are_given_up() -> None:
    deep = "".join(f"{'  ' * depth}n{'x' * 900}:\n" for depth in range(500))
    with pytest.raises(YamlBeyond):
        parameter_files.read(Source("params.yaml", deep))


@pytest.mark.parametrize(("text", "offset"), [("a: " + "[" * 3_000, 1_002), ("- " * 3_000, 2_000)])
def test_depth_without_measure_is_given_up(text: str, offset: int) -> None:
    with pytest.raises(YamlBeyond, match="nested more than 1000 deep") as beyond:
        list(read(text, "rcl"))
    assert abs(beyond.value.offset - offset) <= 4  # a level more or less, by the version of libyaml


def plain(value: Any) -> Any:
    """A value as the recorded answers write it."""
    if isinstance(value, tuple):
        return (
            {"sha1": hashlib.sha1(json.dumps(list(value)).encode()).hexdigest(), "len": len(value)}
            if len(value) > 400
            else [*map(plain, value)]
        )
    if isinstance(value, float) and not math.isfinite(value):
        return repr(value)
    if isinstance(value, str) and len(value) > 400:
        return {"sha1": hashlib.sha1(value.encode()).hexdigest(), "len": len(value)}
    return value


def test_recorded_answers(answers: Answers) -> None:
    corpus = Path(os.environ.get("LAUNCHLINT_ROS2_CORPUS", "")).resolve()
    recorded = [each for each in answers("paramfiles.visible.jsonl.xz") if (corpus / each["file"]).is_file()]
    if not recorded:
        pytest.skip("LAUNCHLINT_ROS2_CORPUS does not name the unpacked corpus of ROS 2")
    for answer in recorded:
        read = parameter_files.read(Source(answer["file"], (corpus / answer["file"]).read_bytes().decode("utf-8", "replace")))
        assert isinstance(read, Table) == answer["ok"], answer["file"]
        if isinstance(read, Table):
            found = [
                [key.name, {each.name: [each.value.type, plain(each.value.data)] for each in key.parameters}] for key in read.keys.values()
            ]
            assert json.dumps(found) == json.dumps(answer["nodes"]), answer["file"]
