"""Putting a changed text back where it was read."""

from __future__ import annotations

import os

from launchlint.atomic import write_bytes
from launchlint.errors import UsageError


def write_back(file: str, before: bytes, after: bytes, inside: str) -> None:
    """Write ``after`` to ``file``, which held ``before`` when it was read and must lie in the directory ``inside``.

    All of it or nothing, with the permissions it had; a symbolic link stays one where its target lies in ``inside`` too. Raises
    :class:`UsageError`, and writes nothing, where the target lies elsewhere, is no plain file, may not be written, or has been changed
    since it was read.
    """
    if before == after:
        return
    try:
        target = os.path.realpath(file)
        directory = os.path.realpath(inside)
        if os.path.commonpath((target, directory)) != directory:
            raise _refused(file, f"it lies outside of {inside!r}, which is what may be changed")
        if not os.path.isfile(target):
            raise _refused(file, "it is no plain file any more")
        if not os.access(target, os.W_OK):
            raise _refused(file, "it is write-protected")
        with open(target, "rb") as stream:
            if stream.read(len(before) + 1) != before:
                raise _refused(file, "it was changed by something else in the meantime; run the command again")
    except (OSError, ValueError) as error:  # ValueError: a null byte in the name, or another drive
        reason = error.strerror if isinstance(error, OSError) and error.strerror else str(error)
        raise _refused(file, reason) from error
    write_bytes(target, after, what="the changed file")


def _refused(file: str, reason: str) -> UsageError:
    return UsageError(f"{file!r} is left as it is: {reason}")
