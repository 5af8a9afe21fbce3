"""What comments of a launch file say of its args: that they are not used, or not yet."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Sequence

from launchlint.late import late
from launchlint.rules.view import LaunchView
from launchlint.source import Place
from launchlint.syntax.remarks import Remark

SAID_NOT_USED = "a comment of this file names it, and says that it is not used"
STILL_TO_BE_USED = "a comment beside it says that something is still to be done"
_MARKUP = late(r"<[^<>]*>")
ON_PURPOSE = late(
    r"unused|not used|no longer|deprecat|obsolete|compat|ignored|legacy|dummy|placeholder|interface|"
    r"\b(?:old|previous|previously)\b(?!\s*(?:value|default)?\s*[:=]?\s*[-+.\d])|\b(?:prevents?|backwards?|so\s+that)\b",
    re.IGNORECASE,
)
# In capitals: in Spanish, todo is everything.
_LATER = late(r"\b(?:TODO|FIXME)\b|(?i:\bnot\s+yet\b|\bnot\s+implemented\b|\bunimplemented\b|\bto\s+be\s+(?:used|implemented)\b)")
_OF_VALUE = late(r"\b(?:set|change|adjust|adapt|fill|replace|tune|your|values?|defaults?)\b", re.IGNORECASE)
# Of one arg, wherever in the file a comment names it as such: in quotes, or behind the word.
_NOT_TO_BE_USED = late(
    r"\b(?:unused|ignored)\b|(?:\b(?:not|never|cannot)|n[’']?t)\s+(?:be\s+)?(?:use|used|put|place|placed|read|need|needed)\b", re.IGNORECASE
)
_AS_NAME = late(r"(?:\barg(?:ument)?[ \t]+|(?<!\w)[`'\"]|\barg(?:ument)?[ \t]+[`'\"])(\w+)(?!\w)")


def says_so(comment: str) -> bool:
    """Whether the words of a comment call something unused or the like; not the XML that is commented out in it."""
    return ON_PURPOSE.search(_MARKUP.sub(" ", comment)) is not None


def says_later(comment: str) -> bool:
    """Whether they say that something is still to be done, other than to give it another value."""
    words = _MARKUP.sub(" ", comment)
    return _LATER.search(words) is not None and _OF_VALUE.search(words) is None


def not_used(comments: Iterable[str]) -> set[str]:
    """The names of args of which one of the comments says that they are not used, or not to be used."""
    texts = (_MARKUP.sub(" ", comment) for comment in comments)
    return {name for text in texts if _NOT_TO_BE_USED.search(text) is not None for name in _AS_NAME.findall(text)}


def remarks_of(view: LaunchView) -> Callable[[str], Sequence[Remark]]:
    """The comments of the launch files of a view, by their paths as they are shown."""
    known: dict[str, Sequence[Remark]] = {}

    def found(path: str) -> Sequence[Remark]:
        if path not in known:
            document = view.documents.get(path)
            known[path] = () if document is None else view.dialect.remarks(document)
        return known[path]

    return found


def speaks_of(remarks: Sequence[Remark], declaration: Place, name: Place, says: Callable[[str], bool]) -> bool:
    """Whether a comment that ``says`` something stands in a line of the ``declaration`` of an arg, or in the lines directly above it."""
    source = declaration.source
    first = source.position(declaration.span.start).line
    last = source.position(max(declaration.span.end, name.span.end)).line
    above = first - 1
    for remark in reversed(remarks):
        begins, ends = (source.position(at).line for at in remark.span)
        alone = not source.line(begins)[: remark.span.start - source.line_starts[begins - 1]].strip()
        if first <= begins <= last or (alone and ends == above):
            if says(remark.text):
                return True
            above = begins - 1 if ends == above else above
    return False
