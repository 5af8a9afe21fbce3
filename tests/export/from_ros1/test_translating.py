"""Launch files of ROS 1 as launch files of ROS 2: what is written, what is said to be lost, and what a person has to look at."""

from __future__ import annotations

from pathlib import Path

import pytest

from launchlint.evaluate.session import Session
from launchlint.export.from_ros1 import converting
from launchlint.export.from_ros1.converting import convert
from launchlint.export.from_ros1.params import FILE_HAS_NO_NODE
from launchlint.export.ros2.converting import XML, YAML, Converted
from launchlint.export.written import CannotExport
from launchlint.fix.format.style import Style
from launchlint.workspace.packages import Packages

PACKAGE = "<package format='2'><name>demo</name></package>"
VARIABLES = {"HOME": "/home/somebody"}
BOX = """\
<launch>
  <arg name="rate" default="1"/>
  <arg name="speed" default="3"/>
  <node name="wheels" pkg="demo" type="wheels"><param name="rate" value="$(arg rate)"/></node>
</launch>
"""


def translated(directory: Path, body: str, language: str = XML, **files: str) -> Converted:
    """The launch file with this ``body`` in a package ``demo``; ``files`` are those beside it, by the first part of their names."""
    launch = directory / "demo/launch"
    launch.mkdir(parents=True)
    (directory / "demo/package.xml").write_text(PACKAGE)
    for name, text in {"main": f"<launch>\n{body}\n</launch>\n", "box": BOX, **files}.items():
        (launch / f"{name}.launch").write_text(text, encoding="utf-8")
    (launch / "p.yaml").write_text("a: 1\n")
    session = Session(Packages([str(directory)], VARIABLES, explicit=True), VARIABLES, str(directory))
    return convert(session, str(launch / "main.launch"), (), Style(), language)


def said(result: Converted) -> list[str]:
    return [words for _, words in (*result.lost, *result.remarks)]


NODE = '<node name="n" pkg="demo" type="run"'
SAME: dict[str, str] = {
    f"{NODE}/>": '<node name="n" pkg="demo" exec="run"/>',
    f'{NODE} ns="a" required="true" respawn="false" output="screen" launch-prefix="nice"/>': (
        '<node name="n" pkg="demo" exec="run" namespace="a" on_exit="shutdown" output="screen" launch-prefix="nice"/>'
    ),
    f"{NODE} args=\"-d 'a b' x:=y ~z:=w _p:=5 __name:=m\"/>": (
        '<node name="n" pkg="demo" exec="run" args="-d \'a b\'" ros_args="-r x:=y -r ~/z:=w -p p:=5 -r __name:=m"/>'
    ),
    f'{NODE}><remap from="~in" to="/out"/></node>': (
        '<node name="n" pkg="demo" exec="run">\n    <remap from="~/in" to="/out"/>\n  </node>'
    ),
    f'{NODE}><param name="a/b" value="1.5"/><param name="s" value="yes"/><param name="t" type="str" value="5"/></node>': (
        '<node name="n" pkg="demo" exec="run">\n    <param name="a.b" value="1.5"/>\n    <param name="s" value="\'yes\'"/>\n'
        '    <param name="t" value="\'5\'"/>\n  </node>'
    ),
    f"{NODE}><rosparam>{{a: {{b: 1}}, l: [1, 2.5]}}</rosparam></node>": (
        '<node name="n" pkg="demo" exec="run">\n    <param name="a">\n      <param name="b" value="1"/>\n    </param>\n'
        '    <param name="l" value="[1.0, 2.5]"/>\n  </node>'
    ),
    f'{NODE}><param name="d" command="cat $(find demo)/x"/><param name="f" textfile="$(dirname)/p.yaml"/></node>': (
        '<node name="n" pkg="demo" exec="run">\n    <param name="d" type="str" value="$(command \'cat $(find-pkg-share demo)/x\')"/>\n'
        '    <param name="f" type="str" value="$(file-content $(find-pkg-share demo)/launch/p.yaml)"/>\n  </node>'
    ),
    f'<param name="n/a" value="1"/>{NODE}/>': ('<node name="n" pkg="demo" exec="run">\n    <param name="a" value="1"/>\n  </node>'),
    f'<param name="~a" value="1"/><remap from="x" to="y"/>{NODE}><remap from="x" to="z"/></node>': (
        '<node name="n" pkg="demo" exec="run">\n    <remap from="x" to="z"/>\n    <param name="a" value="1"/>\n  </node>'
    ),
    '<param name="/use_sim_time" value="true"/>': '<set_parameter name="use_sim_time" value="true"/>',
    f'<group ns="g">{NODE}/></group>': (
        '<group>\n    <push_ros_namespace namespace="g"/>\n    <node name="n" pkg="demo" exec="run"/>\n  </group>'
    ),
    f'<env name="A" value="$(optenv B c d)"/>{NODE}/>': (
        '<set_env name="A" value="$(env B \'c d\')"/>\n  <node name="n" pkg="demo" exec="run"/>'
    ),
    f'<arg name="a" default="true" doc="d"/><arg name="b" value="$(arg a)"/>{NODE} if="$(arg b)"/>': (
        '<arg name="a" default="true" description="d"/>\n  <let name="b" value="$(var a)"/>\n'
        '  <node if="$(var b)" name="n" pkg="demo" exec="run"/>'
    ),
    f'<arg name="a" default="x"/><arg name="b" default="2"/>{NODE} if="$(eval a == \'x\' and b > 1)"/>': (
        '<arg name="a" default="x"/>\n  <arg name="b" default="2"/>\n'
        '  <node if="$(eval &quot;\'$(var a)\' == \'x\' and $(var b) > 1&quot;)" name="n" pkg="demo" exec="run"/>'
    ),
}


@pytest.mark.parametrize("body", SAME)
def test_what_has_a_counterpart(body: str, tmp_path: Path) -> None:
    result = translated(tmp_path, body)
    assert (result.data.decode(), said(result)) == (f"<launch>\n  {SAME[body]}\n</launch>\n".replace("> 1&", "&gt; 1&"), [])


LOST: dict[str, list[str]] = {
    '<machine name="m" address="a"/>': ["the machine m: ROS 2 launch starts nothing on other machines"],
    '<node name="n" pkg="nodelet" type="nodelet" args="load a/B m"/>': [
        "the node n: a nodelet (load a/B m): ROS 2 has components, in a <node_container> with <composable_node>s"
    ],
    '<rosparam command="dump" file="/tmp/x"/>': ["the rosparam /tmp/x: command=dump has no counterpart"],
    '<param name="a" value="1"/>': ["the param a: ROS 2 has no parameter server; give it to the nodes that read it"],
    '<test test-name="t" pkg="demo" type="t"/>': ["the test: rostest has no counterpart; launch_testing has tests in Python"],
    f'{NODE} clear_params="true" cwd="node"/>': [
        "clear_params: there is no parameter server to be cleared",
        "cwd: a path is wanted in ROS 2",
    ],
    f'{NODE}><param name="/a" value="1"/></node>': ["a param: /a is a param of all, and ROS 2 has none; give it to the nodes that read it"],
    f"{NODE}><rosparam>{{a: [[1], [2]], b: 2}}</rosparam></node>": ["the param a: ROS 2 has lists of values of one type only"],
    f'{NODE}><param name="a" value="1e3"/></node>': ["a param: the text 1e3 would be read again, as something else"],
    f'{NODE}><rosparam file="$(dirname)/p.yaml" ns="x"/></node>': [f"$(dirname)/p.yaml {FILE_HAS_NO_NODE}, and x: below these"],
    f'<arg name="a" default=""/>{NODE} args="$(arg a)"/>': [
        "what is put into args is one word in ROS 2, also where it is empty or blanks stand in it: $(arg a)"
    ],
}


@pytest.mark.parametrize("body", LOST)
def test_what_is_lost_is_said(body: str, tmp_path: Path) -> None:
    assert said(translated(tmp_path, body)) == LOST[body]


def test_an_include_is_told_what_it_would_take_over(tmp_path: Path) -> None:
    """In ROS 2 all that is set is handed on: what the included file does not get here, it has to be told."""
    body = '<arg name="rate" default="9"/><include file="$(find demo)/launch/box.launch" ns="a"><arg name="speed" value="4"/></include>'
    result = translated(tmp_path, body)
    assert (
        result.data.decode()
        == """\
<launch>
  <arg name="rate" default="9"/>
  <group>
    <push_ros_namespace namespace="a"/>
    <include file="$(find-pkg-share demo)/launch/box.launch">
      <arg name="speed" value="4"/>
      <arg name="rate" value="1"/>
    </include>
  </group>
</launch>
"""
    )
    assert said(result) == ["$(find demo)/launch/box.launch has to be translated, too"]


def test_conditions_inside_of_a_node_become_two_nodes(tmp_path: Path) -> None:
    body = f'<arg name="a" default="true"/>{NODE}><param if="$(arg a)" name="x" value="1"/></node>'
    result = translated(tmp_path, body, YAML)
    assert (
        result.data.decode()
        == """\
launch:
- arg:
    name: a
    default: 'true'
- node:
    if: $(var a)
    name: n
    pkg: demo
    exec: run
    param:
    - name: x
      value: 1
- node:
    unless: $(var a)
    name: n
    pkg: demo
    exec: run
"""
    )


CHOSEN = {
    '<remap if="$(arg a)" from="x" to="y"/>': '<remap from="x" to="$(if $(var a) y x)"/>',
    '<remap unless="$(arg a)" from="x" to="/y"/>': '<remap from="x" to="$(if $(var a) x /y)"/>',
    '<remap if="$(arg a)" from="x" to="y"/><remap unless="$(arg a)" from="x" to="z"/>': '<remap from="x" to="$(if $(var a) y z)"/>',
    '<param if="$(arg a)" name="p" value="1"/><param unless="$(arg a)" name="p" value="2"/>': (
        '<param name="p" type="int" value="$(if $(var a) 1 2)"/>'
    ),
    '<param unless="$(arg a)" name="p" value="b c"/><param if="$(arg a)" name="p" value=""/>': (
        '<param name="p" type="str" value="$(if $(var a) \'\' \'b c\')"/>'
    ),
}


@pytest.mark.parametrize("inside", CHOSEN)
def test_conditions_become_choices_where_that_says_the_same(inside: str, tmp_path: Path) -> None:
    result = translated(tmp_path, f'<arg name="a" default="true"/>{NODE}>{inside}</node>')
    assert f'  <node name="n" pkg="demo" exec="run">\n    {CHOSEN[inside]}\n  </node>\n' in result.data.decode()
    assert said(result) == []


def test_values_of_two_types_are_no_choice(tmp_path: Path) -> None:
    inside = '<param if="$(arg a)" name="p" value="1"/><param unless="$(arg a)" name="p" value="b"/>'
    result = translated(tmp_path, f'<arg name="a" default="true"/>{NODE}>{inside}</node>')
    assert result.data.decode().count("<node") == 2


def test_comments_stay(tmp_path: Path) -> None:
    result = translated(tmp_path, f"<!-- the one -->\n{NODE}/> <!-- here -->")
    assert result.data.decode() == '<launch>\n  <!-- the one -->\n  <node name="n" pkg="demo" exec="run"/> <!-- here -->\n</launch>\n'


def test_a_difference_is_no_file(tmp_path: Path) -> None:
    """A remap of the scope comes first in ROS 2, before what the included node says itself; here, the node's own one counts."""
    box = f'<launch>{NODE}><remap from="x" to="z"/></node></launch>'
    with pytest.raises(CannotExport, match="would have the remaps"):
        translated(tmp_path, '<remap from="x" to="y"/><include file="$(dirname)/box.launch"/>', box=box)


def test_what_is_not_the_same_is_found_in_every_configuration(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    tried: list[tuple[tuple[str, str], ...]] = []
    honest = converting.difference
    monkeypatch.setattr(converting, "difference", lambda old, new, dropped: tried.append(old.given) or honest(old, new, dropped))  # type: ignore[func-returns-value]
    translated(tmp_path, f'<arg name="a" default="true"/>{NODE} if="$(arg a)"/>')
    assert tried == [(), (("a", "false"),)]
