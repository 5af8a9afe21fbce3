"""Where the files of a package stand once it is installed: from source to share path, and back."""

from __future__ import annotations

import os
import posixpath
from collections.abc import Iterator, Sequence

from launchlint.workspace.ament.cmake import PREFIX
from launchlint.workspace.cmake_taking import takes
from launchlint.workspace.cmake_targets import Install
from launchlint.workspace.looking import exists, is_directory

TYPE_CHECKING = False
if TYPE_CHECKING:
    from launchlint.workspace.cmake_scope import Value


def below_prefix(destination: Value) -> str | None:
    """A destination relative to the prefix, with ``/`` and no dots; ``..`` for one outside of it, ``None`` where it is not known."""
    if destination is None or "$<" in destination:
        return None
    inside = destination.removeprefix(PREFIX).lstrip("/") if destination.startswith(PREFIX) else destination
    path = posixpath.normpath(inside or ".")
    return ".." if path.startswith(("/", "..")) else path


def places_of(installs: Sequence[Install], file: str) -> Iterator[str]:
    """The paths below the prefix at which the file of the package at ``file`` (absolute) stands, as far as they are known."""
    for install in installs:
        to = below_prefix(install.destination)
        if to is None or to == ".." or not takes(install, file):
            continue
        if not install.is_directory:
            if install.renamed is not None:
                yield posixpath.normpath(f"{to}/{install.renamed or os.path.basename(install.path)}")
            continue
        top = install.path if install.contents else os.path.dirname(install.path)
        yield posixpath.normpath(f"{to}/{os.path.relpath(file, top)}")


def sources_of(installs: Sequence[Install], place: str) -> Iterator[str]:
    """The files or directories (absolute; they exist) that are installed to ``place``, a path below the prefix."""
    for install in installs:
        to = below_prefix(install.destination)
        if to is None or to == "..":
            continue
        if not install.is_directory:
            if install.renamed is not None and posixpath.normpath(f"{to}/{install.renamed or os.path.basename(install.path)}") == place:
                yield install.path
            continue
        root = to if install.contents else posixpath.normpath(f"{to}/{os.path.basename(install.path)}")
        if place == root:
            rest = ""
        elif root == "." or place.startswith(f"{root}/"):
            rest = place if root == "." else place[len(root) + 1 :]
        else:
            continue
        source = os.path.normpath(os.path.join(install.path, rest))
        if exists(source) and (is_directory(source) or takes(install, source)):
            yield source
