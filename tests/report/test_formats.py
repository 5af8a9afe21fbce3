"""Every format: the whole output for a plain set of findings, and what hostile text does to it."""

from __future__ import annotations

import io
import json
import os
import random
import re
import stat
from collections.abc import Callable
from pathlib import Path
from xml.etree import ElementTree

import pytest

from launchlint.errors import UsageError
from launchlint.finding import Finding, Severity
from launchlint.report import formats
from launchlint.report.run import Run, files_below
from launchlint.verdict import Verdict

Snapshot = Callable[[str, str], None]

NAMES = {
    "text": "plain.txt",
    "concise": "plain.concise.txt",
    "json": "plain.json",
    "jsonl": "plain.jsonl",
    "sarif": "plain.sarif",
    "github": "plain.github.txt",
    "gitlab": "plain.gitlab.json",
    "junit": "plain.junit.xml",
    "markdown": "plain.md",
}
HARMFUL = re.compile("[\x00-\x09\x0b-\x1f\x7f-\x9f\u061c\u200b-\u200f\u2028-\u202e\u2066-\u2069\ufeff\ud800-\udfff]")
"""What must never reach a terminal, a log or a strict reader; line feeds are looked at line by line."""

NOTHING_IN_JUNIT = """\
<?xml version="1.0" encoding="utf-8"?>
<testsuites name="launchlint" tests="1" failures="0" errors="0">
  <testsuite name="launchlint" tests="1" failures="0" errors="0" skipped="0">
    <testcase classname="launchlint" name="launch files"/>
  </testsuite>
</testsuites>
"""


def test_every_format_has_a_snapshot() -> None:
    assert NAMES.keys() == formats.FORMATS.keys()


@pytest.mark.parametrize("name", formats.FORMATS)
def test_plain(name: str, plain: list[Finding], run: Run, snapshot: Snapshot) -> None:
    snapshot(NAMES[name], formats.render(name, plain, run))


@pytest.mark.parametrize("name", formats.FORMATS)
def test_hostile(name: str, hostile: list[Finding], run: Run, snapshot: Snapshot) -> None:
    text = formats.render(name, hostile, run._replace(verbose=True))
    snapshot(NAMES[name].replace("plain", "hostile"), text)
    assert HARMFUL.search(text) is None
    assert "##[" not in text, "GitHub takes this for a command wherever it stands"
    commands = [line for line in text.splitlines() if line.lstrip().startswith("::")]
    expected = ["::error", "::warning", "::notice"] if name == "github" else []
    assert [line.split(" ", 1)[0] for line in commands] == expected


@pytest.mark.parametrize("name", formats.FORMATS)
def test_order_of_the_findings_does_not_matter(name: str, plain: list[Finding], hostile: list[Finding], run: Run) -> None:
    findings = plain + hostile + plain[3:6]
    first = formats.render(name, findings, run._replace(verbose=True))
    for seed in range(5):
        random.Random(seed).shuffle(findings)
        assert formats.render(name, findings, run._replace(verbose=True)) == first


@pytest.mark.parametrize(
    ("name", "expected"),
    [
        ("text", "no problems in 12 launch files\n"),
        ("concise", ""),
        ("json", '{"version": 1, "findings": []}\n'),
        ("jsonl", ""),
        ("github", ""),
        ("gitlab", "[]\n"),
        (
            "junit",
            NOTHING_IN_JUNIT,
        ),
    ],
)
def test_no_findings(name: str, expected: str, run: Run) -> None:
    assert formats.render(name, [], run) == expected


def test_json_gives_back_what_went_in(hostile: list[Finding], run: Run) -> None:
    """Only lone surrogates are changed, which strict readers refuse."""
    finding = json.loads(formats.render("json", hostile, run))["findings"][0]
    kept = hostile[0].message.replace("\udcff", "\\xff").replace("\ud800", "\\ud800")
    assert finding["message"] == kept
    assert list(finding["configuration"].values()) == [kept.removeprefix("message ")]
    assert finding["related"][0]["label"] == kept.replace("message", "related")


def test_json_lines_agree_with_json(plain: list[Finding], run: Run) -> None:
    lines = [json.loads(line) for line in formats.render("jsonl", plain, run).splitlines()]
    assert lines == json.loads(formats.render("json", plain, run))["findings"]


def test_entry_line(plain: list[Finding], run: Run) -> None:
    from launchlint.report.jsonl import entry_line

    line = entry_line("mutants/a.launch", "nav.launch", "error", plain[:1], Verdict("refused", "LL301", "two nodes"))
    assert line.endswith("}\n")
    assert "\n" not in line[:-1]
    expected = {"file": "mutants/a.launch", "as": "nav.launch", "verdict": "error"}
    outcome = {"word": "refused", "rule": "LL301", "reason": "two nodes", "missing": [], "elsewhere": []}
    assert json.loads(line) == {**expected, "outcome": outcome, "findings": json.loads(formats.render("json", plain[:1], run))["findings"]}


@pytest.mark.parametrize(
    ("fail_on", "failing"),
    [
        (None, []),
        (Severity.ERROR, ["empty.launch", "nav.launch"]),
        (Severity.WARNING, ["empty.launch", "launch/wheels.launch", "nav.launch"]),
        (Severity.INFO, ["empty.launch", "launch/wheels.launch", "long.launch", "nav.launch"]),
    ],
)
def test_junit_fails_where_the_run_fails(fail_on: Severity | None, failing: list[str], plain: list[Finding], run: Run) -> None:
    root = ElementTree.fromstring(formats.render("junit", plain, run._replace(fail_on=fail_on)))
    cases = [(case.get("name"), case.find("failure") is not None) for case in root.iter("testcase")]
    assert [name for name, _ in cases] == ["empty.launch", "launch/wheels.launch", "long.launch", "nav.launch"]
    assert [name for name, failed in cases if failed] == failing
    assert root.get("failures") == str(len(failing))


def test_junit_with_hostile_text_is_xml(hostile: list[Finding], run: Run) -> None:
    root = ElementTree.fromstring(formats.render("junit", hostile, run))
    assert [case.get("name", "")[-10:] for case in root.iter("testcase")] == ["901.launch", "902.launch", "903.launch"]


def test_github_tells_how_many_it_leaves_out(plain: list[Finding], run: Run) -> None:
    errors = [plain[0]._replace(message=f"error {number:02}") for number in range(13)]
    warnings = [plain[1]._replace(message=f"warning {number:02}") for number in range(11)]
    infos = [plain[6]._replace(message=f"info {number:02}") for number in range(10)]
    lines = formats.render("github", [*infos, *warnings, *errors], run._replace(verbose=True)).splitlines()
    assert [line.split(" ", 1)[0] for line in lines] == ["::error"] * 10 + ["::warning"] * 10 + ["::notice"] * 10
    assert lines[-1] == (
        "::notice title=launchlint::3 more errors and 1 more warning and 1 more info not shown: "
        "GitHub takes ten of a level; --format text tells all"
    )


def test_gitlab_fingerprints_are_unique(plain: list[Finding], run: Run) -> None:
    items = json.loads(formats.render("gitlab", plain * 3, run))
    assert len({item["fingerprint"] for item in items}) == len(items) == 3 * len(plain)


@pytest.mark.parametrize(
    ("spec", "expected"),
    [
        ("text", formats.Output("text", None)),
        ("sarif:-", formats.Output("sarif", None)),
        ("sarif:out/a:b.sarif", formats.Output("sarif", "out/a:b.sarif")),
    ],
)
def test_parse(spec: str, expected: formats.Output) -> None:
    assert formats.parse(spec) == expected


@pytest.mark.parametrize(
    ("spec", "message"),
    [
        ("sariff:x", "there is no format 'sariff': did you mean sarif?"),
        ("", "there is no format '': the formats are text, concise, json, jsonl, sarif, github, gitlab, junit, markdown"),
        ("json:", "--format json:: the name of a file belongs after the colon"),
    ],
)
def test_parse_refuses(spec: str, message: str) -> None:
    with pytest.raises(UsageError) as caught:
        formats.parse(spec)
    assert str(caught.value) == message


def test_write_to_a_file_is_without_colours_and_leaves_nothing_else(plain: list[Finding], run: Run, tmp_path: Path) -> None:
    formats.write(f"text:{tmp_path}/out.txt", plain, run._replace(color=True))
    assert (tmp_path / "out.txt").read_text(encoding="utf-8") == formats.render("text", plain, run)
    assert [path.name for path in tmp_path.iterdir()] == ["out.txt"]


def test_write_to_a_stream_that_cannot_hold_everything(plain: list[Finding], run: Run) -> None:
    raw = io.BytesIO()
    stream = io.TextIOWrapper(raw, encoding="ascii")
    formats.write("text", plain, run, stream)
    assert '   15 | \\u2026ame="\\u8868\\u793a\\u540d"' in raw.getvalue().decode("ascii")


def test_write_into_a_directory_that_does_not_exist(plain: list[Finding], run: Run, tmp_path: Path) -> None:
    with pytest.raises(UsageError) as caught:
        formats.write(f"json:{tmp_path}/no/out.json", plain, run)
    assert str(caught.value) == (
        f"cannot write the json report to '{tmp_path}/no/out.json': the directory '{tmp_path}/no' does not exist; create it first"
    )


def test_files_below_reads_regular_files_only(tmp_path: Path) -> None:
    read = files_below(str(tmp_path))
    (tmp_path / "a.launch").write_bytes(b"<launch/>")
    os.mkfifo(tmp_path / "pipe")
    (tmp_path / "loop").symlink_to("loop")
    assert [read(name) for name in ("a.launch", "pipe", "loop", ".", "none", "a\0b", "\ud800")] == [b"<launch/>", *[None] * 6]
    assert stat.S_ISFIFO((tmp_path / "pipe").stat().st_mode)
