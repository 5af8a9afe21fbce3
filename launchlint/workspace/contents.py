"""What files hold, told by digests and by facts: those of an earlier run, where ``stat`` says that a file is still the one that was read.

A file is the same where its device, inode, size, time of modification and time of change are: so git's index takes it. One that was
written so shortly before it was read that a later change might bear the same times is not remembered (git calls such a file racy). Nobody
but the system sets the time of change, so that a file whose time of modification was put back is read again. Where that time has no
fraction of a second, the file system is coarse, or an image whose files all bear one time: there nothing is remembered either.
"""

from __future__ import annotations

import os
import stat
import time
from collections.abc import Callable
from contextlib import suppress

from launchlint.errors import UsageError
from launchlint.named_tuple import NamedTuple
from launchlint.workspace.reading import read_bytes

FORMAT = 1
"""Of what is kept; another one is not read."""
RACY = 3_000_000_000
"""Nanoseconds from the last change of a file to its being read, after which a later change bears other times on any file system."""
WORTH_WRITING = 50
"""New digests and facts from which all is written: to find fewer than that again takes less time than writing."""
MOST_FILES = 400_000
"""Files that are remembered; where there are more, only those that this run has looked at."""
LARGEST_FILE = 64 << 20
"""Bytes: a larger file is not read here (nor as a launch file: :mod:`launchlint.evaluate.session`)."""
LARGEST_KEPT = 256 << 20
"""Bytes of what is kept."""
_TRUSTED = os.name == "posix"
"""Elsewhere the time of change may be that of creation, which says nothing."""
_PART = 1 << 20
_SIGNATURE = 5
"""Numbers that :func:`_signature` gives; behind them a digest and facts are kept."""
_SECOND = 1_000_000_000
_NO_SIGNATURE = (0,) * _SIGNATURE
_BROKEN = (OSError, ValueError, TypeError, KeyError, IndexError, AttributeError, RecursionError)

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any, TypeVar

    Made = TypeVar("Made")


class _Held(NamedTuple):
    """What a plain file holds: bytes, and their SHA-1 in hexadecimal."""

    size: int
    digest: str


class Contents:
    """What files (absolute) hold. ``file`` is where that is kept for later runs; ``version`` is that of who makes facts."""

    def __init__(self, file: str) -> None:
        self._file = file
        self.version, self._kept = _read(file) if _TRUSTED else ("", {})
        self._statuses: dict[str, os.stat_result] = {}
        self._found: dict[str, _Held | None] = {}
        self._facts: dict[str, dict[str, Any]] = {}
        self._new: dict[str, list[Any]] = {}
        self._count = 0

    def begin(self, version: str) -> None:
        """Before any fact is asked for: ``version`` is that of the program which makes them. Those of another one are forgotten."""
        if version != self.version:
            self.version = version
            for known in self._kept.values():
                known[_SIGNATURE + 1] = {}
            self._facts.clear()

    def seen(self, path: str, status: os.stat_result) -> None:
        """``status`` is what ``stat`` has said of ``path`` in this run, and is not asked again."""
        self._statuses[path] = status

    def tells(self, path: str, now: int) -> bool:
        """Whether a change of a file that was :meth:`seen`, after ``now`` (in nanoseconds), would show in its :meth:`mark`."""
        return _TRUSTED and _tells(self._statuses[path], now)

    def mark(self, path: str) -> str:
        """What ``stat`` has said of a file that was :meth:`seen`."""
        return " ".join(map(str, _signature(self._statuses[path])))

    def is_as_seen(self, path: str) -> bool:
        """Whether ``stat`` now says the same of a file that was :meth:`seen`."""
        try:
            return _signature(os.stat(path)) == _signature(self._statuses[path])
        except OSError:
            return False

    def sha1(self, path: str, largest: int = LARGEST_FILE) -> str | None:
        """SHA-1 of a plain file of at most ``largest`` bytes, in hexadecimal; None where there is none that can be read."""
        try:
            held = self._found[path]
        except KeyError:
            held = self._found[path] = self._hold(path)
        return held.digest if held is not None and held.size <= largest else None

    def fact(self, path: str, kind: str, make: Callable[[bytes], Made], write: Callable[[Made], Any], read: Callable[[Any], Made]) -> Made:
        """What ``make`` makes of the content of a small file, and of nothing else.

        ``kind`` is a name for that; ``write`` gives it as JSON values, and ``read`` is the inverse. Raises what ``make`` raises, and
        OSError as :func:`launchlint.workspace.reading.read_bytes`.
        """
        digest = self.sha1(path)
        facts = self._facts.get(path)
        if facts is not None and kind in facts:
            try:
                return read(facts[kind])
            except _BROKEN:
                pass  # somebody else wrote it
        data = read_bytes(path)
        made = make(data)
        if digest is not None and _sha1(data) == digest:  # else the file has changed since
            self._facts.setdefault(path, {})[kind] = write(made)
            self._count += 1
        return made

    def keep(self) -> None:
        """Keep what is new, for later runs, where that is worth while."""
        if not _TRUSTED or len(self._new) + self._count < WORTH_WRITING:
            return
        import json

        from launchlint.atomic import seal, write_text

        files = {**self._kept, **self._new}
        if len(files) > MOST_FILES:
            files = {path: known for path, known in files.items() if path in self._found}
        for path, facts in self._facts.items():
            held, known = self._found.get(path), files.get(path)
            if held is not None and known is not None and known[_SIGNATURE] == held.digest:
                known[_SIGNATURE + 1] = facts
        text = json.dumps([FORMAT, self.version, files], separators=(",", ":"))
        self._new.clear()
        self._kept, self._count = files, 0
        with suppress(OSError, UsageError):
            os.makedirs(os.path.dirname(self._file), mode=0o700, exist_ok=True)
            write_text(self._file, seal("", text) + text)

    def _hold(self, path: str) -> _Held | None:
        try:
            status = self._statuses.get(path) or os.stat(path)
            if not stat.S_ISREG(status.st_mode) or status.st_size > LARGEST_FILE:
                return None
            known = self._kept.get(path)
            if known is not None and known[:_SIGNATURE] == _signature(status):
                held: _Held | None = _Held(status.st_size, known[_SIGNATURE])
            else:
                held = self._hashed(path)
        except (OSError, ValueError):
            return None
        if held is not None and known is not None and known[_SIGNATURE] == held.digest:
            self._facts[path] = known[_SIGNATURE + 1]
        return held

    def _hashed(self, path: str) -> _Held | None:
        from hashlib import sha1

        now = time.time_ns()
        found = sha1(usedforsecurity=False)
        # O_NONBLOCK: not to wait for ever on a named pipe that was a file a moment ago.
        flags = os.O_RDONLY | getattr(os, "O_NONBLOCK", 0) | getattr(os, "O_CLOEXEC", 0) | getattr(os, "O_BINARY", 0)
        descriptor = os.open(path, flags)
        try:
            before = os.fstat(descriptor)
            if not stat.S_ISREG(before.st_mode):
                return None
            size = 0
            while size <= LARGEST_FILE and (part := os.read(descriptor, _PART)):
                found.update(part)
                size += len(part)
            after = os.fstat(descriptor)
        finally:
            os.close(descriptor)
        if size > LARGEST_FILE:
            return None
        held, signature = _Held(size, found.hexdigest()), _signature(after)
        unchanged = signature == _signature(before) and size == after.st_size
        known = self._kept.get(path)
        if unchanged and _tells(after, now):
            self._new[path] = [*signature, held.digest, {}]
        elif known is None or known[_SIGNATURE] != held.digest:
            self._new[path] = [*_NO_SIGNATURE, held.digest, {}]  # to be read again; its facts hold if it is the same then
        return held


def _signature(status: os.stat_result) -> list[int]:
    return [status.st_dev, status.st_ino, status.st_size, status.st_mtime_ns, status.st_ctime_ns]


def _tells(status: os.stat_result, now: int) -> bool:
    """Whether a change after ``now`` would show in what ``stat`` says of a file."""
    return max(status.st_mtime_ns, status.st_ctime_ns) < now - RACY and status.st_ctime_ns % _SECOND != 0


def _sha1(data: bytes) -> str:
    from hashlib import sha1

    return sha1(data, usedforsecurity=False).hexdigest()


def _read(file: str) -> tuple[str, dict[str, list[Any]]]:
    """What is kept: the version that made the facts, and what is known of each file; nothing where it is broken."""
    import json

    from launchlint.atomic import seal

    try:
        with open(file, encoding="utf-8") as stream:
            text = stream.read(LARGEST_KEPT)
        if text[:40] != seal("", text[40:]):
            return "", {}
        number, version, files = json.loads(text[40:])
        if number != FORMAT or not isinstance(version, str) or not all(map(_is_whole, files.values())):
            return "", {}
        with suppress(OSError):
            os.utime(file)
        return version, dict(files)
    except _BROKEN:
        return "", {}


def _is_whole(known: Any) -> bool:
    return isinstance(known, list) and len(known) == _SIGNATURE + 2 and isinstance(known[-2], str) and isinstance(known[-1], dict)
