"""Every rule on small packages: input and whole output side by side.

``fixtures/LLnnn/CASE/`` is what is checked, ``expected.txt`` in it what ``launchlint check -v --select LLnnn`` prints there;
``options.txt`` and ``environment.txt`` may add options (one line of words) and environment variables. Cases named ``clean…``
must give no finding. ``base/`` holds the files of an earlier revision, to which ``--base`` is then set.
"""

from __future__ import annotations

import shutil
from pathlib import Path

import pytest

from launchlint.rules.registry import RULES
from tests.rules.pipeline import ENVIRONMENT_FILE, OPTIONS_FILE, case_environment, case_options, check, commit

FIXTURES = Path(__file__).resolve().parent / "fixtures"
EXPECTED = "expected.txt"
BASE = "base"
NOTHING = "no problems"
CASES = sorted(path for path in FIXTURES.glob("LL*/*") if path.is_dir())


@pytest.mark.parametrize("case", CASES, ids=lambda case: f"{case.parent.name}-{case.name}")
def test_case(case: Path, update: bool, tmp_path: Path) -> None:
    # A copy, since this repository would else be the workspace, with the packages of all other cases in it.
    copy = tmp_path / case.name
    shutil.copytree(case, copy, symlinks=True, ignore=shutil.ignore_patterns(EXPECTED, OPTIONS_FILE, ENVIRONMENT_FILE))
    options = case_options(case)
    if (copy / BASE).is_dir():
        options = [*options, "--base", commit_base(copy)]
    _, output = check(copy, "-v", "--select", case.parent.name, *options, environment=case_environment(case))
    expected = case / EXPECTED
    if update:
        expected.write_bytes(output.encode("utf-8"))
    assert expected.is_file(), f"there is no {EXPECTED} yet: read the output, then run pytest --update\n{output}"
    assert output == expected.read_bytes().decode("utf-8")
    assert any(line.startswith(NOTHING) for line in output.splitlines()) == case.name.startswith("clean")


def commit_base(directory: Path) -> str:
    """Make a repository whose only commit holds what is in ``base``; its name."""
    now = directory.with_name("now")
    directory.rename(now)
    (now / BASE).rename(directory)
    revision = commit(directory)
    for path in directory.iterdir():
        if path.name != ".git":
            shutil.rmtree(path) if path.is_dir() else path.unlink()
    shutil.copytree(now, directory, symlinks=True, dirs_exist_ok=True)
    return revision


@pytest.mark.parametrize("rule", [rule.id for rule in RULES])
def test_each_rule_has_a_failing_and_a_clean_case(rule: str) -> None:
    names = [case.name for case in CASES if case.parent.name == rule]
    assert any(name.startswith("clean") for name in names)
    assert any(not name.startswith("clean") for name in names)


def test_each_fixture_belongs_to_a_rule() -> None:
    assert {path.name for path in FIXTURES.iterdir()} <= {rule.id for rule in RULES}
