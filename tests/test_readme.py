"""README.md is true: its commands are run, and what it shows is what they print.

`pytest tests/test_readme.py --update` writes the real output into README.md.
"""

from __future__ import annotations

import os
import re
import shlex
import subprocess
import sys
from pathlib import Path
from typing import NamedTuple

import pytest

README = Path(__file__).resolve().parent.parent / "README.md"
TOOL = ".venv/bin/launchlint"
CONSOLE = re.compile(r"^```console\n(.*?)^```$", re.MULTILINE | re.DOTALL)


class Shown(NamedTuple):
    """A command of the README and the output printed below it."""

    command: str
    output: str
    start: int
    end: int


def shown(text: str) -> list[Shown]:
    """Every `$ command` of the console blocks, with its output and where in ``text`` that stands."""
    found = []
    for block in CONSOLE.finditer(text):
        commands = list(re.finditer(r"^\$ (.*)\n", block[1], re.MULTILINE))
        ends = [*(command.start() for command in commands[1:]), len(block[1])]
        for command, end in zip(commands, ends, strict=True):
            start = block.start(1)
            found.append(Shown(command[1], block[1][command.end() : end], start + command.end(), start + end))
    return found


EXAMPLES = [entry for entry in shown(README.read_text(encoding="utf-8")) if entry.command.startswith(TOOL)]


def run(command: str) -> str:
    """What a person sees on the terminal's standard output, run in the root of this repository."""
    program = "import sys; from launchlint.cli import main; sys.argv[0] = 'launchlint'; main()"
    arguments = shlex.split(command)[1:]
    # A plain terminal without ROS: what the README shows must not depend on the machine it is read on.
    environment = {name: value for name, value in os.environ.items() if not name.startswith("ROS_") and name != "FORCE_COLOR"}
    result = subprocess.run(
        [sys.executable, "-c", program, *arguments],
        cwd=README.parent,
        env={**environment, "NO_COLOR": "1", "COLUMNS": "120"},
        capture_output=True,
        text=True,
        timeout=120,
        check=False,
    )
    assert result.returncode in (0, 1), result.stderr
    return result.stdout


@pytest.mark.parametrize("command", [example.command for example in EXAMPLES])
def test_readme_shows_what_the_tool_prints(command: str, update: bool) -> None:
    real = run(command)
    text = README.read_text(encoding="utf-8")
    example = next(entry for entry in shown(text) if entry.command == command)
    if update:
        README.write_text(text[: example.start] + real + text[example.end :], encoding="utf-8")
        return
    assert example.output == real


def test_readme_needs_two_commands_to_set_up_one_to_run_and_one_to_test() -> None:
    commands = [entry.command for entry in shown(README.read_text(encoding="utf-8"))]
    assert commands[:5] == [
        "python3 -m venv .venv",
        ".venv/bin/pip install -e '.[test]'",
        f"{TOOL} check examples/turtles/turtle_parade/launch/parade_broken.launch",
        f"{TOOL} check --distro jazzy examples/ferry/ferry_bringup/launch/ferry_broken.launch.xml",
        ".venv/bin/python -m pytest -n auto",
    ]


def test_every_file_the_readme_links_to_is_here() -> None:
    text = README.read_text(encoding="utf-8")
    links = [link for link in re.findall(r"\]\(([^)#]+)(?:#[^)]*)?\)", text) if "://" not in link]
    assert [link for link in links if not (README.parent / link).exists()] == []


def test_every_option_the_readme_names_exists() -> None:
    text = README.read_text(encoding="utf-8")
    named = set(re.findall(r"(?<![\w-])--[a-z][a-z-]+", text))
    helps = "".join(run(f"{TOOL} {command} --help") for command in ("", "check", "model", "graph", "export"))
    known = set(re.findall(r"--[a-z][a-z-]+", helps))
    assert sorted(named - known) == []


@pytest.mark.parametrize("file", ["turtles/turtle_parade/launch/parade.launch", "ferry/ferry_bringup/launch/ferry.launch.xml"])
def test_the_fixed_examples_are_clean(file: str) -> None:
    assert "LL" not in run(f"{TOOL} check -v examples/{file}")
