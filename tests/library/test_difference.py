"""What changed between two libraries."""

from __future__ import annotations

from typing import Any

import pytest

from launchlint.library.difference import difference
from launchlint.report.library_changes import changes_text
from tests.library.samples import evidence, executable, library, one, publishers
from tests.library.test_schema import EVERYTHING

X: dict[str, Any] = {"name": "x", "type": "std_msgs/String"}


def told(old: Any, new: Any) -> list[str]:
    """The lines below demo/node."""
    head, *lines = changes_text(difference(old, new)).splitlines()
    assert head == "demo/node"
    return [line.removeprefix("  ") for line in lines]


@pytest.mark.parametrize(
    ("old", "new", "expected"),
    [
        ([], [X], ["+ publisher x (std_msgs/String)"]),
        ([X], [], ["- publisher x (std_msgs/String)"]),
        ([X], [{**X, "queue": 1}], ["~ publisher x: queue none → 1"]),
        ([X], [{**X, "type": "a/B", "latched": True}], ["~ publisher x: latched none → true, type std_msgs/String → a/B"]),
        (
            [{**X, "queue": 1}],
            [{**X, "latched": True, "name": "y"}],
            ["- publisher x (std_msgs/String, queue 1)", "+ publisher y (std_msgs/String, latched true)"],
        ),
        ([X, {**X, "condition": {"arg": 1}}], [X], ["- publisher x (std_msgs/String, condition argument 1 is given)"]),
        ([X], [{**X, "condition": {"param": "~p", "default": True}}], ["~ publisher x: condition none → ~p is true (default true)"]),
    ],
)
def test_entries(old: Any, new: Any, expected: list[str]) -> None:
    assert told(publishers(*old), publishers(*new)) == expected


@pytest.mark.parametrize(
    ("old", "new", "expected"),
    [
        (executable(), {**executable(), "class": "rospy"}, ["~ executable: class roscpp → rospy"]),
        ({"like": "a"}, {"like": "b"}, ["~ executable: like a → b"]),
        (
            {"like": "a"},
            executable(clients=[X]),
            ["~ executable: class none → roscpp, like a → none", "+ service client x (std_msgs/String)"],
        ),
        (executable(), executable(open={"params": "why"}), ['~ variant default: open none → {"params": "why"}']),
        (
            executable(),
            {"class": "roscpp", "variants": {"default": {}, "fast": {"match": {"arg": 1}, "actions": [{"name": "go", "role": "server"}]}}},
            ["+ variant fast", "+ action server go [variant fast]"],
        ),
        (
            executable(params=[{"name": "~p", "default": 1}]),
            executable(params=[{"name": "~p", "default": True}]),
            ["~ param ~p: default 1 → true"],
        ),
    ],
)
def test_programs(old: Any, new: Any, expected: list[str]) -> None:
    assert told(one(old), one(new)) == expected


def test_whole_programs() -> None:
    old = library(a={"executables": {"gone": executable(publishers=[X])}}, b={"nodelets": {"b/Same": executable()}})
    new = library(b={"nodelets": {"b/Same": executable(), "b/New": executable(subscribers=[X])}})
    assert changes_text(difference(old, new)) == (
        "- a/gone\n  - publisher x (std_msgs/String)\n\n+ b/New (nodelet of b)\n  + subscriber x (std_msgs/String)\n"
    )


def test_evidence_is_no_difference() -> None:
    assert difference(publishers({**X, "evidence": evidence("static")}), publishers({**X, "evidence": evidence("manual")})) == []


def test_nothing_changed() -> None:
    assert difference(EVERYTHING, EVERYTHING) == []
    assert changes_text([]) == ""
