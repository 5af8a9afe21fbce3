"""Args that no launch file reads and that other files of the workspace give to it: they may have to be there.

Which files those are is worked out when everything has been checked: what is said of one launch file would else hang on all the others.
"""

from __future__ import annotations

import os
from collections.abc import Iterable, Iterator

from launchlint.finding import Finding, Severity
from launchlint.rules.args.unused_arg import NAME, RULE
from launchlint.workspace.packages import Packages

FAMILY = "an include with a computed file name passes it, so that files like this one have to take it"


def judged_by_givers(findings: Iterable[Finding], packages: Packages, root: str) -> Iterator[Finding]:
    """``findings``, those of LL206 about args that others give as infos, and without the removal where an include passes the arg.

    ``root`` is the directory that shown paths are relative to.
    """
    for finding in findings:
        name = NAME.match(finding.message) if finding.rule == RULE.id else None
        if name is not None:
            uses = packages.arg_uses()
            file = os.path.abspath(os.path.join(root, finding.location.path))
            giver = uses.giver(file, name[1])
            reason = ""
            if giver is not None:
                reason = f"{os.path.relpath(giver, root).replace(os.sep, '/')} gives it with :=, so that it may have to be there"
            elif uses.may_be_passed(name[1]):
                reason = FAMILY
            if reason and finding.severity is RULE.severity:
                cause = f"{finding.cause}; {reason}"
                finding = finding._replace(severity=Severity.INFO, notes=(reason,), cause=cause)
            if reason or uses.is_passed(file, name[1]):
                finding = finding._replace(fix=None)
        yield finding
