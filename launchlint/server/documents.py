"""The files that are open in the editor, and the texts of others that an answer speaks of."""

from __future__ import annotations

from lsprotocol import types

from launchlint.ide.view import Snapshot, Target, View
from launchlint.server.addresses import address_of
from launchlint.server.positions import Lines
from launchlint.source import Span
from launchlint.syntax.decode import decode

TYPE_CHECKING = False
if TYPE_CHECKING:
    from launchlint.server.positions import Unit


class Document:
    """An open file: its text, the number of its version, the address under which the editor knows it."""

    def __init__(self, address: str, file: str, text: str, version: int, unit: Unit, encoding: str = "utf-8", mark: bytes = b"") -> None:
        self.address = address
        self.file = file
        self.version = version
        self.encoding = encoding
        self.mark = mark
        self._unit: Unit = unit
        self.lines = Lines(text, unit)
        self._view: tuple[Snapshot, View] | None = None

    @property
    def text(self) -> str:
        """What it holds."""
        return self.lines.text

    @property
    def data(self) -> bytes:
        """The same as it would be saved."""
        try:
            return self.mark + self.text.encode(self.encoding)
        except (UnicodeEncodeError, LookupError):
            return self.text.encode("utf-8", "replace")

    def change(self, changes: list[types.TextDocumentContentChangeEvent], version: int) -> None:
        """What was typed: stretches, one after another, or all of it."""
        for each in changes:
            if isinstance(each, types.TextDocumentContentChangePartial):
                span = self.lines.span(each.range)
                text = self.text
                self.lines = Lines(text[: span.start] + each.text + text[span.end :], self._unit)
            else:
                self.lines = Lines(each.text, self._unit)
        self.version = version
        self._view = None

    def view(self, snapshot: Snapshot) -> View:
        """What is known of it, made once for each text."""
        if self._view is None or self._view[0] is not snapshot:
            self._view = (snapshot, View(snapshot, self.file, self.text))
        return self._view[1]


class Documents:
    """All that are open, by their files (absolute), and the texts of others."""

    def __init__(self) -> None:
        self.unit: Unit = "utf-16"
        self._open: dict[str, Document] = {}

    def open(self, address: str, file: str, text: str, version: int) -> Document:
        """Take a file that was opened; it will be saved in the encoding that it has."""
        encoding, mark = "utf-8", b""
        try:
            with open(file, "rb") as stream:
                decoded = decode(stream.read())
                encoding, mark = decoded.encoding, decoded.bom
        except OSError:
            pass
        self._open[file] = Document(address, file, text.removeprefix("\ufeff") if mark else text, version, self.unit, encoding, mark)
        return self._open[file]

    def close(self, file: str) -> None:
        """It is not open any more."""
        self._open.pop(file, None)

    def get(self, file: str) -> Document | None:
        """An open file."""
        return self._open.get(file)

    @property
    def files(self) -> list[str]:
        """All that are open."""
        return list(self._open)

    def lines(self, file: str) -> Lines:
        """The text of a file, as the editor has it or as it is on disk; empty where it cannot be read."""
        known = self._open.get(file)
        if known is not None:
            return known.lines
        try:
            with open(file, "rb") as stream:
                return Lines(decode(stream.read()).text, self.unit)
        except OSError:
            return Lines("", self.unit)

    def address(self, file: str) -> str:
        """The address of a file, as the editor spells it where it is open."""
        known = self._open.get(file)
        return address_of(file) if known is None else known.address

    def location(self, target: Target) -> types.Location:
        """Where something is."""
        return types.Location(self.address(target.file), self.lines(target.file).range(target.span))

    def range(self, file: str, start: int, end: int) -> types.Range:
        """A stretch of a file."""
        return self.lines(file).range(Span(start, end))
