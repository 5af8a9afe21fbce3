"""What ``check --fix`` makes of files with one mistake each: is the mistake gone, and is the file what it was before the mistake?

``python -m tests.bench.fixes CORPUS ORACLE [--every N] [--unsafe]``. ``CORPUS`` holds ``ros1`` (public launch files) and ``mutants``
(copies of some of them with one mistake each, and ``index.jsonl``); ``ORACLE`` the programs ``oracle.py`` (the real roslaunch) and
``agree.py``. Only what the mistake brought is repaired. A line of the table is one rule: in how many mutants its fix was made and the
finding is gone; of those, how many files are the original again byte for byte, in how many others roslaunch starts the same as for the
original, and in how many not: because the mistake had added something that was not in the original (then that is there now, and is in
order), or else (these are listed); after how many an error or warning is found that was not there; how many fixes were taken back, and why.
"""

from __future__ import annotations

import argparse
import json
import os
import subprocess
import sys
import tempfile
from collections import Counter
from collections.abc import Iterable, Iterator, Mapping
from importlib import util
from pathlib import Path
from types import ModuleType
from typing import Any, NamedTuple

from launchlint.check.entry import EntryChecker
from launchlint.check.fixing import Fixed, Fixing
from launchlint.check.ignores import PerFileIgnores
from launchlint.check.merge import Outcome, merge
from launchlint.check.options import EntryRequest, Options
from launchlint.finding import Finding, Severity
from launchlint.rules.registry import RULES
from tests.bench.timing import ros_python

PACKAGE_VARIABLES = {
    "HOME": "/home/user",
    "USER": "user",
    "ROS_DISTRO": "noetic",
    "CMAKE_PREFIX_PATH": "",
    "PATH": os.environ.get("PATH", ""),
}
NONE_IGNORED = PerFileIgnores({}, "/", "/")


class Repair(NamedTuple):
    """What became of one mutant: ``texts`` are the original, the mutant and the mutant after its fixes."""

    mutant: Mapping[str, Any]
    fixed: Fixed
    left: tuple[Finding, ...]
    texts: tuple[bytes, bytes, bytes]

    @property
    def rules(self) -> list[str]:
        """The rules whose fixes were made."""
        return sorted({finding.rule for finding in self.fixed.made})

    @property
    def is_restored(self) -> bool:
        """Whether the file is the original again, byte for byte."""
        return self.texts[0] == self.texts[2]


def repairs(corpus: Path, *, every: int = 1, unsafe: bool = False) -> Iterator[Repair]:
    """Every ``every``-th mutant that had a finding with a fix, after its fixes."""
    index = [json.loads(line) for line in (corpus / "mutants" / "index.jsonl").read_text(encoding="utf-8").splitlines()][::every]
    verdicts = {
        item["id"]: item for item in map(json.loads, (corpus / "mutants" / "verdicts.jsonl").read_text(encoding="utf-8").splitlines())
    }
    repository, checker = "", None
    for mutant in sorted(index, key=lambda item: str(item["original"])):
        if checker is None or mutant["original"].split("/")[0] != repository:
            repository = mutant["original"].split("/")[0]
            checker = checker_for(corpus / "ros1", repository)
        given = tuple((mutant.get("args") or verdicts[mutant["id"]].get("guessed_args") or {}).items())
        repair = repaired(checker, corpus, mutant, given, unsafe=unsafe)
        if repair is not None and (repair.fixed.made or repair.fixed.refused):
            yield repair


def checker_for(root: Path, repository: str) -> EntryChecker:
    """A checker that sees the packages of one repository first, then all others."""
    rules = frozenset(rule.id for rule in RULES if rule.default)
    return EntryChecker(Options(rules, (str(root / repository), str(root)), True, PACKAGE_VARIABLES, str(root)))


def repaired(
    checker: EntryChecker, corpus: Path, mutant: Mapping[str, Any], given: tuple[tuple[str, str], ...], *, unsafe: bool
) -> Repair | None:
    """One mutant after the fixes of what the mistake brought, judged as if it stood in the original's place; None where it has none."""
    original = str(corpus / "ros1" / mutant["original"])
    request = EntryRequest(original, original, given)
    before, after = Path(original).read_bytes(), (corpus / mutant["file"]).read_bytes()
    mutated = checker.holding({original: after})
    if not any(finding.fix is not None and (unsafe or finding.fix.safe) for finding in told_of(mutated, request)):
        return None
    known = told_of(checker, request)

    def brought(outcome: Outcome) -> Outcome:
        return outcome._replace(findings=tuple(without(outcome.findings, known)))

    fixing = Fixing(
        mutated, [mutated.check(request)], NONE_IGNORED, asked=(), may_change=lambda file: file == original, told=brought, unsafe=unsafe
    )
    fixed = fixing.run()
    text = fixed.files[original][1] if original in fixed.files else after
    more = without(told_of(checker.holding({original: text}), request), told_of(mutated, request))
    left = tuple(finding for finding in more if finding.severity > Severity.INFO)
    return Repair(mutant, fixed, left, (before, after, text))


def told_of(checker: EntryChecker, request: EntryRequest) -> tuple[Finding, ...]:
    """The findings of one entry file by itself."""
    return merge([checker.check(request)], checker.options, checker.packages, NONE_IGNORED, workspace=False, alone=True).findings


def without(findings: Iterable[Finding], known: Iterable[Finding]) -> Iterator[Finding]:
    """The findings of which ``known`` has no equal left; places do not count."""
    left = Counter((finding.rule, finding.severity, finding.message) for finding in known)
    for finding in findings:
        key = (finding.rule, finding.severity, finding.message)
        if left[key]:
            left[key] -= 1
        else:
            yield finding


def module(path: Path) -> ModuleType:
    """The Python file ``path`` as a module."""
    spec = util.spec_from_file_location(path.stem, path)
    assert spec is not None
    assert spec.loader is not None
    loaded = util.module_from_spec(spec)
    spec.loader.exec_module(loaded)
    return loaded


def differences(found: Iterable[Repair], corpus: Path, oracle: Path) -> dict[str, str]:
    """For each repaired mutant that is not the original again: what roslaunch does differently, or the empty string."""
    interpreter = ros_python()
    if interpreter is None:
        raise SystemExit("no Python here can import roslaunch")
    others = [repair for repair in found if repair.fixed.made and not repair.is_restored]
    agree = module(oracle / "agree.py")
    root = str(corpus / "ros1")
    with tempfile.TemporaryDirectory(prefix="launchlint-fixes-") as scratch:
        lines: list[str] = []
        for number, repair in enumerate(others):
            for which, text in (("original", repair.texts[0]), ("fixed", repair.texts[2])):
                file = Path(scratch, f"{number}_{which}.launch")
                file.write_bytes(text)
                lines.append(f"{file}\t{root}/{repair.mutant['original']}")
        listed = Path(scratch, "list.txt")
        listed.write_text("\n".join(lines), encoding="utf-8")
        command = [
            interpreter,
            str(oracle / "oracle.py"),
            "--root",
            root,
            "--layout",
            "repos",
            "--guess-args",
            "--files-from",
            str(listed),
        ]
        answers = [json.loads(line) for line in subprocess.run(command, capture_output=True, text=True, check=True).stdout.splitlines()]
    result: dict[str, str] = {}
    for repair, before, after in zip(others, answers[::2], answers[1::2], strict=True):
        result[repair.mutant["id"]] = _difference(agree, before, after, root)
    return result


def _difference(agree: ModuleType, before: Mapping[str, Any], after: Mapping[str, Any], root: str) -> str:
    if before["verdict"] != after["verdict"]:
        message = (after.get("error") or before.get("error") or {}).get("message", "")
        return f"{before['verdict']} before, {after['verdict']} after: {message}"
    for part in agree.PARTS if before["verdict"] == "ok" else ():
        one, other = (agree.canonical(answer, part, root) for answer in (before, after))
        if one != other:
            return str(agree.first_difference(one, other, part))
    return ""


def outcome_of(repair: Repair, different: Mapping[str, str]) -> str:
    """What the repaired file is to the original: ``restored``, the ``same`` to roslaunch, with something ``added``, or ``different``."""
    if repair.is_restored:
        return "restored"
    if not different.get(repair.mutant["id"]):
        return "same"
    original, mutant, _ = repair.texts
    start = next((index for index, (one, other) in enumerate(zip(original, mutant, strict=False)) if one != other), len(original))
    return "added" if mutant.endswith(original[start:]) else "different"


def table(found: list[Repair], different: Mapping[str, str]) -> str:
    """The table, one line for each rule."""
    rows: dict[str, Counter[str]] = {}
    for repair in found:
        for rule in repair.rules:
            row = rows.setdefault(rule, Counter())
            row["made"] += 1
            row[outcome_of(repair, different)] += 1
            row["new"] += bool(repair.left)
        for rule in sorted({refused.finding.rule for refused in repair.fixed.refused}):
            rows.setdefault(rule, Counter())["taken back"] += 1
    columns = ("made", "restored", "same", "added", "different", "new", "taken back")
    lines = [f"{'rule':6}" + "".join(f"{column:>12}" for column in columns)]
    lines += [f"{rule:6}" + "".join(f"{rows[rule][column]:12}" for column in columns) for rule in sorted(rows)]
    total = Counter[str]()
    for row in rows.values():
        total.update(row)
    lines.append(f"{'all':6}" + "".join(f"{total[column]:12}" for column in columns))
    return "\n".join(lines)


def main() -> int:
    """Measure, print, and return the exit status: 1 where something new was found after a fix."""
    parser = argparse.ArgumentParser(description="Repair files with one mistake each and compare them with the originals.")
    parser.add_argument("corpus", type=Path)
    parser.add_argument("oracle", type=Path)
    parser.add_argument("--every", type=int, default=1, help="take only every n-th mutant")
    parser.add_argument("--unsafe", action="store_true", help="make the unsafe fixes too")
    arguments = parser.parse_args()
    corpus, oracle = arguments.corpus.resolve(), arguments.oracle.resolve()
    sys.path.insert(0, str(oracle))
    found = list(repairs(corpus, every=arguments.every, unsafe=arguments.unsafe))
    different = differences(found, corpus, oracle)
    print(table(found, different))
    for repair in found:
        name = repair.mutant["id"]
        if repair.fixed.made and outcome_of(repair, different) == "different":
            print(f"\n{name} ({', '.join(repair.rules)}): {different[name]}")
        for refused in repair.fixed.refused:
            message = "" if refused.finding.fix is None else refused.finding.fix.message
            print(f"\n{name}: {refused.finding.rule} ({message}) taken back: {refused.reason}")
        for finding in repair.left:
            print(f"\n{name}: NEW {finding.rule} {finding.message}")
    return int(any(repair.left for repair in found))


if __name__ == "__main__":
    sys.exit(main())
