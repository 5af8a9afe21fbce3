"""The documented workflow: it is one that GitHub would run, and its commands do what they say."""

from __future__ import annotations

import shutil
import subprocess
import sys
from pathlib import Path
from typing import Any

import pytest
import yaml

from tests.probe.odd_nodes import PACKAGE, install

ROOT = Path(__file__).resolve().parent.parent.parent
WORKFLOW = ROOT / "docs" / "workflows" / "probe.yml"


def workflow() -> dict[str, Any]:
    read: dict[str, Any] = yaml.load(WORKFLOW.read_text(), Loader=yaml.BaseLoader)
    return read


def steps(job: str) -> list[dict[str, Any]]:
    found: list[dict[str, Any]] = workflow()["jobs"][job]["steps"]
    return found


def test_its_form() -> None:
    found = workflow()
    assert set(found) == {"name", "on", "permissions", "jobs"}
    assert found["permissions"] == {"contents": "read"}
    for job in found["jobs"].values():
        assert job["runs-on"] == "ubuntu-latest"
        for step in job["steps"]:
            assert ("uses" in step) != ("run" in step)
            assert set(step) <= {"name", "uses", "with", "run", "env"}
    assert found["jobs"]["merge"]["needs"] == "probe"


def test_no_expression_reaches_a_shell() -> None:
    assert [step["run"] for job in ("probe", "merge") for step in steps(job) if "${{" in step.get("run", "")] == []


def test_its_form_is_that_of_githubs_schema() -> None:
    checker = shutil.which("check-jsonschema", path=str(Path(sys.executable).parent)) or shutil.which("check-jsonschema")
    if checker is None:
        pytest.skip("check-jsonschema is not installed (pip install check-jsonschema)")
    words = [checker, "--builtin-schema", "vendor.github-workflows", str(WORKFLOW)]
    assert subprocess.run(words, capture_output=True, text=True, check=False).stdout == "ok -- validation done\n"


def test_its_commands_make_the_library_of_one_long_run(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """The matrix is played through with an own package in place of ROS, `--local` in place of Docker."""
    install(tmp_path / "prefix", ["wants_args.py", "crashes_politely.py", "waits_for_message.py", "own_name.py"])
    (tmp_path / "probe.yaml").write_text(f"packages: [{PACKAGE}]\nlimits: {{quiet: 0.3, limit: 4}}\n")
    tools = tmp_path / "bin"
    tools.mkdir()
    launcher = tools / "launchlint"
    launcher.write_text(
        f'#!/bin/sh\n[ "$1" = probe ] && set -- "$@" --local -q\nPYTHONPATH={ROOT} exec {sys.executable} -m launchlint "$@"\n'
    )
    launcher.chmod(0o755)
    monkeypatch.setenv("PATH", f"{tools}:/usr/bin:/bin")
    monkeypatch.setenv("CMAKE_PREFIX_PATH", str(tmp_path / "prefix"))
    monkeypatch.setenv("ROS_DISTRO", "odd")

    def shell(command: str, **variables: str) -> None:
        done = subprocess.run(
            ["bash", "-e", "-c", command], cwd=tmp_path, env={**_environment(), **variables}, capture_output=True, text=True, check=False
        )
        assert done.returncode == 0, done.stderr

    probing = next(step for step in steps("probe") if "launchlint probe" in step.get("run", ""))
    for shard in workflow()["jobs"]["probe"]["strategy"]["matrix"]["shard"]:
        shell(probing["run"], **{name: value.replace("${{ matrix.shard }}", shard) for name, value in probing["env"].items()})
    for step in steps("merge"):
        if "launchlint library" in step.get("run", ""):
            shell(step["run"])
    shell("launchlint probe probe.yaml -o whole.json")
    assert (tmp_path / "library.json").read_text() == (tmp_path / "whole.json").read_text()


def _environment() -> dict[str, str]:
    import os

    return dict(os.environ)
