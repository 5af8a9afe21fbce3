"""Files that are not found by the default of an arg which every launch file that includes this one overrides: nobody comes to that."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Set

from launchlint.check.known import Known
from launchlint.finding import Finding, Severity
from launchlint.syntax.ros1.substitutions import parse

NOTE = "only the default of {} leads there: the launch files here that include this one give it another value"
NOTE2 = "only the defaults of this file lead there: the launch files here that include it name another one"
_NAMED = frozenset(("LL401", "LL502"))
_FOR_NODES = "LL411"
"""What nodes are told to read."""


def judged_by_includers(findings: Iterable[Finding], known: Known) -> Iterator[Finding]:
    """``findings``, those as information that only a file started alone shows, while all that include it give the arg in the name."""
    for finding in findings:
        if _is_warning_of_ros2(finding) and finding.key in known.by_default:
            if _is_overridden_everywhere(known.reached.get(finding.key, frozenset()), known):
                finding = finding._replace(severity=Severity.INFO, notes=(*finding.notes, NOTE2))
        elif _is_of_missing_file(finding) and finding.key in known.by_default:
            path = finding.location.path
            names = list(parse(finding.location.marked).names("arg"))
            if names and _is_overridden_everywhere(known.reached.get(finding.key, frozenset()), known):
                uses, file = known.packages.arg_uses(), known.file(path)
                given = [name for name in names if uses.is_passed(file, name)]
                if given:
                    finding = finding._replace(severity=Severity.INFO, notes=(*finding.notes, NOTE.format(given[0])))
        yield finding


def _is_of_missing_file(finding: Finding) -> bool:
    """Whether roslaunch, or a node that it starts, finds no file."""
    return finding.severity > Severity.INFO if finding.rule == _FOR_NODES else finding.severity is Severity.ERROR and finding.rule in _NAMED


def _is_warning_of_ros2(finding: Finding) -> bool:
    """Whether ros2 launch only warns of a file that is not there; by which arg it was named, a launch file in Python need not show."""
    return finding.rule in _NAMED and finding.severity is Severity.WARNING and finding.launcher != "roslaunch"


def _is_overridden_everywhere(alone: Set[str], known: Known) -> bool:
    """Whether of the entry files that come to it each is included by one that does not: the defaults of the first count for nobody."""
    return bool(alone) and all(known.included_by.get(path, frozenset()) - alone for path in alone)
