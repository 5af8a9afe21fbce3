"""``<node>`` and ``<test>``, and what XML itself allows."""

from __future__ import annotations

from tests.evaluate.comparison import case


def test_tag(attributes: str, *refused: str):  # type: ignore[no-untyped-def]
    """A test with these attributes besides the required ones."""
    return case(f'<test pkg="p" type="t" test-name="x" {attributes}/>', *refused)


test_tag.__test__ = False  # type: ignore[attr-defined]

NODES = {
    "every attribute": case(
        '[[n machine="" args="-a \'b c\'" output="screen" respawn="true" respawn_delay="1.5" cwd="node"'
        ' launch-prefix="nice -n 5" required="false"]]'
    ),
    "attributes that are empty": case('[[n args="" launch-prefix="" machine=""]]'),
    "cwd in small letters": case('[[n cwd="ros_home"]][[m cwd="ROS_HOME"]]'),
    "cwd is a word": case('[[n cwd="Node"]]', "invalid-value"),
    "cwd is empty": case('[[n cwd=""]]', "invalid-value"),
    "output is a word": case('[[n output="both"]]', "invalid-value"),
    "output is empty": case('[[n output=""]]', "invalid-value"),
    "output in capital letters": case('[[n output="LOG"]]', "invalid-value"),
    "respawn is a boolean": case('[[n respawn="1"]]', "invalid-value"),
    "respawn is empty": case('[[n respawn=""]]', "invalid-value"),
    "required with a blank": case('[[n required=" true"]]', "invalid-value"),
    "required and respawn": case('[[n required="true" respawn="TRUE"]]', "conflicting-attributes"),
    "a delay that is a word": case('[[n respawn_delay="soon"]]', "invalid-value"),
    "a delay that is empty": case('[[n respawn_delay=""]]', "invalid-value"),
    "a delay below 0": case('[[n respawn_delay="-1"]][[m respawn_delay=" 1e1 "]][[o respawn_delay="inf"]]'),
    "no pkg": case('<node type="t" name="n"/>', "missing-attribute"),
    "no type": case('<node pkg="p" name="n"/>', "missing-attribute"),
    "no name": case('<node pkg="p" type="t"/>', "missing-attribute"),
    "an empty pkg": case('<node pkg=" " type="t" name="n"/>', "invalid-value"),
    "an empty type": case('<node pkg="p" type="" name="n"/>', "invalid-value"),
    "an empty name": case("[[]][[]]"),
    "an empty name in a namespace, with params": case(
        '<group ns="g">[[ | <param name="x" value="1"/><param name="~y" value="1"/>]]</group>'
    ),
    "a name with a slash": case("[[a/b]]", "invalid-node-name"),
    "a name that is absolute": case("[[/a]]", "invalid-node-name"),
    "a private name": case("[[~a]]", "invalid-node-name"),
    "the name ~": case("[[~]]", "invalid-node-name"),
    "odd names": case('[[1a]][[a-b]][[ä]]<node pkg="p" type="t" name="a b"/>'),
    "names with odd characters and params": case('[[a.b | <param name="x" value="1"/>]]'),
    "two nodes of one name": case("[[a]][[a]]", "duplicate-node"),
    "two nodes of one name in a namespace": case('<group ns="g">[[a]]</group>[[a ns="/g/"]]', "duplicate-node"),
    "two nodes of one name, spelled otherwise": case('[[a ns="g//h"]][[a ns="/g/h/"]]', "duplicate-node"),
    "two nodes of one name, one switched off": case('[[a if="0"]][[a]]'),
    "one name in two namespaces": case('[[a]][[a ns="g"]]'),
    "roscore's own node": case("[[rosout]]", "duplicate-node"),
    "roscore's node in a namespace": case('[[rosout ns="g"]]'),
    "quotes in args": case('[[n args="\'a"]]', "unbalanced-quotes"),
    "a backslash in args": case('[[n args="a\\"]]', "unbalanced-quotes"),
    "quotes in a prefix": case('[[n launch-prefix="\'a"]]', "unbalanced-quotes"),
    "a hash in args": case('[[n args="a #\'b"]]', "unbalanced-quotes"),
    "tags in a node in any case": case(
        '[[n | <Param name="x" value="1"/><REMAP from="a" to="b"/><rosParam>{y: 1}</rosParam><Env name="A" value="1"/>]]'
    ),
    "other tags in a node": case('[[n | <arg name="a" value="1"/><node/><group/>text]]'),
    "unknown attributes": case('[[n namespace="x" Name="y" ns2="$(bad)"]]'),
    "an unset arg in each attribute": case('[[n args="$(arg a)"]]', "undeclared-arg"),
    # tests
    "a test": test_tag(""),
    "a test in full": test_tag(
        'name="n" time-limit="5" retry="2" args="a" machine="" cwd="node" launch-prefix="nice" ns="g" required="true"'
    ),
    "a test without test-name": case('<test pkg="p" type="t" name="n"/>', "missing-attribute"),
    "a test named by its test-name": test_tag('name=""'),
    "a test without a type": case('<test pkg="p" test-name="x"/>', "missing-attribute"),
    "tests are not compared with nodes": case('[[x]]<test pkg="p" type="t" test-name="x"/><test pkg="p" type="t" test-name="x"/>'),
    "a test with respawn": test_tag('respawn="false"', "conflicting-attributes"),
    "a test with a delay": test_tag('respawn_delay=""', "conflicting-attributes"),
    "a test with output": test_tag('output="log"', "conflicting-attributes"),
    "a test's required is a boolean": test_tag('required="1"', "invalid-value"),
    "a time limit that is empty": test_tag('time-limit="" retry=""'),
    "a time limit of 0": test_tag('time-limit="0"', "invalid-value"),
    "a time limit that is a word": test_tag('time-limit="x"', "invalid-value"),
    "a time limit that is no number": test_tag('time-limit=" 1.5e1 "'),
    "a retry with a point": test_tag('retry="1.5"', "invalid-value"),
    "a retry below 0": test_tag('retry="-1"'),
    "a test's name with a slash": case('<test pkg="p" type="t" test-name="a/b"/>', "invalid-node-name"),
    "a test-name with a slash": test_tag('name="n"'),
    "a test with params and remaps": case(
        '<remap from="a" to="b"/><test pkg="p" type="t" test-name="x"><remap from="c" to="d"/>'
        '<param name="q" value="1"/><rosparam>{r: 1}</rosparam></test>'
    ),
    # XML
    "unknown tags": case("<bad><node/></bad><Node/><NODE/>[[n]]<master auto='start'/>"),
    "text anywhere": case("text[[n]]text<group>text</group>"),
    "attributes of the root": case('<launch xmlns:x="y" version="1" x:z="2">[[n]]</launch>'),
    "a default namespace": case('<launch xmlns="http://example.org">[[n]]</launch>'),
    "a prefix": case('<launch xmlns:x="y"><x:node pkg="p" type="t" name="n"/>[[m]]</launch>'),
    "another root": case("<robot><a><launch>[[n]]</launch></a></robot>"),
    "a root without launch": case(b"<robot/>", "root-not-launch"),
    "two launch tags": case("<robot><launch/><launch/></robot>", "root-not-launch"),
    "a launch in a launch": case("<launch><group><launch/></group></launch>", "root-not-launch"),
    "not well-formed": case("<launch><node></launch>", "malformed-xml"),
    "an empty file": case(b"", "malformed-xml"),
    "entities": case(
        "<!DOCTYPE launch [<!ENTITY a \"1\"><!ENTITY b \"<param name='y' value='2'/>\">]><launch>"
        '<param name="x" value="&a;&lt;"/>&b;</launch>'
    ),
    "an unknown entity": case("<launch>&nbsp;</launch>", "malformed-xml"),
    "UTF-8 with a mark": case(b"\xef\xbb\xbf<launch><param name='x' value='\xc3\xa9'/></launch>"),
    "Latin-1": case(b"<?xml version='1.0' encoding='ISO-8859-1'?><launch><param name='x' value='\xe9'/></launch>"),
    "ISO-8859-15": case(b"<?xml version='1.0' encoding='ISO-8859-15'?><launch><param name='x' value='\xa4'/></launch>"),
    "UTF-16": case("<?xml version='1.0' encoding='UTF-16'?><launch><param name='x' value='é'/></launch>".encode("utf-16")),
    "bytes that are no UTF-8": case(b"<launch><param name='x' value='\xe9'/></launch>", "malformed-xml"),
    "a declaration after a blank": case(b" <?xml version='1.0'?><launch/>", "malformed-xml"),
    "an attribute twice": case(b"<launch><param name='x' name='y' value='1'/></launch>", "malformed-xml"),
    "line ends and tabs in attributes": case("<param name='x' value='a\nb\tc\r\nd'/><param name='y' value='a&#10;b&#9;c'/>"),
    "line ends in text": case(b"<launch>\r\n<rosparam param='x'>|\r\n a\r\n b\r</rosparam></launch>"),
    "hyphens in a comment": case(b"<launch><!-- a -- b --></launch>", "malformed-xml"),
    "CDATA and instructions": case("<?a b?>\n<launch><![CDATA[x]]><?c d?>[[n]]</launch><!-- end -->"),
    "two roots": case(b"<launch/><launch/>", "malformed-xml"),
}
