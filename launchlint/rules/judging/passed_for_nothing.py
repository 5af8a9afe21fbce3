"""Args that are passed to files of which none knows them: what several such findings come to, in ROS 1 and in ROS 2."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Sequence

from launchlint.finding import Finding
from launchlint.plural import listed
from launchlint.rules.judging.joined import alike, joined

_MOST_NAMED = 6
_MOST_FILES = 3


def about(name: str, file: str, near: str | None) -> tuple[str, ...]:
    """:attr:`Finding.about` where ``file`` is given the arg ``name`` and does not know it; ``near`` is the one that may be meant."""
    return (near or "", file, name)


def said(files: Sequence[str], names: Sequence[str]) -> str:
    """What is wrong: none of ``files`` has anything that knows the args ``names``."""
    *most, last = files
    where = f"{', '.join(most)} or {last}" if most and len(files) <= _MOST_FILES else listed(files, _MOST_FILES)
    return f"nothing in {where} knows the arg{'s' if len(names) > 1 else ''} {listed(names, _MOST_NAMED)}"


def of_one_file(findings: Sequence[Finding]) -> Finding:
    """One for all that is passed to one file for nothing, by the names of the args."""
    told = joined(findings)
    near, file, *_ = told.about
    names = list(dict.fromkeys(name for each in findings for name in each.about[2:]))
    if len(names) < 2:
        return told
    return told._replace(message=said([file], names), help="remove them, or declare them there", about=(near, file, *names))


def of_several_files(findings: Sequence[Finding]) -> Iterator[Finding]:
    """One for what one file passes to several for nothing: of each of these, the arg that most of them are given."""
    given = Counter((each.location.path, each.about[0], name) for each in findings for name in each.about[2:])

    def common(finding: Finding) -> tuple[str, str, str]:
        path, (near, _, *names) = finding.location.path, finding.about
        return max(((path, near, name) for name in names), key=lambda each: (given[each], each))

    for several in alike(findings, common):
        told = joined(several) if len(several) > 1 else several[0]
        files = list(dict.fromkeys(each.about[1] for each in several))
        if len(files) > 1:
            differ = len({frozenset(each.about[2:]) for each in several}) > 1
            words = said(files, [common(told)[2]] if differ else told.about[2:])
            told = told._replace(message=f"{words}, or others that it is given" if differ else words)
        yield told
