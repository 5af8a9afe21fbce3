"""What the client libraries give to every node: no source code makes it, and no library lists it."""

from __future__ import annotations

from collections.abc import Mapping

from launchlint.model import ROS1, ROS2

PARAMETER_SERVICES = (
    "describe_parameters",
    "get_parameter_types",
    "get_parameters",
    "list_parameters",
    "set_parameters",
    "set_parameters_atomically",
)
"""Private services of a node of ROS 2 (rclcpp::ParameterService)."""

LIFECYCLE_SERVICES = ("change_state", "get_state", "get_available_states", "get_available_transitions", "get_transition_graph")
"""Those of one with a lifecycle (rcl_lifecycle_com_interface)."""

EVERYWHERE: Mapping[str, Mapping[str, tuple[str, ...]]] = {
    ROS1: {
        "publishers": ("/rosout",),
        "subscribers": ("/clock",),
        "services": ("~get_loggers", "~set_logger_level"),
        "params": ("/use_sim_time",),
    },
    ROS2: {
        "publishers": ("/rosout", "/parameter_events", "~transition_event"),
        "subscribers": ("/clock", "/parameter_events"),
        "services": tuple(f"~{name}" for name in (*PARAMETER_SERVICES, *LIFECYCLE_SERVICES)),
        "params": ("~use_sim_time",),
    },
}
"""The names of every node, or of every one with a lifecycle, by middleware and category."""

ACTION_TOPICS: Mapping[str, Mapping[str, tuple[str, ...]]] = {
    "server": {"subscribers": ("goal", "cancel"), "publishers": ("status", "feedback", "result")},
    "client": {"publishers": ("goal", "cancel"), "subscribers": ("status", "feedback", "result")},
}
"""The topics that an action of ROS 1 consists of, by the role of the node and category (actionlib)."""
