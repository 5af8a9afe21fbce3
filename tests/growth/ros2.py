"""The constructs of ROS 2, in XML, YAML and parameter files."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from math import isqrt

from tests.growth.workspace import ENTRY_ROS2, Construct, times

PACKAGE = (
    '<package format="3"><name>demo</name><version>1.0.0</version><description>A demo.</description>'
    '<maintainer email="a@example.org">A</maintainer><license>BSD</license>'
    "<buildtool_depend>ament_cmake</buildtool_depend><export><build_type>ament_cmake</build_type></export></package>\n"
)
BUILD = (
    "project(demo)\nfind_package(ament_cmake REQUIRED)\nadd_executable(talk talk.cpp)\n"
    "install(TARGETS talk DESTINATION lib/demo)\nament_package()\n"
)
ONE = '<node pkg="demo" exec="talk" name="one"/>'
EACH = '<node pkg="demo" exec="talk" name="n{}"/>'
COMPONENT = '<composable_node pkg="demo" plugin="demo::Talk" name="c{}"/>'
TALKER = '<node pkg="demo_nodes_cpp" exec="talker" name="talker{}"><remap from="chatter" to="topic{}"/></node>'
LISTENER = '<node pkg="demo_nodes_cpp" exec="listener" name="listener{}"><remap from="chatter" to="{to}"/></node>'
INNER = '<include file="$(dirname)/b.launch.xml"/>'
FILE = '<node pkg="demo" exec="talk" name="one"><param from="$(dirname)/p.yaml"/></node>'


def launch(*parts: str) -> str:
    """The text of a launch file in XML."""
    return "\n".join(("<launch>", *parts, "</launch>\n"))


def node(*parts: str) -> str:
    """One node with these elements in it."""
    return "\n".join(('<node pkg="demo" exec="talk" name="one">', *parts, "</node>"))


def _construct(
    name: str,
    text: Callable[[int], str],
    inner: Callable[[int], Mapping[str, str]] | None = None,
    entry: str = ENTRY_ROS2,
    most: int = 100_000,
    product: bool = False,
) -> Construct:
    def files(count: int) -> Mapping[str, str]:
        others = {f"launch/{file}": content for file, content in inner(count).items()} if inner else {}
        return {".git/HEAD": "", "package.xml": PACKAGE, "CMakeLists.txt": BUILD, entry: text(count), **others}

    return Construct(f"ROS 2: {name}", entry, files, most, product)


def _repeated(name: str, line: str, before: str = "", after: str = "", *, product: bool = False) -> Construct:
    return _construct(name, lambda count: launch(before, times(count, line), after), product=product)


def _in_node(name: str, line: str) -> Construct:
    return _construct(name, lambda count: launch(node(times(count, line))))


def _yaml(name: str, line: str) -> Construct:
    return _construct(name, lambda count: "launch:\n" + times(count, line) + "\n", entry="launch/a.launch.yaml")


def _parameters(name: str, text: Callable[[int], str]) -> Construct:
    return _construct(name, lambda _: launch(FILE), lambda count: {"p.yaml": text(count)})


def _levels(count: int, copies: int) -> Mapping[str, str]:
    """Files of which each includes the next one, so many times."""
    again = {f"b{level}.launch.xml": launch(f'<include file="$(dirname)/b{level + 1}.launch.xml"/>' * copies) for level in range(count)}
    return {**again, f"b{count}.launch.xml": launch('<let name="x" value="1"/>')}


CONSTRUCTS = (
    _repeated("nodes", EACH),
    _repeated("nodes of one name", ONE),
    _repeated("unknown tags", "<nod/>"),
    _construct(
        "unknown attributes", lambda count: launch('<node pkg="demo" exec="talk" name="one" ' + times(count, 'a{}="1"', " ") + "/>")
    ),
    _in_node("remaps of a node", '<remap from="a{}" to="b{}"/>'),
    _in_node("remaps of one name", '<remap from="a" to="b{}"/>'),
    _repeated("remaps for all", '<set_remap from="a{}" to="b{}"/>', after=ONE),
    _repeated("remaps and nodes", '<set_remap from="a{}" to="b{}"/>' + EACH, product=True),
    _in_node("params of a node", '<param name="p{}" value="1"/>'),
    _in_node("params in params", '<param name="a{}"><param name="b" value="1"/></param>'),
    _repeated("params for all", '<set_parameter name="p{}" value="1"/>', after=ONE),
    _in_node("variables of a node", '<env name="A{}" value="b"/>'),
    _repeated("variables and nodes", '<set_env name="A{}" value="b"/>' + EACH, product=True),
    _repeated("args", '<arg name="a{}" default="1"/>'),
    _repeated("args declared twice", '<arg name="a" default="{}"/>'),
    _repeated("chain of args", '<arg name="a{+}" default="$(var a{})"/>', before='<arg name="a0" default="1"/>'),
    _repeated("chain of lets", '<let name="a{+}" value="$(var a{})"/>', before='<let name="a0" value="1"/>'),
    _repeated("names nobody set", '<let name="b{}" value="$(var a{})"/>', product=True),
    _repeated("conditions of one arg", f'<group if="$(var a)">{EACH}</group>', before='<arg name="a" default="true"/>'),
    _repeated("conditions", f'<arg name="a{{}}" default="true"/><group if="$(var a{{}})">{EACH}</group>'),
    _repeated("expressions", '<let name="a{}" value="$(eval \'1 + {}\')"/>'),
    _repeated("groups", f'<group><push_ros_namespace namespace="g{{}}"/>{ONE}</group>'),
    _repeated("namespaces", '<push_ros_namespace namespace="g{}"/>'),
    _construct("depth of groups", lambda count: launch("<group>" * count + ONE + "</group>" * count)),
    _construct("letters of a value", lambda count: launch('<let name="x" value="' + "abcdefghij" * count + '"/>')),
    _construct(
        "substitutions of a value", lambda count: launch('<let name="a" value="1"/><let name="x" value="' + "$(var a)" * count + '"/>')
    ),
    _construct("directories of a value", lambda count: launch('<let name="x" value="' + "$(dirname)" * count + '"/>')),
    _construct("depth of a substitution", lambda count: launch('<let name="x" value="' + "$(var " * count + "a" + ")" * count + '"/>')),
    _construct(
        "arguments",
        lambda count: launch('<node pkg="demo" exec="talk" name="n" args="--ros-args ' + times(count, "-p a{}:=1", " ") + '"/>'),
    ),
    _construct(
        "remaps in arguments",
        lambda count: launch('<node pkg="demo" exec="talk" name="n" args="--ros-args ' + times(count, "-r a{}:=b{}", " ") + '"/>'),
    ),
    _construct(
        "components",
        lambda count: launch('<node_container pkg="demo" exec="talk" name="n" namespace="">', times(count, COMPONENT), "</node_container>"),
    ),
    _repeated("containers", f'<node_container pkg="demo" exec="talk" name="m{{}}" namespace="">{COMPONENT}</node_container>'),
    _repeated(
        "loaded components",
        f'<load_composable_node target="m">{COMPONENT}</load_composable_node>',
        before='<node_container pkg="demo" exec="talk" name="m" namespace=""/>',
    ),
    _repeated("lifecycle nodes", '<node pkg="nav2_map_server" exec="map_server" name="m{}"/>'),
    _repeated("timers", f'<timer period="1.0">{EACH}</timer>'),
    _repeated("processes", '<executable cmd="ls {}"/>'),
    _repeated("packages nobody has", '<node pkg="demo{}" exec="talk" name="n{}"/>'),
    _repeated("programs nobody has", '<node pkg="demo" exec="talk{}" name="n{}"/>'),
    _repeated("files nobody has", '<include file="$(dirname)/c{}.launch.xml"/>'),
    _construct(
        "includes of one file", lambda count: launch(times(count, INNER)), lambda _: {"b.launch.xml": launch('<let name="x" value="1"/>')}
    ),
    _construct(
        "includes with an arg",
        lambda count: launch(times(count, '<include file="$(dirname)/b.launch.xml"><arg name="a" value="{}"/></include>')),
        lambda _: {"b.launch.xml": launch('<arg name="a"/>', '<let name="x" value="$(var a)"/>')},
    ),
    _construct(
        "files",
        lambda count: launch(times(count, '<include file="$(dirname)/b{}.launch.xml"/>')),
        lambda count: {f"b{number}.launch.xml": launch(EACH.replace("{}", str(number))) for number in range(count)},
        most=10_000,
    ),
    _construct(
        "depth of includes", lambda _: launch('<include file="$(dirname)/b0.launch.xml"/>'), lambda count: _levels(count, 1), most=10_000
    ),
    _construct(
        "includes that meet again",
        lambda _: launch('<include file="$(dirname)/b0.launch.xml"/>'),
        lambda count: _levels(isqrt(count), 2),
        most=10_000,
        product=True,
    ),
    _construct(
        "args handed on",
        lambda count: launch('<include file="$(dirname)/b.launch.xml">', times(count, '<arg name="a{}" value="1"/>'), "</include>"),
        lambda count: {"b.launch.xml": launch(times(count, '<arg name="a{}"/>'))},
    ),
    _construct(
        "args nobody takes",
        lambda count: launch('<include file="$(dirname)/b.launch.xml">', times(count, '<arg name="b{}" value="1"/>'), "</include>"),
        lambda count: {"b.launch.xml": launch(times(count, '<arg name="a{}" default="1"/>'))},
    ),
    _repeated("publishers", TALKER),
    _repeated("pairs", TALKER + LISTENER.replace("{to}", "topic{}")),
    _repeated("pairs that just miss", TALKER + LISTENER.replace("{to}", "topik{}")),
    _repeated("a hub", (TALKER + LISTENER).replace("topic{}", "topic").replace("{to}", "topic")),
    _repeated("subscribers among unknown nodes", LISTENER.replace("{to}", "topic{}") + EACH),
    _yaml("nodes of YAML", '- node: {pkg: demo, exec: talk, name: "n{}"}'),
    _yaml("args of YAML", '- arg: {name: "a{}", default: "1"}'),
    _yaml("unknown actions of YAML", "- nod: {}"),
    _construct("depth of YAML", lambda count: "launch:\n- " + "{group: [" * count + "]}" * count + "\n", entry="launch/a.launch.yaml"),
    _parameters("parameters of a file", lambda count: "one:\n  ros__parameters:\n" + times(count, "    p{}: 1") + "\n"),
    _parameters("nodes of a parameter file", lambda count: times(count, "n{}: {ros__parameters: {a: 1}}") + "\n"),
    _parameters("depth of a parameter file", lambda count: "one:\n  ros__parameters: " + "{a: " * count + "1" + "}" * count + "\n"),
    _parameters("list of a parameter file", lambda count: "one:\n  ros__parameters: {a: [" + times(count, "1", ", ") + "]}\n"),
    _parameters("wildcards of a parameter file", lambda count: times(count, "/**/n{}: {ros__parameters: {a: 1}}") + "\n"),
)
