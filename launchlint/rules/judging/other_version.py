"""Programs that may not be the ones that the library knows: the workspace has another version of them, or another fork."""

from __future__ import annotations

from launchlint.graph.connections import Instance
from launchlint.model import ROS2
from launchlint.rules.view import GraphView
from launchlint.spelling import closest
from launchlint.workspace.surveys import list_like

_MOST_LOOKED_AT = 50


def may_be_another_version(instance: Instance, view: GraphView) -> bool:
    """Whether a list of sources brings the package of the node, of which only a state of its repository is known, or its params say so.

    It is brought where a ``.repos``, ``.rosinstall`` or ``.gitmodules`` of the workspaces names the package or that repository (vcstool's
    and wstool's formats); in ROS 2 the params say so where it is given one that it does not declare, and that is no slip.
    """
    repositories = _repositories(instance)
    if not repositories:
        return False
    if any(list_like(view.packages, name) for name in sorted({instance.node.package, *repositories})):
        return True
    if view.dialect.name != ROS2:
        return False
    from launchlint.rules.judging.ros2_params import not_declared

    declared, others = not_declared(instance)
    return any(closest(name, declared) is None for name in others)


def _repositories(instance: Instance) -> set[str]:
    """Whose sources say what the node does, without their owners; none where some of it was read here."""
    ends = instance.endpoints[:_MOST_LOOKED_AT]
    if any(each.is_read_here for each in ends):
        return set()
    said = {fact.get("at", "").partition("@") for each in ends for fact in each.declaration.evidence}
    return {repository.rpartition("/")[2] for repository, at, _ in said if at}
