"""Which programs there are in packages, and which files each of them is made of."""

from __future__ import annotations

import os
from collections.abc import Mapping, Sequence

from launchlint.errors import UsageError
from launchlint.extract.ament_package import AmentPackage
from launchlint.extract.assembly import Workspace
from launchlint.extract.catkin_package import CatkinPackage
from launchlint.extract.origin import Origin, origin_of
from launchlint.extract.package_reader import PackageReader
from launchlint.extract.task import Skipped, Task
from launchlint.named_tuple import NamedTuple
from launchlint.spelling import did_you_mean
from launchlint.workspace.package import Package
from launchlint.workspace.packages import Packages


class Plan(NamedTuple):
    """What is to be read. ``complete`` are packages of which all nodelet classes, or components, are known; ``modules`` maps directories to
    packages.
    """

    tasks: tuple[Task, ...]
    skipped: tuple[Skipped, ...]
    origins: tuple[Origin, ...]
    complete: frozenset[str]
    modules: dict[str, str]


def plan(sources: Sequence[str], wanted: Sequence[str] = (), context: Mapping[str, str] | None = None) -> Plan:
    """The programs of the packages in directories, or of those that are ``wanted`` by name.

    ``context`` has the values of the variables in the conditions of manifests; without it all that they list counts.

    Raises:
        UsageError: there is no such directory or package.
    """
    packages = _packages(sources, context)
    names = {package.name for package, _ in packages}
    for each in wanted:
        if each not in names:
            hint = did_you_mean(each, names) or f"there are {len(names)} packages: {', '.join(sorted(names)[:10])}"
            raise UsageError(f"--package {each}: there is no such package in these sources; {hint}")
    tasks: list[Task] = []
    skipped: list[Skipped] = []
    origins: dict[Origin, None] = {}
    complete: set[str] = set()
    workspace = Workspace(package for package, _ in packages)
    for package, given in packages:
        if package.broken:
            skipped.append(Skipped(package.name, "", package.manifest_path, f"the package cannot be read: {package.broken}"))
        elif not package.is_metapackage and (not wanted or package.name in wanted):
            reader = reader_of(package, origin_of(package.directory, given), workspace)
            reader.read()
            origins[reader.origin] = None
            tasks += reader.tasks
            skipped += reader.skipped
            if reader.complete:
                complete.add(package.name)
    modules = {package.directory: package.name for package, _ in packages if not package.broken}
    return Plan(tuple(tasks), tuple(skipped), tuple(origins), frozenset(complete), modules)


def reader_of(package: Package, origin: Origin, workspace: Workspace) -> PackageReader:
    """What reads a package: by what builds it."""
    return (AmentPackage if _is_ament(package) else CatkinPackage)(package, origin, workspace)


def _is_ament(package: Package) -> bool:
    """Whether its manifest says so; where it forgets the build type, whether it names tools of ament, and not catkin."""
    manifest = package.manifest
    if manifest is None or manifest.is_ament or manifest.build_types:
        return manifest is not None and manifest.is_ament
    tools = manifest.depends("buildtool")
    return "catkin" not in manifest.depends() and any(each.startswith("ament_") for each in tools)


def _packages(sources: Sequence[str], context: Mapping[str, str] | None) -> list[tuple[Package, str]]:
    found: dict[str, tuple[Package, str]] = {}
    for source in sources:
        if not os.path.isdir(source):
            reason = "it is a file; give the directory of a package or workspace" if os.path.exists(source) else "it does not exist"
            raise UsageError(f"cannot read sources from {source!r}: {reason}")
        packages = Packages([source], {}, explicit=True)
        listed = packages.places[0].everything
        if not listed:
            around = packages.package_of(source)
            listed = [] if around is None else [around]
        if not listed:
            raise UsageError(f"there is no package in {source!r}: no package.xml was found in it or below it")
        for package in _sources_first(listed, packages.colcon.places[0].everything):
            seen_so = package if context is None else package.under(context)
            found.setdefault(os.path.realpath(package.directory), (seen_so, source))
    seen: set[str] = set()
    first: list[tuple[Package, str]] = []
    for package, given in found.values():
        if package.broken or package.name not in seen:
            first.append((package, given))
        seen.add(package.name)
    return first


def _sources_first(listed: Sequence[Package], of_colcon: Sequence[Package]) -> list[Package]:
    """``listed`` packages, with what colcon passes over (``COLCON_IGNORE``) behind those of ROS 2 that it finds.

    It marks so what it writes: a build space, whose links break where it is copied, and an install space, in which each package stands
    once more, without its sources. In a workspace of ROS 2 what is broken and passed over is left out.
    """
    found = {each.directory for each in of_colcon}
    if not any(each.manifest is not None and each.manifest.is_ament for each in of_colcon):
        return list(listed)
    passed_over = [each for each in listed if each.directory not in found]
    return [*(each for each in listed if each.directory in found), *(each for each in passed_over if not each.broken)]
