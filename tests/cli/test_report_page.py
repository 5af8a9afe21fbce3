"""docs/report.md is true: its command prints what it shows, and its options are those of the command."""

from __future__ import annotations

import re
import shlex
from pathlib import Path

from tests.cli.running import run

ROOT = Path(__file__).resolve().parents[2]
PAGE = (ROOT / "docs" / "report.md").read_text(encoding="utf-8")
OPTION = r"(?<![\w-])(--[a-z][a-z-]+|-o|-q)(?![\w-])"


def test_the_command_prints_what_the_page_shows(tmp_path: Path) -> None:
    ((command, output),) = re.findall(r"^```console\n\$ launchlint (.*)\n([^`]*)^```$", PAGE, re.MULTILINE)
    (tmp_path / "work").mkdir()
    (tmp_path / "work" / "examples").symlink_to(ROOT / "examples")
    assert run(tmp_path / "work", *shlex.split(command)) == (0, "", output)
    assert (tmp_path / "work" / "report.html").is_file()


def test_the_page_names_every_option_and_no_other(tmp_path: Path) -> None:
    usage = run(tmp_path, "report", "--help").output
    options = set(re.findall(r"^  (?:-\w, )?(--[a-z-]+)", usage, re.MULTILINE)) | set(re.findall(r"^  (-\w)\b", usage, re.MULTILINE))
    named = set(re.findall(OPTION, PAGE))
    assert sorted(named - options) == []
    assert sorted(options - named - {"--output", "--quiet", "--help", "-h", "-q"}) == []
