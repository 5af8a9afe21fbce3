"""What ros2 launch would start, as JSON with the keys other tools compare."""

from __future__ import annotations

from collections.abc import Mapping
from itertools import dropwhile
from typing import Any

from launchlint.model import Condition, Executable, Include, Launch, Node, ParameterSource, Unknown
from launchlint.verdict import LOADS, Verdict


def as_object(launch: Launch, file: str, error: tuple[str, str] | None, verdict: Verdict = LOADS) -> dict[str, Any]:
    """The model as one JSON object; ``error`` is (rule ID, message) of the first reason why ros2 launch refuses the file here.

    ``verdict`` is what people are told of that: it sets apart what only this machine lacks. Keys that say nothing are left out below the
    first level.
    """
    return {
        "file": file,
        "distro": launch.distro,
        "verdict": "ok" if error is None else "error",
        "error": None if error is None else {"rule": error[0], "message": error[1]},
        "outcome": verdict.as_object(),
        "complete": launch.complete,
        "args": [
            _terse(
                {
                    "name": each.argument.name,
                    "value": _text(each.argument.value),
                    "given": each.given,
                    "has_default": each.has_default,
                    "choices": each.choices,
                    "file": each.argument.origin.place.source.file,
                }
            )
            for each in launch.declarations
        ],
        "declared": [[each.name, each.required, each.conditional] for each in launch.listed],
        "includes": [_include(each) for each in launch.includes],
        "nodes": [_component(each) if each.kind == "composable" else _node(each) for each in launch.nodes],
        "executables": [_executable(each) for each in launch.programs],
        "deferred_errors": [problem.kind for problem in launch.late],
        "findings": [],
    }


def _terse(item: Mapping[str, Any]) -> dict[str, Any]:
    return {key: value for key, value in item.items() if value not in (None, False, "", (), [], {}) or (value == 0 and value is not False)}


def _text(value: Any) -> Any:
    return value.text if isinstance(value, Unknown) else value


def _plain(value: Any) -> Any:
    """A value of a parameter as JSON can hold it."""
    if isinstance(value, Unknown):
        return value.text
    if isinstance(value, Mapping):
        return {str(_text(key)): _plain(item) for key, item in value.items()}
    if isinstance(value, (list, tuple)):
        return [_plain(item) for item in value]
    if isinstance(value, float) and (value != value or abs(value) == float("inf")):
        return repr(value)
    return value if value is None or isinstance(value, (str, bool, int, float)) else str(value)


def _conditions(conditions: tuple[Condition, ...]) -> list[list[str]]:
    return [[each.attribute, each.text] for each in conditions]


def _include(include: Include) -> dict[str, Any]:
    return _terse(
        {
            "file": include.file,
            "from": include.origin.place.source.file,
            "args": {name: _text(value) for name, value in include.arguments.items()},
            "ns": include.pushed,
            "conditions": _conditions(include.conditions),
            "deferred": include.deferred,
        }
    )


def _given(node: Node) -> dict[str, Any]:
    """What every node has."""
    return {
        "kind": node.kind,
        "package": node.package,
        "name": node.name,
        "namespace": (node.namespace.rstrip("/") or "/") if node.has_namespace else None,
        "remaps": _remaps(node),
        "file": node.file,
        "conditions": _conditions(node.conditions),
        "deferred": node.deferred,
        "parameters": None if node.own is None else {name: _typed(pair) for name, pair in node.own.items()},
    }


def _remaps(node: Node) -> list[list[str]]:
    """The rules as they stand on the command line; those in front that give the node its name or namespace are no remaps."""
    rules = [f"{remap.source}:={remap.target}" for remap in node.remaps]
    if node.kind != "composable":
        rules = list(dropwhile(lambda rule: rule.startswith(("__node:=", "__ns:=")), rules))
    return [list(rule.partition(":=")[::2]) for rule in rules]


def _typed(pair: tuple[str, Any]) -> list[Any]:
    return [pair[0], _plain(pair[1])]


def _node(node: Node) -> dict[str, Any]:
    process = node.process
    assert process is not None
    return _terse(
        {
            **_given(node),
            "executable": node.executable,
            "arguments": process.arguments,
            "ros_arguments": process.ros_arguments,
            "env": process.environment,
            "cwd": node.cwd,
            "output": node.output,
            "prefix": node.launch_prefix,
            "respawn": node.respawn,
            "respawn_delay": process.respawn_delay,
            "on_exit": process.on_exit,
            "shell": process.shell,
            "exec_name": process.label,
            "params": [_source(each) for each in node.sources],
            "rcl_error": node.fatal,
        }
    )


def _source(source: ParameterSource) -> dict[str, Any]:
    if source.rule is not None:
        return {"rule": source.rule.strip()}
    if source.file is not None:
        return {"file": source.file}
    return {"content": _plain(source.content), "of": source.of}


def _component(node: Node) -> dict[str, Any]:
    return _terse(
        {
            **_given(node),
            "plugin": node.plugin,
            "container": node.container,
            "extra_arguments": {name: _typed(pair) for name, pair in node.extra_arguments.items()},
            "condition_ignored": node.condition_ignored,
        }
    )


def _executable(program: Executable) -> dict[str, Any]:
    process = program.process
    return _terse(
        {
            "cmd": program.command,
            "name": process.label,
            "cwd": program.cwd,
            "env": process.environment,
            "output": program.output,
            "prefix": program.launch_prefix,
            "respawn": program.respawn,
            "respawn_delay": process.respawn_delay,
            "on_exit": process.on_exit,
            "shell": process.shell,
            "file": program.file,
            "conditions": _conditions(program.conditions),
            "deferred": program.deferred,
        }
    )
