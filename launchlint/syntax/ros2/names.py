"""Names that attributes have elsewhere in ROS 2."""

from __future__ import annotations

IN_PYTHON = {
    "package": "pkg",
    "executable": "exec",
    "node_executable": "exec",
    "node-exec": "exec",
    "node_name": "name",
    "node-name": "name",
    "node_namespace": "namespace",
    "node-namespace": "namespace",
    "arguments": "args",
    "ros_arguments": "ros_args",
    "prefix": "launch-prefix",
    "default_value": "default",
    "desc": "description",
}
"""Keyword of a launch file in Python, or name of an old distribution, to the attribute in XML and YAML."""
