"""Edits on the text of a file: made all at once, without touching any other byte."""

from __future__ import annotations

from bisect import bisect_right, insort
from collections.abc import Iterable, Sequence

from launchlint.finding import Edit
from launchlint.syntax.decode import decode


class CannotEdit(Exception):
    """The edits cannot be made; ``str(error)`` says why."""


def apply(data: bytes, edits: Iterable[Edit]) -> bytes:
    """``data``, the content of an XML file, after ``edits``, which are all of this file and do not overlap.

    Byte order mark, encoding and line ends stay as they are. Insertions at one place come in the order given. Raises :class:`CannotEdit`.
    """
    decoded = decode(data)
    text, encoding = decoded.text, decoded.encoding
    try:
        if decoded.bom + text.encode(encoding) != data:
            raise CannotEdit(f"not all of its bytes are {encoding}")
        pieces: list[str] = []
        done = 0
        for edit in sorted(edits, key=lambda each: (each.start, each.end)):
            if not done <= edit.start <= edit.end <= len(text):
                raise CannotEdit("it has been changed since it was checked")
            pieces += (text[done : edit.start], edit.text)
            done = edit.end
        return decoded.bom + "".join([*pieces, text[done:]]).encode(encoding)
    except UnicodeEncodeError as error:
        raise CannotEdit(f"its encoding, {encoding}, cannot hold {error.object[error.start : error.end]!r}") from error


class Claims:
    """The stretches of files that edits have been chosen for."""

    def __init__(self) -> None:
        self._spans: dict[str, list[tuple[int, int]]] = {}

    def take(self, edits: Sequence[Edit]) -> bool:
        """Claim what ``edits`` change; False, and nothing is claimed, where one of them meets a stretch that is taken.

        Stretches may touch each other, and there may be several insertions at one place, but none at the border of a stretch.
        """
        if any(self._meets(edit) for edit in edits):
            return False
        for edit in edits:
            insort(self._spans.setdefault(edit.path, []), (edit.start, edit.end))
        return True

    def _meets(self, edit: Edit) -> bool:
        spans = self._spans.get(edit.path, [])
        at = bisect_right(spans, (edit.start, edit.end))
        return any(_meet(edit.start, edit.end, *span) for span in spans[max(0, at - 1) : at + 1])


def _meet(start: int, end: int, other_start: int, other_end: int) -> bool:
    if start == end and other_start == other_end:
        return False
    if start == end or other_start == other_end:
        return start <= other_end and other_start <= end
    return start < other_end and other_start < end


class Shift:
    """Where the places of a file are after ``edits`` of it."""

    __slots__ = ("_edits", "_moved", "_starts")

    def __init__(self, edits: Iterable[Edit]) -> None:
        self._edits = sorted(edits, key=lambda edit: (edit.start, edit.end))
        self._starts = [edit.start for edit in self._edits]
        self._moved = [0]
        for edit in self._edits:
            self._moved.append(self._moved[-1] + len(edit.text) - (edit.end - edit.start))

    def __call__(self, offset: int) -> int:
        """The new offset; what is replaced moves to the start of what replaces it."""
        number = bisect_right(self._starts, offset)
        if number:
            last = self._edits[number - 1]
            if offset < last.end:
                return last.start + self._moved[number - 1]
        return offset + self._moved[number]
