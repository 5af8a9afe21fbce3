"""What files hold, as an earlier run has seen it: never believed where a file may be another one."""

from __future__ import annotations

import hashlib
import json
import os
from collections.abc import Callable
from pathlib import Path

import pytest

from launchlint.atomic import seal
from launchlint.workspace import contents
from launchlint.workspace.contents import Contents


@pytest.fixture(autouse=True)
def always_written(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(contents, "WORTH_WRITING", 1)


@pytest.fixture
def old(monkeypatch: pytest.MonkeyPatch) -> None:
    """Every file counts as written long ago."""
    monkeypatch.setattr(contents, "RACY", 0)


class Seen:
    """One file of which runs ask what it holds."""

    def __init__(self, directory: Path) -> None:
        self.file = directory / "a.launch"
        self.kept = directory / "cache" / "kept"
        self.file.write_text("<launch/>\n")

    def digest(self) -> str | None:
        """As a run sees it, which keeps what it has seen."""
        held = Contents(str(self.kept))
        found = held.sha1(str(self.file))
        held.keep()
        return found

    def is_believed(self, monkeypatch: pytest.MonkeyPatch) -> bool:
        """Whether a run takes what was kept, without reading the file."""
        with monkeypatch.context() as patch:
            patch.setattr(Contents, "_hashed", lambda self, path: None)
            return Contents(str(self.kept)).sha1(str(self.file)) is not None


@pytest.fixture
def seen(tmp_path: Path) -> Seen:
    return Seen(tmp_path)


def sha1(text: str) -> str:
    return hashlib.sha1(text.encode(), usedforsecurity=False).hexdigest()


@pytest.mark.usefixtures("old")
def test_a_file_is_read_once(seen: Seen, monkeypatch: pytest.MonkeyPatch) -> None:
    assert seen.digest() == sha1("<launch/>\n")
    assert seen.is_believed(monkeypatch)
    assert seen.digest() == sha1("<launch/>\n")


def test_a_file_that_was_just_written_is_read_again(seen: Seen, monkeypatch: pytest.MonkeyPatch) -> None:
    seen.digest()
    assert not seen.is_believed(monkeypatch)


def same_size(file: Path) -> None:
    file.write_text("<LAUNCH/>\n")


def same_times(file: Path) -> None:
    before = file.stat()
    file.write_text("<LAUNCH/>\n")
    os.utime(file, ns=(before.st_atime_ns, before.st_mtime_ns))


def another_file(file: Path) -> None:
    other = file.with_suffix(".other")
    other.write_text("<LAUNCH/>\n")
    os.utime(other, ns=(file.stat().st_atime_ns, file.stat().st_mtime_ns))
    other.replace(file)


def link(file: Path) -> None:
    other = file.with_suffix(".other")
    other.write_text("<LAUNCH/>\n")
    file.unlink()
    file.symlink_to(other)


@pytest.mark.usefixtures("old")
@pytest.mark.parametrize("change", [same_size, same_times, another_file, link])
def test_a_change_is_seen(seen: Seen, change: Callable[[Path], None]) -> None:
    seen.digest()
    change(seen.file)
    assert seen.digest() == sha1("<LAUNCH/>\n")


@pytest.mark.usefixtures("old")
def test_the_target_of_a_link_counts(seen: Seen) -> None:
    link(seen.file)
    assert seen.digest() == sha1("<LAUNCH/>\n")
    seen.file.with_suffix(".other").write_text("<launch/>\n")
    assert seen.digest() == sha1("<launch/>\n")


@pytest.mark.usefixtures("old")
@pytest.mark.parametrize("instead", ["nothing", "directory", "pipe", "circle of links"])
def test_what_is_no_file_any_more(seen: Seen, instead: str) -> None:
    seen.digest()
    seen.file.unlink()
    if instead == "directory":
        seen.file.mkdir()
    elif instead == "pipe":
        os.mkfifo(seen.file)
    elif instead == "circle of links":
        seen.file.symlink_to(seen.file)
    assert seen.digest() is None


@pytest.mark.usefixtures("old")
def test_a_file_that_changes_while_it_is_read_is_not_remembered(seen: Seen, monkeypatch: pytest.MonkeyPatch) -> None:
    read = os.read

    def meddled(descriptor: int, size: int) -> bytes:
        data = read(descriptor, size)
        if data:
            seen.file.write_text("<LAUNCH/>\n")
        return data

    with monkeypatch.context() as patch:
        patch.setattr(os, "read", meddled)
        seen.digest()
    assert not seen.is_believed(monkeypatch)
    assert seen.digest() == sha1("<LAUNCH/>\n")


@pytest.mark.usefixtures("old")
def test_times_without_a_fraction_of_a_second_say_nothing(seen: Seen, monkeypatch: pytest.MonkeyPatch) -> None:
    """In an image that was packed with one time for all files another file may have the same size, number and times."""

    class Packed:
        """What ``stat`` says in such an image."""

        def __init__(self, status: os.stat_result) -> None:
            self.st_mode, self.st_size, self.st_dev, self.st_ino = status.st_mode, status.st_size, status.st_dev, 1
            self.st_mtime_ns = self.st_ctime_ns = 1_000_000_000

    stat, fstat = os.stat, os.fstat
    with monkeypatch.context() as patch:
        patch.setattr(os, "fstat", lambda descriptor: Packed(fstat(descriptor)))
        patch.setattr(os, "stat", lambda path: Packed(stat(path)))
        seen.digest()
        same_size(seen.file)
        assert seen.digest() == sha1("<LAUNCH/>\n")


def test_without_the_time_of_change_a_racy_file_is_read_again(seen: Seen, monkeypatch: pytest.MonkeyPatch) -> None:
    """Where only the time of modification told of a change, as on some file systems, the rule for racy files holds."""
    number = os.stat(seen.file).st_mtime_ns
    monkeypatch.setattr(contents, "_signature", lambda status: [0, 0, status.st_size, 0, number])
    seen.digest()
    same_size(seen.file)
    assert seen.digest() == sha1("<LAUNCH/>\n")
    monkeypatch.setattr(contents, "RACY", 0)
    seen.digest()
    seen.file.write_text("<launch/>\n")
    assert seen.digest() == sha1("<LAUNCH/>\n"), "this is what the rule is for"


def resealed(change: Callable[[list[object]], object]) -> Callable[[Path], None]:
    def damage(file: Path) -> None:
        text = json.dumps(change(json.loads(file.read_text()[40:])))
        file.write_text(seal("", text) + text)

    return damage


def lied(value: list[object]) -> object:
    return [1, "", {path: {"a": 1} for path in value[2]}]  # type: ignore[attr-defined]


DAMAGES: dict[str, Callable[[Path], object]] = {
    "empty": lambda file: file.write_text(""),
    "cut": lambda file: file.write_text(file.read_text()[:-20]),
    "one digit": lambda file: file.write_text(file.read_text().replace("[1,", "[2,")),
    "no text": lambda file: file.write_bytes(b"\xff" * 1000),
    "a directory": lambda file: (file.unlink(), file.mkdir()),
    "another format": resealed(lambda value: [2, *value[1:]]),
    "no list": resealed(lambda value: {"a": 1}),
    "no files": resealed(lambda value: [1, "", []]),
    "no version": resealed(lambda value: [1, None, value[2]]),
    "no digests": resealed(lied),
    "too few": resealed(lambda value: [1, "", {path: known[:-1] for path, known in value[2].items()}]),  # type: ignore[attr-defined]
}


@pytest.mark.usefixtures("old")
@pytest.mark.parametrize("damage", DAMAGES.values(), ids=list(DAMAGES))
def test_what_is_broken_is_passed_over(seen: Seen, damage: Callable[[Path], object], monkeypatch: pytest.MonkeyPatch) -> None:
    seen.digest()
    damage(seen.kept)
    assert not seen.is_believed(monkeypatch)
    assert seen.digest() == sha1("<launch/>\n")
    assert seen.is_believed(monkeypatch) is not seen.kept.is_dir()


class Counting:
    """A fact about files: how long they are."""

    def __init__(self, seen: Seen, version: str = "1") -> None:
        self.file = str(seen.file)
        self.made = 0
        self.held = Contents(str(seen.kept))
        self.held.begin(version)

    def length(self) -> int:
        return self.held.fact(self.file, "length", self._make, str, int)

    def _make(self, data: bytes) -> int:
        self.made += 1
        return len(data)


def made(seen: Seen, version: str = "1") -> int:
    """How often the fact is made in one run, which is true in any case."""
    counting = Counting(seen, version)
    assert [counting.length(), counting.length()] == [len(seen.file.read_bytes())] * 2
    counting.held.keep()
    return counting.made


def test_a_fact_is_made_once_for_the_same_content(seen: Seen) -> None:
    """Also where the file is read again, since it is new or came again from elsewhere."""
    assert made(seen) == 1
    assert made(seen) == 0
    text = seen.file.read_text()
    seen.file.unlink()
    seen.file.write_text(text)
    assert made(seen) == 0
    seen.file.write_text("<launch></launch>")
    assert made(seen) == 1
    assert made(seen) == 0


def test_another_version_makes_facts_anew(seen: Seen) -> None:
    assert made(seen, "1") == 1
    assert made(seen, "2") == 1
    assert made(seen, "2") == 0
    assert made(seen, "1") == 1


def test_a_fact_of_another_form_is_made_anew(seen: Seen) -> None:
    made(seen)
    for value in ("x", None, [], {"a": 1}):

        def change(kept: list[object], value: object = value) -> object:
            return [*kept[:2], {path: [*known[:-1], {"length": value}] for path, known in kept[2].items()}]  # type: ignore[attr-defined]

        resealed(change)(seen.kept)
        assert made(seen) == 1, value


def test_a_fact_of_a_file_that_has_changed_since_is_not_kept(seen: Seen) -> None:
    first = Counting(seen)
    first.held.sha1(first.file)
    seen.file.write_text("<launch></launch>\n")
    assert first.length() == 18
    first.held.keep()
    seen.file.write_text("<launch/>\n")
    assert made(seen) == 1


def test_what_raises_is_kept_by_nobody(seen: Seen) -> None:
    def refuse(data: bytes) -> int:
        raise ValueError("no")

    for _ in range(2):
        with pytest.raises(ValueError, match="no"):
            Contents(str(seen.kept)).fact(str(seen.file), "length", refuse, str, int)
    seen.file.write_bytes(b" " * ((1 << 20) + 1))
    with pytest.raises(OSError, match="larger than"):
        Counting(seen).length()


def test_little_is_not_worth_writing(seen: Seen, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(contents, "WORTH_WRITING", 2)
    seen.digest()
    assert not seen.kept.exists()


@pytest.mark.usefixtures("old")
def test_of_too_many_files_those_stay_that_were_looked_at(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(contents, "MOST_FILES", 2)
    kept = tmp_path / "kept"
    files = [tmp_path / str(number) for number in range(4)]
    for file in files:
        file.write_text(file.name)
    for some in (files[:2], files[2:]):
        held = Contents(str(kept))
        for file in some:
            held.sha1(str(file))
        held.keep()
    assert list(json.loads(kept.read_text()[40:])[2]) == [str(file) for file in files[2:]]


@pytest.mark.usefixtures("old")
def test_where_nothing_can_be_written(seen: Seen) -> None:
    (seen.kept.parent).write_text("")
    assert seen.digest() == sha1("<launch/>\n")


@pytest.mark.usefixtures("old")
def test_names_that_are_no_text(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    seen = Seen(tmp_path)
    seen.file = Path(os.fsdecode(os.fsencode(tmp_path) + b"/\xff.launch"))
    seen.file.write_text("<launch/>\n")
    seen.digest()
    assert seen.is_believed(monkeypatch)
    assert Contents(str(seen.kept)).sha1("a\0b") is None
