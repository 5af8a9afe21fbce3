"""Evaluation goes on after a mistake: every mistake once, at its exact place, and none that only follows from another."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from launchlint.model import Launch
from launchlint.problem import Problem
from tests.evaluate.comparison import MAIN, Case, case, content, launch_of, write

MARK = re.compile("[«»]")
YAML = '<rosparam file="$(dirname)/p.yaml"/>'
GO = '<include file="$(dirname)/i.launch"/>'


def lines(launch: Launch) -> list[str]:
    """The problems as ``file:line:column kind``, those that roslaunch stops at with a ``!``."""
    return [line(problem) for problem in launch.problems]


def line(problem: Problem) -> str:
    position = problem.place.source.position(problem.place.span.start)
    return f"{problem.place.source.path}:{position.line}:{position.column} {problem.kind}{'!' if problem.refused else ''}"


def evaluated(each: Case, directory: Path) -> Launch:
    write(each, directory)
    return launch_of(each, directory)


# -- exact places ------------------------------------------------------------------------------------------------------------

PLACES = [
    ("arg-out-of-scope", case('<group><arg name="a" value="1"/></group><param name="x" value="a«$(arg a)»b"/>')),
    ("arg-override-refused", case('<arg name="«a»" value="1"/>', args={"a": "2"})),
    (
        "arg-override-refused",
        case('<include file="$(dirname)/i.launch"><arg name="«a»" value="1"/></include>', files={"i.launch": '<arg name="a" value="1"/>'}),
    ),
    (
        "arg-override-refused",
        case(
            '<arg name="a" default="1"/><include file="$(dirname)/i.launch" pass_all_args="«true»"/>',
            files={"i.launch": '<group><arg name="a" value="1"/></group>'},
        ),
    ),
    ("arg-redeclared", case('<arg name="a"/><arg name="«a»"/>')),
    (
        "arg-redeclared",
        case(
            '<include file="$(dirname)/i.launch"><arg name="a" value="1"/><arg name="«a»" value="1"/></include>',
            files={"i.launch": '<arg name="a"/>'},
        ),
    ),
    ("arg-value-and-default", case('<arg name="a" default="1" «value»="2"/>')),
    ("bad-substitution", case('<param name="x" value="a «$(args b)» c"/>')),
    ("bad-substitution", case('<param name="x" value="a «$(arg $»(arg b)) c"/>')),
    ("condition-not-boolean", case('<group if="«maybe»"/>')),
    ("condition-not-boolean", case("<group if=«''»/>")),
    ("condition-not-boolean", case('<launch unless="«maybe»"/>')),
    ("condition-on-launch", case('<launch if="«$(arg x)»"/>')),
    ("conflicting-attributes", case('<group «ns=""»/>')),
    ("conflicting-attributes", case('<param name="x" value="1" «command»="2"/>')),
    ("conflicting-attributes", case('<«param» name="x"/>')),
    ("conflicting-attributes", case('[[n respawn="true" «required»="true"]]')),
    ("conflicting-attributes", case('<group «clear_params»="true"/>')),
    ("conflicting-attributes", case('<test pkg="p" type="t" test-name="x" «output»="log"/>')),
    ("deprecated-construct", case('<machine name="m" address="h" «ros-ip»="1"/>')),
    ("deprecated-construct", case('<machine name="m" address="h"><«env» name="a" value="b"/></machine>')),
    ("deprecated-include", case('<include file="«$(dirname)/i.launch»"/>', files={"i.launch": '<launch deprecated="yes"/>'})),
    ("duplicate-node", case('[[a]]<node pkg="p" type="t" name="«a»"/>')),
    ("duplicate-node", case('<node pkg="p" type="t" name="«rosout»"/>')),
    ("env-unset", case('<param name="x" value="a«$(env NO)»b"/>')),
    ("env-unset", case('<param name="x" value="$(eval 1 + «env(\'NO\')»)"/>')),
    ("eval-error", case('<param name="x" value="$(eval 1 + «len(3)»)"/>')),
    ("eval-never-equal", case('<arg name="a" default="5"/><group if="$(eval «a == \'5\'»)"/>')),
    ("global-param-in-node", case('[[n | <param name="«/x»" value="1"/>]]')),
    ("if-and-unless", case('<group unless="0" «if»="1"/>')),
    ("if-and-unless", case('<launch unless="0" «if»="1"/>')),
    ("include-cycle", case('<include file="«$(dirname)/main.launch»"/>')),
    (
        "include-missing-arg",
        case('<include file="«$(dirname)/i.launch»"/>', files={"i.launch": '<arg name="a"/><param name="x" value="$(arg a)"/>'}),
    ),
    ("include-not-found", case('<include file="«$(dirname)/no.launch»"/>')),
    ("include-not-loadable", case('<include file="«$(dirname)/i.xml»"/>', files={"i.xml": "<robot/>"})),
    ("include-undeclared-arg", case('<include file="$(dirname)/i.launch"><arg name="«a»" value="1"/></include>', files={"i.launch": ""})),
    ("invalid-namespace", case('<group ns="«~a»"/>')),
    ("invalid-namespace", case('<group ns="«a-b»"/>')),
    ("invalid-node-name", case('<node pkg="p" type="t" name="«a/b»"/>')),
    ("invalid-node-name", case('<node pkg="p" type="t" «name»=""/>')),
    ("invalid-param-name", case('<param name="«a b»" value="1"/>')),
    ("invalid-remap-name", case('<remap from="x" to="«a b»"/>')),
    ("invalid-remap-name", case('<remap «from»="" to="b"/>')),
    ("invalid-value", case('[[n output="«both»"]]')),
    ("invalid-value", case("[[n respawn=«''»]]")),
    ("invalid-value", case('[[n respawn_delay="«soon»"]]')),
    ("machine-conflict", case('<machine name="m" address="h"/>«<machine name="m" address="i"/>»')),
    ("malformed-xml", case("<launch>\n  <node name='a'/>\n«</lauch>»")),
    ("missing-attribute", case('<«node» pkg="p" name="n"/>')),
    ("package-not-found", case('<param name="x" value="a «$(find nothing)»/b"/>')),
    ("package-not-found", case('<param name="x" value="«$(eval find(\'nothing\'))»"/>')),
    ("param-file-missing", case('<param name="x" textfile="«$(dirname)/no.txt»"/>')),
    ("param-file-missing", case('<rosparam file="«$(dirname)/no.yaml»"/>')),
    ("param-replaced", case('[[n | <param name="x" value="1"/>«<param name="x" value="2"/>»]]')),
    ("param-value-type", case('<param name="x" type="int" value="«1.5»"/>')),
    ("param-value-type", case('<param name="x" type="«float»" value="1.5"/>')),
    ("param-yaml-invalid", case("<rosparam>\n  a: 1\n  b: [1\n«<»/rosparam>")),
    ("param-yaml-invalid", case("<rosparam>{«1»: a}</rosparam>")),
    ("param-yaml-invalid", case(YAML, files={"p.yaml": "a: 1\n«1»: 2\n"})),
    ("remap-replaced", case('[[n | <remap from="a" to="b"/>«<remap from="a" to="c"/>»]]')),
    ("required-arg-unset", case('<arg name="«a»"/><param name="x" value="$(arg a)"/>')),
    ("root-not-launch", case("<«robot»/><!-- no <launch> -->")),
    ("unbalanced-quotes", case('[[n args="«a \'b»"]]')),
    ("unbalanced-quotes", case('<param name="x" command="«echo \'b»"/>')),
    ("undeclared-arg", case('<remap from="a" to="x«$(arg a)»"/>')),
    ("undeclared-arg", case('<remap from="a" to="x&#97;é«$( arg  a )»"/>')),
    ("undeclared-arg", case('<arg name="b" value="1"/><remap from="a" to="$(arg b)«$(arg a)»"/>')),
    ("undeclared-arg", case('<param name="x" value="$(eval 1 + «nothing»)"/>')),
    ("undeclared-arg", case("<rosparam subst_value='true'>\n  a: «$(arg b)»\n</rosparam>")),
    ("unexpanded-substitution", case('<param name="x" value="a «${arg b}» c"/>')),
    ("unexpanded-substitution", case("<rosparam>{a: «$(arg b)»}</rosparam>")),
    ("unknown-machine", case('[[n machine="«m»"]]')),
    ("used-before-declaration", case('<param name="x" value="«$(arg a)»"/><arg name="a" value="1"/>')),
    ("yaml-duplicate-key", case("<rosparam>\n  a: 1\n  «a»: 2\n</rosparam>")),
    ("yaml-duplicate-key", case(YAML, files={"p.yaml": "a: 1\n«a»: 2\n"})),
]


@pytest.mark.parametrize(
    ("kind", "marked"), [pytest.param(kind, marked, id=f"{kind} {index}") for index, (kind, marked) in enumerate(PLACES)]
)
def test_exact_place(kind: str, marked: Case, tmp_path: Path) -> None:
    expanded = {name: content(name, text).decode() for name, text in marked.files.items()}
    expected = next(text for text in expanded.values() if "«" in text)
    files = {name: MARK.sub("", text).encode() for name, text in expanded.items()}
    places = [problem.place for problem in evaluated(marked._replace(files=files), tmp_path).problems if problem.kind == kind]
    shown = [f"{source.text[: span.start]}«{source.text[span.start : span.end]}»{source.text[span.end :]}" for source, span in places]
    assert shown == [expected]


def test_tabs_line_ends_and_characters_of_two_units(tmp_path: Path) -> None:
    text = "\ufeff<launch>\r\n\t<!-- 🤖 -->\r\n\t<param name='🤖'\r\n\t\tvalue='🤖 $(arg x)'/>\r\n</launch>".encode()
    assert lines(evaluated(case(text), tmp_path)) == [f"{MAIN}:4:12 undeclared-arg!", f"{MAIN}:3:15 invalid-param-name"]


# -- one pass ----------------------------------------------------------------------------------------------------------------

MANY = """<launch>
  <arg name="a" value="1" default="2"/>
  <arg name="needed"/>
  <param name="p" value="$(arg needed)"/>
  <param name="q" type="int" value="x"/>
  <group ns="">
    <node pkg="p" type="t" name="a/b"/>
    <node pkg="p" name="c" output="both" respawn="1"/>
  </group>
  <node pkg="p" type="t" name="same">
    <remap from="" to=""/>
    <param name="x" value="$(arg typo)"/>
    <rosparam>[1, 2]</rosparam>
  </node>
  <node pkg="p" type="t" name="same" machine="nowhere"/>
  <include file="$(find nothing)/x.launch"/>
  <include file="$(dirname)/no.launch"/>
  <include file="$(dirname)/i.launch">
    <arg name="wrong" value="1"/>
  </include>
  <group if="perhaps">
    <param name="r"/>
  </group>
</launch>
"""


def test_many_mistakes_in_one_pass(tmp_path: Path) -> None:
    inner = '<launch>\n  <arg name="right"/>\n  <param name="p" value="$(arg right) $(env NOT_SET)"/>\n</launch>'
    assert lines(evaluated(case(MANY, files={"i.launch": inner}), tmp_path)) == [
        f"{MAIN}:2:27 arg-value-and-default!",
        f"{MAIN}:3:14 required-arg-unset!",
        f"{MAIN}:5:37 param-value-type!",
        f"{MAIN}:6:10 conflicting-attributes!",
        f"{MAIN}:7:34 invalid-node-name!",
        f"{MAIN}:8:6 missing-attribute!",
        f"{MAIN}:8:51 invalid-value!",
        f"{MAIN}:8:36 invalid-value!",
        f"{MAIN}:11:12 invalid-remap-name!",
        f"{MAIN}:11:20 invalid-remap-name!",
        f"{MAIN}:12:28 undeclared-arg!",
        f"{MAIN}:13:6 param-yaml-invalid!",
        f"{MAIN}:15:32 duplicate-node!",
        f"{MAIN}:16:18 package-not-found!",
        f"{MAIN}:17:18 include-not-found!",
        f"{MAIN}:19:16 include-undeclared-arg!",
        f"{MAIN}:18:18 include-missing-arg!",
        "i.launch:3:39 env-unset!",
        f"{MAIN}:21:14 condition-not-boolean!",
        f"{MAIN}:22:6 conflicting-attributes",
        f"{MAIN}:15:47 unknown-machine!",
    ]


# -- no cascades -------------------------------------------------------------------------------------------------------------

USES = """
  <param name="x" value="$(arg {0})" type="int"/><param name="$(arg {0})" value="1"/>
  <node pkg="$(arg {0})" type="t" name="n$(arg {0})" respawn="$(arg {0})" output="$(arg {0})" machine="$(arg {0})" args="'$(arg {0})"/>
  <remap from="$(arg {0})" to="-$(arg {0})"/><env name="$(arg {0})" value="1"/>
  <group ns="$(arg {0})" if="$(arg {0})"><node pkg="p" type="t" name="a"/></group>
  <group ns="$(arg {0})" unless="$(arg {0})"><node pkg="p" type="t" name="a"/></group>
  <rosparam file="$(arg {0}).yaml" ns="$(arg {0})"/><rosparam subst_value="true">[$(arg {0})]</rosparam>
  <param name="y" textfile="$(arg {0})"/><param name="z" value="$(eval {0} + 1)"/>
  <machine name="$(arg {0})" address="h" timeout="$(arg {0})" default="$(arg {0})"/>
  <include file="$(arg {0})"/><include file="$(find $(arg {0}))/x"/>
  <include file="$(dirname)/i.launch"><arg name="v" value="$(arg {0})"/></include>
  <test pkg="p" type="t" test-name="$(arg {0})" time-limit="$(arg {0})" retry="$(arg {0})"/>
"""
EXPECTED_IN_USES = ["bad-substitution"]  # $(find $(arg …)), which is wrong by itself
TAKES = {
    "i.launch": '<arg name="v"/><param name="w" value="$(arg v)" type="double"/><group if="$(arg v)">'
    '<arg name="u" value="$(eval v * 2)"/></group>'
}

NO_CASCADES: dict[str, tuple[Case, list[str]]] = {
    "an undeclared arg": (case(USES.format("a"), files=TAKES), ["undeclared-arg", *EXPECTED_IN_USES]),
    "a required arg": (case('<arg name="a"/>' + USES.format("a"), files=TAKES), ["required-arg-unset", *EXPECTED_IN_USES]),
    "an arg made from a variable that is not set": (
        case('<arg name="a" value="$(env NO)"/>' + USES.format("a"), files=TAKES),
        ["env-unset", *EXPECTED_IN_USES],
    ),
    "an arg made from a package that is not here": (
        case('<arg name="a" default="$(find no)/x"/>' + USES.format("a"), files=TAKES),
        ["package-not-found", *EXPECTED_IN_USES],
    ),
    "an arg made from an expression that fails": (
        case('<arg name="a" default="$(eval 1/0)"/>' + USES.format("a"), files=TAKES),
        ["eval-error", *EXPECTED_IN_USES],
    ),
    "an arg made from a wrong substitution": (
        case('<arg name="a" default="$(bad)"/>' + USES.format("a"), files=TAKES),
        ["bad-substitution", *EXPECTED_IN_USES],
    ),
    "an arg made from an arg that is not known": (
        case('<arg name="b" default="$(env NO)"/><arg name="a" default="$(arg b)"/>' + USES.format("a"), files=TAKES),
        ["env-unset", *EXPECTED_IN_USES],
    ),
    "an arg that is declared after it is read": (
        case('<param name="x" value="$(arg a)"/><arg name="a" value="1"/><param name="y" value="$(arg a)" type="int"/>'),
        ["used-before-declaration"],
    ),
    "an arg that is declared with a default after it is read": (
        case('<param name="x" value="$(arg a)"/><arg name="a" default="word"/><param name="y" value="$(arg a)" type="int"/>'),
        ["used-before-declaration", "param-value-type"],
    ),
    "an arg that is passed on": (
        case('<include file="$(dirname)/i.launch" pass_all_args="true"/><arg name="b" value="$(arg v)"/>', files=TAKES),
        ["include-missing-arg", "undeclared-arg"],
    ),
    "an unknown arg that is passed to all": (
        case('<arg name="v" value="$(env NO)"/><include file="$(dirname)/i.launch" pass_all_args="true"/>', files=TAKES),
        ["env-unset"],
    ),
    "two nodes of unknown names": (case('<arg name="a" value="$(env NO)"/>[[$(arg a)]][[$(arg a)]]'), ["env-unset"]),
    "two nodes in unknown namespaces": (case('<arg name="a" value="$(env NO)"/>[[n ns="$(arg a)"]][[n ns="$(arg a)"]]'), ["env-unset"]),
    "two nodes under unknown conditions": (
        case('<arg name="a" value="$(env NO)"/>[[n if="$(arg a)"]][[n unless="$(arg a)"]]'),
        ["env-unset"],
    ),
    "an arg declared under unknown conditions": (
        case('<arg name="a" value="$(env NO)"/><arg name="b" value="1" if="$(arg a)"/><arg name="b" value="2" unless="$(arg a)"/>'),
        ["env-unset"],
    ),
    "a file that cannot be included": (
        case('<include file="$(dirname)/no.launch"><arg name="a" value="1"/></include>[[n]]'),
        ["include-not-found"],
    ),
    "a machine that is not known": (case('<machine name="m" address="$(env NO)" default="true"/>[[n machine="m"]]'), ["env-unset"]),
}


@pytest.mark.parametrize(("each", "expected"), [pytest.param(*found, id=name) for name, found in NO_CASCADES.items()])
def test_no_cascades(each: Case, expected: list[str], tmp_path: Path) -> None:
    assert [problem.kind for problem in evaluated(each, tmp_path).problems] == expected


def test_what_stands_under_an_unknown_condition_refuses_nothing(tmp_path: Path) -> None:
    launch = evaluated(
        case('<group if="$(env NO)"><param name="x"/><include file="$(dirname)/i.launch"/></group>', files={"i.launch": "<param/>"}),
        tmp_path,
    )
    assert [(problem.kind, problem.refused, problem.assumed) for problem in launch.problems] == [
        ("env-unset", True, False),
        ("conflicting-attributes", False, True),
        ("conflicting-attributes", False, True),
        ("missing-attribute", False, True),
    ]


def test_what_is_known_of_a_refused_file(tmp_path: Path) -> None:
    launch = evaluated(case('[[a]]<param name="x" value="$(arg no)"/>[[b args="$(arg no)"]]<param name="y" value="2"/>'), tmp_path)
    assert [(node.full_name, sorted(node.unknown)) for node in launch.nodes] == [("/a", []), ("/b", ["arguments"])]
    assert repr(launch.parameters["/x"].value) == "Unknown('$(arg no)', 'the arg no has no value')"
    assert launch.parameters["/y"].value == 2


# -- include chains ----------------------------------------------------------------------------------------------------------

CHAIN = case(
    "<launch>\n  <group>\n    <include file='$(dirname)/one.launch'/>\n  </group>\n"
    "  <include file='$(dirname)/two.launch' ns='b'/>\n</launch>",
    files={
        "one.launch": "<launch>\n\n  <include file='$(dirname)/two.launch' ns='a'/></launch>",
        "two.launch": "<launch>\n  <node pkg='p' type='t' name='n'>\n    <param name='x' value='$(arg no)'/>\n"
        "    <remap from='q' to='r'/>\n  </node>\n"
        "  <machine name='m' address='h'/>\n  <param name='~late' value='1'/></launch>",
    },
)


def chain(steps: tuple[object, ...]) -> list[str]:
    found = []
    for step in steps:
        source, span = step  # type: ignore[misc]
        found.append(f"{source.path}:{source.position(span.start).line}")
    return found


def test_include_chains(tmp_path: Path) -> None:
    launch = evaluated(CHAIN, tmp_path)
    by_one, direct = [f"{MAIN}:3", "one.launch:3"], [f"{MAIN}:5"]
    assert [(line(problem), chain(problem.origin.chain)) for problem in launch.problems] == [
        ("two.launch:3:28 undeclared-arg!", by_one),
        ("two.launch:3:28 undeclared-arg!", direct),
    ]
    assert [(node.full_name, chain(node.origin.chain)) for node in launch.nodes] == [("/a/n", by_one), ("/b/n", direct)]
    assert [chain(node.remaps[0].origin.chain) for node in launch.nodes] == [by_one, direct]
    assert [(setting.name, chain(setting.origin.chain)) for setting in launch.parameter_settings] == [
        ("/a/n/x", by_one),
        ("/b/n/x", direct),
    ]
    assert [chain(machine.origin.chain) for machine in launch.machines.values()] == [by_one]
    assert [(include.file.rpartition("/")[2], chain(include.origin.chain)) for include in launch.includes] == [
        ("one.launch", []),
        ("two.launch", [f"{MAIN}:3"]),
        ("two.launch", []),
    ]
    assert [(setting.key, chain(setting.origin.chain)) for setting in launch.settings] == [("~late", by_one), ("~late", direct)]


def test_a_leaked_private_param_keeps_its_chain(tmp_path: Path) -> None:
    files = {
        "one.launch": "<include file='$(dirname)/two.launch'/>",
        "two.launch": "<param name='~b' value='2'/>",
        "three.launch": "[[n]]",
    }
    launch = evaluated(
        case(
            "<launch><param name='~a' value='1'/>\n<include file='$(dirname)/one.launch'/>\n<include file='$(dirname)/three.launch'/>"
            "</launch>",
            files=files,
        ),
        tmp_path,
    )
    assert [(setting.name, chain(setting.origin.chain), setting.node) for setting in launch.parameter_settings] == [
        ("/n/a", [], "/n"),
        ("/n/b", [f"{MAIN}:2", "one.launch:1"], "/n"),
    ]
