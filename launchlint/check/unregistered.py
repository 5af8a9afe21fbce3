"""What nobody starts: errors of tests that the build does not start become warnings, and all below a CATKIN_IGNORE becomes information."""

from __future__ import annotations

import os
from collections.abc import Iterable, Iterator, Mapping

from launchlint.finding import Finding, Key, Severity
from launchlint.workspace.packages import Packages
from launchlint.workspace.registered_tests import TEST_END, why_not_started

HIDDEN = "a CATKIN_IGNORE hides this file from catkin: nobody starts it from here"


def judged_by_registration(
    findings: Iterable[Finding], reached: Mapping[Key, set[str]], packages: Packages, root: str
) -> Iterator[Finding]:
    """``findings``, the errors that only tests which nothing starts lead to (``reached``, paths below ``root``) as warnings."""
    reasons: dict[str, str | None] = {}
    for finding in findings:
        paths = sorted(reached.get(finding.key) or {finding.location.path})
        if finding.severity is Severity.ERROR and all(path.endswith(TEST_END) for path in paths):
            for path in paths:
                if path not in reasons:
                    file = os.path.abspath(os.path.join(root, path))
                    package = packages.package_of(file)
                    reasons[path] = None if package is None else why_not_started(package.directory, file)
            why = reasons[paths[0]]
            if why is not None and all(reasons[path] for path in paths):
                finding = finding._replace(severity=Severity.WARNING, notes=(*finding.notes, why))
        yield finding


def judged_by_marker(findings: Iterable[Finding], packages: Packages, root: str) -> Iterator[Finding]:
    """``findings``, those in files that somebody hid from catkin (a ``CATKIN_IGNORE`` beside or above them) as infos."""
    hidden: dict[str, bool] = {}
    for finding in findings:
        if finding.severity > Severity.INFO:
            directory = os.path.dirname(os.path.abspath(os.path.join(root, finding.location.path)))
            if directory not in hidden:
                hidden[directory] = packages.is_hidden(directory)
            if hidden[directory]:
                finding = finding._replace(severity=Severity.INFO, notes=(*finding.notes, HIDDEN))
        yield finding
