"""What launch files of ROS 1 have and those of ROS 2 do not, each with the way of ROS 2."""

from __future__ import annotations

TAGS = {
    "rosparam": '<param from="FILE"/> inside the <node>',
    "machine": "",
    "master": "",
    "test": "a test with launch_testing",
}
"""Tag to the way of ROS 2, empty where there is none."""

ATTRIBUTES = {
    "node": {
        "type": "exec",
        "ns": "namespace",
        "required": 'on_exit="shutdown"',
        "clear_params": "",
        "machine": "",
    },
    "include": {"ns": "a <group> with <push_ros_namespace> before the <include>", "clear_params": "", "pass_all_args": ""},
    "group": {"ns": '<push_ros_namespace namespace="…"/> as the first thing in the group', "clear_params": ""},
    "arg": {"doc": "description", "value": '<let name="…" value="…"/>, or default'},
    "param": {
        "textfile": 'value="$(file-content …)"',
        "command": "value=\"$(command '…')\"",
        "binfile": "",
    },
}
"""Tag to its attributes in ROS 1, each with the way of ROS 2 (empty where there is none)."""

RENAMED = frozenset(("exec", "namespace", "description"))
"""Attributes that only have another name in ROS 2."""

SUBSTITUTIONS = {"find": "find-pkg-share", "arg": "var", "optenv": "env"}
"""Substitution to the one of ROS 2."""
