"""Where in the markup an offset is, told from the text in front of it alone: that need not be well-formed."""

from __future__ import annotations

import re
from collections.abc import Mapping
from types import MappingProxyType

from launchlint.late import late
from launchlint.named_tuple import NamedTuple
from launchlint.source import Span

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Literal

_NAME = r"[A-Za-z_:][\w:.-]{0,200}"
_TAG = late(rf"<!--.*?(?:-->|$)|<(/?)({_NAME})((?:\s+{_NAME}\s*=\s*(?:\"[^\"<]*\"|'[^'<]*'))*)\s*(/?)>", re.DOTALL)
_PAIR = late(rf"({_NAME})\s*=\s*(?:\"([^\"<]*)\"|'([^'<]*)')")
_IN_VALUE = late(rf"({_NAME})\s*=\s*(?:\"([^\"<]*)|'([^'<]*))$")
_SUBSTITUTION = late(r"\$\(([\w-]*)(\s+)?([^()$]*)$")
_NOTHING: Mapping[str, str] = MappingProxyType({})


class Context(NamedTuple):
    """What is being written: a ``tag``'s name, one that closes, an ``attribute``'s name, its ``value``, or nothing that is known.

    ``span`` is the part of the word that is there already. ``tag`` and ``attributes`` are those of the tag that the place is in; ``parent``
    and ``outer`` the tag around it, and its attributes; ``siblings`` the names of the args it holds already. ``command`` is that of a
    ``$(…)`` around the place: empty where it is just being written.
    """

    kind: Literal["", "tag", "close", "attribute", "value"]
    span: Span
    tag: str = ""
    attribute: str = ""
    attributes: Mapping[str, str] = _NOTHING
    parent: str = ""
    outer: Mapping[str, str] = _NOTHING
    siblings: tuple[str, ...] = ()
    command: str | None = None


def context_at(text: str, offset: int) -> Context:
    """What is being written at ``offset`` of XML."""
    before = text[:offset]
    line = before.rpartition("\n")[2]
    opened = before.rfind("<")
    stack = _around(before[:opened] if opened >= 0 else "")
    parent, outer, siblings = stack[-1] if stack else ("", _NOTHING, ())
    rest = before[opened:] if opened >= 0 else ""
    if re.fullmatch(rf"<({_NAME})?", rest):
        return Context("tag", Span(opened + 1, offset), parent=parent, outer=outer, siblings=siblings)
    if re.fullmatch(rf"</({_NAME})?", rest):
        return Context("close", Span(opened + 1, offset), parent=parent, outer=outer)
    started = re.match(rf"<({_NAME})\s", rest)
    if started is None or _TAG.match(rest) is not None:
        return Context("", Span(offset, offset), parent=parent, outer=outer)
    tag = started[1]
    after = text[offset : text.find("<", offset) if text.find("<", offset) >= 0 else len(text)]
    attributes = {match[1]: match[2] or match[3] or "" for match in _PAIR.finditer(rest)}
    quotes = _IN_VALUE.search(rest)
    if quotes is not None and not _balanced(rest):
        attributes.pop(quotes[1], None)
        following = {match[1]: match[2] or match[3] or "" for match in _PAIR.finditer(after[after.find(rest[quotes.start(0) :][:0]) :])}
        value = quotes[2] if quotes[2] is not None else quotes[3]
        made = Context(
            "value", Span(offset - len(value), offset), tag, quotes[1], {**following, **attributes}, parent, outer, siblings
        )  # fmt: skip
        return with_command(made, line, offset)
    word = re.search(rf"(?:{_NAME})?$", rest)
    assert word is not None
    following = {match[1]: match[2] or match[3] or "" for match in _PAIR.finditer(after.partition(">")[0])}
    return Context("attribute", Span(offset - len(word[0]), offset), tag, "", {**following, **attributes}, parent, outer, siblings)


def _balanced(rest: str) -> bool:
    """Whether every quote that is opened in a tag is closed."""
    return re.fullmatch(r"(?:[^\"']|\"[^\"]*\"|'[^']*')*", rest) is not None


def with_command(context: Context, line: str, offset: int) -> Context:
    """``context`` with the ``$(…)`` that the text of the line in front of ``offset`` ends in, if any."""
    inside = _SUBSTITUTION.search(line)
    if inside is None:
        return context
    if inside[2] is None:
        return context._replace(command="", span=Span(offset - len(inside[1]), offset))
    word = inside[3].rpartition(" ")[2]
    return context._replace(command=inside[1], span=Span(offset - len(word), offset))


def _around(text: str) -> list[tuple[str, Mapping[str, str], tuple[str, ...]]]:
    """The elements that are open at the end of ``text``, outermost first: name, attributes, names of the args in it."""
    stack: list[tuple[str, Mapping[str, str], tuple[str, ...]]] = []
    for match in _TAG.finditer(text):
        name = match[2]
        if name is None:
            continue
        if match[1]:
            if any(each[0] == name for each in stack):
                while stack.pop()[0] != name:
                    pass
            continue
        attributes = {pair[1]: pair[2] or pair[3] or "" for pair in _PAIR.finditer(match[3])}
        if stack and name == "arg" and "name" in attributes:
            outer = stack[-1]
            stack[-1] = (outer[0], outer[1], (*outer[2], attributes["name"]))
        if not match[4]:
            stack.append((name, attributes, ()))
    return stack
