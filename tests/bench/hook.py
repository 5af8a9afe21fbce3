"""The hook in a repository of N launch files, beside a hook that does nothing: what pre-commit itself costs.

``python -m tests.bench.hook [--files N] [--runs N]``
"""

from __future__ import annotations

import argparse
import os
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

from tests.bench.timing import by_turns, launchlint, milliseconds, table

PACKAGE = (
    '<package format="2"><name>demo</name><version>1.0.0</version><description>A demo.</description>'
    '<maintainer email="a@example.com">A</maintainer><license>MIT</license></package>\n'
)
LAUNCH = '<launch>\n  <node name="n{number}" pkg="demo" type="talk.py"/>\n</launch>\n'
HOOK = "      - {{id: {id}, name: {id}, entry: {entry}, language: system, pass_filenames: false, always_run: true}}\n"


def main() -> int:
    """Measure, print, and return the exit status."""
    parser = argparse.ArgumentParser(description="Time the warm hook against pre-commit's own overhead.")
    parser.add_argument("--files", type=int, default=10, help="launch files in the repository (default: 10)")
    parser.add_argument("--runs", type=int, default=10, help="counted runs of each command (default: 10)")
    arguments = parser.parse_args()
    with tempfile.TemporaryDirectory() as directory:
        repository = Path(directory, "robot")
        (repository / "launch").mkdir(parents=True)
        (repository / "package.xml").write_text(PACKAGE)
        (repository / "talk.py").write_text("#!/usr/bin/env python3\n")
        (repository / "talk.py").chmod(0o755)
        for number in range(arguments.files):
            (repository / f"launch/{number:05}.launch").write_text(LAUNCH.format(number=number))
        hooks = HOOK.format(id="nothing", entry="env true") + HOOK.format(id="launchlint", entry=" ".join(launchlint("check", "--staged")))
        (repository / ".pre-commit-config.yaml").write_text(f"repos:\n  - repo: local\n    hooks:\n{hooks}")
        for words in (["init", "-q"], ["add", "-A"], ["-c", "user.name=b", "-c", "user.email=b@example.org", "commit", "-qm", "all"]):
            subprocess.run(["git", *words], cwd=repository, check=True)
        os.environ["PRE_COMMIT_HOME"] = str(Path(directory, "home"))
        os.environ["XDG_CACHE_HOME"] = str(Path(directory, "cache"))
        pre_commit = [sys.executable, "-m", "pre_commit", "run", "--all-files"]
        os.chdir(repository)
        series = by_turns(
            {
                "pre-commit, a hook that does nothing": [*pre_commit, "nothing"],
                "pre-commit, launchlint": [*pre_commit, "launchlint"],
                "launchlint check --staged, alone": launchlint("check", "--staged"),
                "git ls-files --stage": [shutil.which("git") or "git", "ls-files", "--stage"],
            },
            arguments.runs,
        )
        print(f"{arguments.files} launch files, {arguments.runs} runs each")
        rows = [[name, milliseconds(each.median), milliseconds(min(each.seconds)), str(each.status)] for name, each in series.items()]
        print(table(("command", "median ms", "least ms", "status"), rows))
        os.chdir("/")
    return 0


if __name__ == "__main__":
    sys.exit(main())
