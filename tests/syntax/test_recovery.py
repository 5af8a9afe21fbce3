"""Texts that are being written: what is half written is left out, and all else keeps its meaning and its place."""

from __future__ import annotations

import random
import time

import pytest

from launchlint.syntax.parse import parse
from launchlint.syntax.problems import MalformedXml
from launchlint.syntax.recovery import MOST_EDITS, changed_from, is_readable, recovered, recovered_xml

BEFORE = '<launch>\n  <arg name="a" default="1"/>\n'
AFTER = '\n  <group ns="g">\n    <node name="n" pkg="p" type="t">\n      <param name="x" value="y"/>\n    </node>\n  </group>\n</launch>\n'


@pytest.mark.parametrize(
    ("line", "left"),
    [
        ('  <remap from="scan" to="$(arg ', '<remap from="scan"/>'),
        ('  <remap from="scan" to="$(arg x)/>', '<remap from="scan"/>'),
        ('  <node name="m" pkg="p type="t"/>', '<node name="m" type="t"/>'),
        ('  <node name="m" pkg=', '<node name="m"/>'),
        ("  <node", "<node/>"),
        ("  <no", "<no/>"),
        ("  <", ""),
        ("  </", ""),
        ("  </group>", ""),
        ('  <group ns="h">', '<group ns="h"></group>'),
        ('  <param name="a" value="x & y"/>', '<param name="a" value="x &amp; y"/>'),
        ('  <param name="a" name="b"/>', '<param name="a"/>'),
        ("  <!-- half", ""),
    ],
)
def test_a_half_written_line_loses_only_what_it_must(line: str, left: str) -> None:
    text = BEFORE + line + AFTER
    found = recovered_xml(text)
    lines = [each.strip() for each in found.text.split("\n")]
    assert lines[2] == left or (left and (lines[2] + lines[3]).startswith(left))
    assert is_readable(found.text, "a.launch")
    document = parse(found.text.encode(), "a.launch")
    kept = [(each.tag, each.depth) for each in document.elements if found.back(each.span.start) >= len(BEFORE + line)]
    assert kept == [("group", 1), ("node", 2), ("param", 3)]
    for element in document.elements:
        start = found.back(element.span.start)
        assert text.startswith("<", start)
        assert found.back(found.forth(start)) == start


def test_a_text_that_can_be_read_stays_as_it_is() -> None:
    assert recovered_xml(BEFORE + AFTER).edits == ()


def test_lines_of_yaml_and_python_are_left_out() -> None:
    assert recovered("launch:\n- arg:\n    name: a\n- node: {pkg: [\n", "a.launch.yaml").text == "launch:\n- arg:\n    name: a\n\n"
    assert recovered("import a\nx = (\nb = 1\n", "a.launch.py").text == "import a\n\nb = 1\n"


def test_what_was_readable_stands_in_for_what_is_not() -> None:
    found = changed_from("abXYc", "abc")
    assert (found.text, found.forth(4), found.back(3)) == ("abc", 2, 5)


@pytest.mark.parametrize(
    "text",
    ["<a>", "<node ", "<!--", '"', "&", "</a>", "<a b=", "<a>\n ", ' a="b', "<launch><group>", "\n  <group>"],
)
def test_a_hostile_text_takes_no_longer_than_its_length(text: str) -> None:
    large = f"<launch>{text * 30_000}"
    start = time.process_time()
    found = recovered_xml(large)
    assert time.process_time() - start < 5
    assert len(found.edits) <= MOST_EDITS


def test_blanks_without_end_take_no_time() -> None:
    start = time.process_time()
    recovered_xml(f"<launch><a {' ' * 200_000}<b/>")
    assert time.process_time() - start < 5


def test_any_slip_leaves_something_that_can_be_read() -> None:
    chance = random.Random(7)
    text = BEFORE + AFTER
    good = 0
    for _ in range(400):
        at = chance.randrange(len(text))
        slip = chance.choice(["<", '"', "<node ", 'to="$(arg ', "</", "&", " name=", ">", "<group>", "<!--", ""])
        found = recovered_xml(text[:at] + slip + text[at + (not slip) :])
        problems = parse(found.text.encode(), "a.launch").problems
        good += not any(isinstance(each, MalformedXml) for each in problems)
    assert good >= 396
