"""The wheel in clean environments: every supported Python, the oldest dependencies, one file for machines without a network."""

from __future__ import annotations

import hashlib
import os
import re
import shutil
import subprocess
import sys
import zipfile
from functools import cache
from pathlib import Path

import pytest

from tests.cli.running import ROOT

PYTHONS = ("3.10", "3.11", "3.12", "3.13")
BROKEN = "turtle_parade/launch/parade_broken.launch"
TWICE = f"{BROKEN}:14:15: error LL301 duplicate-node-name: two nodes are named /sim2"

pytestmark = pytest.mark.pypi


@cache
def find_python(version: str) -> str | None:
    """An interpreter of this version: on the PATH, or of pyenv."""
    candidates = [shutil.which(f"python{version}")]
    candidates += [str(each) for each in sorted(Path.home().glob(f".pyenv/versions/{version}.*/bin/python"))]
    for candidate in filter(None, candidates):
        done = subprocess.run([candidate, "-c", "import venv, sys; print(sys.version)"], capture_output=True, text=True, check=False)
        if done.returncode == 0 and done.stdout.startswith(f"{version}."):
            return candidate
    return None


def environment(directory: Path) -> dict[str, str]:
    kept = {
        name: value for name, value in os.environ.items() if not name.startswith(("PYTHON", "ROS_", "XDG_", "LAUNCHLINT", "SOURCE_DATE"))
    }
    return {**kept, "XDG_CACHE_HOME": str(directory / "cache"), "SHIV_ROOT": str(directory / "shiv"), "NO_COLOR": "1"}


def run(words: list[str | Path], directory: Path) -> subprocess.CompletedProcess[str]:
    return subprocess.run(words, cwd=directory, env=environment(directory), capture_output=True, text=True, timeout=300, check=False)


def build(target: Path, *, epoch: str = "1700000000") -> Path:
    """The wheel and the source distribution of this checkout, built from a copy of what git would ship."""
    source = target / "source"
    listed = subprocess.run(
        ["git", "ls-files", "-z", "--cached", "--others", "--exclude-standard"], cwd=ROOT, capture_output=True, check=True
    )
    for name in filter(None, os.fsdecode(listed.stdout).split("\0")):
        if (ROOT / name).is_file():
            (source / name).parent.mkdir(parents=True, exist_ok=True)
            shutil.copyfile(ROOT / name, source / name)
    command = [sys.executable, "-m", "build", "--outdir", str(target / "dist"), str(source)]
    done = subprocess.run(
        command, env={**environment(target), "SOURCE_DATE_EPOCH": epoch}, capture_output=True, text=True, timeout=300, check=False
    )
    assert done.returncode == 0, done.stdout + done.stderr
    return target / "dist"


@pytest.fixture(scope="session")
def distributions(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return build(tmp_path_factory.mktemp("first"))


@pytest.fixture(scope="session")
def wheel(distributions: Path) -> Path:
    (found,) = distributions.glob("*.whl")
    return found


def installed(wheel: Path, python: str, directory: Path, *more: str) -> Path:
    """A virtual environment with the wheel and what ``more`` says to pip."""
    run([python, "-m", "venv", directory / "venv"], directory).check_returncode()
    done = run([directory / "venv/bin/python", "-m", "pip", "install", "--quiet", "--disable-pip-version-check", wheel, *more], directory)
    assert done.returncode == 0, done.stdout + done.stderr
    return directory / "venv/bin/launchlint"


def smoke(command: list[str | Path], directory: Path) -> None:
    """Every command once, on the bundled example."""
    shutil.copytree(ROOT / "examples/turtles/turtle_parade", directory / "turtle_parade")
    done = run([*command, "--version"], directory)
    assert re.fullmatch(r"launchlint, version \d+\.\d+\.\d+\n", done.stdout), done.stderr
    done = run([*command, "check", "--format", "concise", "--format", "sarif:out.sarif", BROKEN], directory)
    assert (done.returncode, TWICE in done.stdout.splitlines()) == (1, True), done.stdout + done.stderr
    good = "turtle_parade/launch/parade.launch"
    for words in (
        ["check", good],
        ["model", good],
        ["graph", good],
        ["graph", "--format", "graphml", good],
        ["format", "--check", good],
        ["export", "--flatten", good],
        ["report", "-o", "report.html", "turtle_parade"],
        ["explain", "LL301"],
        ["library", "show", "turtlesim"],
        ["extract", "turtle_parade", "-o", "library.json"],
        ["schema", "ros1"],
    ):
        done = run([*command, *words], directory)
        assert done.returncode == 0, (words, done.stdout, done.stderr)
    assert (directory / "report.html").stat().st_size > 100_000


@pytest.mark.parametrize("version", PYTHONS)
def test_every_supported_python(version: str, wheel: Path, tmp_path: Path) -> None:
    python = find_python(version)
    if python is None:
        pytest.skip(f"there is no Python {version} on this machine")
    smoke([installed(wheel, python, tmp_path)], tmp_path)


def test_the_oldest_dependencies(wheel: Path, tmp_path: Path) -> None:
    python = find_python("3.10")
    if python is None:
        pytest.skip("there is no Python 3.10 on this machine, which the oldest dependencies have wheels for")
    text = (ROOT / "pyproject.toml").read_text(encoding="utf-8")
    listed = text[text.index("\ndependencies = [") : text.index("\n]", text.index("\ndependencies = ["))]
    oldest = [f"{name}=={bound}" for name, bound in re.findall(r'"([\w-]+)>=([\d.]+)"', listed)]
    assert len(oldest) >= 7
    smoke([installed(wheel, python, tmp_path, *oldest)], tmp_path)


def test_the_build_is_reproducible(distributions: Path, tmp_path: Path) -> None:
    again = build(tmp_path / "a rather longer path")
    first, second = (
        {file.name: hashlib.sha256(file.read_bytes()).hexdigest() for file in sorted(built.iterdir())} for built in (distributions, again)
    )
    assert [Path(name).suffix for name in first] == [".whl", ".gz"]
    assert first == second


def test_one_file_for_machines_without_a_network(wheel: Path, tmp_path: Path) -> None:
    target = tmp_path / "launchlint.pyz"
    done = run([sys.executable, ROOT / "scripts/zipapp.py", wheel, target], tmp_path)
    assert done.returncode == 0, done.stdout + done.stderr
    assert zipfile.is_zipfile(target)
    smoke([sys.executable, "-I", target], tmp_path)
