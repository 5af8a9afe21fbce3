"""Findings: what is told to people.

A finding is flat and self-contained (no tree, no source): it can be pickled by a worker, kept in the cache, sorted and
printed without any file being opened again.
"""

from __future__ import annotations

from enum import IntEnum

from launchlint.named_tuple import NamedTuple
from launchlint.source import Place, Source, Span

LONGEST_LINE = 4_000
"""Characters of a line that a finding carries; terminals show a few hundred."""
_MOST_RESOLVED = 5_000
"""Places of one text that are kept resolved."""


class Severity(IntEnum):
    """How bad it is; a larger number is worse."""

    INFO = 1
    WARNING = 2
    ERROR = 3

    @property
    def word(self) -> str:
        """The lower-case word users write and read: ``error``, ``warning`` or ``info``."""
        return self.name.lower()

    @property
    def meaning(self) -> str:
        """What has to be true of a finding of this level. Each rule is held to it; the index of the rule pages prints it."""
        return _MEANINGS[self]


_MEANINGS = {
    Severity.ERROR: "roslaunch refuses to load or to start what somebody would really start, or what is written cannot work",
    Severity.WARNING: "most likely not meant, although it starts: what roslaunch itself merely warns about or ignores is a warning, too",
    Severity.INFO: "worth knowing, and often intended: what depends on the command line, the machine or files that are made later",
}


class Location(NamedTuple):
    """A place, resolved: lines and columns from 1, ``end_column`` exclusive.

    ``start`` and ``end`` are the code point offsets of the same span (edits and suppressions need them), ``text`` is the whole
    first line without its line end, so that reports can show it. Of a very long line it is the beginning only, and nothing where the span
    stands behind that: many findings in one line of megabytes must not each carry all of it.
    """

    path: str
    line: int
    column: int
    end_line: int
    end_column: int
    start: int
    end: int
    text: str

    @classmethod
    def of(cls, place: Place) -> Location:
        """Resolve ``place``, once for each: many findings have one place, in other configurations and as that of an include."""
        source, span = place
        known: Location | None = source.resolved.get(span)
        if known is None:
            known = cls._resolved(source, span)
            if len(source.resolved) < _MOST_RESOLVED:
                source.resolved[span] = known
        return known

    @property
    def marked(self) -> str:
        """The text of the span; the whole line where it goes on in others."""
        return self.text[self.column - 1 : self.end_column - 1] if self.line == self.end_line else self.text

    @property
    def bounds(self) -> tuple[str, int, int]:
        """File, start and end: what tells two places apart."""
        return self.path, self.start, self.end

    @classmethod
    def _resolved(cls, source: Source, span: Span) -> Location:
        """What :meth:`of` gives, worked out."""
        first, last = source.position(span.start), source.position(span.end)
        text = source.line(first.line, LONGEST_LINE) if first.column <= LONGEST_LINE else ""
        return cls(source.path, first.line, first.column, last.line, last.column, span.start, span.end, text)


class Related(NamedTuple):
    """A further place that belongs to a finding, with what it shows."""

    location: Location
    label: str


class Edit(NamedTuple):
    """Replace the code points ``start`` to ``end`` of ``path`` by ``text``."""

    path: str
    start: int
    end: int
    text: str


class Fix(NamedTuple):
    """A repair: what it does in words, whether it is certainly what was meant, and its edits.

    ``changes`` says what roslaunch does differently afterwards; empty where it does just the same, which is proved before the edits are
    made.
    """

    message: str
    safe: bool
    edits: tuple[Edit, ...]
    changes: str = ""


Key = tuple[str, str, int, int, str]


class Finding(NamedTuple):
    """One mistake, at one place.

    ``rule``: the ID (``LL301``). ``name``: its kebab-case name. ``message``: what is wrong, one line, no full stop. ``label``: what the
    caret points at. ``chain``: the include elements that lead from the entry file to the place, outermost first. ``notes``: further
    lines, such as what roslaunch says. ``help``: what to do. ``entry`` and ``arguments``: the launch file and the ``name:=value`` pairs
    that show it. ``entries``: from how many entry files it is reached. ``element``: the normalised element text that the fingerprint is
    made from. ``topic`` tells apart several findings of one rule at one place (a missing arg's name, say); it is never shown. ``cause``:
    findings that have the same one (what is to be mended once for all of them) are told as one. ``launcher`` starts the entry file.
    ``about``: names that the message holds, in an order of the rule's own, for what is said of several findings at once.
    """

    rule: str
    name: str
    severity: Severity
    location: Location
    message: str
    label: str = ""
    related: tuple[Related, ...] = ()
    chain: tuple[Location, ...] = ()
    notes: tuple[str, ...] = ()
    help: str = ""
    entry: str = ""
    arguments: tuple[tuple[str, str], ...] = ()
    entries: int = 0
    element: str = ""
    fix: Fix | None = None
    topic: str = ""
    cause: str = ""
    launcher: str = "roslaunch"
    about: tuple[str, ...] = ()

    @property
    def key(self) -> Key:
        """Equal for two findings that say the same: rule, path, start, end and topic."""
        return (self.rule, self.location.path, self.location.start, self.location.end, self.topic)

    @property
    def sort_key(self) -> tuple[object, ...]:
        """Stable order: by file, place, rule, message."""
        at = self.location
        return (at.path, at.start, at.end, self.rule, self.message, -int(self.severity))


def whole_file(source: Source) -> Place:
    """The place of a finding that belongs to a file as a whole: its first character."""
    return Place(source, Span(0, 0))
