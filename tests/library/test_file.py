"""Reading a library file, and its index: never out of date, never in the way."""

from __future__ import annotations

import hashlib
import json
import os
import threading
from pathlib import Path
from typing import Any

import pytest

from launchlint.errors import LibraryError
from launchlint.library import file as library_file
from launchlint.library.file import LibraryFile, open_library, read
from tests.library.samples import executable, library, written

DOCUMENT = library(
    a={"executables": {"node": executable(publishers=[{"name": "x"}])}},
    b={"nodelets": {"b/One": executable(), "other/Two": executable()}},
    c={"nodelets": {"b/One": executable()}},
)


@pytest.fixture(autouse=True)
def _everything_is_indexed(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(library_file, "INDEX_PAYS", 0)


@pytest.fixture
def validations(monkeypatch: pytest.MonkeyPatch) -> list[str]:
    """The libraries that were read in full."""
    seen: list[str] = []
    whole = library_file.parse

    def parse(data: bytes, path: str) -> Any:
        seen.append(os.path.basename(path))
        return whole(data, path)

    monkeypatch.setattr(library_file, "parse", parse)
    return seen


def contents(file: LibraryFile) -> dict[str, Any]:
    return {name: file.package(name) for name in file.names()}


def index_of(cache: Path) -> Path:
    (index,) = cache.glob("library-*.index")
    return index


def test_the_index_says_what_the_library_says(tmp_path: Path, validations: list[str]) -> None:
    path, cache = written(tmp_path / "lib.json", DOCUMENT), tmp_path / "cache"
    first, second = open_library(path, str(cache)), open_library(path, str(cache))
    assert validations == ["lib.json"]
    for file in (first, second):
        assert contents(file) == DOCUMENT["packages"]
        assert (file.path, file.digest) == (path, hashlib.sha256(Path(path).read_bytes()).hexdigest())
        assert [file.package_of_class(name) for name in ("b/One", "other/Two", "b/Three")] == ["b", "b", None]
        assert file.package("d") is None
    assert validations == ["lib.json"]


def test_a_changed_library_has_another_index(tmp_path: Path, validations: list[str]) -> None:
    path, cache = written(tmp_path / "lib.json", DOCUMENT), str(tmp_path / "cache")
    open_library(path, cache)
    stat = os.stat(path)
    Path(path).write_text(json.dumps(DOCUMENT).replace('"x"', '"y"'))
    os.utime(path, ns=(stat.st_atime_ns, stat.st_mtime_ns))
    changed = open_library(path, cache)
    assert changed.package("a") == {"executables": {"node": executable(publishers=[{"name": "y"}])}}
    assert validations == ["lib.json", "lib.json"]


def test_a_broken_library_has_no_index(tmp_path: Path) -> None:
    path, cache = written(tmp_path / "lib.json", {**DOCUMENT, "version": 3}), tmp_path / "cache"
    for _ in range(2):
        with pytest.raises(LibraryError, match="reads the versions 1 and 2 of the format"):
            open_library(path, str(cache))
    assert not cache.exists()


@pytest.mark.parametrize("how", ["empty", "cut", "no line", "text", "directory"])
def test_a_useless_index_is_made_anew(tmp_path: Path, validations: list[str], how: str) -> None:
    path, cache = written(tmp_path / "lib.json", DOCUMENT), tmp_path / "cache"
    open_library(path, str(cache))
    index = index_of(cache)
    whole = index.read_bytes()
    if how == "directory":
        index.unlink()
        index.mkdir()
    else:
        index.write_bytes({"empty": b"", "cut": whole[:150], "no line": whole.replace(b"\n", b" "), "text": b"x" * 64 + b"\n{}\n"}[how])
    assert contents(open_library(path, str(cache))) == DOCUMENT["packages"]
    assert validations == ["lib.json", "lib.json"]
    if how != "directory":
        assert index.read_bytes() == whole


def test_no_flipped_bit_of_an_index_is_believed(tmp_path: Path) -> None:
    path, cache = written(tmp_path / "lib.json", DOCUMENT), tmp_path / "cache"
    open_library(path, str(cache))
    index = index_of(cache)
    whole = index.read_bytes()
    for at in range(len(whole)):
        index.write_bytes(whole[:at] + bytes([whole[at] ^ 1]) + whole[at + 1 :])
        file = open_library(path, str(cache))
        assert contents(file) == DOCUMENT["packages"], at
        assert file.package_of_class("other/Two") == "b"


def test_a_cache_below_a_file(tmp_path: Path) -> None:
    path = written(tmp_path / "lib.json", DOCUMENT)
    assert contents(open_library(path, os.path.join(path, "cache"))) == DOCUMENT["packages"]


def test_few_indices_are_kept(tmp_path: Path) -> None:
    cache = tmp_path / "cache"
    for number in range(library_file.MOST_INDICES + 5):
        open_library(written(tmp_path / "lib.json", library(**{f"p{number}": {}})), str(cache))
        os.utime(max(cache.iterdir(), key=lambda path: path.stat().st_mtime_ns), (number, number))
    assert len(list(cache.iterdir())) == library_file.MOST_INDICES


def test_a_small_library_needs_no_index(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.undo()
    open_library(written(tmp_path / "lib.json", DOCUMENT), str(tmp_path / "cache"))
    assert not (tmp_path / "cache").exists()


@pytest.mark.parametrize(
    ("name", "reason"),
    [("none.json", "No such file or directory"), (".", "Is a directory"), ("x" * 300, "File name too long")],
)
def test_what_cannot_be_read(name: str, reason: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    with pytest.raises(LibraryError) as error:
        open_library(name)
    assert str(error.value) == f"{name}: the library cannot be read: {reason}"


def test_a_null_byte_in_the_name() -> None:
    with pytest.raises(LibraryError, match="the library cannot be read"):
        read("a\0b")


def test_a_library_from_a_pipe(tmp_path: Path) -> None:
    pipe = tmp_path / "pipe"
    os.mkfifo(pipe)
    data = json.dumps(DOCUMENT).encode() * 100
    writer = threading.Thread(target=lambda: pipe.write_bytes(data))
    writer.start()
    assert read(str(pipe)) == data
    writer.join()


def test_too_large(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(library_file, "LARGEST", 2**20)
    path = tmp_path / "lib.json"
    path.write_bytes(b" " * 2**20)
    assert len(read(str(path))) == 2**20
    path.write_bytes(b" " * (2**20 + 1))
    with pytest.raises(LibraryError) as error:
        read(str(path))
    assert str(error.value) == f"{path}: the library is larger than 1 MiB"
