"""Which findings are new since a revision, and which are fixed: the whole run once more, of the files as they were."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence

from launchlint.check.causes import Told, told_with_theirs
from launchlint.check.entry import EntryResult
from launchlint.check.graphs import Revision
from launchlint.check.ignores import PerFileIgnores
from launchlint.check.merge import merge
from launchlint.check.options import EntryRequest
from launchlint.check.survey import Surveyed, Surveyor, reached
from launchlint.finding import Finding
from launchlint.fingerprint import fingerprints
from launchlint.named_tuple import NamedTuple
from launchlint.verdict import Verdict


class Since(NamedTuple):
    """What became of findings and verdicts.

    ``new`` are fingerprints of findings that were not there, ``fixed`` those that are not there any more, each with its fingerprint;
    ``fixed_in`` has their indexes and ``verdicts`` what its launcher made of the file, by the path of the entry file.
    """

    new: frozenset[str] = frozenset()
    fixed: Sequence[tuple[Finding, str]] = ()
    fixed_in: Mapping[str, Sequence[int]] = {}
    verdicts: Mapping[str, Verdict] = {}


def since(
    surveyed: Sequence[Surveyed], gone: Iterable[EntryRequest], surveyor: Surveyor, old: Revision, told: Sequence[Told],
    per_file: PerFileIgnores, asked: Sequence[str],
) -> Since:  # fmt: skip
    """What changed from the revision ``old`` to what is ``told``. ``gone`` are the entry files that are no more, as they are there.

    The single findings are compared: one that stands for several is new where any of them is, wherever it is told.
    """
    before = [each for each in (_before(one.result, surveyor, old) for one in surveyed) if each is not None]
    before += [old.checker.check(request) for request in gone]
    options = old.checker.options
    known = merge(before, options, old.checker.packages, per_file, asked=tuple(old.place(path) for path in asked)).findings
    was = {mark: finding for finding, mark in fingerprints(known)}
    now = {mark: finding for finding, mark in fingerprints([finding for each in told for finding in each.of])}
    appeared = {id(finding) for mark, finding in now.items() if mark not in was}
    left = {id(finding): mark for mark, finding in was.items() if mark not in now}
    fixed = told_with_theirs([finding for mark, finding in was.items() if mark not in now])
    marks = fingerprints([each.finding for each in told])
    return Since(
        frozenset(mark for (_, mark), each in zip(marks, told, strict=True) if any(id(finding) in appeared for finding in each.of)),
        [(_at_home(each.finding, old), left[id(each.of[0])]) for each in fixed],
        dict(zip((result.path for result in before), reached(fixed, [Surveyed(each, None, {}) for each in before]), strict=True)),
        {result.path: result.outcome for result in before},
    )


def _before(result: EntryResult, surveyor: Surveyor, old: Revision) -> EntryResult | None:
    """The same entry file at the revision; checked anew only where something that it reads is otherwise."""
    request = old.request(result.request)
    if request is None:
        return None
    if old.differs(surveyor.options.root, result.launch_files):
        return old.checker.check(request)
    return result


def _at_home(finding: Finding, old: Revision) -> Finding:
    return finding._replace(message=old.at_home(finding.message), help=old.at_home(finding.help), label=old.at_home(finding.label))
