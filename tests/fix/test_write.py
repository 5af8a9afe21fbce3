"""A changed text is put back whole, or not at all and with a reason."""

from __future__ import annotations

import os
import re
import stat
from pathlib import Path

import pytest

from launchlint.errors import UsageError
from launchlint.fix.write import write_back

BEFORE = b"\xef\xbb\xbf<launch>\r\n</launch>\r\n"
AFTER = "\N{ZERO WIDTH NO-BREAK SPACE}<launch>\r\n  <!-- \u00e4 -->\r\n</launch>\r\n".encode("utf-16-le")


def names(directory: Path) -> list[str]:
    return sorted(path.name for path in directory.iterdir())


def test_bytes_and_permissions(tmp_path: Path) -> None:
    file = tmp_path / "a.launch"
    file.write_bytes(BEFORE)
    file.chmod(0o640)
    write_back(str(file), BEFORE, AFTER, str(tmp_path))
    assert (file.read_bytes(), stat.S_IMODE(file.stat().st_mode), names(tmp_path)) == (AFTER, 0o640, ["a.launch"])


def test_nothing_to_change_touches_nothing(tmp_path: Path) -> None:
    file = tmp_path / "a.launch"
    file.write_bytes(BEFORE)
    os.utime(file, (1, 1))
    write_back(str(file), BEFORE, BEFORE, str(tmp_path))
    assert file.stat().st_mtime == 1


def test_a_link_that_stays_inside(tmp_path: Path) -> None:
    (tmp_path / "real").mkdir()
    (tmp_path / "real" / "a.launch").write_bytes(BEFORE)
    link = tmp_path / "a.launch"
    link.symlink_to("real/a.launch")
    write_back(str(link), BEFORE, AFTER, str(tmp_path))
    assert (link.is_symlink(), (tmp_path / "real" / "a.launch").read_bytes()) == (True, AFTER)


def refused(file: Path, inside: Path) -> str:
    content = os.path.realpath(file)
    before = Path(content).read_bytes() if os.path.isfile(content) else None
    with pytest.raises(UsageError) as caught:
        write_back(str(file), BEFORE, AFTER, str(inside))
    assert before is None or Path(content).read_bytes() == before
    return str(caught.value)


def test_a_link_that_leads_outside(tmp_path: Path) -> None:
    outside, inside = tmp_path / "outside", tmp_path / "inside"
    outside.mkdir()
    inside.mkdir()
    (outside / "a.launch").write_bytes(BEFORE)
    (inside / "a.launch").symlink_to(outside / "a.launch")
    (inside / "directory").symlink_to(outside)
    expected = f"is left as it is: it lies outside of {str(inside)!r}, which is what may be changed"
    for file in (inside / "a.launch", inside / "directory" / "a.launch", outside / "a.launch", tmp_path / "insider" / ".." / "a"):
        assert refused(file, inside) == f"{str(file)!r} {expected}"


def test_a_name_that_only_begins_like_the_directory(tmp_path: Path) -> None:
    (tmp_path / "work").mkdir()
    (tmp_path / "workbench").mkdir()
    file = tmp_path / "workbench" / "a.launch"
    file.write_bytes(BEFORE)
    assert "outside" in refused(file, tmp_path / "work")


@pytest.mark.parametrize("now", [b"", BEFORE + b" ", BEFORE[:-1], b"something else"])
def test_a_file_changed_meanwhile(now: bytes, tmp_path: Path) -> None:
    file = tmp_path / "a.launch"
    file.write_bytes(now)
    assert (
        refused(file, tmp_path)
        == f"{str(file)!r} is left as it is: it was changed by something else in the meantime; run the command again"
    )


def test_a_file_that_is_gone_or_no_file(tmp_path: Path) -> None:
    file = tmp_path / "a.launch"
    assert refused(file, tmp_path) == f"{str(file)!r} is left as it is: it is no plain file any more"
    os.mkfifo(file)
    assert refused(file, tmp_path) == f"{str(file)!r} is left as it is: it is no plain file any more"


@pytest.mark.skipif(os.geteuid() == 0, reason="root may write everything")
def test_a_write_protected_file(tmp_path: Path) -> None:
    file = tmp_path / "a.launch"
    file.write_bytes(BEFORE)
    file.chmod(0o444)
    assert refused(file, tmp_path) == f"{str(file)!r} is left as it is: it is write-protected"


def test_a_full_disk_leaves_the_file(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    def full(*names: object) -> None:
        raise OSError(28, "No space left on device")

    file = tmp_path / "a.launch"
    file.write_bytes(BEFORE)
    monkeypatch.setattr(os, "replace", full)
    with pytest.raises(UsageError, match=re.escape("cannot write the changed file")):
        write_back(str(file), BEFORE, AFTER, str(tmp_path))
    assert (file.read_bytes(), names(tmp_path)) == (BEFORE, ["a.launch"])
