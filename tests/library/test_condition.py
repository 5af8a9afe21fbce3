"""Conditions and `each`: what they come to in a situation."""

from __future__ import annotations

from typing import Any

import pytest

from launchlint.library.condition import holds, things
from launchlint.library.template import UNKNOWN, Thing, Undetermined
from tests.library.samples import Node

YES: dict[str, Any] = {"param": "~yes"}
NO: dict[str, Any] = {"param": "~no"}
WHO: dict[str, Any] = {"param": "~who"}
PARAMS = Node(params={"~yes": True, "~no": False, "~who": UNKNOWN, "~n": 3, "~text": "off", "~empty": "", "~f": 2.5})


@pytest.mark.parametrize(
    ("condition", "expected"),
    [
        (YES, True),
        (NO, False),
        (WHO, None),
        ({"param": "~gone"}, False),
        ({"param": "~gone", "default": True}, True),
        ({"param": "~no", "default": True}, False),
        ({"param": "~text"}, False),
        ({"param": "~empty"}, False),
        ({"param": "~n"}, True),
        ({"param": "~n", "is": 3}, True),
        ({"param": "~n", "is": "3"}, True),
        ({"param": "~n", "is": 4}, False),
        ({"param": "~f", "is": 2.5}, True),
        ({"param": "~gone", "is": 3}, False),
        ({"param": "~gone", "is": 3, "default": 3}, True),
        ({"param": "~text", "is": False}, True),
        ({"param": "~gone", "is": False}, False),
        ({"param": "~n", "in": [1, 2]}, False),
        ({"param": "~n", "in": [1, 3]}, True),
        ({"param": "~gone", "in": [1], "default": 1}, True),
        ({"param": "~gone", "set": True}, False),
        ({"param": "~gone", "set": False}, True),
        ({"param": "~no", "set": True}, True),
        ({"param": "~who", "set": True}, None),
        ({"text": "if (debug_)"}, None),
        ({"not": YES}, False),
        ({"not": WHO}, None),
        ({"all": [YES, YES]}, True),
        ({"all": [YES, WHO]}, None),
        ({"all": [WHO, NO]}, False),
        ({"any": [NO, NO]}, False),
        ({"any": [NO, WHO]}, None),
        ({"any": [WHO, YES]}, True),
    ],
)
def test_condition_on_params(condition: Any, expected: bool | None) -> None:
    assert holds(condition, PARAMS) is expected


@pytest.mark.parametrize(
    ("condition", "expected"),
    [
        ({"arg": 1}, True),
        ({"arg": 3}, False),
        ({"arg": -1, "is": "7"}, True),
        ({"arg": 2, "is": 7}, True),
        ({"arg": 1, "is": "pub"}, True),
        ({"arg": 1, "in": ["echo", "pub"]}, True),
        ({"option": "-l"}, True),
        ({"option": "-r"}, False),
        ({"option": "--rate", "is": 5}, True),
        ({"remap": "in"}, True),
        ({"remap": "out"}, False),
    ],
)
def test_condition_on_the_command_line(condition: Any, expected: bool) -> None:
    node = Node(("pub", "7"), {"-l": True, "--rate": "5"}, remaps={"/ns/in": "/scan"})
    assert holds(condition, node) is expected


@pytest.mark.parametrize(
    ("each", "node", "expected"),
    [
        ({"args": 2}, Node(("out", "a", "b")), [Thing("a", "a"), Thing("b", "b")]),
        ({"args": 2}, Node(("out",)), []),
        (
            {"args": 1, "like": "{topic}@{type}[{other}"},
            Node(("/a@std_msgs/Int8[x.Int", "/b@std_msgs/Int8@x.Int", "/c@[", "@std_msgs/Int8[x", "d", "/e@p/T[q")),
            [
                Thing("/a@std_msgs/Int8[x.Int", {"topic": "/a", "type": "std_msgs/Int8", "other": "x.Int"}),
                Thing("/e@p/T[q", {"topic": "/e", "type": "p/T", "other": "q"}),
            ],
        ),
        ({"args": 1, "like": "{all}"}, Node(("a@b",)), [Thing("a@b", {"all": "a@b"})]),
        ({"args": 1, "like": "{topic}@{type}"}, Node((UNKNOWN,)), UNKNOWN),
        ({"args": 2}, Node(("out", UNKNOWN)), UNKNOWN),
        ({"param": "~topics"}, Node(params={"~topics": ["a", "b"]}), [Thing("a", "a"), Thing("b", "b")]),
        ({"param": "~topics"}, Node(params={"~topics": {"a": {"x": 1}}}), [Thing("a", {"x": 1})]),
        ({"param": "~topics"}, Node(), []),
        ({"param": "~topics", "default": ["c"]}, Node(), [Thing("c", "c")]),
        ({"param": "~topics", "default": ["c"]}, Node(params={"~topics": []}), []),
        ({"param": "~topics"}, Node(params={"~topics": "[a, b]"}), UNKNOWN),
        ({"param": "~topics"}, Node(params={"~topics": UNKNOWN}), UNKNOWN),
        ({"words": "~sources"}, Node(params={"~sources": "scan  cloud"}), [Thing("scan", "scan"), Thing("cloud", "cloud")]),
        ({"words": "~sources", "default": ["scan"]}, Node(), [Thing("scan", "scan")]),
        ({"words": "~sources"}, Node(params={"~sources": ""}), []),
        ({"words": "~sources"}, Node(params={"~sources": 5}), UNKNOWN),
    ],
)
def test_things(each: Any, node: Node, expected: Any) -> None:
    assert things(each, node) == expected


def test_arguments_known_in_part() -> None:
    """Of ``$(arg sensor)/imu@p/T[q`` the type is known; a word of which the form is not known may be any argument."""
    each = {"args": 1, "like": "{topic}@{type}[{other}"}
    found = things(each, Node((Undetermined("*/imu@p/T[q"), "/b@p/T[q")))
    assert isinstance(found, list)
    topic, certain = (thing.value["topic"] for thing in found)
    assert isinstance(topic, Undetermined)
    assert topic.pattern == "*/imu"
    assert certain == "/b"
    assert found[0].value["type"] == "p/T"
    assert things(each, Node((Undetermined("/x*"), "/b@p/T[q"))) is UNKNOWN
