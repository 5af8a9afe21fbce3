"""Numbers and what they count."""

from __future__ import annotations

import pytest

from launchlint.plural import counted


@pytest.mark.parametrize(
    ("number", "words", "said"),
    [
        (0, ("node",), "0 nodes"),
        (1, ("node",), "1 node"),
        (2, ("node",), "2 nodes"),
        (1, ("process", "processes"), "1 process"),
        (3, ("process", "processes"), "3 processes"),
        (1234, ("file",), "1234 files"),
    ],
)
def test_counted(number: int, words: tuple[str, ...], said: str) -> None:
    assert counted(number, *words) == said


def test_thousands_may_be_set_apart() -> None:
    assert counted(1234, "file", thousands=",") == "1,234 files"
