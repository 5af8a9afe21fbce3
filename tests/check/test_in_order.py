"""What is in order in many entry files, in few groups."""

from __future__ import annotations

import pytest

from launchlint.check.in_order import InOrder, ReadOnce, Together, from_text, grouped, to_text
from launchlint.rules.rule import Fine

FINE = [
    Fine("LL507", "a.launch", 10),
    Fine("LL507", "a.launch", 2),
    Fine("LL612", "a.launch", 2, "topic\n2"),
    Fine("LL507", "b\n.launch", 2),
    Fine("LL612", "a.launch", 4, "topic\n2"),
]
GROUPS = (
    InOrder("LL507", "a.launch", "", frozenset((2, 10))),
    InOrder("LL612", "a.launch", "topic\n2", frozenset((2, 4))),
    InOrder("LL507", "b\n.launch", "", frozenset((2,))),
)


def test_groups() -> None:
    assert grouped(FINE) == GROUPS
    assert sorted(each for group in GROUPS for each in group.each) == sorted(FINE)


def test_texts_and_back() -> None:
    assert [from_text(to_text(group)) for group in GROUPS] == list(GROUPS)
    read = ReadOnce()
    assert read[to_text(GROUPS[0])] is read[to_text(GROUPS[0])]
    for text in ("", "LL507", "LL507\n1\n0", "LL507\n1\nx\na", "LL507\nx\n0\na"):
        with pytest.raises(ValueError):  # noqa: PT011 - whatever it says
            from_text(text)


def test_together() -> None:
    together = Together()
    together.add(GROUPS[:1])
    together.add((*GROUPS, InOrder("LL507", "a.launch", "", frozenset((3,)))))
    found = [(rule, path, start) for rule in ("LL507", "LL612") for path in ("a.launch", "b\n.launch") for start in range(12)]
    assert [each for each in found if together.has(*each)] == [
        ("LL507", "a.launch", 2),
        ("LL507", "a.launch", 3),
        ("LL507", "a.launch", 10),
        ("LL507", "b\n.launch", 2),
    ], "what has a topic is in order for what is said of that alone"
