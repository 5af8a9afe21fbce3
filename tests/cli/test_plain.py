"""What is read without click means what click makes of it; all else is left to click."""

from __future__ import annotations

import pytest

import launchlint.cli.check
import launchlint.cli.report
import launchlint.cli.reporting
from launchlint.cli.checking import CheckOptions
from launchlint.cli.plain import plain_check, plain_report
from launchlint.cli.reporting import ReportOptions
from launchlint.project.asked import EntryOptions

READ = (
    "",
    "a.launch",
    "a.launch b c/d.launch",
    "-q --verbose --no-cache a.launch --exit-zero --statistics",
    "--no-extract .",
    "--format json:out.json . --format=text --select LL3 --ignore=LL301,LL302 --ignore LL9 --severity LL301=info",
    "--jobs 2 --fail-on warning --jobs=4 --fail-on=info",
    "--baseline known.json --staged --changed",
)
LEFT = (
    "-",
    "-qv",
    "--help",
    "--formats json",
    "--format",
    "--format=",
    "--format --verbose",
    "--jobs -1",
    "--jobs many",
    "--jobs 1.5",
    "--verbose=yes",
    "-- a.launch",
    "--arg a:=1 a.launch",
    "--fix a.launch",
)


@pytest.mark.parametrize("words", READ)
def test_plain_options_are_what_click_makes_of_them(words: str, monkeypatch: pytest.MonkeyPatch) -> None:
    told: list[tuple[EntryOptions, CheckOptions]] = []
    monkeypatch.setattr(launchlint.cli.check, "run_check", lambda entry, given: told.append((entry, given)))
    launchlint.cli.check.command.main(words.split(), standalone_mode=False)
    plain = plain_check(words.split())
    assert plain is not None
    assert plain[1] == told[0][1]
    assert (plain[0].paths, plain[0].extract) == (told[0][0].paths, told[0][0].extract)


@pytest.mark.parametrize(
    "words",
    [
        "",
        "a.launch -o page.html",
        "-q --output=page.html --separate-assets --no-extract a b",
        "--picture a.svg --base HEAD~1 --title Robot --source-url https://example.org/x .",
        "--select LL3 --ignore=LL301 --ignore LL9 --severity LL301=info --fail-on error --jobs 2",
    ],
)
def test_plain_options_of_report_are_what_click_makes_of_them(words: str, monkeypatch: pytest.MonkeyPatch) -> None:
    told: list[tuple[EntryOptions, ReportOptions]] = []
    monkeypatch.setattr(launchlint.cli.reporting, "run_report", lambda entry, given: told.append((entry, given)))
    launchlint.cli.report.command.main(words.split(), standalone_mode=False)
    plain = plain_report(words.split())
    assert plain is not None
    assert plain[1] == told[0][1]
    assert (plain[0].paths, plain[0].extract) == (told[0][0].paths, told[0][0].extract)


@pytest.mark.parametrize("words", ["-o -", "-opage.html", "-o=page.html", "--arg a:=1 a.launch", "--help", "--jobs -1", "-o"])
def test_what_is_not_plain_of_report_is_left_to_click(words: str) -> None:
    assert plain_report(words.split()) is None


@pytest.mark.parametrize("words", LEFT)
def test_what_is_not_plain_is_left_to_click(words: str) -> None:
    assert plain_check(words.split()) is None
