"""What one element and its parent tell: input, kind, place and fields side by side."""

from __future__ import annotations

from typing import Any

import pytest

from launchlint.problem import Problem
from launchlint.syntax.parse import parse
from launchlint.syntax.ros1.validate import KINDS, validate
from tests.syntax.fields import own_fields


def problems(content: str) -> list[Problem]:
    document = parse(f"<launch>{content}</launch>".encode(), "a.launch")
    assert document.problems == []
    return validate(document)


def shown(problem: Problem) -> tuple[Any, ...]:
    hidden = ("known", "owners", "choices", "instead", "environment", "behind_tag")
    fields = {name: value for name, value in own_fields(problem).items() if name not in hidden}
    return (problem.kind, problem.place.text, "refused" if problem.refused else "accepted", fields)


NODE = '<node name="n" pkg="p" type="t"{}/>'
TEST = '<test test-name="n" pkg="p" type="t"{}/>'
PARAM = '<param name="n" value="v"{}/>'

CASES: list[tuple[str, list[tuple[Any, ...]]]] = [
    (NODE.format("") + TEST.format("") + PARAM.format("") + '<arg name="a"/><env name="e" value=""/><remap from="a" to="b"/>', []),
    ('<group ns="a"><include file="f"><Arg name="a" value=""/><ENV name="e" value="1"/></include></group>', []),
    ('<node name="n" pkg="p" type="t"><Param name="x" value="1"/><REMAP from="a" to="b"/></node>', []),
    ('<machine name="m" address="a" ssh-port="" default="" timeout="1"/>', []),
    (
        '<nod name="x"/>',
        [("unknown-tag", "nod", "accepted", {"tag": "nod", "parent": "launch", "ignored": False})],
    ),
    (
        '<Node name="x"/>',
        [("unknown-tag", "Node", "accepted", {"tag": "Node", "parent": "launch", "ignored": False})],
    ),
    (
        '<param name="n" value="v"><foo/></param>',
        [("unknown-tag", "foo", "accepted", {"tag": "foo", "parent": "param", "ignored": True})],
    ),
    (
        '<node name="n" pkg="p" type="t"><NODE/><x/></node>',
        [
            ("misplaced-tag", "NODE", "accepted", {"tag": "NODE", "name": "", "parent": "node", "within": 8, "reported": True}),
            ("unknown-tag", "x", "accepted", {"tag": "x", "parent": "node", "ignored": False}),
        ],
    ),
    (
        '<include file="f"><param/></include><arg name="a"><arg/></arg>',
        [
            ("misplaced-tag", "param", "accepted", {"tag": "param", "name": "", "parent": "include", "within": 8, "reported": True}),
            ("misplaced-tag", "arg", "accepted", {"tag": "arg", "name": "", "parent": "arg", "within": 44, "reported": False}),
        ],
    ),
    (
        '<machine name="m" address="a"><env/><Env/></machine>',
        [
            ("deprecated-construct", "env", "refused", {"construct": "machine env"}),
            ("unknown-tag", "Env", "accepted", {"tag": "Env", "parent": "machine", "ignored": False}),
        ],
    ),
    (
        '<machine name="m" address="a" ros-root="/r" ros-ip=""/>',
        [
            ("deprecated-construct", "ros-root", "refused", {"construct": "machine ros-root"}),
            ("deprecated-construct", "ros-ip", "accepted", {"construct": "machine ros-ip"}),
        ],
    ),
    (
        '<master auto="start"/><rosparam ns="a">b: 1</rosparam><param name="r" command="$(find xacro)/xacro.py a.xacro"/>',
        [
            ("deprecated-construct", "master", "accepted", {"construct": "<master>"}),
            ("deprecated-construct", "ns", "accepted", {"construct": "rosparam ns"}),
            ("deprecated-construct", "xacro.py", "accepted", {"construct": "xacro.py"}),
        ],
    ),
    (
        NODE.format(' ouput="screen"'),
        [("unknown-attribute", "ouput", "accepted", {"tag": "node", "attribute": "ouput", "silent": False})],
    ),
    (
        '<node pkg="" type=" "/>',
        [
            ("missing-attribute", "node", "refused", {"tag": "node", "attribute": "name"}),
            ("invalid-value", '""', "refused", {"tag": "node", "attribute": "pkg", "value": "", "expected": "a name"}),
            ("invalid-value", " ", "refused", {"tag": "node", "attribute": "type", "value": " ", "expected": "a name"}),
        ],
    ),
    (
        '<node name="n" pkg="p" type="t"><Remap from="a"/></node>',
        [("missing-attribute", "Remap", "refused", {"tag": "remap", "attribute": "to"})],
    ),
    (
        'one<arg name="a">two</arg>\n<![CDATA[three]]><!-- -->\n  four &amp; five\n<group ns="a"> </group>',
        [
            ("stray-text", "one", "accepted", {"text": "one", "parent": "launch", "because": "tag"}),
            ("stray-text", "two", "accepted", {"text": "two", "parent": "arg", "because": "tag"}),
            ("stray-text", "three", "accepted", {"text": "three", "parent": "launch", "because": "tag"}),
            ("stray-text", "four &amp; five", "accepted", {"text": "four & five", "parent": "launch", "because": "tag"}),
            ("ineffective-attribute", "group", "accepted", {"tag": "group", "attribute": "", "reason": "empty-group"}),
        ],
    ),
    (
        '<rosparam file="f">a: 1</rosparam><rosparam command="delete" param="p">b</rosparam><rosparam command="dump"/><rosparam/>',
        [
            ("stray-text", "a: 1", "accepted", {"text": "a: 1", "parent": "rosparam", "because": "file"}),
            ("stray-text", "b", "accepted", {"text": "b", "parent": "rosparam", "because": "delete"}),
            ("missing-attribute", "rosparam", "accepted", {"tag": "rosparam", "attribute": "file"}),
            ("ineffective-attribute", "rosparam", "accepted", {"tag": "rosparam", "attribute": "", "reason": "empty-rosparam"}),
        ],
    ),
    (
        '<rosparam command="delete" file="f"/>',
        [
            (
                "conflicting-attributes",
                "file",
                "refused",
                {"tag": "rosparam", "attributes": ("command", "file"), "reason": "delete-with-file"},
            )
        ],
    ),
    (
        '<arg name="a" unless="0" if="$(arg b)"/><arg name="b" if="false" unless="true"/>',
        [("if-and-unless", "if", "refused", {"tag": "arg"}), ("if-and-unless", "unless", "refused", {"tag": "arg"})],
    ),
    (
        '<arg name="a" if=" TRUE "/><arg name="a" if="yes"/><arg name="a" if=""/><arg name="a" if="$(arg b)"/>',
        [
            ("invalid-value", "yes", "refused", {"tag": "arg", "attribute": "if", "value": "yes", "expected": "true, false, 1 or 0"}),
            ("invalid-value", '""', "refused", {"tag": "arg", "attribute": "if", "value": "", "expected": "true, false, 1 or 0"}),
        ],
    ),
    (
        PARAM.format(' type="$(arg t)"') + PARAM.format(' type=" Int "') + '<param name="n" binfile="b" type="foo"/>',
        [
            (
                "invalid-value",
                "$(arg t)",
                "refused",
                {"tag": "param", "attribute": "type", "value": "$(arg t)", "expected": "auto, str, int, double, bool or yaml"},
            )
        ],
    ),
    (
        '<param name="a"/><param name="a" value="" textfile="f"/>',
        [
            ("conflicting-attributes", "param", "refused", {"tag": "param", "attributes": (), "reason": "param-sources"}),
            (
                "conflicting-attributes",
                "textfile",
                "refused",
                {"tag": "param", "attributes": ("value", "textfile"), "reason": "param-sources"},
            ),
        ],
    ),
    (
        NODE.format(' respawn="true" required="True"') + NODE.format(' ns=""') + TEST.format(' output="log" required="true"'),
        [
            (
                "conflicting-attributes",
                "required",
                "refused",
                {"tag": "node", "attributes": ("respawn", "required"), "reason": "respawn-and-required"},
            ),
            ("conflicting-attributes", 'ns=""', "refused", {"tag": "node", "attributes": ("ns",), "reason": "empty-ns"}),
            ("conflicting-attributes", "output", "refused", {"tag": "test", "attributes": ("output",), "reason": "test-attribute"}),
            ("ineffective-attribute", "required", "accepted", {"tag": "test", "attribute": "required", "reason": "required-on-test"}),
        ],
    ),
    (
        '<include file="f" clear_params="true"/><include file="f" clear_params=""/><include file="f" clear_params="1"/>',
        [
            (
                "conflicting-attributes",
                "clear_params",
                "refused",
                {"tag": "include", "attributes": ("clear_params",), "reason": "clear-params-without-ns"},
            ),
            ("invalid-value", "1", "refused", {"tag": "include", "attribute": "clear_params", "value": "1", "expected": "true or false"}),
        ],
    ),
    (
        '<arg name="a" value="1" default="2"/>',
        [("arg-value-and-default", "default", "refused", {"name": "a"})],
    ),
    (
        NODE.format(' respawn_delay="2"')
        + NODE.format(' respawn="true" respawn_delay="-2"')
        + NODE.format(' respawn="$(arg r)" respawn_delay="2"'),
        [
            (
                "ineffective-attribute",
                "respawn_delay",
                "accepted",
                {"tag": "node", "attribute": "respawn_delay", "reason": "respawn-delay-without-respawn"},
            ),
            (
                "ineffective-attribute",
                "respawn_delay",
                "accepted",
                {"tag": "node", "attribute": "respawn_delay", "reason": "negative-respawn-delay"},
            ),
        ],
    ),
    (
        '<let name="a" value="b"/><node pkg="p" exec="e" namespace="n"/><group namespace="n"><arg name="a"/></group>',
        [
            ("wrong-dialect", "let", "accepted", {"tag": "let", "what": "tag", "construct": "let"}),
            ("wrong-dialect", "exec", "refused", {"tag": "node", "what": "attribute", "construct": "exec"}),
            ("wrong-dialect", "namespace", "accepted", {"tag": "node", "what": "attribute", "construct": "namespace"}),
            ("unknown-attribute", "namespace", "accepted", {"tag": "group", "attribute": "namespace", "silent": False}),
        ],
    ),
    (
        '<arg name="a" default="x/$(find-pkg-share p)/$(var b)"/><arg name="c" default="$(eval arg(\'$(var b)\'))"/>',
        [
            (
                "wrong-dialect",
                "$(find-pkg-share p)",
                "refused",
                {"tag": "arg", "what": "substitution", "construct": "$(find-pkg-share …)"},
            ),
            ("wrong-dialect", "$(var b)", "refused", {"tag": "arg", "what": "substitution", "construct": "$(var …)"}),
        ],
    ),
    (
        '<group if="0"><node name="n"/></group><node if="false" pkg="p"/>',
        [
            ("missing-attribute", "node", "accepted", {"tag": "node", "attribute": "pkg"}),
            ("missing-attribute", "node", "accepted", {"tag": "node", "attribute": "type"}),
            ("missing-attribute", "node", "accepted", {"tag": "node", "attribute": "name"}),
            ("missing-attribute", "node", "accepted", {"tag": "node", "attribute": "type"}),
        ],
    ),
]


@pytest.mark.parametrize(("content", "expected"), CASES, ids=[content[:60] for content, _ in CASES])
def test_problems(content: str, expected: list[tuple[Any, ...]]) -> None:
    assert [shown(problem) for problem in problems(content)] == expected


@pytest.mark.parametrize(
    ("attributes", "expected"),
    [
        (' deprecated="use b.launch"', []),
        (' xmlns:xacro="u"', []),
        (' version="1"', [("unknown-attribute", "version", "accepted", {"tag": "launch", "attribute": "version", "silent": True})]),
        (
            ' if="false"',
            [("ineffective-attribute", "if", "accepted", {"tag": "launch", "attribute": "if", "reason": "condition-on-launch"})],
        ),
        (
            ' if="$(arg a)"',
            [
                (
                    "invalid-value",
                    "$(arg a)",
                    "refused",
                    {"tag": "launch", "attribute": "if", "value": "$(arg a)", "expected": "true, false, 1 or 0 (no $(…) on <launch>)"},
                )
            ],
        ),
    ],
)
def test_on_launch(attributes: str, expected: list[tuple[Any, ...]]) -> None:
    document = parse(f"<launch{attributes}/>".encode(), "a.launch")
    assert [shown(problem) for problem in validate(document)] == expected


def test_what_is_known_and_who_has_it() -> None:
    (tag,) = problems("<grup/>")
    assert tag.known == ("arg", "group", "include", "machine", "node", "test", "param", "rosparam", "remap", "env", "master")
    (attribute,) = problems('<group ns="a" file="x"><arg name="a"/></group>')
    assert (attribute.known, attribute.owners) == (("if", "unless", "clear_params"), ("rosparam", "include"))
    (value,) = problems(NODE.format(' output="Screen"'))
    assert value.choices == ("log", "screen")


@pytest.mark.parametrize(("content", "behind"), [('<arg name="a" value="1"/>"', True), ('<arg name="a" value="1"/> "', False)])
def test_what_stands_behind_a_tag(content: str, behind: bool) -> None:
    (text,) = problems(content)
    assert (text.kind, text.behind_tag) == ("stray-text", behind)


def test_every_kind_is_made_here() -> None:
    made = {type(problem) for content, _ in CASES for problem in problems(content)}
    assert made == set(KINDS)


def test_nothing_to_validate() -> None:
    assert validate(parse(b"", "a.launch")) == []
    assert validate(parse(b"<lauch/>", "a.launch")) == []
