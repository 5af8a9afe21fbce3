"""What nobody starts: errors of tests that the build does not start become warnings, and all below a CATKIN_IGNORE becomes information.

Who talks to whom is no matter in a launch file that is only checked.
"""

from __future__ import annotations

import os
from collections.abc import Iterable, Iterator

from launchlint.check.known import Known
from launchlint.finding import Finding, Severity
from launchlint.workspace.registered_tests import TEST_END, is_only_checked, why_not_started

_ON_CONNECTIONS = frozenset(f"LL{number}" for number in (*range(611, 620), 622))
HIDDEN = "a CATKIN_IGNORE hides this file from catkin: nobody starts it from here"


def judged_by_registration(findings: Iterable[Finding], known: Known) -> Iterator[Finding]:
    """``findings``, the errors that only tests which nothing starts lead to as warnings; none on connections in what is only checked."""
    reasons: dict[str, str | None] = {}
    checked: dict[str, bool] = {}
    for finding in findings:
        paths = sorted(known.reached.get(finding.key) or {finding.location.path})
        if finding.rule in _ON_CONNECTIONS and all(_is_only_checked(path, known, checked) for path in paths):
            continue
        if finding.severity is Severity.ERROR and all(path.endswith(TEST_END) for path in paths):
            for path in paths:
                if path not in reasons:
                    file = known.file(path)
                    package = known.packages.package_of(file)
                    reasons[path] = None if package is None else why_not_started(package.directory, file)
            why = reasons[paths[0]]
            if why is not None and all(reasons[path] for path in paths):
                finding = finding._replace(severity=Severity.WARNING, notes=(*finding.notes, why))
        yield finding


def _is_only_checked(path: str, known: Known, told: dict[str, bool]) -> bool:
    if path not in told:
        file = known.file(path)
        package = known.packages.package_of(file)
        told[path] = package is not None and is_only_checked(package.directory, file)
    return told[path]


def judged_by_marker(findings: Iterable[Finding], known: Known) -> Iterator[Finding]:
    """``findings``, those in files that somebody hid from catkin (a ``CATKIN_IGNORE`` beside or above them) as infos."""
    hidden: dict[str, bool] = {}
    for finding in findings:
        if finding.severity > Severity.INFO:
            directory = os.path.dirname(known.file(finding.location.path))
            if directory not in hidden:
                hidden[directory] = known.packages.is_hidden(directory)
            if hidden[directory]:
                finding = finding._replace(severity=Severity.INFO, notes=(*finding.notes, HIDDEN))
        yield finding
