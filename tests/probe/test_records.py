"""What comes out of a container is hostile: nothing but checked records gets through, and never more than a bounded amount."""

from __future__ import annotations

import itertools
import json
from collections.abc import Iterator
from typing import Any

import pytest

from launchlint.probe import record as record_module
from launchlint.probe.record import LaunchRecord, NodeRecord, Note, Problem, Record, Refused, parse
from launchlint.probe.stream import Stream, TooMuch

NODE: dict[str, Any] = {
    "kind": "node",
    "label": "ignored",
    "package": "demo",
    "name": "talker",
    "program": "roscpp",
    "variant": "default",
    "hash": "0123456789abcdef",
    "digest": "fedcba9876543210",
    "status": "ok",
    "interface": {"publishers": [{"name": "chatter", "type": "std_msgs/String"}]},
    "messages": {"std_msgs/String": {"md5": "992ce8a1687cec8c8bd883ec73ca41d1", "text": "string data"}},
    "problems": [{"code": "ended", "detail": "it ended"}],
    "seconds": 1.5,
    "left": [],
}


def records(*chunks: bytes) -> list[Record]:
    return list(Stream().records(chunks))


def node(**changes: Any) -> NodeRecord:
    record = parse(json.dumps({**NODE, **changes}))
    assert isinstance(record, NodeRecord)
    return record


def test_a_good_record() -> None:
    record = node()
    assert record._replace(line="") == NodeRecord(
        "demo/talker",
        "demo",
        "talker",
        "roscpp",
        "default",
        "0123456789abcdef",
        "fedcba9876543210",
        "ok",
        {"publishers": [{"name": "chatter", "type": "std_msgs/String"}]},
        {},
        {"std_msgs/String": {"md5": "992ce8a1687cec8c8bd883ec73ca41d1", "text": "string data"}},
        (Problem("ended", "it ended"),),
        1.5,
        0,
        "",
    )
    assert parse(record.line) == record


LAUNCH: dict[str, Any] = {
    "kind": "launch",
    "package": "demo",
    "file": "launch/a.launch",
    "args": {"x": "1", "-y": "2"},
    "hash": "0123456789abcdef",
    "status": "ok",
    "interface": {
        "nodes": [
            {"name": "talker", "publishers": [{"name": "chatter"}], "evil": 1},
            {"name": "../x"},
            "text",
        ],
        "params": ["volume", "a b", 3],
    },
    "problems": [],
    "seconds": 2,
    "left": [],
}


@pytest.mark.parametrize("file", ["../a.launch", "launch/../../a.launch", "/etc/passwd", "-a.launch", "a;id.launch", "", None])
def test_a_launch_file_with_a_hostile_name_is_refused(file: str | None) -> None:
    with pytest.raises(Refused):
        parse(json.dumps({**LAUNCH, "file": file}))


def test_a_launch_file() -> None:
    record = parse(json.dumps(LAUNCH))
    assert isinstance(record, LaunchRecord)
    assert (record.label, record.args, record.nodes, record.params) == (
        "demo/launch/a.launch",
        {"x": "1"},
        ({"name": "talker", "publishers": [{"name": "chatter"}]},),
        ("volume",),
    )
    assert parse(record.line) == record


@pytest.mark.parametrize(
    "changes",
    [
        {"package": "../../etc"},
        {"package": "-rf"},
        {"package": 3},
        {"name": "../../bin/sh"},
        {"name": "a/b"},
        {"name": "-x"},
        {"name": "x\n"},
        {"name": "\x1b[31m"},
        {"variant": "../x"},
        {"variant": None},
        {"program": "exe"},
        {"status": "great"},
        {"kind": "nodes"},
        {"kind": ["node"]},
        {"program": "nodelet", "name": "a/../b"},
    ],
)
def test_refused(changes: dict[str, Any]) -> None:
    with pytest.raises(Refused):
        parse(json.dumps({**NODE, **changes}))


@pytest.mark.parametrize(
    "line",
    [
        "",
        "[]",
        "null",
        "3",
        "{",
        '{"kind": "node"}',
        "[" * 100_000,
        '{"kind": "plan", "count": ' + "9" * 100_000 + "}",
        '{"kind": "plan", "count": ' + "9" * 21 + "}",
        '{"kind": NaN}',
        "\x00",
    ],
)
def test_no_record_at_all(line: str) -> None:
    with pytest.raises(Refused):
        parse(line)


def test_names_that_no_node_can_have_are_left_out_and_counted() -> None:
    odd = [{"name": name} for name in ("good", "two words", "$(id)", "\x1b[31m", "{arg:1}", "{nonsense", "x" * 2000, 7)]
    record = node(
        interface={
            "publishers": [*odd, "text", {"type": "a/B"}],
            "elsewhere": [1],
            "services": "text",
            "params": [{"name": "~p", "default": {"a": [1]}}],
        }
    )
    assert record.interface == {"publishers": [{"name": "good"}, {"name": "{arg:1}"}], "params": [{"name": "~p", "default": {"a": [1]}}]}
    assert record.problems[-1] == Problem("odd-names", "8 names that no node can have were left out")


def test_evidence_is_not_for_the_container_to_give() -> None:
    record = node(interface={"publishers": [{"name": "x", "evidence": [{"by": "manual", "at": "trust me"}]}]})
    assert record.interface == {"publishers": [{"name": "x"}]}


def test_text_is_made_harmless_and_short() -> None:
    record = node(
        problems=[{"code": "exception", "detail": "\x1b[2J" + "x" * 10_000 + "\n\u202e"}, {"code": "Not A Code", "detail": ""}, 7]
    )
    assert record.problems == (Problem("exception", "[2J" + "x" * 296 + "…"),)


def test_what_is_of_no_use_is_dropped() -> None:
    text = {"md5": "992ce8a1687cec8c8bd883ec73ca41d1", "text": "string data\x1b[2J\nint8 more\u202e"}
    record = node(hash="../x", digest=7, messages={"std_msgs/String": text, "../x/Y": text, "a/B": {"md5": "none"}, "a/C": {"md5": 3}})
    assert (record.hash, record.digest) == ("", "")
    assert record.messages == {"std_msgs/String": {"md5": "992ce8a1687cec8c8bd883ec73ca41d1", "text": "string data[2J\nint8 more"}}


def test_there_is_a_bound_to_how_much_is_kept(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(record_module, "MOST_ENTRIES", 2)
    monkeypatch.setattr(record_module, "MOST_PROBLEMS", 2)
    sums = {f"a/{letter}": {"md5": 32 * letter} for letter in "abc"}
    listed = [{"name": letter} for letter in "abc"]
    record = node(interface={"publishers": listed}, messages=sums, problems=[{"code": letter, "detail": ""} for letter in "abc"])
    assert record.interface == {"publishers": [{"name": "a"}, {"name": "b"}]}
    assert sorted(record.messages) == ["a/a", "a/b"]
    assert record.problems == (Problem("a", ""), Problem("b", ""), Problem("odd-names", "1 names that no node can have were left out"))
    launch = parse(json.dumps({**LAUNCH, "interface": {"nodes": listed, "params": ["a", "b", "c"]}}))
    assert isinstance(launch, LaunchRecord)
    assert (launch.nodes, launch.params) == (({"name": "a"}, {"name": "b"}), ("a", "b"))


def test_notes() -> None:
    lines = [
        {"kind": "environment", "distro": "noetic\x07", "base": ["x"]},
        {"kind": "build", "package": "demo", "result": "odd", "errors": ["a\x1b[0m", 3] * 100},
        {"kind": "end", "left": -1},
        {"kind": "plan", "count": True, "all": 7},
    ]
    assert records("".join(json.dumps(line) + "\n" for line in lines).encode()) == [
        Note("environment", {"distro": "noetic", "base": "", "middleware": "ros1"}),
        Note("build", {"package": "demo", "result": "failed", "errors": ["a [0m", ""] * 10, "log": []}),
        Note("end", {"left": 0}),
        Note("plan", {"count": 0, "all": 7}),
    ]


def test_lines_in_pieces() -> None:
    line = json.dumps(NODE).encode() + b"\n"
    assert records(*(line[at : at + 7] for at in range(0, len(line), 7)), b"\n", line[:-1]) == [node(), node()]


def test_what_is_no_record_is_counted() -> None:
    stream = Stream(longest=100)
    found = list(stream.records([b"hello\n", b"x" * 90, b"x" * 90, b"\n", b'{"kind": "end", "left": 0}\n', b"\xff\xfe\n"]))
    assert (found, stream.refused, stream.first) == ([Note("end", {"left": 0})], 3, "it is no JSON")


def test_a_line_without_end_is_not_kept() -> None:
    stream = Stream(longest=100)
    kept = []

    def pieces() -> Iterator[bytes]:
        yield b'{"kind": "end", "left": 0' + b" " * 60
        for _ in range(3):
            kept.append(len(stream._rest))
            yield b" " * 60
        yield b"}\n"

    assert (list(stream.records(pieces())), stream.refused, stream.first) == ([], 1, "it is too long")
    assert kept == [85, 0, 0]


def test_a_line_that_comes_at_once_may_not_be_longer_either() -> None:
    stream = Stream(longest=100)
    line = b'{"kind": "end", "left": 0' + b" " * 100 + b"}\n"
    assert (list(stream.records([line])), stream.refused, stream.first) == ([], 1, "it is too long")


def test_a_container_that_prints_without_end_is_given_up() -> None:
    taken = 0

    def endless() -> Iterator[bytes]:
        nonlocal taken
        for _ in range(1000):
            taken += 1
            yield b"x" * 65536

    with pytest.raises(TooMuch, match="it printed more than 8 MiB"):
        list(Stream(largest=8 * 2**20).records(endless()))
    assert taken == 129


def test_so_is_one_that_prints_lines_that_are_no_records() -> None:
    with pytest.raises(TooMuch, match="it printed 1001 lines that are no records: it is no JSON"):
        list(Stream().records(itertools.repeat(b"x\n", 5000)))
