"""Every element, attribute and text has its exact place, in every encoding and layout."""

from __future__ import annotations

import pytest

from launchlint.source import Position, Span
from launchlint.syntax.parse import parse
from launchlint.syntax.tree import Document

LAYOUT = """<?xml version="1.0"?>
<launch>
\t<node
      pkg = "übung"\tname='a"b'
      type="c&lt;d"   >
    <rosparam>
      a: 1
    </rosparam><!-- ü -->
  </node>
  <arg name="x"/>
</launch>
"""


def outline(document: Document) -> list[str]:
    """One line for each element, attribute and comment: what is written there, and line:column of its start and end."""
    source = document.source

    def show(span: Span) -> str:
        first, last = source.position(span.start), source.position(span.end)
        text = source.text[span.start : span.end].replace("\r\n", "\n").replace("\r", "\n")
        return f"{text!r} {first.line}:{first.column}-{last.line}:{last.column}"

    lines = []
    for element in document.elements:
        lines.append(f"{element.tag} {show(element.name_span)}")
        first, last = source.position(element.span.start), source.position(element.span.end)
        tag_end = source.position(element.start_span.end)
        lines.append(
            f"  {first.line}:{first.column} {tag_end.line}:{tag_end.column} {last.line}:{last.column} end {show(element.end_span)}"
        )
        lines.extend(f"  @{show(attribute.name_span)} = {show(attribute.value_span)}" for attribute in element.attributes.values())
    lines.extend(f"comment {show(comment.span)}" for comment in document.comments)
    return lines


EXPECTED = [
    "launch 'launch' 2:2-2:8",
    "  2:1 2:9 11:10 end '</launch>' 11:1-11:10",
    "node 'node' 3:3-3:7",
    "  3:2 5:24 9:10 end '</node>' 9:3-9:10",
    "  @'pkg' 4:7-4:10 = 'übung' 4:14-4:19",
    "  @'name' 4:21-4:25 = 'a\"b' 4:27-4:30",
    "  @'type' 5:7-5:11 = 'c&lt;d' 5:13-5:19",
    "rosparam 'rosparam' 6:6-6:14",
    "  6:5 6:15 8:16 end '</rosparam>' 8:5-8:16",
    "arg 'arg' 10:4-10:7",
    "  10:3 10:18 10:18 end '' 10:18-10:18",
    "  @'name' 10:8-10:12 = 'x' 10:14-10:15",
    "comment '<!-- ü -->' 8:16-8:26",
]


def declared(encoding: str) -> str:
    return LAYOUT.replace('version="1.0"', f'version="1.0" encoding="{encoding}"')


ENCODINGS = {
    "utf-8": LAYOUT.encode(),
    "utf-8 declared": declared("UTF-8").encode(),
    "utf-8 with bom": b"\xef\xbb\xbf" + LAYOUT.encode(),
    "utf-16 le with bom": b"\xff\xfe" + LAYOUT.encode("utf-16-le"),
    "utf-16 be with bom, declared": b"\xfe\xff" + declared("UTF-16").encode("utf-16-be"),
    "utf-16 le without bom": LAYOUT.encode("utf-16-le"),
    "utf-16 be without bom": LAYOUT.encode("utf-16-be"),
    "iso-8859-1": declared("ISO-8859-1").encode("latin-1"),
    "iso-8859-1 with utf-8 bom": b"\xef\xbb\xbf" + declared("ISO-8859-1").encode("latin-1"),
    "latin1": declared("latin1").encode("latin-1"),
    "iso-8859-15": declared("ISO-8859-15").encode("iso-8859-15"),
    "windows-1252": declared("windows-1252").encode("windows-1252"),
    "us-ascii with references": declared("us-ascii").encode("ascii", "xmlcharrefreplace"),
}


@pytest.mark.parametrize("line_end", ["\n", "\r\n", "\r"], ids=["lf", "crlf", "cr"])
@pytest.mark.parametrize("encoding", [name for name in ENCODINGS if "references" not in name])
def test_layout(encoding: str, line_end: str) -> None:
    data = ENCODINGS[encoding]
    if line_end != "\n":
        codec = "utf-16-le" if "le" in encoding.split() else "utf-16-be" if "be" in encoding.split() else "ascii"
        data = data.replace("\n".encode(codec), line_end.encode(codec)) if codec == "ascii" else crossed(data, codec, line_end)
    document = parse(data, "a.launch")
    assert document.problems == []
    assert outline(document) == EXPECTED
    node, rosparam = document.elements[1], document.elements[2]
    assert {name: attribute.value for name, attribute in node.attributes.items()} == {"pkg": "übung", "name": 'a"b', "type": "c<d"}
    assert rosparam.text == "\n      a: 1\n    "
    assert document.source.position(rosparam.text_offset(rosparam.text.index("a: 1"))) == Position(7, 7)
    assert document.source.position(rosparam.text_offset(len(rosparam.text))) == Position(8, 5)


def crossed(data: bytes, codec: str, line_end: str) -> bytes:
    bom = data[:2] if data[:2] in (b"\xff\xfe", b"\xfe\xff") else b""
    return bom + data[len(bom) :].decode(codec).replace("\n", line_end).encode(codec)


def test_character_references_are_one_unit() -> None:
    document = parse(ENCODINGS["us-ascii with references"], "a.launch")
    pkg = document.elements[1].attributes["pkg"]
    assert (pkg.value, pkg.raw) == ("übung", "&#252;bung")
    start = pkg.value_span.start
    assert pkg.span_of(0, 1) == Span(start, start + 6)
    assert pkg.span_of(1, 3) == Span(start + 6, start + 8)


@pytest.mark.parametrize(
    ("written", "value", "part", "expected"),
    [
        ("abc", "abc", "b", "b"),
        ("a&lt;b&gt;c", "a<b>c", "<b", "&lt;b"),
        ("&quot;x&quot;", '"x"', "x", "x"),
        ("&quot;x&quot;", '"x"', 'x"', "x&quot;"),
        ("a&#10;b", "a\nb", "\n", "&#10;"),
        ("a&#x1F600;b", "a\U0001f600b", "b", "b"),
        ("a\r\n\tb", "a  b", "b", "b"),
        ("a\r\nb", "a b", " ", "\r\n"),
        ("a\nb", "a b", " b", "\nb"),
        ("x&robot;y", "xrobbyy", "yy", "&robot;y"),
        ("x&robot;y", "xrobbyy", "obb", "&robot;"),
        ("x&robot;-&robot;y", "xrobby-robbyy", "-r", "-&robot;"),
        ("&robot;&other;", "robbysomething", "some", "&robot;&other;"),  # two entities: nobody can tell, so all of it
        ("", "", "", ""),
    ],
)
def test_span_of_part(written: str, value: str, part: str, expected: str) -> None:
    text = f'<!DOCTYPE launch [<!ENTITY robot "robby"><!ENTITY other "something">]><launch a="{written}"/>'
    document = parse(text.encode(), "a.launch")
    attribute = document.elements[0].attributes["a"]
    assert attribute.value == value
    start = value.index(part)
    span = attribute.span_of(start, start + len(part))
    assert document.source.text[span.start : span.end] == expected


def test_text_of_several_pieces() -> None:
    document = parse(b"<launch>\r\na &amp; b<!-- no --><![CDATA[c\r\n<d>&amp;]]>e<x/>f<?pi?>g</launch>", "a.launch")
    launch = document.elements[0]
    assert [(text.value, text.cdata) for text in launch.texts] == [
        ("\na & b", False),
        ("c\n<d>&amp;", True),
        ("e", False),
        ("f", False),
        ("g", False),
    ]
    assert launch.text == "\na & bc\n<d>&amp;efg"
    written = document.source.text
    assert [written[launch.text_offset(index)] for index in range(len(launch.text))] == list("\ra & bc\r<d>&amp;efg")
    assert launch.text_offset(len(launch.text)) == written.index("</launch>")


def test_out_of_an_entity_everything_is_at_the_reference() -> None:
    text = "<!DOCTYPE launch [<!ENTITY e \"<arg name='n'>t<x/></arg>\">]><launch>a&e;b</launch>"
    document = parse(text.encode(), "a.launch")
    assert document.problems == []
    _, arg, x = document.elements
    reference = Span(text.rindex("&e;"), text.rindex("&e;") + 3)
    name = arg.attributes["name"]
    assert [arg.span, arg.start_span, arg.name_span, x.span, name.name_span, name.value_span, name.span, name.span_of(0, 1)] == [
        reference
    ] * 8
    assert (name.value, arg.text, document.elements[0].text) == ("n", "t", "ab")


def test_prefixes_and_namespaces_are_as_written() -> None:
    document = parse(b'<launch xmlns="u" xmlns:p="v" p:a="1" a="2"><p:node xml:lang="en"/></launch>', "a.launch")
    launch, node = document.elements
    assert {name: attribute.value for name, attribute in launch.attributes.items()} == {"xmlns": "u", "xmlns:p": "v", "p:a": "1", "a": "2"}
    assert (node.tag, document.source.text[slice(*node.name_span)]) == ("p:node", "p:node")
    assert [document.source.text[slice(*attribute.span)] for attribute in node.attributes.values()] == ['xml:lang="en"']
    assert document.launch is launch


def test_tree() -> None:
    document = parse(b"<!-- a --><launch><group><node/></group><arg/><!-- b --></launch>", "a.launch", "/ws/a.launch")
    launch, group, node, arg = document.elements
    assert [(e.tag, e.index, e.depth, e.self_closed, e.parent) for e in document.elements] == [
        ("launch", 0, 0, False, None),
        ("group", 1, 1, False, launch),
        ("node", 2, 2, True, group),
        ("arg", 3, 1, True, launch),
    ]
    assert (launch.children, group.children) == ([group, arg], [node])
    assert [(comment.text, comment.parent) for comment in document.comments] == [(" a ", None), (" b ", launch)]
    assert (document.root, document.launch, document.max_depth, document.source.file) == (launch, launch, 2, "/ws/a.launch")
    assert document.element_from(document.comments[0].span.end) is launch
    assert document.element_from(group.span.end) is arg
    assert document.element_from(arg.span.end) is None
