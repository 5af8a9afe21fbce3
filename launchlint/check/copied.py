"""Copies of public packages, and of whole projects, among packages of other people: what is untidy there is for those to mend who maintain
the original; and so is whatever is wrong in those launch files of a copied package that nothing outside of it leads to.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from typing import NamedTuple

from launchlint.check.known import Known
from launchlint.finding import Finding, Severity
from launchlint.workspace.package import Package
from launchlint.workspace.packages import Packages

NOTE = "{} is a copy of a public package, and that is where to mend it"
NAMED = "{} names another repository as its own, and that is where to mend it"
WHOLE = "{} is part of another project, {}, which is kept here as a whole, and that is where to mend it"
_LAUNCH_ENDS = (".launch", ".xml", ".test")
_UNTIDY = frozenset(("LL111", "LL206", "LL210", "LL303", "LL411", "LL504", "LL508", "LL601", "LL623", "LL702"))
"""By their IDs: in most runs none of these modules has to be loaded for this. LL701 says it itself, since it proposes a line."""


class _Origin(NamedTuple):
    """Whose copy a package is, in words (empty: nobody's), and whether it certainly is one of a public package."""

    note: str
    is_public: bool = False


def judged_by_origin(findings: Iterable[Finding], known: Known) -> Iterator[Finding]:
    """``findings``, the warnings of rules about untidiness in copied packages as infos, apart from those elsewhere.

    In copies of public packages all that people meet only who start a launch file of the copy.
    """
    copies: dict[str, _Origin] = {}
    for finding in findings:
        untidy = finding.rule in _UNTIDY and finding.severity is Severity.WARNING
        if untidy or (finding.severity > Severity.INFO and finding.location.path.endswith(_LAUNCH_ENDS)):
            package = known.packages.package_of(known.file(finding.location.path))
            if package is not None:
                if package.directory not in copies:
                    copies[package.directory] = _origin(package, known.packages)
                note, is_public = copies[package.directory]
                if note and (untidy or (is_public and _is_its_own(finding, package, known))):
                    cause = finding.cause and f"{finding.cause}; {note}"
                    finding = finding._replace(severity=Severity.INFO, notes=(*finding.notes, note), cause=cause)
        yield finding


def _is_its_own(finding: Finding, package: Package, known: Known) -> bool:
    """Whether only launch files of ``package`` itself lead to ``finding``."""
    paths = {finding.location.path, *known.reached.get(finding.key, ())}
    return all(known.file(path).startswith(f"{package.directory}/") for path in paths)


def _origin(package: Package, packages: Packages) -> _Origin:
    """Whose copy a package is."""
    from launchlint.rules.judging.left_out import is_copy, is_from_elsewhere, kept_whole

    if is_copy(package, packages):
        return _Origin(NOTE.format(package.name), True)
    if is_from_elsewhere(package, packages):
        return _Origin(NAMED.format(package.name))
    project = kept_whole(package, packages)
    return _Origin(WHOLE.format(package.name, project) if project else "")
