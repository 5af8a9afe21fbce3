"""Joining a launch with a library: the paper's example, nodelets, what is not known, what may not be there."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest

from tests.graph.sample import STRING, channels, edges, graph, program, reasons

TALK: dict[str, Any] = {
    "my_pkg": {
        "executables": {
            "talker.py": program("rospy", publishers=[{"name": "/msg", "type": STRING}]),
            "listener.py": program("rospy", subscribers=[{"name": "/msg", "type": STRING}]),
            "cpp": program(publishers=[{"name": "out", "type": STRING}], subscribers=[{"name": "in", "type": STRING}]),
            "server": program(services=[{"name": "~reset", "type": "std_srvs/Empty"}]),
            "client": program(clients=[{"name": "reset", "type": "std_srvs/Empty"}]),
        }
    }
}
NESTED = """
<arg name="b" value="value2"/>
<node name="listener" pkg="my_pkg" type="listener.py"/>
<node name="talker" pkg="my_pkg" type="talker.py"/>
"""
INCLUDE = '<include file="$(find pkg)/nested.launch"/>'


def test_the_paper_remaps_what_an_include_starts(tmp_path: Path) -> None:
    found = graph(tmp_path, f'<remap from="/msg" to="/chatter"/>{INCLUDE}', TALK, {"nested.launch": NESTED})
    assert channels(found) == ["topic /chatter: /talker > /listener"]
    (talker,) = found.channels["topic", "/chatter"].offers
    assert (talker.declared, talker.unremapped, [(each.source, each.target) for each in talker.applied], talker.type) == (
        "/msg",
        "/msg",
        [("/msg", "/chatter")],
        STRING,
    )


def test_a_remap_below_the_nodes_comes_too_late(tmp_path: Path) -> None:
    late = {"nested.launch": NESTED + '<remap from="/msg" to="/chatter"/>'}
    assert channels(graph(tmp_path, INCLUDE, TALK, late)) == ["topic /msg: /talker > /listener"]


def test_the_paper_in_namespaces(tmp_path: Path) -> None:
    launch = f"""
    <group ns="a"><remap from="/msg" to="chatter"/>{INCLUDE}</group>
    <include file="$(find pkg)/nested.launch" ns="b"/>
    <group><remap from="/msg" to="~msg"/>{INCLUDE}</group>
    """
    assert channels(graph(tmp_path, launch, TALK, {"nested.launch": NESTED})) == [
        "topic /a/chatter: /a/talker > /a/listener",
        "topic /listener/msg:  > /listener",
        "topic /msg: /b/talker > /b/listener",
        "topic /talker/msg: /talker > ",
    ]


def test_a_service_and_its_client(tmp_path: Path) -> None:
    launch = """
    <node pkg="my_pkg" type="server" name="server" ns="a"/>
    <node pkg="my_pkg" type="client" name="client"><remap from="reset" to="/a/server/reset"/></node>
    """
    assert channels(graph(tmp_path, launch, TALK)) == ["service /a/server/reset: /a/server > /client"]


def test_tests_are_nodes_too(tmp_path: Path) -> None:
    launch = '<node pkg="my_pkg" type="talker.py" name="t"/><test pkg="my_pkg" type="listener.py" test-name="l" ns="tests"/>'
    assert channels(graph(tmp_path, launch, TALK)) == ["topic /msg: /t > /tests/l"]


def test_an_unknown_node_may_be_anything(tmp_path: Path) -> None:
    found = graph(tmp_path, '<node pkg="my_pkg" type="cpp" name="a"/><node pkg="other" type="thing" name="b"/>', TALK)
    known, unknown = found.instances
    assert (known.knowledge, known.client, unknown.knowledge, unknown.client) == ("known", "roscpp", "unknown", "")
    assert unknown.reason == "no library knows other/thing"
    assert (known.is_unknown, unknown.is_unknown, known.may_have_more("publishers"), unknown.may_have_more("publishers")) == (
        False,
        True,
        False,
        True,
    )
    assert reasons(found.may_offer("topic", "/in")) == ["it is not known what /b does: no library knows other/thing"]


@pytest.mark.parametrize(
    ("attributes", "reason"),
    [
        ('pkg="$(arg what)" type="cpp" name="n"', "its package depends on something that is not here"),
        ('pkg="my_pkg" type="$(arg what)" name="n"', "its executable depends on something that is not here"),
    ],
)
def test_a_start_that_cannot_be_known(attributes: str, reason: str, tmp_path: Path) -> None:
    (instance,) = graph(tmp_path, f'<arg name="what" value="$(find absent)"/><node {attributes}/>', TALK).instances
    assert (instance.reason, edges(instance)) == (reason, [])


def test_a_name_that_is_not_known(tmp_path: Path) -> None:
    """What does not lie below the name is known all the same; what does may be anywhere beside it."""
    nodes = '<node pkg="my_pkg" type="cpp" name="$(arg what)"/><node pkg="my_pkg" type="server" name="$(arg what)_server" ns="a"/>'
    found = graph(tmp_path, f'<arg name="what" value="$(find absent)"/>{nodes}', TALK)
    assert [each.knowledge for each in found.instances] == ["known", "known"]
    assert channels(found) == ["topic /in:  > /$(arg what)", "topic /out: /$(arg what) > "]
    assert [[(doubt.category, doubt.pattern) for doubt in each.doubts] for each in found.instances] == [
        [],
        [("services", "/a/*_server/reset")],
    ]
    assert reasons(found.may_offer("service", "/a/b_server/reset")) == [
        "/a/$(arg what)_server has services whose names cannot be known (~reset)"
    ]
    assert (found.may_offer("service", "/a/b/reset"), found.may_offer("service", "/reset")) == ((), ())


def test_a_namespace_that_is_not_known(tmp_path: Path) -> None:
    """It may be any one, global or not: a name that the code gives as global is known all the same."""
    nodes = '<node pkg="my_pkg" type="cpp" name="n" ns="$(arg what)"/><node pkg="my_pkg" type="talker.py" name="t" ns="$(arg what)"/>'
    found = graph(tmp_path, f'<arg name="what" value="$(find absent)"/>{nodes}', TALK)
    assert [(each.knowledge, each.certain) for each in found.instances] == [("known", False), ("known", False)]
    assert [edge.rpartition(" ")[2] for edge in edges(found)] == ["/unknown_namespace/out?", "/unknown_namespace/in?", "/msg"]
    assert [(doubt.category, doubt.pattern) for doubt in found.instances[0].doubts] == [("publishers", "*/out"), ("subscribers", "*/in")]
    assert reasons(found.may_use("topic", "/a/b/in")) == ["/unknown_namespace/n has subscribers whose names cannot be known (in)"]
    assert (found.may_use("topic", "/a/out"), found.may_use("topic", "/a/b/in", "std_msgs/Bool")) == ((), ())


def test_params_of_a_name_that_is_not_known_are_read_nowhere_for_certain(tmp_path: Path) -> None:
    known = {"p": {"executables": {"n": program(params=[{"name": "~rate"}, {"name": "/speed"}])}}}
    launch = '<arg name="what" value="$(find absent)"/><node pkg="p" type="n" name="$(arg what)"/><node pkg="p" type="n" name="known"/>'
    found = graph(tmp_path, launch, known)
    assert [[reading.name for reading in each.readings] for each in found.instances] == [["/speed"], ["/known/rate", "/speed"]]
    assert {name: len(readings) for name, readings in found.readers.items()} == {"/known/rate": 1, "/speed": 2}


def test_params_in_a_namespace_that_is_not_known_are_not_certain(tmp_path: Path) -> None:
    known = {"p": {"executables": {"n": program(params=[{"name": "rate"}, {"name": "/speed"}])}}}
    launch = '<arg name="what" value="$(find absent)"/><node pkg="p" type="n" name="n" ns="$(arg what)"/>'
    (found,) = graph(tmp_path, launch, known).instances
    assert [(reading.name, reading.certain) for reading in found.readings] == [("/unknown_namespace/rate", False), ("/speed", True)]


def test_the_namespace_in_args_counts_before_that_of_the_environment(tmp_path: Path) -> None:
    inside = '<env name="ROS_NAMESPACE" value="b"/>'
    (found,) = graph(tmp_path, f'<node pkg="my_pkg" type="cpp" name="n" args="__ns:=/$(env NOT_HERE)/c">{inside}</node>', TALK).instances
    assert (found.certain, edges(found)) == (False, ["publisher /unknown_namespace/out?", "subscriber /unknown_namespace/in?"])


def test_what_lies_somewhere_below_a_name_that_is_not_known(tmp_path: Path) -> None:
    known = {"p": {"executables": {"n": program(publishers=[{"name": "~in/{any}/pose"}, {"name": "{any}/map"}])}}}
    (found,) = graph(
        tmp_path, '<arg name="what" value="$(find absent)"/><node pkg="p" type="n" name="$(arg what)_node" ns="a"/>', known
    ).instances
    assert [doubt.pattern for doubt in found.doubts] == ["/a/*_node/in/*/pose", "/a/*/map"]


def test_a_script_that_nobody_knows_is_named_as_rospy_does(tmp_path: Path) -> None:
    moved = '<remap from="~" to="/moved"/>'
    launch = f'<node pkg="p" type="script.py" name="a">{moved}</node><node pkg="p" type="program" name="b">{moved}</node>'
    assert [each.host for each in graph(tmp_path, launch, TALK).instances] == ["/a", "/moved"]


def test_a_condition_that_was_assumed(tmp_path: Path) -> None:
    launch = '<node pkg="my_pkg" type="cpp" name="n" if="$(find absent)"/><node pkg="my_pkg" type="talker.py" name="t"/>'
    found = graph(tmp_path, launch, TALK)
    assert (edges(found), [each.certain for each in found.instances]) == (
        ["/n publisher /out?", "/n subscriber /in?", "/t publisher /msg"],
        [False, True],
    )


@pytest.mark.parametrize(
    ("remap", "endpoints", "doubts"),
    [
        ('from="$(find absent)" to="x"', ["publisher /out?", "subscriber /in?"], [("publishers", "/x"), ("subscribers", "/x")]),
        ('from="out" to="$(find absent)"', ["subscriber /in"], [("publishers", "*")]),
        ('from="out" to="/robot/$(env NOT_HERE)/out"', ["subscriber /in"], [("publishers", "/robot/*/out")]),
        ('from="o$(env NOT_HERE)" to="x"', ["publisher /out?", "subscriber /in"], [("publishers", "/x")]),
        ('from="other" to="$(find absent)"', ["publisher /out", "subscriber /in"], []),
    ],
)
def test_a_remap_that_is_not_known_makes_names_unknown_and_not_the_node(
    remap: str, endpoints: list[str], doubts: list[tuple[str, str]], tmp_path: Path
) -> None:
    (found,) = graph(tmp_path, f'<node pkg="my_pkg" type="cpp" name="n"><remap {remap}/></node>', TALK).instances
    assert (found.knowledge, edges(found)) == ("known", endpoints)
    assert [(doubt.category, doubt.pattern) for doubt in found.doubts] == doubts


@pytest.mark.parametrize(
    ("client", "source", "doubts"),
    [
        ("roscpp", "camera", ["/moved/left/image"]),
        ("roscpp", "camera/left", ["/moved/image"]),
        ("roscpp", "camera/left/image", []),
        ("roscpp", "left", []),
        ("rospy", "camera", []),
    ],
)
def test_a_remap_of_a_namespace_acts_where_the_code_makes_a_node_handle_of_it(
    client: str, source: str, doubts: list[str], tmp_path: Path
) -> None:
    known = {"p": {"executables": {"n": {**program(publishers=[{"name": "camera/left/image"}]), "class": client}}}}
    launch = f'<node pkg="p" type="n" name="n"><remap from="{source}" to="/moved"/></node>'
    (found,) = graph(tmp_path, launch, known).instances
    assert [doubt.pattern for doubt in found.doubts] == doubts
    assert [each.certain for each in found.endpoints] == [not doubts]


def test_two_remaps_that_are_not_known_do_not_replace_each_other(tmp_path: Path) -> None:
    remaps = '<remap from="in" to="$(env A)/a"/><remap from="out" to="$(env B)/b"/>'
    (found,) = graph(tmp_path, f'{remaps}<node pkg="my_pkg" type="cpp" name="n"/>', TALK).instances
    assert [(doubt.category, doubt.pattern) for doubt in found.doubts] == [("publishers", "*/b"), ("subscribers", "*/a")]


def test_an_include_that_cannot_be_followed(tmp_path: Path) -> None:
    include = '<include file="$(find absent)/x.launch"><arg name="topic" value="/in"/></include>'
    found = graph(tmp_path, f'<node pkg="my_pkg" type="cpp" name="n"/>{include}', TALK)
    answers = [found.may_offer("topic", "/in"), found.may_use("topic", "/out"), found.may_offer("service", "/s")]
    assert {reason for answer in answers for reason in reasons(answer)} == {"an include could not be followed: $(find absent)/x.launch"}
    assert [each.named for answer in answers for each in answer] == [True, False, False]
    assert all(each.anything for answer in answers for each in answer)


def test_what_is_open_is_told(tmp_path: Path) -> None:
    packages = {"p": {"executables": {"rviz": program(open={"subscribers": "whatever its file says"}, publishers=[{"name": "/pose"}])}}}
    found = graph(tmp_path, '<node pkg="p" type="rviz" name="v"/>', packages)
    assert reasons(found.may_use("topic", "/x")) == ["/v may have more subscribers: whatever its file says"]
    assert (found.may_offer("topic", "/x"), found.may_use("service", "/x")) == ((), ())
    assert found.instances[0].may_have_more("subscribers")


def test_doubts_are_about_some_names_only(tmp_path: Path) -> None:
    packages = {"p": {"executables": {"t": program(publishers=[{"name": "~{any}/pose"}])}}}
    found = graph(tmp_path, '<node pkg="p" type="t" name="n" ns="a"/>', packages)
    assert reasons(found.may_offer("topic", "/a/n/left/pose")) == ["/a/n has publishers whose names cannot be known (~{any}/pose)"]
    others = [found.may_offer("topic", "/a/n/left/twist"), found.may_offer("topic", "/b/pose"), found.may_use("topic", "/a/n/left/pose")]
    assert others == [(), (), ()]


def test_many_doubts_are_about_all_names(tmp_path: Path) -> None:
    packages = {"p": {"executables": {"t": program(publishers=[{"name": "~a/{any}/pose"}])}}}
    launch = "".join(f'<node pkg="p" type="t" name="n{number}"/>' for number in range(51))
    found = graph(tmp_path, launch, packages)
    assert reasons(found.may_offer("topic", "/x/pose")) == ["many nodes have publishers whose names cannot be known"]
    assert reasons(found.may_offer("topic", "/n3/a/x/pose"))[0] == "/n3 has publishers whose names cannot be known (~a/{any}/pose)"
    assert found.may_offer("topic", "/x/twist") == ()


def test_a_name_that_is_said_twice_is_there_once(tmp_path: Path) -> None:
    twice = [{"name": "x", "type": STRING, "condition": {"text": "sometimes"}}, {"name": "/x"}, {"name": "x", "type": STRING}]
    (instance,) = graph(tmp_path, '<node pkg="p" type="t" name="n"/>', {"p": {"executables": {"t": program(publishers=twice)}}}).instances
    assert [(each.name, each.type, each.certain) for each in instance.endpoints] == [("/x", STRING, True)]


def test_of_two_that_say_as_much_the_first_is_kept(tmp_path: Path) -> None:
    twice = [{"name": "x", "type": STRING}, {"name": "/x", "type": STRING}, {"name": "x", "condition": {"text": "now"}}]
    (instance,) = graph(tmp_path, '<node pkg="p" type="t" name="n"/>', {"p": {"executables": {"t": program(publishers=twice)}}}).instances
    assert [(each.declared, each.certain) for each in instance.endpoints if each.name == "/x"] == [("x", True)]


def test_two_names_that_a_remap_makes_one_are_both_said_by_the_code(tmp_path: Path) -> None:
    both = {"p": {"executables": {"t": program(publishers=[{"name": "a"}, {"name": "b"}])}}}
    launch = '<node pkg="p" type="t" name="n"><remap from="a" to="b"/></node><node pkg="p" type="t" name="m"/>'
    joined, apart = graph(tmp_path, launch, both).instances
    assert ([each.unremapped for each in joined.endpoints], joined.looked_up) == (["/a"], {"/b": "b"})
    assert ([each.unremapped for each in apart.endpoints], apart.looked_up) == (["/a", "/b"], {})


def test_an_action_is_five_topics(tmp_path: Path) -> None:
    action = {"name": "go", "type": "demo_msgs/GoAction"}
    server, client = (program(actions=[{**action, "role": role}]) for role in ("server", "client"))
    known = {"p": {"executables": {"s": server, "c": client}}}
    found = graph(tmp_path, '<node pkg="p" type="s" name="s"/><node pkg="p" type="c" name="c"/>', known)
    assert [each for each in channels(found) if each.startswith("topic")] == [
        "topic /go/cancel: /c > /s",
        "topic /go/feedback: /s > /c",
        "topic /go/goal: /c > /s",
        "topic /go/result: /s > /c",
        "topic /go/status: /s > /c",
    ]


def test_hubs_and_plumbing(tmp_path: Path) -> None:
    packages = {
        "p": {
            "executables": {
                "t": program(
                    publishers=[{"name": "/tf", "type": "tf2_msgs/TFMessage"}, {"name": "busy"}, {"name": "~bond", "type": "bond/Status"}],
                    subscribers=[{"name": "busy"}],
                )
            }
        }
    }
    found = graph(tmp_path, "".join(f'<node pkg="p" type="t" name="n{number}"/>' for number in range(8)), packages)
    told = {name: (channel.is_hub, channel.is_plumbing) for (_, name), channel in found.channels.items() if name[:3] != "/n7"}
    assert (told["/tf"], told["/busy"], told["/n0/bond"]) == ((True, False), (True, False), (False, True))


# Nodes whose process is not named or not placed as the launch file says.


def test_a_process_has_the_name_that_remappings_and_environment_give_it(tmp_path: Path) -> None:
    launch = """
    <group ns="a">
      <node pkg="my_pkg" type="cpp" name="moved"><remap from="~" to="/elsewhere"/></node>
      <node pkg="my_pkg" type="cpp" name="env">
        <env name="ROS_NAMESPACE" value="b"/><env name="LANG" value="d"/><env name="ROS_X" value="e"/>
      </node>
      <node pkg="my_pkg" type="cpp" name="args" args="__ns:=/c"><env name="ROS_NAMESPACE" value="b"/></node>
      <node pkg="my_pkg" type="talker.py" name="python"><remap from="~" to="/elsewhere"/></node>
    </group>
    """
    found = graph(tmp_path, launch, TALK)
    assert [(each.name, each.host) for each in found.instances] == [
        ("/a/moved", "/elsewhere"),
        ("/a/env", "/b/env"),
        ("/a/args", "/c/args"),
        ("/a/python", "/a/python"),
    ]
    assert {(each.node, each.process) for instance in found.instances for each in instance.endpoints} == {
        (each.name, each.host) for each in found.instances
    }
    assert [edge for edge in edges(found) if "publisher" in edge] == [
        "/a/moved publisher /a/out",
        "/a/env publisher /b/out",
        "/a/args publisher /c/out",
        "/a/python publisher /msg",
    ]


# Nodelets.

NODELET: dict[str, Any] = {
    "nodelet": {
        "executables": {
            "nodelet": {
                "class": "roscpp",
                "options": {"--no-bond": 0},
                "variants": {
                    "load": {
                        "match": {"arg": 1, "is": "load"},
                        "clients": [{"name": "{arg:3}/load_nodelet", "type": "nodelet/NodeletLoad"}],
                    },
                    "manager": {
                        "match": {"arg": 1, "is": "manager"},
                        "services": [{"name": "~load_nodelet", "type": "nodelet/NodeletLoad"}],
                    },
                    "standalone": {"match": {"arg": 1, "is": "standalone"}},
                },
            }
        }
    },
    "cam": {
        "executables": {"driver": program(services=[{"name": "~load_nodelet", "type": "nodelet/NodeletLoad"}])},
        "nodelets": {
            "cam/Color": {
                "class": "nodelet",
                "variants": {
                    "default": {
                        "publishers": [{"name": "color", "type": STRING}],
                        "subscribers": [{"name": "~in", "type": STRING}, {"name": "{arg:1}", "type": STRING}],
                    }
                },
            }
        },
    },
}


def nodelet(name: str, args: str, inside: str = "") -> str:
    return f'<node pkg="nodelet" type="nodelet" name="{name}" args="{args}">{inside}</node>'


def test_a_nodelet_runs_in_its_manager(tmp_path: Path) -> None:
    launch = f'<group ns="a">{nodelet("m", "manager")}{nodelet("n", "load cam/Color m extra")}</group>'
    found = graph(tmp_path, launch, NODELET)
    manager, loaded = found.instances
    assert (manager.kind, manager.program, manager.host, loaded.kind, loaded.program, loaded.host, loaded.knowledge) == (
        "manager",
        "nodelet/nodelet",
        "/a/m",
        "nodelet",
        "cam/Color",
        "/a/m",
        "template",
    )
    assert [(each.role, each.name, each.node, each.process) for each in loaded.endpoints] == [
        ("client", "/a/m/load_nodelet", "/a/n", "/a/n"),
        ("publisher", "/a/color", "/a/n", "/a/m"),
        ("subscriber", "/a/extra", "/a/n", "/a/m"),
        ("subscriber", "/a/n/in", "/a/n", "/a/m"),
    ]


def test_a_nodelet_on_its_own(tmp_path: Path) -> None:
    (alone,) = graph(tmp_path, nodelet("n", "standalone cam/Color extra", '<remap from="color" to="~red"/>'), NODELET).instances
    assert (alone.kind, alone.host, edges(alone)) == ("nodelet", "/n", ["publisher /n/red", "subscriber /extra", "subscriber /n/in"])


@pytest.mark.parametrize(
    ("manager", "loader", "host"),
    [
        ("", "", "/a/m"),
        ('<remap from="~load_nodelet" to="/load"/>', "", ""),
        ('<remap from="~load_nodelet" to="/load"/>', '<remap from="m/load_nodelet" to="/load"/>', "/a/m"),
        ("", '<remap from="m/load_nodelet" to="/load"/>', ""),
        ("", '<remap from="m" to="/other"/>', "/a/m"),
        ('<remap from="~" to="/moved"/>', "", ""),
        ('<remap from="~" to="/moved"/>', '<remap from="m/load_nodelet" to="/moved/load_nodelet"/>', "/moved"),
    ],
)
def test_a_manager_is_found_by_its_service(manager: str, loader: str, host: str, tmp_path: Path) -> None:
    launch = f'<group ns="a">{nodelet("m", "manager", manager)}{nodelet("n", "load cam/Color m", loader)}</group>'
    assert graph(tmp_path, launch, NODELET).instances[1].host == host


@pytest.mark.parametrize("package", ["cam", "zed"])
def test_any_program_that_serves_what_a_manager_serves_is_one(package: str, tmp_path: Path) -> None:
    known = {**NODELET, "zed": {"executables": NODELET["cam"]["executables"]}}
    found = graph(tmp_path, f'<node pkg="{package}" type="driver" name="d"/>{nodelet("n", "load cam/Color d")}', known)
    assert [(each.kind, each.host) for each in found.instances] == [("node", "/d"), ("nodelet", "/d")]


@pytest.mark.parametrize(
    "other",
    [
        '<node pkg="aaa" type="unknown" name="m" args="manager"/>',
        '<node pkg="zzz" type="unknown" name="m" args="manager"/>',
        '<node pkg="zzz" type="unknown" name="m"/>',
        nodelet("m", "load cam/Color elsewhere"),
        nodelet("m", "standalone cam/Color"),
        '<node pkg="cam" type="other_services" name="m"/>',
        '<node pkg="cam" type="publisher" name="m"/>',
        '<node pkg="cam" type="subscriber" name="m"/>',
    ],
)
def test_into_what_no_nodelet_can_be_loaded(other: str, tmp_path: Path) -> None:
    others = {
        "other_services": program(services=[{"name": "~aaa"}, {"name": "~zzz"}]),
        "publisher": program(publishers=[{"name": "~load_nodelet", "type": STRING}]),
        "subscriber": program(subscribers=[{"name": "~load_nodelet", "type": STRING}]),
    }
    known = {**NODELET, "cam": {**NODELET["cam"], "executables": others}}
    found = graph(tmp_path, f"{other}{nodelet('n', 'load cam/Color m')}", known)
    assert {each.name: each.host for each in found.instances}["/n"] == ""


def test_a_manager_is_known_whatever_its_args_lead_to(tmp_path: Path) -> None:
    program_of_nodelets: dict[str, Any] = NODELET["nodelet"]["executables"]["nodelet"]
    manager = {**program_of_nodelets["variants"]["manager"], "publishers": [{"name": "{arg:2}/x", "type": STRING}]}
    variants = {**program_of_nodelets["variants"], "manager": manager}
    known = {**NODELET, "nodelet": {"executables": {"nodelet": {**program_of_nodelets, "variants": variants}}}}
    (found,) = graph(tmp_path, nodelet("m", "manager extra"), known).instances
    assert (found.kind, found.knowledge, edges(found)) == ("manager", "known", ["publisher /extra/x", "server /m/load_nodelet"])


def test_a_manager_that_is_not_here(tmp_path: Path) -> None:
    (loaded,) = graph(tmp_path, nodelet("n", "load cam/Color elsewhere"), NODELET).instances
    assert (loaded.host, loaded.is_unknown) == ("", False)
    assert [(each.name, each.process) for each in loaded.endpoints if each.role == "publisher"] == [("/color", "")]


def test_a_manager_whose_name_is_not_known(tmp_path: Path) -> None:
    (loaded,) = graph(tmp_path, '<arg name="m"/>' + nodelet("n", "load cam/Color $(arg m)"), NODELET).instances
    published = [(each.name, each.certain) for each in loaded.endpoints if each.role == "publisher"]
    assert (loaded.reason, published) == ("", [("/unknown_namespace/color", False)])


@pytest.mark.parametrize(("manager", "name"), [("cam/m", "/cam/color"), ("/cam/m", "/cam/color"), ("m", "/color"), ("/m", "/color")])
def test_a_nodelet_in_no_namespace(manager: str, name: str, tmp_path: Path) -> None:
    (loaded,) = graph(tmp_path, nodelet("n", f"load cam/Color {manager}"), NODELET).instances
    assert [each.name for each in loaded.endpoints if each.role == "publisher"] == [name]


@pytest.mark.parametrize(
    ("args", "reason"),
    [
        ("load cam/Unknown m", "no library knows the nodelet class cam/Unknown"),
        ("load cam/Color", "its args do not say what it loads"),
        ("standalone", "its args do not say what it loads"),
        ("load", "its args do not say what it loads"),
        ("", "its args do not say what it loads"),
        ("unloads n m", "its args do not say what it loads"),
        ("unload n m", ""),
        ("standalone cam/Color", ""),
        ("manager", ""),
    ],
)
def test_a_nodelet_that_is_not_known(args: str, reason: str, tmp_path: Path) -> None:
    (found,) = graph(tmp_path, nodelet("n", args), NODELET).instances
    assert found.reason == reason
