"""YAML as rosparam sees it: values, places, errors in plain words, bounds, and the real rosparam beside it."""

from __future__ import annotations

import json
import subprocess
import time

import pytest
import yaml
from hypothesis import given, settings
from hypothesis import strategies as st

from launchlint.evaluate.ros1.rosparam import Duplicate, UnknownValue, YamlError, YamlUnknown, load
from launchlint.yaml.tree import Node, Reader, parse

REFUSED = "(refused)"

# text, repr of the data that rosparam loads
TABLE = (
    ("", "None"),
    ("# nothing\n", "None"),
    ("a: 1", "{'a': 1}"),
    ("5", "5"),
    ("[1, two, 3.0]", "[1, 'two', 3.0]"),
    ("a: {b: {c: 1}, d: 2}\ne: []\nf: {}", "{'a': {'b': {'c': 1}, 'd': 2}, 'e': [], 'f': {}}"),
    (
        "{a: on, b: Off, c: yes, d: NO, e: True, f: y, g: n}",
        "{'a': True, 'b': False, 'c': True, 'd': False, 'e': True, 'f': 'y', 'g': 'n'}",
    ),
    ("[1, +1, -1, 0, 00, 012, 0o14, 0x1F, 0b11, 1_000]", "[1, 1, -1, 0, 0, 10, '0o14', 31, 3, 1000]"),
    ("[08, 09, 1:30, 1:30:00, -1:30, 12:61]", "['08', '09', 90, 5400, -90, '12:61']"),
    ("[1e3, 1.e3, 1.0e+3, 1.0e3, .5, 5., -.5, 1_0.5]", "['1e3', '1.e3', 1000.0, '1.0e3', 0.5, 5.0, '-.5', 10.5]"),
    ("[.inf, -.INF, .nan, inf, nan, 190:20:30.15, -0.0]", "[inf, -inf, nan, 'inf', 'nan', 685230.15, -0.0]"),
    ("[null, Null, ~, '', none]", "[None, None, None, '', 'none']"),
    ("a:\nb: ''", "{'a': None, 'b': ''}"),
    (
        "[deg(180), deg( 90.0 ), rad(pi/2), rad(2*pi), !degrees 90, !radians pi]",
        "[3.141592653589793, 1.5707963267948966, 1.5707963267948966, 6.283185307179586, 1.5707963267948966, 3.141592653589793]",
    ),
    ("[deg(90), 'deg(90)', deg(90) , x deg(90), deg (90)]", "[1.5707963267948966, 'deg(90)', 1.5707963267948966, 'x deg(90)', 'deg (90)']"),
    ("a: rad(1 + int(2))", "{'a': 'rad(1 + int(2))'}"),
    ("a: !radians 1 + int(2.5)", "{'a': 3.0}"),
    ("a: rad(2 ** 3 - 1/4.0)", "{'a': 7.75}"),
    ("a: 2001-12-14", "{'a': datetime.date(2001, 12, 14)}"),
    ("a: 2001-12-14 21:59:43", "{'a': datetime.datetime(2001, 12, 14, 21, 59, 43)}"),
    ("a: !!binary aGVsbG8=", "{'a': b'hello'}"),
    ("a: !!set {x}", "{'a': {'x'}}"),
    ("a: !!omap [x: 1, y: 2]", "{'a': [('x', 1), ('y', 2)]}"),
    ("a: !!str 5\nb: !!int '5'\nc: !!float 5\nd: !!bool 'on'", "{'a': '5', 'b': 5, 'c': 5.0, 'd': True}"),
    ("a: &x {p: 1, q: 2}\nb: *x", "{'a': {'p': 1, 'q': 2}, 'b': {'p': 1, 'q': 2}}"),
    ("a: &x {p: 1, q: 2}\nb: {<<: *x, q: 3}", "{'a': {'p': 1, 'q': 2}, 'b': {'p': 1, 'q': 3}}"),
    (
        "a: &x {p: 1}\nb: &y {p: 2, r: 4}\nc: {q: 3, <<: [*x, *y]}",
        "{'a': {'p': 1}, 'b': {'p': 2, 'r': 4}, 'c': {'p': 1, 'r': 4, 'q': 3}}",
    ),
    ("a: 1\nb: 2\na: 3", "{'a': 3, 'b': 2}"),
    ("a:\n- 1\n- 2", "{'a': [1, 2]}"),
    ("a: |\n  x\n   y\n\nb: >-\n  x\n  y", "{'a': 'x\\n y\\n', 'b': 'x y'}"),
    ("a: \"x\\n\\u00e9\"\nb: 'it''s'", "{'a': 'x\\né', 'b': \"it's\"}"),
    ("a: x y\n  z", "{'a': 'x y z'}"),
    ("a: http://x:80/y", "{'a': 'http://x:80/y'}"),
    ("a: $(arg x)", "{'a': '$(arg x)'}"),
    ("rate:10", "'rate:10'"),
    ("{a:1}", "{'a:1': None}"),
    ("a: 1\r\nb: 2\r\n", "{'a': 1, 'b': 2}"),
    ("\ufeffa: 1", "{'a': 1}"),
    ("a: äöü 🙂", "{'a': 'äöü 🙂'}"),
    ("---\na: 1\n...\n", "{'a': 1}"),
    ("'=': 1\n=: 2", "{'=': 2}"),
    ("a: !!map {b: 1}", "{'a': {'b': 1}}"),
    ("a: 123456789012345678901234567890", "{'a': 123456789012345678901234567890}"),
    # what roslaunch refuses
    ("a: b: c", REFUSED),
    ("a: 1\n b: 2", REFUSED),
    ("a:\t1", REFUSED),
    ("\ta: 1", REFUSED),
    ("a: 1\t# note", REFUSED),
    ("a: \t1", REFUSED),
    ("a: [1, 2", REFUSED),
    ("a: 'x", REFUSED),
    ("a: @x", REFUSED),
    ("a: %x", REFUSED),
    ("a: `x`", REFUSED),
    ("a: *nothing", REFUSED),
    ("a: &x 1\nb: &x 2", REFUSED),
    ("a: 1\n---\nb: 2", REFUSED),
    ("%YAML:1.0\n---\na: 1", REFUSED),
    ("a: !unknown 1", REFUSED),
    ("a: !!python/object:os.system x", REFUSED),
    ("a: 2001-13-45", REFUSED),
    ("a: !!int x", REFUSED),
    ("a: =", REFUSED),
    ("a: deg(x)", REFUSED),
    ("a: deg(2*90)", REFUSED),
    ("a: rad(math.pi)", REFUSED),
    ("a: !radians sin(1)", REFUSED),
    ("a: rad(x)", REFUSED),
    ("a: rad(1/0)", REFUSED),
    ("a: rad(1 +)", REFUSED),
    ("{[1]: 2}", REFUSED),
    ("{<<: 5}", REFUSED),
    ("1: x", REFUSED),
    ("a: {2.5: x}", REFUSED),
    ("on: x", REFUSED),
    ("~: x", REFUSED),
    ("off: x", REFUSED),
    ("a: \x00", REFUSED),
    ("a: \x07", REFUSED),
)
TEXTS = [text for text, _ in TABLE]


def outcome(text: str) -> str:
    try:
        loaded = load(text)
    except YamlError as error:
        return REFUSED if 0 <= error.offset <= len(text) else "(an error outside the text)"
    return repr(loaded.data)


@pytest.mark.parametrize(("text", "expected"), TABLE)
def test_data(text: str, expected: str) -> None:
    assert outcome(text) == expected


def test_leaves_come_in_the_order_roslaunch_sets_them_with_their_places() -> None:
    text = "a: 1  # one\nb:\n  c: 'two'\n  d: [1, 2]\n  e: {}\nf:\n  - x\n  - y  # last\n\n# end\ng: |\n  text\n\nh:\ni: {j: 5, k: }\n"
    found = [
        (entry.path, entry.value, text[entry.key_start : entry.key_end], text[entry.value_start : entry.value_end])
        for entry in load(text).entries
    ]
    assert found == [
        (("a",), 1, "a", "1"),
        (("b", "c"), "two", "c", "'two'"),
        (("b", "d"), [1, 2], "d", "[1, 2]"),
        (("f",), ["x", "y"], "f", "- x\n  - y"),
        (("g",), "text\n", "g", "|\n  text"),
        (("h",), None, "h", ""),
        (("i", "j"), 5, "j", "5"),
        (("i", "k"), None, "k", ""),
    ]


def test_a_value_left_out_stands_behind_its_colon() -> None:
    text = "a  :\nb: 1\n"
    entry = load(text).entries[0]
    assert (entry.value_start, entry.value_end) == (4, 4)


def test_leaves_of_aliases_and_merges_stand_where_they_are_written() -> None:
    text = "x: &x {p: 1, q: 2}\ny: {<<: *x, q: 3}\nz: *x\nz: *x\n"
    loaded = load(text)
    assert [(entry.path, entry.value, entry.value_start) for entry in loaded.entries] == [
        (("x", "p"), 1, 10),
        (("x", "q"), 2, 16),
        (("y", "p"), 1, 10),
        (("y", "q"), 3, 34),
        (("z", "p"), 1, 10),
        (("z", "q"), 2, 16),
    ]
    assert loaded.duplicates == (Duplicate(("z",), (37, 38), (43, 44), same_value=True),)


def test_a_document_that_is_no_dictionary_is_one_leaf() -> None:
    assert [(entry.path, entry.value, entry.value_start, entry.value_end) for entry in load(" [1, 2] ").entries] == [((), [1, 2], 1, 7)]
    assert load("~").entries == ()
    assert load("{}").entries == ()


def test_duplicate_keys() -> None:
    text = "a: 1\nb: {c: 1, c: 1.0, c: 1.0}\na: 2\nd: [{e: x, e: x}]\n"
    assert load(text).duplicates == (
        Duplicate(("b", "c"), (9, 10), (15, 16), same_value=False),
        Duplicate(("b", "c"), (15, 16), (23, 24), same_value=True),
        Duplicate(("a",), (0, 1), (31, 32), same_value=False),
        Duplicate(("d", 0, "e"), (41, 42), (47, 48), same_value=True),
    )


def test_texts_that_look_like_key_and_value() -> None:
    text = "a: rate:10\nb: http://x\nc: pkg::Class\nd: 'x:1'\ne: 12:30\nf: C:\\x\n{g:5}: 1\n".replace("{g:5}: 1", "g: {h:5}")
    assert [text[start:end] for start, end in load(text).scalar_colon] == ["rate:10", "h:5"]


@pytest.mark.parametrize(
    ("text", "kind", "marked", "message"),
    [
        (
            "a: 1\nb: 2: 3\n",
            "syntax",
            ": 3",
            "a second colon stands where no key can be; the indentation differs from the lines above, or the value",
        ),
        ("a:\n\tb: 1", "syntax", "\tb", "a tab stands here, and YAML wants blanks; replace the tab by blanks"),
        ("é: 1\n---\nb: 2", "documents", "---", "a second YAML document starts here; rosparam loads files with one document only"),
        (
            "a: 1\n12: x",
            "key",
            "12",
            "YAML reads the key '12' as a number, and roslaunch stops at keys that are not text; put it in quotes",
        ),
        (
            "a: {on: x}",
            "key",
            "on",
            "YAML reads the key 'on' as true or false, and roslaunch stops at keys that are not text; put it in quotes",
        ),
        ("a: *b", "anchor", "*b", "the alias *b refers to an anchor that is not set above it"),
        (
            "a: !!python/name:os.system",
            "tag",
            "!!py",
            "the YAML tag 'tag:yaml.org,2002:python/name:os.system' is not one that rosparam knows",
        ),
        ("a: 2001-13-45", "value", "2001", "'2001-13-45' cannot be read as timestamp (Python says: ValueError: month must be in 1..12)"),
        ("a: deg(90 / 2)", "value", "deg", "deg() wants one number, not '90 / 2'"),
        ("a: x\x07", "character", "\x07", "YAML does not allow the character U+0007, which stands here"),
        (
            "%YAML:1.0\na: 1",
            "syntax",
            ":1.0",
            "this line is no YAML directive; files that OpenCV writes start with %YAML:1.0, and rosparam",
        ),
    ],
)
def test_error_has_its_place_and_says_what_is_wrong(text: str, kind: str, marked: str, message: str) -> None:
    with pytest.raises(YamlError) as raised:
        load(text)
    assert raised.value.kind == kind
    assert text[raised.value.offset :].startswith(marked)
    assert raised.value.message.startswith(message)


def test_keys_are_free_where_nothing_is_unrolled() -> None:
    loaded = load("{1: a, on: b, ~: {2: c}}", unroll=False)
    assert loaded.data == {1: "b", None: {2: "c"}}
    assert loaded.entries == ()
    assert load("[{1: a}]").data == [{1: "a"}]


@pytest.mark.parametrize(
    "expression", ["os.system('clear')", "__import__('os').getpid()", "9**9**9", "10**9 * 'x'", "sys.maxsize", "(" * 500]
)
def test_an_angle_that_would_run_code_is_never_run_and_unknown(expression: str) -> None:
    loaded = load(f"a: !radians {expression}\nb: 1")
    assert isinstance(loaded.data["a"], UnknownValue)
    assert loaded.data["b"] == 1


def bomb(template: str, first: str, rounds: int) -> str:
    return f"a0: &a0 {first}\n" + "".join(template.format(at, at - 1) for at in range(1, rounds))


@pytest.mark.parametrize(
    "text",
    [
        bomb("a{0}: &a{0} [*a{1}, *a{1}, *a{1}, *a{1}]\n", "[x]", 30),
        bomb("a{0}: &a{0} {{x: *a{1}, y: *a{1}}}\n", "{x: 1}", 40),
        bomb("a{0}: &a{0} {{<<: [*a{1}, *a{1}, *a{1}]}}\n", "{x: 1}", 40),
        "a: &a [" + "1, " * 5000 + "]\nb: &b [" + "1, " * 5000 + "]\nc:\n" + "  k: *a\n  k: *b\n" * 2000,
        "s: &s " + "x" * 1_000_000 + "\n" + "".join(f"k{at}: *s\n" for at in range(10_000)),
        "a: &a [*a]",
        "&a {b: *a}",
        "&a {<<: *a}",
        "[" * 1_000_000,
        "- " * 500_000,
        "? " * 500_000,
        "".join(" " * depth + "a:\n" for depth in range(1000)),
        "x" * 9_000_000,
        "".join(f"a{at}: 1\n" for at in range(200_001)),
    ],
    ids=lambda text: text[:20],
)
def test_what_is_beyond_the_bounds_is_unknown_and_known_to_be_so_soon(text: str) -> None:
    started = time.process_time()
    with pytest.raises(YamlUnknown):
        load(text)
    assert time.process_time() - started < 10


TOKENS = st.sampled_from(
    [
        *(
            "a",
            "b",
            "key",
            "1",
            "0.5",
            "true",
            '"q"',
            "'s'",
            ": ",
            ":",
            "- ",
            "-",
            "\n",
            "\n  ",
            "\n    ",
            "[",
            "]",
            "{",
            "}",
            ", ",
            "#",
            " # c",
        ),
        *("&x ", "*x", "!", "!t ", "!!str ", "!!set ", "!!int ", "|\n", ">\n", ">#", "?", "? ", "---\n", "...\n", "%", "@", "~", "<<", "="),
        *("<<: *x\n", " ", '"', "'", "\t", "\\n", "é", "http://x", "a:b", "\r\n", "\u2028", "\x85", "\x07", "12:30", "010", "1e3"),
        *("&x {a: 1}\n", "a: ", "b: ", "2001-01-01", "on", "{a: 1}"),
    ]
)


@settings(max_examples=1500, deadline=None)
@given(st.lists(TOKENS, min_size=1, max_size=10).map("".join))
def test_random_texts_are_what_the_pure_python_parser_says(text: str) -> None:
    try:
        expected = repr(yaml.load(text, Loader=yaml.SafeLoader))
    except Exception:  # any error of PyYAML stops roslaunch
        expected = REFUSED
    try:
        found = repr(load(text, unroll=False, angles=False).data)
    except YamlError as error:
        found = REFUSED if 0 <= error.offset <= len(text) else "(an error outside the text)"
    except YamlUnknown:
        return
    assert found == expected


@pytest.mark.parametrize("text", [text for text in TEXTS if "!" not in text])
def test_both_parsers_give_the_same_tree(text: str, monkeypatch: pytest.MonkeyPatch) -> None:
    def tree() -> object:
        try:
            parsed = parse(text, Reader("rosparam"))
        except YamlError as error:
            return error.message, error.offset
        return _plain(parsed.root), parsed.scalar_colon

    fast = tree()
    monkeypatch.setattr(yaml, "__with_libyaml__", False)
    assert fast == tree()


def _plain(node: object) -> object:
    if isinstance(node, (list, tuple)):
        return [_plain(item) for item in node]
    if isinstance(node, Node):
        return node.tag, node.start, node.end, _plain(node.value)
    return node


def test_nothing_is_registered_with_pyyaml() -> None:
    load("a: deg(90)")
    assert yaml.safe_load("deg(90)") == "deg(90)"
    assert "!degrees" not in yaml.SafeLoader.yaml_constructors


REAL = """
import json, sys, yaml, rosparam
from rosgraph.names import ns_join
from xmlrpc.client import Binary
Binary.__repr__ = lambda self: repr(self.data)
def unroll(name, value):
    if type(value) is dict:
        for key, inner in value.items():
            yield from unroll(ns_join(name, key), inner)
    else:
        yield name
answers = []
for text in json.load(sys.stdin):
    try:
        data = yaml.safe_load(text)
        answers.append([repr(data), list(unroll("/", data))])
    except Exception as error:
        answers.append(["(refused)", []])
json.dump(answers, sys.stdout)
"""


@pytest.mark.ros
def test_table_is_what_rosparam_says(ros_python: str) -> None:
    """The texts are ours: the real rosparam runs code that stands in ``rad(…)``."""
    run = subprocess.run([ros_python, "-c", REAL], input=json.dumps(TEXTS), capture_output=True, text=True, timeout=60, check=True)
    expected = dict(zip(TEXTS, json.loads(run.stdout), strict=True))
    found = {text: [outcome(text), [] if outcome(text) == REFUSED else names(text)] for text in TEXTS}
    assert {text: answer for text, answer in found.items() if answer != expected[text]} == {}


def names(text: str) -> list[str]:
    entries = load(text).entries
    return ["/" + "/".join(entry.path) for entry in entries] or ([] if load(text).data is not None else ["/"])
