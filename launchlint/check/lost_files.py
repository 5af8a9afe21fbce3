"""Files that are missing: one file that several places name, and one that copies of a launch file each look for, are one cause.

The rules see one place at a time, and give it the cause that this place shows: another one where a name like it is near, say.
"""

from __future__ import annotations

import posixpath
from collections.abc import Callable, Iterable, Iterator
from itertools import combinations

from launchlint.check.fragments import PREFIX as FRAGMENT
from launchlint.check.known import Known
from launchlint.finding import Finding, Severity
from launchlint.late import late
from launchlint.rules.judging.moved import COPIES, same_directory

_LOSSES = frozenset(("LL401", "LL411", "LL502"))
_WITH_PATH = frozenset(("LL401", "LL411"))
"""Those whose message tells the whole path."""
# Not the grammar of substitutions: a finding has no more than a shown line, in which copies of a file may name another package.
_PACKAGE = late(r"\$\(find [^()]*\)")
_MOST_COMPARED = 200
_DID_YOU_MEAN = "did you mean"


def judged_by_loss(findings: Iterable[Finding], _: Known) -> Iterator[Finding]:
    """``findings``, those about one missing file, or about the same one of each copy of a launch file, with one cause."""
    told = list(findings)
    lost = [at for at, each in enumerate(told) if _is_loss(each)]
    if len(lost) < 2:
        yield from told
        return
    for file in _grouped(told, lost, lambda each: (each.rule, each.severity, each.message) if each.rule in _WITH_PATH else None):
        best = min((told[at] for at in file), key=lambda each: (not each.help.startswith(_DID_YOU_MEAN), each.sort_key))
        for at in file:
            told[at] = told[at]._replace(cause=best.cause)
    joined: dict[str, str] = {}
    for copies in _grouped(told, lost, _as_written):
        first = _first(told[copies[0]].cause, joined)
        for at in copies[1:]:
            other = _first(told[at].cause, joined)
            if other != first:
                joined[other] = first
    causes = sorted({told[at].cause for at in lost})
    for one, other in combinations(causes[:_MOST_COMPARED], 2):
        if same_directory(one, other) and _first(one, joined) != _first(other, joined):
            joined[_first(other, joined)] = _first(one, joined)
    alike = {*joined, *joined.values()}
    for finding in told:
        yield finding._replace(cause=f"{COPIES}{_first(finding.cause, joined)}") if finding.cause in alike else finding


def _is_loss(finding: Finding) -> bool:
    return finding.rule in _LOSSES and finding.severity > Severity.INFO and bool(finding.cause) and not finding.cause.startswith(FRAGMENT)


def _as_written(finding: Finding) -> tuple[object, ...]:
    """What is the same in copies of a launch file: its name, and what it says, the packages aside."""
    name, missing = posixpath.basename(finding.location.path), posixpath.basename(finding.about[0]) if finding.about else finding.message
    return (finding.rule, finding.severity, name, missing, _PACKAGE.sub("$(find)", finding.element))


def _grouped(told: list[Finding], lost: list[int], key: Callable[[Finding], tuple[object, ...] | None]) -> Iterator[list[int]]:
    """Those of ``lost`` (places in ``told``) that have the same ``key``, in order, where there are several."""
    groups: dict[tuple[object, ...], list[int]] = {}
    for at in lost:
        same = key(told[at])
        if same is not None:
            groups.setdefault(same, []).append(at)
    return (group for group in groups.values() if len(group) > 1)


def _first(cause: str, joined: dict[str, str]) -> str:
    """The cause that stands for ``cause``."""
    while cause in joined:
        cause = joined[cause]
    return cause
