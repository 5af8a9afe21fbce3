"""Comments in a launch file that say: this finding is known and meant.

``<!-- launchlint: ignore[LL301] why -->`` before an element covers that whole element; several rules are separated by commas, by ID or by
name; ``ignore`` alone covers every rule. ``<!-- launchlint: ignore-file[LL206] why -->`` at the top, before the first element inside
``<launch>``, covers the whole file. In YAML the same stands behind a ``#``, above an item or in its first line, also in a parameter file.
``<!-- launchlint: format off -->`` is no suppression (see :mod:`launchlint.fix.format.directives`).
"""

from __future__ import annotations

import re
from bisect import bisect_right
from collections.abc import Callable, Iterable, Sequence

from launchlint.finding import Edit, Finding, Location
from launchlint.fix.format.directives import directive
from launchlint.named_tuple import NamedTuple
from launchlint.source import Place, Source, Span
from launchlint.syntax.remarks import Remark

_MEANT = re.compile(r"\s*launchlint\s*:|\s*launchlint\s+ignore\b", re.IGNORECASE)
_WHOLE = re.compile(
    r"\s*launchlint\s*(?P<colon>:?)\s*(?P<word>[\w-]*)\s*(?P<list>\[(?P<names>[^\[\]]*)\])?(?P<reason>.*)", re.DOTALL | re.IGNORECASE
)
_NAME = re.compile(r"[^\s,]+")
_LOOKS_LIKE_AN_ID = re.compile(r"LL\d{3}\b", re.IGNORECASE)
_MODEL = "launchlint: ignore[RULE] reason"
_MOST_NAMES = 1_000
_NO_ELEMENT = "no element follows it: it belongs right before the element it is about"
_BELOW = "it stands below the first element: ignore-file belongs at the top of the file"


class Name(NamedTuple):
    """A rule as it is named in a suppression, by ID or name, and where."""

    text: str
    span: Span


class Suppression(NamedTuple):
    """One suppression comment.

    ``location``: the comment. ``rules``: IDs or names in lower case, empty for every rule. ``names``: the same as written. ``covers``:
    the span of the element, ``None`` for the whole file. ``reason``: the words after it. ``problem``: why it is no suppression (it
    suppresses nothing then), empty where all is well. ``removal``: the edit that takes the comment away, with its line where nothing else
    stands in it.
    """

    location: Location
    rules: frozenset[str]
    names: tuple[Name, ...]
    covers: Span | None
    reason: str
    problem: str
    removal: Edit


Resolve = Callable[[str], "str | None"]
"""Gives the ID of the rule that has this ID or name (any letter case, also one that was renamed); ``None`` where there is none."""

Used = set[tuple[Suppression, str]]
"""A suppression together with each name in it (as written; the empty string where it names none) that suppressed at least one finding."""


def read(source: Source, remarks: Iterable[Remark]) -> list[Suppression]:
    """All suppressions among the comments of a launch file, in order.

    Those that are malformed, or stand where they cover nothing, are among them and have a ``problem``.
    """
    return [_suppression(source, each) for each in remarks if _MEANT.match(each.text) and not directive(each.text)]


def applies(suppression: Suppression, finding: Finding, resolve: Resolve) -> bool:
    """Whether ``suppression`` covers ``finding``: its rule, and its primary place."""
    return _reaches(suppression, finding) and (
        not suppression.names or any(resolve(name.text.lower()) == finding.rule for name in suppression.names)
    )


def apply(findings: Iterable[Finding], suppressions: Sequence[Suppression], resolve: Resolve) -> tuple[list[Finding], Used]:
    """The findings that no suppression covers, in their order, and which suppressions covered something (of several, all)."""
    by_path: dict[str, list[Suppression]] = {}
    for suppression in suppressions:
        if not suppression.problem:
            by_path.setdefault(suppression.location.path, []).append(suppression)
    covering = {path: _Covering(listed) for path, listed in by_path.items()}
    kept: list[Finding] = []
    used: Used = set()
    for finding in findings:
        location = finding.location
        reaching = covering[location.path].at(location.start) if location.path in covering else ()
        hits = [hit for suppression in reaching for hit in _hits(suppression, finding, resolve)]
        used.update(hits)
        if not hits:
            kept.append(finding)
    return kept, used


def unused(suppressions: Sequence[Suppression], used: Used) -> list[tuple[Suppression, tuple[Name, ...]]]:
    """The well-formed suppressions that suppressed nothing, wholly or for some of their names: each with those names."""
    result: list[tuple[Suppression, tuple[Name, ...]]] = []
    for suppression in suppressions:
        idle = tuple(name for name in suppression.names if (suppression, name.text) not in used)
        if not suppression.problem and (idle or (not suppression.names and (suppression, "") not in used)):
            result.append((suppression, idle))
    return result


class _Covering:
    """The suppressions of one file by place. Elements stand inside each other or apart, and so do the spans that are covered."""

    __slots__ = ("_around", "_ends", "_everywhere", "_listed", "_starts")

    def __init__(self, suppressions: Sequence[Suppression]) -> None:
        self._everywhere = [each for each in suppressions if each.covers is None]
        spans = sorted(
            ((each.covers.start, -each.covers.end, number) for number, each in enumerate(suppressions) if each.covers is not None),
        )
        self._listed = [suppressions[number] for _, _, number in spans]
        self._starts = [start for start, _, _ in spans]
        self._ends = [-end for _, end, _ in spans]
        self._around: list[int] = []
        open_spans: list[int] = []
        for number, start in enumerate(self._starts):
            while open_spans and self._ends[open_spans[-1]] <= start:
                open_spans.pop()
            self._around.append(open_spans[-1] if open_spans else -1)
            open_spans.append(number)

    def at(self, place: int) -> list[Suppression]:
        """Those that cover the offset ``place``."""
        found = list(self._everywhere)
        number = bisect_right(self._starts, place) - 1
        while number >= 0:
            if place < self._ends[number]:
                found.append(self._listed[number])
            number = self._around[number]
        return found


def _hits(suppression: Suppression, finding: Finding, resolve: Resolve) -> list[tuple[Suppression, str]]:
    if not _reaches(suppression, finding):
        return []
    if not suppression.names:
        return [(suppression, "")]
    return [(suppression, name.text) for name in suppression.names if resolve(name.text.lower()) == finding.rule]


def _reaches(suppression: Suppression, finding: Finding) -> bool:
    if suppression.problem or suppression.location.path != finding.location.path:
        return False
    return suppression.covers is None or suppression.covers.start <= finding.location.start < suppression.covers.end


def _suppression(source: Source, remark: Remark) -> Suppression:
    inside = remark.inside  # else it comes out of an entity, and its names have no place of their own
    match = _WHOLE.match(remark.text) if inside is None else _WHOLE.match(source.text, *inside)
    names: list[Name] = []
    word = reason = problem = ""
    if match is not None:
        word = match["word"].lower()
        reason = " ".join(match["reason"].split()).lstrip(":,-–— ")
        base = match.start("names")
        names = [
            Name(name[0], remark.span if inside is None else Span(base + name.start(), base + name.end()))
            for name in _NAME.finditer(match["names"] or "")
        ]
        problem = _spelling(match, names, reason)
        if len(names) > _MOST_NAMES:
            names, problem = [], f"it names {len(names):,} rules, which is more than there are"
    of_file = word == "ignore-file"
    return Suppression(
        Location.of(Place(source, remark.span)),
        frozenset(name.text.lower() for name in names),
        tuple(names),
        None if of_file else remark.covers,
        reason,
        problem or (("" if remark.on_top else _BELOW) if of_file else _NO_ELEMENT if remark.covers is None else ""),
        _removal(source, remark.span),
    )


def _spelling(match: re.Match[str], names: list[Name], reason: str) -> str:
    """Why the words of the comment cannot be taken; empty where they can."""
    word = match["word"].lower()
    if not word:
        return f"it does not say what to do: write {_MODEL}"
    if not match["colon"]:
        return f"a colon is missing: write {_MODEL}"
    if word not in ("ignore", "ignore-file"):
        return f"there is no {word!r}, only ignore, ignore-file, format off and format on"
    if reason.startswith("["):
        return f"the list of rules cannot be read: write {word}[LL301] or {word}[LL301, LL302]"
    if match["list"] and not names:
        return "the list of rules is empty: name one, or leave the brackets out to ignore every rule"
    if not match["list"] and _LOOKS_LIKE_AN_ID.match(reason):
        return f"rules stand in brackets: write {word}[{reason.split()[0]}]"
    return ""


def _removal(source: Source, span: Span) -> Edit:
    """Deletes the comment; where it has its lines for itself, these with their indentation and line end."""
    return Edit(source.path, *source.with_lines(span), "")
