"""Which file an ``import`` reads: modules beside a script, and those of the packages that were given.

What can be imported of a package is what its ``setup.py`` names, from where its ``package_dir`` says, and what is in its ``src``.
"""

from __future__ import annotations

import os
from collections.abc import Mapping

from launchlint.python.setup_paths import setup_paths
from launchlint.python.source import Source, SourceError, parse
from launchlint.workspace import looking

MOST_KEPT = 1 << 20
"""Characters of source whose trees are kept for the next program: a tree takes about a hundred times as much memory."""


_DEEPEST = 4
"""Directories within each other, none of which has an ``__init__.py``, that are looked into for modules."""


class ModuleFinder:
    """Modules of the packages whose directories are given, by name.

    Args:
        packages: directory of each package → its name, those that win first.
        generated: names of modules in packages that a build makes, so that no source of them is looked for.
    """

    __slots__ = ("_asked", "_found", "_generated", "_names", "_parsed", "_real", "_roots", "packages")

    def __init__(self, packages: Mapping[str, str], generated: frozenset[str] = frozenset()) -> None:
        self.packages = dict(packages)
        self._generated = generated
        self._roots: dict[str, tuple[tuple[tuple[str, str], ...], looking.Looked]] = {}
        self._real: dict[str, str] = {}
        self._asked: dict[tuple[str, str, str], tuple[str | None, looking.Looked]] = {}
        self._names: dict[str, tuple[frozenset[str] | None, frozenset[str]]] = {}
        self._found: dict[tuple[str, str], tuple[str | None, looking.Looked]] = {}
        self._parsed: dict[str, tuple[object, Source | SourceError]] = {}

    def find(self, name: str, beside: str, package: str) -> str | None:
        """The file of module ``name`` (dotted) for a script in directory ``beside`` of the package at ``package``, or None.

        A module of the own package is preferred to one of the same name in another.
        """
        key = (name, beside, package)
        if key not in self._asked:
            self._asked[key] = looking.watched(lambda: self._find(name, beside, package))
        found, looked = self._asked[key]
        looking.note(looked)
        return found

    def _find(self, name: str, beside: str, package: str) -> str | None:
        parts = name.split(".")
        if not all(part.isidentifier() for part in parts) or len(parts) > 20:
            return None
        own = self._roots_of(package) if package else ()
        for prefix, root in dict.fromkeys((("", beside), *own)):
            found = self._below(prefix, root, name)
            if found is not None:
                return found
        if len(parts) > 1 and parts[1] in self._generated:
            return None
        for directory in self.packages:
            for prefix, root in self._roots_of(directory):
                found = self._below(prefix, root, name)
                if found is not None:
                    return found
        return None

    def _below(self, prefix: str, root: str, name: str) -> str | None:
        """The file of module ``name`` where the directory of the Python package ``prefix`` is ``root``."""
        if not prefix:
            return self._look(root, name.replace(".", os.sep))
        if name != prefix and not name.startswith(f"{prefix}."):
            return None
        return self._look(root, name[len(prefix) + 1 :].replace(".", os.sep))

    def parse(self, path: str) -> Source:
        """A module, read once for the programs that import it one after the other.

        Raises:
            SourceError: it cannot be read, or is no Python.
        """
        looking.note((os.path.abspath(path),))
        stamp = _stamp(path)
        known = self._parsed.pop(path, None)
        if known is None or known[0] != stamp:
            try:
                known = (stamp, parse(path))
            except SourceError as error:
                known = (stamp, error)
        self._parsed[path] = known  # the one that was asked for last stands at the end
        kept = 0
        for each, (_, old) in reversed(list(self._parsed.items())):
            kept += old.size if isinstance(old, Source) else 0
            if kept > MOST_KEPT and each != path:
                del self._parsed[each]
        if isinstance(known[1], SourceError):
            raise known[1]
        return known[1]

    def real(self, path: str) -> str:
        """The path without links, looked up once."""
        if path not in self._real:
            self._real[path] = os.path.realpath(path)
        return self._real[path]

    def roots(self, directory: str) -> tuple[tuple[str, str], ...]:
        """Names of Python packages with their directories, the longest first; an empty name is a directory on Python's path."""
        said = setup_paths(directory)
        listed = [(name, said[name]) for name in sorted(said, key=lambda name: (-len(name), name))]
        found = []
        for name, each in dict.fromkeys((*listed, ("", "src"))):
            path = os.path.normpath(os.path.join(directory, each))
            if looking.is_directory(path):
                found.append((name, path))
        return tuple(found)

    def _roots_of(self, directory: str) -> tuple[tuple[str, str], ...]:
        """Where the Python modules of a package are, looked for once: names of Python packages, empty for any, with their directories."""
        if directory not in self._roots:
            self._roots[directory] = looking.watched(lambda: self.roots(directory))
        roots, looked = self._roots[directory]
        looking.note(looked)
        return roots

    def _look(self, root: str, relative: str) -> str | None:
        if root not in self._names:
            names = looking.names(root)
            self._names[root] = (frozenset(names) if len(names) < looking.MOST_NAMES else None, frozenset((os.path.abspath(root),)))
        there, place = self._names[root]
        looking.note(place)
        first = relative.partition(os.sep)[0]
        if relative and there is not None and first not in there and f"{first}.py" not in there:
            return None
        key = (root, relative)
        if key not in self._found:
            self._found[key] = looking.watched(lambda: _module(root, relative))
        found, looked = self._found[key]
        looking.note(looked)
        return found


def _stamp(path: str) -> object:
    """Another one where the file is another."""
    try:
        status = os.stat(path)
    except (OSError, ValueError):
        return None
    return (status.st_mtime_ns, status.st_size, status.st_ino)


def _module(root: str, relative: str) -> str | None:
    path = os.path.join(root, relative) if relative else root
    if looking.is_file(os.path.join(path, "__init__.py")):
        return os.path.join(path, "__init__.py")
    if relative and looking.is_file(path + ".py"):
        return path + ".py"
    return path + os.sep if looking.is_directory(path) and _has_python(path, _DEEPEST) else None


def _has_python(directory: str, deep: int) -> bool:
    """Whether a directory without ``__init__.py`` may be meant as a package, be it that modules are only further down (PEP 420)."""
    names = looking.names(directory)
    if "package.xml" in names:
        return False
    return any(name.endswith(".py") for name in names) or any(
        name.isidentifier() and looking.is_directory(below) and _has_python(below, deep - 1)
        for name, below in ((name, os.path.join(directory, name)) for name in sorted(names) if deep > 1)
    )
