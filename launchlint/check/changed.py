"""Which files of a repository differ from those of a revision, as far as that can change what a launch file starts or what it connects."""

from __future__ import annotations

import os
from collections.abc import Iterator

from launchlint.named_tuple import NamedTuple
from launchlint.workspace.listing import SOURCE_ENDS

_LAUNCH = frozenset({".launch", ".test", ".xml", ".py"})
_MANIFESTS = frozenset({"package.xml", "manifest.xml"})
_NO_MATTER = frozenset(
    ".action .c .cc .cmake .cpp .css .cxx .gitignore .h .hh .hpp .html .hxx .ipp .js .json .log .md .msg .py .pyc .rst .rviz .srv .txt"
    " .bag .bmp .dae .gif .jpeg .jpg .obj .pcd .pdf .pgm .ply .png .stl .svg .tif .tiff .world".split()
)
"""Ends of the names of files that no launch file is made of."""


class Changed(NamedTuple):
    """``launch_files`` are those (absolute, links resolved) that are new or not the same; ``others``: whether anything else may matter.

    ``sources``: whether any source of a node is new, gone or not the same.
    """

    launch_files: frozenset[str]
    others: bool
    sources: bool


def changed(repository: str, directory: str) -> Changed:
    """What differs between the working tree at ``repository`` and a revision of it that was unpacked to ``directory``."""
    now, then = (dict(_files(each)) for each in (repository, directory))
    launch_files = set()
    gone = then.keys() - now.keys()
    sources = any(_is_source(path) for path in gone)
    others = not all(_is_source(path) for path in gone)
    for path, file in now.items():
        before = then.get(path)
        if before is not None and _same(file, before):
            continue
        if os.path.splitext(path)[1].lower() in _LAUNCH and os.path.basename(path) not in _MANIFESTS and not os.path.islink(file):
            launch_files.add(os.path.realpath(file))
            sources = sources or _is_source(path)  # a program in Python, or a launch file
        elif _is_source(path):
            sources = True
        else:
            others = True
    return Changed(frozenset(launch_files), others, sources or others)


def _is_source(path: str) -> bool:
    return os.path.splitext(path)[1].lower() in SOURCE_ENDS


def _files(top: str) -> Iterator[tuple[str, str]]:
    """Path within ``top`` and path of each file and link that may matter."""
    for place, directories, names in os.walk(top):
        directories[:] = [each for each in directories if each != ".git" and not os.path.islink(os.path.join(place, each))]
        for name in names:
            if os.path.splitext(name)[1].lower() not in _NO_MATTER or _is_source(name):
                file = os.path.join(place, name)
                yield os.path.relpath(file, top), file


def _same(first: str, second: str) -> bool:
    """Whether two files hold the same (or two links the same goal); a large one of a revision is empty, and never read."""
    try:
        if os.path.islink(first) or os.path.islink(second):
            return os.readlink(first) == os.readlink(second)
        if os.path.getsize(first) != os.path.getsize(second):
            return False
        with open(first, "rb") as one, open(second, "rb") as other:
            return one.read() == other.read()
    except OSError:
        return False
