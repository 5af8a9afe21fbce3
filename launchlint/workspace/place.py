"""One directory tree that is searched for packages."""

from __future__ import annotations

import os

from launchlint.named_tuple import NamedTuple
from launchlint.workspace.crawl import Way, crawl_all
from launchlint.workspace.package import Package
from launchlint.workspace.prefixes import is_installed

TYPE_CHECKING = False
if TYPE_CHECKING:
    from launchlint.workspace.contents import Contents


class Hidden(NamedTuple):
    """A package of the workspace that is not found, because of the file ``marker`` (CATKIN_IGNORE …) in or above its ``directory``."""

    name: str
    directory: str
    marker: str


class Place:
    """One directory tree that is searched for packages, in the ``way`` of rospack or of colcon; ``held`` may know manifests."""

    __slots__ = ("_all", "_by_name", "_held", "_ignored", "root", "way")

    def __init__(self, root: str, way: Way, held: Contents | None = None) -> None:
        self.root = root
        self.way = way
        self._held = held
        self._ignored: list[str] = []
        self._all: list[Package] | None = None
        self._by_name: dict[str, list[Package]] = {}

    @property
    def everything(self) -> list[Package]:
        """All packages, metapackages and broken packages, in the order of the crawl."""
        return self._crawl()

    @property
    def by_name(self) -> dict[str, list[Package]]:
        """The packages ``$(find)`` can answer, those of one name in the order of the crawl; none that is installed where a source is."""
        return self._by_name if self.everything else {}

    @property
    def ignored(self) -> list[str]:
        """The files (absolute), such as a ``CATKIN_IGNORE``, that keep the crawl out of directories."""
        self._crawl()
        return self._ignored

    def hidden(self) -> list[Hidden]:
        """The packages that such a file keeps from being found, but for what a build has installed; each call looks at the disk again."""
        return [
            Hidden(each.name, each.directory, marker)
            for marker in self.ignored
            for each in crawl_all(os.path.dirname(marker), self.way, through_ignored=True)[0]
            if each.name and (self.way.metapackages or not each.metapackage) and not each.reason and not is_installed(each.directory)
        ]

    def _crawl(self) -> list[Package]:
        if self._all is None:
            found, self._ignored = crawl_all(self.root, self.way, held=self._held)
            self._all = [Package(each, self._held) for each in found]
            for package in self._all:
                if package.name and (self.way.metapackages or not package.is_metapackage) and not package.broken:
                    self._by_name.setdefault(package.name, []).append(package)
            for name, copies in self._by_name.items():
                self._by_name[name] = [each for each in copies if len(copies) > 1 and not is_installed(each.directory)] or copies
        return self._all
