"""What ``--fix`` and ``--unsafe-fixes`` do to the files that every rule is tried on: the whole difference, and what is left.

``expected/LLnnn-CASE.txt`` holds what ``check --select LLnnn`` shows with ``--diff`` and with ``--unsafe-fixes --diff``.
"""

from __future__ import annotations

import json
import shutil
from collections import Counter
from pathlib import Path
from typing import Any

import pytest

from launchlint.rules.registry import RULES
from tests.rules.pipeline import ENVIRONMENT_FILE, OPTIONS_FILE, case_environment, case_options, check
from tests.rules.test_fixtures import BASE, CASES, EXPECTED

KEPT = Path(__file__).with_name("expected")
FIXABLE = {entry.id: entry.load().RULE.fixable for entry in RULES}
TRIED = [
    case for case in CASES if FIXABLE[case.parent.name] != "never" and not case.name.startswith("clean") and not (case / BASE).exists()
]
MODES = {"--fix": ("--diff",), "--unsafe-fixes": ("--unsafe-fixes", "--diff")}
every_case = pytest.mark.parametrize("case", TRIED, ids=lambda case: f"{case.parent.name}-{case.name}")


def copied(case: Path, directory: Path) -> Path:
    copy = directory / case.name
    shutil.copytree(case, copy, symlinks=True, ignore=shutil.ignore_patterns(EXPECTED, OPTIONS_FILE, ENVIRONMENT_FILE))
    return copy


@every_case
def test_difference(case: Path, update: bool, tmp_path: Path) -> None:
    copy = copied(case, tmp_path)
    shown = []
    for mode, options in MODES.items():
        _, output = check(copy, "--select", case.parent.name, *options, *case_options(case), environment=case_environment(case))
        shown.append(f"==== {mode}\n{output.replace(str(copy), '')}")
    expected = KEPT / f"{case.parent.name}-{case.name}.txt"
    if update:
        expected.parent.mkdir(exist_ok=True)
        expected.write_bytes("".join(shown).encode("utf-8"))
    assert expected.is_file(), f"read this, then run pytest --update\n{''.join(shown)}"
    assert "".join(shown) == expected.read_bytes().decode("utf-8")


def found(copy: Path, case: Path, *options: str) -> list[dict[str, Any]]:
    """What all rules find in the copy, with ``options``; what is said of the fixes is not of interest."""
    output = copy.with_name("report.json")
    words = ["--select", "all", "--format", f"json:{output}", *options]
    check(copy, *words, *case_options(case), environment=case_environment(case))
    findings: list[dict[str, Any]] = json.loads(output.read_text(encoding="utf-8"))["findings"]
    return findings


@every_case
@pytest.mark.parametrize("mode", MODES)
def test_what_is_left(mode: str, case: Path, tmp_path: Path) -> None:
    """No error or warning has come, and there is nothing left to repair."""
    copy = copied(case, tmp_path)
    before = found(copy, case)
    after = found(copy, case, mode)
    rules = [Counter(each["rule"] for each in findings if each["severity"] != "info") for findings in (before, after)]
    assert rules[1] - rules[0] == Counter()
    again = found(copy, case, mode)
    assert again == after


def test_every_rule_that_repairs_something_is_tried() -> None:
    shown = "".join(file.read_text(encoding="utf-8") for file in sorted(KEPT.iterdir()))
    assert "+++" in shown
    tried = {file.name.partition("-")[0] for file in KEPT.iterdir() if "+++" in file.read_text(encoding="utf-8")}
    assert tried == {rule for rule, fixable in FIXABLE.items() if fixable != "never"}
