"""Packages that were copied, and those of people who do not declare what they use: what their ``package.xml`` lack is told once."""

from __future__ import annotations

import posixpath
from collections.abc import Iterator, Sequence

from launchlint.finding import Finding, Related, Severity
from launchlint.plural import listed
from launchlint.rules.judging.joined import joined

_COPIES = 3
"""Packages that lack the same of which nobody wants to read one by one."""
_MANY = 2
"""Packages that two do not lack alike by chance."""
_HABIT = 3
"""Packages of one checkout that lack something: nobody forgot them one by one."""
_MANIFEST = "package.xml"
_MOST_NAMED = 6


def told_of_copies(findings: Sequence[Finding]) -> Iterator[Finding]:
    """One for all packages that lack something, where these are several, or two of which one lacks more than the other does and all of
    that; else one for those that lack the same two or more packages.

    Of the former nobody declares what launch files use; of the latter one was made after the other, or is the same, kept twice: two
    packages have to lack three. ``findings`` are about one ``package.xml`` each; :attr:`Finding.about` says how many packages it
    lacks, which ones in words, then each of them, and nothing where it is one. Of one that is kept twice, what one copy lacks besides is
    told of that one, with the other.
    """
    once = list(_of_one_name(findings))
    habit = [each for each in once if each.severity is Severity.WARNING and posixpath.basename(each.location.path) == _MANIFEST]
    if len(habit) >= _HABIT or (len(habit) > 1 and _lacks_more(habit)):
        yield _habitual(habit)
        once = [each for each in once if each not in habit]
    alike: dict[tuple[Severity, tuple[str, ...]], list[Finding]] = {}
    for finding in once:
        alike.setdefault((finding.severity, finding.about[:2] or (finding.message,)), []).append(finding)
    for (_, lack), several in alike.items():
        called = {_called(each) for each in several}
        enough = 2 if len(called) == 1 or len(_lacking(several[0])) >= _MANY else _COPIES
        if len(several) >= enough and several[0].about:
            several = [joined(several)._replace(message=_say(len(several), lack))]
        yield from several


def _of_one_name(findings: Sequence[Finding]) -> Iterator[Finding]:
    """``findings``, one for each name of a package; of those called alike only, of which one lacks all that the others lack."""
    named: dict[tuple[Severity, str], list[Finding]] = {}
    for finding in findings:
        named.setdefault((finding.severity, _called(finding)), []).append(finding)
    for several in named.values():
        most = max(several, key=lambda each: len(_lacking(each)))
        if len(several) > 1 and all(_lacking(each) <= _lacking(most) for each in several):
            told = joined(several, most)
            several = [told._replace(message=_say(len(several), most.about)) if most.about else told]
        yield from several


def _lacks_more(findings: Sequence[Finding]) -> bool:
    """Whether one package lacks all that the others lack, and more."""
    most = max(findings, key=lambda each: len(_lacking(each)))
    return all(each is most or _lacking(each) < _lacking(most) for each in findings)


def _habitual(findings: Sequence[Finding]) -> Finding:
    """One for all of ``findings``: first where each ``package.xml`` is, with what it lacks, then where that is used."""
    told = joined(findings)
    places = {each.location: f"{_called(each)} lacks {listed(sorted(_lacking(each)), _MOST_NAMED)}" for each in findings}
    named = listed(sorted(map(_called, findings)), _MOST_NAMED)
    others = tuple(Related(place, lacks) for place, lacks in places.items() if place != told.location)
    return told._replace(
        message=f"{len(findings)} packages do not declare all that their launch files use: {named}",
        label=places[told.location],
        related=(*others, *(each for each in told.related if each.location not in places)),
        notes=("their launch files work only where something else brings along what they use",),
    )


def _say(count: int, lack: Sequence[str]) -> str:
    return f"{count} packages do not declare {lack[0]} that their launch files use: {lack[1]}"


def _called(finding: Finding) -> str:
    return posixpath.basename(posixpath.dirname(finding.location.path)) or _MANIFEST


def _lacking(finding: Finding) -> frozenset[str]:
    return frozenset(finding.about[2:] or (finding.topic,))
