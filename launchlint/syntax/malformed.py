"""Why a file is no XML: from expat's error code to the slip a person made.

Only read when a file is broken. expat says where it could not go on, which is often far behind the mistake: an
element that is never closed is noticed at the next end tag, a forgotten quote at the next quote.
"""

from __future__ import annotations

import pyexpat as expat
import re

from launchlint.source import Origin, Place, Span
from launchlint.syntax.badtoken import bad_token
from launchlint.syntax.decode import Decoded
from launchlint.syntax.problems import MalformedXml
from launchlint.syntax.tags import CONFLICT, NAME, Verdict, Written, attributes_of, conflict_verdict, token_at
from launchlint.syntax.tree import Document, Element
from launchlint.syntax.unclosed import mismatch, never_closed


def diagnose(document: Document, decoded: Decoded, code: str | int, offset: int, opened: list[Element], last_end: int) -> MalformedXml:
    """What is wrong with a file that is not well-formed.

    ``code`` is expat's error (number or name), ``offset`` where expat stopped, ``opened`` the elements open there,
    outermost first, ``last_end`` the end of the last piece that was read without error.
    """
    name = code if isinstance(code, str) else _code_name(code)
    offset = min(max(offset, 0), len(decoded.text))
    verdict = _judge(name, decoded, offset, opened, document, last_end)
    related: tuple[tuple[Place, str], ...] = tuple((document.place(span), label) for span, label in verdict.related)
    return MalformedXml(
        origin=Origin(document.place(verdict.span)), refused=True, related=related,
        message=verdict.message, code=name, hint=verdict.hint, opened=verdict.opened, closed=verdict.closed,
    )  # fmt: skip


def _code_name(code: int) -> str:
    message = expat.errors.messages.get(code)
    for name, value in vars(expat.errors).items():
        if value == message and name.startswith("XML_ERROR_"):
            return name
    return f"XML_ERROR_{code}"


def _judge(code: str, decoded: Decoded, offset: int, opened: list[Element], document: Document, last_end: int) -> Verdict:
    text = decoded.text
    here = Span(offset, min(offset + 1, len(text)))
    match code:
        case "XML_ERROR_TAG_MISMATCH":
            return mismatch(text, offset, opened)
        case "XML_ERROR_NO_ELEMENTS":
            return _no_elements(text, opened, document)
        case "XML_ERROR_JUNK_AFTER_DOC_ELEMENT":
            return _junk(text, offset, document)
        case "XML_ERROR_MISPLACED_XML_PI":
            return _late_declaration(text, offset)
        case "XML_ERROR_DUPLICATE_ATTRIBUTE":
            return _duplicate(text, offset, last_end)
        case "XML_ERROR_UNDEFINED_ENTITY":
            return _undefined_entity(text, offset, last_end)
        case "XML_ERROR_UNKNOWN_ENCODING" | "XML_ERROR_INCORRECT_ENCODING":
            return _encoding(decoded, code)
        case "XML_ERROR_UNBOUND_PREFIX":
            return _unbound(text, offset, last_end)
        case "XML_ERROR_UNCLOSED_CDATA_SECTION":
            start = text.rfind("<![CDATA[", 0, offset + 9)
            return Verdict("a CDATA section is never closed", Span(start, start + 9) if start >= 0 else here, "it must end with ]]>")
        case (
            "XML_ERROR_INVALID_TOKEN"
            | "XML_ERROR_SYNTAX"
            | "XML_ERROR_UNCLOSED_TOKEN"
            | "XML_ERROR_PARTIAL_CHAR"
            | "XML_ERROR_BAD_CHAR_REF"
        ):
            token = token_at(text, last_end, offset)
            if document.root is not None and not opened and token.kind in ("tag", "text"):
                return _junk(text, token.start + len(text[token.start : offset]) - len(text[token.start : offset].lstrip()), document)
            return bad_token(decoded, offset, document, last_end)
        case "XML_ERROR_AMPLIFICATION_LIMIT_BREACH":
            return Verdict(
                "the entities of this file expand to far more than is written",
                here,
                "expat refuses it as an attack; write the text out instead",
            )
        case "XML_ERROR_RECURSIVE_ENTITY_REF":
            return Verdict("an entity refers to itself", here)
        case "RecursionError":
            name = NAME.match(text, offset + 1)
            return Verdict(
                f"{document.max_depth + 1} elements stand inside each other",
                here if name is None else Span(offset, name.end()),
                "roslaunch walks the file by recursion and stops with: maximum recursion depth exceeded",
            )
    words = next((value for name, value in vars(expat.errors).items() if name == code), code)
    return Verdict(str(words), here)


def _no_elements(text: str, opened: list[Element], document: Document) -> Verdict:
    if opened:
        return never_closed(text, opened[-1], len(text), None, "")
    if not text.strip():
        return Verdict("the file is empty", Span(0, 0), "a launch file needs at least <launch></launch>")
    if document.comments:
        return Verdict(
            "there is no element in this file",
            Span(0, min(1, len(text))),
            "a launch file needs at least <launch></launch>; everything here is a comment",
        )
    return Verdict("there is no element in this file", Span(0, min(1, len(text))), "a launch file needs at least <launch></launch>")


def _junk(text: str, offset: int, document: Document) -> Verdict:
    root = document.root
    related = () if root is None else ((root.name_span, "the file's element"),)
    ended = () if root is None else ((root.end_span if root.end_span.end > root.end_span.start else root.start_span, "it ends here"),)
    tag = "launch" if root is None else root.tag
    name = NAME.match(text, offset + 1) if text.startswith("<", offset) else None
    if conflict := CONFLICT.match(text, offset):
        return conflict_verdict(Span(offset, conflict.end()))
    if text.startswith("</", offset):
        end = text.find(">", offset) + 1 or len(text)
        return Verdict(
            "an end tag too many", Span(offset, end), f"<{tag}> is already closed", ended, closed=text[offset + 2 : end - 1].strip()
        )
    if name is not None:
        return Verdict(
            f"a second element <{name[0]}> stands after </{tag}>",
            Span(offset, name.end()),
            "a file has one element around everything: join the two",
            related,
            closed=tag,
        )
    end = offset + len(text[offset:].split("<", 1)[0].rstrip())
    return Verdict(f"text stands after </{tag}>", Span(offset, max(end, offset)), "remove it", ended)


def _late_declaration(text: str, offset: int) -> Verdict:
    end = text.find("?>", offset) + 2
    where = Span(offset, end if end > 1 else min(offset + 5, len(text)))
    before = text[:offset]
    if not before.strip():
        what = "a blank line" if "\n" in before or "\r" in before else "a blank"
    elif before.lstrip().startswith("<?xml"):
        return Verdict("a second <?xml …?> declaration", where, "remove it")
    else:
        what = "a comment" if before.lstrip().startswith("<!--") else "something"
    return Verdict(f"{what} stands before <?xml …?>", where, "the declaration must be the very first thing in the file")


def _duplicate(text: str, offset: int, last_end: int) -> Verdict:
    token = token_at(text, last_end, offset)
    seen: dict[str, Written] = {}
    for written in attributes_of(text, token):
        first = seen.setdefault(written.name, written)
        if first is not written:
            same = text[first.value_start : first.value_end] == text[written.value_start : written.value_end]
            hint = "remove one of the two" + (" (they say the same)" if same else "")
            span = Span(written.start, written.start + len(written.name))
            return Verdict(f"the attribute {written.name} is given twice", span, hint, ((Span(first.start, first.end), "the first one"),))
    return Verdict("an attribute is given twice", Span(offset, min(offset + 1, len(text))))


def _undefined_entity(text: str, offset: int, last_end: int) -> Verdict:
    token = token_at(text, last_end, offset)
    start = offset if text.startswith("&", offset) else -1
    if start < 0:
        for match in re.finditer(r"&([^;&<\s\"']+);", text[token.start : token.end]):
            if match[1] not in ("lt", "gt", "amp", "quot", "apos") and not match[1].startswith("#"):
                start = token.start + match.start()
                break
    if start < 0:
        return Verdict("an entity that nothing declares", Span(offset, min(offset + 1, len(text))))
    end = text.find(";", start) + 1 or start + 1
    reference = text[start:end]
    return Verdict(
        f"{reference} is not known in XML", Span(start, end), "XML knows &lt; &gt; &amp; &quot; and &apos;; for a plain & write &amp;"
    )


def _encoding(decoded: Decoded, code: str) -> Verdict:
    declared = decoded.declared
    start = decoded.text.find(declared) if declared else -1
    where = Span(start, start + len(declared)) if start >= 0 else Span(0, min(5, len(decoded.text)))
    if code == "XML_ERROR_INCORRECT_ENCODING":
        return Verdict(
            f"the declared encoding {declared or '…'} is not the one of the file", where, "save the file as UTF-8 and declare UTF-8"
        )
    return Verdict(
        f"the encoding {declared or '…'} is not one that XML parsers know", where, 'save the file as UTF-8 and declare encoding="UTF-8"'
    )


def _unbound(text: str, offset: int, last_end: int) -> Verdict:
    token = token_at(text, last_end, offset)
    declared = re.compile(r"xmlns:([^\s=]+)")
    known = set(declared.findall(text[: token.end])) | {"xml", "xmlns"}
    names = [(token.start + 1, token.name), *((written.start, written.name) for written in attributes_of(text, token))]
    for start, name in names:
        prefix, colon, _ = name.partition(":")
        if colon and prefix not in known:
            return Verdict(
                f"the prefix {prefix}: is not declared", Span(start, start + len(name)), f"remove it, or declare it with xmlns:{prefix}"
            )
    return Verdict("a prefix that is not declared", Span(token.start, token.end))
