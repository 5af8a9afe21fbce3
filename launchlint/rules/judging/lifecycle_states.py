"""Who takes the lifecycle nodes of a launch of ROS 2 from one state to the next."""

from __future__ import annotations

import posixpath
from collections.abc import Mapping

from launchlint.graph.connections import Instance
from launchlint.model import Executable, Launch, UnknownText
from launchlint.named_tuple import NamedTuple
from launchlint.workspace.looking import question
from launchlint.workspace.texts import files_by_word

TYPE_CHECKING = False
if TYPE_CHECKING:
    from launchlint.rules.view import GraphView
    from launchlint.workspace.packages import Packages

MANAGER = "nav2_lifecycle_manager"
NAMES = "node_names"
"""The param of a manager that lists its nodes."""
CHANGE_STATE = "lifecycle_msgs/srv/ChangeState"
_ANY = "*"
_STARTING = ("autostart", "autostart_node")
"""Params with which a program is asked to take itself there (nav2_util::LifecycleNode, beluga_amcl)."""
_ENDS = (".py", ".sh", ".bash", ".md", ".rst", ".txt", ".cpp", ".cc", ".cxx", ".h", ".hpp", ".xml", ".launch", ".yaml", ".yml")
_SIMULATORS = frozenset(("gz", "ign", "gazebo", "gzserver", "gzclient", "rviz2", "xacro"))
_SILENT_VERBS = frozenset(("bag", "topic", "param", "control"))
"""What ``ros2`` is told to do that changes no node's state."""


def managed_names(manager: Instance) -> list[str] | None:
    """The names that a lifecycle manager is given, as written; None where they are not known (nav2_lifecycle_manager::LifecycleManager)."""
    if manager.node.own is None:
        return None
    _, value = manager.node.own.get(NAMES, ("", ()))
    return [each for each in value if each] if isinstance(value, tuple) and all(isinstance(each, str) for each in value) else None


def full_name(name: str, manager: Instance) -> str:
    """The full name of the node that a manager calls ``name``: it is relative to the namespace of the manager."""
    return name if name.startswith("/") else f"{manager.namer.namespace.rstrip('/')}/{name}"


class _Takers(NamedTuple):
    """Who takes nodes to other states: the managers, and the full names that they are given; ``unknown``: somebody may take any node."""

    unknown: bool
    managers: frozenset[str]
    named: frozenset[str]


def may_be_taken(instance: Instance, view: GraphView) -> bool:
    """Whether something may configure or activate the lifecycle node ``instance``: its program, launch, a manager, another node, people.

    What is not known counts as something that may.
    """
    takers, graph = view.once(_takers), view.graph
    if (instance.managed and not _waits_to_be_asked(instance)) or takers.unknown or instance.name in takers.named:
        return True
    service = f"{instance.name}/change_state"
    channel = graph.channels.get(("service", service))
    if channel is not None and channel.uses:
        return True
    possible = graph.may_use("service", service, CHANGE_STATE)
    if any(each.node not in takers.managers and each.node != instance.name for each in possible):
        return True
    return _is_told(instance.name.rpartition("/")[2], view.launch, view.packages)


def _waits_to_be_asked(instance: Instance) -> bool:
    """Whether a program takes itself there only where a param says so, which is not set and false by default."""
    own = instance.node.own
    if own is None:
        return False
    defaults = {each.name.removeprefix(f"{instance.name}:"): each.declaration.default for each in instance.readings if each.certain}
    return any(defaults.get(name) is False and name not in own for name in _STARTING)


def _takers(view: GraphView) -> _Takers:
    launch, instances = view.launch, view.graph.instances
    managers = [each for each in instances if each.node.package == MANAGER]
    listed = [managed_names(each) for each in managers]
    named = {full_name(name, each) for each, names in zip(managers, listed, strict=True) for name in names or ()}
    unknown = (
        bool(launch.transitions) or not launch.complete or not all(map(_is_idle, launch.programs))
        # Who is managed and not there may be any node, misspelt: LL940 tells that.
        or None in listed or not named <= {each.name for each in instances}
        or any(each.is_unknown or _may_call_any(each) for each in instances if each.node.package != MANAGER)
    )  # fmt: skip
    return _Takers(unknown, frozenset(each.name for each in managers), frozenset(named))


def _may_call_any(instance: Instance) -> bool:
    return any(end.role == "client" and end.type == CHANGE_STATE and not end.certain for end in instance.endpoints)


def _is_idle(program: Executable) -> bool:
    """Whether a program that is no node changes no node's state for certain."""
    words = program.command
    if not words or any(isinstance(word, UnknownText) for word in words):
        return False
    line = " ".join(words).split()
    first = posixpath.basename(line[0]) if line else ""
    return first in _SIMULATORS or (first == "ros2" and len(line) > 1 and line[1] in _SILENT_VERBS)


def _is_told(name: str, launch: Launch, packages: Packages) -> bool:
    """Whether a file of the workspaces that is none of this launch takes nodes to other states, and names this one: a script, a README."""
    own = set(launch.files)
    return any(file not in own for each in (name, _ANY) for file in packages.answer(_telling, each))


@question
def _telling(packages: Packages, name: str) -> tuple[str, ...]:
    """The files that take nodes to other states, and hold the name."""
    return packages.once(_kept).get(name, ())


def _kept(packages: Packages) -> Mapping[str, tuple[str, ...]]:
    """The files that take nodes to other states, by the names that they hold."""
    return files_by_word(packages.workspaces, _ENDS, "lifecycle", held=packages.held)
