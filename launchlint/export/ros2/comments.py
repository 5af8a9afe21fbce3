"""Comments of a launch file, and of what is lost of it, at the tags of the one that is written."""

from __future__ import annotations

import re
from bisect import bisect_left, bisect_right
from functools import partial

from launchlint.syntax.remarks import remarks as xml_remarks
from launchlint.syntax.yaml_remarks import remarks as yaml_remarks

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable, Iterable

    from launchlint.export.ros2.losses import Lost
    from launchlint.export.ros2.tree import Branch
    from launchlint.source import Source, Span
    from launchlint.syntax.remarks import Remark
    from launchlint.syntax.ros2.reading import Reading

_PYTHON = ".py"
_BLANK_LINE = re.compile(r"\n[ \t]*\r?\n[ \t]*(?:-[ \t]*)?\Z")
_BLANK_LINE_INSIDE = re.compile(r"\n[ \t]*\r?\n")
_BLANK_LINE_BELOW = re.compile(r"[ \t]*\r?\n[ \t]*\r?\n")
_BLANKS = re.compile(" *")
_LOOKED_BACK = 300


class Comments:
    """The comments of one file that was read."""

    def __init__(self, reading: Reading) -> None:
        self._reading = reading
        self._source = reading.source
        document = reading.document
        comments = () if document is None else document.comments
        self._parents = {each.span.start: each.parent.span.start for each in comments if each.parent is not None}

    def put(self, root: Branch, lost: Iterable[Lost], inlined: frozenset[int] | None = None) -> None:
        """Put each comment to the tag that it stands before, or behind in its line; and say at its place what is lost.

        ``inlined``, where not all of the file is written: the tags, by identity, whose content comes from other files. A comment on what is
        not written goes with it, unless a blank line sets it apart.
        """
        spots = _Spots(root, self._source, inlined or frozenset())
        comments = self._comments() if inlined is None else self._comments_on(spots.starts)
        found = [(start, partial(self._comment, spots, start, text, set_off)) for start, text, set_off in comments]
        found += [(each.place.span.start, partial(self._lost, spots, each)) for each in lost]
        for _, put in sorted(found, key=lambda item: item[0]):
            put()
        spots.set_apart(self._is_apart)

    def _comment(self, spots: _Spots, start: int, text: str, set_off: bool) -> None:
        lines = [*([""] if self._is_apart(start) else []), text, *([""] if set_off else [])]
        inside = self._parents.get(start, -1) if self._reading.document is not None else None
        spots.put(start, lines, beside=self._is_beside(start), inside=inside)

    def _lost(self, spots: _Spots, each: Lost) -> None:
        line = self._source.position(each.place.span.start).line if each.place.source.file == self._source.file else 0
        where = f" (line {line})" if line else ""
        spots.put(each.place.span.start, [f"not carried over{where}: {each.words}"], beside=False, inside=-1)

    def _comments(self) -> list[tuple[int, str, bool]]:
        return [(each.span.start, _trimmed(each.text), False) for each in self._remarks()]

    def _remarks(self) -> list[Remark]:
        if self._source.file.endswith(_PYTHON):
            return []
        document = self._reading.document
        found = yaml_remarks(self._source) if document is None else xml_remarks(document)
        if document is None:
            found = [each for each in found if not self._in_quotes(each.span.start)]
        return [each for each in found if each.text.strip()]

    def _comments_on(self, written: list[int]) -> list[tuple[int, str, bool]]:
        """Those on what begins at one of the offsets ``written``, sorted, or holds that; and whether a blank line follows."""
        found: list[tuple[int, str, bool]] = []
        for each in self._remarks():
            on = [*self._around_it(each), *self._it_is_about(each)]
            if all(_holds_any(written, *span) for span in on):
                set_off = _BLANK_LINE_BELOW.match(self._source.text, each.span.end) is not None
                found.append((each.span.start, _trimmed(each.text), set_off))
        return found

    def _around_it(self, remark: Remark) -> list[Span]:
        """The element that a comment in XML stands in, but for the document element."""
        document = self._reading.document
        if document is None:
            return []
        comment = next(each for each in document.comments if each.span == remark.span)
        return [] if comment.parent is None or comment.parent is document.root else [comment.parent.span]

    def _it_is_about(self, remark: Remark) -> list[Span]:
        """What a comment stands beside, or before without a blank line between."""
        document = self._reading.document
        start = remark.span.start
        if document is not None and self._is_beside(start):
            line = self._source.text.rfind("\n", 0, start) + 1
            spans = [each.span for each in document.elements]
            return [each for each in spans if line <= each.start < start][-1:] or [each for each in spans if line < each.end <= start][-1:]
        if remark.covers is None or _BLANK_LINE_INSIDE.search(
            self._source.text, remark.span.end, max(remark.covers.start, remark.span.end)
        ):
            return []
        return [remark.covers]

    def _in_quotes(self, offset: int) -> bool:
        """Whether a ``#`` in YAML seems to stand in a quoted text: an odd number of quotes stands before it in its line."""
        line = self._source.text[self._source.text.rfind("\n", 0, offset) + 1 : offset]
        return bool(line.count("'") % 2 or line.count('"') % 2)

    def _is_beside(self, start: int) -> bool:
        text = self._source.text
        return bool(text[text.rfind("\n", 0, start) + 1 : start].strip())

    def _is_apart(self, start: int) -> bool:
        """Whether a blank line stands before what begins there."""
        return _BLANK_LINE.search(self._source.text[max(0, start - _LOOKED_BACK) : start]) is not None


def _holds_any(written: list[int], start: int, end: int) -> bool:
    at = bisect_left(written, start)
    return at < len(written) and written[at] < end


class _Spots:
    """The tags in the order in which they stand in the original, without what is in ``inlined`` ones."""

    def __init__(self, root: Branch, source: Source, inlined: frozenset[int]) -> None:
        self._root = root
        self._text = source.text
        self._branches: list[Branch] = []
        self._parents: dict[int, Branch] = {}
        depths: dict[int, int] = {id(root): 0}
        waiting = [root]
        while waiting:
            branch = waiting.pop()
            if branch is not root and id(branch) in inlined:
                own: list[Branch] = []
            else:
                own = branch.inner
            waiting += reversed(own)
            for inner in own:
                self._parents[id(inner)] = branch
                depths[id(inner)] = depths[id(branch)] + 1
            if branch is not root and branch.place.source.file == source.file:
                self._branches.append(branch)
        self._branches.sort(key=lambda each: each.place.span.start)
        self.starts = [each.place.span.start for each in self._branches]
        # What stands for one tag may be a group around it, and several of it: the first of the innermost ones.
        self._by_start: dict[int, Branch] = {}
        for branch in sorted(self._branches, key=lambda each: (bool(each.inner), depths[id(each)]), reverse=True):
            self._by_start.setdefault(branch.place.span.start, branch)

    def set_apart(self, is_apart: Callable[[int], bool]) -> None:
        """Keep the blank lines before tags, but for the first one in each."""
        for branch in self._branches:
            parent = self._parents[id(branch)]
            if branch is not parent.inner[0] and is_apart(branch.place.span.start):
                branch.above.append("")

    def put(self, start: int, lines: list[str], *, beside: bool, inside: int | None) -> None:
        """One comment; an empty line says that one stands before it. ``inside``: where the element around it begins; None in YAML."""
        before = bisect_left(self.starts, start) - 1
        words = [each for each in lines if each]
        if beside and before >= 0 and "\n" not in words[-1]:
            self._by_start[self.starts[before]].beside += words[-1:]
            return
        after = bisect_right(self.starts, start)
        following = self._branches[after] if after < len(self._branches) else None
        parent = self._around(start, before, following) if inside is None else self._by_start.get(inside)
        if parent is not None and (following is None or self._parents.get(id(following)) is not parent):
            inner = [each for each in parent.inner if each.place.span.start > start]
            (inner[0].above if inner else parent.below).extend(lines)
        elif following is None:
            self._root.below += lines
        else:
            following.above += lines

    def _around(self, start: int, before: int, following: Branch | None) -> Branch | None:
        """In YAML: what a comment stands in that is indented deeper than what follows it."""
        column = _indentation(self._text, start)
        if before < 0 or (following is not None and _indentation(self._text, following.place.span.start) >= column):
            return None
        branch: Branch | None = self._branches[before]
        while branch is not None and _indentation(self._text, branch.place.span.start) >= column:
            branch = self._parents.get(id(branch))
            branch = None if branch is self._root else branch
        return branch


def _indentation(text: str, offset: int) -> int:
    """How many blanks stand at the beginning of a line."""
    match = _BLANKS.match(text, text.rfind("\n", 0, offset) + 1)
    return 0 if match is None else len(match[0])


def _trimmed(text: str) -> str:
    """A comment without blanks around it and, where it has several lines, without their common indentation."""
    lines = text.strip().split("\n")
    margin = min((len(line) - len(line.lstrip()) for line in lines[1:] if line.strip()), default=0)
    return "\n".join((lines[0].rstrip(), *(line[margin:].rstrip() for line in lines[1:])))
