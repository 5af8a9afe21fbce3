"""Leaving out what only looks like a launch file of ROS 1.

That are the launch files of ROS 2 (both dialects use the same file names, and this one would find them wrong from top to bottom), and files
of other programs with the same ending (Eclipse has ``.launch`` files, too), even where they hold a ``<launch>`` somewhere.
"""

from __future__ import annotations

import os
from collections.abc import Collection, Sequence
from typing import NamedTuple

from launchlint.check.options import EntryRequest
from launchlint.evaluate.session import Session
from launchlint.workspace.packages import Packages


class SortedOut(NamedTuple):
    """Requests for launch files of ROS 1, and the paths of others: ``ros2`` launch files, ``other`` files with the name of their root."""

    kept: list[EntryRequest]
    ros2: tuple[str, ...]
    other: tuple[tuple[str, str], ...]


def sort_out(requests: Sequence[EntryRequest], named: Collection[str], session: Session) -> SortedOut:
    """Tell launch files of ROS 1 from others. Files in ``named`` (absolute) were asked for by name, and stay whatever they hold."""
    from launchlint.workspace.dialect import ROS2, dialect, other_root

    kept: list[EntryRequest] = []
    ros2: dict[str, None] = {}
    other: dict[str, str] = {}
    for request in requests:
        data = None if os.path.abspath(request.at) in named else session.read(request.file).data
        root = None if data is None else other_root(data)
        if root is not None:
            other[session.shown(request.at)] = root
        elif data is not None and dialect(data, _built_for(request.at, session.packages)) == ROS2:
            ros2[session.shown(request.at)] = None
        else:
            kept.append(request)
    return SortedOut(kept, tuple(ros2), tuple(other.items()))


def _built_for(file: str, packages: Packages) -> str | None:
    """The ROS that the package of ``file`` is built for, where that is one only."""
    package = packages.package_of(file)
    manifest = None if package is None else package.manifest
    if manifest is None or (manifest.is_catkin and any(each.startswith("ament") for each in manifest.build_types)):
        return None
    return "ros2" if manifest.is_ament else "ros1" if manifest.is_catkin else None
