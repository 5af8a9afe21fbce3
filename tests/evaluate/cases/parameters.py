"""``<param>`` and ``<rosparam>``: names, types, sources, YAML."""

from __future__ import annotations

from tests.evaluate.comparison import case

VALUES = [
    "1",
    "-1",
    "+1",
    "1.0",
    ".5",
    "1.",
    "1e5",
    "1.e5",
    "0x1F",
    "nan",
    "inf",
    "1_000",
    "1_0.5",
    "true",
    "TRUE",
    "yes",
    "on",
    "",
    " ",
    " 7 ",
    "1,5",
    "1:30",
    "٣",
    "012",
    "null",
    "-inf.",
    "1.5.2",
    "..",
    "True ",
    "a b",
    "{x: 1}",
    "[1, 2]",
    "--1",
    "1 2",
    "1L",
    "0b1",
    "é",
]
YAMLS = [
    "{a: 1, b: [x, 2.5, true]}",
    "[1, null]",
    "3",
    "1e3",
    "012",
    "yes",
    "1:30",
    "~",
    "2001-01-01",
    "text: more",
    "",
    "'1'",
    "!!str 1",
    "-.inf",
    "1_000",
]


def typed(type_: str, values: list[str]) -> str:
    """A param of this type for each of the values."""
    return "".join(f'<param name="p{number}" type="{type_}" value="{value}"/>' for number, value in enumerate(values))


PARAMETERS = {
    # types
    "automatic types": case(typed("auto", VALUES)),
    "strings": case(typed("str", VALUES)),
    "the type string": case(typed(" STRING ", VALUES)),
    "whole numbers": case(typed("int", ["1", "-1", "+1", "1_000", " 7 ", "٣", "012"])),
    "numbers": case(typed("double", ["1", "-1", ".5", "1e5", "nan", "inf", "-Infinity", "1_0.5", " 7 "])),
    "booleans": case(typed("bool", ["1", "0", "true", "FALSE", " True "]) + '<param name="q" type="Boolean" value="1"/>'),
    "YAML values": case(typed("yaml", YAMLS)),
    "a type that is empty": case('<param name="x" type="" value="1"/>'),
    "a whole number with a point": case('<param name="x" type="int" value="1.0"/>', "param-value-type"),
    "a number that is a word": case('<param name="x" type="double" value="one"/>', "param-value-type"),
    "a boolean that is yes": case('<param name="x" type="bool" value="yes"/>', "param-value-type"),
    "a boolean that is 2": case('<param name="x" type="bool" value="2"/>', "param-value-type"),
    "a type that is unknown": case('<param name="x" type="float" value="1"/>', "param-value-type"),
    "a type is not resolved": case('<arg name="t" value="int"/><param name="x" type="$(arg t)" value="1"/>', "param-value-type"),
    "YAML with an error": case('<param name="x" type="yaml" value="[1"/>', "param-value-type"),
    "YAML with a bad character": case('<param name="x" type="yaml" value="@"/>', "param-value-type"),
    "an angle in YAML": case('<param name="x" type="yaml" value="deg(90)"/>'),
    "an angle in YAML after a rosparam": case('<rosparam>a: 1</rosparam><param name="x" type="yaml" value="deg(90)"/>'),
    "an angle in YAML before a rosparam": case('<param name="x" type="yaml" value="rad(pi)"/><rosparam>a: 1</rosparam>'),
    "an angle in YAML after a rosparam of another file": case(
        '<include file="$(dirname)/i.launch"/><param name="x" type="yaml" value="deg(90)"/>',
        files={"i.launch": "<rosparam>a: 1</rosparam>"},
    ),
    "an angle in YAML in an included file, before and after": case(
        '<include file="$(dirname)/i.launch" ns="a"/><rosparam/><include file="$(dirname)/i.launch" ns="a"/>',
        files={"i.launch": '<param name="$(anon x)" type="yaml" value="deg(90)"/><param name="y" type="yaml" value="deg(90)"/>'},
    ),
    "an angle in YAML after a rosparam delete": case('<rosparam command="delete" param="a"/><param name="x" type="yaml" value="deg(90)"/>'),
    # sources
    "a textfile": case('<param name="x" textfile="$(dirname)/t.txt"/>', files={"t.txt": "one\r\ntwo\rthree\n"}),
    "a textfile is converted": case(
        '<param name="x" textfile="$(dirname)/t.txt"/><param name="y" textfile="$(dirname)/t.txt" type="int"/>', files={"t.txt": " 12\n"}
    ),
    "a textfile with a mark": case('<param name="x" textfile="$(dirname)/t.txt"/>', files={"t.txt": b"\xef\xbb\xbf5"}),
    "a textfile that is no UTF-8": case(
        '<param name="x" textfile="$(dirname)/t.txt"/>', "param-file-missing", files={"t.txt": b"\xff\xfe"}
    ),
    "a textfile that is not there": case('<param name="x" textfile="$(dirname)/t.txt"/>', "param-file-missing"),
    "a textfile that is a directory": case('<param name="x" textfile="$(dirname)"/>', "param-file-missing"),
    "a textfile without a name": case('<param name="x" textfile=""/>', "param-file-missing"),
    "a binfile": case('<param name="x" binfile="$(dirname)/t.bin" type="nonsense"/>', files={"t.bin": b"\x00\xff"}),
    "a binfile that is not there": case('<param name="x" binfile="$(dirname)/t.bin"/>', "param-file-missing"),
    "a command": case('<param name="x" command="echo $(anon a) \'b c\'" type="yaml"/>'),
    "a command of an unknown type": case('<param name="x" command="echo" type="nonsense"/>', "param-value-type"),
    "a command that is empty": case('<param name="x" command=""/>', "invalid-value"),
    "a command with an open quote": case('<param name="x" command="echo \'"/>', "unbalanced-quotes"),
    "no source": case('<param name="x"/>', "conflicting-attributes"),
    "two sources": case('<param name="x" value="" textfile=""/>', "conflicting-attributes"),
    "no name": case('<param value="1"/>', "missing-attribute"),
    # names
    "names join": case('<group ns="g"><param name="x" value="1"/><param name="/y" value="1"/><param name=" z/w " value="1"/></group>'),
    "odd names": case('<group ns="g"><param name="a b" value="1"/><param name="a//b/" value="1"/><param name="" value="1"/></group>'),
    "the name /": case('<param name="/" value="1"/>'),
    "an empty name at the root": case('<param name="" value="1"/>'),
    "an empty name in a node": case('[[n | <param name="" value="1"/><param name="/" value="2"/>]]'),
    "a name from an arg": case('<arg name="a" value=" x "/><param name="$(arg a)" value="1"/>'),
    "a name from an arg that begins with ~": case('<arg name="a" value="~x"/><param name="$(arg a)" value="1"/>[[n]]'),
    "the last writer wins": case('<param name="x" value="1"/><param name="/x" value="2"/><rosparam>x: 3</rosparam>'),
    "a node's param is written at the node": case(
        '<param name="n/x" value="1"/>[[n | <param name="x" value="2"/>]]<param name="/n/x" value="3"/>'
    ),
    "a parent and its child": case('<param name="a" value="1"/><param name="a/b" value="2"/>'),
    "a child and its parent": case('<param name="a/b" value="2"/><param name="a" value="1"/>'),
    # rosparam
    "a dictionary": case("<rosparam>\n  a: 1\n  b: {c: [1, 2.5], d: {e: text}}\n</rosparam>"),
    "YAML 1.1": case(
        "<rosparam>{a: on, b: yes, c: 012, d: 1:30, e: 1e3, f: ~, g: 1_000, h: 0x1F, i: .5, j: 1.0e+3, k: 2001-01-01}</rosparam>"
    ),
    "angles": case("<rosparam>{a: deg(90), b: rad(pi/2), c: !degrees 45, d: !radians 1}</rosparam>"),
    "the number of a parameter": case(
        '<rosparam param="x">5</rosparam><rosparam param="y">[1, a]</rosparam><rosparam param="z"> text </rosparam>'
    ),
    "ns and param": case('<group ns="g"><rosparam ns="a" param="b">1</rosparam><rosparam ns="/a" param="b">1</rosparam></group>'),
    "absolute and odd params": case('<group ns="g"><rosparam param="/a//b/">1</rosparam><rosparam ns="a" param="/c">1</rosparam></group>'),
    "a ~param of a rosparam": case('<group ns="g"><rosparam param="~a">1</rosparam></group>'),
    "the ns ~": case('<group ns="g"><rosparam ns="~" param="a">1</rosparam><rosparam ns="~">{c: 1, /d: 2, ~e: 3}</rosparam></group>'),
    "keys with ~ and /": case('<group ns="g"><rosparam>{~a: 1, /b: 2, c/d: 3, "": 4}</rosparam></group>'),
    "an empty key at the root": case('<rosparam>{"": 1}</rosparam>', "param-yaml-invalid"),
    "empty keys at the root": case('<rosparam>{"": {"": {}}}</rosparam>'),
    "the param /": case('<rosparam param="/">1</rosparam>', "param-yaml-invalid"),
    "a dictionary for the param /": case('<group ns="g"><rosparam param="/">{a: 1}</rosparam></group>'),
    "in a node": case(
        '<group ns="g">[[n | <rosparam>{a: 1, /b: 2, ~c: 3}</rosparam><rosparam param="/d">4</rosparam>'
        '<rosparam ns="e">{f: 5}</rosparam>]]</group>'
    ),
    "nothing": case('<rosparam/><rosparam param="x"/><rosparam param="y">{}</rosparam><rosparam param="z">{a: {}}</rosparam>'),
    "null for a param": case('<rosparam param="x">~</rosparam>'),
    "a list without param": case("<rosparam>[1]</rosparam>", "param-yaml-invalid"),
    "a value without a blank": case("<rosparam>a:1</rosparam>", "param-yaml-invalid"),
    "a text without param": case("<rosparam>text</rosparam>", "param-yaml-invalid"),
    "a key that is a number": case("<rosparam>{1: a}</rosparam>", "param-yaml-invalid"),
    "a key that is a boolean": case("<rosparam>{on: a}</rosparam>", "param-yaml-invalid"),
    "a key that is null": case("<rosparam>{~: a}</rosparam>", "param-yaml-invalid"),
    "keys twice": case("<rosparam>{a: 1, b: 2, a: 3}</rosparam>"),
    "dictionaries merge": case("<rosparam>{a: {b: 1, c: 2}}</rosparam><rosparam>{a: {c: 3, d: 4}}</rosparam>"),
    "several documents": case("<rosparam>a: 1\n---\nb: 2</rosparam>", "param-yaml-invalid"),
    "a tab": case("<rosparam>\ta: 1</rosparam>", "param-yaml-invalid"),
    "a bad indentation": case("<rosparam>\na: 1\n b: 2\n</rosparam>", "param-yaml-invalid"),
    "an unknown tag": case("<rosparam>a: !!python/object:os.system x</rosparam>", "param-yaml-invalid"),
    "an anchor": case("<rosparam>a: &amp;x {b: 1}\nc: *x\nd: {&lt;&lt;: *x, e: 2}</rosparam>"),
    "CDATA, comments and tags in the text": case("<rosparam><![CDATA[a: '<b>']]>\n<!-- c: 1 -->\n<param>d: 1</param>e: 2</rosparam>"),
    "binary data": case("<rosparam>a: !!binary aGVsbG8=</rosparam>"),
    "a file": case('<rosparam file="$(dirname)/p.yaml"/>', files={"p.yaml": "a: 1\r\nb: {c: é}\r\n"}),
    "a file, and text that is not looked at": case('<rosparam file="$(dirname)/p.yaml">[</rosparam>', files={"p.yaml": "a: 1"}),
    "a file that is empty": case('<rosparam file="$(dirname)/p.yaml" command="load"/>', files={"p.yaml": "# nothing\n"}),
    "a file that is not there": case('<rosparam file="$(dirname)/p.yaml"/>', "param-file-missing"),
    "a file without a name": case('<rosparam file=""/>', "param-file-missing"),
    "a file that is no UTF-8": case('<rosparam file="$(dirname)/p.yaml"/>', "param-yaml-invalid", files={"p.yaml": b"a: \xff"}),
    "a file with an error": case('<rosparam file="$(dirname)/p.yaml"/>', "param-yaml-invalid", files={"p.yaml": "a: [1"}),
    "a file with a mark": case('<rosparam file="$(dirname)/p.yaml"/>', files={"p.yaml": b"\xef\xbb\xbfa: 1"}),
    "subst_value": case('<arg name="a" value="5"/><rosparam subst_value="true">{x: $(arg a), y: "$(anon b)"}</rosparam>'),
    "no subst_value": case('<rosparam>{x: $(arg a)}</rosparam><rosparam subst_value="False">{y: $(arg a)}</rosparam>'),
    "subst_value of a file": case(
        '<arg name="a" value="5"/><rosparam subst_value="True" file="$(dirname)/p.yaml"/>', files={"p.yaml": "x: $(arg a)\ny: $(dirname)\n"}
    ),
    "subst_value with an unknown arg": case('<rosparam subst_value="true">{x: $(arg a)}</rosparam>', "undeclared-arg"),
    "subst_value of an eval": case('<rosparam subst_value="true" param="x">$(eval 1 + 1)</rosparam>'),
    "subst_value of an eval after a blank": case('<rosparam subst_value="true" param="x"> $(eval 1 + 1)</rosparam>', "bad-substitution"),
    "subst_value is a boolean": case('<rosparam subst_value="1">{}</rosparam>', "invalid-value"),
    "delete and dump": case(
        '<group ns="g"><rosparam command="delete" param="a"/><rosparam command="dump" file="x.yaml" param="b"/>'
        '<rosparam command="delete" ns="c"/></group>'
    ),
    "delete everything": case('<rosparam command="delete"/>[[n | <rosparam command="delete" param="x"/>]]'),
    "delete with a file": case('<rosparam command="delete" file="x"/>', "conflicting-attributes"),
    "an empty command": case('<rosparam command="">{a: 1}</rosparam>'),
    "an unknown command": case('<rosparam command="set">{a: 1}</rosparam>', "invalid-value"),
    "a command in capital letters": case('<rosparam command="LOAD">{a: 1}</rosparam>', "invalid-value"),
    "an unknown attribute": case('<rosparam tag="x">{a: 1}</rosparam>'),
}
