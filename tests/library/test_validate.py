"""The validator: each kind of fault with its message and its place, which § marks in the text."""

from __future__ import annotations

import json

import pytest

from launchlint.errors import LibraryError
from launchlint.library.file import examine, parse
from launchlint.library.inspection import inspect
from tests.library.samples import publishers

TOP = '{"format": "launchlint-library", "version": 1, "packages": '
KEYS_OF_A_PUBLISHER = "name, type, md5, latched, by_hand, queue, transport, when, condition, each, evidence"


def told(marked: str) -> tuple[str, str]:
    """The place that § marks, as the start of a line of output, and the text without the mark."""
    before, _, after = marked.partition("§")
    return f"lib.json:{before.count(chr(10)) + 1}:{len(before) - before.rfind(chr(10))}: ", before + after


def package(text: str) -> str:
    return f'{TOP}{{\n "demo": {text}\n}}}}\n'


def program(text: str) -> str:
    return package(f'{{"executables": {{\n  "node": {text}\n }}}}')


def publisher(text: str) -> str:
    return program(f'{{"variants": {{"default": {{"publishers": [\n   {{"name": "a"}},\n   {text}\n  ]}}}}}}')


def frame(text: str) -> str:
    return program(f'{{"variants": {{"default": {{"frames": [{text}]}}}}}}')


def condition(text: str) -> str:
    return publisher(f'{{"name": "x", "condition": {text}}}')


def each(text: str) -> str:
    return publisher(f'{{"name": "{{each}}", "each": {text}}}')


CONDITION_KINDS = "param, arg, option, remap, not, all, any, text"
DEEP = "[" * 60 + "]" * 60

SHAPES = [
    ("§[]", "the library must be a mapping, and is a list"),
    ("§null", "the library must be a mapping, and is null"),
    (TOP + "§[]}", "this must be a mapping from each package to what it is, and is a list"),
    ('{"format": §"other", "version": 1, "packages": {}}', '"other" is not one of launchlint-library'),
    ('{"format": §3, "version": 1, "packages": {}}', "this must be a string, and is 3"),
    (
        '{"format": "launchlint-library", "version": §3, "packages": {}}',
        "this launchlint reads the versions 1 and 2 of the format, and this is version 3: use a newer launchlint",
    ),
    ('{"format": "launchlint-library", "version": §true, "packages": {}}', "this must be a whole number, at least 1, and is true"),
    ('§{"format": "launchlint-library", "version": 1}', 'the library lacks the key "packages"'),
    (TOP + '{}, "package": §1}', 'the library has no key "package": did you mean packages?'),
    (TOP + '{}, "sources": [{"id": "a", "url": "b", "dirty": §1}]}', "this must be true or false, and is 1"),
    (TOP + '{}, "sources": [§{"id": "a"}]}', 'a source lacks the key "url"'),
    (TOP + '{"": §{}}}', "the name of the package is empty"),
    (TOP + '{"' + "x" * 1001 + '": §{}}}', "the name of the package is too long"),
    (package("§7"), "a package must be a mapping, and is 7"),
    (package('{"complete": §"nodelets"}'), 'this must be a list, and is "nodelets"'),
    (package('{"complete": [§"nodelet"]}'), '"nodelet" is not one of executables, nodelets; did you mean nodelets?'),
    (package('{"build": {"result": §"fine"}}'), '"fine" is not one of ok, partial, failed'),
    (program('{"class": §"rosjava"}'), '"rosjava" is not one of roscpp, rospy, nodelet, none, other'),
    (program('{"options": {"-r": §-1}}'), "this must be a whole number, at least 0, and is -1"),
    (program('{"options": {"-r": §1.5}}'), "this must be a whole number, at least 0, and is 1.5"),
    (program('{"varaints": §{}}'), 'an executable or nodelet has no key "varaints": did you mean variants?'),
    (program('{"problems": [§{"detail": "x"}]}'), 'a problem lacks the key "code"'),
    (
        program('{"variants": {"default": {"open": {"topics": §"x"}}}}'),
        'what is open has no key "topics": there are publishers, subscribers, services, clients, actions, params',
    ),
    (publisher('§"chatter"'), 'a publisher must be a mapping, and is "chatter"'),
    (publisher('§{"type": "std_msgs/String"}'), 'a publisher lacks the key "name"'),
    (publisher('{"name": "x", "topic": §1}'), f'a publisher has no key "topic": there are {KEYS_OF_A_PUBLISHER}'),
    (publisher('{"name": §["x"]}'), "this must be a string, and is a list"),
    (publisher('{"name": §"' + "x" * 1001 + '"}'), "this is longer than 1000 characters"),
    (publisher('{"name": "x", "when": §"always"}'), '"always" is not one of start, subscriber, message'),
    (publisher('{"name": "x", "latched": §"yes"}'), 'this must be true or false, and is "yes"'),
    (publisher('{"name": "x", "evidence": [§{"at": "x"}]}'), 'evidence lacks the key "by"'),
    (publisher('{"name": "x", "evidence": [{"by": §"guess"}]}'), '"guess" is not one of manual, dynamic, static'),
    (frame('{"name": "odom", "role": §"parent"}'), '"parent" is not one of child, used, label'),
    (frame('§{"name": "odom"}'), 'a frame lacks the key "role"'),
    (condition("§1"), f"a condition has one of the keys {CONDITION_KINDS}"),
    (condition("§{}"), f"a condition has one of the keys {CONDITION_KINDS}"),
    (condition('§{"param": "x", "arg": 1}'), f"a condition has one of the keys {CONDITION_KINDS}"),
    (condition('{"param": §""}'), "this must be a string"),
    (condition('{"arg": §0}'), "this must be the number of an argument, counted from 1 or from -1"),
    (condition('{"arg": §10000}'), "this must be the number of an argument, counted from 1 or from -1"),
    (condition('{"arg": §true}'), "this must be the number of an argument, counted from 1 or from -1"),
    (condition('{"remap": "x", "is": §1}'), 'a condition on remap has no key "is"'),
    (condition('{"param": "x", "in": §1}'), "this must be a list of values"),
    (condition('{"param": "x", "set": §1}'), "this must be true or false"),
    (condition('{"all": §[]}'), "this must be a list of conditions"),
    (condition('{"all": [{"arg": 1}, §{}]}'), f"a condition has one of the keys {CONDITION_KINDS}"),
    (condition('{"not": {"param": §5}}'), "this must be a string"),
    (each("§[]"), "`each` has one of the keys args, param, words"),
    (each('{"args": §"2"}'), "this must be the number of an argument, counted from 1 or from -1"),
    (each('{"args": 2, "like": §"topic"}'), "this must be names in braces, each once, with something between them: {topic}@{type}"),
    (each('{"args": 2, "like": §"{a}{b}"}'), "this must be names in braces, each once, with something between them: {topic}@{type}"),
    (each('{"args": 2, "like": §"{a}@{B}"}'), "this must be names in braces, each once, with something between them: {topic}@{type}"),
    (each('{"args": 2, "like": §5}'), "this must be names in braces, each once, with something between them: {topic}@{type}"),
    (each('{"args": 2, "default": §["x"]}'), '`each` over args has no key "default"'),
    (each('{"param": §1}'), "this must be the name of a param"),
    (each('{"words": "~x", "default": §"a b"}'), "this must be a list of strings"),
]

GRAMMAR = [
    (each('{"args": 2, "like": §"{a}@{a}"}'), "this must be names in braces, each once, with something between them: {topic}@{type}"),
    (frame('{"name": §"/map", "role": "used"}'), '"/map" is no frame: it has no blanks, no ~ and no / before it'),
    (
        frame('{"name": §"{arg:0}", "role": "used"}'),
        '"{arg:0}" is no template: {arg:0} must be the number of an argument, counted from 1 or from -1',
    ),
    (frame('{"name": "odom", "role": "child", "parent": §"a b"}'), '"a b" is no frame: it has no blanks, no ~ and no / before it'),
    (publisher('{"name": §""}'), '"" is no ROS name: letters, digits, _ and /, after a / or ~ at most'),
    (publisher('{"name": §"a b"}'), '"a b" is no ROS name: letters, digits, _ and /, after a / or ~ at most'),
    (publisher('{"name": §"größe"}'), '"größe" is no ROS name: letters, digits, _ and /, after a / or ~ at most'),
    (publisher('{"name": §"a\\n"}'), '"a\\n" is no ROS name: letters, digits, _ and /, after a / or ~ at most'),
    (publisher('{"name": §"{arg:0}"}'), '"{arg:0}" is no template: {arg:0} must be the number of an argument, counted from 1 or from -1'),
    (
        publisher('{"name": §"{arg:--1}"}'),
        '"{arg:--1}" is no template: {arg:--1} must be the number of an argument, counted from 1 or from -1',
    ),
    (publisher('{"name": "x", "type": §"String"}'), '"String" is no type: it is written package/Type'),
    (
        publisher('{"name": "x", "type": §"{"}'),
        '"{" is no template: {} is no template; there are arg, option, param, remap, parent, each, node, any',
    ),
    (publisher('{"name": "x", "md5": §"abc"}'), '"abc" is no MD5 sum: 32 digits of 0-9 a-f'),
    (condition('{"not": ' * 8 + '{"not": §{"arg": 1}}' + "}" * 8), "a condition is nested deeper than 8 levels"),
    (condition('§{"param": "x", "is": ' + DEEP + "}"), "this is nested deeper than 50 levels"),
    (program('{"variants": {"default": {"params": [{"name": "x", "default": §' + DEEP + "}]}}}"), "this is nested deeper than 50 levels"),
]


@pytest.mark.parametrize(("marked", "message"), SHAPES + GRAMMAR)
def test_fault(marked: str, message: str) -> None:
    place, text = told(marked)
    assert examine(text.encode(), "lib.json")[1] == [place + message]


@pytest.mark.parametrize(
    ("marked", "message"),
    [
        ("§", "the library is not JSON: expecting value"),
        ('{\n "a": §}', "the library is not JSON: expecting value"),
        ("{} §x", "the library is not JSON: extra data"),
        ('{"a": §NaN}', "the library is not JSON: NaN is no number that can be held"),
        ('{"NaN": "NaN",\n "a": §-Infinity}', "the library is not JSON: -Infinity is no number that can be held"),
        ('{"a": [1, 1e9, §-1e999]}', "the library is not JSON: -1e999 is no number that can be held"),
        (
            '{"a": 1' + "0" * 400 + ', "b": §' + "1" * 5000 + "}",
            "the library is not JSON: 11111111111111111… is no number that can be held",
        ),
        ('{"a": "\\\\ud800 \\ud83d\\ude00 §\\ud800"}', "the library is not JSON that can be read: \\ud800 is half of a character"),
        ('["§\\uDE00\\ud83d"]', "the library is not JSON that can be read: \\uDE00 is half of a character"),
        ("§" + "[" * 100_000, "the library is not JSON that can be read: it is nested too deep"),
        ("§" + '{"a":' * 100_000, "the library is not JSON that can be read: it is nested too deep"),
    ],
    ids=["empty", "no value", "more", "NaN", "infinity", "float", "int", "surrogate", "low surrogate", "lists", "mappings"],
)
def test_no_json(marked: str, message: str) -> None:
    place, text = told(marked)
    assert examine(text.encode(), "lib.json") == (None, [place + message])


def test_no_utf8() -> None:
    assert examine(b'{"a":\n "\xc3\xa4\xff"}', "lib.json") == (None, ["lib.json:2:4: the library is not UTF-8"])


def test_byte_order_mark() -> None:
    text = json.dumps(publishers({"name": "x"}))
    assert examine(b"\xef\xbb\xbf" + text.encode(), "lib.json") == (publishers({"name": "x"}), [])


def test_all_faults_are_told_in_order() -> None:
    text = publisher('{"name": "a b", "type": 1},\n   {"when": 5}')
    assert examine(text.encode(), "lib.json")[1] == [
        'lib.json:5:13: "a b" is no ROS name: letters, digits, _ and /, after a / or ~ at most',
        "lib.json:5:28: this must be a string, and is 1",
        "lib.json:6:13: this must be a string, and is 5",
        'lib.json:6:4: a publisher lacks the key "name"',
    ]


def test_whoever_needs_a_library_is_told_ten_faults() -> None:
    with pytest.raises(LibraryError) as error:
        parse(json.dumps(publishers(*[{"name": "a b"}] * 12)).encode(), "lib.json")
    lines = str(error.value).splitlines()
    assert (len(lines), lines[-1]) == (11, "lib.json: and 2 more: launchlint library validate lib.json")


def test_a_key_that_stands_twice() -> None:
    text = f'{TOP}{{\n "demo": {{"version": "1",\n  "version": "2"}},\n "demo": {{}}\n}}}}'
    assert inspect(text.encode(), "lib.json")[1] == [
        "lib.json:4:10: this key stands twice in the same mapping; only this value counts: demo"
    ]
    assert examine(text.encode(), "lib.json")[1] == []
