"""Text to typed value, beside what roslaunch's own convert_value says."""

from __future__ import annotations

import json
import subprocess

import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from launchlint.evaluate.expression.errors import UnknownValue
from launchlint.evaluate.ros1.typed_values import convert_value
from launchlint.evaluate.ros1.values import type_name

REFUSED = "(refused)"

# text, type, repr of the value
TABLE = (
    ("5", "auto", "5"),
    ("-3", "auto", "-3"),
    (" 7 ", "auto", "7"),
    ("+7", "auto", "7"),
    ("007", "auto", "7"),
    ("٣", "auto", "3"),
    ("1_000", "auto", "'1_000'"),
    ("1_0.5", "auto", "10.5"),
    ("0x1F", "auto", "'0x1F'"),
    ("1e5", "auto", "'1e5'"),
    ("1.e5", "auto", "100000.0"),
    (".5", "auto", "0.5"),
    ("5.", "auto", "5.0"),
    ("1.2.3", "auto", "'1.2.3'"),
    ("192.168", "auto", "192.168"),
    ("1,5", "auto", "'1,5'"),
    ("nan", "auto", "'nan'"),
    ("true", "auto", "True"),
    ("FALSE", "auto", "False"),
    (" true", "auto", "' true'"),
    ("yes", "auto", "'yes'"),
    ("", "auto", "''"),
    ("9" * 4300, "auto", "9" * 4300),
    ("9" * 4301, "auto", repr("9" * 4301)),
    ("abc", "AUTO", "'abc'"),
    ("5", "str", "'5'"),
    (" 5 ", "String", "' 5 '"),
    ("5", "int", "5"),
    ("1_000", "int", "1000"),
    ("5.0", "int", REFUSED),
    ("", "int", REFUSED),
    ("0x10", "int", REFUSED),
    ("9" * 4301, "int", REFUSED),
    ("5", "double", "5.0"),
    ("1e5", "double", "100000.0"),
    ("inf", "double", "inf"),
    ("nan", "double", "nan"),
    ("1,5", "double", REFUSED),
    ("true", "bool", "True"),
    (" 1 ", "boolean", "True"),
    ("0", "bool", "False"),
    ("yes", "bool", REFUSED),
    ("", "bool", REFUSED),
    ("[1, 2]", "yaml", "[1, 2]"),
    ("{a: {b: 1}, 2: x}", "yaml", "{'a': {'b': 1}, 2: 'x'}"),
    ("deg(180)", "yaml", "'deg(180)'"),
    ("on", "yaml", "True"),
    ("", "yaml", "None"),
    ("[1, 2", "yaml", REFUSED),
    ("a: b: c", "yaml", REFUSED),
    ("\t", "yaml", REFUSED),
    ("5", "float", REFUSED),
    ("5", "", REFUSED),
    ("5", "integer", REFUSED),
)


def outcome(text: str, type_: str) -> str:
    try:
        return repr(convert_value(text, type_))
    except ValueError as error:
        return REFUSED if str(error) else "(refused without words)"


@pytest.mark.parametrize(("text", "type_", "expected"), TABLE, ids=[f"{text[:20]}-{type_}" for text, type_, _ in TABLE])
def test_value(text: str, type_: str, expected: str) -> None:
    assert outcome(text, type_) == expected


@pytest.mark.parametrize(
    ("text", "type_", "message"),
    [
        ("5.0", "int", "'5.0' is not a whole number, which type='int' needs"),
        ("fast", "double", "'fast' is not a number, which type='double' needs"),
        ("yes", "Bool", "'yes' is neither true, false, 1 nor 0, which type='bool' needs"),
        ("5", "float", "'float' is not a parameter type; roslaunch knows auto, str, string, int, double, bool, boolean, yaml"),
        (
            "[1",
            "yaml",
            (
                "'[1' is not the YAML that type='yaml' needs: a list that starts with [ lacks a comma or its ] here "
                "(YAML says: expected ',' or ']', but got '<stream end>')"
            ),
        ),
        ("x" * 100, "int", "'" + "x" * 57 + "...' is not a whole number, which type='int' needs"),
    ],
)
def test_message_is_in_plain_words(text: str, type_: str, message: str) -> None:
    with pytest.raises(ValueError, match=r".") as raised:
        convert_value(text, type_)
    assert str(raised.value) == message


def test_yaml_beyond_the_bounds_is_unknown() -> None:
    with pytest.raises(UnknownValue, match="nested more than 100 deep"):
        convert_value("[" * 5000, "yaml")


def test_type_names() -> None:
    values = (True, 1, 1.5, "x", [1], (1,), {"a": 1}, None, b"x", {1})
    assert [type_name(value) for value in values] == ["bool", "int", "double", "str", "list", "list", "dict", "null", "binary", "set"]


REAL = """
import json, sys
from roslaunch.loader import convert_value
answers = []
for text, kind in json.load(sys.stdin):
    try:
        answers.append(repr(convert_value(text, kind)))
    except Exception as error:
        answers.append("(refused)")
json.dump(answers, sys.stdout)
"""


def real_outcomes(ros_python: str, cases: list[tuple[str, str]]) -> list[str]:
    run = subprocess.run([ros_python, "-c", REAL], input=json.dumps(cases), capture_output=True, text=True, timeout=120, check=True)
    answers: list[str] = json.loads(run.stdout)
    return answers


@pytest.mark.ros
def test_table_is_what_roslaunch_says(ros_python: str) -> None:
    cases = [(text, type_) for text, type_, _ in TABLE]
    assert real_outcomes(ros_python, cases) == [expected for _, _, expected in TABLE]


TEXTS = st.one_of(st.text(max_size=8), st.text("0123456789._+-eE tTrRuUaAlLsSfxXinN\u0661½²", max_size=8))
TYPES = st.sampled_from(["auto", "int", "double", "bool", "str", "Auto", "BOOLEAN", "String", "number"])


@pytest.mark.ros
@settings(max_examples=5, deadline=None, suppress_health_check=list(HealthCheck))
@given(cases=st.lists(st.tuples(TEXTS, TYPES), min_size=100, max_size=300))
def test_random_texts_are_what_roslaunch_says(ros_python: str, cases: list[tuple[str, str]]) -> None:
    assert [outcome(text, type_) for text, type_ in cases] == real_outcomes(ros_python, cases)
