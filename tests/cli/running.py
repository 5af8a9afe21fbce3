"""The command line as a user runs it: a process of its own, with nothing of this machine's ROS around it."""

from __future__ import annotations

import os
import subprocess
import sys
from collections.abc import Mapping
from pathlib import Path
from typing import NamedTuple

from tests.cli.forking import LONGEST, forks

ROOT = Path(__file__).resolve().parents[2]
FOREIGN = ("ROS_", "CMAKE_", "XDG_", "NO_COLOR", "FORCE_COLOR", "LAUNCHLINT", "COLUMNS", "PYTHON")
AT_START = ("PYTHON", "LC_", "LANG")
"""Variables that count while Python starts."""

CLEAN = '<launch>\n  <node name="talker" pkg="demo" type="talk.py"/>\n</launch>\n'
DOUBLE = '<launch>\n  <node name="talker" pkg="demo" type="talk.py"/>\n  <node name="talker" pkg="demo" type="talk.py"/>\n</launch>\n'
UNUSED = '<launch>\n  <arg name="speed" default="1"/>\n  <node name="talker" pkg="demo" type="talk.py"/>\n</launch>\n'
PACKAGE = (
    '<package format="2"><name>{name}</name><version>1.0.0</version><description>A demo.</description>'
    '<maintainer email="a@example.com">A</maintainer><license>MIT</license></package>\n'
)


class Ran(NamedTuple):
    """How a run ended."""

    status: int
    output: str
    errors: str


def clean_environment(cache: Path, **variables: str) -> dict[str, str]:
    """The environment of this process without what changes findings or their looks."""
    kept = {name: value for name, value in os.environ.items() if not name.startswith(FOREIGN)}
    return {**kept, "PYTHONPATH": str(ROOT), "XDG_CACHE_HOME": str(cache), "COLUMNS": "120", **variables}


def run(directory: Path, *words: str, stdin: str | bytes = "", environment: Mapping[str, str] | None = None) -> Ran:
    """Run ``launchlint WORDS`` in ``directory``."""
    data = stdin.encode() if isinstance(stdin, str) else stdin
    variables = clean_environment(directory.parent / f"{directory.name}-cache", **(environment or {}))
    if any(name.startswith(AT_START) for name in environment or {}):
        done = subprocess.run(
            [sys.executable, "-m", "launchlint", *words],
            cwd=directory,
            env=variables,
            input=data,
            capture_output=True,
            timeout=LONGEST,
            check=False,
        )
        return Ran(done.returncode, done.stdout.decode(), done.stderr.decode())
    status, output, errors = forks().run(directory, words, variables, data)
    return Ran(status, output.decode(), errors.decode())


def run_program(directory: Path, program: str, *words: str, cache: Path) -> Ran:
    """Run a ``program`` in Python that does something to launchlint, and then runs it with ``words``, in ``directory``."""
    status, output, errors = forks().run(directory, words, clean_environment(cache), program=program)
    return Ran(status, output.decode(), errors.decode())


def write(directory: Path, files: Mapping[str, str]) -> None:
    """Write text files below ``directory``; those whose name ends with ``.py`` may be executed."""
    for name, text in files.items():
        file = directory / name
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(text, encoding="utf-8")
        if name.endswith(".py"):
            file.chmod(0o755)
