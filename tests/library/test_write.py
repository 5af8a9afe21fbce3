"""Canonical text: the same for the same library, and the same library again when it is read."""

from __future__ import annotations

import json
import random
from typing import Any

import pytest

from launchlint.library.write import canonical
from tests.library.samples import evidence, library
from tests.library.test_schema import BUNDLED, EVERYTHING

TEXT = """\
{
 "format": "launchlint-library",
 "version": 1,
 "sources": [
  {"id": "owner/name@0", "url": "https://example.org"}
 ],
 "packages": {
  "a": {},
  "b": {
   "complete": ["nodelets"],
   "executables": {
    "node": {
     "class": "roscpp",
     "options": {"-a": 0, "-b": 1},
     "variants": {
      "default": {
       "publishers": [
        {"name": "a", "type": "a/B", "latched": true, "condition": {"param": "~x", "is": 1, "default": {"a": 1, "b": 2}}},
        {"name": "b", "evidence": [{"by": "static", "at": "z"}, {"by": "manual", "at": "y"}]}
       ],
       "services": [],
       "open": {"publishers": "x", "params": "y"}
      }
     }
    }
   },
   "nodelets": {
    "b/Nodelet": {
     "like": "b/Other"
    }
   }
  }
 }
}
"""
DOCUMENT: Any = {
    "version": 1,
    "packages": {
        "b": {
            "nodelets": {"b/Nodelet": {"like": "b/Other"}},
            "executables": {
                "node": {
                    "options": {"-b": 1, "-a": 0},
                    "variants": {
                        "default": {
                            "open": {"params": "y", "publishers": "x"},
                            "services": [],
                            "publishers": [
                                {"evidence": [*evidence("static", "z"), *evidence("manual", "y")], "name": "b"},
                                {
                                    "condition": {"default": {"b": 2, "a": 1}, "is": 1, "param": "~x"},
                                    "latched": True,
                                    "type": "a/B",
                                    "name": "a",
                                },
                            ],
                        }
                    },
                    "class": "roscpp",
                }
            },
            "complete": ["nodelets"],
        },
        "a": {},
    },
    "sources": [{"url": "https://example.org", "id": "owner/name@0"}],
    "format": "launchlint-library",
}


def test_canonical() -> None:
    assert canonical(DOCUMENT) == TEXT


def shuffled(value: Any, random_: random.Random) -> Any:
    """The same JSON with the keys of each mapping in another order."""
    if isinstance(value, dict):
        items = list(value.items())
        random_.shuffle(items)
        return {key: shuffled(inner, random_) for key, inner in items}
    return [shuffled(inner, random_) for inner in value] if isinstance(value, list) else value


@pytest.mark.parametrize("document", [DOCUMENT, EVERYTHING, library()], ids=["document", "everything", "empty"])
def test_round_trip(document: Any) -> None:
    text = canonical(document)
    assert canonical(json.loads(text)) == text
    for seed in range(20):
        assert canonical(shuffled(document, random.Random(seed))) == text


@pytest.mark.parametrize("path", BUNDLED, ids=lambda path: path.stem)
def test_round_trip_of_a_bundled_file(path: Any) -> None:
    text = canonical(json.loads(path.read_bytes()))
    assert canonical(json.loads(text)) == text


def test_nothing_is_lost() -> None:
    assert json.loads(canonical(EVERYTHING)) == EVERYTHING
