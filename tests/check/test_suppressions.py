"""Comments that silence findings, from the file to the exit status."""

from __future__ import annotations

import json
from collections.abc import Callable, Mapping
from pathlib import Path

import pytest

from tests.cli.running import run

Make = Callable[[Mapping[str, str]], Path]

NODE = '<node name="a" pkg="demo" type="talk.py"/>'
FOUND = "a.launch:{line}:13: error LL301 duplicate-node-name: two nodes are named /a\n"


def check(make: Make, text: str, *words: str) -> tuple[int, str, str]:
    return tuple(run(make({"a.launch": text}), "check", "--format", "concise", *words))  # type: ignore[return-value]  # three parts


@pytest.mark.parametrize(
    "comment",
    [
        "launchlint: ignore[LL301] the second one is another build",
        "launchlint: ignore[duplicate-node-name] meant",
        "launchlint: ignore[ll301, LL105] meant",
        "launchlint: ignore meant",
    ],
)
def test_before_an_element(make: Make, comment: str) -> None:
    status, output, _ = check(make, f"<launch>\n{NODE}\n<!-- {comment} -->\n{NODE}\n</launch>\n", "--ignore", "LL802")
    assert (status, output) == (0, "")


def test_only_the_element_is_covered(make: Make) -> None:
    text = f"<launch>\n{NODE}\n<!-- launchlint: ignore[LL301] meant -->\n{NODE}\n{NODE}\n</launch>\n"
    assert check(make, text)[:2] == (1, FOUND.format(line=5))


def test_a_group_covers_what_is_in_it(make: Make) -> None:
    text = f"<launch>\n{NODE}\n<!-- launchlint: ignore[LL301] meant -->\n<group>\n{NODE}\n</group>\n{NODE}\n</launch>\n"
    assert check(make, text)[:2] == (1, FOUND.format(line=7))


def test_the_whole_file(make: Make) -> None:
    text = f"<!-- launchlint: ignore-file[LL301] meant -->\n<launch>\n{NODE}\n{NODE}\n{NODE}\n</launch>\n"
    assert check(make, text) == (0, "", "")


def test_one_that_suppresses_nothing_is_a_finding(make: Make) -> None:
    text = f"<launch>\n<!-- launchlint: ignore[LL301] meant -->\n{NODE}\n</launch>\n"
    status, output, _ = check(make, text)
    assert status == 0
    assert output.startswith("a.launch:2:1: warning LL802 unused-suppression: ")
    assert check(make, text, "--ignore", "LL301") == (0, "", ""), "a rule that does not run cannot be suppressed in vain"


def test_the_finding_in_an_included_file_is_suppressed_there(make: Make) -> None:
    part = f"<launch>\n{NODE}\n<!-- launchlint: ignore[LL301] meant -->\n{NODE}\n</launch>\n"
    directory = make({"part.launch": part, "all.launch": '<launch>\n<include file="$(dirname)/part.launch"/>\n</launch>\n'})
    assert run(directory, "check", "--format", "concise") == (0, "", "")
    assert run(directory, "check", "--format", "concise", "all.launch") == (0, "", "")


def test_a_suppressed_finding_is_in_no_format_and_no_baseline(make: Make) -> None:
    directory = make({"a.launch": f"<launch>\n{NODE}\n<!-- launchlint: ignore[LL301] meant -->\n{NODE}\n</launch>\n"})
    for name in ("text", "jsonl", "github", "gitlab", "junit"):
        assert "duplicate-node-name:" not in run(directory, "check", "--format", name).output
        assert "two nodes are named" not in run(directory, "check", "--format", name).output
    # A comment does not change what roslaunch does with the file: these two say so beside the findings.
    told = json.loads(run(directory, "check", "--format", "json").output)
    assert told["findings"] == []
    assert [(each["word"], each["reason"]) for each in told["verdicts"]] == [("refused", "two nodes are named /a")]
    (sarif,) = json.loads(run(directory, "check", "--format", "sarif").output)["runs"]
    assert sarif["results"] == []
    assert run(directory, "check", "--write-baseline", "b.json").errors.startswith("launchlint: wrote 0 findings")


def test_severities_and_per_file_ignores_hold_for_what_is_said_of_comments(make: Make) -> None:
    text = f"<launch>\n<!-- launchlint: ignore[LL301] meant -->\n{NODE}\n</launch>\n"
    assert check(make, text, "--severity", "LL802=error")[0] == 1
    directory = make({"a.launch": text, ".launchlint.yaml": "per-file-ignores: {a.launch: [LL802]}\n"})
    assert run(directory, "check", "--format", "concise") == (0, "", "")
