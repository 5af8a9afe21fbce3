"""Held against recorded answers of the real roslaunch: a sample of thousands of public launch files, and of files with one mistake each.

``LAUNCHLINT_CORPUS`` names the unpacked files, ``LAUNCHLINT_ORACLE`` the directory with roslaunch's answers and the comparison.
"""

from __future__ import annotations

import importlib.util
import json
import lzma
import os
from collections import Counter
from collections.abc import Iterator
from pathlib import Path
from types import ModuleType
from typing import Any

import pytest

from launchlint.check.entry import EntryChecker, EntryResult
from launchlint.check.ignores import PerFileIgnores
from launchlint.check.merge import merge
from launchlint.check.options import EntryRequest, Options
from launchlint.finding import Finding, Severity
from launchlint.report.model import as_object
from launchlint.rules.registry import RULES

EVERY_ANSWER = 8
EVERY_MUTANT = 5
FIXED = {
    "HOME": "/home/user",
    "USER": "user",
    "LANG": "C.UTF-8",
    "ROS_DISTRO": "noetic",
    "ROS_MASTER_URI": "http://localhost:11311",
    "ROS_HOSTNAME": "localhost",
    "ROS_ETC_DIR": "/etc/ros",
    "ROS_HOME": "/home/user/.ros",
    "CMAKE_PREFIX_PATH": "",
    "ROS_VERSION": "1",
    "ROS_PYTHON_VERSION": "3",
}
NONE_IGNORED = PerFileIgnores({}, "/", "/")
RULE_IDS = frozenset(rule.id for rule in RULES if rule.default)


@pytest.fixture(scope="module")
def oracle() -> Path:
    directory = Path(os.environ.get("LAUNCHLINT_ORACLE", ""))
    if not (directory / "agree.py").is_file():
        pytest.skip("LAUNCHLINT_ORACLE does not name a directory with roslaunch's recorded answers")
    return directory


def load(path: Path) -> ModuleType:
    spec = importlib.util.spec_from_file_location(path.stem, path)
    assert spec is not None
    assert spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


class Checkers:
    """A checker that sees the packages of a file's repository first and then all others, as the recorded roslaunch did."""

    def __init__(self, root: Path) -> None:
        self.root = root
        self.repository = ""
        self.latest: EntryChecker | None = None

    def of(self, file: str) -> EntryChecker:
        repository = file.split("/")[0]
        if self.latest is None or repository != self.repository:
            variables = {**FIXED, "PATH": os.environ["PATH"]}
            workspaces = (str(self.root / repository), str(self.root))
            self.latest = EntryChecker(Options(RULE_IDS, workspaces, True, variables, str(self.root)))
            self.repository = repository
        return self.latest


def answers(oracle: Path, name: str) -> Iterator[dict[str, Any]]:
    with lzma.open(oracle / name, "rt", encoding="utf-8") as lines:
        for number, line in enumerate(lines):
            if number % EVERY_ANSWER == 0 and "/usr/share/" not in line:
                yield json.loads(line)


@pytest.mark.corpus
@pytest.mark.parametrize("name", ["visible-guess.jsonl.xz", "visible-strict.jsonl.xz"])
def test_verdict_and_model_are_roslaunchs(corpus: Path, oracle: Path, name: str) -> None:
    """Answers that need packages of repositories outside the corpus are left out: those packages cannot be found here."""
    agree = load(oracle / "agree.py")
    root = corpus / "ros1"
    checkers = Checkers(root)
    different: list[str] = []
    compared = 0
    for answer in answers(oracle, name):
        here = checkers.of(answer["file"])
        file = str(root / answer["file"])
        if {package for package in answer["finds"] if here.packages.find(package, file) is None} - set(answer["missing_packages"]):
            continue
        compared += 1
        evaluation, error = here.model(EntryRequest(file, file, tuple((answer.get("guessed_args") or {}).items())))
        ours = json.loads(json.dumps(as_object(evaluation.launch, file, error), default=str))
        if ours["verdict"] != answer["verdict"]:
            different.append(f"{answer['file']}: roslaunch {answer['verdict']}, launchlint {ours['verdict']} {error}")
        for part in agree.PARTS if ours["verdict"] == answer["verdict"] == "ok" else ():
            theirs, mine = agree.canonical(answer, part, str(root)), agree.canonical(ours, part, str(root))
            if theirs != mine:
                different.append(f"{answer['file']}: {agree.first_difference(theirs, mine, part)}")
    assert different == []
    assert compared > 400


def told_of(here: EntryChecker, result: EntryResult) -> tuple[Finding, ...]:
    return merge([result], here.options, here.packages, NONE_IGNORED, workspace=False, alone=True).findings


@pytest.mark.corpus
def test_every_mistake_that_roslaunch_refuses_or_reports_is_told(corpus: Path, oracle: Path) -> None:
    """Mutants whose original already fails here are left out: it needs packages of repositories outside the corpus."""
    mutants = corpus / "mutants"
    verdicts = {item["id"]: item for item in map(json.loads, (mutants / "verdicts.jsonl").read_text(encoding="utf-8").splitlines())}
    index = [json.loads(line) for line in (mutants / "index.jsonl").read_text(encoding="utf-8").splitlines()][::EVERY_MUTANT]
    checkers = Checkers(corpus / "ros1")
    untold: list[str] = []
    told = 0
    for mutant in sorted(index, key=lambda item: str(item["original"])):
        verdict = verdicts[mutant["id"]]
        if verdict["outcome"] not in ("rejected", "warned") or mutant["class"] == "control":
            continue
        here = checkers.of(mutant["original"])
        original = str(corpus / "ros1" / mutant["original"])
        given = tuple((mutant.get("args") or verdict.get("guessed_args") or {}).items())
        before = here.check(EntryRequest(original, original, given))
        if before.verdict == "error":
            continue
        after = here.check(EntryRequest(str(mutants / Path(mutant["file"]).relative_to("mutants")), original, given))
        had, has = (Counter((finding.rule, finding.severity) for finding in told_of(here, each)) for each in (before, after))
        if any(severity >= Severity.WARNING for _, severity in has - had):
            told += 1
        else:
            untold.append(mutant["id"])
    assert untold == []
    assert told > 150
