"""Whose a package is: one of the people of this workspace, or one of somebody else, of which a copy is kept here.

Nothing says so plainly, so that several things have to come together: what stands in the ``package.xml`` (REP 127, REP 140: maintainers,
authors, addresses), what a directory holds that only the root of a repository has, and the list of public packages.
"""

from __future__ import annotations

import posixpath
from collections import Counter
from collections.abc import Iterable, Sequence
from functools import cached_property, partial

from launchlint.late import late
from launchlint.library.shipped import is_in_library
from launchlint.workspace.copied_packages import are_copied, is_copied
from launchlint.workspace.looking import Looked, is_file, names, note, question, watched
from launchlint.workspace.package import Package
from launchlint.workspace.packages import Packages
from launchlint.workspace.public_packages import public_names

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Mapping

    from launchlint.workspace.manifest import Manifest

CHANGES = "CHANGELOG.rst"
"""What releases are made from (REP 132)."""
_MUCH_MORE = 4
SOME = 3
_README = "readme"
_LICENCES = frozenset(("license", "licence", "copying", "unlicense"))
_TEMPLATE = "@todo.todo"
"""The end of the address that ``catkin_create_pkg`` writes for who called it."""
_EXPORTED = "todo@"
"""The beginning of the address that the exporter of SolidWorks writes, with a licence."""
_REPOSITORY = late(r"https?://([^\s/<]+/[^\s/<]+)/[^\s<]")
"""Host and owner of the repository that a manifest names (REP 140); nobody has to name one, and ``catkin_create_pkg`` proposes none."""
_NO_LICENCE = "TODO"
"""How what ``catkin_create_pkg`` and ``ros2 pkg create`` (``TODO: License declaration``) write for a licence begins."""
_OF_ASSISTANT = frozenset(("github.com/moveit", "github.com/ros-planning"))
"""What MoveIt's Setup Assistant writes for the origin of all that it makes."""
_ASSISTED = ".setup_assistant"
"""Beside it, the licence is what MoveIt's Setup Assistant always writes."""
_SHORTEST_NAME = 3
_WORD = late(r"[a-z]{3,}")
_PAGE = late(r"https?://(?:www\.|wiki\.)?ros\.org(?:/wiki)?/([A-Za-z]\w*)/?")
_OF_CHAMP = late(r"<description>[^<>]{0,200}\bChamp Config Package\s{0,200}</description>")


def is_copy(home: Package, packages: Packages) -> bool:
    """Whether ``home`` is a public package in a workspace of others that was released, whence its list of changes."""
    return is_released(home) and packages.answer(_answers_of_others, home.manifest_path)


@question
def _answers_of_others(packages: Packages, manifest_path: str) -> bool:
    home = packages.with_manifest(manifest_path)
    return home is not None and _is_of_others(home, packages)


def is_beside_own(home: Package, packages: Packages) -> bool:
    """Whether ``home`` says whose it is, beside packages of others that are left as ``catkin_create_pkg`` made them, be it but one.

    It is called as a public package or names its repository, and has a list of changes or people who have nothing to do with those others.
    """
    return packages.answer(_answers_beside_own, home.manifest_path)


@question
def _answers_beside_own(packages: Packages, manifest_path: str) -> bool:
    home = packages.with_manifest(manifest_path)
    manifest = None if home is None else home.manifest
    if (
        home is None
        or manifest is None
        or not manifest.people
        or not _is_filled_in(manifest)
        or not (is_public(home.name) or _origins(manifest) - _OF_ASSISTANT)
    ):
        return False
    workspace = packages.once(_Workspaces).around(home.directory)
    words = workspace.words_left_as_made
    if not words or not workspace.are_few(manifest) or _is_of_tool(home):
        return False
    return is_released(home) or words.isdisjoint((*_words(manifest), *_words_of_addresses(manifest)))


def left_as_made(home: Package, packages: Packages) -> frozenset[str]:
    """The packages around ``home`` that are as ``catkin_create_pkg`` made them: people made them here."""
    return packages.answer(_answers_left_as_made, home.directory) - {home.name}


@question
def _answers_left_as_made(packages: Packages, directory: str) -> frozenset[str]:
    return packages.once(_Workspaces).around(directory).left


def is_renamed(home: Package, packages: Packages) -> str:
    """The public package that ``home`` is a copy of under another name, as its address in the wiki of ROS says; else empty.

    It is none where that package is here, too, or is a metapackage, which this may belong to; where this one needs that one, or one whose
    name begins like it (it is made to go with that); and where most packages around it are of its people.
    """
    return packages.answer(_answers_renamed, home.manifest_path)


@question
def _answers_renamed(packages: Packages, manifest_path: str) -> str:
    home = packages.with_manifest(manifest_path)
    manifest = None if home is None else home.manifest
    if home is None or manifest is None or is_public(home.name):
        return ""
    named = (match[1] for _, address in manifest.urls if (match := _PAGE.fullmatch(address)) is not None)
    found = next((each for each in named if is_public(each.lower()) and _is_part(each, home.name) and not packages.has(each)), "")
    if not found or any(f"{each}_".startswith(f"{found.lower()}_") for each in manifest.depends()):
        return ""
    return found if packages.once(_Workspaces).around(home.directory).are_not_most(manifest) else ""


def is_published(home: Package) -> bool:
    """Whether ``home`` is called as a released package, and is not as ``catkin_create_pkg`` made it: `control` and `navigation` may be."""
    return home.name in public_names() and not (home.manifest is not None and is_left_as_made(home.manifest.people))


def is_generated(home: Package) -> bool:
    """Whether the setup assistant of CHAMP wrote the package, which says so."""
    return home.manifest is not None and _OF_CHAMP.search(home.manifest.source.text) is not None


def is_released(home: Package) -> bool:
    """Whether ``home`` is called as a public package, and has a list of changes as a released one has."""
    return was_released(home.directory, home.name)


def is_from_elsewhere(home: Package, packages: Packages) -> bool:
    """Whether ``home`` is a public package in a workspace of others that says whose it is; it may be changed here.

    That is: which repository it is from; or which people's, where several others have what ``catkin_create_pkg`` writes.
    """
    return packages.answer(_answers_from_elsewhere, home.manifest_path)


@question
def _answers_from_elsewhere(packages: Packages, manifest_path: str) -> bool:
    home = packages.with_manifest(manifest_path)
    manifest = None if home is None else home.manifest
    if home is None or manifest is None or not _is_licensed(manifest) or not _is_of_others(home, packages):
        return False
    workspace = packages.once(_Workspaces).around(home.directory)
    return bool(_origins(manifest)) or (not of_template(manifest.people) and workspace.left_as_made >= SOME)


def is_well_known(home: Package, packages: Packages) -> bool:
    """Whether ``home`` is one of the packages that people copy, in a workspace of others: of these, too, there are packages."""
    manifest = home.manifest
    if manifest is None or not is_copied(manifest.name, manifest.people):
        return False
    return packages.answer(_answers_has_own, home.directory)


def is_of_copied_people(home: Package, packages: Packages) -> bool:
    """Whether ``home`` is of people of whom several packages are known that others copy, in a workspace of others: it was renamed.

    Most packages around it are none of theirs, and of those people, too, who make their own here, there are packages.
    """
    return packages.answer(_answers_of_copied_people, home.manifest_path)


@question
def _answers_of_copied_people(packages: Packages, manifest_path: str) -> bool:
    home = packages.with_manifest(manifest_path)
    return home is not None and home.manifest is not None and packages.once(_Workspaces).around(home.directory).has_copied(home.manifest)


@question
def _answers_has_own(packages: Packages, directory: str) -> bool:
    return packages.once(_Workspaces).around(directory).has_own


def is_signed(home: Package, packages: Packages) -> bool:
    """Whether ``home`` has a licence and people who have nothing to do with the several packages here that have no licence.

    Whoever leaves ``TODO`` for the licence of each package that they make here has got this one from somebody who did not. Where those
    without are of different people, one of these may have filled it in: then it has to have a README as well.
    """
    return packages.answer(_answers_signed, home.manifest_path)


@question
def _answers_signed(packages: Packages, manifest_path: str) -> bool:
    home = packages.with_manifest(manifest_path)
    return home is not None and packages.once(_Signed).from_elsewhere(home)


def is_of_team(home: Package, packages: Packages) -> bool:
    """Whether the people of ``home``, with all with whom they made a package here, made more packages than are without a licence."""
    return packages.answer(_answers_of_team, home.manifest_path)


@question
def _answers_of_team(packages: Packages, manifest_path: str) -> bool:
    home = packages.with_manifest(manifest_path)
    return home is not None and packages.once(_Signed).is_of_team(home)


class _Signed:
    """The packages that have a licence and people, and those that have none."""

    def __init__(self, packages: Packages) -> None:
        self._found: dict[str, tuple[bool, Looked]] = {}
        self._workspaces: list[tuple[str, _Licences]] = []
        for root, place in zip(packages.workspaces, packages.places, strict=False):
            manifests = {each.directory: each.manifest for each in place.everything if each.manifest is not None}
            self._workspaces.append((root.rstrip("/"), _Licences(manifests)))

    def from_elsewhere(self, home: Package) -> bool:
        """As :func:`is_signed`."""
        if home.directory not in self._found:
            self._found[home.directory] = watched(partial(self._is_from_elsewhere, home))
        found, looked = self._found[home.directory]
        note(looked)
        return found

    def is_of_team(self, home: Package) -> bool:
        """As :func:`is_of_team`."""
        manifest = home.manifest
        around = (licences for root, licences in self._workspaces if is_in(home.directory, root))
        return manifest is not None and any(licences.has_fewer_than(manifest.people) for licences in around)

    def _is_from_elsewhere(self, home: Package) -> bool:
        manifest = home.manifest
        if manifest is None or not _is_licensed(manifest) or not manifest.people or of_template(manifest.people):
            return False
        if _is_of_tool(home):
            return False
        listed = names(home.directory)
        around = [licences for root, licences in self._workspaces if is_in(home.directory, root)]
        return any((licences.of_one or has_readme(listed)) and licences.has_others(manifest) for licences in around)


class _Licences:
    """Which packages of one workspace have no licence, and whose they are; ``of_one``: all are the same people's."""

    def __init__(self, manifests: Mapping[str, Manifest]) -> None:
        bare = {each: manifest for each, manifest in manifests.items() if not _is_licensed(manifest)}
        self._bare = len(bare)
        self.of_one = len({manifest.people for manifest in bare.values()}) == 1
        self._words = frozenset[str]().union(*map(_words, bare.values()))
        self._people = Counter(person for manifest in manifests.values() for person in manifest.people)
        self._bare_people = everybody(bare.values())
        self._all = [manifest.people for manifest in manifests.values()]
        self._fewer: dict[frozenset[str], bool] = {}

    def has_fewer_than(self, people: frozenset[str]) -> bool:
        """Whether fewer packages are without a licence than are of ``people`` or of those with whom any of them made one."""
        if people not in self._fewer:
            team = people.union(*(each for each in self._all if not people.isdisjoint(each)))
            self._fewer[people] = self._bare < sum(not team.isdisjoint(each) for each in self._all)
        return self._fewer[people]

    def has_others(self, manifest: Manifest) -> bool:
        """Whether several packages, and more than its people have, are without a licence, and none of them is theirs."""
        if not manifest.people.isdisjoint(self._bare_people) or not _words(manifest).isdisjoint(self._words):
            return False  # james@todo.todo may well be James
        theirs = max(self._people[person] for person in manifest.people)
        return self._bare >= max(SOME, theirs)


def _is_licensed(manifest: Manifest) -> bool:
    return any(each and not each.startswith(_NO_LICENCE) for each in manifest.licences)


def _words(manifest: Manifest) -> frozenset[str]:
    """The names of the people, word by word, and what stands before the ``@`` in their addresses."""
    words = [*" ".join(manifest.signatures).lower().split(), *(each.partition("@")[0] for each in manifest.people)]
    return frozenset(each for each in words if len(each) >= _SHORTEST_NAME)


def _words_of_addresses(manifest: Manifest) -> frozenset[str]:
    """Their parts: ``ada``, ``lovelace`` and ``analytical`` of ``ada.lovelace@analytical-engines.org``."""
    return frozenset(word for each in manifest.people for word in _WORD.findall(each))


class _Workspaces:
    """Whose the packages of each workspace are."""

    def __init__(self, packages: Packages) -> None:
        self._roots = [
            (root.rstrip("/"), _Workspace(place.everything)) for root, place in zip(packages.workspaces, packages.places, strict=False)
        ]
        self._none = _Workspace(())

    def around(self, directory: str) -> _Workspace:
        """The first one that ``directory`` lies in: of others that are overlaid nobody says that they are one's own."""
        return next((each for root, each in self._roots if is_in(directory, root)), self._none)


class _Workspace:
    """Whose the packages of one workspace are. ``left_as_made``: how many have nobody's name but what the template has.

    ``words_left_as_made``: the words in the names of the people of those without a licence.
    ``has_own``: at least one is of people of whom no package is here that is known to be copied; where most packages are, as in a public
    project itself, several are, of people who say who they are: what is not in the list of such a project is left as a template made it.
    """

    def __init__(self, everything: Sequence[Package]) -> None:
        self._count = len(everything)
        self._in: Counter[str] = Counter(posixpath.dirname(each.directory) for each in everything)
        self._known = [(each.directory, each.name, each.manifest) for each in everything if each.manifest is not None]
        self._known_in: Counter[str] = Counter(posixpath.dirname(directory) for directory, _, _ in self._known)
        self._of_people: dict[str, set[int]] = {}
        self._from_origins: dict[str, set[int]] = {}
        self._public: Counter[str] = Counter()
        for number, (_, name, manifest) in enumerate(self._known):
            if is_public(name):
                self._public[name] += 1
            for person in manifest.people:
                self._of_people.setdefault(person, set()).add(number)
            for origin in _origins(manifest):
                self._from_origins.setdefault(origin, set()).add(number)
        self.left_as_made = sum(is_left_as_made(manifest.people) for _, _, manifest in self._known)
        bare = [each for _, _, each in self._known if is_left_as_made(each.people) and not _is_licensed(each)]
        self.words_left_as_made = frozenset[str]().union(*map(_words, bare))
        self._bare = bare
        self._copied_people: dict[frozenset[str], bool] = {}
        copied = [manifest for _, _, manifest in self._known if is_copied(manifest.name, manifest.people)]
        theirs = everybody(copied)
        own = [manifest.people for _, _, manifest in self._known if manifest.people and manifest.people.isdisjoint(theirs)]
        few = 2 * len(copied) <= len(self._known)  # in a public project itself nearly all are in the list
        self.has_own = bool(copied and own) and (few or sum(map(_say_who_they_are, own)) >= SOME)

    @cached_property
    def left(self) -> frozenset[str]:
        """The names of the packages that are left as the template made them, but for those of people whose packages others copy."""
        return frozenset(each.name for each in self._bare if not is_copied(each.name, each.people) and not self.has_copied(each))

    def has_copied(self, manifest: Manifest) -> bool:
        """Whether the people of ``manifest`` are known for packages that others copy, and have made few of those here."""
        people = manifest.people
        if people not in self._copied_people:
            self._copied_people[people] = (
                self.has_own and mostly_others((each for _, _, each in self._known), people) and are_copied(people)
            )
        return self._copied_people[people]

    def are_few(self, manifest: Manifest) -> bool:
        """Whether no more packages have the people or the repository of ``manifest`` than have not."""
        alike = _united(self._of_people, manifest.people) | _united(self._from_origins, _origins(manifest))
        return 2 * len(alike) <= len(self._known)

    def are_not_most(self, manifest: Manifest) -> bool:
        """Whether the people of ``manifest`` have not made most packages, of several."""
        alike = _united(self._of_people, manifest.people)
        return len(self._known) < SOME or 2 * len(alike) <= len(self._known)

    def is_of_others_than(self, home: Package, manifest: Manifest) -> bool:
        """Whether most packages, as they are told apart by :func:`_is_of_others`, are of others than those of ``home``, a public one."""
        beside = posixpath.dirname(home.directory)
        of_people = _united(self._of_people, manifest.people)
        theirs_beside = sum(posixpath.dirname(self._known[each][0]) == beside for each in of_people)
        came_along = self._in[beside] < self._count and theirs_beside == self._known_in[beside]
        alike = of_people | _united(self._from_origins, _origins(manifest))
        related = [self._known[each][0] for each in alike if not is_public(self._known[each][1])]
        theirs = sum(not (came_along and posixpath.dirname(each) == beside) for each in related)
        public = self._public.total() - self._public[home.name]
        own = len(self._known) - self._public.total() - len(related)
        return own >= _MUCH_MORE * theirs if own > public else own >= SOME and not theirs


def _united(index: Mapping[str, set[int]], keys: Iterable[str]) -> set[int]:
    return set().union(*(index.get(each, ()) for each in keys))


def is_public(name: str) -> bool:
    """Whether somebody published a package of this name: it is in the public index, or the library that launchlint ships knows it."""
    return name in public_names() or is_in_library(name)


def was_released(directory: str, name: str) -> bool:
    """Whether the package ``name`` in ``directory`` is called as a public one, and has a list of changes."""
    return is_public(name) and is_file(posixpath.join(directory, CHANGES))


def _is_of_others(home: Package, packages: Packages) -> bool:
    """Whether ``home`` is named as a public package, and most packages are of others.

    That is: they are not public, and at most a few, which came with it, have its people or are from its owner; or several are not public,
    and none of these is theirs but those beside it.
    """
    if home.manifest is None or not is_public(home.name):
        return False
    return bool(home.manifest.people) and packages.once(_Workspaces).around(home.directory).is_of_others_than(home, home.manifest)


def mostly_others(manifests: Iterable[Manifest], people: frozenset[str]) -> bool:
    """Whether several of the packages, and most of them, are not of ``people``."""
    known = [each.people for each in manifests]
    theirs = sum(not people.isdisjoint(each) for each in known)
    return len(known) - theirs >= max(SOME, _MUCH_MORE * theirs)


def everybody(manifests: Iterable[Manifest]) -> frozenset[str]:
    """The people of all of them."""
    return frozenset().union(*(each.people for each in manifests))


def is_left_as_made(people: frozenset[str]) -> bool:
    """Whether the people of a package are those that ``catkin_create_pkg`` wrote."""
    return bool(people) and of_template(people) == people


def of_template(people: frozenset[str]) -> frozenset[str]:
    """Those among ``people`` that ``catkin_create_pkg`` wrote."""
    return frozenset(each for each in people if each.endswith(_TEMPLATE))


def _say_who_they_are(people: frozenset[str]) -> bool:
    """Whether those who made a package have said who they are: neither a template nor an exporter has written an address."""
    return not of_template(people) and not any(each.startswith(_EXPORTED) for each in people)


def _is_filled_in(manifest: Manifest) -> bool:
    """Whether somebody has said what the licence is, and who they are."""
    return _is_licensed(manifest) and not of_template(manifest.people)


def _is_of_tool(home: Package) -> bool:
    """Whether the exporter of SolidWorks or MoveIt's Setup Assistant wrote the manifest, licence, addresses and all."""
    people = frozenset[str]() if home.manifest is None else home.manifest.people
    return any(each.startswith(_EXPORTED) for each in people) or _ASSISTED in names(home.directory)


def _is_part(page: str, name: str) -> bool:
    """Whether the words of ``page`` stand in ``name``, which has one more in front or behind: ``lms1xx_robot`` of ``LMS1xx``."""
    return page.lower() != name.lower() and f"_{page.lower()}_" in f"_{name.lower()}_"


def is_in(package: str, directory: str) -> bool:
    """Whether a package lies in ``directory`` or below it."""
    return f"{package}/".startswith(f"{directory}/")


def has_licence(listed: Iterable[str]) -> bool:
    """Whether there is a licence among the names of a directory."""
    return not _LICENCES.isdisjoint(each.partition(".")[0].lower() for each in listed)


def has_readme(listed: Iterable[str]) -> bool:
    """Whether there is a README among the names of a directory."""
    return any(each.partition(".")[0].lower() == _README for each in listed)


def _origins(manifest: Manifest) -> frozenset[str]:
    found = (_REPOSITORY.match(address) for type_, address in manifest.urls if type_ in ("bugtracker", "repository"))
    return frozenset(match[1].lower() for match in found if match is not None)
