"""Some damaged inputs for each reader; any number of them: :mod:`tests.fuzz.readers`."""

from __future__ import annotations

from pathlib import Path
from random import Random

import pytest

from tests.fuzz import readers
from tests.fuzz.mutation import HOW, mutated
from tests.fuzz.readers import READERS, Reader, originals, part


@pytest.mark.parametrize("name", READERS)
def test_damaged_inputs(name: str) -> None:
    done = part((name, 7_000_000, 80))
    assert done.wrong == ()
    assert done.refused < done.done


@pytest.mark.parametrize("name", READERS)
def test_what_they_are_made_from_can_be_read(name: str, tmp_path: Path) -> None:
    refused = 0
    for data in originals(READERS[name]):
        path = tmp_path / READERS[name].name
        path.write_bytes(data)
        try:
            READERS[name].read(data, path)
        except readers.REFUSALS:
            refused += 1
    assert refused <= len(originals(READERS[name])) // 2


def test_what_goes_wrong_is_told(monkeypatch: pytest.MonkeyPatch) -> None:
    def odd(data: bytes, path: Path) -> None:
        assert path.read_bytes() == data
        if data[:1] == b"b":
            raise KeyError("it begins so")

    monkeypatch.setitem(READERS, "odd", Reader(odd, texts=("a word", "b word")))
    done = part(("odd", 0, 200))
    assert 20 < len(done.wrong) < 180
    assert "KeyError: 'it begins so'" in done.wrong[0]
    monkeypatch.setattr(readers, "SECONDS", -1.0)
    assert len(part(("odd", 0, 10)).wrong) >= 10
    monkeypatch.setattr(readers, "MOST_KILOBYTES", 1)
    assert part(("odd", 0, 10)).wrong[-1].endswith(" KiB")


def test_an_input_is_told_by_its_number() -> None:
    made_from = originals(READERS["ros1"])
    inputs = [mutated(Random(f"ros1 {number}"), made_from) for number in range(200)]
    assert inputs == [mutated(Random(f"ros1 {number}"), made_from) for number in range(200)]
    assert len(set(inputs)) > 190
    assert all(how(Random(1), b"", b"") is not None for how in set(HOW))
