"""What is wrong inside one tag, comment or stretch of text that expat could not read."""

from __future__ import annotations

import re

from launchlint.source import Span
from launchlint.syntax.decode import Decoded
from launchlint.syntax.tags import CONFLICT, Token, Verdict, Written, attributes_of, conflict_verdict, token_at
from launchlint.syntax.tree import Document


def bad_token(decoded: Decoded, offset: int, document: Document, last_end: int) -> Verdict:
    """Expat could not go on at ``offset``; everything up to ``last_end`` was in order."""
    text = decoded.text
    byte = decoded.byte(offset) if offset < len(text) else -1
    if byte >= 0x80 and text[offset] == "\ufffd" and document.encoding in ("utf-8", "ascii"):
        where = Span(offset, offset + 1)
        return Verdict(
            f"the byte 0x{byte:02X} is not valid UTF-8",
            where,
            'save the file as UTF-8, or declare its encoding, for example encoding="ISO-8859-1"',
        )
    if byte >= 0x80 and document.encoding == "ascii":
        return Verdict("a character that is not in US-ASCII, as the file declares", Span(offset, offset + 1), 'declare encoding="UTF-8"')
    if 0 <= byte < 0x20 and text[offset] not in "\t\r\n":
        return Verdict(f"the control character U+{ord(text[offset]):04X} is not allowed in XML", Span(offset, offset + 1), "remove it")
    if text.startswith(("\ufffe", "\uffff"), offset):
        return Verdict(f"the character U+{ord(text[offset]):04X} is not allowed in XML", Span(offset, offset + 1), "remove it")
    token = token_at(text, last_end, offset)
    if (conflict := CONFLICT.match(text, token.start)) is not None or (conflict := CONFLICT.match(text, offset)) is not None:
        return conflict_verdict(Span(*conflict.span()))
    if token.kind == "comment":
        return _comment(text, token)
    if token.kind == "tag":
        return _tag(text, offset, token)
    if token.kind == "text":
        return _text(text, offset, token, document)
    here = Span(offset, min(offset + 1, len(text)))
    if token.end >= len(text):
        return Verdict("the file ends in the middle of something", Span(token.start, min(token.start + 2, len(text))), "it is never closed")
    return Verdict("this is not XML", here)


def _comment(text: str, token: Token) -> Verdict:
    end = text.find("-->", token.start + 4)
    double = text.find("--", token.start + 4)
    if end < 0 and double < 0:
        return Verdict("a comment is never closed", Span(token.start, token.start + 4), "it must end with -->")
    span = Span(double, double + 2)
    opening = text.find("<!--", token.start + 4, end if end >= 0 else None)
    if opening >= 0 and double == opening + 2:
        hint = "a comment cannot stand inside another one: end the first one with --> before it"
        return Verdict("-- stands inside a comment", span, hint, ((Span(token.start, token.start + 4), "the comment begins here"),))
    return Verdict(
        "-- stands inside a comment",
        span,
        "XML does not allow it there: use one hyphen or other words",
        ((Span(token.start, token.start + 4), "the comment begins here"),),
    )


def _text(text: str, offset: int, token: Token, document: Document) -> Verdict:
    here = Span(offset, min(offset + 1, len(text)))
    if document.root is None:
        end = token.start + len(text[token.start : token.end].rstrip())
        return Verdict("text stands before the first element", Span(token.start, max(end, token.start)), "remove it")
    ampersand = text.rfind("&", token.start, offset + 1)
    if ampersand >= 0 and not re.match(r"&[^;&<\s]+;", text[ampersand:offset]):
        return Verdict("a bare & in the text", Span(ampersand, ampersand + 1), "write &amp;")
    if text.startswith("]]>", offset) or text.startswith("]]>", offset - 2):
        start = offset if text.startswith("]]>", offset) else offset - 2
        return Verdict("]]> stands in the text", Span(start, start + 3), "write ]]&gt;")
    if text.startswith("<", offset):
        return Verdict("a bare < in the text", here, "write &lt;")
    return Verdict("this is not XML", here)


def _tag(text: str, offset: int, token: Token) -> Verdict:
    """What is wrong in the tag ``token`` that expat could not read past ``offset``."""
    here = Span(offset, min(offset + 1, len(text)))
    if not token.name:
        return Verdict("a bare < in the text", Span(token.start, token.start + 1), "write &lt;")
    if token.closing:
        return Verdict(
            f"the end tag </{token.name} is not complete",
            Span(token.start, min(max(offset, token.start + 2), len(text))),
            f"write </{token.name}>",
        )
    before: Written | None = None
    for written in attributes_of(text, token):
        if written.value_start < 0:
            return _no_value(text, written, before)
        if before is not None and before.end == written.start:
            if _swallowed(text, before):
                return _open_quote(text, before)
            return Verdict(
                f"a blank is missing between {before.name} and {written.name}",
                Span(written.start, written.start + len(written.name)),
                f"put a blank before {written.name}",
            )
        value = text[written.value_start : written.value_end]
        less = value.find("<")
        if written.value_end < 0 or less >= 0:
            return _less_or_open(text, written, token)
        if (ampersand := _bare_ampersand(value)) >= 0:
            at = written.value_start + ampersand
            return Verdict(f"a bare & in the value of {written.name}", Span(at, at + 1), "write &amp; for each &")
        before = written
    if before is not None and offset == before.end and offset < len(text) and text[offset] not in "/> \t\r\n":
        if _swallowed(text, before):
            return _open_quote(text, before)
        return Verdict(f"{text[offset]!r} does not belong after the value of {before.name}", here, "remove it")
    if offset >= len(text) or token.end >= len(text) or text.startswith("<", offset):
        return Verdict(
            f"the tag <{token.name} has no > at its end", Span(token.start, token.start + 1 + len(token.name)), "end it with /> or >"
        )
    if text.startswith("/", offset) or text.startswith("/", offset - 1):
        return Verdict(f"<{token.name} does not end properly", here, "end it with /> (nothing between the two)")
    return Verdict(f"{text[offset]!r} does not belong in the tag <{token.name}", here, "remove it")


def _bare_ampersand(value: str) -> int:
    match = re.search(r"&(?!#[0-9]+;|#x[0-9a-fA-F]+;|[^\s;&<#]+;)", value)
    return -1 if match is None else match.start()


def _no_value(text: str, written: Written, before: Written | None) -> Verdict:
    """An attribute without ``="…"``; after a value that ate the beginning of the next attribute it is the rest of that one."""
    if before is not None and _swallowed(text, before):
        return _open_quote(text, before)
    span = Span(written.start, written.start + len(written.name))
    if text[written.start + len(written.name) :].lstrip().startswith("="):
        return Verdict(f"the value of {written.name} is not in quotes", span, f'write {written.name}="…"')
    first = written.name[0]
    if before is not None and before.end == written.start and not (first.isalnum() or first in "_:\"'"):
        return Verdict(f"{first!r} does not belong after the value of {before.name}", Span(span.start, span.start + 1), "remove it")
    if '"' in written.name or "'" in written.name or (before is not None and before.end == written.start):
        return Verdict("a quote too many or too few", span, "each value stands between two quotes")
    return Verdict(f"{written.name} has no value", span, f'write {written.name}="…", or remove it')


def _swallowed(text: str, written: Written) -> bool:
    """Does the value end like ``… name=``? Then its closing quote is really the opening quote of the next attribute."""
    return re.search(r"(?:^|[\s/>])[\w.:-]+[ \t\r\n]*=[ \t\r\n]*$", text[written.value_start : written.value_end]) is not None


def _open_quote(text: str, written: Written) -> Verdict:
    value = text[written.value_start : written.value_end if written.value_end >= 0 else len(text)]
    cut = re.search(r"(?<!\s)(?:\s+[\w.:-]+[ \t]*=|\s*/?>)|[\r\n]", value)
    end = written.value_start + (cut.start() if cut else len(value))
    return Verdict(
        f"the value of {written.name} has no closing quote", Span(written.start, end), f"close it with {text[written.value_start - 1]}"
    )


def _less_or_open(text: str, written: Written, token: Token) -> Verdict:
    """A ``<`` in a value: meant as "less than", or the value was never closed and the next tag got into it."""
    value = text[written.value_start : written.value_end if written.value_end >= 0 else len(text)]
    less = value.find("<")
    head = value if less < 0 else value[:less]
    if (
        less < 0
        or ">" in head
        or "\n" in head
        or "\r" in head
        or written.value_end < 0
        or (_swallowed(text, written) and "$(eval" not in head)  # the file is broken: there is no value to take apart
    ):
        return _open_quote(text, written)
    at = written.value_start + less
    return Verdict(f"a bare < in the value of {written.name}", Span(at, at + 1), "write &lt;")
