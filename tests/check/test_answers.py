"""What packages answered comes back from a cache as it was, or not at all."""

from __future__ import annotations

import json
from collections import OrderedDict

import pytest

from launchlint.check.answers import KeptAnswer, answers_from_json, answers_to_json
from launchlint.workspace.looking import Answer, Looked

FOUND = (None, "", "/a", True, 7, (), ("a", ("b", 1)), ["list", ["a"]], {"b": ("x",), "a": [None]}, {"z", "a"}, frozenset(("frozenset",)))
OTHERS = (Looked(frozenset()), 1.5, OrderedDict(), b"", ("a", object()), {1, 2})


def _called(found: object) -> str:
    return type(found).__name__  # the same in every process of the tests


@pytest.mark.parametrize("found", FOUND, ids=_called)
def test_what_was_found(found: object) -> None:
    kept = {"?a": KeptAnswer("s", ["n", "m"], ()).with_found(found), "?b": KeptAnswer("t", ["m"], ())}
    read = answers_from_json(json.loads(json.dumps(answers_to_json(kept))))
    assert {question: (each.state, each.names, each.has_found) for question, each in read.items()} == {
        "?a": ("s", ["n", "m"], True),
        "?b": ("t", ["m"], False),
    }
    again = read["?a"].found
    assert (again, type(again)) == (found, type(found))
    assert repr(again) == repr(found) or isinstance(found, (set, frozenset))
    nowhere = Looked(frozenset())
    assert Answer("?a", again, lambda: nowhere).state == Answer("?a", found, lambda: nowhere).state


@pytest.mark.parametrize("found", OTHERS, ids=_called)
def test_what_would_come_back_as_something_else(found: object) -> None:
    assert not KeptAnswer("s", [], ()).with_found(found).has_found
