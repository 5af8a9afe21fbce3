"""The baseline file: written the same every time, read with care, and what it lets through."""

from __future__ import annotations

import json
import os
import random
from collections.abc import Callable
from pathlib import Path

import pytest

from launchlint import baseline
from launchlint.errors import ConfigurationError, UsageError
from launchlint.finding import Finding, Location, Severity
from launchlint.fingerprint import fingerprint


def finding(rule: str, path: str, line: int, element: str) -> Finding:
    return Finding(
        rule, f"name-of-{rule}", Severity.ERROR, Location(path, line, 1, line, 2, line * 10, line * 10 + 1, ""), "message", element=element
    )


FINDINGS = [
    finding("LL301", "b.launch", 3, '<node name="x"/>'),
    finding("LL301", "b.launch", 9, '<node name="x"/>'),
    finding("LL206", "b.launch", 1, '<arg name="y"/>'),
    finding("LL301", "a.launch", 3, '<node name="x"/>'),
    finding("LL901", '\x1b[31m"\u202e\udcff\n.launch', 1, "\x00"),
]


def test_written_file(tmp_path: Path, snapshot: Callable[[str, str], None]) -> None:
    file = tmp_path / "baseline.json"
    baseline.write(str(file), FINDINGS)
    first = file.read_text(encoding="ascii")
    snapshot("baseline.json", first)
    for seed in range(5):
        findings = list(FINDINGS)
        random.Random(seed).shuffle(findings)
        baseline.write(str(file), findings)
        assert file.read_text(encoding="ascii") == first
    assert os.listdir(tmp_path) == ["baseline.json"]


def test_nothing_is_new_right_after_writing(tmp_path: Path) -> None:
    file = str(tmp_path / "baseline.json")
    baseline.write(file, FINDINGS)
    assert baseline.filter(FINDINGS, baseline.load(file)) == []


def test_no_findings(tmp_path: Path) -> None:
    file = tmp_path / "baseline.json"
    baseline.write(str(file), [])
    assert file.read_text(encoding="ascii") == '{\n  "version": 1,\n  "findings": []\n}\n'
    assert baseline.load(str(file)) == baseline.Baseline({})


def test_what_is_new(tmp_path: Path) -> None:
    file = str(tmp_path / "baseline.json")
    baseline.write(file, FINDINGS[:3])
    moved = [
        one._replace(location=one.location._replace(line=one.location.line + 5, start=one.location.start + 50)) for one in FINDINGS[:3]
    ]
    third = finding("LL301", "b.launch", 99, '<node name="x"/>')
    other = finding("LL206", "b.launch", 2, '<arg name="z"/>')
    assert baseline.filter([third, *moved, other], baseline.load(file)) == [other, third]


ONE = fingerprint(FINDINGS[0])


def written(version: object = 1, findings: object = ()) -> str:
    return json.dumps({"version": version, "findings": findings})


@pytest.mark.parametrize(
    ("content", "message"),
    [
        (b"", "F:1:1: this baseline is no JSON: Expecting value; --write-baseline makes a new one"),
        (b'{\n "a": }', "F:2:7: this baseline is no JSON: Expecting value; --write-baseline makes a new one"),
        (b"\xff{}", "F: the baseline is no UTF-8 text (byte 0); --write-baseline makes a new one"),
        (b"[]", 'F: this is no baseline: it has no list "findings"; --write-baseline makes a new one'),
        (b'{"version": 1, "findings": {}}', 'F: this is no baseline: it has no list "findings"; --write-baseline makes a new one'),
        (written(2).encode(), "F: this baseline has version 2, not 1; --write-baseline makes a new one"),
        (written(True).encode(), "F: this baseline has version true, not 1; --write-baseline makes a new one"),
        (b'{"findings": []}', "F: this baseline has version null, not 1; --write-baseline makes a new one"),
        (
            written("\x1b" * 100).encode(),
            'F: this baseline has version "' + "\\u001b" * 6 + "\\u0 …, not 1; --write-baseline makes a new one",
        ),
        (written(1, [3]).encode(), "F: finding 1 of this baseline has no fingerprint of 64 hexadecimal digits"),
        (written(1, [{"fingerprint": ONE + "\n"}]).encode(), "F: finding 1 of this baseline has no fingerprint of 64 hexadecimal digits"),
        (
            written(1, [{"fingerprint": ONE}, {"fingerprint": ONE, "count": 0}]).encode(),
            "F: finding 2 of this baseline has the count 0; a count is a whole number from 1",
        ),
        (
            written(1, [{"fingerprint": ONE, "count": 1.5}]).encode(),
            "F: finding 1 of this baseline has the count 1.5; a count is a whole number from 1",
        ),
    ],
)
def test_what_is_no_baseline(content: bytes, message: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    Path("F").write_bytes(content)
    with pytest.raises(ConfigurationError) as caught:
        baseline.load("F")
    assert str(caught.value) == message


@pytest.mark.parametrize("content", [b"[" * 100_000, b'{"a":' * 100_000, b'{"version": ' + b"9" * 10_000 + b"}"])
def test_json_that_breaks_readers(content: bytes, tmp_path: Path) -> None:
    (tmp_path / "F").write_bytes(content)
    with pytest.raises(ConfigurationError, match="this baseline cannot be read as JSON"):
        baseline.load(str(tmp_path / "F"))


@pytest.mark.parametrize(
    ("name", "message"),
    [
        ("none.json", "none.json: there is no such baseline file; --write-baseline makes one"),
        (".", ".: the baseline must be a file"),
        ("pipe", "pipe: the baseline must be a file"),
        ("loop", "loop: the baseline cannot be read: Too many levels of symbolic links"),
        ("a\0b", "'a\\x00b': this is no name of a file"),
    ],
)
def test_what_cannot_be_read(name: str, message: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    Path("loop").symlink_to("loop")
    os.mkfifo("pipe")
    with pytest.raises(ConfigurationError) as caught:
        baseline.load(name)
    assert str(caught.value) == message


def test_a_byte_order_mark_and_counts_of_one(tmp_path: Path) -> None:
    file = tmp_path / "F"
    file.write_bytes(b"\xef\xbb\xbf" + written(1, [{"fingerprint": ONE}, {"fingerprint": ONE, "count": 2}]).encode())
    assert baseline.load(str(file)) == baseline.Baseline({ONE: 3})


def test_where_it_cannot_be_written(tmp_path: Path) -> None:
    with pytest.raises(UsageError) as caught:
        baseline.write(str(tmp_path / "no" / "baseline.json"), FINDINGS)
    assert str(caught.value) == (
        f"cannot write the baseline to '{tmp_path}/no/baseline.json': the directory '{tmp_path}/no' does not exist; create it first"
    )
