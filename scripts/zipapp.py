"""Put launchlint and all it needs into one file that runs without installation and without a network: scripts/zipapp.py WHEEL TARGET.

The file fits the Python and the platform that it is made with (lxml, PyYAML and tree-sitter are compiled). shiv does the work; it is
installed into a temporary environment.
"""

from __future__ import annotations

import os
import subprocess
import sys
import tempfile
from pathlib import Path


def main(words: list[str]) -> int:
    """Make TARGET of WHEEL. Returns the exit status."""
    if len(words) != 2:
        print("usage: scripts/zipapp.py WHEEL TARGET", file=sys.stderr)
        return 2
    wheel, target = Path(words[0]).resolve(), Path(words[1]).resolve()
    target.parent.mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory() as directory:
        environment = Path(directory, "venv")
        subprocess.run([sys.executable, "-m", "venv", environment], check=True)
        python = environment / "bin/python"
        subprocess.run([python, "-m", "pip", "install", "--quiet", "--disable-pip-version-check", "shiv>=1.0.4", "setuptools"], check=True)
        subprocess.run(
            [
                python, "-m", "shiv", "--console-script", "launchlint", "--output-file", target, "--reproducible", "--compressed",
                "--python", "/usr/bin/env python3", "--quiet", str(wheel),
            ],
            check=True,
            env={**os.environ, "SOURCE_DATE_EPOCH": os.environ.get("SOURCE_DATE_EPOCH", "315532800")},
        )  # fmt: skip
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
