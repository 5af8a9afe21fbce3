"""One file name that is both told to be of one machine (LL406) and found to lead nowhere (LL401, LL502): it is one name to write anew.

The worse of the two tells it; of two that are as bad the first, which says what to write instead.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from launchlint.check.copied import PREFIX as PROJECT
from launchlint.check.fragments import PREFIX as FRAGMENT
from launchlint.check.known import Known
from launchlint.finding import Finding

_OF_MACHINE = "LL406"
_LEADS_NOWHERE = frozenset(("LL401", "LL502"))
_Place = tuple[str, int, int]


def judged_by_name(findings: Iterable[Finding], _: Known) -> Iterator[Finding]:
    """``findings``, those of both kinds about one name with the cause of the one that tells it."""
    told = list(findings)
    of_machine = {_place(each): each for each in told if each.rule == _OF_MACHINE}
    nowhere: dict[_Place, Finding] = {}
    for each in told if of_machine else ():
        place = _place(each)
        if each.rule in _LEADS_NOWHERE and place in of_machine and not each.cause.startswith((PROJECT, FRAGMENT)):
            nowhere[place] = max(nowhere.get(place, each), each, key=lambda finding: finding.severity)
    for finding in told:
        place = _place(finding)
        if place in nowhere and (finding.rule == _OF_MACHINE or finding.rule in _LEADS_NOWHERE):
            one, other = of_machine[place], nowhere[place]
            teller = one if one.severity >= other.severity else other
            finding = finding._replace(cause=teller.cause or f"{teller.rule} {teller.location.path} {teller.message}")
        yield finding


def _place(finding: Finding) -> _Place:
    return finding.location.bounds
