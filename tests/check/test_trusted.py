"""Runs that take the content of files from what ``stat`` says of them: they tell what a run without a cache tells, whatever has changed.

Files of tests were written a moment ago, and are then read in any case; here that moment is long enough.
"""

from __future__ import annotations

import json
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest

from tests.check import test_cache as changes
from tests.check.many import many
from tests.cli.running import PACKAGE, run_program, write

PROGRAM = """
import sys
from launchlint.check import entry
from launchlint.cli import main
from launchlint.workspace import contents

contents.RACY, contents.WORTH_WRITING = 0, 1
check, hashed, counts = entry.EntryChecker.check, contents.Contents._hashed, [0, 0]

def counted(self, request):
    counts[0] += 1
    return check(self, request)

def counted_files(self, path):
    counts[1] += "/launchlint/" not in path
    return hashed(self, path)

entry.EntryChecker.check, contents.Contents._hashed = counted, counted_files
main(["check", "--format", "json", "--jobs", "1", *sys.argv[1:]], standalone_mode=False)
print()
print(*counts)
"""


class Trusting:
    """A repository that is checked with a cache."""

    def __init__(self, directory: Path) -> None:
        self.directory = many(directory / "repository", 30)
        self.cache = directory / "cache"

    def run(self, *words: str) -> tuple[str, list[int]]:
        """What is said; how many entry files are computed, and how many files are read for their digests."""
        done = run_program(self.directory, PROGRAM, *words, cache=self.cache)
        assert done.status == 0, done.errors
        said, counts = done.output.rstrip().rsplit("\n", 1)
        return said, [int(count) for count in counts.split()]

    def agrees(self) -> tuple[list[int], list[int]]:
        """What two runs with the cache do, which must say what one without it says."""
        anew, _ = self.run("--no-cache")
        first, done = self.run()
        second, again = self.run()
        assert first == anew
        assert second == anew
        return done, again


@pytest.fixture
def trusting(tmp_path: Path) -> Trusting:
    return Trusting(tmp_path)


def same_size(directory: Path) -> None:
    file = directory / "arm/launch/entry000.launch"
    file.write_text(file.read_text().replace("robot0", "robot9"))


def other_manifest_of_the_same_size(directory: Path) -> None:
    file = directory / "base/package.xml"
    file.write_text(file.read_text().replace("<name>base<", "<name>bass<"))


def break_manifest(directory: Path) -> None:
    file = directory / "arm/package.xml"
    file.write_text(file.read_text().replace("</package>", "</Package>"))


def mend_manifest(directory: Path) -> None:
    write(directory, {"arm/package.xml": PACKAGE.format(name="arm"), "base/package.xml": PACKAGE.format(name="base")})


def another_program(directory: Path) -> None:
    """An Eclipse file in place of a launch file, and back."""
    write(directory, {"arm/launch/entry001.launch": "<launchConfiguration/>\n"})


def a_launch_file_again(directory: Path) -> None:
    write(directory, {"arm/launch/entry001.launch": '<launch><node name="a" pkg="base" type="talk.py" args="x:=1"/></launch>\n'})


def give_args(directory: Path) -> None:
    write(directory, {"README.md": "roslaunch arm part.launch robot:=r2 unused:=1\n"})


def swap(directory: Path) -> None:
    one, other = directory / "arm/launch/entry002.launch", directory / "base/launch/entry003.launch"
    between = directory / "between"
    one.rename(between)
    other.rename(one)
    between.rename(other)


CHANGES: tuple[Callable[[Path], None], ...] = (
    *(same_size, other_manifest_of_the_same_size, break_manifest, mend_manifest, another_program, a_launch_file_again, give_args, swap),
    *(changes.change_included, changes.change_yaml, changes.remove_yaml, changes.declare_dependency, changes.change_build_file),
    *(changes.list_sources, changes.take_first_line, changes.take_executable_bit, changes.add_near_name, changes.add_package),
    *(changes.change_package, changes.ignore_package, changes.link_package),
)


def test_whatever_changes(trusting: Trusting) -> None:
    trusting.agrees()
    for change in CHANGES:
        change(trusting.directory)
        _, again = trusting.agrees()
        assert again == [0, 0], change.__name__


def test_one_file_is_read_where_one_has_changed(trusting: Trusting) -> None:
    trusting.run()
    same_size(trusting.directory)
    assert trusting.agrees() == ([1, 1], [0, 0])


def runs_of_others(trusting: Trusting) -> Iterator[tuple[str, list[int]]]:
    yield trusting.run("--select", "LL301")
    yield trusting.run("base")


def test_runs_with_other_options_share_what_files_hold(trusting: Trusting) -> None:
    trusting.run()
    assert [counts[1] for _, counts in runs_of_others(trusting)] == [0, 0]


def test_a_broken_file_of_contents_is_passed_over(trusting: Trusting) -> None:
    said, _ = trusting.run()
    (file,) = (trusting.cache / "launchlint").glob("*.contents.json")
    for text in ("", file.read_text()[:-100], json.dumps([1, "", {}]), "\0" * 100):
        file.write_text(text)
        assert trusting.run()[0] == said
    file.unlink()
    file.mkdir()
    assert trusting.run()[0] == said
