"""From the bytes of an XML file to its text, decoded as expat decodes it.

expat knows UTF-8, UTF-16, ISO-8859-1 and US-ASCII; for any other name pyexpat asks Python to decode the 256 single bytes and takes
that as a table (``Modules/pyexpat.c``, ``PyUnknownEncodingHandler``).
"""

from __future__ import annotations

from launchlint.late import late

_DECLARED = late(rb"<\?xml[ \t\r\n][^>]*?encoding[ \t\r\n]*=[ \t\r\n]*[\"']([A-Za-z][A-Za-z0-9._-]*)")
_UTF8 = ("utf-8", "utf-16", "utf-16le", "utf-16be")  # a declared UTF-16 in a file of single bytes is an error: shown as UTF-8


class Decoded:
    """The text of a file and the way from byte offsets to offsets in it.

    ``direct`` says that the two are the same. ``encoding`` is a Python codec name, ``declared`` what the XML declaration says.
    """

    __slots__ = ("_counting", "_data", "_known_byte", "_known_offset", "bom", "declared", "direct", "encoding", "text")

    def __init__(self, data: bytes, text: str, encoding: str, bom: bytes, declared: str, counting: str) -> None:
        """``counting`` is the codec that says how many bytes a character has: ``utf-8``, ``utf-16-le``, ``utf-16-be`` or ``latin-1``."""
        self.text = text
        self.encoding = encoding
        self.bom = bom
        self.direct = not bom and counting == "latin-1"
        self.declared = declared
        self._data = data
        self._counting = counting
        self._known_byte = len(bom)
        self._known_offset = 0

    def offset(self, byte: int) -> int:
        """The offset in ``text`` of the character that starts at ``byte``; fast where the calls go forward."""
        if self.direct:
            return max(0, min(byte, len(self.text)))
        bom = len(self.bom)
        if byte <= bom:
            return 0
        if byte < self._known_byte:
            self._known_byte, self._known_offset = bom, 0
        elif byte == self._known_byte:
            return self._known_offset
        self._known_offset += len(self._data[self._known_byte : byte].decode(self._counting, "replace"))
        self._known_byte = byte
        return min(self._known_offset, len(self.text))

    def byte(self, offset: int) -> int:
        """The value of the first byte of the character at ``offset`` as it stands in the file, for messages; -1 at the end."""
        low, high = 0, len(self._data)
        if not self.direct:
            while low < high:
                middle = (low + high) // 2
                if self.offset(middle) < offset:
                    low = middle + 1
                else:
                    high = middle
        else:
            low = offset
        return self._data[low] if low < len(self._data) else -1


def decode(data: bytes) -> Decoded:
    """Decode ``data``; what cannot be decoded becomes U+FFFD (expat then refuses the file at that place)."""
    start = data[:4]
    if start[:2] == b"\xff\xfe":
        return _utf16(data, "utf-16-le", data[:2])
    if start[:2] == b"\xfe\xff":
        return _utf16(data, "utf-16-be", data[:2])
    # Without a mark, one zero byte among the first two says UTF-16 (expat's initScan).
    if start[:1] == b"\0" and len(data) > 1:
        return _utf16(data, "utf-16-be", b"")
    if start[1:2] == b"\0":
        return _utf16(data, "utf-16-le", b"")
    bom = b"\xef\xbb\xbf" if start[:3] == b"\xef\xbb\xbf" else b""
    found = _DECLARED.match(data, len(bom)) if start[:1] in (b"<", b"\xef") else None
    declared = "" if found is None else found[1].decode("ascii")
    name = declared.lower()
    content = data[len(bom) :] if bom else data
    if not name or name in _UTF8 or name == "us-ascii":
        encoding = "ascii" if name == "us-ascii" else "utf-8"
        return Decoded(data, content.decode("utf-8", "replace"), encoding, bom, declared, "latin-1" if data.isascii() else "utf-8")
    if name == "iso-8859-1":
        return Decoded(data, content.decode("latin-1"), "iso-8859-1", bom, declared, "latin-1")
    try:
        table = bytes(range(256)).decode(name, "replace")
    except (LookupError, ValueError, TypeError, Warning):  # a warning where they are turned into errors
        table = ""
    if len(table) != 256:  # expat will refuse it
        return Decoded(data, content.decode("utf-8", "replace"), "utf-8", bom, declared, "utf-8")
    return Decoded(data, content.decode("latin-1").translate(dict(enumerate(table))), name, bom, declared, "latin-1")


def _utf16(data: bytes, encoding: str, bom: bytes) -> Decoded:
    return Decoded(data, data[len(bom) :].decode(encoding, "replace"), encoding, bom, "", encoding)
