"""Reading small files that may be anything."""

from __future__ import annotations

import os
import stat
from _thread import _local
from collections.abc import Iterator, Mapping
from contextlib import contextmanager

LARGEST_FILE = 1 << 20
"""In bytes. The largest package.xml, CMakeLists.txt or configuration in public use has a tenth of it."""


class _StandIns(_local):
    """Texts that a thread reads instead of files (absolute names)."""

    texts: Mapping[str, bytes] = {}


_stand_ins = _StandIns()


@contextmanager
def standing_in(texts: Mapping[str, bytes]) -> Iterator[None]:
    """While it lasts, files (absolute names) hold ``texts`` for whatever this thread reads: those of an editor that are not saved yet."""
    before = _stand_ins.texts
    _stand_ins.texts = texts
    try:
        yield
    finally:
        _stand_ins.texts = before


def stand_ins() -> Mapping[str, bytes]:
    """The texts that this thread reads instead of files, to be given to another thread that works for it."""
    return _stand_ins.texts


def read_bytes(path: str, largest: int = LARGEST_FILE) -> bytes:
    """Content of a plain file of at most ``largest`` bytes, or the text that stands in for it (:func:`standing_in`).

    Raises:
        OSError: it cannot be read, is no plain file, or is larger.
    """
    if _stand_ins.texts and (text := _stand_ins.texts.get(os.path.abspath(path))) is not None:
        if len(text) > largest:
            raise OSError(f"it is larger than {largest} bytes")
        return text
    # O_NONBLOCK: not to wait for ever on a named pipe that calls itself package.xml.
    flags = os.O_RDONLY | getattr(os, "O_NONBLOCK", 0) | getattr(os, "O_CLOEXEC", 0) | getattr(os, "O_BINARY", 0)
    try:
        descriptor = os.open(path, flags)
    except ValueError as error:
        raise OSError(str(error)) from error
    try:
        status = os.fstat(descriptor)
        if not stat.S_ISREG(status.st_mode):
            raise OSError("it is not a plain file")
        if status.st_size > largest:
            raise OSError(f"it is larger than {largest} bytes")
        parts: list[bytes] = []
        left = largest
        while left > 0 and (part := os.read(descriptor, left)):
            parts.append(part)
            left -= len(part)
            if len(part) >= status.st_size:
                break
        return b"".join(parts)
    finally:
        os.close(descriptor)
