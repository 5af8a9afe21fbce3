"""Real editors, those of Debian 12, as clients: a finding is seen, a fix made, an arg renamed through an include, a topic completed."""

from __future__ import annotations

import json
import os
import re
import subprocess
import sys
from pathlib import Path
from typing import Any

import pytest

from tests.server.workspace import make

ROOT = Path(__file__).resolve().parent.parent.parent
SCRIPTS = Path(__file__).resolve().parent / "editors"


def settings(language: str) -> str:
    """The first snippet of docs/editors.md in a language of settings."""
    found = re.search(rf"^```{language}\n(.*?)^```$", (ROOT / "docs" / "editors.md").read_text(encoding="utf-8"), re.MULTILINE | re.DOTALL)
    assert found is not None
    return found[1]


def session(command: list[str], language: str, directory: Path) -> dict[str, Any]:
    """What the script of an editor says came of its session."""
    root = make(directory / "ws")
    environment = {
        **os.environ, "PATH": f"{Path(sys.executable).parent}:{os.environ['PATH']}", "PYTHONPATH": str(ROOT), "WORKSPACE": str(root),
        "HOME": str(directory), "XDG_CACHE_HOME": str(directory / "cache"), "SETTINGS": settings(language),
    }  # fmt: skip
    run = subprocess.run(command, cwd=root, env=environment, capture_output=True, text=True, timeout=300, check=False)
    lines = [line for line in run.stdout.splitlines() if line.startswith("{")]
    assert lines, run.stdout + run.stderr
    found: dict[str, Any] = json.loads(lines[-1])
    assert "problem" not in found, found["problem"]
    return found


def holds(found: dict[str, Any]) -> None:
    """The session went as it should."""
    assert "/turtle1/pose" in found["hover"]
    assert '  <arg name="hertz"/>' in found["renamed"]
    assert any("$(arg hertz)" in line for line in found["renamed"])
    assert "/turtle1/pose" in found["completed"]


@pytest.mark.neovim
def test_neovim(neovim: str, tmp_path: Path) -> None:
    found = session([neovim, "--headless", "-u", "NONE", "-n", "-c", f"luafile {SCRIPTS / 'neovim.lua'}"], "lua", tmp_path)
    assert found["diagnostics"] == ["LL206:2", "LL301:9"]
    assert found["after_fix"] == ["LL301:8"]
    holds(found)


@pytest.mark.emacs
def test_emacs(emacs: str, tmp_path: Path) -> None:
    found = session([emacs, "--batch", "-l", str(SCRIPTS / "emacs.el")], "elisp", tmp_path)
    assert len(found["diagnostics"]) == 2
    assert len(found["after_fix"]) == 1
    holds(found)
