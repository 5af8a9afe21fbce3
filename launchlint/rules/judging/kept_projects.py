"""Other people's projects that are kept as a whole in a workspace, by what a directory holds that only the root of a repository has."""

from __future__ import annotations

import posixpath
from bisect import bisect_left
from functools import partial

from launchlint.late import late
from launchlint.rules.judging.projects import (
    SOME,
    everybody,
    has_licence,
    has_readme,
    is_in,
    is_left_as_made,
    is_public,
    mostly_others,
    of_template,
    was_released,
)
from launchlint.workspace.looking import Looked, names, note, question, watched
from launchlint.workspace.package import Package
from launchlint.workspace.packages import Packages
from launchlint.workspace.source_lists import GITMODULES
from launchlint.workspace.surveys import list_naming

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Mapping

    from launchlint.workspace.manifest import Manifest

_OF_ROOTS = frozenset(
    (
        ".appveyor.yml",
        ".circleci",
        ".github",
        ".gitlab-ci.yml",
        ".gitmodules",
        ".travis.yml",
        "appveyor.yml",
        "bitbucket-pipelines.yml",
    )
)
"""What git, or who builds and tests, reads at the root of a repository only."""
_WIKI = late(r"https?://(?:www\.|wiki\.)?ros\.org(?:/wiki)?/[^\s<]")
_FIRST_AND_BEHIND_LAST = ("/", "0")
"""What the names of all that lies below a directory go on with, and the sign behind that."""
_DOWNLOADED = late(
    r".+-(?:master|main|develop|(?:[a-z]+-)?devel|fuerte|groovy|hydro|indigo|jade|kinetic|lunar|melodic|noetic|v?\d+(?:\.\d+)+)"
)
"""What the archive of a repository is unpacked to: its name with that of the branch or the release."""


def kept_whole(home: Package, packages: Packages) -> str:
    """The directory (absolute) in which somebody else's project, with ``home`` in it, is kept in this workspace; else empty.

    Such a directory has what a repository has at its root only, or is called as what the archive of one is unpacked to; or it holds a
    README, and with it a licence of its own, or packages most of which have a page in the wiki of ROS, or one that is called as the
    directory is, by people who fill in what others here leave as ``catkin_create_pkg`` wrote it. And at most a few packages outside
    of it, which came with it, have its people. So is a directory that was checked in although a list of sources (``*.repos``,
    ``*.rosinstall``) says which repository to put there: then no package outside of such directories has its people.
    """
    return "" if home.manifest is None else packages.answer(_answers_around, home.directory)


@question
def _answers_around(packages: Packages, directory: str) -> str:
    return packages.once(_Projects).around(directory)


def kept_without_package(directory: str, packages: Packages) -> str:
    """The directory (absolute) around ``directory``, which lies in no package, that is the root of a project; else empty.

    Such a directory has a licence and a README of its own, and several packages of the workspace lie outside of it.
    """
    return packages.answer(_answers_bare, directory)


@question
def _answers_bare(packages: Packages, directory: str) -> str:
    return packages.once(_Projects).bare_around(directory)


class _Below:
    """Packages by their directories: which there are below another directory is found without going through all of them."""

    def __init__(self, manifests: Mapping[str, Manifest]) -> None:
        self._directories = sorted(f"{each}/" for each in manifests)
        self._manifests = [manifests[each[:-1]] for each in self._directories]

    def of(self, directory: str) -> dict[str, Manifest]:
        """Those in ``directory`` and below."""
        first, last = (bisect_left(self._directories, f"{directory}{end}") for end in _FIRST_AND_BEHIND_LAST)
        return {self._directories[at][:-1]: self._manifests[at] for at in range(first, last)}


class _Projects:
    """The projects that are kept in the workspaces, by their directories."""

    def __init__(self, packages: Packages) -> None:
        self._roots = [each.rstrip("/") for each in packages.workspaces]
        everything = [each for place in packages.places[: len(self._roots)] for each in place.everything]
        self._manifests = {each.directory: each.manifest for each in everything if each.manifest is not None}
        self._below = _Below(self._manifests)
        self._found: dict[str, tuple[bool, Looked]] = {}
        self._signs: dict[str, tuple[bool, Looked]] = {}
        self._packages = packages

    def around(self, home: str) -> str:
        """The nearest one that the package in the directory ``home`` lies in; empty: in none."""
        directory = home
        while any(directory.startswith(f"{root}/") for root in self._roots):
            if directory not in self._found:
                self._found[directory] = watched(partial(self._is_project, directory))
            found, looked = self._found[directory]
            note(looked)
            if found:
                return directory
            directory = posixpath.dirname(directory)
        return ""

    def bare_around(self, home: str) -> str:
        """The nearest one around the directory ``home`` in which no package lies; empty: there is none."""
        directory = home
        while any(directory.startswith(f"{root}/") for root in self._roots):
            if self._below.of(directory):
                return ""
            listed = names(directory)
            shown = has_readme(listed) and has_licence(listed)
            if shown and len(self._outside(directory)) >= SOME:
                return directory
            directory = posixpath.dirname(directory)
        return ""

    def _is_project(self, directory: str) -> bool:
        """Whether a project of other people is kept in ``directory``."""
        within = self._below.of(directory)
        people = everybody(within.values())
        if not people:
            return False
        if self._is_listed(directory):
            outside = self._outside(directory)
            return people.isdisjoint(everybody(manifest for each, manifest in outside.items() if not self._lies_in_listed(each)))
        if self._is_root(directory):
            return self._are_others(directory, people)
        if directory in within or not has_readme(names(directory)):
            return False  # one package with a README is most people's own
        if len(within) > 1 and 2 * sum(map(_is_in_wiki, within.values())) > len(within):
            return self._are_others(directory, people)
        named = any(each.name == posixpath.basename(directory) for each in within.values())
        return named and self._left_as_made(directory) >= SOME and not of_template(people) and self._are_others(directory, people)

    def _are_others(self, directory: str, people: frozenset[str]) -> bool:
        """Whether most packages outside of ``directory`` have nothing to do with ``people``: of all, or of those in no other project."""
        outside = self._outside(directory)
        if mostly_others(outside.values(), people):
            return True
        return mostly_others([manifest for each, manifest in outside.items() if not self._is_in_other(each, directory)], people)

    def _lies_in_listed(self, directory: str) -> bool:
        """Whether the package lies in a directory of :meth:`_is_listed`."""
        while any(directory.startswith(f"{root}/") for root in self._roots):
            if self._is_listed(directory):
                return True
            directory = posixpath.dirname(directory)
        return False

    def _is_listed(self, directory: str) -> bool:
        """Whether a list outside of ``directory`` names the repository whose files are checked in there; a clone holds ``.git``."""
        file = self._packages.answer(list_naming, posixpath.basename(directory))
        if not file or is_in(file, directory) or posixpath.basename(file) == GITMODULES:
            return False
        return ".git" not in names(directory)

    def _left_as_made(self, directory: str) -> int:
        """How many packages outside of ``directory`` have nobody's name but what the template has."""
        return sum(is_left_as_made(manifest.people) for manifest in self._outside(directory).values())

    def _outside(self, directory: str) -> dict[str, Manifest]:
        """The packages outside of ``directory`` in the same workspace: of others that are overlaid nobody says that they are one's own."""
        root = next(each for each in self._roots if is_in(directory, each))
        within = self._below.of(directory)
        return {each: manifest for each, manifest in self._below.of(root).items() if each not in within}

    def _is_in_other(self, package: str, directory: str) -> bool:
        """Whether a directory around the package, and not around ``directory``, looks like the root of a repository."""
        while any(package.startswith(f"{root}/") for root in self._roots) and not is_in(directory, package):
            if self._is_root(package):
                return True
            package = posixpath.dirname(package)
        return False

    def _is_root(self, directory: str) -> bool:
        """Whether it looks like the root of a repository, or what its archive was unpacked to; never a mere package with a licence."""
        if directory not in self._signs:
            self._signs[directory] = watched(partial(self._shows_root, directory))
        shown, looked = self._signs[directory]
        note(looked)
        return shown

    def _shows_root(self, directory: str) -> bool:
        listed = names(directory)
        if _DOWNLOADED.fullmatch(posixpath.basename(directory)) is not None:
            return has_readme(listed) or len(self._below.of(directory)) > 1
        if not _OF_ROOTS.isdisjoint(listed):
            return True
        licensed = has_licence(listed)
        manifest = self._manifests.get(directory)
        if not licensed or (manifest is not None and not is_public(manifest.name)):
            return False
        return has_readme(listed) or (manifest is None and self._holds_released(directory))

    def _holds_released(self, directory: str) -> bool:
        """Whether a package right in ``directory`` was released: nobody makes a list of changes for a mere copy."""
        inside = ((each, manifest) for each, manifest in self._below.of(directory).items() if posixpath.dirname(each) == directory)
        return any(was_released(each, manifest.name) for each, manifest in inside)


def _is_in_wiki(manifest: Manifest) -> bool:
    """Whether a page in the wiki of ROS is named; a template proposes one in a comment."""
    return any(_WIKI.match(address) is not None for _, address in manifest.urls)
