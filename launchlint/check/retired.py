"""Files that somebody put aside: what is wrong in a directory called `old` or `deprecated`, which nothing else leads to, is information.

So it is in one that is no package any more because its manifest was renamed.
"""

from __future__ import annotations

from bisect import bisect_left
from collections.abc import Iterable, Iterator

from launchlint.check.known import Known
from launchlint.finding import Finding, Severity
from launchlint.workspace.put_aside import put_aside, renamed_manifest

NOTE = "it lies in {}, which nothing outside of it leads to: somebody seems to have put it aside"


class _Places:
    """Where files lie; each directory is looked into once."""

    def __init__(self, known: Known) -> None:
        self._known = known
        self._renamed: dict[str, str] = {"": ""}

    def aside(self, path: str) -> str:
        """The directory on the way to ``path`` that was put aside, for people; empty where none was."""
        directory = path.rpartition("/")[0]
        if directory not in self._renamed:
            file = self._known.file(directory)
            self._renamed[directory] = self._without_manifest(directory) if self._known.packages.package_of(file) is None else ""
        return put_aside(path) or self._renamed[directory]

    def _without_manifest(self, directory: str) -> str:
        while directory:
            name = renamed_manifest(self._known.file(directory))
            if name:
                return f"{directory} (no package since its manifest is {name})"
            directory = directory.rpartition("/")[0]
        return ""


def judged_by_place(findings: Iterable[Finding], known: Known) -> Iterator[Finding]:
    """``findings``, those in files that were put aside and that no entry file elsewhere leads to as infos."""
    used: list[str] | None = None
    places = _Places(known)
    for finding in findings:
        if finding.severity > Severity.INFO:
            aside = places.aside(finding.location.path)
            if aside and all(places.aside(path) for path in known.reached.get(finding.key, ())):
                used = _used(known, places) if used is None else used
                if not _is_used(finding.location.path, used):
                    note, cause = NOTE.format(aside), finding.cause and f"{finding.cause}; put aside"
                    finding = finding._replace(severity=Severity.INFO, notes=(*finding.notes, note), cause=cause)
        yield finding


def _used(known: Known, places: _Places) -> list[str]:
    """The launch files that entry files outside of such directories include, in order."""
    return sorted({path for entry in known.entries if not places.aside(entry.path) for path in entry.included})


def _is_used(path: str, used: list[str]) -> bool:
    """Whether ``path`` is among ``used``, or is the manifest of a package of which a file is."""
    directory, _, name = path.rpartition("/")
    wanted = f"{directory}/" if name in ("package.xml", "manifest.xml", "CMakeLists.txt") else path
    at = bisect_left(used, wanted)
    return at < len(used) and (used[at] == path or (wanted != path and used[at].startswith(wanted)))
