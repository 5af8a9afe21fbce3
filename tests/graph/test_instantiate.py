"""From what a library declares to the names of one node: templates, conditions, images, actions, doubts."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest

from launchlint.graph.connections import Doubt, Instance
from tests.graph.sample import STRING, edges, graph, program

IMAGE = "sensor_msgs/Image"


def instance(directory: Path, node: dict[str, Any], attributes: str = "", inside: str = "", around: str = "") -> Instance:
    """The node ``/ns/n`` with this program."""
    launch = f'{around}<node pkg="p" type="t" name="n" ns="ns" {attributes}>{inside}</node>'
    return graph(directory, launch, {"p": {"executables": {"t": node}}}).instances[0]


TEMPLATES = [
    # declared, args, inside the node → on the graph
    ("{arg:1}", "a b", "", ["/ns/a"]),
    ("{arg:-1}", "a b", "", ["/ns/b"]),
    ("{arg:3}", "a b", "", []),
    ("{arg:2|{arg:1}_relay}", "a", "", ["/ns/a_relay"]),
    ("{arg:1}", "a:=b /c", "", ["/c"]),
    ("~{arg:1}", "a", "", ["/ns/n/a"]),
    ("~{param:~cam}/x", "", '<param name="cam" value="/left"/>', ["/left/x"]),
    ("~/{param:~cam}/x", "", '<param name="cam" value="/left"/>', ["/ns/n/left/x"]),
    ("~/{param:~cam}/x", "", '<param name="cam" value="left"/>', ["/ns/n/left/x"]),
    ("{param:~topic|default}", "", "", ["/ns/default"]),
    ("{param:~topic|default}", "", '<param name="topic" value="/given"/>', ["/given"]),
    ("{param:~topic|default}", "_topic:=~given", '<param name="topic" value="/never"/>', ["/ns/n/given"]),
    ("{param:~a/b}", "", "<rosparam>a: {b: deep}</rosparam>", ["/ns/deep"]),
    ("x_{param:~count}", "", '<param name="count" value="5"/>', ["/ns/x_5"]),
    ("{remap:in}/compressed", "", "", ["/ns/in/compressed"]),
    ("{remap:in}/compressed", "", '<remap from="in" to="/a"/>', ["/a/compressed"]),
    ("{remap:in}/compressed", "", '<remap from="in" to="/a"/><remap from="/a/compressed" to="c"/>', ["/ns/c"]),
    ("{parent:cam/image}/camera_info", "", '<remap from="cam/image" to="/left/raw"/>', ["/left/camera_info"]),
    ("{node}_debayer/x", "", "", ["/ns/n_debayer/x"]),
    ("{arg:1}", "bad-name", "", []),
]


@pytest.mark.parametrize(("declared", "args", "inside", "names"), TEMPLATES)
def test_template(declared: str, args: str, inside: str, names: list[str], tmp_path: Path) -> None:
    found = instance(tmp_path, program(publishers=[{"name": declared, "type": STRING}]), f'args="{args}"', inside)
    assert edges(found) == [f"publisher {name}" for name in names]
    assert found.knowledge == "template"


@pytest.mark.parametrize(
    ("each", "declared", "args", "inside", "names"),
    [
        ({"args": 2}, "{each}", "out a /b ~c", "", ["/b", "/ns/a", "/ns/n/c"]),
        ({"args": 1, "like": "{topic}@{type}[{x}"}, "{each:topic}", "/a@p/T[x c@p/T@x b@p/T[x", "", ["/a", "/ns/b"]),
        ({"param": "~topics"}, "{each}", "", "<rosparam>topics: [a, b]</rosparam>", ["/ns/a", "/ns/b"]),
        ({"param": "~topics"}, "{each:topic}", "", "<rosparam>topics: {a: {topic: x}, b: {}}</rosparam>", ["/ns/x"]),
        ({"param": "~topics", "default": ["d"]}, "{each}", "", "", ["/ns/d"]),
        ({"param": "~topics"}, "{each}", "", "", []),
        ({"words": "~sources"}, "{each}", "", '<param name="sources" value="a  b"/>', ["/ns/a", "/ns/b"]),
    ],
)
def test_each(each: Any, declared: str, args: str, inside: str, names: list[str], tmp_path: Path) -> None:
    found = instance(tmp_path, program(subscribers=[{"name": declared, "each": each}]), f'args="{args}"', inside)
    assert edges(found) == [f"subscriber {name}" for name in names]


@pytest.mark.parametrize(
    ("condition", "args", "inside", "found"),
    [
        ({"param": "~on"}, "", "", []),
        ({"param": "~on"}, "_on:=true", "", ["publisher /ns/x"]),
        ({"param": "~on", "default": True}, "", "", ["publisher /ns/x"]),
        ({"param": "~on"}, "", '<param name="on" command="date"/>', ["publisher /ns/x?"]),
        ({"remap": "x"}, "", '<remap from="/ns/x" to="y"/>', ["publisher /ns/y"]),
        ({"not": {"remap": "x"}}, "", "", ["publisher /ns/x"]),
        ({"arg": 2}, "a", "", []),
        ({"arg": 1, "is": "pub"}, "pub", "", ["publisher /ns/x"]),
        ({"arg": 1, "is": "pub"}, "$(optenv NOT_HERE)'", "", ["publisher /ns/x?"]),
        ({"text": "if (debug_)"}, "", "", ["publisher /ns/x?"]),
    ],
)
def test_condition(condition: Any, args: str, inside: str, found: list[str], tmp_path: Path) -> None:
    node = program(publishers=[{"name": "x", "type": STRING, "condition": condition}])
    assert edges(instance(tmp_path, node, f'args="{args}"', inside)) == found


@pytest.mark.parametrize(
    ("declared", "args", "inside", "pattern"),
    [
        ("{any}/pose", "", "", ["/ns/*/pose"]),
        ("{any}pose", "", "", ["*"]),
        ("~{any}/pose", "", "", ["/ns/*/pose"]),
        ("~a/{any}/pose", "", "", ["/ns/n/a/*/pose"]),
        ("a/{any}", "", '<remap from="a/b" to="/c"/>', ["/ns/a/*", "/c"]),
        ("{arg:1}", "bad-name", "", ["*"]),
        ("{param:~topic}", "", '<param name="topic" command="date"/>', ["*"]),
        ("x/{param:~topic}", "", '<param name="topic" command="date"/>', ["/ns/x/*"]),
        ("{arg:1}", "$(optenv NOT_HERE)'", "", ["*"]),
    ],
)
def test_names_that_cannot_be_known(declared: str, args: str, inside: str, pattern: list[str], tmp_path: Path) -> None:
    found = instance(tmp_path, program(publishers=[{"name": declared, "type": STRING}]), f'args="{args}"', inside)
    assert (edges(found), list(found.doubts)) == ([], [Doubt("publishers", each, declared, STRING) for each in pattern])


def test_types_may_be_templates(tmp_path: Path) -> None:
    node = program(publishers=[{"name": "{arg:1}", "type": "{arg:2}"}])
    known, unknown = (instance(tmp_path, node, f'args="{args}"').endpoints for args in ("a std_msgs/Bool", "a"))
    assert [(each.name, each.type) for each in (*known, *unknown)] == [("/ns/a", "std_msgs/Bool"), ("/ns/a", "")]


def test_an_action_has_topics(tmp_path: Path) -> None:
    def node(role: str) -> dict[str, Any]:
        return program(actions=[{"name": "job", "type": "p/JobAction", "role": role}])

    server = instance(tmp_path, node("server"), inside='<remap from="job" to="/work"/><remap from="/work/goal" to="~goal"/>')
    assert [(each.role, each.name, each.type, each.action) for each in server.endpoints] == [
        ("action server", "/work", "p/JobAction", ""),
        ("publisher", "/work/feedback", "p/JobActionFeedback", "/work"),
        ("publisher", "/work/result", "p/JobActionResult", "/work"),
        ("publisher", "/work/status", "actionlib_msgs/GoalStatusArray", "/work"),
        ("subscriber", "/ns/n/goal", "p/JobActionGoal", "/work"),
        ("subscriber", "/work/cancel", "actionlib_msgs/GoalID", "/work"),
    ]
    client = instance(tmp_path, node("client"))
    assert edges(client) == [
        "action client /ns/job",
        "publisher /ns/job/cancel",
        "publisher /ns/job/goal",
        "subscriber /ns/job/feedback",
        "subscriber /ns/job/result",
        "subscriber /ns/job/status",
    ]


@pytest.mark.parametrize(
    ("category", "inside", "found"),
    [
        ("publishers", "", ["/ns/image", "/ns/image/compressed?", "/ns/image/compressedDepth?", "/ns/image/theora?"]),
        (
            "publishers",
            '<remap from="image" to="/cam"/><remap from="/cam/compressed" to="/small"/><remap from="image/theora" to="/never"/>',
            ["/cam", "/cam/compressedDepth?", "/cam/theora?", "/small?"],
        ),
        (
            "publishers",
            '<remap from="image" to="/a"/><remap from="/a" to="/b"/>',
            ["/a/compressed?", "/a/compressedDepth?", "/a/theora?", "/b"],
        ),
        ("subscribers", "", ["/ns/image"]),
        ("subscribers", '<param name="image_transport" value="raw"/>', ["/ns/image"]),
        ("subscribers", '<param name="image_transport" value="compressed"/><remap from="image" to="/cam"/>', ["/cam/compressed"]),
        (
            "subscribers",
            '<param name="image_transport" command="date"/>',
            ["/ns/image/compressed?", "/ns/image/compressedDepth?", "/ns/image/theora?", "/ns/image?"],
        ),
    ],
)
def test_images(category: str, inside: str, found: list[str], tmp_path: Path) -> None:
    interface: dict[str, Any] = {category: [{"name": "image", "type": IMAGE, "transport": "image"}]}
    node = program(**interface)
    names = sorted(edge.partition(" ")[2] for edge in edges(instance(tmp_path, node, inside=inside)))
    assert names == found


def test_variants(tmp_path: Path) -> None:
    def variant(name: str, **more: Any) -> dict[str, Any]:
        return {**more, "publishers": [{"name": name, "type": STRING}]}

    node = {
        "class": "roscpp",
        "variants": {
            "default": variant("plain"),
            "echo": variant("said", match={"arg": 1, "is": "echo"}),
            "twice": variant("twice", match={"param": "~twice"}),
        },
    }
    assert edges(instance(tmp_path, node)) == ["publisher /ns/plain"]
    assert edges(instance(tmp_path, node, 'args="echo _twice:=true"')) == ["publisher /ns/said"]
    assert edges(instance(tmp_path, node, 'args="_twice:=true"')) == ["publisher /ns/twice"]
    unsure = instance(tmp_path, node, inside='<param name="twice" command="date"/>')
    assert edges(unsure) == ["publisher /ns/plain?", "publisher /ns/twice?"]


def test_a_way_of_starting_that_the_library_does_not_know(tmp_path: Path) -> None:
    node = {"class": "roscpp", "variants": {"echo": {"match": {"arg": 1, "is": "echo"}, "publishers": [{"name": "x"}]}}}
    found = instance(tmp_path, node)
    assert edges(found) == []
    assert set(found.open) == {"publishers", "subscribers", "services", "clients", "actions", "params"}


def test_params_that_are_read(tmp_path: Path) -> None:
    node = program(params=[{"name": "~rate"}, {"name": "scale"}, {"name": "/use_sim"}])
    found = instance(tmp_path, node, inside='<remap from="scale" to="size"/>')
    assert [(each.declared, each.unremapped, each.name) for each in found.readings] == [
        ("~rate", "/ns/n/rate", "/ns/n/rate"),
        ("scale", "/ns/scale", "/ns/size"),
        ("/use_sim", "/use_sim", "/use_sim"),
    ]


def test_names_that_only_templates_resolve(tmp_path: Path) -> None:
    node = program(publishers=[{"name": "{remap:in}/compressed", "type": STRING}])
    assert instance(tmp_path, node, inside='<remap from="in" to="/a"/>').looked_up == {"/ns/in": "in"}
