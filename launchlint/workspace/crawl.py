"""Finding packages below a directory, by the rules of rospkg.rospack.list_by_path, or by those of colcon.

A package is a directory with a ``package.xml`` (its name is what the file says) or a ``manifest.xml`` (its name is the directory's).
A package is a leaf: nothing below it is looked at, nor below a metapackage. ``CATKIN_IGNORE`` and ``rospack_nosubdirs`` end the walk, so
do hidden directories and, as in Debian's rospkg, whatever lies deeper than one level below ``/usr/share``. Symbolic links are followed.

For colcon a package is a directory with a ``package.xml``, a metapackage like any other; ``COLCON_IGNORE`` and ``AMENT_IGNORE`` end the
walk, and ``CATKIN_IGNORE`` and ``rospack_nosubdirs`` mean nothing (colcon-recursive-crawl, colcon-ros).

Different from rospkg on purpose: the walk is sorted, so that the answer does not hang on the file system; a broken ``package.xml`` is
noted where rospkg would stop with a traceback; links that lead back to where one came from are not followed for ever.
"""

from __future__ import annotations

import os

from launchlint.named_tuple import NamedTuple
from launchlint.workspace.manifest import MANIFEST_FILE, PACKAGE_FILE, identify
from launchlint.workspace.reading import read_bytes

CATKIN_IGNORE = "CATKIN_IGNORE"
NO_SUBDIRECTORIES = "rospack_nosubdirs"
SYSTEM_SHARE = "/usr/share/"


class Way(NamedTuple):
    """How packages are found, under a ``name``: ``manifests`` are the files that make a directory one, ``ignoring`` those that hide it and
    what lies below, ``ends`` the others that end the walk. ``metapackages`` are packages, too, where that is true.
    """

    name: str
    manifests: tuple[str, ...]
    ignoring: tuple[str, ...]
    ends: tuple[str, ...]
    metapackages: bool


ROSPACK = Way("rospack", (PACKAGE_FILE, MANIFEST_FILE), (CATKIN_IGNORE,), (NO_SUBDIRECTORIES,), False)
COLCON = Way("colcon", (PACKAGE_FILE,), ("COLCON_IGNORE", "AMENT_IGNORE"), (), True)

# How often one directory is entered through different symbolic links before further ones are left alone: links among a few
# directories can otherwise spell a number of paths that is exponential in the number of directories.
_MOST_ENTRANCES = 16
_MOST_DIRECTORIES = 100_000


TYPE_CHECKING = False
if TYPE_CHECKING:
    from launchlint.workspace.contents import Contents


class Crawled(NamedTuple):
    """One directory with a manifest. ``reason`` is empty, or says why the manifest is broken."""

    name: str
    directory: str
    manifest_path: str
    metapackage: bool
    reason: str


def crawl(root: str, way: Way = ROSPACK) -> list[Crawled]:
    """All packages, metapackages and broken packages below ``root`` (any path), sorted by directory as a depth-first walk meets them.

    What cannot be read is passed over. Never raises.
    """
    return crawl_all(root, way)[0]


def crawl_all(
    root: str, way: Way = ROSPACK, *, through_ignored: bool = False, held: Contents | None = None
) -> tuple[list[Crawled], list[str]]:
    """As :func:`crawl`, and the files (``CATKIN_IGNORE`` …) that keep it out of directories; ``through_ignored`` goes into those, too.

    ``held`` may know what the manifests hold.
    """
    found: list[Crawled] = []
    ignored: list[str] = []
    others = (*way.ends, *(() if through_ignored else way.ignoring))
    ends = frozenset((*way.manifests, *others))
    pending = [os.path.abspath(root)]  # depth first, the next directory last
    entrances: dict[tuple[int, int], int] = {}
    visited = 0
    while pending and visited < _MOST_DIRECTORIES:
        visited += 1
        directory = pending.pop()
        markers: set[str] = set()
        below: list[str] = []
        links: set[str] = set()
        try:
            if directory.startswith(SYSTEM_SHARE):  # nothing deeper counts there, and its directories may hold thousands of files
                markers.update(name for name in way.manifests if os.path.isfile(f"{directory}/{name}"))
                if markers:
                    markers.update(name for name in others if os.path.isfile(f"{directory}/{name}"))
                    _note_packages(directory, markers, way, found, held)
                continue
            with os.scandir(directory) as scan:
                for entry in scan:
                    name = entry.name
                    if name in ends and not _is_directory(entry):
                        markers.add(name)
                    elif name[0] != "." and _is_directory(entry):
                        below.append(name)
                        if entry.is_symlink():
                            links.add(name)
        except OSError:
            continue
        if markers:
            marker = next((each for each in way.ignoring if each in markers), None)
            if marker is not None:
                ignored.append(os.path.join(directory, marker))
            else:
                _note_packages(directory, markers, way, found, held)
            continue
        below.sort(reverse=True)
        start = directory if directory.endswith("/") else directory + "/"
        pending += [start + name for name in below if name not in links or _may_enter(directory, start + name, entrances)]
    return found, ignored


def _note_packages(directory: str, markers: set[str], way: Way, found: list[Crawled], held: Contents | None) -> None:
    """Append what the manifests among ``markers`` of ``directory`` describe."""
    if not markers.isdisjoint(way.ignoring):
        return
    if PACKAGE_FILE in markers:
        found.append(examine(directory, PACKAGE_FILE, held))
    if MANIFEST_FILE in markers and (PACKAGE_FILE not in markers or found[-1].metapackage):
        found.append(examine(directory, MANIFEST_FILE, held))


def examine(directory: str, file: str, held: Contents | None = None) -> Crawled:
    """The package that the manifest ``file`` (``package.xml`` or ``manifest.xml``) in ``directory`` describes. Never raises."""
    path = os.path.join(directory, file)
    if file == MANIFEST_FILE:
        return Crawled(os.path.basename(directory), directory, path, False, "")
    try:
        if held is None:
            identity = identify(read_bytes(path))
        else:
            from launchlint.workspace.known_manifest import known_identity

            identity = known_identity(path, held)
    except OSError as error:
        return Crawled("", directory, path, False, f"it cannot be read: {error.strerror or error}")
    return Crawled(identity.name, directory, path, identity.metapackage, identity.reason)


def hides(root: str, directory: str, way: Way) -> bool:
    """Whether a crawl of ``root`` meets a file that hides things in or above ``directory``; what lies beside the way is not looked at."""
    at = root.rstrip("/")
    if not f"{directory}/".startswith(f"{at}/"):
        return False
    for part in ("", *directory[len(at) :].strip("/").split("/")):
        at = f"{at}/{part}" if part else at
        if any(os.path.isfile(f"{at}/{name}") for name in way.ignoring):
            return True
        if any(os.path.isfile(f"{at}/{name}") for name in (*way.manifests, *way.ends)):
            return False
    return False


def _is_directory(entry: os.DirEntry[str]) -> bool:
    try:
        return entry.is_dir()
    except OSError:
        return False


def _may_enter(directory: str, link: str, entrances: dict[tuple[int, int], int]) -> bool:
    """Whether the symbolic link ``link`` in ``directory`` leads somewhere new; counts the entrance."""
    try:
        status = os.stat(link)
    except OSError:
        return False
    target = (status.st_dev, status.st_ino)
    if entrances.get(target, 0) >= _MOST_ENTRANCES:
        return False
    above = directory
    while True:
        try:
            status = os.stat(above)
        except OSError:
            return False
        if (status.st_dev, status.st_ino) == target:
            return False
        parent = os.path.dirname(above)
        if parent == above:
            break
        above = parent
    entrances[target] = entrances.get(target, 0) + 1
    return True
