"""Args that no launch file reads and that other files of the workspace give to it: they may have to be there.

Which files those are is worked out when everything has been checked: what is said of one launch file would else hang on all the others.
"""

from __future__ import annotations

import os
from collections.abc import Iterable, Iterator

from launchlint.check.known import Known
from launchlint.finding import Finding, Severity
from launchlint.rules.args.unused_arg import RULE, name_of

FAMILY = "an include with a computed file name passes it, so that files like this one have to take it"


def judged_by_givers(findings: Iterable[Finding], known: Known) -> Iterator[Finding]:
    """``findings``, those of LL206 about args that others give as infos, and without the removal where an include passes the arg."""
    for finding in findings:
        if finding.rule == RULE.id:
            name = name_of(finding)
            uses = known.packages.arg_uses()
            file = known.file(finding.location.path)
            giver = uses.giver(file, name)
            reason = ""
            if giver is not None:
                reason = f"{os.path.relpath(giver, known.root).replace(os.sep, '/')} gives it with :=, so that it may have to be there"
            elif uses.may_be_passed(name):
                reason = FAMILY
            if reason and finding.severity is RULE.severity:
                cause = f"{finding.cause}; {reason}"
                finding = finding._replace(severity=Severity.INFO, notes=(reason,), cause=cause)
            if reason or uses.is_passed(file, name):
                finding = finding._replace(fix=None)
        yield finding
