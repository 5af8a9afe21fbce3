"""What can be done about a finding, and the normal form of a file, as changes of the text."""

from __future__ import annotations

from launchlint.finding import Edit, Finding
from launchlint.fix.format.formatting import formatted
from launchlint.ide.view import View
from launchlint.named_tuple import NamedTuple
from launchlint.source import Span


class Replacement(NamedTuple):
    """A stretch of the text, and what is to stand there."""

    span: Span
    text: str


class Action(NamedTuple):
    """Something to do about ``findings``: ``edits`` of files (as shown); ``safe`` where it is certainly what was meant."""

    title: str
    edits: tuple[Edit, ...]
    findings: tuple[Finding, ...]
    safe: bool
    fixes: bool


def actions(view: View, findings: list[Finding], start: int, end: int) -> list[Action]:
    """What can be done about those ``findings`` of the file that meet a stretch of it: their fixes first, then to silence them here."""
    here = [each for each in findings if each.location.path == view.shown and each.location.start <= end and start <= each.location.end]
    found = []
    for finding in here:
        fix = finding.fix
        if fix is not None:
            found.append(Action(_title(fix.message, finding), fix.edits, (finding,), fix.safe, fixes=True))
    for finding in here:
        edit = _silence(view, finding)
        if edit is not None:
            found.append(Action(f"Silence {finding.rule} {finding.name} here", (edit,), (finding,), safe=False, fixes=False))
    return found


def has_safe(view: View, findings: list[Finding]) -> bool:
    """Whether there is a safe fix that changes this file alone."""
    fixes = (each.fix for each in findings if each.location.path == view.shown)
    return any(fix is not None and fix.safe and all(edit.path == view.shown for edit in fix.edits) for fix in fixes)


def _title(message: str, finding: Finding) -> str:
    return f"{message[:1].upper()}{message[1:]} ({finding.rule})"


def _silence(view: View, finding: Finding) -> Edit | None:
    """A comment in front of the element in which a finding stands."""
    words = f"launchlint: ignore[{finding.rule}] "
    start = finding.location.start
    element = view.element_at(start)
    if element is not None:
        start = view.seen(element.span).start
    line = view.text.rfind("\n", 0, start) + 1
    indentation = view.text[line:start]
    if indentation.strip():
        indentation, start = "", start
    else:
        start = line
    if view.document.root is None:
        return Edit(view.shown, line, line, f"{' ' * (len(view.text[line:]) - len(view.text[line:].lstrip(' ')))}# {words.strip()}\n")
    return Edit(view.shown, start, start, f"{indentation}<!-- {words}-->\n" if view.text[line:start] == "" else f"<!-- {words}-->")


def format_edits(view: View) -> list[Replacement]:
    """The changes that bring the file into normal form; none where it must be left alone."""
    if view.file.endswith(".py") or view.recovery.edits:
        return []
    data = view.text.encode("utf-8", "surrogateescape")
    result = formatted(data, view.file, view.snapshot.style)
    after = result.data.decode("utf-8", "surrogateescape")
    return [] if after == view.text else changes(view.text, after)


def changes(before: str, after: str) -> list[Replacement]:
    """The lines that differ, each stretch of them as one change."""
    from difflib import SequenceMatcher

    old, new = before.splitlines(keepends=True), after.splitlines(keepends=True)
    starts = [0]
    for line in old:
        starts.append(starts[-1] + len(line))
    found = []
    for kind, first, last, new_first, new_last in SequenceMatcher(None, old, new, autojunk=False).get_opcodes():
        if kind != "equal":
            found.append(Replacement(Span(starts[first], starts[last]), "".join(new[new_first:new_last])))
    return found
