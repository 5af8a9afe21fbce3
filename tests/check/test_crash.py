"""A crash inside one rule (or anywhere) is a finding that names it; everything else goes on, and the exit status is 2."""

from __future__ import annotations

import json
from collections.abc import Callable, Mapping
from pathlib import Path

from tests.cli.running import CLEAN, DOUBLE, UNUSED, Ran, run_program

Make = Callable[[Mapping[str, str]], Path]

BREAK_A_RULE = """
import launchlint.rules.args.unused_arg as rule
def check(view):
    if view.document.source.path.endswith("unused.launch"):
        raise ZeroDivisionError("on purpose" + "!" * 5000 + "\\x1b")
    return ()
rule.check = check
"""
BREAK_THE_EVALUATION = """
import launchlint.check.entry as entry
real = entry.configurations
def configurations(session, file, given=()):
    if file.endswith("unused.launch"):
        raise MemoryError
    return real(session, file, given)
entry.configurations = configurations
"""


def run_broken(directory: Path, breakage: str, *words: str) -> Ran:
    """``launchlint WORDS`` after ``breakage`` has been done to it."""
    program = f"import sys\n{breakage}\nfrom launchlint.cli import main\nmain(sys.argv[1:])\n"
    return run_program(directory, program, *words, cache=directory.parent / "cache")


def files(make: Make) -> Path:
    return make({"clean.launch": CLEAN, "double.launch": DOUBLE, "unused.launch": UNUSED})


def test_a_crash_in_a_rule(make: Make) -> None:
    ran = run_broken(files(make), BREAK_A_RULE, "check")
    assert (ran.status, ran.errors) == (2, "")
    first, second = ran.output.split("\n\n")[:2]
    assert first.startswith("double.launch:3:15: error LL301 duplicate-node-name: ")
    line, *rest = second.splitlines()
    assert line.startswith(
        "unused.launch:1:1: error LL000 internal-error: rule LL206 unused-arg crashed on this file: ZeroDivisionError: on purpose!"
    )
    assert len(line) < 1500
    assert line.isprintable()
    assert rest == [
        "   = in check, line 6; everything else went on",
        "   = help: please report this, with the launch file if you can share it",
    ]


def test_a_crash_in_the_evaluation(make: Make) -> None:
    ran = run_broken(files(make), BREAK_THE_EVALUATION, "check", "--format", "concise")
    assert (ran.status, ran.errors) == (2, "")
    assert ran.output == (
        "double.launch:3:15: error LL301 duplicate-node-name: two nodes are named /talker\n"
        "unused.launch:1:1: error LL000 internal-error: the evaluation crashed on this file: MemoryError: \n"
    )


def test_it_counts_whatever_people_switch_off(make: Make) -> None:
    directory = files(make)
    text = (directory / "unused.launch").read_text()
    (directory / "unused.launch").write_text(f"<!-- launchlint: ignore-file meant -->\n{text}")
    (directory / ".launchlint.yaml").write_text("per-file-ignores: {'*.launch': [all]}\n")
    for words in (["--exit-zero"], ["-q"], ["--ignore", "LL301"]):
        assert run_broken(directory, BREAK_A_RULE, "check", *words).status == 2, words
    assert "LL000" in run_broken(directory, BREAK_A_RULE, "check", "--format", "concise").output


def test_a_baseline_never_knows_it(make: Make) -> None:
    directory = files(make)
    written = run_broken(directory, BREAK_A_RULE, "check", "--write-baseline", "known.json")
    assert (written.status, "LL000" in (directory / "known.json").read_text()) == (2, False)
    after = run_broken(directory, BREAK_A_RULE, "check", "--baseline", "known.json", "--format", "json")
    assert (after.status, [each["rule"] for each in json.loads(after.output)["findings"]]) == (2, ["LL000"])


def test_sarif_says_that_the_run_failed(make: Make) -> None:
    sarif = json.loads(run_broken(files(make), BREAK_A_RULE, "check", "--format", "sarif").output)
    assert sarif["runs"][0]["invocations"][0]["executionSuccessful"] is False


def test_a_crash_is_not_kept_in_the_cache(make: Make) -> None:
    directory = files(make)
    for number in range(30):
        (directory / f"more{number}.launch").write_text(CLEAN)
    assert run_broken(directory, BREAK_THE_EVALUATION, "check", "-q").status == 2
    mended = run_broken(directory, "", "check", "--format", "concise")
    assert (mended.status, "LL000" in mended.output, "LL206" in mended.output) == (1, False, True)
