"""What has been probed so far, on disk as soon as it is known: an interruption loses nothing, and ``--resume`` goes on from there."""

from __future__ import annotations

import os
from contextlib import suppress

from launchlint.atomic import check_target
from launchlint.errors import UsageError
from launchlint.probe.record import LaunchRecord, NodeRecord, Refused, parse

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import IO

SUFFIX = ".partial.jsonl"

Done = NodeRecord | LaunchRecord


class Journal:
    """The records of a run, one line each, in a file beside the library that will be made of them."""

    def __init__(self, output: str, *, resume: bool) -> None:
        """A journal for ``output``. Its file is made with the first record: a run that comes to nothing leaves the file of an earlier one.

        Args:
            output: the library to be written.
            resume: go on with what is there already; else begin anew.

        Raises:
            UsageError: the file cannot be written.
        """
        self.path = output + SUFFIX
        check_target(self.path, what="what is probed")
        self.records: list[Done] = _read(self.path) if resume else []
        self._file: IO[str] | None = None

    def add(self, record: Done) -> None:
        """Keep a record.

        Raises:
            UsageError: the file cannot be written.
        """
        self.records.append(record)
        try:
            if self._file is None:
                self._file = open(self.path, "w", encoding="utf-8")  # noqa: SIM115 (closed by close())
                self._file.writelines(each.line + "\n" for each in self.records[:-1])
            self._file.write(record.line + "\n")
            self._file.flush()
        except (OSError, ValueError) as error:
            reason = error.strerror if isinstance(error, OSError) and error.strerror else str(error)
            raise UsageError(f"cannot write what is probed to {self.path!r}: {reason}") from None

    @property
    def done(self) -> list[str]:
        """The fingerprints of what need not be probed again."""
        return sorted({record.hash for record in self.records if record.hash})

    def close(self, *, complete: bool) -> None:
        """Close the file; remove it where all its records are in the library."""
        if self._file is not None:
            self._file.close()
        if complete:
            with suppress(FileNotFoundError):
                os.unlink(self.path)


def _read(path: str) -> list[Done]:
    """The records of an earlier run; a line that was cut off is none."""
    found: dict[str, Done] = {}
    try:
        with open(path, encoding="utf-8", errors="replace") as file:
            for line in file:
                try:
                    record = parse(line)
                except Refused:
                    continue
                if isinstance(record, (NodeRecord, LaunchRecord)):
                    found[record.hash] = record
    except OSError:
        return []
    return list(found.values())
