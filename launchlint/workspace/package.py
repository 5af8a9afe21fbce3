"""One package on disk."""

from __future__ import annotations

import os
from collections.abc import Collection, Mapping
from copy import copy

from launchlint.named_tuple import NamedTuple
from launchlint.workspace.looking import note
from launchlint.workspace.manifest import Manifest, read_manifest

TYPE_CHECKING = False
if TYPE_CHECKING:
    from launchlint.workspace.contents import Contents
    from launchlint.workspace.crawl import Crawled


class Kind(NamedTuple):
    """What a package is called, whether it can be read, what builds it, and the nodelet plugin descriptions that it exports; see
    :class:`~launchlint.workspace.manifest.Manifest`.
    """

    name: str
    is_metapackage: bool
    is_broken: bool
    is_catkin: bool = False
    is_ament: bool = False
    ros_versions: frozenset[str] = frozenset()
    build_types: Collection[str] = ()
    plugins: Collection[str] = ()


class Package:
    """One package (or metapackage) on disk; its manifest is read when first asked for.

    ``directory`` is absolute and spelled as the crawl met it (symbolic links are kept, as rospkg does). ``broken`` is empty, or says why
    the manifest cannot be used: the package then has no dependencies and, if its name could not be read, no name. ``held`` may know what
    the manifest says.
    """

    __slots__ = ("_context", "_held", "_kind", "_manifest", "_read", "broken", "directory", "is_metapackage", "manifest_path", "name")

    def __init__(self, crawled: Crawled, held: Contents | None = None) -> None:
        self._held = held
        self.name = crawled.name
        self.directory = crawled.directory
        self.manifest_path = crawled.manifest_path
        self.is_metapackage = crawled.metapackage
        self.broken = crawled.reason
        self._manifest: Manifest | None = None
        self._read = bool(crawled.reason)
        self._context: Mapping[str, str] | None = None
        self._kind: Kind | None = None

    def under(self, context: Mapping[str, str]) -> Package:
        """The same package where the variables in the conditions of its manifest are those of ``context``."""
        other = copy(self)
        other._context, other._manifest, other._kind, other._read = context, None, None, bool(self.broken)
        return other

    def __repr__(self) -> str:
        return f"Package({self.name!r}, {self.directory!r})"

    @property
    def manifest(self) -> Manifest | None:
        """The whole manifest with places; ``None`` where it is broken (``broken`` then says why). Who asks for it has looked at it."""
        note((self.manifest_path,))
        return self._whole

    @property
    def kind(self) -> Kind:
        """What it is to all launch files of a workspace, whoever asks: this alone is not noted as a look at the manifest."""
        if self._kind is None:
            manifest = self._whole
            built = () if manifest is None else (
                manifest.is_catkin, manifest.is_ament, manifest.ros_versions, manifest.build_types, manifest.plugins,
            )  # fmt: skip
            self._kind = Kind(self.name, self.is_metapackage, bool(self.broken), *built)
        return self._kind

    @property
    def _whole(self) -> Manifest | None:
        if not self._read:
            self._read = True
            try:
                manifest = self._read_manifest()
                self._manifest = manifest if self._context is None else manifest.under(self._context)
            except (OSError, ValueError) as error:
                self.broken = str(error)
        return self._manifest

    def _read_manifest(self) -> Manifest:
        if self._held is None:
            return read_manifest(self.manifest_path)
        from launchlint.workspace.known_manifest import known_manifest

        return known_manifest(self.manifest_path, self._held)

    @property
    def is_catkin(self) -> bool:
        """Whether catkin builds it (roslaunch.depends judges those by their run dependencies)."""
        return self.manifest is not None and self.manifest.is_catkin

    @property
    def run_dependencies(self) -> frozenset[str]:
        """Packages its manifest declares for running; empty where the manifest is broken (see ``Manifest.run_dependencies``)."""
        return frozenset() if self.manifest is None else self.manifest.run_dependencies

    @property
    def test_dependencies(self) -> frozenset[str]:
        """Packages its manifest declares for testing; empty where the manifest is broken."""
        return frozenset() if self.manifest is None else self.manifest.test_dependencies

    @property
    def nodelet_plugin_files(self) -> tuple[str, ...]:
        """Paths of the nodelet plugin descriptions it exports, whether or not they exist (``<nodelet plugin="${prefix}/…"/>``)."""
        return tuple(os.path.join(self.directory, each) for each in self.kind.plugins)
