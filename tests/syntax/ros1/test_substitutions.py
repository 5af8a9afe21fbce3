"""Values taken apart as roslaunch does it, with the place of every part."""

from __future__ import annotations

import time

import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from launchlint.syntax.parse import parse as parse_file
from launchlint.syntax.parts import Expression, Literal, Malformed, Part, Substitution
from launchlint.syntax.ros1.substitutions import (
    MOST_PARTS,
    expression_in,
    is_computed,
    is_plain,
    only_arg,
    parse,
    parse_again,
    parts_of,
    slip,
)


def shown(part: Part) -> tuple[str, ...]:
    """A part in short: what it is, what is written, its words or why it is refused."""
    match part:
        case Literal():
            return ("text", part.text)
        case Substitution():
            return ("put in", part.text, *(word.text for word in part.words))
        case Expression():
            return ("expression", part.text, part.code)
        case Malformed():
            return (part.kind, part.text, *(word.text for word in part.words))


CASES: dict[str, list[tuple[str, ...]]] = {
    "": [],
    "map": [("text", "map")],
    "(a)": [("text", "(a)")],
    "$5": [("text", "$5")],
    "$(arg x)": [("put in", "$(arg x)", "arg", "x")],
    "$( arg  x )": [("put in", "$( arg  x )", "arg", "x")],
    "$(arg\tx)": [("put in", "$(arg\tx)", "arg\tx")],
    "$(find a)/b.yaml $(dirname)/c": [
        ("put in", "$(find a)", "find", "a"),
        ("text", "/b.yaml "),
        ("put in", "$(dirname)", "dirname"),
        ("text", "/c"),
    ],
    "$(optenv A b c)": [("put in", "$(optenv A b c)", "optenv", "A", "b", "c")],
    "$(nothing x)": [("put in", "$(nothing x)", "nothing", "x")],
    "$( )": [("put in", "$( )")],
    "$()": [("text", "$()")],
    "$$(arg x)": [("text", "$"), ("put in", "$(arg x)", "arg", "x")],
    # An expression fills the value; else it is a command that roslaunch does not know.
    "$(eval arg('x') + (1))": [("expression", "$(eval arg('x') + (1))", "arg('x') + (1)")],
    "$(eval a) or $(eval b)": [("expression", "$(eval a) or $(eval b)", "a) or $(eval b")],
    "$(eval x) ": [("put in", "$(eval x)", "eval", "x"), ("text", " ")],
    " $(eval x)": [("text", " "), ("put in", "$(eval x)", "eval", "x")],
    "$(eval f(x)) ": [("parenthesis", "$(eval f", "eval", "f"), ("text", "(x)) ")],
    # Refused: roslaunch stops at the second dollar, at the parenthesis.
    "$(find $(arg x))/y": [("nested", "$(find ", "find"), ("put in", "$(arg x)", "arg", "x"), ("text", ")/y")],
    "$(find (a))": [("parenthesis", "$(find ", "find"), ("text", "(a))")],
    "$(($": [("parenthesis", "$("), ("text", "($")],
    # They stay in the value as they are.
    "$(arg x": [("like", "$(arg x", "arg", "x")],
    "$(arg x}/y": [("like", "$(arg x}", "arg", "x"), ("text", "/y")],
    "$(eval x": [("like", "$(eval x", "eval", "x")],
    "$(else x": [("text", "$(else x")],
    "${arg x}": [("like", "${arg x}", "arg", "x")],
    "${HOME}": [("text", "${HOME}")],
    "$[arg x]": [("like", "$[arg x]", "arg", "x")],
    "$ (find a)/b": [("like", "$ (find a)", "find", "a"), ("text", "/b")],
    "a $arg x) b": [("text", "a "), ("like", "$arg x)", "arg", "x"), ("text", " b")],
    "$arg(x)": [("like", "$arg(x)", "arg", "x")],
    "(arg x) (arg y)": [("like", "(arg x)", "arg", "x"), ("text", " "), ("like", "(arg y)", "arg", "y")],
    "$(arg x)(arg y)": [("put in", "$(arg x)", "arg", "x"), ("like", "(arg y)", "arg", "y")],
    "f(arg x)": [("text", "f(arg x)")],
    # A parenthesis too many belongs to no bracket of the text.
    "$(arg x))": [("put in", "$(arg x)", "arg", "x"), ("extra", ")")],
    "$(arg x)), $(arg y))": [
        ("put in", "$(arg x)", "arg", "x"),
        ("extra", ")"),
        ("text", ", "),
        ("put in", "$(arg y)", "arg", "y"),
        ("text", ")"),
    ],
    "deg($(arg x))": [("text", "deg("), ("put in", "$(arg x)", "arg", "x"), ("text", ")")],
    "$(arg x) )": [("put in", "$(arg x)", "arg", "x"), ("text", " )")],
}


@pytest.mark.parametrize("text", CASES)
def test_parts(text: str) -> None:
    assert [shown(part) for part in parse(text).parts] == CASES[text]


PROPERTY = settings(deadline=None, suppress_health_check=[HealthCheck.too_slow])


def texts() -> st.SearchStrategy[str]:
    pieces = ["$", "(", ")", "$(", "{", "}", "[", "]", " ", "\n", "arg", "find", "eval", "env", "x", "-", "/", "$(arg x)", "$(eval ", "$()"]
    return st.lists(st.sampled_from(pieces), max_size=12).map("".join)


@PROPERTY
@given(texts())
def test_parts_joined_are_the_text_and_every_part_stands_where_it_says(text: str) -> None:
    for parts in (parse(text), parse_again(text)):
        assert "".join(part.text for part in parts.parts) == parts.text == text
        assert all(part.text for part in parts.parts)
        at = 0
        for part in parts.parts:
            assert (part.start, part.end) == (at, at + len(part.text))
            at = part.end
            for word in part.words if isinstance(part, (Substitution, Malformed)) else ():
                assert word.text == text[word.start : word.end]
                assert part.start < word.start < word.end <= part.end


@PROPERTY
@given(texts())
def test_plain_text_is_one_piece_of_text(text: str) -> None:
    if is_plain(text):
        assert parse(text).parts == ((Literal(text, 0, len(text)),) if text else ())


def test_what_is_left_after_the_first_reading_is_no_expression() -> None:
    assert [shown(part) for part in parse_again("$(eval 1)").parts] == [("put in", "$(eval 1)", "eval", "1")]


def test_the_whole_value() -> None:
    assert only_arg(parse("$(arg x)")) == only_arg(parse("$( arg x)")) == "x"
    assert [only_arg(parse(text)) for text in ("x", "$(arg x) ", "$(env x)", "$(arg x y)", "$(arg)", "$(eval x)", "")] == [""] * 7
    assert [expression_in(text) for text in ("$(eval x + 1)", "$(eval x) ", "$(arg x)")] == ["x + 1", None, None]
    expression = parse("$(eval x + 1)").expression
    assert expression is not None
    assert expression.text[expression.code_start : expression.code_start + len(expression.code)] == expression.code


def test_what_is_refused_is_the_first_of_them() -> None:
    parts = parse("$(find $(arg (x)))")
    assert parts.refused is parts.parts[0]
    assert parts.refused.refused == "a substitution cannot stand inside another one"


def test_names_and_the_text_beside() -> None:
    parts = parse("$(find a)/$(arg x)-$(arg y z)$(arg x)_${arg q}")
    assert list(parts.names("arg")) == ["x", "x"]
    assert [part.only for part in parts.substitutions()] == ["a", "x", "", "x"]
    assert parts.beside() == "/-_${arg q}"
    assert parts.beside("*") == "*/*-**_${arg q}"
    assert parts.filled() == f"{'.' * 9}/{'.' * 8}-{'.' * 18}_${{arg q}}"
    assert parts.computed
    assert not parse("$(arg x").computed


def test_a_slip_comes_before_a_parenthesis_too_many() -> None:
    told = {text: slip(parse(text)) for text in ("$(arg x)) ${arg y}", "$(arg x)) y", "$(find $(arg x))", "$(arg x)")}
    assert [None if found is None else (found.kind, found.start, found.end) for found in told.values()] == [
        ("like", 10, 18),
        ("extra", 8, 9),
        None,
        None,
    ]


def test_places_in_a_file_with_references() -> None:
    file = '<!DOCTYPE launch [<!ENTITY at "$(find a)">]>\n<launch><x v="&quot;$(arg &#120;)&quot; &at;/b"/></launch>'
    document = parse_file(file.encode(), "a.launch")
    attribute = document.elements[1].attributes["v"]
    parts = parts_of(attribute)
    assert parts is parts_of(attribute)
    assert is_computed(attribute)
    spans = [attribute.span_of(part.start, part.end) for part in parts.parts]
    assert [file[start:end] for start, end in spans] == ["&quot;", "$(arg &#120;)", "&quot; ", "&at;", "/b"]
    (found, _) = parts.substitutions()
    assert [file[slice(*attribute.span_of(word.start, word.end))] for word in found.words] == ["arg", "&#120;"]


@pytest.mark.parametrize(
    "piece",
    ["$(", "$(arg ", "$(arg x) ", "$(arg x))", "$ ", "${arg ", "$arg a ", "$arg(", "(arg ", "$()", "$(eval x ", "a ", "\n$(find a"],
)
def test_time_grows_with_the_length(piece: str) -> None:
    """What is quadratic takes minutes for a megabyte; and so much of one value is kept that memory holds it."""
    text = piece * (1_000_000 // len(piece))
    started = time.process_time()
    parts = parse(text)
    assert time.process_time() - started < 10
    assert "".join(part.text for part in parts.parts) == text
    assert len(parts.parts) < 3 * MOST_PARTS
