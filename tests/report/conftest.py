"""Findings to render: a plain set that looks like what launchlint says, and a hostile one."""

from __future__ import annotations

from collections.abc import Mapping

import pytest

from launchlint.finding import Edit, Finding, Fix, Location, Related, Severity
from launchlint.report.run import RuleMetadata, Run
from launchlint.source import Place, Source, Span

NAV = Source(
    "nav.launch",
    """\
<launch>
  <arg name="slam" default="true"/>
  <arg name="sacn" default="/scan"/>
  <group ns="robot1">

    <node pkg="amcl" type="amcl" name="amcl"/>

    <group unless="$(arg slam)">
      <node pkg="amcl" type="amcl" name="amcl"/>
    </group>
  </group>
\t<include file="$(find my_robot)/launch/wheels.launch">
\t\t<arg name="radius" value="0.1"/>
\t</include>
  <param name="表示名" value="ロボット" type="string"/> <param name="rate" value="fast" type="int"/>
  <node pkg="tf" type="static_transform_publisher" name="base_to_laser"
        args="0.1 0 0.2 0 0 0 base laser 100"
        respawn="true" required="true"/>
</launch>
""",
)
WHEELS = Source("launch/wheels.launch", '<launch>\n  <node pkg="amcl" type="amcl" name="wheel driver"/>\n</launch>\n')
LONG = Source("long.launch", f'<launch><param name="a" value="{"0123456789" * 40}"/><remap from="x" to="x"/>{"<!-- . -->" * 40}</launch>\n')


def at(source: Source, text: str, occurrence: int = 1) -> Location:
    """The location of ``text`` in ``source``."""
    start = -1
    for _ in range(occurrence):
        start = source.text.index(text, start + 1)
    return Location.of(Place(source, Span(start, start + len(text))))


PLAIN = [
    Finding(
        "LL301",
        "duplicate-node-name",
        Severity.ERROR,
        at(NAV, 'name="amcl"', 2),
        "two nodes are named /robot1/amcl",
        label="the second one",
        related=(Related(at(NAV, 'name="amcl"'), "the first one"),),
        notes=("roslaunch stops with: multiple nodes named [/robot1/amcl]",),
        help="rename one, or put them into different namespaces",
        entry="nav.launch",
        arguments=(("slam", "false"),),
        entries=1,
        element='<node pkg="amcl" type="amcl" name="amcl"/>',
    ),
    Finding(
        "LL302",
        "invalid-node-name",
        Severity.WARNING,
        at(WHEELS, "wheel driver"),
        "wheel driver is no valid node name",
        label="a blank in a name",
        chain=(at(NAV, "<include"),),
        help="write wheel_driver",
        entry="nav.launch",
        arguments=(("frame", "base link"), ("empty", "")),
        entries=3,
        element='<node pkg="amcl" type="amcl" name="wheel driver"/>',
        fix=Fix("write wheel_driver", False, (Edit("launch/wheels.launch", 46, 58, "wheel_driver"),)),
    ),
    Finding(
        "LL404",
        "include-missing-arg",
        Severity.ERROR,
        at(NAV, '<include file="$(find my_robot)/launch/wheels.launch">\n\t\t<arg name="radius" value="0.1"/>\n\t</include>'),
        "the include does not pass width, which launch/wheels.launch requires",
        label="passes only radius",
        related=(Related(at(WHEELS, "<launch>"), "requires width"),),
        help='add <arg name="width" value="…"/>',
        entry="nav.launch",
        entries=1,
        element="<include>",
    ),
    Finding(
        "LL501",
        "param-value-type",
        Severity.ERROR,
        at(NAV, "fast"),
        "fast is no int",
        related=(Related(at(NAV, 'type="int"'), "the type is written here"),),
        entry="nav.launch",
        element='<param name="rate" value="fast" type="int"/>',
    ),
    Finding(
        "LL110",
        "conflicting-attributes",
        Severity.ERROR,
        at(NAV, 'respawn="true" required="true"'),
        "respawn and required exclude each other",
        element="<node>",
        fix=Fix("remove respawn", True, (Edit("nav.launch", NAV.text.index('respawn="true" '), NAV.text.index("required="), ""),)),
    ),
    Finding(
        "LL206",
        "unused-arg",
        Severity.WARNING,
        at(NAV, '"sacn"'),
        "the arg sacn is never read",
        help="did you mean scan?",
        element='<arg name="sacn"/>',
    ),
    Finding(
        "LL605", "remap-identity", Severity.INFO, at(LONG, 'from="x"'), "x is remapped to itself", label="does nothing", element="<remap>"
    ),
    Finding("LL605", "remap-identity", Severity.INFO, at(LONG, 'from="x"'), "x is remapped to itself again", element="<remap>"),
    Finding("LL101", "malformed-xml", Severity.ERROR, Location("empty.launch", 1, 1, 1, 1, 0, 0, ""), "the file is empty"),
]

NASTY = (
    "\x1b[31m%\r\n::error file=a,line=1::b"
    "\u202eevil\u2066\u200f\u061c\u2028\u0085\x00\x7f\x9b \udcff\ud800"
    "]]><script>&\"'](http://x)|`@u #1 ##[add-mask]{0}\t"
)
"""Everything that has ever broken out of a report, in one string."""


def _hostile(number: int, severity: Severity) -> Finding:
    where = Location(f"::set-env name=x::{NASTY}/{number}.launch", 1, 3, 1, 9, 2, 8, f"  {NASTY}")
    return Finding(
        f"LL{number}",
        f"name-{NASTY}",
        severity,
        where,
        f"message {NASTY}",
        label=f"label {NASTY}",
        related=(Related(where, f"related {NASTY}"), Related(where._replace(path=f"-{NASTY}"), "")),
        chain=(where,),
        notes=(f"note {NASTY}",),
        help=f"help {NASTY}",
        entry=f"-{NASTY}.launch",
        arguments=((f"name{NASTY}", NASTY),),
        entries=2,
        element=NASTY,
        fix=Fix(f"fix {NASTY}", True, (Edit(where.path, 2, 8, NASTY), Edit("/outside/of/it.launch", 0, 0, NASTY))),
    )


HOSTILE = [_hostile(901, Severity.ERROR), _hostile(902, Severity.WARNING), _hostile(903, Severity.INFO)]


def _rules() -> Mapping[str, RuleMetadata]:
    return {
        finding.rule: RuleMetadata(
            finding.rule,
            finding.name,
            finding.severity,
            f"What {finding.name} means",
            f"The page of {finding.name}.",
            f"## {finding.name}\n\nThe page.",
            f"https://example.org/rules/{finding.rule}",
            ("ros", "roslaunch"),
        )
        for finding in PLAIN
    }


def content(path: str) -> bytes | None:
    """The files that the plain findings are about."""
    return {source.path: source.text.encode() for source in (NAV, WHEELS, LONG)}.get(path)


@pytest.fixture
def plain() -> list[Finding]:
    """Findings as a user sees them."""
    return list(PLAIN)


@pytest.fixture
def hostile() -> list[Finding]:
    """Findings with hostile text in every field."""
    return list(HOSTILE)


@pytest.fixture
def run() -> Run:
    """A run over twelve files, without colours."""
    return Run("1.2.3", _rules, 12, 4, root="/home/user/work space", read=content, width=100, home="https://example.org/")
