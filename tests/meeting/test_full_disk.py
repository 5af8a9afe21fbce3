"""A disk on which there is no room at any moment: one message, no half file, and what was there is there."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.cli.running import clean_environment, run
from tests.meeting.system_calls import GROWING, moments, traced
from tests.meeting.test_killed import COMMANDS
from tests.meeting.workspaces import FILES, content, make

pytestmark = [pytest.mark.strace, pytest.mark.slow]


def growing(log: Path) -> list[tuple[str, int]]:
    """The moments of a run at which a file needs room."""
    return [(name, count) for name, count in moments(log, of_files=True) if name in GROWING]


@pytest.mark.parametrize("words", COMMANDS.values(), ids=COMMANDS)
def test_files_are_whole(words: tuple[str, ...], tmp_path: Path) -> None:
    before = content(make(tmp_path / "before"))
    log = tmp_path / "calls.log"
    undisturbed = make(tmp_path / "repository")
    usual = traced(undisturbed, tmp_path / "cache", words, log=log)
    after = content(undisturbed)
    for number, (name, count) in enumerate(growing(log)):
        directory = make(tmp_path / str(number) / "repository")
        cache = tmp_path / str(number) / "cache"
        full = traced(directory, cache, words, f"{name}:error=ENOSPC:when={count}", log=tmp_path / "full.log")
        now = content(directory)
        assert all(text in (before.get(file), after[file]) for file, text in now.items()), (name, count)
        assert set(before) <= set(now), (name, count)
        assert not list(directory.rglob("*.tmp")), (name, count)
        assert "Traceback" not in full.errors + full.output, (name, count)
        if now != after:
            assert (full.status, full.errors.count("No space left on device")) == (2, 1), (name, count, full)
        elif name == "mkdir":
            assert full == usual, (name, count)
        assert run(directory, *words, environment=clean_environment(cache)).status in (0, 1)
        assert content(directory) == after, (name, count)


def test_results_are_told_where_they_cannot_be_kept(tmp_path: Path) -> None:
    words = ("check", "--jobs", "1", ".")
    directory = make(tmp_path / "repository", FILES)
    expected = run(directory, "check", "--no-cache", "--jobs", "1", ".")
    log = tmp_path / "calls.log"
    traced(directory, tmp_path / "cache", words, log=log)
    where = [(name, count) for name, count in moments(log) if name in ("pwrite64", "mkdir")]
    for name, count in where[:: max(1, len(where) // 12)]:
        cache = tmp_path / f"cache-{name}-{count}"
        assert traced(directory, cache, words, f"{name}:error=ENOSPC:when={count}+", log=log) == expected, (name, count)
        assert run(directory, *words, environment=clean_environment(cache)) == expected, (name, count)
