"""The hooks of ``.pre-commit-hooks.yaml`` in the real pre-commit."""

from __future__ import annotations

import importlib.util
import os
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

from tests.cli.ferry import BROKEN, GOOD, HELM, SEA_BROKEN, Ferry
from tests.cli.running import CLEAN, DOUBLE, PACKAGE, ROOT, run
from tests.workspace.repositories import Repository

HOOKS = ("launchlint", "launchlint-changed", "launchlint-format")
INCLUDING = '<launch>\n  <include file="$(find demo)/launch/part.launch"/>\n  <node name="talker" pkg="demo" type="talk.py"/>\n</launch>\n'
OTHER = CLEAN.replace("talker", "other")

pytestmark = [
    pytest.mark.pypi,  # pre-commit makes an environment for the hook
    pytest.mark.skipif(importlib.util.find_spec("pre_commit") is None, reason="pre-commit is not installed (it is part of the dev extra)"),
]


class Hooked(Repository):
    """A repository with launch files whose hooks are those of this checkout."""

    def __init__(self, directory: Path, environment: dict[str, str]) -> None:
        super().__init__(directory)
        self.environment = environment

    def run_hook(self, hook: str, *words: str) -> tuple[int, str]:
        """Exit status and what pre-commit prints."""
        command = [sys.executable, "-m", "pre_commit", "run", hook, "--color=never", *words]
        done = subprocess.run(command, cwd=self.directory, env=self.environment, capture_output=True, text=True, timeout=300, check=False)
        return done.returncode, done.stdout + done.stderr


@pytest.fixture(scope="session")
def launchlint_repository(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """This checkout as it is now, committed, for pre-commit to clone."""
    made = Repository(tmp_path_factory.mktemp("launchlint") / "launchlint")
    listed = subprocess.run(
        ["git", "ls-files", "-z", "--cached", "--others", "--exclude-standard", "--", ":!tests", ":!docs"],
        cwd=ROOT, capture_output=True, check=True,
    )  # fmt: skip
    for name in filter(None, os.fsdecode(listed.stdout).split("\0")):
        if (ROOT / name).is_file():
            (made.directory / name).parent.mkdir(parents=True, exist_ok=True)
            shutil.copy(ROOT / name, made.directory / name)
    made.commit()
    return made.directory


@pytest.fixture(scope="session")
def pre_commit_environment(tmp_path_factory: pytest.TempPathFactory) -> dict[str, str]:
    """The environment in which pre-commit keeps its environments apart from this machine's."""
    kept = {name: value for name, value in os.environ.items() if not name.startswith(("GIT_", "PRE_COMMIT", "PYTHON", "XDG_"))}
    home = tmp_path_factory.mktemp("pre-commit")
    return {**kept, "PRE_COMMIT_HOME": str(home), "XDG_CACHE_HOME": str(home / "cache")}


@pytest.fixture
def repository(tmp_path: Path, launchlint_repository: Path, pre_commit_environment: dict[str, str]) -> Hooked:
    made = Hooked(tmp_path / "robot", pre_commit_environment)
    revision = subprocess.run(
        ["git", "rev-parse", "HEAD"], cwd=launchlint_repository, capture_output=True, text=True, check=True
    ).stdout.strip()
    hooks = "".join(f"      - id: {hook}\n" for hook in HOOKS)
    made.write(
        **{
            ".pre-commit-config.yaml": f"repos:\n  - repo: {launchlint_repository}\n    rev: {revision}\n    hooks:\n{hooks}",
            "package.xml": PACKAGE.format(name="demo"),
            "launch/all.launch": INCLUDING,
            "launch/part.launch": OTHER,
        }
    )
    made.write_bytes("scripts/talk.py", b"#!/usr/bin/env python3\nprint()\n")
    os.chmod(made.directory / "scripts/talk.py", 0o755)
    made.commit()
    return made


def test_all_is_well(repository: Hooked) -> None:
    for hook in HOOKS:
        status, output = repository.run_hook(hook, "--all-files")
        assert status == 0, output
        assert "Passed" in output


def test_a_bad_remap_is_staged(repository: Hooked) -> None:
    bad = CLEAN.replace('type="talk.py"/>', 'type="talk.py">\n    <remap from="chatter" too="said"/>\n  </node>')
    repository.write(**{"launch/part.launch": bad.replace("talker", "other")})
    repository.git("add", "-A")
    for hook in HOOKS[:2]:
        status, output = repository.run_hook(hook)
        assert status == 1, output
        assert "launch/part.launch:3:6: error LL105 missing-attribute" in output


def test_only_the_including_file_is_staged(repository: Hooked) -> None:
    repository.write(**{"launch/all.launch": INCLUDING.replace('name="talker"', 'name="other"')})
    repository.git("add", "-A")
    for hook in HOOKS[:2]:
        status, output = repository.run_hook(hook)
        assert status == 1, output
        assert "launch/all.launch:3:15: error LL301 duplicate-node-name: two nodes are named /other" in output


def test_an_included_file_is_deleted(repository: Hooked) -> None:
    repository.git("rm", "-q", "launch/part.launch")
    status, output = repository.run_hook("launchlint")
    assert status == 1, output
    assert "launch/all.launch:2:18: error LL401 include-not-found" in output


def test_an_untracked_file_would_clash(repository: Hooked) -> None:
    repository.write(**{"launch/copy.launch": DOUBLE})
    status, output = repository.run_hook("launchlint")
    assert status == 0, output
    assert "Passed" in output


def test_a_change_that_is_not_staged_does_not_count(repository: Hooked) -> None:
    repository.write(**{"launch/part.launch": DOUBLE, "README": "new"})
    repository.git("add", "README")
    status, output = repository.run_hook("launchlint")
    assert status == 0, output


def test_a_file_is_put_in_normal_form(repository: Hooked) -> None:
    repository.write(**{"launch/part.launch": CLEAN.replace("  <node", "\t<node").replace("talker", "other")})
    repository.git("add", "-A")
    status, output = repository.run_hook("launchlint-format")
    assert status == 1, output
    assert "files were modified by this hook" in output
    assert (repository.directory / "launch/part.launch").read_text() == OTHER


def test_three_thousand_files(repository: Hooked) -> None:
    """pre-commit splits so many names into several calls; what is wrong is told all the same."""
    repository.write(**{f"launch/many/{number:04}_{'x' * 60}.launch": OTHER for number in range(3000)})
    repository.write(**{"launch/many/1500_bad.launch": DOUBLE})
    repository.git("add", "-A")
    for hook in HOOKS[:2]:
        status, output = repository.run_hook(hook)
        assert status == 1, output
        assert "launch/many/1500_bad.launch:3:15: error LL301 duplicate-node-name: two nodes are named /talker" in output


def test_no_launch_files_at_all(tmp_path: Path, launchlint_repository: Path, pre_commit_environment: dict[str, str]) -> None:
    """``try-repo`` is what people try first."""
    made = Repository(tmp_path / "plain")
    made.write(README="nothing here")
    made.commit()
    command = [
        sys.executable,
        "-m",
        "pre_commit",
        "try-repo",
        str(launchlint_repository),
        "launchlint",
        "--all-files",
        "--verbose",
        "--color=never",
    ]
    done = subprocess.run(command, cwd=made.directory, env=pre_commit_environment, capture_output=True, text=True, timeout=300, check=False)
    assert done.returncode == 0, done.stdout + done.stderr
    assert "no launch files" in done.stdout


@pytest.fixture
def ferry(tmp_path: Path, repository: Hooked) -> Hooked:
    """The bundled example of ROS 2 with the same hooks, all of it in order and committed."""
    made = Hooked(tmp_path / "ferry", repository.environment)
    shutil.copy(repository.directory / ".pre-commit-config.yaml", made.directory)
    Ferry(made.directory)
    for name in (BROKEN, SEA_BROKEN):
        (made.directory / name).unlink()
    assert run(made.directory, "format", GOOD, HELM).status == 0
    made.commit()
    return made


def test_launch_files_of_ros2(ferry: Hooked) -> None:
    for hook in HOOKS:
        status, output = ferry.run_hook(hook, "--all-files")
        assert status == 0, output
    before = (ferry.directory / HELM).read_text()
    ferry.write(**{HELM: before.replace("turtle1/cmd_vel", "turtle1/cmd_vel/")})
    ferry.git("add", "-A")
    ferry.write(**{HELM: before})
    for hook in HOOKS[:2]:
        status, output = ferry.run_hook(hook)
        assert status == 1, output
        assert f"{HELM}:22:7: error LL947 remap-kills-node" in output
        assert "show it: ros2 launch" in output


def test_a_file_in_yaml_is_put_in_normal_form(ferry: Hooked) -> None:
    normal = (ferry.directory / HELM).read_text()
    ferry.write(**{HELM: normal.replace("pkg: joy\n", "pkg: joy  \n")})
    ferry.git("add", "-A")
    status, output = ferry.run_hook("launchlint-format")
    assert status == 1, output
    assert (ferry.directory / HELM).read_text() == normal
