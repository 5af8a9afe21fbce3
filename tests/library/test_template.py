"""Templates: what they give in a situation, what they are without one, and how wrong ones are refused."""

from __future__ import annotations

from typing import Any

import pytest

from launchlint.library.template import UNKNOWN, TemplateError, Thing, Undetermined, default_text, fill, parse
from tests.library.samples import Node

RELAY = "{arg:2|{arg:1}_relay}"


@pytest.mark.parametrize(
    ("template", "node", "expected"),
    [
        ("chatter", Node(), "chatter"),
        ("{arg:1}", Node(("in", "out")), "in"),
        ("{arg:-1}", Node(("in", "out")), "out"),
        ("{arg:3}", Node(("in", "out")), None),
        (RELAY, Node(("in", "out")), "out"),
        (RELAY, Node(("in",)), "in_relay"),
        (RELAY, Node(), None),
        (RELAY, Node((UNKNOWN,)), Undetermined("*_relay")),
        ("{arg:1}/{arg:2}", Node((UNKNOWN,)), None),
        ("{option:--rate|10}", Node(options={"--rate": "5"}), "5"),
        ("{option:--rate|10}", Node(), "10"),
        ("{option:-l}", Node(options={"-l": True}), "true"),
        ("{param:~topic|scan}", Node(), "scan"),
        ("{param:~topic|scan}", Node(params={"~topic": "laser"}), "laser"),
        ("{param:~topic|scan}", Node(params={"~topic": UNKNOWN}), Undetermined("*")),
        ("{param:~a}/{param:~b}", Node(params={"~a": UNKNOWN, "~b": "scan"}), Undetermined("*/scan")),
        ("{any}/pose", Node(), Undetermined("*/pose")),
        ("camera_{param:~index}", Node(params={"~index": 2}), "camera_2"),
        ("camera_{param:~index}", Node(params={"~index": [1, 2]}), Undetermined("camera_*")),
        ("{param:~a|{param:~b|{arg:1|c}}}", Node(), "c"),
        ("{param:~a|{param:~b|{arg:1|c}}}", Node(params={"~b": "d"}), "d"),
        ("{param:~prefix|}scan", Node(), "scan"),
        ("{remap:in}/compressed", Node(), "/ns/in/compressed"),
        ("{remap:in}/compressed", Node(remaps={"/ns/in": "/camera/image"}), "/camera/image/compressed"),
        ("{remap:{param:~topic|in}}", Node(params={"~topic": "/x"}), "/x"),
        ("{remap:{param:~topic}}", Node(), None),
        ("{remap:{param:~topic}}", Node(params={"~topic": UNKNOWN}), Undetermined("*")),
        ("{parent:image}/camera_info", Node(remaps={"/ns/image": "/left/image_raw"}), "/left/camera_info"),
        ("{node}/status", Node(node="lidar"), "lidar/status"),
        ("a{{b}}", Node(), "a{b}"),
    ],
)
def test_fill(template: str, node: Node, expected: Any) -> None:
    assert repr(fill(parse(template), node)) == repr(expected)


@pytest.mark.parametrize(
    ("template", "each", "expected"),
    [
        ("{each}", Thing("front", {"topic": "/front/scan"}), "front"),
        ("{each:topic}", Thing("front", {"topic": "/front/scan"}), "/front/scan"),
        ("{each:topic/name}", Thing("front", {"topic": {"name": "x"}}), "x"),
        ("{each:topic/name}", Thing("front", {"topic": "x"}), None),
        ("{each:topic/name}", Thing("front", {"topic": UNKNOWN}), Undetermined("*")),
        ("{each:topic|{each}_scan}", Thing("front", {}), "front_scan"),
        ("{each}", UNKNOWN, Undetermined("*")),
        ("{each}", None, None),
    ],
)
def test_fill_with_each(template: str, each: Any, expected: Any) -> None:
    assert repr(fill(parse(template), Node(), each)) == repr(expected)


@pytest.mark.parametrize(
    ("template", "expected"),
    [
        ("scan", "scan"),
        ("{param:~topic|scan}", "scan"),
        ("~/{param:~camera|/left}/image", "~left/image"),
        ("{arg:2|{arg:1}_relay}", "{arg:1}_relay"),
        ("{remap:in}/compressed", "in/compressed"),
        ("{parent:camera/image}/camera_info", "camera/camera_info"),
        ("{remap:{param:~t|in}}/x", "in/x"),
        ("{node}/{each}/{each:topic}", "{node}/{each}/{each:topic}"),
    ],
)
def test_default_text(template: str, expected: str) -> None:
    assert default_text(template) == expected


@pytest.mark.parametrize(
    ("template", "message"),
    [
        ("{arg:0}", "{arg:0} must be the number of an argument, counted from 1 or from -1"),
        ("{arg:--1}", "{arg:--1} must be the number of an argument, counted from 1 or from -1"),
        ("{arg:\u0661}", "{arg:\u0661} must be the number of an argument, counted from 1 or from -1"),
        ("{arg:10000}", "{arg:10000} must be the number of an argument, counted from 1 or from -1"),
        ("{arg:}", "{arg} needs a : after its name"),
        ("{arg}", "{arg} needs a : after its name"),
        ("{node:x}", "{node} needs a } after its name"),
        ("{node|x}", "{node} always has a value: it takes no default"),
        ("{any:x}", "{any} needs a } after its name"),
        ("{any|x}", "{any} always has a value: it takes no default"),
        ("{remap:in|x}", "{remap} always has a value: it takes no default"),
        ("{remap}", "{remap} needs a : after its name"),
        ("{remap:}", "its {remap} needs a name"),
        ("{remap:in", "its {remap} is not closed"),
        ("{param:~x|y", "its {param} is not closed"),
        ("{param:~x", "its {param} is not closed"),
        ("{ros:x}", "{ros} is no template; there are arg, option, param, remap, parent, each, node, any"),
        ("{", "{} is no template; there are arg, option, param, remap, parent, each, node, any"),
        ("a}", "it has a } that closes nothing; a brace itself is written twice"),
        ("{arg:1|" * 9 + "x" + "}" * 9, "its templates are nested too deep"),
        ("{remap:" * 500, "its templates are nested too deep"),
    ],
)
def test_no_template(template: str, message: str) -> None:
    with pytest.raises(TemplateError) as error:
        parse(template)
    assert str(error.value) == message
