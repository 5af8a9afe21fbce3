"""Splitting into words: as shlex does, and fast."""

from __future__ import annotations

import shlex

import pytest
from hypothesis import example, given
from hypothesis import strategies as st

from launchlint.words import split_words


def by_shlex(text: str) -> list[str] | str:
    try:
        return shlex.split(text)
    except ValueError as error:
        return str(error)


def ours(text: str) -> list[str] | str:
    try:
        return split_words(text)
    except ValueError as error:
        return str(error)


@given(st.text(alphabet=" \t\n\r'\"\\ab#$`\u00a0\u2003", max_size=14))
@example('a \'b c\' "d \\" e" f\\ g')
@example("'' \"\"")
@example('a"b\\')
@example("'a\\")
@example('a\\\nb "c\\\nd"')
def test_as_shlex_does(text: str) -> None:
    assert ours(text) == by_shlex(text)


@pytest.mark.parametrize("text", ["x" * 1_000_000, "x " * 500_000, '"' + "\\a" * 500_000, "'a'" * 300_000, "\\ " * 500_000])
def test_a_megabyte_ends(text: str) -> None:
    """Each of these took minutes with shlex; a test run that does not come back is how this one fails."""
    assert len("".join(ours(text))) > 15
