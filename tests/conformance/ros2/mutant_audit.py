"""Launch files with one mistake each: what the real front ends make of them, and what launchlint says.

``python -m tests.conformance.ros2.mutant_audit CORPUS [--count N] [--seed N] [--only KIND,KIND] [--json OUT] [--record OUT]``.
``CORPUS`` has one directory per repository; :mod:`.front_end` says what else must be there. Of each mutant the front ends say whether it
is *refused*, loads but starts *something else* than the file without the mistake, or *the same*. A refused mutant must be told at level
error, near what was changed, by a rule for that kind of refusal; of the others it is counted how many are told at warning or above.
"""

from __future__ import annotations

import argparse
import collections
import json
import os
import subprocess
import sys
import tempfile
from collections.abc import Iterator, Sequence
from pathlib import Path
from random import Random
from typing import Any, NamedTuple

from tests.conformance.ros2 import mistakes, structure_mistakes
from tests.conformance.ros2.elements import read
from tests.conformance.ros2.front_end import WHY_NOT, Answer, FrontEnd, Question, front_end
from tests.conformance.ros2.mutations import KINDS, Mutant, mutants

RULES = {
    "xml": "101", "ParserError": "101", "ScannerError": "101", "ComposerError": "101", "ReaderError": "101", "root": "102",
    "unknown_tag": "103 106 112", "unknown_child": "103 106 112", "unknown_attribute": "104 106 112",
    "missing_attribute": "104 105 110 112 933", "if_and_unless": "108", "value_type": "109 214 501 933 935", "ValueError": "109 501 935",
    "negative": "109 933", "output": "109 933", "on_exit": "109 933", "param_form": "110", "unknown_substitution": "112 207 934",
    "substitution_syntax": "207 934", "substitution_arity": "112 207 934 935", "var_undefined": "201 205", "required_arg": "202",
    "include_missing_arg": "202 404 912", "missing_file": "401 502", "recursion": "402", "condition": "214 923", "env": "209",
    "package": "106 210 303", "node_name": "302", "namespace": "302 314", "param_type": "501 907", "executed_twice": "929",
    "choice": "109",
}  # fmt: skip
"""Which rules are for which kind of refusal."""

FROM_OUTSIDE = ("env", "package", "var_undefined", "required_arg", "include_missing_arg")
"""Refusals that another machine or command line may not bring: a variable, a package that is not here, an arg. Told, not as an error."""
UNSEEN = ("LL303", "LL304", "LL904", "LL909", "LL947")
"""Errors that the front ends do not see here: programs are not looked for, and nodes that die when they start are not started."""
TOLERANCE = 2
"""How many lines beside the place a finding may stand."""
_SHARE_OF_YAML = 0.25


class Judged(NamedTuple):
    """A mutant, what the front end says of it, and what launchlint says."""

    group: str
    kind: str
    original: str
    mutant: Mutant
    outcome: str
    real: Answer
    verdict: str
    model: Answer
    findings: list[Answer]
    """Those that the file without the mistake has not."""

    @property
    def told(self) -> bool:
        """Whether launchlint tells of it at all, loud enough."""
        return any(self.is_told_by(finding) for finding in self.findings)

    @property
    def at_the_place(self) -> list[Answer]:
        """The findings near what was changed."""
        return [
            finding
            for finding in self.findings
            if any(first - TOLERANCE <= (finding.get("line") or 0) <= last + TOLERANCE for first, last in self.mutant.lines)
        ]

    @property
    def by_the_rule(self) -> bool:
        """Whether one of the rules for that kind of refusal tells it."""
        wanted = RULES.get(self.reason, "")
        return not wanted or any(finding["rule"][2:] in wanted for finding in self.findings if self.is_told_by(finding))

    @property
    def reason(self) -> str:
        """The kind of the refusal."""
        return str((self.real.get("error") or {}).get("kind", ""))

    @property
    def asks_outside(self) -> bool:
        """Whether what is missing may be given elsewhere, so that it is told as a warning or as information."""
        return self.outcome == "refused" and self.reason in FROM_OUTSIDE and not self.told_as_error

    @property
    def told_as_error(self) -> bool:
        """Whether anything is told at level error."""
        return any(finding["severity"] == "error" for finding in self.findings)

    def is_told_by(self, finding: Answer) -> bool:
        """Whether the level of a finding is enough."""
        if self.outcome == "refused":
            return finding["severity"] == "error" or self.asks_outside
        return finding["severity"] in ("error", "warning")

    @property
    def wrongly_refused(self) -> list[Answer]:
        """Errors of a file that loads, those left out that launch cannot see."""
        found = (each for each in self.findings if each["severity"] == "error" and each["rule"] not in UNSEEN)
        return [] if self.outcome == "refused" or self.real.get("deferred_errors") else list(found)


def launch_files(corpus: Path) -> list[str]:
    """The XML and YAML launch files of a corpus, relative to it; what begins with an underscore only stands in for something."""
    found = (path.relative_to(corpus) for path in corpus.rglob("*") if path.name.endswith((".launch.xml", ".launch.yaml", ".launch.yml")))
    return sorted(str(path) for path in found if not str(path).startswith("_"))


def loadable(real: FrontEnd, corpus: Path) -> dict[str, Answer]:
    """The launch files that load, with guessed args where they need some; those are kept in the answer as given."""
    answers = real.answers(corpus, [Question(file) for file in launch_files(corpus)], guess=True)
    return {
        answer["file"]: answer for answer in answers if answer["verdict"] == "ok" and " " not in "".join(arguments(answer, "").values())
    }


def arguments(answer: Answer, root: str) -> dict[str, str]:
    """The args with which a file was loaded."""
    both = {**(answer.get("given_args") or {}), **(answer.get("guessed_args") or {})}
    return {name: value.replace("$WS", root) for name, value in both.items()}


def draw(corpus: Path, files: Sequence[str], count: int, seed: int, only: Sequence[str] = ()) -> Iterator[tuple[str, str, str, Mutant]]:
    """``count`` mutants (group, kind, file, mutant), all kinds in turn."""
    random = Random(seed)
    documents = {}
    for file in files:
        documents[file] = read((corpus / file).read_text("utf-8"), file)
    of_yaml = [file for file in documents if documents[file].yaml]
    kinds = [each for each in KINDS if not only or each.name in only]
    seen: set[tuple[str, str]] = set()
    made = 0
    for _ in range(count):
        for each in kinds:
            for _ in range(40):
                yaml = of_yaml and (each.dialect == "yaml" or (not each.dialect and random.random() < _SHARE_OF_YAML))
                file = random.choice(of_yaml if yaml else list(documents))
                mutant = next(mutants(documents[file], each, random), None)
                if mutant is not None and (file, mutant.text) not in seen:
                    seen.add((file, mutant.text))
                    yield each.group, each.name, file, mutant
                    made += 1
                    break
            if made == count:
                return


def judge(real: FrontEnd, corpus: Path, count: int, seed: int, only: Sequence[str], launchlint: Sequence[str]) -> list[Judged]:
    """Draws mutants and has all sides look at them. While this runs, they stand beside their originals in ``corpus``."""
    originals = loadable(real, corpus)
    drawn = list(draw(corpus, list(originals), count, seed, only))
    beside = [os.path.join(os.path.dirname(file), f"mutant{n}_{os.path.basename(file)}") for n, (_, _, file, _) in enumerate(drawn)]
    given = [arguments(originals[file], str(corpus)) for _, _, file, _ in drawn]
    try:
        for name, (_, _, _, mutant) in zip(beside, drawn, strict=True):
            (corpus / name).write_text(mutant.text, "utf-8")
        answers = real.answers(corpus, [Question(name, args) for name, args in zip(beside, given, strict=True)])
        entries = [{"file": str(corpus / name), "args": args} for name, args in zip(beside, given, strict=True)]
        models = _asked(real, launchlint, corpus, beside, "model", entries)
    finally:
        for name in beside:
            (corpus / name).unlink(missing_ok=True)
    with tempfile.TemporaryDirectory() as directory:
        entries = []
        for name, (_, _, file, mutant), args in zip(beside, drawn, given, strict=True):
            apart = Path(directory, os.path.basename(name))
            apart.write_text(mutant.text, "utf-8")
            entries.append({"file": str(apart), "as": str(corpus / file), "args": args})
        checks = _asked(real, launchlint, corpus, beside, "check", entries)
        files = sorted({file for _, _, file, _ in drawn})
        whole = [{"file": str(corpus / file), "args": arguments(originals[file], str(corpus))} for file in files]
        clean = dict(zip(files, _asked(real, launchlint, corpus, files, "check", whole), strict=True))
    judged = []
    for name, (group, each, file, mutant), answer, model, check in zip(beside, drawn, answers, models, checks, strict=True):
        answer = json.loads(json.dumps(answer).replace(os.path.basename(name), os.path.basename(file)))
        outcome = "refused" if answer["verdict"] != "ok" else "same" if not real.difference(corpus, originals[file], answer) else "changed"
        model = json.loads(json.dumps(model).replace(os.path.basename(name), os.path.basename(file)))
        findings = new_findings(check["findings"], clean[file]["findings"])
        judged.append(Judged(group, each, file, mutant, outcome, answer, check["verdict"], model, findings))
    return judged


def _asked(real: FrontEnd, launchlint: Sequence[str], corpus: Path, files: Sequence[str], command: str, entries: list[Any]) -> list[Any]:
    """What launchlint answers for each entry, repository by repository."""
    by_repository: dict[str, list[int]] = {}
    for index, file in enumerate(files):
        by_repository.setdefault(file.split("/")[0], []).append(index)
    found: dict[int, Any] = {}
    for repository, indices in by_repository.items():
        with tempfile.NamedTemporaryFile("w", suffix=".json") as listed:
            json.dump([entries[index] for index in indices], listed)
            listed.flush()
            options = ["--format", "jsonl", "--workspace", str(corpus / repository), "--workspace", str(corpus), "--entries", listed.name]
            options += ["--exit-zero", "--no-cache"] if command == "check" else []
            environment = {**real.environment(), "PATH": os.environ["PATH"], "PYTHONPATH": os.environ.get("PYTHONPATH", "")}
            run = subprocess.run([*launchlint, command, *options], env=environment, capture_output=True, text=True, check=False)
        lines = run.stdout.splitlines()
        if len(lines) != len(indices):
            raise SystemExit(f"launchlint {command} of {repository}: {len(lines)} answers for {len(indices)} files\n{run.stderr[-2000:]}")
        found.update(zip(indices, map(json.loads, lines), strict=True))
    return [found[index] for index in range(len(files))]


def new_findings(findings: list[Answer], before: list[Answer]) -> list[Answer]:
    """The findings of a file that are not among those of the file ``before`` it was changed, wherever they stand."""
    had = collections.Counter((each["rule"], each["severity"], each["message"]) for each in before)
    found = []
    for each in findings:
        key = (each["rule"], each["severity"], each["message"])
        if had[key]:
            had[key] -= 1
        else:
            found.append(each)
    return found


def report(judged: Sequence[Judged], real: FrontEnd, corpus: Path, show: int) -> Iterator[str]:
    """The numbers, and what is missed."""
    rows: dict[str, collections.Counter[str]] = {}
    for each in judged:
        for name in (each.group, "all"):
            row = rows.setdefault(name, collections.Counter())
            row["n"] += 1
            row[each.outcome] += 1
            row[f"{each.outcome} told"] += each.told
            row["placed"] += each.outcome == "refused" and any(each.is_told_by(finding) for finding in each.at_the_place)
            row["outside"] += each.asks_outside
            row["ruled"] += each.outcome == "refused" and each.by_the_rule
            row["verdict"] += (each.outcome == "refused") == (each.verdict == "error")
            row["model"] += not real.difference(corpus, each.real, each.model)
    columns = (
        "n",
        "refused",
        "refused told",
        "outside",
        "placed",
        "ruled",
        "changed",
        "changed told",
        "same",
        "same told",
        "verdict",
        "model",
    )
    yield f"{'':14}" + "".join(f"{column:>14}" for column in columns)
    for name in sorted(rows, key=lambda name: (name == "all", name)):
        yield f"{name:14}" + "".join(f"{rows[name][column]:14}" for column in columns)
    for each in judged:
        what = list(_missed(each, real, corpus))
        if what and show:
            show -= 1
            yield f"\n{each.group} {each.kind} {each.original} {each.mutant.lines}: {'; '.join(what)}"
            yield f"    launch: {each.outcome} {json.dumps(each.real.get('error'))}"
            for finding in each.findings:
                yield f"    {finding['severity']} {finding['rule']} line {finding['line']} {finding['message'][:200]}"


def _missed(each: Judged, real: FrontEnd, corpus: Path) -> Iterator[str]:
    if (each.outcome == "refused") != (each.verdict == "error"):
        yield f"verdict {each.verdict}"
    elif difference := real.difference(corpus, each.real, each.model):
        yield f"model {difference}"
    if each.outcome == "refused":
        if not each.told:
            yield "not told"
        elif not any(each.is_told_by(finding) for finding in each.at_the_place):
            yield "not at the place"
        if not each.by_the_rule:
            yield "another rule"
    elif each.outcome == "changed" and not each.told:
        yield "changed and not told"
    elif each.wrongly_refused:
        yield "error although it loads"


def main() -> int:
    """See the module."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("corpus", type=Path)
    parser.add_argument("--count", type=int, default=400)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--only", default="")
    parser.add_argument("--show", type=int, default=1000)
    parser.add_argument("--json", type=Path)
    parser.add_argument("--record", type=Path, help="write what a test holds launchlint against later, without the front ends")
    parser.add_argument("--launchlint", default=f"{sys.executable} -m launchlint")
    options = parser.parse_args()
    real = front_end()
    if real is None:
        raise SystemExit(WHY_NOT)
    only = tuple(options.only.split(",")) if options.only else ()
    corpus = options.corpus.resolve()
    judged = judge(real, corpus, options.count, options.seed, only, options.launchlint.split())
    print("\n".join(report(judged, real, corpus, options.show)))
    if options.json:
        keep = ("group", "kind", "original", "outcome", "verdict", "findings")
        rows = (
            {**{key: getattr(each, key) for key in keep}, "lines": each.mutant.lines, "error": each.real.get("error")} for each in judged
        )
        options.json.write_text("".join(json.dumps(row) + "\n" for row in rows), "utf-8")
    if options.record:
        options.record.write_text("[\n" + ",\n".join(json.dumps(recorded(each, corpus)) for each in judged) + "\n]\n", "utf-8")
    return 0


def recorded(each: Judged, corpus: Path) -> dict[str, Any]:
    """A mutant as what it changes in its original, with what the front end says of it."""
    before, after = (corpus / each.original).read_text("utf-8"), each.mutant.text
    start = _alike(before, after)
    rest = _alike(before[start:][::-1], after[start:][::-1])
    edit = {"at": [start, len(before) - rest], "text": after[start : len(after) - rest]}
    return {"kind": each.kind, "file": each.original, **edit, "lines": each.mutant.lines, "outcome": each.outcome, "reason": each.reason,
            "late": bool(each.real.get("deferred_errors"))}  # fmt: skip


def _alike(left: str, right: str) -> int:
    """How many characters both begin with."""
    return next((at for at, (one, other) in enumerate(zip(left, right, strict=False)) if one != other), min(len(left), len(right)))


assert structure_mistakes.__doc__
assert mistakes.__doc__  # importing it fills KINDS
if __name__ == "__main__":
    sys.exit(main())
