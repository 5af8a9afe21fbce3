"""scripts/bundled_library.py, on copies."""

from __future__ import annotations

import json
import subprocess
import sys
from pathlib import Path

import pytest

from tests.library.samples import executable, library, written


def script(directory: Path, *words: str) -> tuple[int, str]:
    """Exit status and output of the script, started in the directory."""
    file = Path(__file__).resolve().parents[2] / "scripts" / "bundled_library.py"
    done = subprocess.run(
        [sys.executable, str(file), "--directory", str(directory), *words], cwd=directory, capture_output=True, text=True, check=False
    )
    assert done.stderr == ""
    return done.returncode, done.stdout


@pytest.fixture
def directory(tmp_path: Path) -> Path:
    """A directory with two packages, not in canonical form, and without index."""
    written(tmp_path / "demo.json", library(demo={"nodelets": {"demo/A": executable(), "Plain": executable()}}))
    written(tmp_path / "tools.json", library(tools={"executables": {"b": executable(), "a": executable()}}))
    return tmp_path


def test_rewrite_then_check(directory: Path) -> None:
    assert script(directory, "--check") == (
        1,
        (
            "demo.json is not in canonical form\nindex.json is not in canonical form\ntools.json is not in canonical form\n"
            "run: python scripts/bundled_library.py\n"
        ),
    )
    before = {path.name: json.loads(path.read_text()) for path in directory.iterdir()}
    assert script(directory) == (0, ".: wrote 3 of 3 files\n")
    assert json.loads((directory / "index.json").read_text()) == {"nodelets": {"Plain": "demo"}}
    assert {path.name: json.loads(path.read_text()) for path in directory.iterdir() if path.name != "index.json"} == before
    assert script(directory, "--check") == (0, ".: 2 packages, all in canonical form, and the index\n")
    assert script(directory) == (0, ".: wrote 0 of 3 files\n")


def test_a_file_with_a_fault_is_left_alone(directory: Path) -> None:
    written(directory / "wrong.json", '{"format": "launchlint-library"}')
    written(directory / "misnamed.json", library(other={}))
    written(directory / "twice.json", library(twice={"nodelets": {"demo/A": executable()}}))
    before = (directory / "wrong.json").read_text()
    status, output = script(directory)
    assert (status, output.splitlines()) == (
        1,
        [
            "misnamed.json: it must hold the package misnamed, and holds other",
            "twice.json: the nodelet class demo/A is in demo.json already; only one can be right",
            'wrong.json:1:1: the library lacks the key "version"',
            'wrong.json:1:1: the library lacks the key "packages"',
            ".: wrote 4 of 4 files",
        ],
    )
    assert (directory / "wrong.json").read_text() == before
