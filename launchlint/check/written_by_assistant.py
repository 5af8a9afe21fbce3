"""Switches that MoveIt's Setup Assistant writes into every package it makes, and that nobody gives: files which only they lead to.

The assistant keeps what it was told in a file ``.setup_assistant`` at the top of the package. Its launch files offer choices (a fake
execution, a database) whether or not the files behind them were written, too.
"""

from __future__ import annotations

import os
from collections.abc import Iterable, Iterator

from launchlint.check.given_together import BOOLEANS
from launchlint.check.known import Known
from launchlint.finding import Finding, Severity
from launchlint.workspace.looking import is_file

NOTE = "MoveIt's Setup Assistant writes this switch into every package, and no launch file here gives {}"
_NAMED = frozenset(("LL401", "LL411", "LL502"))


def judged_by_assistant(findings: Iterable[Finding], known: Known) -> Iterator[Finding]:
    """``findings``, those as information that only a switch of the assistant's shows which nothing here gives."""
    for finding in findings:
        if finding.severity is Severity.ERROR and finding.rule in _NAMED and finding.key not in known.by_default and finding.arguments:
            entry, uses = known.file(finding.entry), known.packages.arg_uses()
            package = known.packages.package_of(known.file(finding.location.path))
            switches = all(value.lower() in BOOLEANS and not uses.is_passed(entry, name) for name, value in finding.arguments)
            if switches and package is not None and is_file(os.path.join(package.directory, ".setup_assistant")):
                given = " ".join(f"{name}:={value}" for name, value in finding.arguments)
                finding = finding._replace(severity=Severity.INFO, notes=(*finding.notes, NOTE.format(given)))
        yield finding
