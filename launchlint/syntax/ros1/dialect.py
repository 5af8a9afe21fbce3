"""The metamodel of roslaunch's XML, as data: which tags there are, what stands in what, which attributes take which values.

The one place where this is written: the validator, the evaluator, the formatter (canonical attribute order), did-you-mean and
the RelaxNG schema all read it here. Source: the ``*_ATTRS`` lists and the tag methods of ``roslaunch.xmlloader.XmlLoader`` 1.15.
"""

from __future__ import annotations

from launchlint.named_tuple import NamedTuple
from launchlint.syntax.ros1.domains import (
    COMMAND,
    CONDITION,
    CWD,
    FILLED,
    FLAG,
    INTEGER,
    MACHINE_DEFAULT,
    NONEMPTY,
    NUMBER,
    OPTIONAL_FLAG,
    OUTPUT,
    PARAM_TYPE,
    TEXT,
    TIME_LIMIT,
    TIMEOUT,
    Domain,
    parse_condition,
    parse_flag,
)

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Literal

    from launchlint.model import Role

__all__ = [
    "CONDITIONS",
    "OWNERS",
    "PARAM_SOURCES",
    "ROLES",
    "ROS2_ATTRIBUTES",
    "ROS2_SUBSTITUTIONS",
    "ROS2_TAGS",
    "TAGS",
    "TEST_REFUSES",
    "AttributeRule",
    "Domain",
    "TagRule",
    "parse_condition",
    "parse_flag",
    "tag_for",
]


class AttributeRule(NamedTuple):
    """One attribute of one tag.

    ``status``: ``deprecated`` still works, ``ineffective`` is accepted without effect, ``refused`` is recognised and
    refused. ``instead``: what to use.
    """

    name: str
    domain: Domain = TEXT
    required: bool = False
    status: Literal["", "deprecated", "ineffective", "refused"] = ""
    instead: str = ""


class TagRule(NamedTuple):
    """One tag: its attributes in canonical order, the tags it may stand in and may hold, whether its text means something.

    ``any_case``: roslaunch reads the names of its children in any case. ``children_noticed``: roslaunch says something about a child it
    does not know (otherwise children are silently ignored). ``status``: ``defunct`` for a tag that is accepted and does nothing.
    """

    tag: str
    attributes: tuple[AttributeRule, ...]
    parents: tuple[str, ...] = ()
    children: tuple[str, ...] = ()
    text: bool = False
    any_case: bool = False
    children_noticed: bool = False
    status: Literal["", "defunct"] = ""
    instead: str = ""

    def attribute(self, name: str) -> AttributeRule | None:
        """The rule for attribute ``name``."""
        for rule in self.attributes:
            if rule.name == name:
                return rule
        return None

    @property
    def known(self) -> tuple[str, ...]:
        """The attributes to use: all but the refused and ineffective ones, in canonical order."""
        return tuple(rule.name for rule in self.attributes if rule.status in ("", "deprecated"))

    @property
    def required(self) -> tuple[str, ...]:
        """The attributes that must be there."""
        return tuple(rule.name for rule in self.attributes if rule.required)


CONDITIONS = ("if", "unless")
"""Every tag but ``<launch>`` takes one of them."""

PARAM_SOURCES = ("value", "textfile", "binfile", "command")
"""A ``<param>`` has exactly one of these."""

TEST_REFUSES = ("respawn", "respawn_delay", "output")
"""What a ``<node>`` may have and a ``<test>`` may not (``XmlLoader._test_attrs``)."""

ROLES: dict[str, Role] = {
    "pkg": "package",
    "type": "executable",
    "name": "name",
    "test-name": "test_name",
    "ns": "namespace",
    "args": "arguments",
    "launch-prefix": "prefix",
    "machine": "machine",
    "output": "output",
    "cwd": "cwd",
}
"""What the attributes of ``<node>`` and ``<test>`` are for, in the words of the model."""

_IF = (AttributeRule("if", CONDITION), AttributeRule("unless", CONDITION))
_BLOCK = ("launch", "group")
_BLOCK_CHILDREN = ("arg", "group", "include", "machine", "node", "test", "param", "rosparam", "remap", "env", "master")
_NODE_CHILDREN = ("param", "rosparam", "remap", "env")
_RUNS = (
    AttributeRule("ns"),
    AttributeRule("args"),
    AttributeRule("machine"),
)
_ROS_PATHS = "set the environment in a script and name it in env-loader"

_RULES = (
    TagRule(
        "launch",
        (
            AttributeRule("deprecated"),
            AttributeRule("if", CONDITION, status="ineffective"),
            AttributeRule("unless", CONDITION, status="ineffective"),
        ),
        children=_BLOCK_CHILDREN,
        children_noticed=True,
    ),
    TagRule(
        "group",
        (*_IF, AttributeRule("ns"), AttributeRule("clear_params", OPTIONAL_FLAG)),
        parents=_BLOCK,
        children=_BLOCK_CHILDREN,
        children_noticed=True,
    ),
    TagRule(
        "node",
        (
            *_IF,
            AttributeRule("name", required=True),
            AttributeRule("pkg", FILLED, required=True),
            AttributeRule("type", FILLED, required=True),
            *_RUNS,
            AttributeRule("required", FLAG),
            AttributeRule("respawn", FLAG),
            AttributeRule("respawn_delay", NUMBER),
            AttributeRule("output", OUTPUT),
            AttributeRule("cwd", CWD),
            AttributeRule("clear_params", OPTIONAL_FLAG),
            AttributeRule("launch-prefix"),
        ),
        parents=_BLOCK,
        children=_NODE_CHILDREN,
        any_case=True,
        children_noticed=True,
    ),
    TagRule(
        "test",
        (
            *_IF,
            AttributeRule("test-name", required=True),
            AttributeRule("name"),
            AttributeRule("pkg", FILLED, required=True),
            AttributeRule("type", FILLED, required=True),
            *_RUNS,
            AttributeRule("time-limit", TIME_LIMIT),
            AttributeRule("retry", INTEGER),
            AttributeRule("cwd", CWD),
            AttributeRule("clear_params", OPTIONAL_FLAG),
            AttributeRule("launch-prefix"),
            AttributeRule("required", FLAG, status="ineffective"),
            *(AttributeRule(name, status="refused") for name in TEST_REFUSES),
        ),
        parents=_BLOCK,
        children=_NODE_CHILDREN,
        any_case=True,
        children_noticed=True,
    ),
    TagRule(
        "param",
        (*_IF, AttributeRule("name", required=True), AttributeRule("type", PARAM_TYPE), *(AttributeRule(name) for name in PARAM_SOURCES)),
        parents=("launch", "group", "node", "test"),
    ),
    TagRule(
        "rosparam",
        (
            *_IF,
            AttributeRule("command", COMMAND),
            AttributeRule("file"),
            AttributeRule("param"),
            AttributeRule("ns", status="deprecated", instead="param"),
            AttributeRule("subst_value", FLAG),
        ),
        parents=("launch", "group", "node", "test"),
        text=True,
    ),
    TagRule(
        "arg",
        (*_IF, AttributeRule("name", required=True), AttributeRule("default"), AttributeRule("value"), AttributeRule("doc")),
        parents=("launch", "group", "include"),
    ),
    TagRule(
        "include",
        (
            *_IF,
            AttributeRule("file", required=True),
            AttributeRule("ns"),
            AttributeRule("clear_params", OPTIONAL_FLAG),
            AttributeRule("pass_all_args", FLAG),
        ),
        parents=_BLOCK,
        children=("arg", "env"),
        any_case=True,
        children_noticed=True,
    ),
    TagRule(
        "remap",
        (*_IF, AttributeRule("from", required=True), AttributeRule("to", required=True)),
        parents=("launch", "group", "node", "test"),
    ),
    TagRule(
        "env",
        (*_IF, AttributeRule("name", NONEMPTY, required=True), AttributeRule("value", required=True)),
        parents=("launch", "group", "node", "test", "include"),
    ),
    TagRule(
        "machine",
        (
            *_IF,
            AttributeRule("name", required=True),
            AttributeRule("address", required=True),
            AttributeRule("env-loader"),
            AttributeRule("default", MACHINE_DEFAULT),
            AttributeRule("user"),
            AttributeRule("password"),
            AttributeRule("ssh-port", INTEGER),
            AttributeRule("timeout", TIMEOUT),
            AttributeRule("ros-root", status="refused", instead=_ROS_PATHS),
            AttributeRule("ros-package-path", status="refused", instead=_ROS_PATHS),
            AttributeRule("ros-ip", status="refused", instead=_ROS_PATHS),
            AttributeRule("ros-hostname", status="refused", instead=_ROS_PATHS),
        ),
        parents=_BLOCK,
        children_noticed=True,
    ),
    TagRule(
        "master",
        (AttributeRule("auto"), AttributeRule("type"), AttributeRule("uri")),
        parents=_BLOCK,
        status="defunct",
        instead="nothing: roslaunch starts a master by itself",
    ),
)

TAGS: dict[str, TagRule] = {rule.tag: rule for rule in _RULES}
"""Every tag of the dialect."""


def _owners() -> dict[str, tuple[str, ...]]:
    owners: dict[str, list[str]] = {}
    for rule in _RULES:
        if not rule.status:
            for name in rule.known:
                owners.setdefault(name, []).append(rule.tag)
    return {name: tuple(tags) for name, tags in owners.items()}


OWNERS: dict[str, tuple[str, ...]] = _owners()
"""For each attribute the tags that have it (deprecated ones included)."""


def tag_for(tag: str, parent: TagRule | None) -> TagRule | None:
    """The rule roslaunch applies to a ``<tag>`` inside ``parent``; ``None`` where the dialect does not know the tag.

    Case matters under launch and group, and does not under node, test and include (``t.tagName.lower()`` there).
    """
    return TAGS.get(tag.lower() if parent is not None and parent.any_case else tag)


# What belongs to ROS 2 (the XML front end of launch_ros) and has no meaning in ROS 1, with what ROS 1 has instead.

ROS2_TAGS: dict[str, str] = {
    "let": '<arg name="…" value="…"/>',
    "push-ros-namespace": '<group ns="…">',
    "push_ros_namespace": '<group ns="…">',
    "push-namespace": '<group ns="…">',
    "set_env": "<env>",
    "unset_env": "<env>",
    "append_env": "<env>",
    "set_parameter": "<param>",
    "set_parameters_from_file": "<rosparam>",
    "set_remap": "<remap>",
    "set_use_sim_time": '<param name="/use_sim_time" value="true"/>',
    "executable": "<node>",
    "node_container": 'a nodelet manager: <node pkg="nodelet" type="nodelet" args="manager"/>',
    "composable_node": "a nodelet",
    "load_composable_node": "a nodelet",
    "lifecycle_node": "<node>",
    "timer": "",
    "shutdown": "",
    "on_exit": "",
}
"""ROS 2 tag to the ROS 1 way, empty where there is none."""

ROS2_ATTRIBUTES: dict[str, dict[str, str]] = {
    "node": {
        "exec": "type",
        "namespace": "ns",
        "ros_args": "args",
        "respawn_max_retries": "",
        "sigterm_timeout": "",
        "sigkill_timeout": "",
        "emulate_tty": "",
    },
    "group": {"scoped": "", "forwarding": ""},
    "arg": {"description": "doc"},
    "param": {"from": "<rosparam file>"},
}
"""Tag to its ROS 2 attributes, each with the ROS 1 way (empty where there is none)."""

ROS2_SUBSTITUTIONS: dict[str, str] = {
    "var": "$(arg …)",
    "find-pkg-share": "$(find …)",
    "find-pkg-prefix": "$(find …)",
    "find-exec": "$(find …)",
    "exec-in-pkg": "$(find …)",
    "exec-in-package": "$(find …)",
    "not": "$(eval not …)",
    "and": "$(eval … and …)",
    "or": "$(eval … or …)",
    "equals": "$(eval … == …)",
    "not-equals": "$(eval … != …)",
    "if": "$(eval … if … else …)",
    "parameter": "",
    "command": "<param command>",
    "path-join": "",
    "file-content": "<param textfile>",
}
"""ROS 2 substitution to the ROS 1 way (empty where there is none); roslaunch refuses each as unknown."""
