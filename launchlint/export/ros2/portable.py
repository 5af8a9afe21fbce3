"""Paths that a program has computed, in place of which a declarative launch file says which package they lie in."""

from __future__ import annotations

import re

from launchlint.syntax.ros2.description import Substitution, Text

TYPE_CHECKING = False
if TYPE_CHECKING:
    from launchlint.evaluate.session import Session
    from launchlint.source import Place

_PATH = re.compile(r"(?:^|(?<=[\s=:'\",;])|(?<=-[A-Za-z]))/[^\s'\",:;]+")
_SHARE = "find-pkg-share"


class Portable:
    """Looks for the directories of packages as ``file`` sees them."""

    def __init__(self, session: Session, file: str) -> None:
        self._session = session
        self._file = file

    def pieces(self, text: str, place: Place) -> list[str | Substitution]:
        """``text`` with ``$(find-pkg-share …)`` in place of such directories."""
        found: list[str | Substitution] = []
        at = 0
        for match in _PATH.finditer(text):
            inside = self._inside(match[0])
            if inside is None:
                continue
            name, rest = inside
            found += [text[at : match.start()], Substitution(_SHARE, (Text((name,), place),), place), rest]
            at = match.end()
        return [*found, text[at:]]

    def is_local(self, text: str) -> bool:
        """Whether ``text`` holds a path of this machine that lies in no package."""
        root = self._session.root.rstrip("/") + "/"
        return any(match[0].startswith(root) for match in _PATH.finditer(text))

    def _inside(self, path: str) -> tuple[str, str] | None:
        """The package that a path lies in, and where in it."""
        packages = self._session.packages
        package = packages.package_of(path)
        directory = None if package is None or not package.name else packages.colcon.find(package.name, self._file)
        if package is None or directory is None or not (path == directory or path.startswith(f"{directory}/")):
            return None
        return package.name, path[len(directory) :]
