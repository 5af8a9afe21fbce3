"""A run that is killed at any moment: every file is as it was or as it was to become, and the next run does all of it."""

from __future__ import annotations

import signal
from pathlib import Path

import pytest

from tests.cli.running import clean_environment, run
from tests.meeting.system_calls import moments, traced
from tests.meeting.workspaces import FILES, content, make

pytestmark = [pytest.mark.strace, pytest.mark.slow]

KILLED = -signal.SIGKILL
COMMANDS = {
    "fix": ("check", "--fix", "--jobs", "1", "."),
    "format": ("format", "."),
    "report": ("report", ".", "-o", "page.html"),
    "export": ("export", "demo/launch/entry00.launch", "--flatten", "-o", "flat.launch"),
    "baseline": ("check", "--write-baseline", "baseline.json", "--jobs", "1", "."),
    "extract": ("extract", "demo", "-o", "library.yaml"),
    "init": ("init", "--force"),
}


@pytest.mark.parametrize("words", COMMANDS.values(), ids=COMMANDS)
def test_nothing_is_lost_or_half_written(words: tuple[str, ...], tmp_path: Path) -> None:
    before = content(make(tmp_path / "before"))
    undisturbed = make(tmp_path / "repository")
    log = tmp_path / "calls.log"
    ended = traced(undisturbed, tmp_path / "cache", words, log=log)
    assert (ended.status in (0, 1), "Traceback" in ended.errors) == (True, False), ended
    after = content(undisturbed)
    assert after != before
    where = list(moments(log))
    assert any(name == "rename" for name, _ in where)
    for number, (name, count) in enumerate(where):
        directory = make(tmp_path / str(number) / "repository")
        cache = tmp_path / str(number) / "cache"
        killed = traced(directory, cache, words, f"{name}:signal=SIGKILL:when={count}", log=tmp_path / "killed.log")
        assert killed.status == KILLED, (name, count)
        now = content(directory)
        assert set(before) <= set(now) <= set(after)
        assert all(text in (before.get(file), after[file]) for file, text in now.items()), (name, count)
        again = run(directory, *words, environment=clean_environment(cache))
        assert again.status in (0, 1), (name, count, again)
        assert content(directory) == after, (name, count)


def test_a_cache_that_was_being_written(tmp_path: Path) -> None:
    words = ("check", "--jobs", "1", ".")
    directory = make(tmp_path / "repository", FILES)
    expected = run(directory, "check", "--no-cache", "--jobs", "1", ".")
    log = tmp_path / "calls.log"
    traced(directory, tmp_path / "cache", words, log=log)
    assert list((tmp_path / "cache").rglob("*.sqlite"))
    where = [(name, count) for name, count in moments(log) if name != "write"]
    assert sum(name == "pwrite64" for name, _ in where) > 10
    for name, count in where[:: max(1, len(where) // 25)]:
        cache = tmp_path / f"cache-{name}-{count}"
        killed = traced(directory, cache, words, f"{name}:signal=SIGKILL:when={count}", log=tmp_path / "killed.log")
        assert killed.status == KILLED, (name, count)
        for _ in range(2):
            assert run(directory, *words, environment=clean_environment(cache)) == expected, (name, count)
