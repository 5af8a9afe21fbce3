"""A library is untrusted input: whatever it holds, the answer is a message, in little time."""

from __future__ import annotations

import json
import random

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from launchlint.library.file import examine
from launchlint.library.inspection import inspect
from launchlint.library.write import canonical
from launchlint.report.library import faults as faults_text
from tests.library.samples import library, one, publishers
from tests.library.test_schema import EVERYTHING, mutated
from tests.library.test_validate import TOP

KEYS = st.sampled_from(("packages", "version", "name", "variants")) | st.text()
PLAIN = st.recursive(
    st.none() | st.booleans() | st.integers() | st.floats() | st.text(max_size=20),
    lambda inner: st.lists(inner, max_size=4) | st.dictionaries(KEYS, inner, max_size=4),
    max_leaves=20,
)


@settings(max_examples=200, deadline=None)
@given(PLAIN)
def test_any_json(document: object) -> None:
    _, lines = inspect(json.dumps(document).encode(), "lib.json")
    assert lines
    assert all(line.startswith("lib.json:") for line in lines)


@settings(max_examples=200, deadline=None)
@given(st.binary(max_size=200))
def test_any_bytes(data: bytes) -> None:
    assert inspect(data, "lib.json")[1]
    assert inspect(TOP.encode() + data, "lib.json")[1]


def test_mutations_never_crash() -> None:
    random_ = random.Random(4)
    for _ in range(300):
        document = EVERYTHING
        for _ in range(random_.randrange(1, 6)):
            document = mutated(document, random_)
        document, lines = inspect(json.dumps(document).encode(), "lib.json")
        if not lines:
            canonical(document)


def test_cut_off_anywhere() -> None:
    data = json.dumps(EVERYTHING).encode()
    for end in range(0, len(data), 7):
        _, lines = examine(data[:end], "lib.json")
        assert len(lines) == 1
        assert "the library is not JSON" in lines[0]


@pytest.mark.parametrize("depth", [100, 400, 900, 980, 1_500, 5_000, 50_000])
@pytest.mark.parametrize("opening", ["[", '{"a":'])
def test_nesting(opening: str, depth: int) -> None:
    """At any depth, also where the reader just manages it and whoever looks for the place does not."""
    nested = opening * depth + ("]" * depth if opening == "[" else "1" + "}" * depth)
    text = f'{TOP}{{"demo": {{"launch": [{nested}], "x": 1}}}}}}'
    lines = inspect(text.encode(), "lib.json")[1]
    assert lines
    assert all("nested" in line or 'no key "x"' in line for line in lines)


def test_ten_megabytes_of_nonsense() -> None:
    document = publishers(*[{"name": f"a {number}", "evidence": []} for number in range(280_000)])
    data = json.dumps(document).encode()
    assert len(data) > 10_000_000
    _, lines = inspect(data, "lib.json")
    assert len(lines) == 100


def test_many_entries_of_one_name() -> None:
    document = publishers(*[{"name": "x", "condition": {"arg": number % 9_000 + 1}} for number in range(20_000)])
    _, lines = inspect(json.dumps(document).encode(), "lib.json")
    assert len(lines) == 100


def test_long_keys_and_values_are_cut() -> None:
    document = one({"k" * 5_000: 1, "class": "v" * 900})
    lines = inspect(json.dumps(document).encode(), "lib.json")[1]
    assert len(lines) == 2
    assert max(map(len, lines)) < 300


def test_nothing_reaches_the_terminal() -> None:
    document = one({"class": "\x1b[2J\u202e", "\x1b]0;x\x07": 1})
    lines = inspect(json.dumps(document).encode(), "::error::\x1b\nlib.json")[1]
    text = faults_text(lines)
    assert text.replace("\n", "").isprintable()
    assert all(line.startswith("./::error::") for line in text.splitlines())


def test_canonical_text_hides_nothing() -> None:
    document = library(**{"a\u202eb": {"source": "x\x1b\x9b\u2028\U000e0001y\x7f"}})
    text = canonical(document)
    assert text.replace("\n", "").isprintable()
    assert json.loads(text) == document
