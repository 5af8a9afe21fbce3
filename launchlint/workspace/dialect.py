"""Telling ROS 1 launch files from ROS 2 ones by what stands in them.

Both are XML with a ``<launch>`` root and share most of their tag names, and the same file endings are in use for both. What differs are
a few tags, attributes and substitutions that only one of the two has; the side with more of them wins, and what the package is built
for counts as well. One slip (``exec=`` written in a ROS 1 file) must never turn a file into the other dialect.
"""

from __future__ import annotations

import re

ROS1 = "ros1"
ROS2 = "ros2"

# As much as two words of a dialect: a short file with a slip or two stays what its package is for.
_PACKAGE_WEIGHT = 2

_COMMENT = re.compile(r"<!--.*?(?:-->|\Z)", re.DOTALL)
_ROOT = re.compile(r"<launch(?=[\s/>])")
_PARTS = ("group", "node", "include", "arg", "param", "rosparam", "remap", "env", "machine", "test", "master")
_START = re.compile(r"<([^\W\d][\w:.-]*)")
# What stands before the root element: declaration, processing instructions, a document type (with or without an internal part).
_PROLOG = re.compile(r"\ufeff?(?:\s+|<\?.*?\?>|<!--.*?-->|<!DOCTYPE[^\[>]*(?:\[[^\]]*\]\s*)?>)*", re.DOTALL)

_ONLY_ROS1 = re.compile(
    r"""\$\((?:find|arg|optenv)\s          # $(find pkg), $(arg name), $(optenv NAME)
    | \$\(eval\s+[^'"\s)\\]                  # $(eval expression) without quotes around the expression
    | <(?:rosparam|machine|test|master)[\s/>]
    | <(?:node|test)\s[^<>]*?\s(?:type|ns)\s*=
    | <param\s[^<>]*?\s(?:type\s*=\s*["'](?:string|double|yaml)["']|command\s*=|textfile\s*=|binfile\s*=)
    | <(?:group|include)\s[^<>]*?\b(?:ns|clear_params|pass_all_args)\s*=
    | <arg\s[^<>]*?\sdoc\s*=
    | \s(?:test-name|time-limit|subst_value)\s*=
    """,
    re.VERBOSE,
)
_ONLY_ROS2 = re.compile(
    r"""\$\((?:var|find-pkg-share|find-pkg-prefix|exec-in-pkg|exec-in-package|find-exec|command|for-var|index|not|and|or|equals)\s
    | \$\(eval\s+(?:['"]|\\|&quot;|&apos;)  # $(eval 'expression')
    | <(?:let|push[-_]ros[-_]namespace|set[-_]env|unset[-_]env|set_remap|set_parameter|set_parameters_from_file|set_use_sim_time
        |composable_node|node_container|load_composable_node|lifecycle_node|executable|timer|shutdown|log|reset|forward|append_env
        |for|ros_timer)[\s/>]
    | <node\s[^<>]*?\s(?:exec|namespace|ros_args|exec_name)\s*=
    | <param\s[^<>]*?\sfrom\s*=
    | <arg\s[^<>]*?\sdescription\s*=
    | \ssep\s*=
    """,
    re.VERBOSE,
)


def decoded(data: bytes) -> str:
    """XML text for looking at, never wrong enough to raise: by byte order mark, else as UTF-8, else as Latin-1."""
    if data.startswith((b"\xff\xfe", b"\xfe\xff")):
        return data.decode("utf-16", "replace")
    try:
        return data.decode("utf-8")
    except UnicodeDecodeError:
        return data.decode("latin-1")


def has_launch_root(data: bytes) -> bool:
    """Whether the document that starts with ``data`` has ``<launch>`` as its root element."""
    text = decoded(data)
    prolog = _PROLOG.match(text)
    return _ROOT.match(text, prolog.end() if prolog else 0) is not None


def other_root(data: bytes) -> str | None:
    """Name of the root element where the file is of another program: an Eclipse ``<launchConfiguration>``, a ``<concert>`` with a
    ``<launch>`` in it (which roslaunch would take, see roslaunch.xmlloader.XmlLoader._parse_launch).

    A root that is nearly ``launch`` is a slip, and one that is another tag of roslaunch has lost its ``<launch>``: None for these.
    """
    text = decoded(data)
    prolog = _PROLOG.match(text)
    start = _START.match(text, prolog.end() if prolog else 0)
    if start is None or start[1] == "launch":
        return None
    from launchlint.spelling import closest

    if closest(start[1], ("launch",)) is not None:
        return None
    is_part = start[1] in _PARTS and _ROOT.search(_COMMENT.sub("", text)) is None
    return None if is_part else start[1]


def dialect(data: bytes, package: str | None = None) -> str | None:
    """Which ROS the launch file with this content is for.

    Args:
        data: the whole file; it need not be well-formed.
        package: ``"ros1"`` or ``"ros2"`` where the package that holds the file is built for one of them (catkin, ament).

    Returns:
        ``"ros1"``, ``"ros2"``, or ``None`` where there is no ``<launch>`` element at all.
    """
    text = _COMMENT.sub("", decoded(data))
    if _ROOT.search(text) is None:
        return None
    ros1 = len(_ONLY_ROS1.findall(text)) + (_PACKAGE_WEIGHT if package == ROS1 else 0)
    ros2 = len(_ONLY_ROS2.findall(text)) + (_PACKAGE_WEIGHT if package == ROS2 else 0)
    return ROS1 if ros1 >= ros2 else ROS2
