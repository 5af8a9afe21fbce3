"""The constructs of ROS 1."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from math import isqrt

from tests.growth.workspace import ENTRY, Construct, times

PACKAGE = (
    '<package format="2"><name>demo</name><version>1.0.0</version><description>A demo.</description>'
    '<maintainer email="a@example.org">A</maintainer><license>BSD</license></package>\n'
)
BUILD = "project(demo)\nfind_package(catkin)\ncatkin_package()\nadd_executable(talk talk.cpp)\n"
ONE = '<node pkg="demo" type="talk" name="one"/>'
EACH = '<node pkg="demo" type="talk" name="n{}"/>'
TALKER = '<node pkg="rospy_tutorials" type="talker" name="talker{}">{remap}</node>'
LISTENER = '<node pkg="rospy_tutorials" type="listener" name="listener{}">{remap}</node>'
CHATTER = '<remap from="chatter" to="{to}"/>'
PARAM = '<param name="p{}" value="1"/>'
INNER = '<include file="$(dirname)/b.launch"/>'


def launch(*parts: str) -> str:
    """The text of a launch file."""
    return "\n".join(("<launch>", *parts, "</launch>\n"))


def node(*parts: str) -> str:
    """One node with these elements in it."""
    return "\n".join(('<node pkg="demo" type="talk" name="one">', *parts, "</node>"))


def talker(to: str) -> str:
    """A node that publishes one topic, remapped to ``to``."""
    return TALKER.replace("{remap}", CHATTER.replace("{to}", to))


def listener(to: str) -> str:
    """A node that subscribes to it, remapped to ``to``."""
    return LISTENER.replace("{remap}", CHATTER.replace("{to}", to))


def _construct(
    name: str,
    text: Callable[[int], str],
    inner: Callable[[int], Mapping[str, str]] | None = None,
    most: int = 100_000,
    product: bool = False,
) -> Construct:
    def files(count: int) -> Mapping[str, str]:
        others = {f"launch/{file}": content for file, content in inner(count).items()} if inner else {}
        return {".git/HEAD": "", "package.xml": PACKAGE, "CMakeLists.txt": BUILD, ENTRY: text(count), **others}

    return Construct(name, ENTRY, files, most, product)


def _repeated(name: str, line: str, before: str = "", after: str = "", *, product: bool = False) -> Construct:
    return _construct(name, lambda count: launch(before, times(count, line), after), product=product)


def _in_node(name: str, line: str) -> Construct:
    return _construct(name, lambda count: launch(node(times(count, line))))


def _with(name: str, line: str, inner: str, before: str = "", after: str = "") -> Construct:
    return _construct(name, lambda count: launch(before, times(count, line), after), lambda count: {"b.launch": inner})


def _value(name: str, piece: str, most: int = 100_000, product: bool = False) -> Construct:
    return _construct(
        name, lambda count: launch('<arg name="a" default="1"/>', f'<param name="x" value="{times(count, piece, "")}"/>'), most=most
    )


def _levels(count: int, copies: int) -> Mapping[str, str]:
    """Files of which each includes the next one, so many times."""
    again = {f"b{level}.launch": launch(f'<include file="$(dirname)/b{level + 1}.launch"/>' * copies) for level in range(count)}
    return {**again, f"b{count}.launch": launch(PARAM)}


CONSTRUCTS = (
    _repeated("nodes", EACH),
    _repeated("nodes of one name", ONE),
    _repeated("unknown tags", "<nod/>"),
    _construct(
        "unknown attributes", lambda count: launch('<node pkg="demo" type="talk" name="one" ' + times(count, 'a{}="1"', " ") + "/>")
    ),
    _repeated("comments that suppress", "<!-- launchlint: ignore=LL101 -->"),
    _repeated("comments", "<!-- nothing -->"),
    _in_node("remaps of a node", '<remap from="a{}" to="b{}"/>'),
    _in_node("remaps of one name", '<remap from="a" to="b{}"/>'),
    _in_node("chain of remaps", '<remap from="a{}" to="a{+}"/>'),
    _repeated("remaps for all", '<remap from="a{}" to="b{}"/>', after=ONE),
    _repeated("remaps and nodes", '<remap from="a{}" to="b{}"/>' + EACH, product=True),
    _in_node("variables of a node", '<env name="A{}" value="b"/>'),
    _repeated("variables and nodes", '<env name="A{}" value="b"/>' + EACH, product=True),
    _in_node("params of a node", PARAM),
    _in_node("YAML of a node", '<rosparam param="p{}">[1, 2]</rosparam>'),
    _repeated("params", PARAM),
    _repeated("params of one name", '<param name="p" value="{}"/>'),
    _repeated("params below params", '<param name="p" value="1"/><param name="p/a{}" value="1"/>'),
    _repeated("params for all", '<param name="~p{}" value="1"/>', after=ONE),
    _construct(
        "params for all groups",
        lambda count: launch(times(count, '<param name="~p{}" value="1"/>'), times(count, f'<group ns="g{{}}">{ONE}</group>')),
        product=True,
    ),
    _repeated("deleted params", '<param name="/a/p{}" value="1"/><rosparam command="delete" param="/a/p{}"/>'),
    _repeated("cleared groups", '<group ns="g{}" clear_params="true"><param name="p" value="1"/></group>'),
    _construct("keys of YAML", lambda count: launch("<rosparam>", times(count, "k{}: 1"), "</rosparam>")),
    _construct("a key of YAML with anchors", lambda count: launch("<rosparam>", times(count, "k: &amp;a{} 1"), "</rosparam>")),
    _construct("comments in YAML", lambda count: launch("<rosparam>\n", times(count, "k: 1 <!-- c -->"), "</rosparam>")),
    _construct("one key of YAML", lambda count: launch("<rosparam>", times(count, "k: 1"), "</rosparam>")),
    _construct("list of YAML", lambda count: launch("<rosparam>k: [" + times(count, "1", ", ") + "]</rosparam>")),
    _construct("depth of YAML", lambda count: launch("<rosparam>k: " + "[" * count + "]" * count + "</rosparam>")),
    _construct(
        "anchors of YAML",
        lambda count: launch("<rosparam>\na0: &amp;a0 [1]\n", times(count, "a{+}: &amp;a{+} [*a{}, *a{}]"), "\n</rosparam>"),
    ),
    _repeated("args", '<arg name="a{}" default="1"/>'),
    _repeated("chain of args", '<arg name="a{+}" default="$(arg a{})"/>', before='<arg name="a0" default="1"/>'),
    _repeated("args nobody declared", '<param name="p{}" value="$(arg a{})"/>', product=True),
    _repeated("args declared twice", '<arg name="a" default="{}"/>'),
    _repeated("required args", '<arg name="a{}"/><param name="p{}" value="$(arg a{})"/>'),
    _repeated("conditions of one arg", '<param if="$(arg a)" name="p{}" value="1"/>', before='<arg name="a" default="true"/>'),
    _repeated("conditions", '<arg name="a{}" default="true"/><param if="$(arg a{})" name="p{}" value="1"/>'),
    _repeated("expressions as conditions", '<arg name="a{}" default="x"/><param if="$(eval a{} == \'x\')" name="p{}" value="1"/>'),
    _repeated("literal conditions", '<param if="false" name="p{}" value="1"/>'),
    _repeated("groups", f'<group ns="g{{}}">{ONE}</group>'),
    _construct("depth of groups", lambda count: launch('<group ns="g">' * count + ONE + "</group>" * count), most=800),
    _repeated("empty groups", "<group/>"),
    _repeated("expressions", '<param name="p{}" value="$(eval 1 + {})"/>'),
    _construct("long expression", lambda count: launch('<param name="x" value="$(eval ' + " + ".join(["1"] * count) + ')"/>')),
    _construct("depth of an expression", lambda count: launch('<param name="x" value="$(eval ' + "(" * count + "1" + ")" * count + ')"/>')),
    _value("letters of a value", "abcdefghij"),
    _value("substitutions of a value", "$(arg a)"),
    _value("anonymous names of a value", "$(anon a)"),
    _value("packages of a value", "$(find demo)"),
    _value("open substitutions", "$(arg "),
    _value("variables of a value", "$(optenv A b)"),
    _value("entities of a value", "&amp;"),
    _repeated("anonymous nodes", '<node pkg="demo" type="talk" name="$(anon n{})"/>'),
    _repeated("machines", '<machine name="m{}" address="h{}"/>'),
    _repeated("nodes on machines", '<machine name="m{}" address="h{}"/><node pkg="demo" type="talk" name="n{}" machine="m{}"/>'),
    _repeated("tests", '<test pkg="demo" type="talk" test-name="t{}"/>'),
    _repeated("packages nobody has", '<node pkg="demo{}" type="talk" name="n{}"/>'),
    _repeated("programs nobody has", '<node pkg="demo" type="talk{}" name="n{}"/>'),
    _repeated("files nobody has", '<include file="$(dirname)/c{}.launch"/>'),
    _repeated("parameter files nobody has", '<rosparam file="$(dirname)/c{}.yaml"/>'),
    _with("includes of one file", INNER, launch(PARAM)),
    _with(
        "includes with an arg",
        '<include file="$(dirname)/b.launch"><arg name="a" value="{}"/></include>',
        launch('<arg name="a"/>', '<param name="p$(arg a)" value="1"/>'),
    ),
    _with("includes in namespaces", '<include file="$(dirname)/b.launch" ns="g{}"/>', launch(ONE)),
    _construct(
        "files",
        lambda count: launch(times(count, '<include file="$(dirname)/b{}.launch"/>')),
        lambda count: {f"b{number}.launch": launch(EACH.replace("{}", str(number))) for number in range(count)},
        most=10_000,
    ),
    _construct(
        "depth of includes", lambda count: launch('<include file="$(dirname)/b0.launch"/>'), lambda count: _levels(count, 1), most=10_000
    ),
    _construct(
        "includes that meet again",
        lambda count: launch('<include file="$(dirname)/b0.launch"/>'),
        lambda count: _levels(isqrt(count), 2),
        most=10_000,
        product=True,
    ),
    _construct(
        "args handed on",
        lambda count: launch('<include file="$(dirname)/b.launch">', times(count, '<arg name="a{}" value="1"/>'), "</include>"),
        lambda count: {"b.launch": launch(times(count, '<arg name="a{}"/>'))},
    ),
    _construct(
        "args nobody takes",
        lambda count: launch('<include file="$(dirname)/b.launch">', times(count, '<arg name="b{}" value="1"/>'), "</include>"),
        lambda count: {"b.launch": launch(times(count, '<arg name="a{}" default="1"/>'))},
    ),
    _construct("args nobody hands on", lambda count: launch(INNER), lambda count: {"b.launch": launch(times(count, '<arg name="a{}"/>'))}),
    _repeated("publishers", talker("topic{}")),
    _repeated("publishers of one topic", talker("topic")),
    _repeated("a hub", talker("topic") + listener("topic")),
    _repeated("pairs", talker("topic{}") + listener("topic{}")),
    _repeated("pairs that just miss", talker("topic{}") + listener("topik{}")),
    _repeated("pairs of other namespaces", talker("topic{}") + listener("other/topic{}")),
    _repeated("subscribers among unknown nodes", listener("topic{}") + EACH),
    _repeated("nodelets", '<node pkg="nodelet" type="nodelet" name="n{}" args="load image_proc/rectify manager"/>'),
    _repeated(
        "nodelets of a manager",
        '<node pkg="nodelet" type="nodelet" name="n{}" args="load image_proc/rectify manager"/>',
        before='<node pkg="nodelet" type="nodelet" name="manager" args="manager"/>',
    ),
    _repeated(
        "managers",
        '<node pkg="nodelet" type="nodelet" name="m{}" args="manager"/>'
        '<node pkg="nodelet" type="nodelet" name="n{}" args="load image_proc/rectify m{}"/>',
    ),
    _repeated("frames", '<node pkg="tf" type="static_transform_publisher" name="n{}" args="0 0 0 0 0 0 a b{} 100"/>'),
    _repeated("chain of frames", '<node pkg="tf" type="static_transform_publisher" name="n{}" args="0 0 0 0 0 0 a{} a{+} 100"/>'),
    _repeated("frame of one name", '<node pkg="tf" type="static_transform_publisher" name="n{}" args="0 0 0 0 0 0 a{} b 100"/>'),
)
