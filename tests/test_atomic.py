"""Writing files: all or nothing, and clear words where it cannot be done."""

from __future__ import annotations

import os
import re
import stat
from pathlib import Path

import pytest

from launchlint.atomic import write_text
from launchlint.errors import UsageError


def names(directory: Path) -> list[str]:
    return sorted(path.name for path in directory.iterdir())


def test_new_file(tmp_path: Path) -> None:
    write_text(str(tmp_path / "a.txt"), "ü\n\ud800")
    assert (tmp_path / "a.txt").read_bytes() == b"\xc3\xbc\n?"
    assert names(tmp_path) == ["a.txt"]


def test_permissions_of_a_file_are_kept(tmp_path: Path) -> None:
    file = tmp_path / "a.txt"
    file.write_text("old", encoding="utf-8")
    file.chmod(0o640)
    write_text(str(file), "new")
    assert (file.read_text(encoding="utf-8"), stat.S_IMODE(file.stat().st_mode)) == ("new", 0o640)


def test_a_symbolic_link_stays_one(tmp_path: Path) -> None:
    (tmp_path / "real").mkdir()
    (tmp_path / "link").symlink_to("real/a.txt")
    write_text(str(tmp_path / "link"), "text")
    assert (tmp_path / "link").is_symlink()
    assert (tmp_path / "real" / "a.txt").read_text(encoding="utf-8") == "text"


def test_a_device_is_written_not_replaced() -> None:
    write_text(os.devnull, "text")
    assert stat.S_ISCHR(Path(os.devnull).stat().st_mode)


def test_nothing_is_left_when_the_last_step_fails(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    def full(*names: object) -> None:
        raise OSError(28, "No space left on device")

    (tmp_path / "a.txt").write_text("old", encoding="utf-8")
    monkeypatch.setattr(os, "replace", full)
    with pytest.raises(UsageError, match=re.escape("a.txt': No space left on device")):
        write_text(str(tmp_path / "a.txt"), "new")
    assert names(tmp_path) == ["a.txt"]
    assert (tmp_path / "a.txt").read_text(encoding="utf-8") == "old"


@pytest.mark.parametrize(
    ("name", "reason"),
    [
        ("", "it is a directory; give the name of a file"),
        ("no/a.txt", "the directory '{0}/no' does not exist; create it first"),
        ("loop", "Too many levels of symbolic links"),
        ("a\0b", "embedded null byte"),
    ],
)
def test_what_cannot_be_written(name: str, reason: str, tmp_path: Path) -> None:
    (tmp_path / "loop").symlink_to("loop")
    path = str(tmp_path / name) if name else str(tmp_path)
    with pytest.raises(UsageError) as caught:
        write_text(path, "text", what="the report")
    assert str(caught.value) == f"cannot write the report to {path!r}: {reason.format(tmp_path)}"
