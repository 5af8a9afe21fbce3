"""SARIF in detail: what GitHub shows, the schema, and the limits."""

from __future__ import annotations

import json
import os
import subprocess
from pathlib import Path
from typing import Any

import jsonschema
import pytest

from launchlint.finding import Finding, Severity
from launchlint.report import sarif
from launchlint.report.run import Run


def log(findings: list[Finding], run: Run) -> dict[str, Any]:
    """The only run of the log."""
    document: dict[str, Any] = json.loads(sarif.render(findings, run))
    only: dict[str, Any] = document["runs"][0]
    return only


def multitool_directory(command: str) -> Path:
    """Where the package of the multitool lies; its schema is beside its program."""
    return Path(os.path.realpath(command)).parent


@pytest.mark.npm
def test_schema(plain: list[Finding], hostile: list[Finding], run: Run, sarif_multitool: str) -> None:
    modules = multitool_directory(sarif_multitool).parent
    files = sorted(modules.rglob("sarif-2.1.0.json"))
    assert files, f"the package below {modules} holds no schema"
    schema = json.loads(files[0].read_text(encoding="utf-8-sig"))
    validator = jsonschema.validators.validator_for(schema)(schema)
    document = json.loads(sarif.render(plain + hostile, run))
    assert [error.message for error in validator.iter_errors(document)] == []


@pytest.mark.npm
def test_multitool_with_the_rules_of_github(
    plain: list[Finding], hostile: list[Finding], run: Run, sarif_multitool: str, tmp_path: Path
) -> None:
    """It ends with status 0 whatever it finds: its log is what counts."""
    (tmp_path / "out.sarif").write_text(sarif.render(plain + hostile, run._replace(notices=("a notice",))), encoding="utf-8")
    # npm's starter hands its words to a shell without quoting them, which would end the command at the semicolon.
    kinds = '"Sarif;Ghas"' if os.path.realpath(sarif_multitool).endswith(".js") else "Sarif;Ghas"
    command = [sarif_multitool, "validate", "--rule-kind", kinds, "out.sarif", "-o", "verdict.sarif"]
    done = subprocess.run(command, cwd=tmp_path, capture_output=True, text=True, check=True, timeout=300)
    verdict = json.loads((tmp_path / "verdict.sarif").read_text(encoding="utf-8-sig"))["runs"][0]
    told = [(result["ruleId"], result.get("level", "warning")) for result in verdict.get("results", [])]
    assert [item for item in told if item[1] != "note"] == [], done.stdout
    assert verdict["invocations"][0]["executionSuccessful"] is True
    wrong = {"version": "2.1.0", "runs": [{"tool": {"driver": {"name": "x"}}, "results": [{"message": {"text": "x"}}]}]}
    (tmp_path / "out.sarif").write_text(json.dumps(wrong), encoding="utf-8")
    done = subprocess.run([*command[:-2], "-o", "wrong.sarif"], cwd=tmp_path, capture_output=True, text=True, check=True, timeout=300)
    assert "GH2012" in done.stdout, "GitHub's rules are not in force"


def test_message_links_to_the_related_places(plain: list[Finding], run: Run) -> None:
    result = log(plain[:1], run)["results"][0]
    assert result["message"]["text"] == (
        "two nodes are named /robot1/amcl ([the first one](1)).\n"
        "roslaunch stops with: multiple nodes named [/robot1/amcl].\n"
        "Show it: roslaunch nav.launch slam:=false.\n"
        "Help: rename one, or put them into different namespaces."
    )
    assert [(one["id"], one["message"]["text"]) for one in result["relatedLocations"]] == [(1, "the first one.")]


def test_hostile_text_makes_no_links(plain: list[Finding], run: Run) -> None:
    finding = plain[0]._replace(message="[a](http://x)", related=(plain[0].related[0]._replace(label="]\\["),), notes=(), help="", entry="")
    assert log([finding], run)["results"][0]["message"]["text"] == "[a] (http://x) ([\\]\\\\\\[](1))."


@pytest.mark.parametrize(
    ("path", "expected"),
    [
        ("launch/a b#?%.launch", {"uri": "launch/a%20b%23%3F%25.launch", "uriBaseId": "SRCROOT"}),
        ("./a/../b:c.launch", {"uri": "b%3Ac.launch", "uriBaseId": "SRCROOT"}),
        ("../other/a.launch", {"uri": "file:///home/user/other/a.launch"}),
        ("/opt/ros/a.launch", {"uri": "file:///opt/ros/a.launch"}),
        ("/home/user/work space/a.launch", {"uri": "a.launch", "uriBaseId": "SRCROOT"}),
        ("\udcff\ud800.launch", {"uri": "%ED%B3%BF%ED%A0%80.launch", "uriBaseId": "SRCROOT"}),
        ("\udcff.launch", {"uri": "%FF.launch", "uriBaseId": "SRCROOT"}),
        ("..a.launch", {"uri": "..a.launch", "uriBaseId": "SRCROOT"}),
    ],
)
def test_addresses(path: str, expected: dict[str, str], plain: list[Finding], run: Run) -> None:
    result = log([plain[8]._replace(location=plain[8].location._replace(path=path))], run)["results"][0]
    assert result["locations"][0]["physicalLocation"]["artifactLocation"] == expected


def test_root(run: Run) -> None:
    assert log([], run)["originalUriBaseIds"] == {"SRCROOT": {"uri": "file:///home/user/work%20space/"}}
    assert log([], run._replace(root="/"))["originalUriBaseIds"] == {"SRCROOT": {"uri": "file:///"}}


def test_include_chain_is_a_code_flow(plain: list[Finding], run: Run) -> None:
    flow = log(plain[1:2], run)["results"][0]["codeFlows"][0]["threadFlows"][0]["locations"]
    steps = [step["location"] for step in flow]
    assert [
        (step["message"]["text"], step["physicalLocation"]["artifactLocation"]["uri"], step["physicalLocation"]["region"]["startLine"])
        for step in steps
    ] == [
        ("included here, step 1.", "nav.launch", 12),
        ("a blank in a name.", "launch/wheels.launch", 2),
    ]


def test_fix(plain: list[Finding], run: Run) -> None:
    assert log(plain[1:2], run)["results"][0]["fixes"] == [
        {
            "description": {"text": "write wheel_driver."},
            "artifactChanges": [
                {
                    "artifactLocation": {"uri": "launch/wheels.launch", "uriBaseId": "SRCROOT"},
                    "replacements": [{"deletedRegion": {"charOffset": 46, "charLength": 12}, "insertedContent": {"text": "wheel_driver"}}],
                }
            ],
        }
    ]


def test_fingerprints_without_the_file(plain: list[Finding], run: Run) -> None:
    """GitHub's own fingerprint needs the text around the line; a guess would be reported as inconsistent."""
    prints = log(plain[:1], run._replace(read=lambda path: None))["results"][0]["partialFingerprints"]
    assert list(prints) == ["launchlint/v1"]


def test_notices_and_a_crash(run: Run) -> None:
    invocation = log([], run._replace(notices=("no packages\x1b found",), successful=False))["invocations"]
    note = {"message": {"text": "no packages\\x1b found"}, "level": "note"}
    assert invocation == [{"executionSuccessful": False, "toolExecutionNotifications": [note]}]


def test_too_many_results(plain: list[Finding], run: Run, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(sarif, "_MOST_RESULTS", 6)
    only = log(plain, run)
    assert [result["level"] for result in only["results"]] == ["error", "warning", "error", "error", "error", "error"]
    assert only["invocations"][0]["toolExecutionNotifications"] == [
        {
            "message": {"text": "3 of 9 findings are left out, the least severe first: GitHub takes no larger log"},
            "level": "warning",
        }
    ]


def test_too_many_bytes(plain: list[Finding], run: Run, monkeypatch: pytest.MonkeyPatch) -> None:
    findings = [plain[number % 2]._replace(message=f"number {number * 7919 % 1000}") for number in range(200)]
    whole = sarif.render(findings, run)
    monkeypatch.setattr(sarif, "_MOST_BYTES", 6000)
    only = log(findings, run)
    assert 0 < len(only["results"]) < 200
    assert {result["level"] for result in only["results"]} == {"error"}
    assert len(only["invocations"][0]["toolExecutionNotifications"]) == 1
    assert len(sarif.render(findings, run)) < len(whole)


def test_a_log_that_can_never_fit_ends_empty(plain: list[Finding], run: Run, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(sarif, "_MOST_BYTES", 10)
    assert log(plain, run)["results"] == []


def test_a_rule_without_a_page(plain: list[Finding], run: Run) -> None:
    finding = plain[0]._replace(rule="LL999", name="internal-error", severity=Severity.ERROR)
    only = log([finding], run)
    rules = only["tool"]["driver"]["rules"]
    assert [rule["id"] for rule in rules] == sorted(rule["id"] for rule in rules)
    assert rules[only["results"][0]["ruleIndex"]]["id"] == "LL999"
