"""The connection graph and its changes as people read them in a terminal."""

from __future__ import annotations

from pathlib import Path

import pytest

from launchlint.graph.difference import difference
from launchlint.graph.doubts import MayBe
from launchlint.graph.selection import Selection, select
from launchlint.graph.topology import RemapStep, Topology, TopologyParam
from launchlint.graph.topology import topology as record
from launchlint.report.graph import changes, text
from launchlint.report.graph.words import WIDTH, doubted, listed, remapped, when
from tests.graph import sample, tiny
from tests.report.graph import hostile

CONFIGURATIONS = ("", "sim:=true")


def said(topology: Topology, *, dangling: bool = False) -> list[str]:
    return text.render(topology, topology, dangling=dangling).splitlines()


def test_nodes_with_what_they_say_and_hear(tmp_path: Path) -> None:
    packages = {
        "d": {
            "executables": {
                "camera": sample.program(
                    publishers=[{"name": "image", "type": "sensor_msgs/Image"}, {"name": "info"}],
                    services=[{"name": "~reset"}],
                    params=[{"name": "~rate"}, {"name": "~frame"}, {"name": "/use_sim_time"}],
                ),
                "flip": sample.program(
                    subscribers=[{"name": "image", "type": "sensor_msgs/Image"}],
                    publishers=[{"name": "flipped", "condition": {"text": "x"}}],
                ),
                "echo": sample.program(publishers=[{"name": "~own"}, {"name": "/tf"}], subscribers=[{"name": "~own"}, {"name": "/tf"}]),
                "open": sample.program(open={"publishers": "plugins", "subscribers": "plugins", "params": "they are many"}),
                "quiet": sample.program(publishers=[{"name": "/tf"}]),
                "mute": sample.program(),
            }
        }
    }
    launch = """
<arg name="flip" default="true"/>
<node pkg="d" type="camera" name="camera" ns="front"><param name="rate" value="30"/><param name="frame" value=""/></node>
<node pkg="d" type="flip" name="flip" if="$(arg flip)"><remap from="image" to="/front/image"/></node>
<node pkg="d" type="flip" name="flop"><remap from="image" to="nowhere"/></node>
<node pkg="d" type="echo" name="echo"/>
<node pkg="d" type="open" name="open"/>
<node pkg="d" type="quiet" name="quiet"/>
<node pkg="d" type="mute" name="mute"/>
<node pkg="x" type="y" name="stranger"/>
"""
    topology = record([sample.graph(tmp_path, launch, packages)])
    shown = text.render(select(topology, Selection(hubs=False)), topology)
    assert shown.splitlines() == [
        "pkg/main.launch: 8 nodes (1 unknown); 2 of 5 topics and 0 of 1 service connected",
        "",
        "/echo  d/echo  pkg/main.launch:6",
        "    talks to itself: /echo/own",
        "",
        '/flip  d/flip, if="$(arg flip)"  pkg/main.launch:4',
        "    subscribes  /front/image  ← /front/camera  (sensor_msgs/Image)",
        "                  remapped from /image (line 4)",
        "    perhaps 1 more name that nobody else uses (--dangling shows it)",
        "",
        "/flop  d/flip  pkg/main.launch:5",
        "    subscribes  /nowhere  ← nobody  (sensor_msgs/Image)",
        "                  remapped from /image (line 5)",
        "    perhaps 1 more name that nobody else uses (--dangling shows it)",
        "",
        "/front/camera  d/camera  pkg/main.launch:3",
        "    publishes  /front/image  → /flip  (sensor_msgs/Image)",
        "    nobody subscribes: /front/info",
        "    nobody calls: /front/camera/reset",
        '    reads ~frame = "", ~rate = 30',
        "",
        "/mute  d/mute  pkg/main.launch:9",
        "    says and hears nothing",
        "",
        "/open  d/open  pkg/main.launch:7",
        "    may have more params: they are many",
        "    may have more publishers and subscribers: plugins",
        "",
        "/quiet  d/quiet  pkg/main.launch:8",
        "    says and hears only what is not shown here",
        "",
        "/stranger  x/y  pkg/main.launch:10",
        "    what it does is not known: no library knows x/y",
        "",
        "not shown: /tf (--hubs)",
    ]


def test_what_nodes_may_have_is_listed_where_asked_for() -> None:
    assert said(tiny.topology("/a > /x?"), dangling=True)[3:] == ["    perhaps, and nobody subscribes: /x"]


def test_partners_are_a_few_and_the_rest_counted() -> None:
    (row,) = [line for line in said(tiny.topology("/a > /x", *(f"/b{number} < /x" for number in range(9)))) if "→" in line]
    assert row == "    publishes  /x  → /b0, /b1, /b2, /b3, /b4, /b5 and 3 more"


def test_long_lists_are_wrapped_between_names() -> None:
    lines = said(tiny.topology(*(f"/a > /{'x' * 20}{number}" for number in range(6))))
    names = [f"/{'x' * 20}{number}" for number in range(6)]
    assert lines[3:] == [f"    nobody subscribes: {', '.join(names[:3])},", f"        {', '.join(names[3:])}"]
    assert max(map(len, lines)) <= WIDTH


def test_configurations_are_marked_where_they_matter() -> None:
    simulated = tiny.node("/a", only=("sim:=true",))
    topology = tiny.topology("/a > /x @sim:=true", "/b < /x", "/b > /y @-", "/c < /y", nodes=[simulated], configurations=CONFIGURATIONS)
    assert said(topology) == [
        "demo.launch: 3 nodes; 2 of 2 topics connected; 2 configurations",
        "",
        "/a  demo/node, only with sim:=true  demo.launch:1",
        "    publishes  /x  → /b",
        "",
        "/b  demo/node  demo.launch:1",
        "    publishes   /y  → /c  [only by default]",
        "    subscribes  /x  ← /a",
        "",
        "/c  demo/node  demo.launch:1",
        "    subscribes  /y  ← /b",
    ]


def test_alternatives_under_one_name_have_their_own_connections() -> None:
    nodes = [tiny.node("/base", "demo/real", only=("",)), tiny.node("/base", "demo/fake", only=("sim:=true",))]
    topology = tiny.topology("/base > /odom @-", "/base > /fake @sim:=true", nodes=nodes, configurations=CONFIGURATIONS)
    assert said(topology) == [
        "demo.launch: 1 node; 0 of 2 topics connected; 2 configurations",
        "",
        "/base  demo/fake, only with sim:=true  demo.launch:1",
        "    nobody subscribes: /fake",
        "",
        "/base  demo/real, only by default  demo.launch:1",
        "    nobody subscribes: /odom",
    ]


def test_nodelets_and_their_managers() -> None:
    nodes = [
        tiny.node("/manager", "nodelet/nodelet", kind="manager", host="/manager"),
        tiny.node("/in", "demo/Flip", kind="nodelet", host="/manager"),
        tiny.node("/lost", "demo/Flip", kind="nodelet", host=""),
        tiny.node("/alone", "demo/Flip", kind="nodelet", host="/alone"),
    ]
    heads = [line.split("  ")[1] for line in said(tiny.topology(nodes=nodes)) if line.startswith("/")]
    assert heads == [
        "demo/Flip, standalone",
        "demo/Flip, in /manager",
        "demo/Flip, its manager is not here",
        "nodelet/nodelet, nodelet manager",
    ]


def test_many_params_are_counted() -> None:
    params = tuple(TopologyParam(f"/a/p{number:02}", "v" * 100, "", ("/a",), ()) for number in range(14))
    lines = said(tiny.topology("/a > /x")._replace(params=params))
    assert lines[-1].endswith("and 2 more")
    assert lines[4].startswith(f"    reads ~p00 = {'v' * 39}…, ~p01 = ")


def test_nothing() -> None:
    assert said(tiny.topology()) == ["demo.launch: 0 nodes"]


def test_hostile_names_are_made_visible() -> None:
    topology = hostile.topology()
    before, after = hostile.changed()
    for shown in (text.render(topology, topology), changes.render([difference(before, after)])):
        assert all(line.isprintable() for line in shown.splitlines())
        assert not [line for line in shown.splitlines() if line.startswith("::") or "##[" in line]


@pytest.mark.parametrize(
    ("only", "configurations", "words"),
    [
        ((), CONFIGURATIONS, ""),
        (("",), CONFIGURATIONS, "only by default"),
        (("sim:=true",), CONFIGURATIONS, "only with sim:=true"),
        (("", "a:=1"), ("", "a:=1", "b:=1"), "not with b:=1"),
        (("a:=1", "b:=1"), ("", "a:=1", "b:=1"), "not by default"),
        (("a:=1", "a:=1 b:=1"), ("", "a:=1", "a:=1 b:=1", "c:=1"), "only with a:=1"),
        (("", "a:=1"), ("", "a:=1", "b:=1", "c:=1"), "only by default or with a:=1"),
        (("\x1b",), ("", "\x1b"), "only with \\x1b"),
    ],
)
def test_when(only: tuple[str, ...], configurations: tuple[str, ...], words: str) -> None:
    assert when(only, configurations) == words


def test_remapped() -> None:
    steps = (RemapStep("/a", "/b", "one.launch:3:4"), RemapStep("/b", "/b", "one.launch:4:4"), RemapStep("/b", "/c", ""))
    assert remapped(steps) == "remapped from /a (one.launch:3), then from /b (args)"
    assert remapped(steps, "one.launch:1:1") == "remapped from /a (line 3), then from /b (args)"
    assert remapped(steps[1:2]) == ""


def test_listed() -> None:
    assert listed(["/a", "/b"], 5) == "/a, /b and 3 more"


def test_changes_begin_with_who_lost_whom() -> None:
    before = tiny.topology("/a > out=/x", "/b < /x", "/c calls /s", "/d serves /s", nodes=[tiny.node("/old", "demo/old"), tiny.node("/e")])
    after = tiny.topology("/a > out=/y", "/b < /x", "/c calls /s", "/e > /y", "/f < /y", nodes=[tiny.node("/e", "demo/new")])
    assert changes.render([difference(before, after)]) == (
        "demo.launch\n"
        "  lost: /c → /d on service /s\n"
        "      /d is no longer started\n"
        "  lost: /a → /b on topic /x\n"
        "      /a now publishes /y\n"
        "  gained: /e → /f on topic /y\n"
        "  - node /d (demo/node)\n"
        "      serves /s\n"
        "  - node /old (demo/old)\n"
        "  + node /f (demo/node)\n"
        "      subscribes /y\n"
        "  ~ node /e: program demo/node → demo/new\n"
        "  + topic /y\n"
        "  ~ /a publishes /y instead of /x\n"
        "  + /e publishes /y\n"
    )


def test_changes_in_several_files_are_told_once() -> None:
    before, after = tiny.topology("/a > /x", "/b < /x"), tiny.topology("/b < /x")
    found = difference(before, after)
    other = difference(before._replace(entry="z.launch"), after._replace(entry="z.launch"))
    assert changes.render([found, other]) == (
        "in 2 launch files: demo.launch, z.launch\n"
        "  lost: /a → /b on topic /x\n"
        "      /a is no longer started\n"
        "  - node /a (demo/node)\n"
        "      publishes /x\n"
    )


def test_a_renamed_file_has_both_names() -> None:
    found = difference(tiny.topology("/a > /x"), tiny.topology(nodes=[tiny.node("/a")])._replace(entry="new.launch"))
    assert changes.render([found]).splitlines() == ["demo.launch → new.launch", "  - topic /x", "  - /a publishes /x"]


def test_conditions_that_changed() -> None:
    before = tiny.topology("/a > /x", "/b < /x", "/c > out=/y", configurations=CONFIGURATIONS)
    after = tiny.topology(
        "/a > /x @sim:=true",
        "/b < /x",
        "/c > out=/y @sim:=true",
        nodes=[tiny.node("/a", only=("sim:=true",))],
        configurations=CONFIGURATIONS,
    )
    assert changes.render([difference(before, after)]).splitlines()[1:] == [
        "  lost by default: /a → /b on topic /x",
        "      /a is started only with sim:=true",
        "  ~ node /a: always → only with sim:=true",
        "  ~ /c publishes /y: always → only with sim:=true",
    ]


def test_a_doubt_is_said_and_moved_nodes_are_seen() -> None:
    before = tiny.topology("/a > /x", "/w < /x")
    after = tiny.topology("/a > /x", "/base/w < in=/base/x", nodes=[tiny.node("/new", "demo/what", knowledge="unknown")])
    assert changes.render([difference(before, after)]).splitlines()[1:] == [
        "  lost: /a → /w on topic /x",
        "      /w is now /base/w",
        "    (a node came in of which not everything is known: it may do what seems lost)",
        "  ~ node /w is now /base/w",
        "  + node /new (demo/what)",
    ]


def test_what_is_gained() -> None:
    found = difference(tiny.topology("/a > out=/y", "/b < /x"), tiny.topology("/a > out=/x", "/b < /x"))
    assert changes.render([found]).splitlines()[1] == "  gained: /a → /b on topic /x"


def test_nothing_changed() -> None:
    assert changes.render([difference(tiny.topology("/a > /x"), tiny.topology("/a > /x"))]) == ""


def test_nobody_is_said_with_the_doubt_that_is_there() -> None:
    who = (MayBe("/driver", True, "nobody knows it"), MayBe("/rviz", False, "plugins"))
    names = {("topic", "/in", True): who, ("topic", "/cloud", False): (MayBe("", False, "an include could not be followed: x.launch"),)}
    topology = tiny.topology("/a < /in", "/a > /out", "/a > /cloud")._replace(doubts=names)
    assert said(topology)[3:] == [
        "    nobody here subscribes, but another one (an include could not be followed) may: /cloud",
        "    nobody subscribes: /out",
        "    nobody here publishes, but /driver (not known) and /rviz (not all of it is known) may: /in",
    ]


def test_those_who_may_be_there_are_a_few() -> None:
    assert doubted(()) == ""
    assert doubted([MayBe(f"/n{number}", True, "") for number in range(3)]) == "/n0 (not known), /n1 (not known) and /n2 (not known)"
    five = doubted([MayBe(f"/n{number}", True, "") for number in range(5)])
    assert five == "/n0 (not known), /n1 (not known), /n2 (not known) and others"


def test_names_that_are_known_only_in_part_are_told() -> None:
    topology = tiny.topology("/a > /out")
    (node,) = topology.nodes
    topology = topology._replace(partly={(node.name, node.place): (("publishers", "/nav/global_costmap/*"), ("subscribers", "*"))})
    assert said(topology)[3:] == [
        "    names known only in part: publishers /nav/global_costmap/*, subscribers *",
        "    nobody subscribes: /out",
    ]
