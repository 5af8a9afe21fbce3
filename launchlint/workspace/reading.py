"""Reading small files that may be anything."""

from __future__ import annotations

import os
import stat

LARGEST_FILE = 1 << 20
"""In bytes. The largest package.xml, CMakeLists.txt or configuration in public use has a tenth of it."""


def read_bytes(path: str, largest: int = LARGEST_FILE) -> bytes:
    """Content of a plain file of at most ``largest`` bytes.

    Raises:
        OSError: it cannot be read, is no plain file, or is larger.
    """
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
