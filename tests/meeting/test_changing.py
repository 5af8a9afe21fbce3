"""A file that somebody else changes or removes while a run is on: no crash, no wrong answer kept, and nobody's text is lost."""

from __future__ import annotations

import json
import subprocess
import sys
from pathlib import Path

import pytest

from launchlint.check.file import INTERNAL_ERROR
from tests.cli.running import clean_environment
from tests.meeting.meddling import OTHER
from tests.meeting.workspaces import make

pytestmark = pytest.mark.slow

ENTRY = "demo/launch/entry00.launch"
PART = "demo/launch/part.launch"
CHANGES = [
    (ENTRY, "vanish"),
    (ENTRY, "text"),
    (PART, "text"),
    (PART, "directory"),
    ("demo/package.xml", "vanish"),
    ("demo/scripts/talk.py", "vanish"),
]


def runs(tmp_path: Path, file: str, change: str, *words: str, warm: bool = False) -> list[dict[str, object]]:
    """What :mod:`.meddling` tells of every moment."""
    make(tmp_path / "repository")
    command = [sys.executable, "-m", "tests.meeting.meddling", *(["warm"] if warm else []), str(tmp_path), file, change, *words]
    done = subprocess.run(command, env=clean_environment(tmp_path / "cache"), capture_output=True, text=True, timeout=600, check=False)
    assert (done.returncode, done.stderr) == (0, "")
    found = [json.loads(line) for line in done.stdout.splitlines()]
    # The last run ended before its moment came; in all others somebody meddled.
    assert len(found) > 4
    assert [each["happened"] for each in found] == [True] * (len(found) - 1) + [False]
    return found[:-1]


@pytest.mark.parametrize(("file", "change"), CHANGES)
def test_a_check_goes_on_and_keeps_nothing_wrong(file: str, change: str, tmp_path: Path) -> None:
    for moment, each in enumerate(runs(tmp_path, file, change, "check", "--jobs", "1", ".")):
        said = str(each["said"])
        assert each["status"] in (0, 1), (moment, said)
        assert "itself failed" not in said, (moment, said)
        assert INTERNAL_ERROR not in said, (moment, said)
        assert each["again"] == each["anew"], moment


@pytest.mark.parametrize(
    ("file", "change"), [(ENTRY, "text"), (PART, "text"), ("demo/package.xml", "vanish"), ("demo/scripts/talk.py", "vanish")]
)
def test_what_an_earlier_run_has_kept_stays_true(file: str, change: str, tmp_path: Path) -> None:
    for moment, each in enumerate(runs(tmp_path, file, change, "check", "--jobs", "1", ".", warm=True)):
        said = str(each["said"])
        assert each["status"] in (0, 1), (moment, said)
        assert "itself failed" not in said, (moment, said)
        assert INTERNAL_ERROR not in said, (moment, said)
        assert each["again"] == each["anew"], moment


@pytest.mark.parametrize("words", [("check", "--fix", "--jobs", "1", "."), ("format", ".")], ids=["fix", "format"])
def test_what_somebody_else_wrote_is_not_written_over(words: tuple[str, ...], tmp_path: Path) -> None:
    for moment, each in enumerate(runs(tmp_path, ENTRY, "text", *words)):
        assert each["holds"] in (OTHER, OTHER.replace("reqiured", "required")), (moment, each["said"])
        assert "itself failed" not in str(each["said"]), (moment, each["said"])
        assert each["again"] == each["anew"], moment


@pytest.mark.parametrize("words", [("check", "--fix", "--jobs", "1", "."), ("format", "."), ("report", ".", "-o", "page.html")])
def test_a_file_that_is_gone_is_not_written_again(words: tuple[str, ...], tmp_path: Path) -> None:
    for moment, each in enumerate(runs(tmp_path, ENTRY, "vanish", *words)):
        assert each["holds"] is None, (moment, each["said"])
        left = "is left as it is" in str(each["said"])
        assert not left or "fixed 2 findings in 2 files" in str(each["said"]) or words[0] != "check", (moment, each["said"])
        assert "itself failed" not in str(each["said"]), (moment, each["said"])
        assert each["again"] == each["anew"], moment
