"""Fingerprints: what they depend on, and what they do not."""

from __future__ import annotations

import pytest

from launchlint.finding import Finding, Location, Severity
from launchlint.fingerprint import fingerprint, fingerprints

HERE = Location("launch/a.launch", 3, 5, 3, 20, 40, 55, '    <node name="x"/>')
PLAIN = Finding("LL301", "duplicate-node-name", Severity.ERROR, HERE, "two nodes are named /x", element='<node name="x"/>')


def test_value() -> None:
    """Written down, since stored baselines and the history of code scanning depend on it."""
    assert fingerprint(PLAIN) == "2aa8b78cf96691446893e6bb7c4351e2a32db40d0bca8045244bb617a9801d49"
    assert fingerprint(PLAIN, 2) == "fe57b758229a0e979b6eb3975debc54d9c9459894a1944874fc5a213c88dd858"


@pytest.mark.parametrize(
    "same",
    [
        PLAIN._replace(location=HERE._replace(line=99, column=1, start=2000, text="")),
        PLAIN._replace(message="other words", severity=Severity.INFO, name="renamed"),
        PLAIN._replace(element='  <node\n\tname="x"/>'),
        PLAIN._replace(location=HERE._replace(path="launch\\a.launch")),
    ],
)
def test_same(same: Finding) -> None:
    assert fingerprint(same) == fingerprint(PLAIN)


@pytest.mark.parametrize(
    "other",
    [
        PLAIN._replace(rule="LL302"),
        PLAIN._replace(topic="width"),
        PLAIN._replace(element='<node name="y"/>'),
        PLAIN._replace(location=HERE._replace(path="launch/b.launch")),
        PLAIN._replace(location=HERE._replace(path="launch/\udcff.launch")),
    ],
)
def test_different(other: Finding) -> None:
    assert fingerprint(other) != fingerprint(PLAIN)


def test_equal_ones_are_numbered_in_the_order_of_the_file() -> None:
    second = PLAIN._replace(location=HERE._replace(line=9, start=100, end=115))
    assert fingerprints([second, PLAIN]) == [(PLAIN, fingerprint(PLAIN)), (second, fingerprint(PLAIN, 2))]
