"""docs/graph.md is true: its commands are run on its example, and what it shows is what they print.

`pytest tests/cli/test_graph_page.py --update` writes the real output into the page.
"""

from __future__ import annotations

import re
import shlex
import subprocess
from pathlib import Path

from tests.cli.running import run, write

PAGE = Path(__file__).resolve().parents[2] / "docs" / "graph.md"


def test_the_page_shows_what_is_printed(tmp_path: Path, update: bool) -> None:
    page = PAGE.read_text(encoding="utf-8")
    (example,) = re.findall(r"^```xml\n(.*?)^```$", page, re.MULTILINE | re.DOTALL)
    directory = tmp_path / "demo"
    write(directory, {"demo.launch": example})
    git = ["git", "-c", "user.name=t", "-c", "user.email=t@example.org"]
    for words in (["init", "-q"], ["add", "-A"], ["commit", "-q", "-m", "base"]):
        subprocess.run([*git, *words], cwd=directory, check=True)

    def real(block: re.Match[str]) -> str:
        lines = []
        for line in block[1].splitlines():
            if not line.startswith("$ "):
                continue
            lines.append(line)
            program, *words = shlex.split(line[2:])
            if program == "launchlint":
                ran = run(directory, *words)
                assert (ran.status, ran.errors) == (0, "")
                lines += ran.output.splitlines()
            else:
                subprocess.run([program, *words], cwd=directory, check=True)
        return "```console\n" + "\n".join(lines) + "\n```"

    true = re.sub(r"^```console\n(.*?)^```$", real, page, flags=re.MULTILINE | re.DOTALL)
    if update:
        PAGE.write_text(true, encoding="utf-8")
    assert page == true or update


def test_every_option_the_page_names_exists(tmp_path: Path) -> None:
    named = set(re.findall(r"(?<![\w-])--[a-z][a-z-]+", PAGE.read_text(encoding="utf-8")))
    helps = "".join(run(tmp_path, *words, "--help").output for words in (("graph",), ("graph", "diff"), ("check",), ("report",)))
    foreign = {"--depth"}
    assert sorted(named - foreign - set(re.findall(r"--[a-z][a-z-]+", helps))) == []
