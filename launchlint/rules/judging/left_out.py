"""Why a package that a launch file uses may be missing from the ``package.xml`` on purpose, or without harm."""

from __future__ import annotations

import posixpath

from launchlint.late import late
from launchlint.rules.judging.metapackages import members
from launchlint.syntax.tree import Document
from launchlint.workspace.looking import is_file, names, walk
from launchlint.workspace.mentions import install_lines, says_install
from launchlint.workspace.package import Package
from launchlint.workspace.packages import Packages
from launchlint.workspace.public_packages import public_names
from launchlint.workspace.put_aside import put_aside
from launchlint.workspace.registered_tests import TEST_END

TYPE_CHECKING = False
if TYPE_CHECKING:
    from launchlint.workspace.manifest import Manifest

BASE = "ros_base"
CHANGES = "CHANGELOG.rst"
"""What releases are made from (REP 132)."""
SETUP_ASSISTANT = ".setup_assistant"
_MUCH_MORE = 4
_SOME = 3
_LICENCES = frozenset(("license", "licence", "copying", "unlicense"))
_BENCH = late(r"(?:^|[/_.-])(?:tests?|bench\w*|debug|examples?|demos?|play\w*|replay|(?:ros)?bags?)(?:[/_.-]|[A-Z\d]|$)")
_TRIAL = late(r"(?:^|[/_.-])(?:tests?|debug|examples?|demos?|tryout|bench\w*)(?:[/_.-]|[A-Z\d]|$)")
_LAUNCH_ENDS = (".launch", ".launch.xml", TEST_END)
_MOST_DIRECTORIES = 100
_TESTS = late(r"(?:^|/)tests?/")
_REPOSITORY = late(r"https?://([^\s/<]+/[^\s/<]+)/[^\s<]")
"""Host and owner of the repository that a manifest names (REP 140); nobody has to name one, and ``catkin_create_pkg`` proposes none."""
_WIKI = late(r"https?://(?:www\.|wiki\.)?ros\.org(?:/wiki)?/[^\s<]")
_DOWNLOADED = late(
    r".+-(?:master|main|develop|(?:[a-z]+-)?devel|fuerte|groovy|hydro|indigo|jade|kinetic|lunar|melodic|noetic|v?\d+(?:\.\d+)+)"
)
"""What the archive of a repository is unpacked to: its name with that of the branch or the release."""


def why_left_out(name: str, document: Document, home: Package, packages: Packages) -> str:
    """Why it is no matter that ``home`` does not declare ``name`` for this launch file, for people; empty where it is one."""
    path = document.source.path
    if put_aside(path):
        return f"{path}, which uses {name}, seems to have been put aside"
    comments = [line for comment in document.comments for line in install_lines(comment.text)]
    if says_install(name, comments) or says_install(name, packages.documents().installing):
        return f"people are told to install {name} where they need it, so that it seems to be left out on purpose"
    if name in _base():
        if home.name not in public_names():
            return f"{name} is part of {BASE}, the smallest installation, and {home.name} is none of the released packages"
        if _BENCH.search(path) is not None:
            return f"{name} is part of every installation of {BASE}, and it is used to try something out only"
    if is_copy(home, packages) or is_from_elsewhere(home, packages):
        return f"{home.name} is a copy of a public package, and that is where to declare {name}"
    project = kept_whole(home, packages)
    if project:
        return f"{home.name} is part of another project, {project}, which is kept here as a whole: that is where to declare {name}"
    return ""


def is_trial(file: str, home: Package) -> bool:
    """Whether a person starts the launch file of package ``home`` to try something out; machines run tests.

    MoveIt's ``demo.launch`` is what people start, and so is what most launch files of a package are called.
    """
    inside = posixpath.relpath(posixpath.abspath(file), home.directory)
    if not _tries(inside) or _TRIAL.search(home.name) or is_file(posixpath.join(home.directory, SETUP_ASSISTANT)):
        return False
    listed = [
        posixpath.relpath(posixpath.join(directory, name), home.directory)
        for directory, names in walk(home.directory, _MOST_DIRECTORIES)
        for name in names
        if name.endswith(_LAUNCH_ENDS)
    ]
    return 2 * sum(map(_tries, listed)) <= len(listed)


def _tries(inside: str) -> bool:
    return not inside.endswith(TEST_END) and _TESTS.search(inside) is None and _TRIAL.search(inside) is not None


def is_copy(home: Package, packages: Packages) -> bool:
    """Whether ``home`` is a public package in a workspace of others that was released, whence its list of changes."""
    return is_file(posixpath.join(home.directory, CHANGES)) and _is_of_others(home, packages)


def is_from_elsewhere(home: Package, packages: Packages) -> bool:
    """Whether ``home`` is a public package in a workspace of others that says which repository it is from; it may be changed here."""
    return home.manifest is not None and bool(_origins(home.manifest)) and _is_of_others(home, packages)


def _is_of_others(home: Package, packages: Packages) -> bool:
    """Whether ``home`` is named as a public package, and most packages are of others.

    That is: they are not public, and at most a few, which came with it, have its people or are from its owner; or several are not public,
    and none of these is theirs.
    """
    if home.manifest is None or home.name not in public_names():
        return False
    people, origins = home.manifest.people, _origins(home.manifest)
    if not people:
        return False
    own = public = theirs = 0
    for place in packages.places[: len(packages.workspaces)]:
        for each in place.everything:
            if each.manifest is None or each.name == home.name:
                continue
            if each.name in public_names():
                public += 1
            elif people.isdisjoint(each.manifest.people) and origins.isdisjoint(_origins(each.manifest)):
                own += 1
            else:
                theirs += 1
    return own >= _MUCH_MORE * theirs if own > public else own >= _SOME and not theirs


def kept_whole(home: Package, packages: Packages) -> str:
    """The name of the directory in which somebody else's project, with ``home`` in it, is kept in this workspace; else empty.

    Such a directory has a README, and its own licence, or most of its packages a page in the wiki of ROS, or it is called as what the
    archive of a repository is unpacked to; and at most a few packages outside of it, which came with it, have its people.
    """
    if home.manifest is None:
        return ""
    directory = home.directory if _is_unpacked(home.directory) else posixpath.dirname(home.directory)
    roots = [each.rstrip("/") for each in packages.workspaces]
    while any(directory.startswith(f"{root}/") for root in roots):
        listed = {each.partition(".")[0].lower() for each in names(directory)}
        if "readme" in listed and _is_apart(directory, packages, sure=bool(listed & _LICENCES) or _is_unpacked(directory)):
            return posixpath.basename(directory)
        directory = posixpath.dirname(directory)
    return ""


def _is_apart(directory: str, packages: Packages, *, sure: bool) -> bool:
    """Whether the packages in ``directory`` have other people than those of the workspace; most have a page in the wiki if not ``sure``."""
    everything = [each for place in packages.places[: len(packages.workspaces)] for each in place.everything]
    manifests = {each.directory: each.manifest for each in everything if each.manifest is not None}
    within = [manifest for each, manifest in manifests.items() if f"{each}/".startswith(f"{directory}/")]
    if not sure and not (len(within) > 1 and 2 * sum(map(_is_in_wiki, within)) > len(within)):
        return False
    inside = frozenset().union(*(manifest.people for manifest in within))
    outside = [manifest.people for each, manifest in manifests.items() if not f"{each}/".startswith(f"{directory}/")]
    theirs = sum(not inside.isdisjoint(people) for people in outside)
    return bool(inside) and len(outside) - theirs >= max(_SOME, _MUCH_MORE * theirs)


def _is_unpacked(directory: str) -> bool:
    return _DOWNLOADED.fullmatch(posixpath.basename(directory)) is not None


def _is_in_wiki(manifest: Manifest) -> bool:
    """Whether a page in the wiki of ROS is named; a template proposes one in a comment."""
    return any(_WIKI.match(address) is not None for _, address in manifest.urls)


def _origins(manifest: Manifest) -> frozenset[str]:
    found = (_REPOSITORY.match(address) for type_, address in manifest.urls if type_ in ("bugtracker", "repository"))
    return frozenset(match[1].lower() for match in found if match is not None)


def _base() -> frozenset[str]:
    """What ``ros_base`` brings along, over all its metapackages."""
    found: set[str] = set()
    waiting = [BASE]
    while waiting:
        name = waiting.pop()
        if name not in found:
            found.add(name)
            waiting += members(name)
    return frozenset(found)
