"""Writing a file so that nobody ever sees half of it, and telling what was written whole."""

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
    write_bytes(path, text.encode("utf-8", "replace"), what=what)


def write_bytes(path: str, data: bytes, *, what: str = "the file") -> None:
    """As :func:`write_text`, for bytes that are written as they are."""
    try:
        target, mode = _checked(path, what)
        if mode is not None and not stat.S_ISREG(mode):
            with open(path, "wb") as special:
                special.write(data)
            return
        _replace(target, data, None if mode is None else stat.S_IMODE(mode))
    except (OSError, ValueError) as error:  # ValueError: a null byte in the name
        raise _cannot(path, what, error) from error


def check_target(path: str, *, what: str = "the file") -> None:
    """Raise the :class:`UsageError` of :func:`write_text` where ``path`` is a directory or lies in none, without writing anything."""
    try:
        _checked(path, what)
    except (OSError, ValueError) as error:
        raise _cannot(path, what, error) from error


def seal(key: str, text: str) -> str:
    """What is kept beside ``text`` under ``key``, so that what a broken disk or an unfinished write has changed is known."""
    import hashlib

    return hashlib.sha1(f"{key}\0{text}".encode("utf-8", "surrogateescape"), usedforsecurity=False).hexdigest()


def _checked(path: str, what: str) -> tuple[str, int | None]:
    """The file that ``path`` leads to, and its mode if it is there."""
    target = os.path.realpath(path)
    mode = _mode(target)
    if mode is not None and stat.S_ISDIR(mode):
        raise UsageError(f"cannot write {what} to {path!r}: it is a directory; give the name of a file")
    if (mode is None or stat.S_ISREG(mode)) and not os.path.isdir(os.path.dirname(target)):
        raise UsageError(f"cannot write {what} to {path!r}: the directory {os.path.dirname(path) or '.'!r} does not exist; create it first")
    return target, mode


def _cannot(path: str, what: str, error: OSError | ValueError) -> UsageError:
    reason = error.strerror if isinstance(error, OSError) and error.strerror else str(error)
    return UsageError(f"cannot write {what} to {path!r}: {reason}")


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
