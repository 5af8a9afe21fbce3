"""Leaving ROS 2 launch files out: both dialects use the same file names, and this one would find them wrong from top to bottom."""

from __future__ import annotations

import os
from collections.abc import Collection, Sequence

from launchlint.check.options import EntryRequest
from launchlint.evaluate.session import Session
from launchlint.workspace.packages import Packages


def without_ros2(requests: Sequence[EntryRequest], named: Collection[str], session: Session) -> tuple[list[EntryRequest], list[str]]:
    """``requests`` without those for ROS 2 launch files, and the paths of these.

    Files in ``named`` (absolute) were asked for by name, and stay whatever they hold.
    """
    from launchlint.workspace.dialect import ROS2, dialect

    kept: list[EntryRequest] = []
    skipped: dict[str, None] = {}
    for request in requests:
        data = None if os.path.abspath(request.at) in named else session.read(request.file).data
        if data is not None and dialect(data, _built_for(request.at, session.packages)) == ROS2:
            skipped[session.shown(request.at)] = None
        else:
            kept.append(request)
    return kept, list(skipped)


def _built_for(file: str, packages: Packages) -> str | None:
    """The ROS that the package of ``file`` is built for, where that is one only."""
    package = packages.package_of(file)
    manifest = None if package is None else package.manifest
    if manifest is None or (manifest.is_catkin and any(each.startswith("ament") for each in manifest.build_types)):
        return None
    return "ros2" if manifest.is_ament else "ros1" if manifest.is_catkin else None
