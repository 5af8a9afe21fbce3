"""``launchlint init``: what it writes is right, and what is there stays."""

from __future__ import annotations

import re
import subprocess
import sys
from pathlib import Path

import pytest

from launchlint.cli import starting
from launchlint.workspace.configuration import KEYS, load
from tests.cli.running import CLEAN, DOUBLE, PACKAGE, ROOT, run, write

ROS2 = '<launch>\n  <node pkg="demo" exec="talk" namespace="a"/>\n  <let name="x" value="$(var y)"/>\n</launch>\n'


@pytest.fixture
def repository(tmp_path: Path) -> Path:
    directory = tmp_path / "robot"
    write(directory, {"package.xml": PACKAGE.format(name="demo"), "launch/a.launch": CLEAN, "scripts/talk.py": "#!/usr/bin/env python3\n"})
    return directory


def test_the_text(repository: Path) -> None:
    ran = run(repository, "init")
    assert (ran.status, ran.errors) == (0, "launchlint: wrote .launchlint.yaml\n")
    assert ran.output.splitlines()[:5] == [
        "1 package, 1 launch file.",
        "A check finds nothing wrong.",
        "",
        "To check every commit, write this to .pre-commit-config.yaml (--pre-commit does):",
        "",
    ]
    assert "\n".join(f"    {line}".rstrip() for line in starting.HOOK.splitlines()) in ran.output
    assert "\n".join(f"    {line}".rstrip() for line in starting.WORKFLOW.splitlines()) in ran.output
    assert run(repository, "check").status == 0


def test_what_is_found(repository: Path) -> None:
    write(repository, {"launch/b.launch": DOUBLE, ".gitlab-ci.yml": "", ".pre-commit-config.yaml": "repos: []\n"})
    ran = run(repository.parent, "init", "robot")
    assert (ran.status, ran.errors) == (0, "launchlint: wrote robot/.launchlint.yaml\n")
    assert ran.output.splitlines()[:10] == [
        "1 package, 2 launch files.",
        "A check finds 1 error and 0 warnings: `launchlint check` shows them.",
        "To hear of new ones only, run",
        "",
        "    launchlint check --write-baseline .launchlint-baseline.json",
        "",
        "and name the file under `baseline` in .launchlint.yaml.",
        "",
        "To check every commit, add this to .pre-commit-config.yaml (--pre-commit does):",
        "",
    ]
    assert "gl-code-quality-report.json" in ran.output
    assert "launchlint/launchlint@" not in ran.output
    assert "#   - file: launch/a.launch\n" in (repository / ".launchlint.yaml").read_text()


def test_nothing_is_replaced(repository: Path) -> None:
    write(repository, {".github/workflows/launchlint.yml": "mine\n"})
    ran = run(repository, "init", "--github", "--pre-commit")
    assert (ran.status, ran.output, ran.errors) == (
        2,
        "",
        "launchlint: ./.github/workflows/launchlint.yml is there already: look at it, or replace it with --force; nothing was written\n",
    )
    assert not (repository / ".launchlint.yaml").exists()
    ran = run(repository, "init", "--github", "--pre-commit", "--force")
    written = (".launchlint.yaml", ".pre-commit-config.yaml", ".github/workflows/launchlint.yml")
    assert ran.errors == "".join(f"launchlint: wrote {name}\n" for name in written)
    assert (repository / ".github/workflows/launchlint.yml").read_text() == starting.WORKFLOW
    assert (repository / ".pre-commit-config.yaml").read_text() == starting.HOOK
    assert run(repository, "init", "nowhere").errors == "launchlint: nowhere: there is no such directory; give the one of a repository\n"


def test_every_example_of_the_configuration_is_valid(tmp_path: Path) -> None:
    """With the comment signs taken away it says what it shows, and every key is there."""
    found = starting.Found(["demo"], ["l/a.launch"], ['l/"a: b".launch', "l/a.launch"], 0, 0, False, False, False)
    write(tmp_path, {'l/"a: b".launch': CLEAN, "l/a.launch": CLEAN, "library.json": "{}", ".launchlint-baseline.json": "{}"})
    (tmp_path / "other_packages").mkdir()
    text = starting.configuration(found)
    load_from = tmp_path / "robot"
    load_from.mkdir()
    for directory in ("l",):
        (load_from / directory).symlink_to(tmp_path / directory)
    examples = [line[2:] for line in text.splitlines() if re.match(r"# ( +-|    |  \"|[a-z-]+:( [\[{.a-z-]|$))", line)]
    (load_from / ".launchlint.yaml").write_text("\n".join(line for line in examples if " is " not in line and "it may" not in line) + "\n")
    configuration = load(str(load_from / ".launchlint.yaml"))
    assert set(KEYS) - {each[0] for each in configuration.positions} == {"select", "args", "env"}
    assert configuration.baseline == str(load_from / ".launchlint-baseline.json")
    assert [Path(entry.file).name for entry in configuration.entries or ()] == ['"a: b".launch', "a.launch"]


def test_the_snippets_are_those_of_the_guides() -> None:
    assert (ROOT / "docs/workflows/check.yml").read_text() == starting.WORKFLOW


@pytest.mark.parametrize(
    ("schema", "name", "text"),
    [("github-workflows", "w.yml", starting.WORKFLOW), ("gitlab-ci", ".gitlab-ci.yml", starting.GITLAB)],
)
def test_the_snippets_are_valid(tmp_path: Path, schema: str, name: str, text: str) -> None:
    tool = Path(sys.executable).parent / "check-jsonschema"
    if not tool.is_file():
        pytest.skip("check-jsonschema is not installed (it is part of the dev extra)")
    (tmp_path / name).write_text(text)
    done = subprocess.run([tool, "--builtin-schema", f"vendor.{schema}", tmp_path / name], capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stdout + done.stderr
