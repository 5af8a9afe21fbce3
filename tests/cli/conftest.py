"""A small repository for the command line to work on."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.cli.running import CLEAN, DOUBLE, PACKAGE, UNUSED, write


@pytest.fixture
def repository(tmp_path: Path) -> Path:
    """A repository with one package, and launch files that are clean, wrong, and doubtful."""
    directory = tmp_path / "repository"
    write(
        directory,
        {
            ".git/HEAD": "ref: refs/heads/main\n",
            "demo/package.xml": PACKAGE.format(name="demo"),
            "demo/scripts/talk.py": "#!/usr/bin/env python3\n",
            "demo/launch/clean.launch": CLEAN,
            "demo/launch/double.launch": DOUBLE,
            "demo/launch/unused.launch": UNUSED,
        },
    )
    return directory
