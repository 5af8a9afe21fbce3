"""Broken files: one problem each, where a person would look, with what was probably meant."""

from __future__ import annotations

import pytest

from launchlint.syntax.parse import parse
from tests.syntax.fields import own_fields

# what is written; line:column and text of the place; message; hint; related
CASES: dict[str, tuple[str, str, str, str, list[str]]] = {
    "never closed": (
        '<launch>\n  <node pkg="a">\n    <param name="b">\n    <param name="c"/>\n  </node>\n</launch>\n',
        '3:5 <param name="b">',
        "<param> is never closed",
        "end it with /> or add </param>",
        ["5:3 </node>: </node> comes first"],
    ),
    "end tag removed": (
        "<launch>\n  <group>\n    <arg/>\n    <arg/>\n\n  <group>\n  </group>\n</launch>\n",
        "4:10 >",
        "<group> is never closed",
        "</group> is missing here",
        ["2:3 <group>: opened here"],
    ),
    "end tag removed in the inner one": (
        "<launch>\n  <group>\n    <group>\n      <arg/>\n  </group>\n</launch>\n",
        "4:12 >",
        "<group> is never closed",
        "</group> is missing here",
        ["3:5 <group>: opened here"],
    ),
    "never closed until the end": (
        "<launch>\n  <arg/>\n",
        "2:8 >",
        "<launch> is never closed",
        "</launch> is missing here",
        ["1:1 <launch>: opened here"],
    ),
    "wrong end tag": (
        "<launch>\n  <node>\n    <param/>\n  </nod>\n</launch>\n",
        "4:3 </nod>",
        "</nod> does not fit the open <node>",
        "write </node> here",
        ["2:3 <node>: opened here"],
    ),
    "wrong end tag that is open further out": (
        "<launch>\n  <group>\n    <node>\n    </group>\n  </group>\n</launch>\n",
        "4:5 </group>",
        "</group> does not fit the open <node>",
        "write </node> here",
        ["3:5 <node>: opened here"],
    ),
    "closed twice": (
        "<launch>\n  <node/>\n      <param/>\n  <node pkg='a'/>\n    </node>\n</launch>\n",
        "5:5 </node>",
        "</node> closes nothing",
        "the <node …/> before it is already closed by its own />: remove one of the two",
        ["4:3 <node pkg='a'/>: already closed here"],
    ),
    "an end tag too many": (
        "<launch>\n</launch>\n</launch>\n",
        "3:1 </launch>",
        "an end tag too many",
        "<launch> is already closed",
        ["2:1 </launch>: it ends here"],
    ),
    "two root elements": (
        "<launch/>\n<launch/>\n",
        "2:1 <launch",
        "a second element <launch> stands after </launch>",
        "a file has one element around everything: join the two",
        ["1:2 launch: the file's element"],
    ),
    "text after the end": (
        "<launch/>\nfoo bar\n",
        "2:1 foo bar",
        "text stands after </launch>",
        "remove it",
        ["1:1 <launch/>: it ends here"],
    ),
    "text before the start": ("foo\n<launch/>\n", "1:1 foo", "text stands before the first element", "remove it", []),
    "empty": ("", "1:1 ", "the file is empty", "a launch file needs at least <launch></launch>", []),
    "blank": (" \n\n", "1:1 ", "the file is empty", "a launch file needs at least <launch></launch>", []),
    "only a comment": (
        "<!-- <launch/> -->\n",
        "1:1 <",
        "there is no element in this file",
        "a launch file needs at least <launch></launch>; everything here is a comment",
        [],
    ),
    "blank line before the declaration": (
        '\n<?xml version="1.0"?>\n<launch/>\n',
        '2:1 <?xml version="1.0"?>',
        "a blank line stands before <?xml …?>",
        "the declaration must be the very first thing in the file",
        [],
    ),
    "comment before the declaration": (
        '<!-- a --><?xml version="1.0"?>\n<launch/>\n',
        '1:11 <?xml version="1.0"?>',
        "a comment stands before <?xml …?>",
        "the declaration must be the very first thing in the file",
        [],
    ),
    "second declaration": (
        '<?xml version="1.0"?><?xml version="1.0"?>\n<launch/>\n',
        '1:22 <?xml version="1.0"?>',
        "a second <?xml …?> declaration",
        "remove it",
        [],
    ),
    "double hyphen": (
        "<launch>\n  <!-- a -- b -->\n</launch>",
        "2:10 --",
        "-- stands inside a comment",
        "XML does not allow it there: use one hyphen or other words",
        ["2:3 <!--: the comment begins here"],
    ),
    "comment in a comment": (
        "<launch>\n  <!-- <a/> <!-- b --> -->\n</launch>",
        "2:15 --",
        "-- stands inside a comment",
        "a comment cannot stand inside another one: end the first one with --> before it",
        ["2:3 <!--: the comment begins here"],
    ),
    "comment never closed": ("<launch>\n<!-- a\n</launch>\n", "2:1 <!--", "a comment is never closed", "it must end with -->", []),
    "attribute twice": (
        '<launch>\n  <node name="a" pkg="b" name="a"/>\n</launch>',
        "2:26 name",
        "the attribute name is given twice",
        "remove one of the two (they say the same)",
        ['2:9 name="a": the first one'],
    ),
    "missing blank": (
        '<launch>\n  <node name="a"pkg="b"/>\n</launch>',
        "2:17 pkg",
        "a blank is missing between name and pkg",
        "put a blank before pkg",
        [],
    ),
    "missing closing quote": (
        '<launch>\n  <node name="a pkg="b" type="c"/>\n</launch>',
        '2:9 name="a',
        "the value of name has no closing quote",
        'close it with "',
        [],
    ),
    "missing closing quote of the last attribute": (
        '<launch>\n  <node name="a" pkg="b/>\n  <node name="c"/>\n</launch>',
        '2:18 pkg="b',
        "the value of pkg has no closing quote",
        'close it with "',
        [],
    ),
    "missing opening quote": (
        '<launch>\n  <node name=a" pkg="b"/>\n</launch>',
        "2:9 name",
        "the value of name is not in quotes",
        'write name="…"',
        [],
    ),
    "no value": (
        "<launch>\n  <node required/>\n</launch>",
        "2:9 required",
        "required has no value",
        'write required="…", or remove it',
        [],
    ),
    "bare ampersand in a value": (
        '<launch>\n  <arg default="a & b"/>\n</launch>',
        "2:19 &",
        "a bare & in the value of default",
        "write &amp; for each &",
        [],
    ),
    "bare less-than in a value": (
        "<launch>\n  <group if=\"$(eval arg('a') < 2)\"/>\n</launch>",
        "2:30 <",
        "a bare < in the value of if",
        "write &lt;",
        [],
    ),
    "bare ampersand in the text": (
        "<launch>\n  <rosparam>a: b & c</rosparam>\n</launch>",
        "2:18 &",
        "a bare & in the text",
        "write &amp;",
        [],
    ),
    "bare less-than in the text": (
        "<launch>\n  <rosparam>a: b < c</rosparam>\n</launch>",
        "2:18 <",
        "a bare < in the text",
        "write &lt;",
        [],
    ),
    "unknown entity": (
        '<launch>\n  <arg default="a&nbsp;b"/>\n</launch>',
        "2:18 &nbsp;",
        "&nbsp; is not known in XML",
        "XML knows &lt; &gt; &amp; &quot; and &apos;; for a plain & write &amp;",
        [],
    ),
    "unknown prefix": (
        "<launch>\n  <node xacro:a='1'/>\n</launch>",
        "2:9 xacro:a",
        "the prefix xacro: is not declared",
        "remove it, or declare it with xmlns:xacro",
        [],
    ),
    "no end of the tag": (
        "<launch>\n  <node name='a'\n  <node name='b'/>\n</launch>",
        "2:3 <node",
        "the tag <node has no > at its end",
        "end it with /> or >",
        [],
    ),
    "blank in the end": (
        "<launch>\n  <node name='a' / >\n</launch>",
        "2:19  ",
        "<node does not end properly",
        "end it with /> (nothing between the two)",
        [],
    ),
    "comma between attributes": (
        "<launch>\n  <node name='a', pkg='b'/>\n</launch>",
        "2:17 ,",
        "',' does not belong after the value of name",
        "remove it",
        [],
    ),
    "merge conflict": (
        "<launch>\n<<<<<<< HEAD\n  <arg/>\n=======\n>>>>>>> other\n</launch>",
        "2:1 <<<<<<<",
        "an unresolved merge conflict",
        "choose one side and remove the lines with <<<<<<<, ======= and >>>>>>>",
        [],
    ),
    "unknown encoding": (
        '<?xml version="1.0" encoding="UTF8x"?>\n<launch/>',
        "1:31 UTF8x",
        "the encoding UTF8x is not one that XML parsers know",
        'save the file as UTF-8 and declare encoding="UTF-8"',
        [],
    ),
    "encoding of several bytes": (
        '<?xml version="1.0" encoding="gb2312"?>\n<launch/>',
        "1:31 gb2312",
        "the encoding gb2312 is not one that XML parsers know",
        'save the file as UTF-8 and declare encoding="UTF-8"',
        [],
    ),
    "wrong encoding": (
        '<?xml version="1.0" encoding="UTF-16"?>\n<launch/>',
        "1:31 UTF-16",
        "the declared encoding UTF-16 is not the one of the file",
        "save the file as UTF-8 and declare UTF-8",
        [],
    ),
    "control character": (
        "<launch>\n  <arg name='\x01'/>\n</launch>",
        "2:14 \x01",
        "the control character U+0001 is not allowed in XML",
        "remove it",
        [],
    ),
    "entity in itself": (
        '<!DOCTYPE launch [<!ENTITY a "&b;"><!ENTITY b "&a;">]>\n<launch>&a;</launch>',
        "2:9 &",
        "an entity refers to itself",
        "",
        [],
    ),
}


@pytest.mark.parametrize("name", CASES)
def test_one_problem(name: str) -> None:
    written, place, message, hint, related = CASES[name]
    document = parse(written.encode(), "a.launch")
    (problem,) = document.problems

    def show(where: object) -> str:
        span = where.span  # type: ignore[attr-defined]  # a Place
        at = document.source.position(span.start)
        return f"{at.line}:{at.column} {document.source.text[span.start : span.end]}"

    assert (problem.kind, problem.refused) == ("malformed-xml", True)
    assert (show(problem.place), problem.message, problem.hint) == (place, message, hint)
    assert [f"{show(where)}: {label}" for where, label in problem.related] == related
    assert problem.code.startswith("XML_ERROR_")
    assert document.launch is None


def test_bad_byte() -> None:
    document = parse(b"<launch>\n<!-- ok -->\n<!-- caf\xe9 -->\n</launch>", "a.launch")
    (problem,) = document.problems
    assert own_fields(problem) == {
        "message": "the byte 0xE9 is not valid UTF-8",
        "code": "XML_ERROR_INVALID_TOKEN",
        "hint": 'save the file as UTF-8, or declare its encoding, for example encoding="ISO-8859-1"',
        "opened": "",
        "closed": "",
    }
    assert document.source.position(problem.place.span.start) == (3, 9)
    assert problem.place.text == "\ufffd"
    assert [comment.text for comment in document.comments] == [" ok "]  # what was read until there is kept


def test_tags_are_named() -> None:
    document = parse(b"<launch>\n<node>\n</launch>", "a.launch")
    (problem,) = document.problems
    assert own_fields(problem) == {
        "message": "<node> is never closed",
        "code": "XML_ERROR_TAG_MISMATCH",
        "hint": "end it with /> or add </node>",
        "opened": "node",
        "closed": "launch",
    }


@pytest.mark.parametrize(
    ("written", "place", "fields", "related"),
    [
        ("<lauch><node/></lauch>", "lauch", {"tag": "lauch", "count": 0}, []),
        ("<launch><group><launch/></group></launch>", "launch", {"tag": "launch", "count": 2}, ["the first <launch>"]),
        ("<robot><launch/><launch/><launch/></robot>", "launch", {"tag": "robot", "count": 3}, ["the first <launch>"]),
    ],
)
def test_root(written: str, place: str, fields: dict[str, object], related: list[str]) -> None:
    document = parse(written.encode(), "a.launch")
    (problem,) = document.problems
    assert (problem.kind, own_fields(problem), problem.refused, problem.place.text) == ("root-not-launch", fields, True, place)
    assert [label for _, label in problem.related] == related
    assert document.launch is None


def test_a_foreign_root_around_one_launch_is_accepted() -> None:
    document = parse(b"<robot><launch/></robot>", "a.launch")
    (problem,) = document.problems
    assert (problem.kind, problem.refused, problem.place.text) == ("root-not-launch", False, "robot")
    assert document.launch is document.elements[1]
