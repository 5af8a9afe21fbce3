"""The JSON Schema and the validator come from the same tables, and agree on every shape."""

from __future__ import annotations

import copy
import json
import random
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
from jsonschema import Draft202012Validator

from launchlint.library.schema import json_schema
from launchlint.library.shipped import DIRECTORY, INDEX
from launchlint.library.validate import faults
from tests.library.samples import evidence, library
from tests.library.test_validate import GRAMMAR, SHAPES, told

SCHEMA = Draft202012Validator(json_schema())
BUNDLED = [path for path in sorted(Path(DIRECTORY).glob("*.json")) if path.name != INDEX]

EVERYTHING = library(
    demo={
        "version": "1.0.0",
        "source": "owner/name",
        "complete": ["nodelets"],
        "build": {"result": "partial", "errors": ["x"]},
        "launch": [{"file": "a.launch"}],
        "nodelets": {"demo/Filter": {"like": "demo/Other", "removed": {"in": "noetic", "instead": "demo/Other"}}},
        "executables": {
            "node": {
                "class": "rospy",
                "status": "ok",
                "hash": "0",
                "options": {"-r": 1},
                "problems": [{"code": "display", "detail": "x"}],
                "variants": {
                    "default": {
                        "args": "-r 5",
                        "env": {"A": "b"},
                        "remap": {"in": "out"},
                        "run": {"seconds": 1.5},
                        "open": {"clients": "why"},
                        "publishers": [
                            {"name": "{arg:1|x}", "type": "a/B", "md5": "0" * 32, "latched": True, "queue": 1, "transport": "image"},
                            {"name": "{each}", "each": {"args": 2}, "when": "message", "evidence": evidence("static")},
                        ],
                        "subscribers": [{"name": "{each:t}", "each": {"param": "~x", "default": ["a"]}}],
                        "services": [{"name": "~reset", "type": "std_srvs/Empty", "condition": {"param": "~a", "is": 1, "default": 2}}],
                        "clients": [{"name": "{each}", "each": {"words": "~x"}, "condition": {"text": "if (x)"}}],
                        "actions": [{"name": "go", "role": "client", "condition": {"remap": "in"}}],
                        "params": [
                            {"name": "~rate", "type": "int", "default": [1], "min": 0, "max": {"a": None}, "removed": {"in": "kinetic"}}
                        ],
                    },
                    "other": {
                        "match": {"all": [{"not": {"arg": -1, "in": ["x"]}}, {"any": [{"option": "-r"}, {"param": "~x", "set": True}]}]}
                    },
                },
            }
        },
    }
)
EVERYTHING.update(
    generator="launchlint",
    environment={"base": "debian", "image": "i", "distro": "noetic", "network": "none"},
    sources=[{"id": "a", "url": "b", "ref": "c", "commit": "d", "dirty": False}],
    messages={"std_msgs/String": {"md5": "*", "text": "string data"}},
)


def test_the_schema_is_one() -> None:
    Draft202012Validator.check_schema(json_schema())


def test_everything_that_can_be_said_passes_both() -> None:
    assert faults(EVERYTHING) == []
    assert [error.message for error in SCHEMA.iter_errors(EVERYTHING)] == []


@pytest.mark.parametrize("path", BUNDLED, ids=lambda path: path.stem)
def test_a_bundled_file_passes_both(path: Path) -> None:
    document = json.loads(path.read_bytes())
    assert faults(document) == []
    assert SCHEMA.is_valid(document)


@pytest.mark.parametrize(("marked", "message"), SHAPES)
def test_the_schema_refuses_wrong_shapes(marked: str, message: str) -> None:
    assert not SCHEMA.is_valid(json.loads(told(marked)[1]))


@pytest.mark.parametrize(("marked", "message"), GRAMMAR)
def test_the_schema_knows_no_grammar(marked: str, message: str) -> None:
    assert SCHEMA.is_valid(json.loads(told(marked)[1]))


def spots(value: Any, path: tuple[Any, ...] = ()) -> Iterator[tuple[Any, ...]]:
    """The path to everything in a document."""
    yield path
    for key, inner in value.items() if isinstance(value, dict) else enumerate(value) if isinstance(value, list) else ():
        yield from spots(inner, (*path, key))


def mutated(document: Any, random_: random.Random) -> Any:
    """The document with one thing replaced, removed, added or under another key."""
    document = copy.deepcopy(document)
    *way, last = random_.choice([path for path in spots(document) if path])
    place = document
    for step in way:
        place = place[step]
    how = random_.randrange(4)
    if how == 0:
        del place[last]
    elif how == 1 and isinstance(place, dict):
        place[random_.choice(("name", "x", "", "default", "args", "type"))] = place.pop(last)
    elif how == 2 and isinstance(place[last], (dict, list)):
        inner = place[last]
        inner.append(7) if isinstance(inner, list) else inner.setdefault(random_.choice(("name", "x", "in", "set")), 7)
    else:
        place[last] = random_.choice((None, True, 0, -1, 2.5, "x", "", [], ["x"], {}, {"arg": 1}, {"x": {}}, 10**30, "x" * 1001))
    return document


def test_schema_and_validator_agree_on_mutations() -> None:
    """Where they disagree it is for a grammar that only the validator knows, and its message says so."""
    random_ = random.Random(20)
    outcomes = {(True, True): 0, (False, False): 0, (True, False): 0}
    for _ in range(1_500):
        document = mutated(EVERYTHING, random_)
        said = [fault.message for fault in faults(document)]
        outcome = (SCHEMA.is_valid(document), not said)
        assert outcome != (False, True), document
        if outcome == (True, False):
            assert all("is no ROS name" in each or "is no type" in each or "is no MD5" in each for each in said), (said, document)
        outcomes[outcome] += 1
    assert min(outcomes.values()) > 0, f"the mutations are one-sided: {outcomes}"
