"""How rules call what launch of ROS 2 knows, in the words of the file they speak of: tags in XML, keys in YAML, classes in Python.

A rule asks for the words of the place it tells of, and puts them into its sentences: no sentence is written first and translated later.
"""

from __future__ import annotations

from launchlint.named_tuple import NamedTuple
from launchlint.source import Origin, Place

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Literal, TypeAlias

    Language: TypeAlias = Literal["xml", "yaml", "python"]

_CALLS = {
    "var": "LaunchConfiguration",
    "env": "EnvironmentVariable",
    "find-pkg-share": "FindPackageShare",
    "find-pkg-prefix": "FindPackagePrefix",
    "find-exec": "FindExecutable",
    "exec-in-pkg": "ExecutableInPackage",
    "eval": "PythonExpression",
    "command": "Command",
    "anon": "AnonName",
    "not": "NotSubstitution",
    "and": "AndSubstitution",
    "or": "OrSubstitution",
    "any": "AnySubstitution",
    "all": "AllSubstitution",
    "if": "IfElseSubstitution",
    "equals": "EqualsSubstitution",
    "not-equals": "NotEqualsSubstitution",
    "param": "Parameter",
    "file-content": "FileContent",
    "dirname": "ThisLaunchFileDir",
    "filename": "ThisLaunchFile",
    "log_dir": "LaunchLogDir",
    "launch_log_dir": "LaunchLogDir",
}
_TAGS = {
    "arg": "DeclareLaunchArgument",
    "let": "SetLaunchConfiguration",
    "group": "GroupAction",
    "keep": "launch_configurations",
    "include": "IncludeLaunchDescription",
    "node": "Node",
    "executable": "ExecuteProcess",
    "node_container": "ComposableNodeContainer",
    "composable_node": "ComposableNode",
    "load_composable_node": "LoadComposableNodes",
    "param": "param",
    "push_ros_namespace": "PushRosNamespace",
    "set_remap": "SetRemap",
    "set_parameter": "SetParameter",
    "set_parameters_from_file": "SetParametersFromFile",
    "set_env": "SetEnvironmentVariable",
    "unset_env": "UnsetEnvironmentVariable",
    "timer": "TimerAction",
    "log": "LogInfo",
}
_ANY = "…"


class Words(NamedTuple):
    """The words of one language in which launch files of ROS 2 are written."""

    language: Language

    def call(self, command: str, *words: str) -> str:
        """A substitution: ``$(env HOME)``, or ``EnvironmentVariable('HOME')``."""
        if self.language != "python":
            return f"$({' '.join((command, *words))})"
        quoted = [each if each == _ANY else f"'{each}'" for each in words]
        if len(words) == 2 and command == "var":
            quoted[1] = f"default={quoted[1]}"
        return f"{_CALLS.get(command, command)}({', '.join(quoted)})"

    def under(self, command: str, word: str, path: str) -> str:
        """A path below what a substitution stands for."""
        if self.language != "python":
            return f"{self.call(command, *([word] if word else []))}/{path}"
        pieces = [self.call(command, *([word] if word else [])), *(f"'{each}'" if each != _ANY else each for each in path.split("/"))]
        return f"PathJoinSubstitution([{', '.join(pieces)}])"

    def equals(self, name: str, value: str) -> str:
        """A comparison of an arg with a text."""
        if self.language != "python":
            return f"$(eval \"'$(var {name})' == '{value}'\")"
        return f"EqualsSubstitution({self.call('var', name)}, '{value}')"

    def tag(self, name: str) -> str:
        """An action by its name: ``<group>``, ``group``, ``GroupAction``."""
        return _TAGS[name] if self.language == "python" else name if self.language == "yaml" else f"<{name}>"

    def written(self, tag: str, attributes: dict[str, str], in_python: str) -> str:
        """An action as it would stand in the file; for Python it is given."""
        if self.language == "python":
            return in_python
        if self.language == "yaml":
            return f"{tag}: {{{', '.join(f'{name}: {_scalar(value)}' for name, value in attributes.items())}}}"
        return f"<{tag} {' '.join(f'{name}={chr(34)}{value}{chr(34)}' for name, value in attributes.items())}/>"

    def set_to(self, attribute: str, value: str) -> str:
        """An attribute with its value: ``name="talker"``, ``name: talker``, ``name='talker'``."""
        if self.language == "yaml":
            return f"{attribute}: {_scalar(value)}"
        return f"{attribute}='{value}'" if self.language == "python" else f'{attribute}="{value}"'

    def remap(self, source: str, target: str) -> str:
        """The other name of a remap: ``to="x"``, or the whole pair in Python."""
        return f"('{source}', '{target}')" if self.language == "python" else self.set_to("to", target)

    def declared(self, name: str) -> str:
        """The declaration of an arg."""
        return self.written("arg", {"name": name}, f"DeclareLaunchArgument('{name}')")

    def passed_on(self, name: str) -> str:
        """What hands an arg on to an included file under the same name."""
        return self.written("arg", {"name": name, "value": f"$(var {name})"}, f"('{name}', LaunchConfiguration('{name}'))")


def words_at(where: Origin | Place) -> Words:
    """The words of the file that ``where`` is in."""
    return words_of((where.place if isinstance(where, Origin) else where).source.path)


def words_of(path: str) -> Words:
    """The words of the launch file at ``path``."""
    return Words("python" if path.endswith(".py") else "yaml" if path.endswith((".yaml", ".yml")) else "xml")


def _scalar(value: str) -> str:
    """``value`` as YAML has to write it for launch, which wants a text: what would be another thing stands in quotes."""
    return f"'{value}'" if value in ("true", "false") or not value or not value.strip("0123456789.") else value


SHARED = "other programs are given the file, too: one of them may make a node of that name beside its own"
"""Of a parameter file in which nothing is for the node that it is given to."""
