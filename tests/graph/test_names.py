"""Names as roscpp and rospy resolve them: tables, and the same rules through the real client libraries."""

from __future__ import annotations

import json
import os
import random
import subprocess
import time
from pathlib import Path

import pytest

from launchlint.graph.names import Applied, Namer, NodeletNamer, Resolved, Rule, absolute, clean, kind, matches
from tests.graph import live


@pytest.mark.parametrize(
    ("name", "cleaned"),
    [("a", "a"), ("a/", "a"), ("/a/", "/a"), ("//a///b//", "/a/b"), ("/", "/"), ("", ""), ("~a//b", "~a/b")],
)
def test_clean(name: str, cleaned: str) -> None:
    assert clean(name) == cleaned


@pytest.mark.parametrize(
    ("name", "full", "said"),
    [
        ("x", "/ns/x", "relative"),
        ("x/y/", "/ns/x/y", "relative"),
        ("/x", "/x", "global"),
        ("//x", "/x", "global"),
        ("~x", "/ns/node/x", "private"),
        ("~/x", "/ns/node/x", "private"),
        ("~", "/ns/node", "private"),
        ("", "/ns", "relative"),
    ],
)
def test_absolute(name: str, full: str, said: str) -> None:
    assert (absolute(name, "/ns/", "/ns/node"), kind(name)) == (full, said)


@pytest.mark.parametrize(
    ("pattern", "name", "is_one"),
    [
        ("/scan", "/scan", True),
        ("/scan", "/scans", False),
        ("/*/scan", "/front/scan", True),
        ("/*/scan", "/scan", False),
        ("/a*b", "/ab", True),
        ("ab*ba", "aba", False),
        ("ab*ba", "abba", True),
        ("*/a/*/b", "/x/a/y/b", True),
        ("*/a/*/b", "/x/c/y/b", False),
        ("/*/a/*/b/*", "/1/b/2/a/3", False),
        ("/*/a/*/b/*", "/1/a/2/b/3", True),
        ("/x*x*x", "/x1x", False),
        ("*", "", True),
        ("*/cam/*", "/cam/image", True),
    ],
)
def test_what_a_pattern_stands_for(pattern: str, name: str, is_one: bool) -> None:
    assert matches(pattern, name) is is_one


def namer(client: str, *rules: tuple[str, str], node: str = "/ns/node") -> Namer:
    return Namer(node.rpartition("/")[0] or "/", node, [Rule(*rule) for rule in rules], client)


RESOLVED = [
    # rules, name → on the graph for roscpp, for rospy
    ([], "x", "/ns/x", "/ns/x"),
    ([("x", "y")], "x", "/ns/y", "/ns/y"),
    ([("x", "y")], "/ns/x", "/ns/y", "/ns/y"),
    ([("x", "y")], "/x", "/x", "/x"),
    ([("/ns/x", "~y")], "x", "/ns/node/y", "/ns/node/y"),
    ([("~x", "/y")], "~x", "/y", "/y"),
    ([("~x", "/y")], "node/x", "/y", "/y"),
    ([("node/x", "/y")], "~x", "/y", "/y"),
    ([("/ns//node/x/", "/y/")], "~x", "/y", "/y"),
    ([("x", "y"), ("x", "z")], "x", "/ns/z", "/ns/z"),
    ([("x", "y"), ("/ns/x", "z")], "x", "/ns/y", "/ns/z"),
    ([("/ns/x", "z"), ("x", "y")], "x", "/ns/y", "/ns/y"),
    ([("x", "y"), ("/ns/x", "z"), ("x", "w")], "x", "/ns/w", "/ns/z"),
    ([("~x", "y"), ("node/x", "z"), ("/ns/node/x", "w")], "~x", "/ns/y", "/ns/w"),
    ([("x", "y"), ("y", "z")], "x", "/ns/y", "/ns/y"),
    ([("x", "y"), ("y", "x")], "y", "/ns/x", "/ns/x"),
    ([("x", "x")], "x", "/ns/x", "/ns/x"),
    ([("node", "y")], "node", "/ns/node", "/ns/y"),
    ([("/ns/node", "y")], "node", "/ns/y", "/ns/y"),
    ([], "~/x", "/ns/node/x", "/x"),
    ([("~x", "/y")], "~/x", "/y", "/x"),
]


@pytest.mark.parametrize(("rules", "name", "roscpp", "rospy"), RESOLVED)
def test_one_look_up(rules: list[tuple[str, str]], name: str, roscpp: str, rospy: str) -> None:
    assert (namer("roscpp", *rules).resolve(name).name, namer("rospy", *rules).resolve(name).name) == (roscpp, rospy)


def test_what_acted_is_told() -> None:
    rule = Rule("/ns/x", "~y")
    there = Applied("/ns/x", "/ns/node/y", rule)
    own = Namer("/ns/", "/ns/node", [rule], "roscpp")
    assert own.resolve("x") == Resolved("/ns/node/y", "/ns/x", (there,))
    assert own.resolve("y") == Resolved("/ns/y", "/ns/y")
    assert own.remappings == {"/ns/x": there}
    assert (own.is_remapped("x"), own.is_remapped("/x")) == (True, False)


def test_topics_of_rospy_are_looked_up_twice() -> None:
    rules = [("a", "b"), ("b", "c"), ("c", "d")]
    assert namer("rospy", *rules).topic("a").name == "/ns/c"
    assert namer("roscpp", *rules).topic("a").name == "/ns/b"
    assert [each.target for each in namer("rospy", *rules).topic("a").applied] == ["/ns/b", "/ns/c"]


@pytest.mark.parametrize(
    ("rules", "roscpp", "rospy"),
    [
        ([], "/ns/job/goal", "/ns/job/goal"),
        ([("job", "work")], "/ns/work/goal", "/ns/work/goal"),
        ([("/ns/job", "/work")], "/work/goal", "/ns/job/goal"),
        ([("job/goal", "/g")], "/g", "/g"),
        ([("job", "work"), ("job/goal", "/g")], "/ns/work/goal", "/ns/work/goal"),
        ([("job", "work"), ("work/goal", "/g"), ("/g", "/h")], "/g", "/h"),
    ],
)
def test_topics_of_an_action(rules: list[tuple[str, str]], roscpp: str, rospy: str) -> None:
    found = {client: own.beneath(own.action("job"), "goal").name for client in ("roscpp", "rospy") if (own := namer(client, *rules))}
    assert found == {"roscpp": roscpp, "rospy": rospy}


@pytest.mark.parametrize(
    ("rules", "graph_name", "state"),
    [
        ([], "/ns/node", "/ns/node/state"),
        ([("node", "/other")], "/ns/node", "/ns/node/state"),
        ([("/ns/node", "/other")], "/other", "/other/state"),
        ([("~", "other")], "/ns/other", "/ns/other/state"),
        ([("~", "/other"), ("/other/state", "/third")], "/other", "/third"),
        ([("~", "/other"), ("~state", "/third")], "/other", "/other/state"),
        ([("~", "/other"), ("/other", "/third")], "/other", "/third/state"),
    ],
)
def test_the_name_of_a_roscpp_node_is_a_name_like_any_other(rules: list[tuple[str, str]], graph_name: str, state: str) -> None:
    own = namer("roscpp", *rules)
    assert (own.node, own.graph_name, own.resolve("~state").name) == ("/ns/node", graph_name, state)
    other = namer("rospy", *rules)
    assert (other.graph_name, other.private) == ("/ns/node", "/ns/node")


def test_a_namespace_that_is_not_that_of_the_launch_file() -> None:
    own = Namer("/given", "/ns/node", [Rule("x", "~y")], "roscpp")
    assert (own.node, own.graph_name, own.resolve("x").name, own.resolve("z").name) == (
        "/ns/node",
        "/given/node",
        "/given/node/y",
        "/given/z",
    )


@pytest.mark.parametrize(
    ("rules", "unknown", "patterns", "for_certain"),
    [
        ([], [], [], False),
        ([("cam", "/a")], [], ["/a/left/image"], False),
        ([("cam", "/z")], [], ["/z/left/image"], False),
        ([("cam", "cam")], [], [], False),
        ([("/ns", "/moved")], [], [], False),
        ([], [("cam", "/*/x")], ["/*/x/left/image"], False),
        ([], [("cam/left", "/*/x")], ["/*/x/image"], False),
        ([], [("car", "/*/x")], [], False),
        ([], [("c*", "/x")], ["/x"], False),
        ([], [("cam/left/image", "*")], ["*"], True),
    ],
)
def test_what_remappings_that_are_not_known_may_make_of_a_name(
    rules: list[tuple[str, str]], unknown: list[tuple[str, str]], patterns: list[str], for_certain: bool
) -> None:
    own = Namer("/ns", "/ns/node", [Rule(*rule) for rule in rules], "roscpp", unknown)
    assert own.elsewhere("/ns/cam/left/image") == (patterns, for_certain)


def test_a_namespace_that_the_process_or_its_private_names_lie_in_is_no_namespace_of_the_code() -> None:
    """Its names were made in it already: what moves it does not act once more."""
    chain = [Rule("~", "/other"), Rule("/other", "/third"), Rule("/third", "/fourth"), Rule("/fourth", "/fifth")]
    private = Namer("/ns", "/ns/node", chain, "roscpp")
    assert (private.private, private.elsewhere("/fourth/state")) == ("/fourth", ([], False))
    elsewhere = Namer("/ns", "/ns/node", [Rule("~", "/other"), Rule("/ns", "/moved")], "roscpp")
    assert (elsewhere.private, elsewhere.elsewhere("/ns/image")) == ("/other", ([], False))


def test_a_remap_of_its_own_name_is_left_out_by_roscpp_and_the_others_stay() -> None:
    rules = [Rule("node", "x"), Rule("z", "y")]
    names = [Namer("/ns", "/ns/node", rules, client).resolve("z").name for client in ("roscpp", "rospy")]
    assert names == ["/ns/y", "/ns/y"]
    assert Namer("/ns", "/ns/node", rules, "roscpp").resolve("node").name == "/ns/node"


def test_a_param_is_called_as_a_topic_may_be() -> None:
    assert not Namer("/ns", "/ns/node").is_param("a.b")


def test_a_nodelet_looks_a_name_up_once_as_roscpp_does() -> None:
    own = NodeletNamer(namer("roscpp", ("a", "b"), ("b", "c")), None)
    assert (own.topic("a").name, own.resolve("~/x").name) == ("/ns/b", "/ns/node/x")


NODELETS = [
    # rules of the loader /ns/node, of the manager /manager, name → on the graph
    ([], [], "image", "/ns/image"),
    ([("image", "a")], [], "image", "/ns/a"),
    ([], [("/ns/image", "/m")], "image", "/m"),
    ([("image", "a")], [("/ns/image", "/m")], "image", "/m"),
    ([("image", "/a")], [("/a", "/m")], "image", "/m"),
    ([("/a", "/b")], [("/a", "/ns/image")], "image", "/b"),
    ([("image", "/a")], [("image", "/m")], "image", "/a"),
    ([("~", "/moved")], [], "~image", "/moved/image"),
    ([], [("/ns/node", "/moved")], "~image", "/moved/image"),
    ([], [("/ns", "/moved")], "image", "/moved/image"),
    ([("/ns", "/never")], [], "image", "/ns/image"),
    ([("~image", "~picture")], [], "~image", "/ns/node/picture"),
]


@pytest.mark.parametrize(("loader", "manager", "name", "found"), NODELETS)
def test_a_nodelet(loader: list[tuple[str, str]], manager: list[tuple[str, str]], name: str, found: str) -> None:
    own = NodeletNamer(namer("roscpp", *loader), namer("roscpp", *manager, node="/manager"))
    assert own.resolve(name).name == found


def test_a_nodelet_of_an_unknown_manager() -> None:
    own = NodeletNamer(namer("roscpp", ("image", "a")), None)
    assert (own.node, own.namespace, own.resolve("image").name, own.resolve("~x").name) == ("/ns/node", "/ns", "/ns/a", "/ns/node/x")


@pytest.mark.parametrize(
    ("rules", "name", "found"),
    [
        ([], "image", "/cam/image"),
        ([("image", "a")], "image", "/cam/image"),
        ([("cam/image", "a")], "image", "/a"),
        ([], "~image", "/node/image"),
        ([("~image", "a")], "~image", "/a"),
    ],
)
def test_a_nodelet_in_no_namespace_has_its_relative_names_in_that_of_its_manager(
    rules: list[tuple[str, str]], name: str, found: str
) -> None:
    loader = namer("roscpp", *rules, node="/node")
    for own in (NodeletNamer(loader, namer("roscpp", node="/cam/manager")), NodeletNamer(loader, None, "/cam")):
        assert (own.home, own.namespace, own.resolve(name).name) == ("/", "/cam", found)


def test_what_moves_the_namespace_of_a_manager_moves_a_nodelet_in_no_namespace() -> None:
    own = NodeletNamer(namer("roscpp", node="/node"), namer("roscpp", ("/cam", "/moved"), node="/cam/manager"))
    assert own.resolve("image").name == "/moved/image"


# The same through the real client libraries, over random rules.

WORDS = ("a", "b", "a/b", "node", "node/a", "x")


def spellings(namespace: str) -> list[str]:
    """Names in all spellings, none of them outside ``namespace``."""
    inner = [f"{namespace}/{word}" for word in WORDS]
    return [*WORDS, "~a", "~b", "~a/b", *inner, f"/{inner[0]}/", "a//b", "node//a", namespace.rpartition("/")[0] + "/x"]


def random_rules(numbers: random.Random, namespace: str) -> list[tuple[str, str]]:
    names = [*spellings(namespace), "~"]
    return [(numbers.choice(names), numbers.choice(names)) for _ in range(numbers.randint(1, 9))]


RESOLVE_IN_PYTHON = """
import json, sys
import rospy.names
answers = []
for rules, node, names in json.load(sys.stdin):
    rospy.names.reload_mappings([f"{source}:={target}" for source, target in rules])
    rospy.names._set_caller_id(node)
    rospy.names.initialize_mappings(node)
    answers.append(
        [
            [rospy.names.resolve_name(name), rospy.names.resolve_name(rospy.names.resolve_name(name)),
             rospy.names.resolve_name(rospy.names.resolve_name(rospy.names.remap_name(name) + "/goal"))]
            for name in names
        ]
    )
json.dump(answers, sys.stdout)
"""


@pytest.mark.ros
@pytest.mark.parametrize("seed", range(4))
def test_rospy_resolves_so(seed: int, ros_python: str) -> None:
    numbers = random.Random(seed)
    names = [*spellings("/deep/ns"), "/elsewhere"]
    cases = [(random_rules(numbers, "/deep/ns"), "/deep/ns/node", names) for _ in range(250)]
    run = subprocess.run(
        [ros_python, "-W", "ignore", "-c", RESOLVE_IN_PYTHON],
        input=json.dumps(cases),
        capture_output=True,
        text=True,
        timeout=120,
        check=True,
    )
    for (rules, node, _), answers in zip(cases, json.loads(run.stdout), strict=True):
        own = namer("rospy", *rules, node=node)
        predicted = {name: [own.resolve(name).name, own.topic(name).name, own.beneath(own.action(name), "goal").name] for name in names}
        assert predicted == dict(zip(names, answers, strict=True)), rules


@pytest.mark.ros
def test_roscpp_resolves_so(tmp_path: Path) -> None:
    """One ``rosbag record`` for each set of rules: it subscribes to every name it is given, and looks each up once."""
    lost = live.missing()
    if lost:
        pytest.skip(lost)
    numbers = random.Random(11)
    namespaces = [f"/case{number}/ns" for number in range(24)]
    cases = {namespace: random_rules(numbers, namespace) for namespace in namespaces}
    expected: set[live.Edge] = set()
    with live.started(lambda port: ["/usr/bin/rosmaster", "--core", "-p", str(port)], tmp_path) as running:
        for namespace, rules in cases.items():
            names = [name for name in spellings(namespace) if not name.startswith("~")]
            own = namer("roscpp", *rules, node=f"{namespace}/node")
            expected |= {("subscriber", own.resolve(name).name, own.graph_name) for name in names}
            running.start(
                ["/usr/lib/rosbag/record", "-O", namespace.replace("/", "_"), *names, *(f"{a}:={b}" for a, b in rules), "__name:=node"],
                {"ROS_NAMESPACE": namespace},
            )
        found: set[live.Edge] = set()
        deadline = time.monotonic() + 30
        while found != expected and time.monotonic() < deadline:
            time.sleep(0.2)
            found = {edge for edge in live.state_or_nothing(running.master) if edge[0] == "subscriber"}
        log = running.log.read_text(encoding="utf-8", errors="replace")
    assert (sorted(expected - found), sorted(found - expected)) == ([], []), log + os.linesep + json.dumps(cases)
