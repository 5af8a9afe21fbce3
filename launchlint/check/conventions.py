"""Environment variables that many launch files of a workspace read, or that are many of one kind: a convention there, and no oversight.

How many do is worked out when everything has been checked: what is said of one launch file would else hang on all the others.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from launchlint.check.known import Known
from launchlint.finding import Finding, Severity

TYPE_CHECKING = False
if TYPE_CHECKING:
    from launchlint.workspace.variables import Readers

CONVENTION = 3
"""Launch files of a workspace that read a variable, from which it is no oversight; one less where none of them has a default for it."""
FAMILY = 3
"""Variables of one first word, none of them with a default anywhere, from which they are a site's configuration."""
_UNSET = "LL209"
"""By its ID: nearly no run has a finding of this rule, and its module takes a while to load."""


def judged_by_conventions(findings: Iterable[Finding], known: Known) -> Iterator[Finding]:
    """``findings``, those of LL209 about variables of which launch files read several, or several launch files one, as infos.

    Each such variable, or kind of variables, is told of on its own.
    """
    readers: Readers | None = None
    for finding in findings:
        if finding.rule == _UNSET:
            if readers is None:
                readers = known.packages.launch_readers()
            finding = _judged(finding, readers)
        yield finding


def _judged(finding: Finding, readers: Readers) -> Finding:
    from launchlint.rules.args.env_unset import RULE, slip_of

    if finding.severity is not RULE.severity or slip_of(finding.topic) is not None:
        return finding
    reason, kind = _convention(finding.topic, readers)
    if not reason:
        others = [word for word in finding.cause.split(" ") if not _convention(word, readers)[0]]
        return finding._replace(cause=" ".join(others))
    return finding._replace(severity=Severity.INFO, notes=(*finding.notes, reason), cause=f"{RULE.id} {kind}")


def _convention(name: str, readers: Readers) -> tuple[str, str]:
    """Why the variable is one of a convention, and of which; empty where it is not."""
    from launchlint.rules.args.env_unset import OF_A_SITE, USUAL

    count = readers.counts.get(name, 0)
    if count == 1 and name in readers.again and name not in readers.optional:
        return "this file reads it at several places, none with a default: it is no slip", name
    if count >= CONVENTION or (count == CONVENTION - 1 and name not in readers.optional):
        return f"{count} launch files read it: it is a convention here", name
    prefix, members = readers.family(name)
    if members < FAMILY or name in readers.optional or any(each.startswith(prefix) for each in USUAL):
        return "", ""
    return f"{OF_A_SITE} {members} variables that begin with {prefix}, none with a default: they are the configuration of a site", prefix
