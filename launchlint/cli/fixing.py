"""``check --fix``, ``--unsafe-fixes`` and ``--diff``: what is done with the fixes that were found, and said of them."""

from __future__ import annotations

import os
import sys
from collections.abc import Callable, Collection, Sequence

from launchlint.check.entry import EntryChecker, EntryResult
from launchlint.check.fixing import Fixing, Refused
from launchlint.check.ignores import PerFileIgnores
from launchlint.check.merge import Outcome
from launchlint.cli.entries import tell
from launchlint.cli.output import Request, report
from launchlint.errors import UsageError
from launchlint.plural import counted
from launchlint.project.asked import EntryOptions
from launchlint.workspace.manifest import MANIFEST_FILE, PACKAGE_FILE
from launchlint.workspace.repository import repository_root


class Fixer:
    """The fixes of one call of ``check``, and what becomes of them. ``only``: the files that may be changed, where these are not all that
    are checked. ``failed``: a file could not be written.
    """

    def __init__(
        self,
        entry: EntryOptions,
        checker: EntryChecker,
        results: Sequence[EntryResult],
        per_file: PerFileIgnores,
        told: Callable[[Outcome], Outcome],
        *,
        only: frozenset[str] | None,
        unsafe: bool,
        quiet: bool,
    ) -> None:
        self.failed = False
        self._entry = entry
        self._session = checker.session
        self._quiet = quiet
        self._told = told
        asked = frozenset(os.path.realpath(result.request.at) for result in results)
        self._asked = asked if only is None else asked & only
        self._roots = tuple(repository_root(path) for path in ([entry.standard_input] if entry.standard_input else entry.paths))
        fixing = Fixing(checker, results, per_file, asked=entry.paths, may_change=self._may_change, told=told, unsafe=unsafe)
        self._fixed = fixing.run()

    def _may_change(self, file: str) -> bool:
        """Launch files that were asked for; and the manifest of a package in the same repository, of what one of them needs."""
        target = os.path.realpath(file)
        if os.path.basename(target) in (PACKAGE_FILE, MANIFEST_FILE):
            return self._entry.standard_input is None and self._root_of(target) is not None
        return target in self._asked and (self._entry.standard_input is not None or self._root_of(target) is not None)

    def _root_of(self, target: str) -> str | None:
        """The repository (or directory) asked for in which ``target`` lies; what links lead to elsewhere is not ours to change."""
        roots = (os.path.realpath(root) for root in self._roots)
        return next((root for root in roots if target.startswith(root.rstrip(os.sep) + os.sep)), None)

    def show(self, *, color: bool) -> int:
        """Print what would change as unified diffs. Returns 1 where anything would."""
        from launchlint.report.formats import emit
        from launchlint.report.patch import unified
        from launchlint.syntax.decode import decode

        for file, (before, after) in self._fixed.files.items():
            if not self._quiet:
                shown = self._session.shown(file)
                emit(unified(shown, decode(before).text, decode(after).text, color=color), sys.stdout)
        self._sum_up("would fix", self._fixed.files)
        return 2 if self._fixed.outcome.crashed else int(bool(self._fixed.files))

    def print_text(self, shown: Request, notices: tuple[str, ...]) -> int:
        """Print standard input with its fixes made, and tell on standard error of what is left. Returns the exit status."""
        assert self._entry.standard_input is not None
        file = os.path.abspath(self._entry.standard_input)
        texts = {os.path.abspath(name): after for name, (_, after) in self._fixed.files.items()}
        sys.stdout.buffer.write(texts.get(file, self._session.overlay[file]))
        sys.stdout.buffer.flush()
        self._sum_up("fixed", self._fixed.files)
        return report(self._told(self._fixed.outcome), shown, notices, sys.stderr)

    def write(self) -> bool:
        """Put the changed files back. Returns whether any was changed."""
        written = [file for file, texts in self._fixed.files.items() if self._write(file, *texts)]
        self._sum_up("fixed", written)
        return bool(written)

    def _write(self, file: str, before: bytes, after: bytes) -> bool:
        from launchlint.fix.write import write_back

        try:
            write_back(file, before, after, self._root_of(os.path.realpath(file)) or os.curdir)
        except UsageError as error:
            self.failed = True
            tell(str(error))
            return False
        return True

    def _sum_up(self, verb: str, changed: Collection[str]) -> None:
        """Say what could not be fixed, and how many findings are, in the files that were ``changed``."""
        if self._quiet:
            return
        for refused in self._fixed.refused:
            tell(_why_not(refused))
        if self._fixed.given_up:
            tell(f"gave up after {self._fixed.given_up} attempts; run the command again to go on")
        shown = {self._session.shown(file) for file in changed}
        count = sum(finding.fix is not None and shown.issuperset(edit.path for edit in finding.fix.edits) for finding in self._fixed.made)
        findings = counted(count, "finding", thousands=",")
        tell(f"{verb} {findings} in {counted(len(changed), 'file', thousands=',')}" if count else f"{verb} nothing")


def _why_not(refused: Refused) -> str:
    finding = refused.finding
    at = finding.location
    message = "" if finding.fix is None else finding.fix.message
    return f"not fixed: {at.path}:{at.line}:{at.column}: {finding.rule} {finding.name} ({message}): {refused.reason}"
