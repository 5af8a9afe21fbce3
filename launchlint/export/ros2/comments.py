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

    from launchlint.export.ros2.carrying import Lost
    from launchlint.export.ros2.tree import Branch
    from launchlint.source import Source
    from launchlint.syntax.ros2.reading import Reading

_PYTHON = ".py"
_BLANK_LINE = re.compile(r"\n[ \t]*\r?\n[ \t]*(?:-[ \t]*)?\Z")
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

    def put(self, root: Branch, lost: Iterable[Lost]) -> None:
        """Put each comment to the tag that it stands before, or behind in its line; and say at its place what is lost."""
        spots = _Spots(root, self._source)
        found = [(start, partial(self._comment, spots, start, text)) for start, text in self._comments()]
        found += [(each.place.span.start, partial(self._lost, spots, each)) for each in lost]
        for _, put in sorted(found, key=lambda item: item[0]):
            put()
        spots.set_apart(self._is_apart)

    def _comment(self, spots: _Spots, start: int, text: str) -> None:
        lines = ["", text] if self._is_apart(start) else [text]
        inside = self._parents.get(start, -1) if self._reading.document is not None else None
        spots.put(start, lines, beside=self._is_beside(start), inside=inside)

    def _lost(self, spots: _Spots, each: Lost) -> None:
        line = self._source.position(each.place.span.start).line if each.place.source.file == self._source.file else 0
        where = f" (line {line})" if line else ""
        spots.put(each.place.span.start, [f"not carried over{where}: {each.words}"], beside=False, inside=-1)

    def _comments(self) -> list[tuple[int, str]]:
        if self._source.file.endswith(_PYTHON):
            return []
        document = self._reading.document
        found = yaml_remarks(self._source) if document is None else xml_remarks(document)
        if document is None:
            found = [each for each in found if not self._in_quotes(each.span.start)]
        return [(each.span.start, _trimmed(each.text)) for each in found if each.text.strip()]

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


class _Spots:
    """The tags in the order in which they stand in the original."""

    def __init__(self, root: Branch, source: Source) -> None:
        self._root = root
        self._text = source.text
        self._branches: list[Branch] = []
        self._parents: dict[int, Branch] = {}
        depths: dict[int, int] = {id(root): 0}
        waiting = [root]
        while waiting:
            branch = waiting.pop()
            waiting += reversed(branch.inner)
            for inner in branch.inner:
                self._parents[id(inner)] = branch
                depths[id(inner)] = depths[id(branch)] + 1
            if branch is not root and branch.place.source.file == source.file:
                self._branches.append(branch)
        self._branches.sort(key=lambda each: each.place.span.start)
        self._starts = [each.place.span.start for each in self._branches]
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
        before = bisect_left(self._starts, start) - 1
        if beside and before >= 0 and "\n" not in lines[-1]:
            self._by_start[self._starts[before]].beside += lines[-1:]
            return
        after = bisect_right(self._starts, start)
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
