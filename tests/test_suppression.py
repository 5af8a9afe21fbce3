"""Suppression comments: what they cover, how they go wrong, what they have suppressed."""

from __future__ import annotations

import random

import pytest
from hypothesis import given
from hypothesis import strategies as some

from launchlint.finding import Finding, Location, Severity
from launchlint.source import Place, Span
from launchlint.suppression import Suppression, applies, apply, read, unused
from launchlint.syntax.parse import parse
from launchlint.syntax.remarks import remarks
from launchlint.syntax.tree import Document

RULES = {
    "ll301": "LL301",
    "duplicate-node-name": "LL301",
    "ll302": "LL302",
    "invalid-node-name": "LL302",
    "ll206": "LL206",
    "old-name": "LL206",
}


def document(text: str) -> Document:
    return parse(text.encode("utf-8", "surrogatepass"), "a.launch")


def suppressions(text: str) -> list[Suppression]:
    parsed = document(text)
    return read(parsed.source, remarks(parsed))


def covered(text: str) -> list[str | None]:
    """What each suppression of the file covers, as text: ``None`` for the whole file."""
    return [None if one.covers is None else text[one.covers.start : one.covers.end] for one in suppressions(text)]


def finding(text: str, what: str, rule: str = "LL301", path: str = "a.launch") -> Finding:
    """A finding of ``rule`` at the first ``what`` in ``text``."""
    start = text.index(what)
    place = Place(document(text).source, Span(start, start + len(what)))
    return Finding(rule, "name", Severity.ERROR, Location.of(place)._replace(path=path), f"{rule} at {what}")


FILE = """\
<launch>
  <!-- launchlint: ignore[LL301, invalid-node-name] two on purpose -->
  <node name="a">
    <param name="p"/>
  </node>
  <node name="b"/>
</launch>
"""


def test_parts_of_a_suppression() -> None:
    (one,) = suppressions(FILE)
    assert one.rules == {"ll301", "invalid-node-name"}
    assert [(name.text, FILE[name.span.start : name.span.end]) for name in one.names] == [
        ("LL301", "LL301"),
        ("invalid-node-name", "invalid-node-name"),
    ]
    assert (one.location.path, one.location.line, one.location.column, one.location.end_line, one.location.end_column) == (
        "a.launch",
        2,
        3,
        2,
        71,
    )
    assert one.reason == "two on purpose"
    assert one.problem == ""
    assert one.covers is not None
    assert FILE[one.covers.start : one.covers.end] == '<node name="a">\n    <param name="p"/>\n  </node>'
    assert FILE[: one.removal.start] + one.removal.text + FILE[one.removal.end :] == FILE.replace(FILE.splitlines(True)[1], "")


@pytest.mark.parametrize(
    ("what", "rule", "path", "expected"),
    [
        ('<node name="a"', "LL301", "a.launch", True),
        ('name="a"', "LL302", "a.launch", True),
        ('<param name="p"/>', "LL301", "a.launch", True),
        ('name="a"', "LL206", "a.launch", False),
        ('<node name="b"/>', "LL301", "a.launch", False),
        ("<launch>", "LL301", "a.launch", False),
        ('name="a"', "LL301", "b.launch", False),
    ],
)
def test_applies(what: str, rule: str, path: str, expected: bool) -> None:
    (one,) = suppressions(FILE)
    assert applies(one, finding(FILE, what, rule, path), RULES.get) is expected
    kept, _ = apply([finding(FILE, what, rule, path)], [one], RULES.get)
    assert kept == ([] if expected else [finding(FILE, what, rule, path)])


def test_a_rule_is_known_by_its_text_whoever_wrote_it() -> None:
    (one,) = suppressions(FILE)
    kept = finding(FILE, 'name="a"', b"LL301".decode(), b"a.launch".decode())  # as it comes out of the cache, or of another process
    assert applies(one, kept, RULES.get)
    assert apply([kept], [one], RULES.get)[0] == []


@pytest.mark.parametrize(
    "comment", ["ignore", "ignore[duplicate-node-name]", "Ignore[ll301]", "ignore [LL301]", "ignore[LL301 LL999]", "ignore\n  [LL301]"]
)
def test_spellings_that_cover_the_element(comment: str) -> None:
    text = f"<launch><!--launchlint:{comment}--><node/></launch>"
    assert applies(suppressions(text)[0], finding(text, "<node/>"), RULES.get)


def test_a_rule_that_was_renamed_and_one_that_does_not_exist() -> None:
    text = "<launch><!-- launchlint: ignore[old-name, nonsense] --><arg/></launch>"
    found = suppressions(text)
    kept, used = apply([finding(text, "<arg/>", "LL206"), finding(text, "<arg/>", "LL301")], found, RULES.get)
    assert kept == [finding(text, "<arg/>", "LL301")]
    assert used == {(found[0], "old-name")}


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("<launch><!-- launchlint: ignore --><!-- other -->\n<node/></launch>", ["<node/>"]),
        ("<launch><!-- launchlint: ignore[LL301] --><!-- launchlint: ignore[LL302] -->\n<?pi x?><node/></launch>", ["<node/>", "<node/>"]),
        ("<!-- launchlint: ignore -->\n<launch><node/></launch>", ["<launch><node/></launch>"]),
        ("<launch>\n<!-- launchlint: ignore-file[LL301] -->\n<node/></launch>", [None]),
        ("<!-- launchlint: ignore-file -->\n<launch>\n<node/></launch>", [None]),
        ("<launch><!-- launchlint: ignore-file --></launch>", [None]),
        ("<launch><group><!-- launchlint: ignore --><node/><node/></group><node/></launch>", ["<node/>"]),
    ],
)
def test_where_it_stands(text: str, expected: list[str | None]) -> None:
    assert covered(text) == expected
    assert [one.problem for one in suppressions(text)] == [""] * len(expected)


UNREADABLE = "the list of rules cannot be read: write ignore[LL301] or ignore[LL301, LL302]"
THERE_ARE = "only ignore, ignore-file, format off and format on"
NO_ELEMENT = "no element follows it: it belongs right before the element it is about"


@pytest.mark.parametrize(
    ("text", "problem"),
    [
        ("<launch><!-- launchlint: ignroe[LL301] --><node/></launch>", f"there is no 'ignroe', {THERE_ARE}"),
        ("<launch><!-- launchlint: disable --><node/></launch>", f"there is no 'disable', {THERE_ARE}"),
        ("<launch><!-- launchlint: ignore[LL301 --><node/></launch>", UNREADABLE),
        ("<launch><!-- launchlint: ignore[[LL301]] --><node/></launch>", UNREADABLE),
        (
            "<launch><!-- launchlint: ignore[ , ] --><node/></launch>",
            "the list of rules is empty: name one, or leave the brackets out to ignore every rule",
        ),
        ("<launch><!-- launchlint: ignore LL301 why --><node/></launch>", "rules stand in brackets: write ignore[LL301]"),
        ("<launch><!-- launchlint: ignore: LL301 --><node/></launch>", "rules stand in brackets: write ignore[LL301]"),
        ("<launch><!-- launchlint: --><node/></launch>", "it does not say what to do: write launchlint: ignore[RULE] reason"),
        ("<launch><!-- launchlint ignore[LL301] --><node/></launch>", "a colon is missing: write launchlint: ignore[RULE] reason"),
        (
            "<launch><node/><!-- launchlint: ignore-file --><node/></launch>",
            "it stands below the first element: ignore-file belongs at the top of the file",
        ),
        ("<launch><node/><!-- launchlint: ignore --></launch>", NO_ELEMENT),
        ("<launch><group><!-- launchlint: ignore --></group><node/></launch>", NO_ELEMENT),
        ("<launch><!-- launchlint: ignore --> text <node/></launch>", NO_ELEMENT),
        ("<launch/><!-- launchlint: ignore -->", NO_ELEMENT),
    ],
)
def test_malformed_ones_suppress_nothing(text: str, problem: str) -> None:
    (one,) = suppressions(text)
    assert one.problem == problem
    found = finding(text, "<node/>" if "<node/>" in text else "<launch/>")
    assert apply([found], [one], RULES.get) == ([found], set())
    assert unused([one], set()) == []


@pytest.mark.parametrize(
    "comment",
    ["launch lint is nice", "see launchlint", "launchlint ignores this", "noqa", "", "launchlint", "launchlint: format off: a table"],
)
def test_other_comments_are_none(comment: str) -> None:
    assert suppressions(f"<launch><!-- {comment} --><node/></launch>") == []


def test_windows_line_ends_and_entities() -> None:
    text = "<launch>\r\n<!-- launchlint:\r\nignore[\r\nLL301,\r\nLL302] -->\r\n<node/></launch>"
    (one,) = suppressions(text)
    assert [text[name.span.start : name.span.end] for name in one.names] == ["LL301", "LL302"]
    text = '<!DOCTYPE launch [<!ENTITY e "<!-- launchlint: ignore[LL301] -->">]><launch>&e;<node/></launch>'
    assert [one.rules for one in suppressions(text)] in ([{"ll301"}], [])


def test_used_and_unused() -> None:
    text = """<launch>
  <!-- launchlint: ignore-file[LL206] -->
  <!-- launchlint: ignore[LL301,LL302] -->
  <node/>
  <!-- launchlint: ignore -->
  <arg/>
</launch>"""
    found = suppressions(text)
    findings = [finding(text, "<node/>", "LL301"), finding(text, "<node/>", "LL206"), finding(text, "<launch>", "LL301")]
    kept, used = apply(findings, found, RULES.get)
    assert kept == findings[2:]
    assert used == {(found[1], "LL301"), (found[0], "LL206")}
    assert unused(found, used) == [(found[1], found[1].names[1:]), (found[2], ())]
    random.Random(1).shuffle(findings)
    assert apply(findings, found, RULES.get)[1] == used


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("<launch><!-- launchlint: ignore --><node/></launch>", "<launch><node/></launch>"),
        ("<launch>\r\n\t<!-- launchlint: ignore -->  \r\n<node/></launch>", "<launch>\r\n<node/></launch>"),
        ("<launch>\n<!-- launchlint:\n ignore --> <node/></launch>", "<launch>\n <node/></launch>"),
        ("<launch>\n<!-- launchlint:\n ignore\n-->\n<node/></launch>", "<launch>\n<node/></launch>"),
        ("<launch/>\n<!-- launchlint: ignore -->", "<launch/>\n"),
    ],
)
def test_removal(text: str, expected: str) -> None:
    (one,) = suppressions(text)
    assert text[: one.removal.start] + text[one.removal.end :] == expected


def test_a_file_that_is_not_well_formed_still_has_its_suppressions() -> None:
    (one,) = suppressions("<launch><!-- launchlint: ignore-file --><node></launch>")
    assert (one.problem, one.covers) == ("", None)


def test_many_comments_in_a_row_cost_linear_time() -> None:
    text = "<launch>" + "<!-- launchlint: ignore -->" * 20_000 + "<node/></launch>"
    found = suppressions(text)
    assert {one.covers for one in found} == {Span(text.index("<node/>"), text.index("<node/>") + 7)}
    assert len(found) == 20_000


@given(some.text(alphabet="launchit: ignore-f[]LL301,\n<é", max_size=60))
def test_any_comment(words: str) -> None:
    """Never an exception; names stand where they are said to stand."""
    text = f"<launch>\n  <!-- launchlint: {words.replace('--', '')}. -->\n  <node/></launch>"
    for one in suppressions(text):
        assert [text[name.span.start : name.span.end] for name in one.names] == [name.text for name in one.names]
        assert (one.covers is None) or text[one.covers.start : one.covers.end] == "<node/>"


def nested(random_: random.Random, start: int, end: int, depth: int = 0) -> list[Span]:
    """Spans inside each other or apart, as those of elements are; some begin, and some end, where another one does."""
    spans: list[Span] = []
    while start < end and len(spans) < 40:
        first = random_.randint(start, min(end - 1, start + 3))
        last = random_.randint(first + 1, end)
        spans.append(Span(first, last))
        if depth < 5:
            spans += nested(random_, first + random_.randint(0, 1), last - random_.randint(0, 1), depth + 1)
        start = last + random_.randint(0, 2)
    return spans


@pytest.mark.parametrize("seed", range(15))
def test_what_is_suppressed_is_what_stands_in_a_span(seed: int) -> None:
    """Of many, in two files, in any order: the same as if each was held against each finding."""
    random_ = random.Random(seed)
    names = ["", "[LL301]", "[invalid-node-name, LL206]", "[old-name]"]
    text = "<launch>" + "".join(f"<!-- launchlint: ignore{each} -->" for each in names) + "<node/></launch>"
    models = suppressions(text)
    assert [len(each.names) for each in models] == [0, 1, 2, 1]
    there = [
        model._replace(covers=span, location=model.location._replace(path=path))
        for path in ("a.launch", "b.launch")
        for span in (*nested(random_, 0, 60), *([None] if seed % 5 == 0 else []))
        for model in random_.sample(models, random_.randint(1, 2))
    ]
    random_.shuffle(there)
    findings = [
        finding(text, "<node/>", rule, path)._replace(location=models[0].location._replace(path=path, start=start, end=start + 1))
        for path in ("a.launch", "b.launch", "c.launch")
        for start in range(62)
        for rule in ("LL206", "LL301", "LL302", "LL999")
    ]
    covering = {
        (one.rule, one.location.path, one.location.start): [
            (each, name)
            for each in there
            if each.location.path == one.location.path
            and (each.covers is None or each.covers.start <= one.location.start < each.covers.end)
            for name in ([name.text for name in each.names if RULES[name.text.lower()] == one.rule] if each.names else [""])
        ]
        for one in findings
    }
    kept, used = apply(findings, there, lambda name: RULES.get(name))
    assert [one for one in findings if not covering[one.rule, one.location.path, one.location.start]] == kept
    assert used == {hit for hits in covering.values() for hit in hits}
    assert [one for one in findings if not any(applies(each, one, RULES.get) for each in there)] == kept


def test_as_many_rules_as_there_may_be() -> None:
    one, more = (
        suppressions(f"<launch><!-- launchlint: ignore[{', '.join(['LL301'] * count)}] --><node/></launch>") for count in (1000, 1001)
    )
    assert (one[0].problem, len(one[0].names)) == ("", 1000)
    assert ("names 1,001 rules" in more[0].problem, more[0].names) == (True, ())
