"""Public launch files through the formatter, and through the real roslaunch before and after; a sample of them."""

from __future__ import annotations

import json
import shutil
import subprocess
from collections.abc import Sequence
from pathlib import Path
from random import Random
from typing import Any

import pytest

from launchlint.fix.format.formatting import formatted
from launchlint.fix.format.style import Style
from launchlint.workspace.discovery import discover
from tests.evaluate.comparison import ENVIRONMENT, PEER, difference
from tests.fix.format.reading import canonical, held

REPOSITORIES = 12


def sample(corpus: Path) -> list[Path]:
    """Some repositories, the same ones in every run."""
    found = sorted(path for path in (corpus / "ros1").iterdir() if path.is_dir())
    return Random(5).sample(found, min(REPOSITORIES, len(found)))


@pytest.mark.corpus
def test_public_files_say_the_same_and_are_formatted_by_once(corpus: Path) -> None:
    wrong: list[str] = []
    for file in (Path(name) for repository in sample(corpus) for name in discover([str(repository)])):
        data = file.read_bytes()
        result = formatted(data, str(file), Style())
        if result.problem is not None:
            continue
        again = formatted(result.data, str(file), Style())
        if result.refusal or again.data != result.data:
            wrong.append(f"{file}: {result.refusal or 'another form the second time'}")
        elif held(data) != held(result.data) or canonical(data) != canonical(result.data):
            wrong.append(f"{file}: something is lost")
    assert wrong == []


@pytest.mark.corpus
@pytest.mark.ros
def test_public_files_mean_the_same_to_roslaunch(corpus: Path, ros_python: str, tmp_path: Path) -> None:
    wrong: list[str] = []
    for repository in sample(corpus)[:4]:
        copy = tmp_path / repository.name
        shutil.copytree(repository, copy)
        files = [Path(name) for name in discover([str(copy)])]
        before = loaded(files, copy, ros_python)
        for file in files:
            file.write_bytes(formatted(file.read_bytes(), str(file), Style()).data)
        after = loaded(files, copy, ros_python)
        wrong += [f"{file}: {found}" for file, *pair in zip(files, before, after, strict=True) if (found := difference(*pair))]
    assert wrong == []


def loaded(files: Sequence[Path], packages: Path, ros_python: str) -> list[dict[str, Any]]:
    """What the real roslaunch makes of each file, with the packages of its repository."""
    jobs = [
        {"file": str(file), "args": {}, "environment": ENVIRONMENT, "packages": str(packages), "directory": str(packages)} for file in files
    ]
    command = [ros_python, "-W", "ignore", str(PEER)]
    run = subprocess.run(command, input=json.dumps(jobs), capture_output=True, text=True, timeout=600, check=True)
    return [json.loads(line) for line in run.stdout.splitlines()]
