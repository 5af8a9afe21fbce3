"""YAML with places: what stands where, whose rules tell the scalars, and what is too much."""

from __future__ import annotations

import pytest

from launchlint.yaml.refusals import YamlError
from launchlint.yaml.tree import MAPPING, SEQUENCE, STR, Node, Reader, Scalars, YamlBeyond, parse

READER = Reader("the reader")
TEXT = """\
# a launch file
launch:
- node: {pkg: demo, exec: "say: hi", on: yes}   # in braces
- arg: &again
    name: ä
    default:
- *again
"""


def leaves(node: Node | None, text: str) -> list[tuple[str, str, str]]:
    """What is written for each scalar, its value and its tag; that of an alias again."""
    if node is None:
        return []
    if node.kind == SEQUENCE:
        return [each for item in node.value for each in leaves(item, text)]
    if node.kind == MAPPING:
        return [each for pair in node.value for item in pair for each in leaves(item, text)]
    return [(text[node.start : node.end], node.value, node.tag.rpartition(":")[2])]


@pytest.mark.parametrize("pure", [True, False])
def test_every_key_and_value_has_its_place(pure: bool) -> None:
    argument = [("name", "name", "str"), ("ä", "ä", "str"), ("default", "default", "str"), ("", "", "null")]
    assert leaves(parse(TEXT, READER._replace(pure=pure)).root, TEXT) == [
        ("launch", "launch", "str"),
        ("node", "node", "str"),
        ("pkg", "pkg", "str"),
        ("demo", "demo", "str"),
        ("exec", "exec", "str"),
        ('"say: hi"', "say: hi", "str"),
        ("on", "on", "bool"),
        ("yes", "yes", "bool"),
        ("arg", "arg", "str"),
        *argument,
        *argument,
    ]


def test_a_key_that_stands_twice_stands_twice_in_the_tree() -> None:
    root = parse("a: 1\na: 2\n", READER).root
    assert root is not None
    assert [(key.value, key.start, value.value) for key, value in root.value] == [("a", 0, "1"), ("a", 5, "2")]


def test_the_caller_says_what_a_plain_scalar_is() -> None:
    def words() -> Scalars:
        return lambda text: "!number" if text.isdecimal() else STR

    text = "[yes, 12, '12', 0x1f]"
    assert leaves(parse(text, READER._replace(scalars=words)).root, text) == [
        ("yes", "yes", "str"),
        ("12", "12", "!number"),
        ("'12'", "12", "str"),
        ("0x1f", "0x1f", "str"),
    ]


@pytest.mark.parametrize(
    ("text", "kind", "offset"),
    [
        ("a: *b", "anchor", 3),
        ("a: &b 1\nc: &b 2", "anchor", 11),
        ("a: 1\n---\nb: 2", "documents", 5),
        ("a: !x 1", "tag", 3),
        ("a: !x [1]", "tag", 3),
        ("a: b: c", "syntax", 4),
        ("a: \0", "character", 3),
    ],
)
def test_what_is_refused(text: str, kind: str, offset: int) -> None:
    with pytest.raises(YamlError) as caught:
        parse(text, READER._replace(tags=frozenset()))
    assert (caught.value.kind, caught.value.offset) == (kind, offset)


def test_tags_are_the_callers_business() -> None:
    root = parse("!x 1", READER).root
    assert root is not None
    assert root.tag == "!x"


@pytest.mark.parametrize(
    ("text", "bounds", "offset"),
    [
        ("[[[1]]]", {"deepest": 2}, 2),
        ("[" * 3_000, {"deepest": 2}, 2),
        ("[" * 3_000, {"deepest": 2, "pure": False}, 2),  # libyaml may refuse it before it says what comes first
        ("a: &a [1, 2]\nb: [*a, *a]", {"written_out": 5}, 16),
        ("a: 12345", {"longest": 7}, 0),
        ("a: &b [*b]", {}, 7),
    ],
)
def test_what_is_too_much(text: str, bounds: dict[str, int], offset: int) -> None:
    with pytest.raises(YamlBeyond) as caught:
        parse(text, READER._replace(**bounds))
    assert caught.value.offset == offset


@pytest.mark.parametrize(
    ("text", "at", "words"),
    [
        ('- a: "x\n  b: 1\n- a: "y"\n', 5, "ends in line 3"),
        ('- {a: "x}\n- {a: "y"}\n', 6, "ends in line 2"),
        ("- a: 'x\n- b: 1\n", 5, "never closed"),
    ],
)
def test_the_quote_that_lacks_its_other_one_is_named(text: str, at: int, words: str) -> None:
    with pytest.raises(YamlError) as raised:
        parse(text, READER)
    assert raised.value.offset == at
    assert words in raised.value.message


def test_a_text_in_quotes_of_several_lines_is_not_blamed_for_what_stands_far_behind_it() -> None:
    text = '- a: "x\n  y"\n- {b: 1, c: 2\n- d: 1\n'
    with pytest.raises(YamlError) as raised:
        parse(text, READER)
    assert "quotes" not in raised.value.message
