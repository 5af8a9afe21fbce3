"""The command line, run in this process in a directory, the same on every machine."""

from __future__ import annotations

import contextlib
import io
import os
import shlex
import subprocess
from collections.abc import Mapping
from pathlib import Path
from unittest import mock

from launchlint.cli import main

WIDTH = "120"
OPTIONS_FILE = "options.txt"
ENVIRONMENT_FILE = "environment.txt"


def check(directory: Path, *options: str, environment: Mapping[str, str] | None = None) -> tuple[int, str]:
    """Exit status and output of ``launchlint check OPTIONS`` in ``directory``, with no other environment than the one given.

    Packages are looked for in ``directory`` only (not in what is installed on this machine), unless the options name a workspace.
    """
    words = ["check", "--no-cache", *options]
    if not any(option.startswith("--workspace") for option in options):
        words += ["--workspace", "."]
    variables = {"PATH": os.environ.get("PATH", ""), "COLUMNS": WIDTH, "HOME": "/home/somebody", **(environment or {})}
    output = io.StringIO()
    before = os.getcwd()
    os.chdir(directory)
    try:
        with mock.patch.dict(os.environ, variables, clear=True), contextlib.redirect_stdout(output), contextlib.redirect_stderr(output):
            status = main(words, standalone_mode=False)
    finally:
        os.chdir(before)
    return status, output.getvalue()


def case_options(case: Path) -> list[str]:
    """The words of the case's ``options.txt``: further options, and the paths to check (default: ``.``)."""
    file = case / OPTIONS_FILE
    words = shlex.split(file.read_text(encoding="utf-8"), comments=True) if file.is_file() else []
    return words if any(not word.startswith("-") and (case / word).exists() for word in words) else [*words, "."]


def case_environment(case: Path) -> dict[str, str]:
    """The variables of the case's ``environment.txt``: lines ``NAME=value``."""
    file = case / ENVIRONMENT_FILE
    lines = file.read_text(encoding="utf-8").splitlines() if file.is_file() else []
    return dict(line.split("=", 1) for line in lines if "=" in line and not line.startswith("#"))


def commit(directory: Path) -> str:
    """Make a git repository of a directory, with one commit of all that is in it; its name."""
    git = ["git", "-C", str(directory), "-c", "user.name=t", "-c", "user.email=t@example.org", "-c", "commit.gpgsign=false"]
    for words in (["init", "-q"], ["add", "-A"], ["commit", "-q", "-m", "base"]):
        subprocess.run([*git, *words], check=True)
    return "HEAD"
