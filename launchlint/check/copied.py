"""Copies of public packages, and of whole projects, among packages of other people: what is untidy there is for those to mend who maintain
the original; and so is whatever is wrong in those launch files of a copy that nothing outside of it leads to.

What is refused in such a file of a project that may have been changed here, or not kept whole, is a warning; all of it is told once. It is
an info where launch files outside lead to others of that project: they chose what they need of it.
"""

from __future__ import annotations

import posixpath
from collections.abc import Iterable, Iterator, Sequence

from launchlint.check.known import Known
from launchlint.finding import Finding, Related, Severity
from launchlint.late import late
from launchlint.named_tuple import NamedTuple
from launchlint.rules.judging.joined import joined
from launchlint.workspace.looking import content
from launchlint.workspace.package import Package
from launchlint.workspace.packages import Packages

PREFIX = "project "
NOTE = "{} is a copy of a public package, and that is where to mend it"
NAMED = "{} is called as a public package, and says that it is from elsewhere: that is where to mend it"
BESIDE = "{} says whose it is, and they made none of the packages here that are left as a template: that is where to mend it"
SIGNED = "{} has a licence, of people who made none of the packages here that have none: that is where to mend it"
KNOWN = "{} is one of the packages that people copy into their workspaces: what was not changed here is to be mended where it is from"
MADE = "{} is of people whose packages are copied, under another name here: what was not changed here is to be mended where it is from"
RENAMED = "{} is a copy of the public package {} under another name, by what its package.xml says, and that is where to mend it"
GENERATED = "the setup assistant of CHAMP wrote {}, and would again"
WHOLE = "{} is part of another project, {}, which is kept here as a whole, and that is where to mend it"
WITHOUT = "{} is another project, which is kept here without a package.xml, and that is where to mend it"
_NAMES_PACKAGE = late(r"""(?:\bfind(?:-pkg-share)?[ ]+|\bpkg[ ]*=[ ]*["']|\bpackage[ ]*=[ ]*["']|share_directory\(["'])([A-Za-z][\w-]*)""")
"""How launch files of all kinds name a package."""
_ENDS = (".launch", ".xml", ".test", ".py", ".yaml", ".yml")
"""Of launch files, and of what they load."""
_UNTIDY = frozenset(("LL111", "LL115", "LL206", "LL210", "LL303", "LL411", "LL504", "LL507", "LL508", "LL601", "LL623", "LL702"))
"""By their IDs: in most runs none of these modules has to be loaded for this. LL701 says it itself, since it proposes a line."""
_OF_NAMES = frozenset(("LL210", "LL303"))
"""What calls a package by a name that it has not."""
_LOOSE = frozenset(("LL612", "LL613", "LL614"))
"""Names that meet nobody, in launch files of a copy alone: it may be joined elsewhere, or nobody there needs it."""


class _Origin(NamedTuple):
    """Whose copy a package is, in words (empty: nobody's); the directory that was copied, where that is certain; whether it is public.

    ``own``: the packages that people made here; a launch file of the copy that names one was written or changed here, too.
    ``is_changed``: it was given another name here, so that what is said of names of packages may come of that.
    """

    note: str
    directory: str = ""
    is_public: bool = False
    own: frozenset[str] = frozenset()
    is_changed: bool = False


_OWN = _Origin("")


def judged_by_origin(findings: Iterable[Finding], known: Known) -> Iterator[Finding]:
    """``findings``, those in copies at a milder level, where they are untidy, or only launch files of the copy lead to them.

    Then warnings are infos, and errors are, too, in copies of public packages; in other projects these are warnings of one cause.
    """
    origins = _Origins(known)
    for finding in findings:
        untidy = finding.rule in _UNTIDY and finding.severity is Severity.WARNING
        if untidy or (finding.severity > Severity.INFO and finding.location.path.endswith(_ENDS)):
            origin = origins.of(finding.location.path)
            if (
                origin.note
                and (
                    (untidy and not (origin.is_changed and finding.rule in _OF_NAMES))
                    or (origin.directory and origins.alone_lead_to(finding, origin))
                    or (finding.rule in _LOOSE and origins.has_of_itself(finding, origin))
                )
                and not origins.adapted(finding.location.path, origin)
            ):
                finding = _milder(finding, origin, chosen=origins.is_chosen_from(origin))
        yield finding


class _Origins:
    """Whose copies the packages are in which something is told of."""

    def __init__(self, known: Known) -> None:
        self._known = known
        self._of: dict[str, _Origin] = {}
        self._named: dict[str, frozenset[str]] = {}
        self._chosen: dict[str, bool] = {}

    def of(self, path: str) -> _Origin:
        """Of the package of the file that is shown as ``path``."""
        file = self._known.file(path)
        package = self._known.packages.package_of(file)
        if package is None:
            return self._without_package(posixpath.dirname(file))
        if package.directory not in self._of:
            self._of[package.directory] = _origin(package, self._known.packages)
        return self._of[package.directory]

    def _without_package(self, directory: str) -> _Origin:
        """Of what lies in no package, be it that its ``package.xml`` has another name until it is built."""
        from launchlint.rules.judging.kept_projects import kept_without_package

        if directory not in self._of:
            project = kept_without_package(directory, self._known.packages)
            name = posixpath.basename(project)
            self._of[directory] = _Origin(WITHOUT.format(name), project) if project else _OWN
        return self._of[directory]

    def adapted(self, path: str, origin: _Origin) -> bool:
        """Whether the launch file that is shown as ``path`` names a package that people made here."""
        if not origin.own:
            return False
        if path not in self._named:
            text = (content(self._known.file(path)) or b"").decode("utf-8", "replace")
            self._named[path] = frozenset(_NAMES_PACKAGE.findall(text))
        return not origin.own.isdisjoint(self._named[path])

    def is_chosen_from(self, origin: _Origin) -> bool:
        """Whether launch files outside of the copy include some of its: what none of them leads to is not needed here."""
        if not origin.directory:
            return False
        if origin.directory not in self._chosen:
            inside = f"{origin.directory}/"
            self._chosen[origin.directory] = any(
                self._known.file(path).startswith(inside) and not all(self._known.file(each).startswith(inside) for each in entries)
                for path, entries in self._known.included_by.items()
            )
        return self._chosen[origin.directory]

    def alone_lead_to(self, finding: Finding, origin: _Origin) -> bool:
        """Whether only launch files of the copy lead to ``finding``, or of copies that are public as it is."""
        paths = {finding.location.path, *self._known.reached.get(finding.key, ())}
        return all(
            self._known.file(path).startswith(f"{origin.directory}/") or (origin.is_public and self.of(path).is_public) for path in paths
        )

    def has_of_itself(self, finding: Finding, origin: _Origin) -> bool:
        """Whether a launch file of the copy leads to names that meet nobody, and all launch files concerned are of it.

        That others here include it as well changes nothing of that.
        """
        package = self._known.packages.package_of(self._known.file(finding.location.path))
        inside = f"{origin.directory or (package.directory if package is not None else '')}/"
        concerned = (finding.location.path, *(each.location.path for each in finding.related if each.location.path.endswith(_ENDS)))
        reached = self._known.reached.get(finding.key, ())
        if not any(self._known.file(path).startswith(inside) for path in reached):
            return False
        return all(self._known.file(path).startswith(inside) for path in concerned)


def told_together(findings: Sequence[Finding]) -> Finding:
    """One for all that is refused in one project: how much that is, with the places."""
    told = joined(findings)
    count = len({(each.message, each.location) for each in findings})
    if count == 1:
        return told
    others = tuple(Related(each.location, each.message) for each in findings if each.location != told.location)
    return told._replace(
        message=f"{count} things are wrong in {posixpath.basename(told.cause)}, a project of other people that is kept here",
        label=min(findings, key=lambda each: each.location != told.location).message,
        related=others,
        notes=(told.notes[-1],),
        help="get it again as it is there, or leave out what is not needed here",
        fix=None,
    )


def _milder(finding: Finding, origin: _Origin, *, chosen: bool) -> Finding:
    notes = (*finding.notes, origin.note)
    if finding.severity is Severity.ERROR and not origin.is_public:
        severity = Severity.INFO if chosen else Severity.WARNING
        return finding._replace(severity=severity, notes=notes, cause=PREFIX + origin.directory)
    return finding._replace(severity=Severity.INFO, notes=notes, cause=finding.cause and f"{finding.cause}; {origin.note}")


def _origin(package: Package, packages: Packages) -> _Origin:
    """Whose copy a package is."""
    from launchlint.rules.judging.kept_projects import kept_whole
    from launchlint.rules.judging.projects import (
        is_beside_own,
        is_copy,
        is_from_elsewhere,
        is_generated,
        is_of_copied_people,
        is_of_team,
        is_released,
        is_renamed,
        is_signed,
        is_well_known,
        left_as_made,
    )

    if is_copy(package, packages):
        return _Origin(NOTE.format(package.name), package.directory, is_public=True)
    project = kept_whole(package, packages)
    if project:
        note = WHOLE.format(package.name, posixpath.basename(project))
        return _Origin(note, project, is_public=is_released(package))
    if is_beside_own(package, packages):
        released = is_released(package)
        own = frozenset[str]() if released else left_as_made(package, packages)
        return _Origin((NOTE if released else BESIDE).format(package.name), package.directory, released, own)
    renamed = is_renamed(package, packages)
    if renamed:
        return _Origin(RENAMED.format(package.name, renamed), package.directory)
    if is_generated(package):
        return _Origin(GENERATED.format(package.name))
    if is_well_known(package, packages):
        return _Origin(KNOWN.format(package.name), package.directory, own=left_as_made(package, packages))
    if is_from_elsewhere(package, packages):
        return _Origin(NAMED.format(package.name), own=left_as_made(package, packages))
    if is_signed(package, packages):
        directory = "" if is_of_team(package, packages) else package.directory  # they may well be at home here: errors stay errors
        return _Origin(SIGNED.format(package.name), directory, own=left_as_made(package, packages))
    if is_of_copied_people(package, packages):
        return _Origin(MADE.format(package.name), own=left_as_made(package, packages), is_changed=True)
    return _OWN
