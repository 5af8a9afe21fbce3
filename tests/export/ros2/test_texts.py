r"""Texts written back: what is read of them again says the same, however hostile they are."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from launchlint.export.ros2.scalars import yaml
from launchlint.export.ros2.texts import CannotWrite, TextWriter
from launchlint.source import Place, Source, Span
from launchlint.syntax.ros2.description import Substitution, Text
from launchlint.syntax.ros2.tables import distribution

NOWHERE = Place(Source("", ""), Span(0, 0))
WRITER = TextWriter(distribution("jazzy"))


def text(*pieces: str | Substitution) -> Text:
    return Text(pieces, NOWHERE)


def var(*words: Text) -> Substitution:
    return Substitution("var", words, NOWHERE)


def code(*pieces: str | Substitution) -> Substitution:
    return Substitution("eval", (text(*pieces),), NOWHERE)


X = var(text("x"))


@pytest.mark.parametrize(
    ("told", "written"),
    [
        (text(), ""),
        (text("a$b ${c}"), "a$b ${c}"),
        (text("C:\\new"), r"C:\\new"),
        (text("$(var x)"), r"\$(var x)"),
        (text("a", X, "b"), "a$(var x)b"),
        (text(var(text("x"), text())), "$(var x '')"),
        (text(var(text("x"), text("it's"))), '$(var x "it\'s")'),
        (text(code("'", X, "' == 'a b'")), "$(eval \"'$(var x)' == 'a b'\")"),
        (text(code("1+1")), "$(eval 1+1)"),
        (text(code("f(", X, ")")), "$(eval 'f($(var x))')"),
        (text(var(text("a", X), text("b c"))), "$(var a$(var x) 'b c')"),
    ],
)
def test_how_a_text_is_written(told: Text, written: str) -> None:
    assert WRITER.text(told) == written


@pytest.mark.parametrize(
    "told",
    [
        text("C:\\", X),  # the backslash would take the substitution for text
        text(code("a ", var(text("x"), text("b c")))),  # a blank in a word of a substitution inside quotes
        text(var(text("x"), text("y"), text("z"))),
        text(Substitution("path-join", (text("a"),), NOWHERE)),
    ],
)
def test_what_cannot_be_written(told: Text) -> None:
    with pytest.raises(CannotWrite):
        WRITER.text(told)


@pytest.mark.parametrize(
    ("words", "written"),
    [
        ((text("-d"), text("a b"), text()), "-d 'a b' ''"),
        ((text(X), text(X, "/y"), text("it's")), '$(var x) $(var x)/y "it\'s"'),
        ((text("--x"), text(), text(X)), "--x '' $(var x)"),
    ],
)
def test_how_a_command_line_is_written(words: tuple[Text, ...], written: str) -> None:
    assert WRITER.command_line(words) == written


HOSTILE = st.text(st.sampled_from("ab \t\n'\"\\$(){}[]:,#&<-%é\u2028\x07"), max_size=8)
DEEP = st.recursive(
    st.tuples(HOSTILE),
    lambda inner: st.lists(
        st.one_of(
            HOSTILE,
            st.builds(
                lambda words: Substitution("env", tuple(words), NOWHERE), st.lists(inner.map(lambda p: text(*p)), min_size=1, max_size=2)
            ),
        ),
        max_size=3,
    ).map(tuple),
    max_leaves=6,
)


@given(DEEP)
def test_hostile_texts_are_written_so_that_they_are_read_again_or_not_at_all(pieces: tuple[str | Substitution, ...]) -> None:
    try:
        written = WRITER.text(text(*pieces))  # reads it again, and refuses what is not the same
    except CannotWrite:
        return
    assert isinstance(written, str)


@given(HOSTILE)
def test_text_without_substitutions_can_always_be_written(literal: str) -> None:
    assert isinstance(WRITER.text(text(literal)), str)


@given(st.lists(st.text(st.sampled_from("ab \t'\"$é-/"), max_size=6), min_size=1, max_size=4))
def test_words_of_a_command_line_can_always_be_written(words: list[str]) -> None:
    assert isinstance(WRITER.command_line([text(each) for each in words]), str)


@given(st.one_of(HOSTILE, st.booleans(), st.integers(), st.floats(allow_nan=False), st.lists(HOSTILE, max_size=4)))
def test_yaml_reads_what_is_written(value: str | bool | int | float | list[str]) -> None:
    import yaml as pyyaml

    for document in (f"a: {yaml(value)}\n", f"- b:\n  - a: {yaml(value)}\n"):
        read = pyyaml.safe_load(document)
        assert (read["a"] if isinstance(read, dict) else read[0]["b"][0]["a"]) == value
