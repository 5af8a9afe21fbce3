"""The same verdict, values and texts as xml.dom.minidom, which is what roslaunch reads a file with."""

from __future__ import annotations

import os
from collections.abc import Iterator
from pathlib import Path
from typing import Any
from xml.dom import minidom

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from launchlint.syntax.parse import parse
from launchlint.syntax.tree import Document

PIECES = [
    "<launch>",
    "</launch>",
    "<node ",
    "<node>",
    "</node>",
    "<a:b ",
    "/>",
    ">",
    " name='x'",
    ' pkg="y"',
    " xmlns:a='u'",
    " xmlns='u v'",
    " xmlns=''",
    "é",
    "text",
    " ",
    "\n",
    "\r\n",
    "\t",
    "<!-- c -->",
    "<!-- -- -->",
    "<?pi x?>",
    "<![CDATA[",
    "]]>",
    "&lt;",
    "&#65;",
    "&e;",
    "&f;",
    "&",
    "<",
    "\x00",
    "\x0b",
    "\u2028",
    "=",
    "'",
    '"',
    '<?xml version="1.0"?>',
    '<?xml version="1.0" encoding="ISO-8859-1"?>',
    "<!DOCTYPE launch [",
    "]>",
    "<!ENTITY e 'v<node/>w'>",
    "<!ENTITY f SYSTEM 'file:///etc/passwd'>",
    "<!ATTLIST node name NMTOKEN 'd' xmlns:a CDATA 'u'>",
    "<!DOCTYPE launch SYSTEM 'x.dtd'>",
    "%p;",
    "<!ENTITY % p '<!ENTITY e \"z\">'>",
]


def minidom_says(data: bytes) -> Any:
    """The minidom document, or ``None`` where minidom (and so roslaunch) refuses the file."""
    try:
        return minidom.parseString(data)
    except Exception:
        return None


def all_elements(document: Any) -> Iterator[Any]:
    stack = [document.documentElement]
    while stack:
        element = stack.pop()
        yield element
        stack.extend(reversed([child for child in element.childNodes if child.nodeType == child.ELEMENT_NODE]))


def content(document: Any) -> list[tuple[str, dict[str, str], str]]:
    text_types = (minidom.Node.TEXT_NODE, minidom.Node.CDATA_SECTION_NODE)
    return [
        (
            element.tagName,
            {name: value or "" for name, value in element.attributes.items()},
            "".join(child.data for child in element.childNodes if child.nodeType in text_types),
        )
        for element in all_elements(document)
    ]


def agree(data: bytes) -> Document:
    document = parse(data, "a.launch")
    expected = minidom_says(data)
    refused = [problem for problem in document.problems if problem.kind == "malformed-xml"]
    assert bool(refused) == (expected is None), (data, refused)
    assert len(refused) <= 1
    text = document.source.text
    for problem in document.problems:
        for place in (problem.place, *(where for where, _ in problem.related)):
            assert 0 <= place.span.start <= place.span.end <= len(text)
    if expected is not None:
        mine = [(e.tag, {name: attribute.value for name, attribute in e.attributes.items()}, e.text) for e in document.elements]
        assert mine == content(expected)
        assert (document.launch is not None) == (len(expected.getElementsByTagName("launch")) == 1)
    for element in document.elements:
        assert 0 <= element.span.start <= element.start_span.end <= element.span.end <= len(text)
        for index in range(len(element.text) + 1):
            assert 0 <= element.text_offset(index) <= len(text)
        for attribute in element.attributes.values():
            assert text[slice(*attribute.value_span)] == attribute.raw
            if "<!" not in text:
                assert text[slice(*attribute.name_span)] == attribute.name
                assert attribute.span_of(0, len(attribute.value)) == attribute.value_span
    return document


@settings(max_examples=400, deadline=None)
@given(st.lists(st.sampled_from(PIECES), max_size=14).map("".join))
def test_pieces(text: str) -> None:
    agree(text.encode())


@settings(max_examples=200, deadline=None)
@given(
    st.lists(st.sampled_from(PIECES), max_size=10).map("".join),
    st.sampled_from(["utf-16", "utf-16-le", "utf-16-be", "utf-8-sig", "latin-1", "utf-7"]),
)
def test_pieces_in_other_encodings(text: str, encoding: str) -> None:
    agree(text.encode(encoding, "replace"))


@settings(max_examples=200, deadline=None)
@given(
    st.lists(st.sampled_from(PIECES), max_size=10).map("".join),
    st.sampled_from(["<launch>", "<!DOCTYPE launch [<!ENTITY e 'v<node/>w'>]><launch>"]),
)
def test_inside_launch(text: str, head: str) -> None:
    agree(f"{head}{text}</launch>".encode())


ATTRIBUTE = st.tuples(st.sampled_from(["name", "pkg", "a-b", "é"]), st.text("aé &<>\"'\t\n😀$()", max_size=8))


def tree(depth: int) -> st.SearchStrategy[str]:
    inside = st.text("ab é&<\n", max_size=5).map(lambda text: text.replace("&", "&amp;").replace("<", "&lt;"))
    body = st.lists(inside if depth == 0 else st.one_of(inside, tree(depth - 1)), max_size=3).map("".join)
    return st.tuples(st.sampled_from(["node", "arg", "x"]), st.lists(ATTRIBUTE, max_size=3, unique_by=lambda pair: pair[0]), body).map(
        lambda made: "<{0}{1}>{2}</{0}>".format(
            made[0],
            "".join(
                f'\n {name}\t= "{value.replace("&", "&amp;").replace("<", "&lt;").replace(chr(34), "&quot;")}"' for name, value in made[1]
            ),
            made[2],
        )
    )


@settings(max_examples=200, deadline=None)
@given(tree(2))
def test_well_formed(text: str) -> None:
    document = agree(text.encode())
    assert [problem.kind for problem in document.problems] == ["root-not-launch"]


@settings(max_examples=400, deadline=None)
@given(st.binary(max_size=60))
def test_any_bytes(data: bytes) -> None:
    agree(data)


@settings(max_examples=200, deadline=None)
@given(
    st.binary(max_size=30),
    st.sampled_from(
        [
            "utf-8",
            "us-ascii",
            "iso-8859-15",
            "windows-1252",
            "koi8-r",
            "utf-7",
            "cp037",
            "punycode",
            "rot13",
            "unicode_escape",
            "idna",
            "hex",
        ]
    ),
)
def test_any_bytes_in_any_declared_encoding(data: bytes, encoding: str) -> None:
    agree(f'<?xml version="1.0" encoding="{encoding}"?><launch a="'.encode() + data + b'"/>')


@pytest.mark.corpus
@pytest.mark.skipif("LAUNCHLINT_CORPUS" not in os.environ, reason="LAUNCHLINT_CORPUS names no directory of launch files")
def test_corpus() -> None:
    checked = 0
    for file in sorted(Path(os.environ["LAUNCHLINT_CORPUS"]).rglob("*")):
        if file.suffix in (".launch", ".test", ".xml") and file.is_file():
            agree(file.read_bytes())
            checked += 1
    assert checked
