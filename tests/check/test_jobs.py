"""The same bytes out, however many processes work, in whatever order, whatever Python's hashes are, with and without the cache."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.check.many import many
from tests.cli.running import Ran, run

FORMATS = ("text", "json", "sarif")


def check(directory: Path, *words: str, **environment: str) -> Ran:
    return run(directory, "check", "-v", *words, environment=environment)


@pytest.fixture(scope="module")
def repository(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return many(tmp_path_factory.mktemp("jobs") / "repository")


@pytest.mark.parametrize("name", FORMATS)
def test_jobs_and_cache(repository: Path, name: str) -> None:
    once = check(repository, "--format", name, "--no-cache", "--jobs", "1")
    assert (once.status, once.errors) == (1, "")
    assert "LL402" in once.output
    assert "LL301" in once.output
    for words in (["--no-cache", "--jobs", "2"], ["--no-cache", "--jobs", "4"], ["--jobs", "3"], ["--jobs", "1"], ["--jobs", "2"], []):
        assert check(repository, "--format", name, *words) == once, words


@pytest.mark.parametrize("seed", ["0", "1", "4711"])
def test_hash_seeds(repository: Path, seed: str) -> None:
    plain = check(repository, "--format", "json", "--no-cache", "--jobs", "1")
    assert check(repository, "--format", "json", "--no-cache", "--jobs", "1", PYTHONHASHSEED=seed) == plain
    assert check(repository, "--format", "json", "--no-cache", "--jobs", "2", PYTHONHASHSEED=seed) == plain
    assert check(repository, "--format", "json", PYTHONHASHSEED=seed) == plain


def test_what_was_worked_out_before_changes_nothing(repository: Path) -> None:
    """Each entry file checked alone, and after all others, gives the same lines."""
    files = sorted(path.relative_to(repository).as_posix() for path in repository.rglob("launch/*.launch"))
    entries = "\n".join(f"- {file}" for file in files)
    (repository / "forwards.yaml").write_text(entries)
    (repository / "backwards.yaml").write_text("\n".join(reversed(entries.splitlines())))
    forwards = run(repository, "check", "--no-cache", "--jobs", "1", "--entries", "forwards.yaml").output.splitlines()
    backwards = run(repository, "check", "--no-cache", "--jobs", "1", "--entries", "backwards.yaml").output.splitlines()
    assert forwards == backwards[::-1]
    for number in (0, 1, 60, len(files) - 1):
        (repository / "one.yaml").write_text(f"- {files[number]}\n")
        assert run(repository, "check", "--entries", "one.yaml").output.splitlines() == [forwards[number]]


def test_a_worker_that_is_killed_costs_time_and_nothing_else(repository: Path) -> None:
    """The kernel kills processes when memory runs out; the work is then done here."""
    from launchlint.check import run as module
    from launchlint.check.entry import EntryChecker
    from launchlint.check.options import EntryRequest, Options
    from launchlint.rules.registry import RULES

    files = sorted(str(path) for path in (repository / "arm" / "launch").glob("*.launch"))
    options = Options(frozenset(rule.id for rule in RULES), (str(repository),), True, {}, str(repository))
    requests = [EntryRequest(file, file) for file in files] * 2
    expected = module.check_entries(requests, EntryChecker(options), jobs=1)
    real = module._work
    try:
        module._work = _die
        assert module.check_entries(requests, EntryChecker(options), jobs=2) == expected
    finally:
        module._work = real


def _die(work: object, checker: object, batch: object) -> object:
    import os
    import signal

    os.kill(os.getpid(), signal.SIGKILL)
    return batch
