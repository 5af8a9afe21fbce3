"""A remap that does nothing where it stands (LL601), and the name that meets nobody for want of it (LL612 and the like): one edit."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from launchlint.check.known import Known
from launchlint.finding import Finding
from launchlint.rules.judging.stray import STRAY

_VAIN = "LL601"
_LOOSE = frozenset(("LL612", "LL613", "LL614"))
_Place = tuple[str, int, int]


def judged_by_remap(findings: Iterable[Finding], _: Known) -> Iterator[Finding]:
    """``findings``, a remap that does nothing with the cause of the name that is as bad and would be met by what the remap says."""
    told = list(findings)
    vain = {each.location.bounds: each for each in told if each.rule == _VAIN}
    causes: dict[_Place, str] = {}
    for number, each in enumerate(told if vain else ()):
        for place in _strays(each):
            remap = vain.get(place)
            if remap is not None and each.severity >= remap.severity and place not in causes:
                causes[place] = each.cause or f"{each.rule} {each.location.path} {each.location.start} {each.message}"
                told[number] = each._replace(cause=causes[place])
    for each in told:
        place = each.location.bounds
        yield each._replace(cause=causes[place]) if each.rule == _VAIN and place in causes else each


def _strays(finding: Finding) -> Iterator[_Place]:
    for each in finding.related if finding.rule in _LOOSE else ():
        if each.label == STRAY:
            yield each.location.bounds
