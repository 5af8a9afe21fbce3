"""Launch files of packages that only rosbuild would build, beside the catkin packages of which they name files that are gone.

The others went on with catkin, and these were left behind: catkin builds nothing with a ``manifest.xml``, and rosbuild needs a workspace of
its own (https://wiki.ros.org/catkin/Tutorials/using_rosbuild_with_catkin).
"""

from __future__ import annotations

import posixpath
from collections.abc import Iterable, Iterator

from launchlint.check.known import Known
from launchlint.finding import Finding, Severity
from launchlint.rules.judging.of_rosbuild import is_of_rosbuild, packages_named_in
from launchlint.workspace.looking import content

NOTE = "{} has a manifest.xml and is built with rosbuild only, and {}, of which it names the file, with catkin: it seems to be left behind"
_NAMED = frozenset(("LL401", "LL502"))
_ROSBUILD = b"rosbuild"


def judged_by_build(findings: Iterable[Finding], known: Known) -> Iterator[Finding]:
    """``findings``, those as information that only such packages lead to, about files of packages that catkin builds."""
    left: dict[str, str] = {}
    for finding in findings:
        if finding.severity > Severity.INFO and finding.rule in _NAMED and (name := _left_behind(finding.location.path, known, left)):
            paths = known.reached.get(finding.key, frozenset())
            other = _of_catkin(finding, known) if all(_left_behind(path, known, left) for path in paths) else ""
            if other:
                note, cause = NOTE.format(name, other), finding.cause and f"{finding.cause}; left behind"
                finding = finding._replace(severity=Severity.INFO, notes=(*finding.notes, note), cause=cause)
        yield finding


def _left_behind(path: str, known: Known, left: dict[str, str]) -> str:
    """The name of the package of ``path`` that rosbuild alone would build; empty where it is none. ``left`` keeps them by directory."""
    file = known.file(path)
    directory = posixpath.dirname(file)
    if directory not in left:
        home = known.packages.package_of(file)
        of_rosbuild = home is not None and is_of_rosbuild(home)
        commands = content(posixpath.join(home.directory, "CMakeLists.txt")) if home is not None and of_rosbuild else None
        left[directory] = home.name if home is not None and commands is not None and _ROSBUILD in commands else ""
    return left[directory]


def _of_catkin(finding: Finding, known: Known) -> str:
    """The only package that the place of ``finding`` names, where it is here and has a ``package.xml``; else empty."""
    names = packages_named_in(finding.location.marked)
    if len(names) != 1:
        return ""
    (name,) = names
    copies = known.packages.copies(name)
    return name if copies and not any(map(is_of_rosbuild, copies)) else ""
