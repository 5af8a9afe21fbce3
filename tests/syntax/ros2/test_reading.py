"""Launch files in XML and YAML read as launch's front ends do: what they describe, what is refused, in which order and where."""

from __future__ import annotations

import gc
import sys
import time

import pytest

from launchlint.evaluate.ros2.launch import DEEPEST_STACK
from launchlint.syntax.ros2.complaints import attributes_of
from launchlint.syntax.ros2.description import (
    Argument,
    Executable,
    Group,
    Include,
    Node,
    Parameter,
    ParameterFile,
    Substitution,
    Text,
    Timer,
    TypedValue,
)
from launchlint.syntax.ros2.order import ORDER
from launchlint.syntax.ros2.reading import Reading, read
from launchlint.syntax.ros2.tables import PARAMETER, Children, distribution


def xml(body: str, distro: str = "jazzy") -> Reading:
    return read(f"<launch>{body}</launch>".encode(), "a.launch.xml", distro=distro)


def yaml(body: str, distro: str = "jazzy") -> Reading:
    return read(f"launch:\n{body}".encode(), "a.launch.yaml", distro=distro)


def told(reading: Reading) -> list[tuple[str, str]]:
    """Kind of each problem, and what is written at its place."""
    return [(problem.kind, problem.place.text) for problem in reading.problems]


NODE = '<node pkg="p" exec="e" {}/>'
PARAM = '<node pkg="p" exec="e" name="n"><param {}/></node>'

REFUSED_XML = [
    ("<noed/>", [("unknown-action", "noed")]),
    ("<param name='a' value='1'/>", [("misplaced-entity", "param")]),
    ("<rosparam file='f'/>", [("of-ros1", "rosparam")]),
    ("<choice value='a'/>", [("misplaced-entity", "choice")]),
    ("<node pkg='p' exec='e'><let name='a' value='b'/></node>", [("misplaced-entity", "let")]),
    ("<include file='f'><remap from='a' to='b'/></include>", [("misplaced-entity", "remap")]),
    ("<node pkg='p' type='e'/>", [("lacks-attribute", "node"), ("of-ros1", "type")]),
    ("<log message='$(find p) $(optenv A b)'/>", [("of-ros1", "$(find p)"), ("of-ros1", "$(optenv A b)")]),
    ("<lifecycle_node/>", [("not-in-distribution", "lifecycle_node")]),
    ("<node pkg='p'/>", [("lacks-attribute", "node")]),
    (NODE.format('respwan="true"'), [("unread-attribute", "respwan")]),
    (NODE.format('if="1" unless="0"'), [("both-conditions", "unless")]),
    (NODE.format('respawn_delay="x"'), [("wrong-value", "x")]),
    (NODE.format('respawn_delay="$(var x)"'), [("broken-in-frontend", "$(var x)")]),
    (NODE.format('respawn_delay="-1"'), [("negative-value", "-1")]),
    (NODE.format('shell="[1]"'), [("wrong-value", "[1]")]),
    (NODE.format('on_exit="restart"'), [("wrong-value", "restart")]),
    (NODE.format("""args="a 'b" """), [("open-quote", "a 'b")]),
    (NODE.format('name-sep=";" name="a;b"'), [("wrong-value", "a;b")]),
    ("<node pkg='p' exec='e'><parm/></node>", [("unknown-action", "parm")]),
    ("<node pkg='p' exec='e'><remap from='a' if='1'/></node>", [("lacks-attribute", "remap"), ("unread-attribute", "if")]),
    ("<include file='f'><arg name='a' default='1'/></include>", [("lacks-attribute", "arg"), ("unread-attribute", "default")]),
    ("<node_container pkg='p' exec='e' name='n'/>", [("lacks-attribute", "node_container")]),
    ("<load_composable_node target='t'/>", [("lacks-attribute", "load_composable_node")]),
    ("<timer period='soon'/>", [("wrong-value", "soon")]),
    ("<append_env name='a' value='b' prepend='maybe'/>", [("wrong-value", "maybe")]),
    (PARAM.format("value='1'"), [("parameter-form", "param")]),
    (PARAM.format("name='a'"), [("parameter-form", "param")]),
    (PARAM.format("name='a' from='f'"), [("parameter-form", "f"), ("unread-attribute", "name")][:1]),
    (PARAM.format("name='a' value='1' allow_substs='true'"), [("parameter-form", "allow_substs")]),
    (PARAM.format("name='a' value='1' type='string'"), [("wrong-value", "string")]),
    (PARAM.format("name='a' value='null'"), [("wrong-value", "null")]),
    (PARAM.format("name='a' value='[1, a]'"), [("wrong-value", "[1, a]")]),
    (PARAM.format("name='a' value='abc' type='int'"), [("wrong-value", "abc")]),
    (PARAM.format("name='a' value='[1, 2]' type='list_of_str'"), [("wrong-value", "[1, 2]")]),
    ("<group if='false'><noed/></group>", [("unknown-action", "noed")]),
]


@pytest.mark.parametrize(("body", "expected"), REFUSED_XML)
def test_refused_xml(body: str, expected: list[tuple[str, str]]) -> None:
    reading = xml(body)
    assert told(reading) == expected
    assert reading.refusal is reading.problems[0]


REFUSED_YAML = [
    ("- node: {pkg: p, exec: e, name: 5}", [("wants-text", "5")]),
    ("- node: {pkg: p, exec: e, if: true}", [("wants-text", "true")]),
    ("- node: {pkg: p, exec: e, respwan: 'true'}", [("unread-attribute", "respwan")]),
    ("- arg: {name: a, default: 1}", [("wants-text", "1")]),
    ("- timer: {period: 1, children: []}", [("wants-fraction", "1")]),
    ("- node: {pkg: p, exec: e, remap: {from: a, to: b}}", [("yaml-form", "remap")]),
    ("- node: {pkg: p, exec: e, remap: []}", [("yaml-form", "remap")]),
    ("- node: {pkg: p, exec: e, param: [{name: a, value: {b: 1}}]}", [("wrong-value", "{b: 1}")]),
    ("- group: {scoped: false}", [("yaml-form", "group")]),
    ("- node", [("yaml-form", "node")]),
    ("- {node: {pkg: p, exec: e}, group: []}", [("yaml-form", "group")]),
    ("- reset_env:", [("yaml-form", "reset_env")]),
    ("  node: {pkg: p, exec: e}", [("yaml-form", "launch")]),
    ("- node: !!python/name:os.system x", [("malformed-yaml", "!")]),
    ("- node: {pkg: p", [("malformed-yaml", "")]),
    ("- noed: {}", [("unknown-action", "noed")]),
]


@pytest.mark.parametrize(("body", "expected"), REFUSED_YAML)
def test_refused_yaml(body: str, expected: list[tuple[str, str]]) -> None:
    reading = yaml(body)
    assert told(reading) == expected
    assert reading.refusal is reading.problems[0]


@pytest.mark.parametrize(
    ("text", "name", "kind"),
    [
        ("<launch><node</launch>", "a.launch.xml", "malformed-xml2"),
        ("", "a.launch.xml", "malformed-xml2"),
        ("", "a.launch.yaml", "wrong-root"),
        ("<lunch/>", "a.launch.xml", "wrong-root"),
        ("<launch xmlns='urn:x'/>", "a.launch.xml", "wrong-root"),
        ("lunch: []", "a.launch.yaml", "wrong-root"),
        ("launch: []\nother: []", "a.launch.yaml", "wrong-root"),
        ("launch:", "a.launch.yaml", "yaml-form"),
        ("launch: [", "a.launch.xml", "malformed-xml2"),
    ],
)
def test_files_that_are_no_launch_files(text: str, name: str, kind: str) -> None:
    reading = read(text.encode(), name)
    assert reading.refusal is not None
    assert reading.refusal.kind == kind


def test_the_content_says_what_a_file_is_and_not_its_name() -> None:
    assert not read(b"launch: []", "a.launch.xml").problems
    assert not read(b"<launch/>", "a.launch.yaml").problems


def test_text_is_utf8_whatever_the_declaration_says() -> None:
    body = '<launch><node pkg="p" exec="e" name="\xe4"/></launch>'
    reading = read(f'<?xml version="1.0" encoding="ISO-8859-1"?>{body}'.encode(), "a.launch.xml")
    (node,) = reading.description.actions
    assert isinstance(node, Node)
    assert node.name is not None
    assert node.name.literal == "\xe4"
    assert node.name.place.text == "\xe4"
    assert read(f'<?xml version="1.0" encoding="ISO-8859-1"?>{body}'.encode("latin-1"), "a.launch.xml").refusal is not None


@pytest.mark.parametrize("distro", ["humble", "jazzy", "rolling"])
def test_attributes_that_humble_lacks(distro: str) -> None:
    body = NODE.format('emulate_tty="true" on_exit="shutdown"') + "<set_ros_log_dir new_log_dir='d'/>"
    expected = ["emulate_tty", "on_exit", "set_ros_log_dir"] if distro == "humble" else []
    assert sorted(problem.place.text for problem in xml(body, distro).problems) == expected


def test_what_launch_reads_first_is_told_first() -> None:
    """In each entity: its own attributes, what stands in it, and what nobody reads, which launch looks for last."""
    body = '<group bad="1" if="$(nope)"><node exec="$(nope2)" worse="2"><remap from="a" to="$(nope3)"/></node></group>'
    assert [problem.place.text for problem in xml(body).problems] == ["$(nope)", "$(nope2)", "$(nope3)", "worse", "bad"]


def test_a_node_with_everything() -> None:
    reading = xml(
        '<node pkg="p" exec="e" name="n" namespace="/s" args="--a $(var x)/b &quot;c d&quot;" exec_name="l" respawn="true"'
        ' respawn_delay="1.5" unless="$(var off)"><env name="A" value="1"/><remap from="a" to="b"/><param from="$(dirname)/p.yaml"'
        ' allow_substs="true"/><param name="q"><param name="r" value="1;2" value-sep=";"/></param></node>'
    )
    assert not reading.problems
    (node,) = reading.description.actions
    assert isinstance(node, Node)
    assert [short(each) for each in node.arguments] == ["--a", "<var>/b", "c d"]
    assert node.process.respawn_delay == 1.5
    assert node.process.name is not None
    assert node.process.name.literal == "l"
    assert node.condition is not None
    assert node.condition.kind == "unless"
    file, outer = node.parameters
    assert isinstance(file, ParameterFile)
    assert file.allow_substs is True
    assert isinstance(outer, Parameter)
    value = outer.nested[0].value
    assert value is not None
    assert value.plain == (1, 2)


def short(text: Text) -> str:
    return "".join(each if isinstance(each, str) else f"<{each.name}>" for each in text.pieces)


@pytest.mark.parametrize(
    ("given", "kind", "plain"),
    [
        ("value='1'", None, 1),
        ("value='1.0'", None, 1.0),
        ("value='y'", None, "y"),
        ("value='yes'", None, True),
        ("value='1e3'", None, "1e3"),
        ("value=\"'1'\"", None, "1"),
        ("value='1' type='str'", "str", "1"),
        ("value='1' type='bool'", "bool", True),
        ("value='1' type='yaml'", None, 1),
        ("value='1' type='float'", "float", 1.0),
        ("value='[1, 2]'", None, (1, 2)),
        ("value='[a, $(var b)]'", None, ("a", None)),
        ("value='$(var b)'", None, None),
        ("value='$(var b)' type='int'", "int", None),
        ("value=''", None, ""),
    ],
)
def test_values_of_params(given: str, kind: str | None, plain: object) -> None:
    reading = xml(PARAM.format(f"name='a' {given}"))
    assert not reading.problems
    (node,) = reading.description.actions
    assert isinstance(node, Node)
    parameter = node.parameters[0]
    assert isinstance(parameter, Parameter)
    assert isinstance(parameter.value, TypedValue)
    assert parameter.value.type == kind
    assert parameter.value.plain == plain
    assert type(parameter.value.plain) is type(plain)


def test_both_syntaxes_describe_the_same() -> None:
    from_xml = xml(
        '<arg name="a" default="1"><choice value="1"/></arg><include file="$(dirname)/x"><arg name="b" value="$(var a)"/></include>'
        '<group scoped="false"><keep name="k" value="v"/><executable cmd="ls -l"/></group><timer period="1.0"><reset_env/></timer>'
    )
    from_yaml = yaml(
        "- arg: {name: a, default: '1', choice: [{value: '1'}]}\n"
        "- include:\n    file: $(dirname)/x\n    arg:\n    - name: b\n      value: $(var a)\n"
        "- group:\n    scoped: false\n    keep: [{name: k, value: v}]\n    children:\n    - executable: {cmd: ls -l}\n"
        "- timer: {period: 1.0, children: [reset_env: {}]}\n"
    )
    assert not from_xml.problems
    assert not from_yaml.problems
    assert without_places(from_xml.description.actions) == without_places(from_yaml.description.actions)
    argument, include, group, timer = from_yaml.description.actions
    assert isinstance(argument, Argument)
    assert argument.choices == ("1",)
    assert isinstance(include, Include)
    assert include.arguments[0].value.place.text == "$(var a)"
    assert isinstance(group, Group)
    assert not group.scoped
    assert isinstance(group.actions[0], Executable)
    assert isinstance(timer, Timer)
    assert timer.period == 1.0


def without_places(value: object) -> object:
    if hasattr(value, "_asdict"):
        fields = value._asdict()
        return [type(value).__name__, *(without_places(each) for name, each in fields.items() if name != "place")]
    return [without_places(each) for each in value] if isinstance(value, tuple) else value


@pytest.mark.parametrize(
    "text",
    [
        '<launch><log message="a &lt;b&gt; $(var x)&#10; c"/></launch>',
        '<!DOCTYPE launch [<!ENTITY e "zz">]><launch><log message="&e;$(var x)"/></launch>',
        "launch:\n- log: {message: a $(var x)}",
        "launch:\n- log: {message: 'it''s $(var x)'}",
        'launch:\n- log: {message: "a\\t\\"\\u00e4 $(var x)"}',
        "launch:\n- log:\n    message: a\n      b $(var x)\n      c",
        "launch:\n- log:\n    message: >-\n      a  b\n      $(var x)\n",
        'launch:\n- log:\n    message: "a \\\n      b $(var x)"\n',
    ],
)
def test_places_survive_entities_quotes_and_folding(text: str) -> None:
    reading = read(text.encode(), "a.launch.xml" if text.startswith("<") else "a.launch.yaml")
    assert not reading.problems
    (log,) = reading.description.actions
    found = [each for each in log.message.pieces if isinstance(each, Substitution)]  # type: ignore[union-attr]
    assert [each.place.text for each in found] == ["$(var x)"]
    assert found[0].arguments[0].place.text == "x"


def test_text_between_tags_is_told_and_refuses_nothing() -> None:
    reading = xml("<log message='a'/> -->")
    assert told(reading) == [("unread-text", "-->")]
    assert reading.refusal is None


def test_yaml_keeps_the_last_of_equal_keys_and_merges() -> None:
    reading = yaml("- node: &n {pkg: p, exec: e, name: a, name: b}\n- node: {<<: *n, exec: f}\n")
    first, second = reading.description.actions
    assert isinstance(first, Node)
    assert isinstance(second, Node)
    assert first.name is not None
    assert first.name.literal == "b"
    assert (second.executable.literal, second.package and second.package.literal) == ("f", "p")


@pytest.mark.parametrize("piece", ["<group>", "<a>", "<group><param>", "<noed/>", "<log message='$(var x'/>"])
def test_great_files_take_linear_time(piece: str) -> None:
    began = time.process_time()
    closing = "".join(f"</{tag}" for tag in reversed(piece.split("<")[1:]) if "/" not in tag)
    xml(piece * 900 + closing * 900)
    xml(piece * 5_000)
    assert time.process_time() - began < 10


@pytest.mark.parametrize("value", ["[" * 40_000, "[" + "1, " * 300_000 + "1]", "&amp;a " * 100_000, "- " * 20_000])
def test_great_values_take_linear_time(value: str) -> None:
    gc.freeze()  # what other tests have left is not gone through meanwhile
    limit = sys.getrecursionlimit()
    sys.setrecursionlimit(DEEPEST_STACK)  # as where a file was evaluated before
    try:
        began = time.process_time()
        xml(f"<node pkg='p' exec='e'><param name='n' value='{value}'/></node>")
        assert time.process_time() - began < 10
    finally:
        gc.unfreeze()
        sys.setrecursionlimit(limit)


def test_deep_nesting_is_refused_and_does_not_overflow() -> None:
    reading = xml("<group>" * 900 + "</group>" * 900)
    assert [problem.kind for problem in reading.problems] == ["too-deep"]


def test_the_canonical_order_names_all_attributes_of_all_tags() -> None:
    for tag in distribution("rolling").tags.values():
        assert set(attributes_of(tag.reads)) <= set(ORDER.get(tag.name, ("if", "unless"))), tag.name
        for inner in tag.reads:
            if isinstance(inner, Children) and inner.name != "arg":
                assert set(attributes_of(inner.reads)) <= set(ORDER[inner.name]), inner.name
    assert set(PARAMETER) <= set(ORDER["param"])
