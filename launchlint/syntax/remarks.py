"""Comments with what they stand before: what somebody says about a part of a launch file."""

from __future__ import annotations

import re

from launchlint.named_tuple import NamedTuple
from launchlint.source import Span
from launchlint.syntax.tree import Document, Element

_NOT_TEXT = re.compile(r"\s*(?:<\?.*?\?>\s*)*", re.DOTALL)
_OPENS, _CLOSES = "<!--", "-->"


class Remark(NamedTuple):
    """One comment.

    ``text`` is what it says, ``span`` all of it. ``inside`` is where the text is written, None where that has no place of its own (it comes
    out of an entity). ``covers`` is what it stands before, if anything; ``on_top``: nothing of the launch file stands above it.
    """

    text: str
    span: Span
    inside: Span | None
    covers: Span | None
    on_top: bool


def remarks(document: Document) -> list[Remark]:
    """The comments of a document in XML."""
    text, root = document.source.text, document.root
    first = None if root is None or not root.children else root.children[0].span.start
    found: list[Remark] = []
    for comment, target in zip(document.comments, _targets(document), strict=True):
        start, end = comment.span
        written = text.startswith(_OPENS, start)
        inside = Span(start + len(_OPENS), end - len(_CLOSES)) if written else None
        found.append(Remark(comment.text, comment.span, inside, None if target is None else target.span, first is None or end <= first))
    return found


def _targets(document: Document) -> list[Element | None]:
    """For each comment the element it stands before: only white space, other comments and processing instructions may come between."""
    text = document.source.text
    targets: list[Element | None] = [None] * len(document.comments)
    for index in range(len(document.comments) - 1, -1, -1):
        comment = document.comments[index]
        end = comment.span.end
        element = document.element_from(end)
        following = document.comments[index + 1] if index + 1 < len(document.comments) else None
        if following is not None and (element is None or following.span.start < element.span.start):
            if _blank(text, end, following.span.start):
                targets[index] = targets[index + 1]
        elif element is not None and element.parent is comment.parent and _blank(text, end, element.span.start):
            targets[index] = element
    return targets


def _blank(text: str, start: int, end: int) -> bool:
    match = _NOT_TEXT.match(text, start, end)
    return match is not None and match.end() == end
