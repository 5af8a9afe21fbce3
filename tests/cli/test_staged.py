"""``check --staged`` and ``--changed``: what a commit hook is told."""

from __future__ import annotations

import os
from pathlib import Path

import pytest

from tests.cli.running import CLEAN, DOUBLE, PACKAGE, UNUSED, run
from tests.workspace.repositories import Repository

INCLUDING = '<launch>\n  <include file="$(find demo)/launch/part.launch"/>\n  <node name="talker" pkg="demo" type="talk.py"/>\n</launch>\n'
OTHER = CLEAN.replace("talker", "other")
TWICE = "error LL301 duplicate-node-name: two nodes are named /talker"


@pytest.fixture
def repository(tmp_path: Path) -> Repository:
    """One package with two launch files, one of which includes the other; all is well and committed."""
    made = Repository(tmp_path / "repository")
    made.write(**{"package.xml": PACKAGE.format(name="demo"), "launch/all.launch": INCLUDING, "launch/part.launch": OTHER})
    made.write_bytes("scripts/talk.py", b"#!/usr/bin/env python3\nprint()\n")
    os.chmod(made.directory / "scripts/talk.py", 0o755)
    made.commit()
    return made


def told(repository: Repository, *words: str, **variables: str) -> tuple[int, list[str]]:
    ran = run(repository.directory, "check", "--format", "concise", *words, environment=variables)
    return ran.status, (ran.output + ran.errors).splitlines()


def test_what_is_staged_counts(repository: Repository) -> None:
    repository.write(**{"launch/part.launch": CLEAN})
    repository.git("add", "-A")
    repository.write(**{"launch/part.launch": OTHER})
    assert told(repository) == (0, [])
    assert told(repository, "--staged") == (1, [f"launch/all.launch:3:15: {TWICE}"])


def test_what_is_not_staged_does_not_count(repository: Repository) -> None:
    repository.write(**{"launch/part.launch": CLEAN})
    assert told(repository)[0] == 1
    assert told(repository, "--staged") == (0, [])


def test_what_git_does_not_know_does_not_count(repository: Repository) -> None:
    repository.write(**{"launch/copy.launch": DOUBLE})
    assert told(repository)[0] == 1
    assert told(repository, "--staged") == (0, [])


def test_a_file_that_is_gone_but_still_staged_is_there(repository: Repository) -> None:
    (repository.directory / "launch/part.launch").unlink()
    assert told(repository)[0] == 1
    assert told(repository, "--staged") == (0, [])


def test_a_file_whose_deletion_is_staged_is_gone(repository: Repository) -> None:
    repository.git("rm", "-q", "launch/part.launch")
    status, lines = told(repository, "--staged")
    assert (status, lines[0].split(":")[3:5]) == (
        1,
        [" error LL401 include-not-found", " the included file launch/part.launch does not exist"],
    )


def test_paths_and_excluded_files(repository: Repository) -> None:
    repository.write(**{"launch/part.launch": CLEAN, "old/bad.launch": DOUBLE, ".hidden/bad.launch": DOUBLE, "x.xml": "<robot/>"})
    repository.git("add", "-A")
    assert told(repository, "--staged", "launch") == (1, [f"launch/all.launch:3:15: {TWICE}"])
    repository.write(**{".launchlint.yaml": "exclude: [old, launch]\n"})
    assert told(repository, "--staged") == (0, [])


def test_line_ends_that_git_converts_do_not_matter(repository: Repository) -> None:
    repository.git("config", "core.autocrlf", "true")
    repository.write(**{"launch/part.launch": CLEAN.replace("\n", "\r\n")})
    repository.git("add", "-A")
    assert told(repository, "--staged") == (1, [f"launch/all.launch:3:15: {TWICE}"])


def test_the_index_of_this_commit_counts(repository: Repository) -> None:
    """``git commit FILE`` commits from an index of its own, which it names to its hooks."""
    repository.write(**{"launch/part.launch": CLEAN})
    index = str(repository.directory / ".git" / "next-index-1.lock")
    before = os.environ.get("GIT_INDEX_FILE")
    os.environ["GIT_INDEX_FILE"] = index
    try:
        repository.git("read-tree", "HEAD")
        repository.git("add", "launch/part.launch")
    finally:
        if before is None:
            del os.environ["GIT_INDEX_FILE"]
        else:
            os.environ["GIT_INDEX_FILE"] = before
    assert told(repository, "--staged") == (0, [])
    assert told(repository, "--staged", GIT_INDEX_FILE=index)[0] == 1
    assert told(repository, "--staged", GIT_INDEX_FILE=str(repository.directory / "elsewhere"))[0] == 0


def test_changed_files_decide_what_is_told(repository: Repository) -> None:
    repository.write(**{"launch/part.launch": CLEAN, "launch/third.launch": UNUSED})
    repository.commit()
    twice = f"launch/all.launch:3:15: {TWICE}"
    unused = "launch/third.launch:2:14: warning LL206 unused-arg: the arg speed is never read"
    assert told(repository, "--changed", "launch/all.launch") == (1, [twice])
    assert told(repository, "--changed", "launch/part.launch") == (1, [twice])
    assert told(repository, "--changed", "launch/third.launch") == (0, [unused])
    assert told(repository, "--changed", "launch/gone.launch", "package.xml") == (0, [])


def test_wrong_use(repository: Repository, tmp_path: Path) -> None:
    (tmp_path / "plain").mkdir()
    ran = run(tmp_path / "plain", "check", "--staged")
    assert (ran.status, ran.errors) == (2, f"launchlint: {tmp_path}/plain is not in a git repository: nothing is staged there\n")
    ran = run(repository.directory, "check", "--staged", "-", stdin=CLEAN)
    assert (ran.status, ran.errors) == (
        2,
        "launchlint: --staged and --changed are about files of a git repository; they go with neither standard input nor --entries\n",
    )
    ran = run(repository.directory, "check", "--changed", "--write-baseline", "b.json", "launch/all.launch")
    assert (ran.status, ran.errors) == (2, "launchlint: --write-baseline records all findings; leave --changed out\n")
