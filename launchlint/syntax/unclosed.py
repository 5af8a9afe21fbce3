"""Tags that do not match: which of them was never closed, and where its end is missing."""

from __future__ import annotations

import re

from launchlint.source import Span
from launchlint.syntax.tags import NAME, Verdict
from launchlint.syntax.tree import Element


def _indent(text: str, offset: int) -> int | None:
    """The column of ``offset`` (tabs to the next multiple of 8) if it is the first thing on its line."""
    start = max(text.rfind("\n", 0, offset), text.rfind("\r", 0, offset)) + 1
    lead = text[start:offset]
    return None if lead.strip(" \t") else len(lead.expandtabs())


def mismatch(text: str, offset: int, opened: list[Element]) -> Verdict:
    """The end tag at ``offset`` does not fit the innermost of the ``opened`` elements."""
    start = text.rfind("<", 0, offset + 1)
    name = NAME.match(text, start + 2)
    end = text.find(">", start) + 1 or len(text)
    where = Span(start, end)
    closed = name[0] if name else ""
    innermost = opened[-1]
    tag = innermost.tag
    column = _indent(text, start)
    mine = _indent(text, innermost.span.start)
    outer = next((element for element in reversed(opened) if element.tag == closed), None)
    if outer is None or (column is not None and column == mine and column != _indent(text, outer.span.start)):
        before = innermost.children[-1] if innermost.children else None
        if before is not None and before.tag == closed and before.self_closed and column != mine:
            return Verdict(
                f"</{closed}> closes nothing",
                where,
                f"the <{closed} …/> before it is already closed by its own />: remove one of the two",
                ((before.start_span, "already closed here"),),
                closed=closed,
            )
        return Verdict(
            f"</{closed}> does not fit the open <{tag}>",
            where,
            f"write </{tag}> here",
            ((innermost.start_span, "opened here"),),
            tag,
            closed,
        )
    return never_closed(text, innermost, start, where, closed)


def never_closed(text: str, element: Element, limit: int, noticed: Span | None, closed: str) -> Verdict:
    """``element`` or one inside it has no end tag; noticed at ``limit``. The indentation tells which and where."""
    element = _by_indentation(text, element)
    tag = element.tag
    message = f"<{tag}> is never closed"
    noticed_label = f"</{closed}> comes first" if closed else "the file ends first"
    column = _indent(text, element.span.start)
    body = element.start_span.end
    stop = limit
    if column is not None:
        for match in re.finditer(r"[\r\n]([ \t]*)<", text[body:limit]):
            if len(match[1].expandtabs()) <= column:
                stop = body + match.start()
                break
    if not text[body:stop].strip():
        related = () if noticed is None else ((noticed, noticed_label),)
        return Verdict(message, element.start_span, f"end it with /> or add </{tag}>", related, tag, closed)
    last = body + len(text[body:stop].rstrip())
    return Verdict(message, Span(last - 1, last), f"</{tag}> is missing here", ((element.start_span, "opened here"),), tag, closed)


def _by_indentation(text: str, element: Element) -> Element:
    """Of elements of one tag inside each other, the one that was really left open.

    Its end tag was taken from the outer one: it stands in the column of the outer start tag.
    """
    while True:
        column = _indent(text, element.span.start)
        if column is None:
            return element
        for child in element.children:
            if child.tag == element.tag and not child.self_closed and child.end_span.start > child.start_span.end:
                mine = _indent(text, child.span.start)
                if mine is not None and mine != column and _indent(text, child.end_span.start) == column:
                    element = child
                    break
        else:
            return element
