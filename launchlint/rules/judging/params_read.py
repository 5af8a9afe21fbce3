"""Which params a node's code reads, whatever the situation it is started in."""

from __future__ import annotations

from launchlint.graph.connections import Doubt, Instance
from launchlint.graph.names import absolute, around
from launchlint.library.lookup import Library
from launchlint.library.program import Program
from launchlint.named_tuple import NamedTuple

UNIVERSAL = frozenset(
    {
        # roscpp and rospy
        "use_sim_time", "tcp_keepalive", "enable_statistics", "statistics_window_min_elements", "statistics_window_max_elements",
        "statistics_window_min_size", "statistics_window_max_size", "rosout_disable_topics_generation", "logger_level",
        # tf, urdf and kdl look for these from the node's own namespace upward
        "tf_prefix", "robot_description", "robot_description_semantic", "robot_description_planning", "robot_description_kinematics",
        # multimaster_fkie shows nodes in groups
        "capability_group",
        # diagnostic_updater, bond, image_transport, actionlib
        "diagnostic_period", "diagnostic_updater_fqn", "diagnostic_updater_use_fqn", "bond_disable_heartbeat_timeout",
        "image_transport", "disable_pub_plugins", "status_frequency", "status_list_timeout", "actionlib_status_frequency",
        "actionlib_server_pub_queue_size", "actionlib_server_sub_queue_size", "actionlib_client_pub_queue_size",
        "actionlib_client_sub_queue_size",
    }
)  # fmt: skip
"""Params that the client libraries and widely used libraries read in any node, by the last part of their names."""


class Declared(NamedTuple):
    """The params that a program may read: full names, all ``around`` these, and patterns of those that are made from something."""

    names: dict[str, str]
    around: frozenset[str]
    patterns: tuple[Doubt, ...]

    def may_be(self, name: str) -> bool:
        """Whether ``name``, something around it or something below it may be one of them."""
        if name in self.names or name in self.around or any(outer in self.names for outer in around(name)):
            return True
        return any(pattern.may_be(name) or pattern.may_be(f"{name}/*") for pattern in self.patterns)


def program_of(instance: Instance, library: Library) -> Program | None:
    """What the library says of the code that ``instance`` runs."""
    if instance.kind == "nodelet":
        return library.nodelet(instance.program)
    return library.executable(instance.node.package, instance.node.executable)


def declared_by(instance: Instance, library: Library) -> Declared:
    """The params that the code of ``instance`` may read in any of its variants, under any condition."""
    names: dict[str, str] = {}
    patterns: dict[Doubt, None] = {}
    program = program_of(instance, library)
    for variant in () if program is None else program.variants:
        for declaration in variant.declarations:
            if declaration.category != "params":
                continue
            known = _pattern(declaration.name)
            if "*" not in known:
                names[instance.namer.resolve(known).name] = known
            elif known.startswith("*") and not known.startswith("*/"):
                patterns[Doubt("params", "*", declaration.name)] = None
            else:
                full = absolute(known, instance.namer.namespace, instance.namer.node)
                patterns[Doubt("params", full, declaration.name)] = None
    return Declared(names, frozenset(outer for name in names for outer in around(name)), tuple(patterns))


def _pattern(template: str) -> str:
    """``template`` with ``*`` for each of its slots."""
    plain: list[str] = []
    depth = 0
    for char in template:
        if char == "{":
            if not depth:
                plain.append("*")
            depth += 1
        elif char == "}":
            depth -= 1
        elif not depth:
            plain.append(char)
    return "".join(plain)
