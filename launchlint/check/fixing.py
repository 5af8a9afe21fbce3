"""``check --fix``: the fixes of findings, made in memory until there are none left, each judged by what it leads to.

A fix stays where the finding is gone afterwards, no other error or warning has come, and, where it is said to change nothing, the guard
proves that. All others are taken back, and told of with the reason.
"""

from __future__ import annotations

import os
from collections import Counter
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from collections.abc import Set as AbstractSet

from launchlint.check.entry import EntryChecker, EntryResult
from launchlint.check.ignores import PerFileIgnores
from launchlint.check.merge import Outcome, merge
from launchlint.check.options import Options
from launchlint.finding import Edit, Finding, Severity
from launchlint.fix import manifest
from launchlint.fix.edits import CannotEdit, Claims, Shift, apply
from launchlint.fix.guard import Caller, Guard
from launchlint.named_tuple import NamedTuple
from launchlint.rules.registry import RULES
from launchlint.workspace.manifest import MANIFEST_FILE, PACKAGE_FILE

TYPE_CHECKING = False
if TYPE_CHECKING:
    from launchlint.evaluate.session import Session

    _Key = tuple[str, str, int, str]

MOST_ATTEMPTS = 200
"""Sets of fixes that are tried. Every one that stays leaves fewer findings, so that there is an end in any case; this bounds the time."""
FEWEST_ATTEMPTS = 20
"""Sets of fixes that are tried however long the files are."""
MOST_TEXT = 32 << 20
"""Bytes of launch files that are checked again, or proved, over all attempts, before an attempt beyond the fewest is one too many."""


class Refused(NamedTuple):
    """A fix that was not made, and why."""

    finding: Finding
    reason: str


class _Fault(NamedTuple):
    """Why a set of fixes cannot stay, and of it those that are to blame as far as that can be told, by what each group did."""

    reason: str
    blamed: Sequence[Sequence[Finding]] = ()


class Fixed(NamedTuple):
    """What came of it: for each changed file (absolute) what it held and what it is to hold, the findings that are gone, what was not
    done, and what is found now. ``given_up``: after so many attempts, and there may be more that could be done; else 0.
    """

    files: Mapping[str, tuple[bytes, bytes]]
    made: tuple[Finding, ...]
    refused: tuple[Refused, ...]
    outcome: Outcome
    given_up: int


class Fixing:
    """The fixes of one run.

    ``may_change`` says of an absolute file name whether it is one that people asked to have changed; ``told`` leaves out the findings
    nobody wants to hear of, such as those of a baseline; with ``unsafe`` likely fixes are made too.
    """

    def __init__(
        self,
        checker: EntryChecker,
        results: Sequence[EntryResult],
        per_file: PerFileIgnores,
        *,
        asked: tuple[str, ...],
        may_change: Callable[[str], bool],
        told: Callable[[Outcome], Outcome],
        unsafe: bool,
    ) -> None:
        self._per_file = per_file
        self._asked = asked
        self._may_change = may_change
        self._told = told
        self._unsafe = unsafe
        self._selected = checker.options.rules
        self._state = _state(checker, results)
        self._outcome = self._merged(self._state)
        self._before: dict[str, bytes] = {}
        self._manifests: dict[str, bytes] = {}
        self._made: list[Finding] = []
        self._refused: list[Refused] = []
        self._apart: list[Sequence[Finding]] = []
        self._attempts = 0
        self._read_again = 0

    @property
    def _may_try(self) -> bool:
        read = self._read_again + self._state.guard.read
        return self._attempts < (MOST_ATTEMPTS if read < MOST_TEXT else FEWEST_ATTEMPTS)

    @property
    def _options(self) -> Options:
        return self._state.checker.options

    def run(self) -> Fixed:
        """Make all fixes that can be made."""
        while self._may_try:
            made = len(self._made)
            self._refused = []
            self._make()
            if not self._refused or len(self._made) == made:
                break  # else what could not be made at first may be possible now
        self._refused += [Refused(finding, f"{_name(error)} is to be mended first") for finding, error in self._waiting()]
        self._fix_manifests()
        files = {file: (before, self._state.text(file)) for file, before in self._before.items()}
        for file, after in self._manifests.items():
            files[file] = (self._state.text(file), after)
        return Fixed(
            {file: files[file] for file in sorted(files) if files[file][0] != files[file][1]},
            tuple(self._made), tuple(self._refused), self._outcome, 0 if self._may_try else self._attempts,
        )  # fmt: skip

    def refusal(self, finding: Finding) -> str:
        """Why the fix of one finding must not be made as things are, in one sentence without a full stop; empty where it may.

        Where it may be made, it has been: to be asked once.
        """
        paths = _paths(finding)
        if not any(map(_is_manifest, paths)):
            fault = self._try([finding])
            return "" if fault is None else fault.reason
        for path in paths:
            file = self._file(path)
            try:
                before = self._state.text(file)
                after = apply(before, [edit for edit in finding.fix.edits if edit.path == path] if finding.fix is not None else [])
                reason = manifest.refusal(file, before, after) if _is_manifest(path) else ""
            except CannotEdit as error:
                reason = str(error)
            if reason:
                return reason
        return ""

    # -- launch files ----------------------------------------------------------------------------------------------

    def _make(self) -> None:
        """Make fixes until none is left that has not been refused."""
        self._apart = []
        while self._may_try:
            # First what changes nothing, then what changes as little as the mistake did: the guard proves nothing of a mixture.
            apart = {_key(finding) for group in self._apart for finding in group}
            chosen = self._chosen(changing=False, without=apart)
            if not chosen and self._apart:
                chosen = self._chosen(of={_key(finding) for finding in self._apart.pop(0)})
            elif not chosen:
                chosen = self._chosen(changing=True)
                if not chosen:
                    return
            self._make_some(chosen)

    def _make_some(self, chosen: Sequence[Finding]) -> None:
        """Make the fixes of ``chosen``, or else of a part of it that can stay, so that others are tried apart; refuse a single one."""
        while chosen and self._may_try:
            self._attempts += 1
            fault = self._try(chosen)
            if fault is None:
                return
            if len(chosen) == 1:
                self._refused.append(Refused(chosen[0], fault.reason))
                return
            groups = [group for group in fault.blamed if len(group) < len(chosen)]
            blamed = {_key(finding) for group in groups for finding in group}
            rest = [finding for finding in chosen if _key(finding) not in blamed]
            if not groups:
                half = len(chosen) // 2
                rest, groups = list(chosen[:half]), [chosen[half:]]
            self._apart[:0] = groups
            chosen = rest

    def _chosen(
        self, *, changing: bool | None = None, of: AbstractSet[_Key] | None = None, without: AbstractSet[_Key] = frozenset()
    ) -> list[Finding]:
        """The findings whose fixes can be made together, in report order: those that change something, those that do not, or only some."""
        claims = Claims()
        refused = {*without, *(_key(each.finding) for each in self._refused), *(_key(finding) for finding, _ in self._waiting())}
        chosen: list[Finding] = []
        for finding in self._wanted():
            fix, key = finding.fix, _key(finding)
            if fix is None or key in refused or (of is not None and key not in of) or any(map(_is_manifest, _paths(finding))):
                continue
            if changing in (None, _changes(finding)) and claims.take(fix.edits):
                chosen.append(finding)
        return chosen

    def _waiting(self) -> Iterator[tuple[Finding, Finding]]:
        """What would be removed as useless from a file with an error, which may be why nothing uses it; each with that error."""
        errors = {each.location.path: each for each in reversed(self._outcome.findings) if each.severity is Severity.ERROR}
        for finding in self._wanted():
            fix, error = finding.fix, errors.get(finding.location.path)
            removes = fix is not None and fix.changes and not fix.safe and not any(edit.text for edit in fix.edits)
            if removes and error is not None and finding.severity is not Severity.ERROR:
                yield finding, error

    def _wanted(self) -> Iterator[Finding]:
        return (finding for finding in self._told(self._outcome).findings if self._is_wanted(finding))

    def _is_wanted(self, finding: Finding) -> bool:
        fix = finding.fix
        if fix is None or finding.rule not in self._selected or not (fix.safe or self._unsafe):
            return False
        return all(self._may_change(self._file(path)) for path in _paths(finding))

    def _try(self, chosen: Sequence[Finding]) -> _Fault | None:
        """Make the fixes of ``chosen``; why not, where they cannot all stay (then nothing has happened)."""
        edits = _by_path(chosen)
        texts: dict[str, bytes] = {}
        try:
            for path, listed in edits.items():
                file = self._file(path)
                texts[file] = apply(self._state.text(file), listed)
        except CannotEdit as error:
            return _Fault(str(error))
        if not all(map(_changes, chosen)):
            reasons = self._state.guard.refusals(texts)
            if reasons:
                first = {self._file(path): path for path in edits}
                return _Fault(next(iter(reasons.values())), _by_file(chosen, [first[file] for file in reasons]))
        state = self._state.after(texts)
        self._read_again += state.read_again
        outcome = self._merged(state)
        shifts = {path: Shift(listed) for path, listed in edits.items()}
        # A dependency that package.xml lacks now is added in the end.
        expected = [each for each in outcome.findings if not (self._is_wanted(each) and all(map(_is_manifest, _paths(each))))]
        fault = _fault(self._outcome.findings, expected, chosen, shifts)
        if fault is not None:
            return fault
        for file in texts:
            self._before.setdefault(file, self._state.text(file))
        self._state, self._outcome = state, outcome
        self._made += chosen
        self._refused = [Refused(_moved(each.finding, shifts), each.reason) for each in self._refused]
        self._apart = [[_moved(finding, shifts) for finding in group] for group in self._apart]
        return None

    def _merged(self, state: _State) -> Outcome:
        checker = state.checker
        return merge(state.results, checker.options, checker.packages, self._per_file, asked=self._asked)

    def _file(self, path: str) -> str:
        return os.path.join(self._options.root, path)

    # -- package.xml -----------------------------------------------------------------------------------------------

    def _fix_manifests(self) -> None:
        """Make the fixes in ``package.xml`` files, one after the other: they add dependencies, of which no launch file takes notice."""
        by_path: dict[str, list[Finding]] = {}
        for finding in self._wanted():
            paths = _paths(finding)
            if all(map(_is_manifest, paths)) and len(paths) == 1:
                by_path.setdefault(paths[0], []).append(finding)
        for path, findings in by_path.items():
            file = self._file(path)
            before = self._state.text(file)
            kept: list[Edit] = []
            for finding in findings:
                edits = finding.fix.edits if finding.fix is not None else ()
                try:
                    after = apply(before, [*kept, *edits])
                    reason = manifest.refusal(file, before, after)
                except CannotEdit as error:
                    reason = str(error)
                if reason:
                    self._refused.append(Refused(finding, reason))
                    continue
                kept += edits
                self._manifests[file] = after
                self._made.append(finding)


def _state(checker: EntryChecker, results: Sequence[EntryResult]) -> _State:
    """As things are. All rules that are on by default judge the fixes, also where fewer are asked for."""
    judging = checker.options.rules.union(rule.id for rule in RULES if rule.default)
    fixable = any(finding.fix is not None for result in results for finding in _all(result))
    if judging == checker.options.rules or not fixable:
        return _State(checker, list(results))
    checker = EntryChecker(checker.options._replace(rules=judging), checker.session.overlay)
    return _State(checker, [checker.check(result.request) for result in results])


def _all(result: EntryResult) -> Iterator[Finding]:
    yield from result.findings
    for file in result.files:
        yield from (guarded.finding for guarded in file.findings)


class _State:
    """The files as they are at one point, and what was found in them. ``read_again``: bytes of the files that were checked for it."""

    def __init__(self, checker: EntryChecker, results: list[EntryResult], read_again: int = 0, guard: Guard | None = None) -> None:
        self.checker = checker
        self.results = results
        self.read_again = read_again
        self.guard = guard or Guard(checker.session, _Callers(checker.session, results))

    def text(self, file: str) -> bytes:
        """What ``file`` holds; raises CannotEdit."""
        read = self.checker.session.read(file)
        if read.data is None:
            raise CannotEdit(read.reason)
        return read.data

    def after(self, texts: Mapping[str, bytes]) -> _State:
        """With ``texts`` in place of what these files hold: all entries that reach one of them are checked again."""
        checker = self.checker.holding(texts)
        changed = {checker.session.shown(file) for file in texts}
        again = [changed.intersection(file.path for file in each.files) or each.path in changed for each in self.results]
        results = [checker.check(each.request) if anew else each for each, anew in zip(self.results, again, strict=True)]
        read = Counter(file.path for each, anew in zip(results, again, strict=True) if anew for file in each.files)
        root, session = checker.options.root, checker.session
        read_again = sum(times * len(session.read(os.path.join(root, path)).data or b"") for path, times in read.items())
        return _State(checker, results, read_again, self.guard.holding(texts, _Callers(session, results)))


class _Callers:
    """The entry files that lead to a file, with the args they are given."""

    def __init__(self, session: Session, results: Iterable[EntryResult]) -> None:
        self._session = session
        self._by_path: dict[str, list[Caller]] = {}
        for result in results:
            for path in dict.fromkeys(each.path for each in result.files):
                self._by_path.setdefault(path, []).append(Caller(result.request.at, result.request.arguments))

    def __call__(self, file: str) -> Iterable[Caller]:
        """Those of ``file``."""
        return self._by_path.get(self._session.shown(file), ())


def _key(finding: Finding) -> _Key:
    return (finding.rule, finding.location.path, finding.location.start, finding.topic)


def _changes(finding: Finding) -> bool:
    """Whether the fix of a finding is one that makes the launcher do something else."""
    return finding.fix is not None and bool(finding.fix.changes)


def _paths(finding: Finding) -> list[str]:
    return [] if finding.fix is None else list(dict.fromkeys(edit.path for edit in finding.fix.edits))


def _is_manifest(path: str) -> bool:
    return os.path.basename(path) in (PACKAGE_FILE, MANIFEST_FILE)


def _by_path(findings: Iterable[Finding]) -> dict[str, list[Edit]]:
    found: dict[str, list[Edit]] = {}
    for finding in findings:
        for edit in finding.fix.edits if finding.fix is not None else ():
            found.setdefault(edit.path, []).append(edit)
    return found


def _moved(finding: Finding, shifts: Mapping[str, Shift]) -> Finding:
    """``finding`` with the start and end that it has after the edits."""
    at = finding.location
    shift = shifts.get(at.path)
    return finding if shift is None else finding._replace(location=at._replace(start=shift(at.start), end=shift(at.end)))


def _by_file(chosen: Sequence[Finding], paths: Sequence[str]) -> list[list[Finding]]:
    """The findings of ``chosen`` whose fixes change one of ``paths``, by the first such."""
    groups: dict[str, list[Finding]] = {path: [] for path in paths}
    for finding in chosen:
        path = next((path for path in _paths(finding) if path in groups), None)
        if path is not None:
            groups[path].append(finding)
    return list(groups.values())


def _fault(before: Sequence[Finding], after: Sequence[Finding], fixed: Sequence[Finding], shifts: Mapping[str, Shift]) -> _Fault | None:
    """Why the fixes of ``fixed`` must be taken back: some leave their finding, or bring another one where they change a file."""
    gone = {_key(_moved(finding, shifts)): finding for finding in fixed}
    known: dict[_Key, int] = {}
    said: Counter[tuple[str, str, str]] = Counter()
    for finding in before:
        key = _key(_moved(finding, shifts))
        known[key] = max(known.get(key, 0), int(finding.severity))
        said[_words(finding)] += 1
    reasons: list[str] = []
    left: dict[_Key, Finding] = {}
    for finding in after:
        key = _key(finding)
        if key in gone:
            reasons.append(f"{_name(finding)} would still be found")
            left[key] = gone[key]
        said[_words(finding)] -= 1
    blamed = [[finding] for finding in left.values()]
    paths: dict[str, None] = {}
    for finding in after if not left else ():
        # What says the same as often as before has only moved; of infos there may be more, as of what is now seen for the first time.
        if finding.severity > Severity.INFO and int(finding.severity) > known.get(_key(finding), 0) and said[_words(finding)] < 0:
            at = finding.location
            reasons.append(f"{_name(finding)} would be found in line {at.line} of {at.path}: {finding.message}")
            paths.update(dict.fromkeys((at.path, *(each.location.path for each in finding.related))))
    if paths:
        blamed = [group for group in _by_file(fixed, list(paths)) if group]
    return _Fault(reasons[0], blamed) if reasons else None


def _words(finding: Finding) -> tuple[str, str, str]:
    return (finding.rule, finding.location.path, f"{finding.severity.word} {finding.message}")


def _name(finding: Finding) -> str:
    return f"{finding.rule} {finding.name}"
