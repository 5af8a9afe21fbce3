"""What rules say of launch files of ROS 2, in the words of Python: their authors know classes, and no tags.

Rules speak of XML, whose constructs have the same names in YAML; for a place in Python they are written as the classes that do the same.
"""

from __future__ import annotations

import re

from launchlint.late import late

_NAME = r"[\w/.…-]+"
_CALLS = {
    "var": "LaunchConfiguration",
    "env": "EnvironmentVariable",
    "find-pkg-share": "FindPackageShare",
    "find-pkg-prefix": "FindPackagePrefix",
    "find-exec": "FindExecutable",
    "eval": "PythonExpression",
    "command": "Command",
    "anon": "AnonName",
    "not": "NotSubstitution",
    "and": "AndSubstitution",
    "or": "OrSubstitution",
    "equals": "EqualsSubstitution",
    "param": "Parameter",
    "file-content": "FileContent",
}
_TAGS = {
    "arg": "DeclareLaunchArgument",
    "let": "SetLaunchConfiguration",
    "group": "GroupAction",
    "include": "IncludeLaunchDescription",
    "node": "Node",
    "executable": "ExecuteProcess",
    "node_container": "ComposableNodeContainer",
    "composable_node": "ComposableNode",
    "load_composable_node": "LoadComposableNodes",
    "push_ros_namespace": "PushRosNamespace",
    "set_remap": "SetRemap",
    "set_parameter": "SetParameter",
    "set_parameters_from_file": "SetParametersFromFile",
    "set_env": "SetEnvironmentVariable",
    "unset_env": "UnsetEnvironmentVariable",
    "timer": "TimerAction",
    "log": "LogInfo",
}
_PLAIN = late(r"\$\((dirname|filename)\)")
_COMPARED = late(r"\$\(eval \"'\$\(var ([\w…]+)\)' == '([\w…]+)'\"\)")
_CALL = late(rf"\$\(({'|'.join(_CALLS)}) ({_NAME})(?: ({_NAME}))?\)")
_OPEN = late(rf"\$\(({'|'.join(_CALLS)}) [^()]*…[^()]*\)")
_TAG = late(rf"</?({'|'.join(_TAGS)})(?: [^<>]*)?/?>")


def in_python(text: str) -> str:
    """``text``, which a rule says, with the classes of launch in the place of substitutions and tags."""
    if "$(" in text:
        text = _PLAIN.sub(lambda match: "ThisLaunchFileDir()" if match[1] == "dirname" else "ThisLaunchFile()", text)
        text = _COMPARED.sub(r"EqualsSubstitution(LaunchConfiguration('\1'), '\2')", text)
        text = _CALL.sub(_called, text)
        text = _OPEN.sub(lambda match: f"{_CALLS[match[1]]}(…)", text)
    return _TAG.sub(lambda match: _TAGS[match[1]], text) if "<" in text else text


def _called(match: re.Match[str]) -> str:
    name, first, second = match[1], match[2], match[3]
    words = [each if each == "…" else f"'{each}'" for each in (first, second) if each]
    if second and name == "var":
        words[1] = f"default={words[1]}"
    return f"{_CALLS[name]}({', '.join(words)})"
