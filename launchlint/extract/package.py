"""From directories of packages to a library: every program read, in parallel where that pays."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from typing import Any

from launchlint import __version__
from launchlint.extract.plan import Plan, plan
from launchlint.extract.reading import ProgramReader, Reading
from launchlint.extract.task import Skipped
from launchlint.named_tuple import NamedTuple

PARALLEL_FROM = 8
"""Programs from which a second process pays."""


class Result(NamedTuple):
    """The library as a document, and what the summary says. ``skipped`` are programs that are not in it, with the reason; ``opened``
    counts those that may have names that were not found.
    """

    document: dict[str, Any]
    programs: int
    names: int
    unresolved: int
    opened: int
    skipped: tuple[Skipped, ...]


def extract(
    sources: Sequence[str],
    wanted: Sequence[str] = (),
    jobs: int = 1,
    progress: Callable[[int, int], None] | None = None,
    context: Mapping[str, str] | None = None,
) -> Result:
    """Read every program of the packages in ``sources`` (directories). Nothing is built, run or imported.

    Args:
        sources: directories of packages or workspaces.
        wanted: names of the packages to read; all if empty. Others are only looked into for modules and headers.
        jobs: processes.
        progress: told how many programs of how many are done.
        context: what the variables in the conditions of manifests are: ``{"ROS_VERSION": "2"}`` for a package that is built for both.

    Raises:
        UsageError: a directory or package does not exist.
    """
    planned = plan(sources, wanted, context)
    readings: list[Reading] = []
    for reading in _read_all(planned, jobs):
        readings.append(reading)
        if progress is not None:
            progress(len(readings), len(planned.tasks))
    return _result(planned, readings)


def _read_all(planned: Plan, jobs: int) -> Iterator[Reading]:
    done = 0
    if jobs > 1 and len(planned.tasks) >= PARALLEL_FROM:
        from launchlint.pool import in_pool

        for reading in in_pool(ProgramReader.read, planned.tasks, min(jobs, len(planned.tasks)), ProgramReader, (planned.modules,)):
            done += 1
            yield reading
    reader = ProgramReader(planned.modules)
    for task in planned.tasks[done:]:
        yield reader.read(task)


def _result(planned: Plan, readings: Sequence[Reading]) -> Result:
    packages: dict[str, dict[str, Any]] = {}
    skipped = list(planned.skipped)
    used: set[str] = set()
    for reading in readings:
        task = reading.task
        if reading.program is None:
            path = task.sources[0][len(task.origin.root) :].lstrip("/")
            skipped.append(Skipped(task.package, task.name, path, reading.problem))
            continue
        of_ros2 = {"middleware": "ros2"} if task.is_of_ros2 else {}
        package = packages.setdefault(task.package, {**of_ros2, "source": task.origin.id})
        package.setdefault(task.kind, {})[task.name] = reading.program
        used.add(task.origin.id)
    missing = {each.package for each in skipped}
    for name, package in packages.items():
        if name in planned.complete and name not in missing:
            package["complete"] = ["components" if "middleware" in package else "nodelets"]
    document = {
        "format": "launchlint-library",
        "version": 2 if any("middleware" in package for package in packages.values()) else 1,
        "generator": f"launchlint {__version__} extract",
        "sources": _sources(planned, used),
        "packages": packages,
    }
    done = [reading for reading in readings if reading.program is not None]
    opened = sum(any("open" in variant for variant in each.program["variants"].values()) for each in done if each.program is not None)
    return Result(document, len(done), sum(each.names for each in done), sum(each.unresolved for each in done), opened, tuple(skipped))


def _sources(planned: Plan, used: set[str]) -> list[dict[str, Any]]:
    found: dict[str, dict[str, Any]] = {}
    for origin in planned.origins:
        if origin.id in used:
            source = {"id": origin.id, "url": origin.url}
            source.update({key: value for key, value in (("ref", origin.ref), ("commit", origin.commit)) if value})
            found.setdefault(origin.id, source)
    return [found[each] for each in sorted(found)]
