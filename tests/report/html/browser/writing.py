"""How pages are written, and repositories made for them."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

GIT = ("git", "-c", "user.name=nobody", "-c", "user.email=nobody@example.org", "-c", "commit.gpgsign=false")


def write_report(directory: Path, page: Path, *words: str) -> None:
    """Write what ``launchlint report WORDS`` makes of a directory."""
    command = [sys.executable, "-m", "launchlint", "report", *words, "-o", str(page), "--quiet", "--jobs", "1"]
    environment = {key: value for key, value in os.environ.items() if not key.startswith(("GITHUB_", "ROS_"))}
    subprocess.run(command, cwd=directory, env=environment, check=True)


def commit(directory: Path) -> None:
    """Make the directory a repository with all that is in it."""
    for words in (("init", "--quiet"), ("add", "--all", "--force"), ("commit", "--quiet", "--message", "before")):
        subprocess.run([*GIT, *words], cwd=directory, check=True)
