"""Files that were copied from each other under a number, a side or the name of another robot: what is wrong at the same place of all of
them is one mistake, that of the first.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Iterable, Sequence

from launchlint.finding import Finding
from launchlint.late import late
from launchlint.rules.judging.joined import spokesman

_SHORTEST_LINE = 40
"""Characters of a line that packages of two names do not have alike by chance."""
_SHORTEST_PART = 20
"""Characters of a line that files of one name do not have alike at one place by chance."""
_NUMBER_OR_SIDE = late(r"[0-9]{1,20}|(?<![A-Za-z])(?:left|right|front|rear|back|upper|lower|top|bottom)(?![a-z])")
_INSIDE = ("launch", "config", "params", "test", "cfg")
"""Directories of a package: the one above them bears its name."""


def with_siblings(groups: Iterable[list[Finding]], is_left: Callable[[str], object]) -> list[list[Finding]]:
    """``groups`` of one cause each; those together that say the same of the same line, but for numbers and sides, of files whose paths are
    the same but for these, or, where the line is long, but for the name of the package. So are those of the same line at the same place of
    files of one name, whatever package each of them names.

    What one file shows several of, is paired one by one. What a rule says of which ``is_left`` is true, by its ID, stays as it is.
    """
    told = list(groups)
    rules = Counter(spokesman(group).rule for group in told)
    joinable = {rule for rule, several in rules.items() if several > 1 and not is_left(rule)}
    for copied in (_alike, _same_place):
        found: dict[object, list[Finding]] = {}
        shown: Counter[object] = Counter()
        for group in told:
            first = spokesman(group)
            key = copied(first) if first.rule in joinable else None
            here = id(group) if key is None else key
            shown[here, first.location.path] += 1
            found.setdefault((here, shown[here, first.location.path]), []).extend(group)
        told = list(found.values())
    return told


def _alike(finding: Finding) -> tuple[str, ...]:
    """What a finding says, and where, without what tells copies apart."""
    path, line = finding.location.path, finding.location.text.strip()
    package = _package(path.split("/"))
    texts: Sequence[str] = (path, finding.message, finding.help, line)
    if package and len(line) >= _SHORTEST_LINE:
        texts = [text.replace(package, "\0") for text in texts]
    return (finding.rule, finding.severity.word, *(_NUMBER_OR_SIDE.sub("\1", text) for text in texts))


def _same_place(finding: Finding) -> tuple[object, ...] | None:
    """Where a finding is in any file of its name; None where the line is too short to be known again."""
    place, line = finding.location, finding.location.text.strip()
    if len(line) < _SHORTEST_PART:
        return None
    return (finding.rule, finding.severity, finding.label, place.path.rpartition("/")[2], place.line, place.column, line)


def _package(parts: Sequence[str]) -> str:
    """The name of the directory above that of the launch files; empty where there is none."""
    return next((above for above, inside in zip(parts[-3::-1], parts[-2::-1], strict=False) if inside in _INSIDE), "")
