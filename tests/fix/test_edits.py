"""Edits: what they make of the bytes, which of them go together, and where places are afterwards."""

from __future__ import annotations

from random import Random

import pytest

from launchlint.finding import Edit
from launchlint.fix.edits import CannotEdit, Claims, Shift, apply
from launchlint.fix.manifest import refusal

EURO = "\N{EURO SIGN}"


def edit(start: int, end: int, text: str) -> Edit:
    return Edit("a.launch", start, end, text)


@pytest.mark.parametrize(
    ("before", "edits", "after"),
    [
        (b"<a b='1'/>", [edit(6, 7, "2")], b"<a b='2'/>"),
        (b"<a b='1'/>", [edit(10, 10, "\n"), edit(3, 4, "c"), edit(1, 2, "d")], b"<d c='1'/>\n"),
        (b"<a/>", [edit(4, 4, "1"), edit(4, 4, "2")], b"<a/>12"),
        (b"\xef\xbb\xbf<a b='\xe2\x82\xac'/>\r\n", [edit(6, 7, EURO + EURO)], b"\xef\xbb\xbf<a b='\xe2\x82\xac\xe2\x82\xac'/>\r\n"),
        (
            b"<?xml version='1.0' encoding='iso-8859-15'?><a b='\xa4'/>",
            [edit(51, 51, EURO)],
            b"<?xml version='1.0' encoding='iso-8859-15'?><a b='\xa4\xa4'/>",
        ),
        ("<a/>".encode("utf-16"), [edit(1, 2, EURO)], f"<{EURO}/>".encode("utf-16")),
        (b"<a/>", [], b"<a/>"),
    ],
)
def test_apply(before: bytes, edits: list[Edit], after: bytes) -> None:
    assert apply(before, edits) == after


@pytest.mark.parametrize(
    ("before", "edits", "reason"),
    [
        (b"<a>\xff</a>", [edit(1, 2, "b")], "not all of its bytes are utf-8"),
        (b"<a>\x80</a>", [edit(1, 2, "b")], "not all of its bytes are utf-8"),
        (b"<?xml version='1.0' encoding='us-ascii'?><a/>", [edit(42, 43, "\xe4")], "its encoding, ascii, cannot hold '\xe4'"),
        (b"<a/>", [edit(3, 9, "")], "it has been changed since it was checked"),
        (b"<a/>", [edit(0, 2, ""), edit(1, 3, "")], "it has been changed since it was checked"),
    ],
)
def test_what_cannot_be_done(before: bytes, edits: list[Edit], reason: str) -> None:
    with pytest.raises(CannotEdit) as caught:
        apply(before, edits)
    assert str(caught.value) == reason


@pytest.mark.parametrize(
    ("one", "other", "together"),
    [
        ((1, 3), (3, 5), True),
        ((1, 3), (2, 5), False),
        ((1, 5), (2, 3), False),
        ((2, 2), (2, 2), True),
        ((2, 2), (2, 5), False),
        ((5, 5), (2, 5), False),
        ((3, 3), (2, 5), False),
        ((6, 6), (2, 5), True),
    ],
)
def test_edits_that_go_together(one: tuple[int, int], other: tuple[int, int], together: bool) -> None:
    far = [(start + 10_000, end + 10_000) for start, end in (one, other)]
    for first, second in ((one, other), (other, one), far, far[::-1]):
        claims = Claims()
        assert claims.take([edit(*first, "x")])
        assert claims.take([edit(*second, "x")]) is together
        assert claims.take([Edit("other.launch", *second, "x")])


def test_what_is_refused_claims_nothing() -> None:
    claims = Claims()
    assert claims.take([edit(0, 4, "")])
    assert not claims.take([edit(8, 9, ""), edit(3, 5, "")])
    assert claims.take([edit(8, 9, "")])


def test_shift() -> None:
    """``abcdefgh`` becomes ``aXYefZgh``: ``bcd`` is replaced, ``Z`` inserted before ``g``."""
    shift = Shift([edit(6, 6, "Z"), edit(1, 4, "XY")])
    assert [shift(offset) for offset in range(9)] == [0, 1, 1, 1, 3, 4, 6, 7, 8]


MANIFEST = b"<package format='2'><name>a</name><depend>b</depend></package>"


@pytest.mark.parametrize(
    ("after", "reason"),
    [
        (MANIFEST.replace(b"</package>", b"<exec_depend>c</exec_depend></package>"), ""),
        (MANIFEST, "no dependency would be added"),
        (MANIFEST.replace(b"<depend>b</depend>", b"<exec_depend>c</exec_depend>"), "a dependency would be lost"),
        (MANIFEST.replace(b"'2'", b"'3'").replace(b"</package>", b"<exec_depend>c</exec_depend></package>"), "its format would change"),
        (MANIFEST.replace(b"</package>", b"<exec_depend>c</package>"), "not well-formed XML: mismatched tag, line 1, column 68"),
    ],
)
def test_manifest(after: bytes, reason: str) -> None:
    assert refusal("/a/package.xml", MANIFEST, after) == reason


def _free(edit: Edit, taken: list[Edit]) -> bool:
    """As the documentation of :meth:`Claims.take` has it, held against every stretch that is taken."""
    for other in taken:
        if edit.path != other.path or (edit.start == edit.end and other.start == other.end):
            continue
        if edit.start == edit.end or other.start == other.end:
            if other.start <= edit.end and edit.start <= other.end:
                return False
        elif edit.start < other.end and other.start < edit.end:
            return False
    return True


@pytest.mark.parametrize("seed", range(60))
def test_what_is_claimed_meets_nothing_that_is(seed: int) -> None:
    random = Random(seed)
    claims, taken = Claims(), list[Edit]()
    for _ in range(40):
        edits = [
            Edit(random.choice(("a", "a", "b")), start, start + random.choice((0, 0, 1, 2, 5)), "x")
            for start in random.sample(range(60), random.choice((1, 1, 2)))
        ]
        if not all(_free(one, [other]) for one in edits for other in edits if one is not other):
            continue
        free = all(_free(edit, taken) for edit in edits)
        assert claims.take(edits) is free
        taken += edits if free else []
    assert len(taken) > 10


@pytest.mark.parametrize("seed", range(60))
def test_where_places_are_after_edits(seed: int) -> None:
    """What is left of the text stands where :class:`Shift` says; what is replaced is where its replacement begins."""
    random = Random(seed)
    text = "".join(chr(0x4E00 + number) for number in range(80))  # each character stands there once
    borders = sorted(random.sample(range(81), 10))
    edits = [Edit("a", start, end, "x" * random.choice((0, 1, 7))) for start, end in zip(borders[::2], borders[1::2], strict=True)]
    after = apply(text.encode("utf-8"), edits).decode("utf-8")
    shift = Shift(edits)
    for offset, letter in enumerate(text):
        edit = next((edit for edit in edits if edit.start <= offset < edit.end), None)
        if edit is None:
            assert after[shift(offset)] == letter
        else:
            assert shift(offset) == shift(edit.start)
            assert after[shift(offset) : shift(offset) + len(edit.text)] == edit.text
