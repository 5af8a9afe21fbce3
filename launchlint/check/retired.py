"""Files that somebody put aside: what is wrong in a directory called `old` or `deprecated`, which nothing else leads to, is information."""

from __future__ import annotations

from bisect import bisect_left
from collections.abc import Iterable, Iterator

from launchlint.check.known import Known
from launchlint.finding import Finding, Severity
from launchlint.workspace.put_aside import put_aside

NOTE = "it lies in {}, which nothing outside of it leads to: somebody seems to have put it aside"


def judged_by_place(findings: Iterable[Finding], known: Known) -> Iterator[Finding]:
    """``findings``, those in files that were put aside and that no entry file elsewhere leads to as infos."""
    used: list[str] | None = None
    for finding in findings:
        if finding.severity > Severity.INFO:
            aside = put_aside(finding.location.path)
            if aside and all(put_aside(path) for path in known.reached.get(finding.key, ())):
                used = _used(known) if used is None else used
                if not _is_used(finding.location.path, used):
                    finding = finding._replace(severity=Severity.INFO, notes=(*finding.notes, NOTE.format(aside)))
        yield finding


def _used(known: Known) -> list[str]:
    """The launch files that entry files outside of such directories include, in order."""
    return sorted({path for entry in known.entries if not put_aside(entry.path) for path in entry.included})


def _is_used(path: str, used: list[str]) -> bool:
    """Whether ``path`` is among ``used``, or is the manifest of a package of which a file is."""
    directory, _, name = path.rpartition("/")
    wanted = f"{directory}/" if name in ("package.xml", "manifest.xml", "CMakeLists.txt") else path
    at = bisect_left(used, wanted)
    return at < len(used) and (used[at] == path or (wanted != path and used[at].startswith(wanted)))
