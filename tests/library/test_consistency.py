"""What `launchlint library validate` says beyond the format: entries that have no effect."""

from __future__ import annotations

import json
from typing import Any

import pytest

from launchlint.library.consistency import inconsistencies
from launchlint.library.inspection import inspect
from launchlint.library.validate import faults
from tests.library.samples import executable, library, one, publishers

SHIPPED = library(far={"executables": {"end": executable(), "again": {"like": "end"}}, "nodelets": {"far/End": executable()}})


def told(document: Any) -> list[str]:
    """The faults of a library that follows the format; paths from the package on."""
    assert faults(document) == []
    return [
        f"{'/'.join(map(str, fault.path[1:]))}: {fault.message}"
        for fault in inconsistencies(document, lambda name, _: SHIPPED["packages"].get(name))
    ]


def variant(**interface: Any) -> list[str]:
    """The faults of a variant, its place left out."""
    return [line.removeprefix("demo/executables/node/variants/default/") for line in told(one(executable(**interface)))]


def names(*entries: dict[str, Any], options: dict[str, int] | None = None) -> list[str]:
    document = publishers(*entries)
    if options is not None:
        document["packages"]["demo"]["executables"]["node"]["options"] = options
    return [line.removeprefix("demo/executables/node/variants/default/publishers/") for line in told(document)]


def test_what_has_an_effect_is_no_fault() -> None:
    assert names(
        {"name": "{arg:2|{arg:1}_relay}"},
        {"name": "{arg:1}/{arg:2|x}"},
        {"name": "{param:~a|{param:~b|c}}"},
        {"name": "{option:-r|x}", "condition": {"any": [{"option": "-r"}, {"arg": 1}]}},
        {"name": "{each}", "each": {"args": 2}},
        {"name": "{each}", "each": {"args": 3}},
        {"name": "{each}_{arg:3|x}", "each": {"args": 2}},
        {"name": "{each:topic}", "type": "{each:type}", "each": {"args": 2, "like": "{topic}@{type}"}},
        {"name": "{each:topic|{each}}", "each": {"param": "~topics"}},
        {"name": "out", "type": "a/B", "condition": {"param": "~x"}},
        {"name": "out", "type": "a/C", "condition": {"not": {"param": "~x"}}},
        {"name": "{remap:in}/compressed", "type": "{param:~type|std_msgs/String}"},
        {"name": "{{odd"},
        options={"-r": 1},
    ) == ["12/name: \"{odd\" cannot be a part of a name: letters, digits, _, / and ~ can"]  # fmt: skip


@pytest.mark.parametrize(
    ("entry", "message"),
    [
        ({"name": "/rosout"}, "0/name: every node has /rosout: leave it out"),
        ({"name": "{node}/a b"}, '0/name: "/a b" cannot be a part of a name: letters, digits, _, / and ~ can'),
        ({"name": "{option:-r}"}, "0/name: {option:-r} has no value: did you mean -R?"),
        ({"name": "{option:--topic|x}"}, "0/name: {option:--topic} has no value: `options` has -R, -l"),
        ({"name": "{param:~x|{option:-z}}"}, "0/name: {option:-z} has no value: `options` has -R, -l"),
        (
            {"name": "x", "condition": {"not": {"all": [{"arg": 1}, {"option": "--rate"}]}}},
            '0/condition/not/all/1/option: the option "--rate" is never given: `options` has -R, -l',
        ),
        ({"name": "{each}"}, "0/name: {each} has no value: the entry has no `each`"),
        (
            {"name": "{each:x}", "each": {"args": 1}},
            "0/name: {each:x} has no value: only the things of a param have members, and args that are `like` a pattern",
        ),
        (
            {"name": "{each:x}", "each": {"args": 1, "like": "{topic}@{type}"}},
            "0/name: {each:x} has no value: only the things of a param have members, and args that are `like` a pattern",
        ),
        ({"name": "{each|x}", "each": {"args": 1}}, "0/name: {each} always has a value: its default is never used"),
        ({"name": "x", "each": {"args": 1}}, "0/each: each of these things gives the same name: put {each} into the name"),
        ({"name": "{arg:2|{arg:2}_x}"}, "0/name: the default of {arg:2} is asked for only where {arg:2} has no value either"),
        ({"name": "{arg:1|{arg:2}}"}, "0/name: the default of {arg:1} is asked for only where {arg:2} has no value either"),
        ({"name": "{param:~x|{param:~x}}"}, "0/name: the default of {param:~x} is asked for only where {param:~x} has no value either"),
        ({"name": "{arg:1|x}/{arg:2}"}, "0/name: the default of {arg:1} is never used: without {arg:2} there is no name at all"),
        (
            {"name": "{arg:2|x}/{each}", "each": {"args": 2}},
            "0/name: the default of {arg:2} is never used: `each` goes through later arguments",
        ),
    ],
)
def test_name_without_effect(entry: dict[str, Any], message: str) -> None:
    assert names(entry, options={"-R": 1, "-l": 0}) == [message]


def test_option_of_a_program_without_options() -> None:
    expected = "0/name: {option:-r} has no value: the program has no `options`, so every argument is positional"
    assert names({"name": "{option:-r}"}) == [expected]


@pytest.mark.parametrize("extra", [{}, {"condition": {"arg": 1}}, {"each": {"args": 1}}])
def test_the_same_entry_twice(extra: dict[str, Any]) -> None:
    name = "{each}" if "each" in extra else "x"
    assert names({"name": "y"}, {"name": name, **extra}, {"name": name, "type": "a/B", **extra}) == [
        f'2: "{name}" stands in this list already, as number 2: join the two, or give each a condition'
    ]


def test_an_action_may_have_a_server_and_a_client() -> None:
    roles = [{"name": "go", "role": "server"}, {"name": "go", "role": "client"}]
    assert variant(actions=roles) == []
    assert variant(actions=[*roles, {"name": "go", "role": "client"}]) == [
        'actions/2: "go" stands in this list already, as number 2: join the two, or give each a condition'
    ]


def test_topics_of_an_action() -> None:
    """move_base publishes the goals of its own server: that does not follow from the action."""
    server = {"name": "go", "role": "server"}
    assert variant(actions=[server], publishers=[{"name": "go/goal"}], subscribers=[{"name": "go/result"}]) == []
    assert variant(actions=[server], publishers=[{"name": "go/result"}], subscribers=[{"name": "go/goal"}]) == [
        'publishers/0/name: "go/result" follows from the action "go": leave it out',
        'subscribers/0/name: "go/goal" follows from the action "go": leave it out',
    ]


def test_names_of_every_node() -> None:
    assert variant(
        publishers=[{"name": "/clock"}], subscribers=[{"name": "/rosout"}, {"name": "/clock"}], services=[{"name": "~get_loggers"}]
    ) == [
        "subscribers/1/name: every node has /clock: leave it out",
        "services/0/name: every node has ~get_loggers: leave it out",
    ]


@pytest.mark.parametrize(
    ("program", "message"),
    [
        ({}, ': this says nothing: give it `variants` or `like`; a program that is no node has "class": "none"'),
        ({"variants": {}}, ': this says nothing: give it `variants` or `like`; a program that is no node has "class": "none"'),
        (
            {"variants": {"fast": {}}},
            '/variants/fast: the variant "fast" is never chosen: only default does without `match`, the condition for it',
        ),
        (
            {"variants": {"default": {"match": {"arg": 1}}}},
            "/variants/default/match: the variant default stands where no other one does: its `match` is never asked",
        ),
        (
            {"variants": {"default": {}, "fast": {"match": {"option": "-f"}}}},
            '/variants/fast/match/option: the option "-f" is never given: the program has no `options`, so every argument is positional',
        ),
        (
            {"class": "none", "variants": {"default": {"publishers": [{"name": "x"}]}}},
            "/variants/default: a program of class none never talks to the ROS master, so it cannot have these names",
        ),
        ({"like": "other", "options": {}}, "/options: `like` says all there is to say: options beside it has no effect"),
        ({"like": "othr"}, '/like: there is no executable "othr" of the package demo here or in the bundled library; did you mean other?'),
        ({"like": "far/and"}, '/like: there is no executable "and" of the package far here or in the bundled library; did you mean end?'),
        ({"like": "nowhere/x"}, '/like: there is no executable "x" of the package nowhere here or in the bundled library'),
        ({"like": "node"}, '/like: `like` leads in a circle: "node" → "node"'),
        ({"like": "back"}, '/like: `like` leads in a circle: "node" → "back" → "node"'),
        ({"like": "chain6"}, "/like: `like` leads over more than 5 programs: name the last one directly"),
    ],
)
def test_program_without_effect(program: Any, message: str) -> None:
    chain = {f"chain{number}": {"like": f"chain{number - 1}"} for number in range(2, 7)}
    others = {"other": executable(), "chain1": executable(), **chain}
    executables = {"node": program, **others, **({"back": {"like": "node"}} if program.get("like") == "back" else {})}
    place = "demo/executables/node"
    found = [line.removeprefix(place) for line in told(library(demo={"executables": executables})) if line.startswith(place)]
    assert found == [message]


def test_programs_with_an_effect() -> None:
    programs = {
        "none": {"class": "none"},
        "failed": {"status": "failed"},
        "same": {"class": "roscpp", "like": "real"},
        "far": {"like": "far/again"},
        "real": {"options": {"-f": 0}, "variants": {"default": {}, "fast": {"match": {"option": "-f"}}}},
    }
    nodelets = {"demo/A": executable(), "demo/B": {"like": "demo/A"}, "demo/C": {"like": "far/End"}}
    assert told(library(demo={"executables": programs, "nodelets": nodelets})) == []


def test_like_of_nodelets() -> None:
    nodelets = {"demo/Image": executable(), "demo/B": {"like": "demo/Imag"}, "demo/C": {"like": "demo/C"}}
    assert told(library(demo={"nodelets": nodelets})) == [
        'demo/nodelets/demo/B/like: there is no nodelet class "demo/Imag" here or in the bundled library; did you mean demo/Image?',
        'demo/nodelets/demo/C/like: `like` leads in a circle: "demo/C" → "demo/C"',
    ]


def test_the_place_in_the_text() -> None:
    text = json.dumps(publishers({"name": "x"}, {"name": "x"}), indent=1)
    line = text[: text.rindex('"name"')].count("\n")
    assert inspect(text.encode(), "lib.json")[1] == [
        f'lib.json:{line}:9: "x" stands in this list already, as number 1: join the two, or give each a condition'
    ]  # fmt: skip
