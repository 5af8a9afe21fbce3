"""Files that are included twice: which two includes bring what is there twice, and what one of them brings all of."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Sequence

from launchlint.finding import Finding, Location
from launchlint.model import Node
from launchlint.rules.judging.joined import alike, joined

_NAMED = 1
"""Names in :attr:`Finding.about` that stand before :func:`ways`."""


def ways(first: Node, second: Node) -> tuple[str, ...]:
    """The two includes, ``PATH:LINE``, from which the ways to two nodes part; empty where one is no include, or both are the same."""
    for one, other in zip(first.origin.chain, second.origin.chain, strict=False):
        if one != other:
            return tuple(f"{at.path}:{at.line}" for at in (Location.of(one), Location.of(other)))
    return ()


def told_of_includes(findings: Sequence[Finding]) -> Iterator[Finding]:
    """One of ``findings`` for all files that one include brings, while others bring each of them, too: it is that one which is too much.

    :attr:`Finding.about` has :func:`ways` behind the name, where a file is included twice.
    """
    count = Counter(include for each in findings for include in dict.fromkeys(each.about[_NAMED:]))

    def common(finding: Finding) -> object:
        return max(dict.fromkeys(finding.about[_NAMED:]), key=lambda include: (count[include], include), default=finding.key)

    for several in alike(findings, common):
        if len(several) < 2:
            yield from several
            continue
        told = joined(several)
        yield told._replace(notes=(f"{common(told)} brings all of them, and other includes bring each of them, too", *told.notes))
