"""Writing a file so that nobody ever sees half of it."""

from __future__ import annotations

import os
import stat

from launchlint.errors import UsageError


def write_text(path: str, text: str, *, what: str = "the file") -> None:
    """Write ``text`` as UTF-8 to ``path``, all of it or nothing.

    A temporary file in the same directory is filled first and then put in place with one rename, so that a reader, a full disk or Ctrl-C
    never leaves half a file. A symbolic link stays one (its target is replaced), and what is no regular file (``/dev/stdout``, a pipe) is
    written directly. Lone surrogates, which no encoding can hold, become ``?``. ``what`` names the file in messages. Raises
    :class:`UsageError` where it cannot be written.
    """
    data = text.encode("utf-8", "replace")
    try:
        target = os.path.realpath(path)
        mode = _mode(target)
        if mode is not None and stat.S_ISDIR(mode):
            raise UsageError(f"cannot write {what} to {path!r}: it is a directory; give the name of a file")
        if mode is not None and not stat.S_ISREG(mode):
            with open(path, "wb") as special:
                special.write(data)
            return
        if not os.path.isdir(os.path.dirname(target)):
            raise UsageError(
                f"cannot write {what} to {path!r}: the directory {os.path.dirname(path) or '.'!r} does not exist; create it first"
            )
        _replace(target, data, None if mode is None else stat.S_IMODE(mode))
    except (OSError, ValueError) as error:  # ValueError: a null byte in the name
        reason = error.strerror if isinstance(error, OSError) and error.strerror else str(error)
        raise UsageError(f"cannot write {what} to {path!r}: {reason}") from error


def _mode(path: str) -> int | None:
    try:
        return os.stat(path).st_mode
    except FileNotFoundError:
        return None


def _replace(target: str, data: bytes, mode: int | None) -> None:
    directory, name = os.path.split(target)
    temporary = os.path.join(directory, f".{name[:100]}.{os.getpid()}.tmp")
    handle = os.open(temporary, os.O_WRONLY | os.O_CREAT | os.O_EXCL, 0o666)
    try:
        with open(handle, "wb") as file:
            file.write(data)
        if mode is not None:
            os.chmod(temporary, mode)
        os.replace(temporary, target)
    except BaseException:
        os.unlink(temporary)
        raise
