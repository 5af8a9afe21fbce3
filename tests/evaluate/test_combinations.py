"""Which combinations of args have to be evaluated, beside those that take every branch once."""

from __future__ import annotations

from pathlib import Path

import pytest

from launchlint.check.options import EntryRequest
from launchlint.check.survey import Surveyor
from launchlint.project.asked import EntryOptions
from tests.cli.running import write

ARGS = "".join(f'<arg name="{each}" default="false"/>' for each in "abcde")
NODE = '<node pkg="p" type="t" name="{}"/>'


def given(text: str, directory: Path, monkeypatch: pytest.MonkeyPatch) -> tuple[set[str], int, bool]:
    """All configurations, how many of them rules looked at, and whether any other one follows from them."""
    monkeypatch.chdir(directory)
    write(directory, {"a.launch": f"<launch>{ARGS}{text}</launch>"})
    found = Surveyor(EntryOptions(("a.launch",)).options()).survey(EntryRequest("a.launch", "a.launch", ()))
    return {" ".join(name for name, _ in each) for each in found.given}, found.checked, found.whole


def inside(names: str, node: str) -> str:
    return "".join(f'<group if="$(arg {each})">' for each in names) + NODE.format(node) + "</group>" * len(names)


def test_args_that_act_on_different_things_are_changed_alone(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    assert given(inside("a", "x") + inside("b", "y"), tmp_path, monkeypatch) == ({"", "a", "b"}, 3, True)


def test_args_that_act_on_one_thing_are_all_combined(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    found, checked, whole = given(inside("a", "x") + inside("ab", "y") + inside("c", "z"), tmp_path, monkeypatch)
    assert found == {"", "a", "b", "a b", "c"}
    assert checked < len(found)
    assert whole


def test_too_many_combinations_are_told(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("launchlint.evaluate.combinations.MOST_OF_GROUP", 4)
    text = "".join(inside("abcde"[:length], f"n{length}") for length in range(1, 6))
    found, _, whole = given(text, tmp_path, monkeypatch)
    assert not whole
    assert len(found) < 32
