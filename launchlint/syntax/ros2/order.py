"""The attributes of ROS 2's tags in canonical order: conditions, what it is, what it is called, how it runs."""

from __future__ import annotations

_CONDITIONS = ("if", "unless")
_PROCESS = (
    *("respawn", "respawn_delay", "respawn_max_retries", "on_exit", "sigterm_timeout", "sigkill_timeout"),
    *("output", "emulate_tty", "cwd", "shell", "launch-prefix"),
)
_NODE = (*_CONDITIONS, "name", "pkg", "exec", "namespace", "args", "ros_args", "exec_name", *_PROCESS)
_PAIR = (*_CONDITIONS, "name", "value")

ORDER = {
    "arg": (*_CONDITIONS, "name", "default", "value", "description"),
    "let": _PAIR,
    "include": (*_CONDITIONS, "file"),
    "group": (*_CONDITIONS, "scoped", "forwarding"),
    "executable": (*_CONDITIONS, "name", "cmd", *_PROCESS),
    "node": _NODE,
    "node_container": _NODE,
    "composable_node": (*_CONDITIONS, "name", "pkg", "plugin", "namespace"),
    "load_composable_node": (*_CONDITIONS, "target"),
    "push_ros_namespace": (*_CONDITIONS, "namespace"),
    "push-ros-namespace": (*_CONDITIONS, "namespace"),
    "param": ("name", "from", "allow_substs", "type", "value", "value-sep"),
    "remap": ("from", "to"),
    "set_remap": (*_CONDITIONS, "from", "to"),
    "set_parameter": _PAIR,
    "set_parameters_from_file": (*_CONDITIONS, "filename"),
    "set_use_sim_time": (*_CONDITIONS, "value"),
    "set_env": _PAIR,
    "append_env": (*_PAIR, "prepend", "separator"),
    "unset_env": (*_CONDITIONS, "name"),
    "env": _PAIR,
    "keep": _PAIR,
    "extra_arg": _PAIR,
    "choice": ("value",),
    "set_ros_log_dir": (*_CONDITIONS, "new_log_dir"),
    "log": (*_CONDITIONS, "message"),
    "shutdown": (*_CONDITIONS, "reason"),
    "timer": (*_CONDITIONS, "period", "cancel_on_shutdown"),
    "for": (*_CONDITIONS, "name", "len"),
    "for_each": (*_CONDITIONS, "values"),
    "ros_timer": (*_CONDITIONS, "period"),
}
"""Tag to its attributes. Where ROS 1 has the tag, too, they go together with its order."""
