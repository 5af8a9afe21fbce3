"""No regular expression takes time by the square of what it reads: that would not be seen by counting calls."""

from __future__ import annotations

import re

from tests.growth.patterns import MOST_SECONDS, Found, patterns, slowest

TEXTS = 8
"""For each expression; ``python -m tests.growth.patterns`` tries more."""

BOUNDED = {"launchlint.rules.judging.template._TO_FILL_IN": "values of up to 200 characters"}
"""What is asked of short texts only."""


def test_those_of_launchlint() -> None:
    tried = 0
    slow = []
    for found in patterns():
        tried += 1
        if found.place in BOUNDED:
            continue
        seconds, text = slowest(found, TEXTS)
        if seconds >= MOST_SECONDS:
            slow.append(f"{found.place}: {text}")
    assert tried > 500
    assert slow == []


def test_one_that_does_is_found() -> None:
    for written in (r"\w+\d\s*\(", r"<!--.*?-->", r"(\w+)\s*$"):
        assert slowest(Found("", 0, "", re.compile(written), ("finditer",)), TEXTS)[0] >= MOST_SECONDS
    assert slowest(Found("", 0, "", re.compile(r"[0-9]+\.?[0-9]*"), ("fullmatch",)), TEXTS)[0] >= MOST_SECONDS
    assert slowest(Found("", 0, "", re.compile(r"\b\w+\s*\("), ("finditer",)), TEXTS)[0] < MOST_SECONDS
