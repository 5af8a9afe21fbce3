"""Launch files that are parts of a whole: what gives the names that they wait for may be started around them."""

from __future__ import annotations

import posixpath

from launchlint.evaluate.problems import RequiredArgUnset
from launchlint.graph.names import kind
from launchlint.model import ROS2

TYPE_CHECKING = False
if TYPE_CHECKING:
    from launchlint.graph.connections import Endpoint
    from launchlint.rules.view import GraphView

_OTHER_LANGUAGES = (".py", ".yaml", ".yml")


def comes_from_around(view: GraphView, taker: Endpoint, giver: Endpoint) -> bool:
    """Whether the global name that ``taker`` waits for is probably given by what the launch file is a part of, and not by ``giver``.

    So it is where the file has args without a default, so that nobody starts it as it is (in ROS 1 with any name: whatever includes the
    file may put it into a namespace); and where another launch file of its package names it, and ``giver`` would have that very name in the
    namespace which that one may put the whole file into.
    """
    if view.launch.dialect != ROS2:
        return any(isinstance(each, RequiredArgUnset) and each.origin.step is None for each in view.launch.problems)
    if not _is_global(taker):
        return False
    if _wants_args(view):
        return True
    return taker.name.endswith(giver.name) and not _is_global(giver) and _is_included(view)


def is_part(view: GraphView) -> bool:
    """Whether the entry file has args without a default, or another launch file of its package names it."""
    return _wants_args(view) or _is_included(view)


def _wants_args(view: GraphView) -> bool:
    launch = view.launch
    return any(each.required and not each.conditional and each.place.source.file == launch.entry.file for each in launch.listed)


def _is_global(end: Endpoint) -> bool:
    """Whether the name stays what it is in whatever namespace the node is started."""
    return kind(end.applied[-1].rule.target if end.applied else end.declared) == "global"


def _is_included(view: GraphView) -> bool:
    """Whether another launch file of its package names the entry file."""
    from launchlint.rules.judging.idle_test import naming

    file = view.launch.entry.file
    home = view.packages.colcon.package_of(file)
    name = posixpath.basename(file)
    name = posixpath.splitext(name)[0] if name.endswith(_OTHER_LANGUAGES) else name
    return home is not None and any(each != file and "launch" in posixpath.basename(each) for each in naming(name, home, view.packages))
