"""Args that no launch file reads: those that other files of the workspace give may have to be there, some others nobody gives.

Which files those are is worked out when everything has been checked: what is said of one launch file would else hang on all the others.
"""

from __future__ import annotations

import os
from collections.abc import Iterable, Iterator

from launchlint.check.known import Known
from launchlint.finding import Finding, Severity
from launchlint.rules.args.unused_arg import RULE, lacks_default, name_of
from launchlint.workspace.looking import content
from launchlint.workspace.registered_tests import TEST_END

TYPE_CHECKING = False
if TYPE_CHECKING:
    from launchlint.workspace.arg_uses import ArgUses

BARE = "it has no default, and no include passes it: roslaunch asks for it only where it is read, so that the file starts without it"
TEST = "no include passes it, and nobody gives args to a test"
FAMILY = "an include with a computed file name passes it, so that files like this one have to take it"
BESIDE = "{} beside this file is given the same args, and reads this one: the two have one interface"
_MANY = 3
"""Args that two files are given alike which were made with one interface."""


def judged_by_givers(findings: Iterable[Finding], known: Known) -> Iterator[Finding]:
    """``findings``, those of LL206 about args that others give, or nobody is likely to, as infos.

    Without the removal where an include passes the arg.
    """
    for finding in findings:
        if finding.rule == RULE.id:
            name = name_of(finding)
            uses = known.packages.arg_uses()
            file = known.file(finding.location.path)
            giver = uses.giver(file, name)
            passed = uses.is_passed(file, name)
            reason = ""
            if giver is not None:
                reason = f"{os.path.relpath(giver, known.root).replace(os.sep, '/')} gives it with :=, so that it may have to be there"
            elif uses.may_be_passed(name):
                reason = FAMILY
            elif passed:
                beside = _given_beside(file, name, uses)
                reason = BESIDE.format(beside) if beside else ""
            if reason or passed:
                finding = finding._replace(fix=None)
            elif lacks_default(finding):
                reason = BARE
            elif file.endswith(TEST_END):
                reason = TEST
            if reason and finding.severity is RULE.severity:
                cause = f"{RULE.id} {name}; {reason}" if reason is BARE else f"{finding.cause}; {reason}"
                finding = finding._replace(severity=Severity.INFO, notes=(reason,), cause=cause)
        yield finding


def _given_beside(file: str, name: str, uses: ArgUses) -> str:
    """A launch file beside ``file`` (absolute) to which includes pass the arg ``name`` and more of the same args, and which reads it."""
    directory, own = os.path.split(file)
    passed = uses.passed.get(own, frozenset())
    for other, args in sorted(uses.passed.items()):
        if other and other != own and name in args and len(args & passed) >= _MANY:
            text = content(os.path.join(directory, other))
            if text is not None and f"$(arg {name})".encode() in text:
                return other
    return ""
