"""Repositories for the pipeline to work on."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from pathlib import Path

import pytest

from tests.cli.running import PACKAGE, write


@pytest.fixture
def make(tmp_path: Path) -> Callable[[Mapping[str, str]], Path]:
    """A function that writes files into a repository with one package (``demo``, executable ``talk.py``) and returns its directory."""

    def build(files: Mapping[str, str]) -> Path:
        directory = tmp_path / "repository"
        standing = {".git/HEAD": "", "demo/package.xml": PACKAGE.format(name="demo"), "demo/scripts/talk.py": "#!/usr/bin/env python3\n"}
        write(directory, {**standing, **files})
        return directory

    return build
