"""The output of the program beside the nodes, as records: bounded in the length of a line and in all, whatever is printed."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from launchlint.probe.record import Record, Refused, parse

LONGEST_LINE = 16 * 2**20
"""Bytes; a longer one is no record."""
LARGEST_OUTPUT = 1 * 2**30
"""Bytes of all output of one run."""
MOST_REFUSED = 1_000
"""Lines that are no records, until it is taken for granted that this is not our program."""


class TooMuch(Exception):
    """It prints without end; ``str(error)`` says what."""


class Stream:
    """Bytes in, records out. ``refused`` counts the lines that were none, ``first`` says what was wrong with the first of them."""

    def __init__(self, *, longest: int = LONGEST_LINE, largest: int = LARGEST_OUTPUT) -> None:
        self.refused = 0
        self.first = ""
        self._longest = longest
        self._largest = largest
        self._total = 0
        self._rest = bytearray()
        self._too_long = False

    def records(self, chunks: Iterable[bytes]) -> Iterator[Record]:
        """The records in some output, each as soon as its line is complete.

        Raises:
            TooMuch: there is more output than a probe has.
        """
        for chunk in chunks:
            self._total += len(chunk)
            if self._total > self._largest:
                raise TooMuch(f"it printed more than {self._largest // 2**20} MiB")
            yield from self._feed(chunk)
        yield from self._feed(b"\n")

    def _feed(self, chunk: bytes) -> Iterator[Record]:
        first, newline, rest = chunk.partition(b"\n")
        while newline:
            if not self._too_long and len(self._rest) + len(first) <= self._longest:
                self._rest += first
                yield from self._record(bytes(self._rest))
            else:
                self._refuse("it is too long")
            self._rest.clear()
            self._too_long = False
            first, newline, rest = rest.partition(b"\n")
        if len(self._rest) + len(first) > self._longest:
            self._too_long = True
            self._rest.clear()
        elif not self._too_long:
            self._rest += first

    def _record(self, line: bytes) -> Iterator[Record]:
        if not line.strip():
            return
        try:
            yield parse(line.decode("utf-8", "replace"))
        except Refused as reason:
            self._refuse(str(reason))

    def _refuse(self, why: str) -> None:
        self.refused += 1
        self.first = self.first or why
        if self.refused > MOST_REFUSED:
            raise TooMuch(f"it printed {self.refused} lines that are no records: {self.first}")
