"""What ros2 launch would start, as JSON with the keys other tools compare."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from itertools import dropwhile
from typing import Any

from launchlint.model import Condition, Executable, Followed, Include, Launch, Node, ParameterSource, Process, StandIn, Unknown, UnknownText
from launchlint.verdict import LOADS, Verdict


def as_object(launch: Launch, file: str, error: tuple[str, str] | None, verdict: Verdict = LOADS) -> dict[str, Any]:
    """The model as one JSON object; ``error`` is (rule ID, message) of the first reason why ros2 launch refuses the file here.

    ``verdict`` is what people are told of that: it sets apart what only this machine lacks. Keys that say nothing are left out below the
    first level.
    """
    complete = launch.complete and not any(_maybe(each.conditions) for each in launch.includes)
    known = complete and not any(each.maybe for each in launch.declarations)
    return {
        "file": file,
        "distro": launch.distro,
        **({"distro_named_by": launch.named_by} if launch.named_by else {}),
        "verdict": "error" if error is not None else "ok" if launch.settled else "unknown",
        "error": None if error is None else {"rule": error[0], "message": error[1]},
        "outcome": verdict.as_object(),
        "complete": complete,
        "args": [
            _terse(
                {
                    "name": each.argument.name,
                    "value": _plain(each.argument.value),
                    "given": each.given,
                    "has_default": each.has_default,
                    "choices": each.choices,
                    "file": each.file or each.argument.origin.place.source.file,
                    "maybe": each.maybe,
                }
            )
            for each in launch.declarations
        ],
        "declared": [[each.name, each.required, each.conditional] for each in launch.listed] if known else None,
        "includes": [_include(each) for each in launch.includes],
        "nodes": [_component(each) if each.kind == "composable" else _node(each) for each in launch.nodes],
        "executables": [_executable(each) for each in launch.programs],
        "deferred_errors": [problem.kind for problem in launch.late],
        "findings": [],
        **({"python": [_followed(each) for each in launch.followed]} if launch.followed else {}),
    }


def _followed(file: Followed) -> dict[str, Any]:
    reasons = [{"line": place.source.position(place.span.start).line, "reason": reason} for place, reason in file.reasons]
    return {"file": file.source.path, "state": file.state, "reasons": reasons}


def _terse(item: Mapping[str, Any]) -> dict[str, Any]:
    return {key: value for key, value in item.items() if value not in (None, False, "", (), [], {}) or (value == 0 and value is not False)}


def _plain(value: Any) -> Any:
    """A value of a parameter as JSON can hold it."""
    if isinstance(value, (Unknown, UnknownText)):
        return value.text if isinstance(value, StandIn) else {"unknown": value.reason}
    if isinstance(value, Mapping):
        unknown = next((key for key in value if isinstance(key, UnknownText)), None)
        return {str(key): _plain(item) for key, item in value.items()} if unknown is None else {"unknown": unknown.reason}
    if isinstance(value, (list, tuple)):
        return [_plain(item) for item in value]
    if isinstance(value, float) and (value != value or abs(value) == float("inf")):
        return repr(value)
    return value if value is None or isinstance(value, (str, bool, int, float)) else str(value)


def _words(values: Iterable[str]) -> Any:
    """Words of a command line: how many there are is not known where one of them is not."""
    words = list(values)
    unknown = next((each for each in words if isinstance(each, UnknownText)), None)
    return words if unknown is None else {"unknown": unknown.reason}


def _conditions(conditions: tuple[Condition, ...]) -> Any:
    unknown = next((each for each in conditions if each.attribute == "unknown"), None)
    if unknown is not None:
        return _plain(unknown.text)
    return [
        [each.attribute, *([] if each.name is None else [each.name]), _plain(each.text)] for each in conditions if each.attribute != "maybe"
    ]


def _maybe(conditions: tuple[Condition, ...]) -> bool:
    return any(each.assumed for each in conditions)


def _include(include: Include) -> dict[str, Any]:
    return _terse(
        {
            "file": _plain(include.file),
            "from": include.within or include.origin.place.source.file,
            "args": _plain(include.arguments),
            "ns": _plain(include.pushed),
            "conditions": _conditions(include.conditions),
            "deferred": include.deferred,
            "maybe": _maybe(include.conditions),
        }
    )


def _given(node: Node) -> dict[str, Any]:
    """What every node has."""
    return {
        "kind": node.kind,
        "package": _plain(node.package),
        "name": _plain(node.name),
        "namespace": _namespace(node.namespace) if node.has_namespace else None,
        "remaps": {"unknown": "not all remaps are known"} if node.open_remaps else _remaps(node),
        "file": node.file,
        "conditions": _conditions(node.conditions),
        "deferred": node.deferred,
        "parameters": _own(node),
        "maybe": _maybe(node.conditions),
    }


def _namespace(namespace: str) -> Any:
    return _plain(namespace if isinstance(namespace, UnknownText) else namespace.rstrip("/") or "/")


def _own(node: Node) -> Any:
    """What it ends up with: nothing can be said of a node whose name launch does not give."""
    if node.own is None or not (node.name or node.kind == "composable"):
        return {"unknown": "not all of its params are known"} if (node.name or node.kind == "composable") and not node.fatal else None
    unknown = next((name for name in node.own if isinstance(name, UnknownText)), None)
    return {name: _typed(pair) for name, pair in node.own.items()} if unknown is None else {"unknown": unknown.reason}


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
            "executable": _plain(node.executable),
            "arguments": _words(process.arguments),
            "ros_arguments": _words(process.ros_arguments),
            "env": _environment(process),
            "cwd": _plain(node.cwd),
            "output": _plain(node.output),
            "prefix": _plain(node.launch_prefix),
            "respawn": node.respawn,
            "respawn_delay": process.respawn_delay,
            "on_exit": process.on_exit,
            "shell": process.shell,
            "exec_name": _plain(process.label),
            "params": _sources(node),
            "rcl_error": node.fatal,
        }
    )


def _environment(process: Process) -> Any:
    return {"unknown": "what was executed before may have set variables"} if process.open_environment else _plain(process.environment)


def _sources(node: Node) -> Any:
    """What it is given; a file that is not known may not be there, and then counts for nothing."""
    unknown = next((each.file for each in node.sources if isinstance(each.file, UnknownText)), None)
    return [_source(each) for each in node.sources] if unknown is None else {"unknown": unknown.reason}


def _source(source: ParameterSource) -> dict[str, Any]:
    if source.rule is not None:
        return {"rule": _plain(source.rule) if isinstance(source.rule, UnknownText) else source.rule.strip()}
    if source.file is not None:
        return _plain(source.file) if isinstance(source.file, UnknownText) else {"file": source.file}
    content = _plain(source.content)
    if source.of is None and _holds_unknown(content) and not _says_something(content):
        return {"unknown": "a value of a param is not known"}
    return {"content": content, "of": source.of}


def _holds_unknown(value: Any) -> bool:
    return isinstance(value, dict) and ("unknown" in value or any(map(_holds_unknown, value.values())))


def _says_something(value: Any) -> bool:
    """Whether something is in it but what is not known, and what may be left out since it is false or empty."""
    if isinstance(value, dict):
        return "unknown" not in value and any(map(_says_something, value.values()))
    return bool(value)


def _component(node: Node) -> dict[str, Any]:
    return _terse(
        {
            **_given(node),
            "plugin": _plain(node.plugin),
            "container": _plain(node.container),
            "extra_arguments": {name: _typed(pair) for name, pair in node.extra_arguments.items()},
            "condition_ignored": node.condition_ignored,
        }
    )


def _executable(program: Executable) -> dict[str, Any]:
    process = program.process
    return _terse(
        {
            "cmd": _words(program.command),
            "name": _plain(process.label),
            "cwd": _plain(program.cwd),
            "env": _environment(process),
            "output": _plain(program.output),
            "prefix": _plain(program.launch_prefix),
            "respawn": program.respawn,
            "respawn_delay": process.respawn_delay,
            "on_exit": process.on_exit,
            "shell": process.shell,
            "file": program.file,
            "conditions": _conditions(program.conditions),
            "deferred": program.deferred,
            "maybe": _maybe(program.conditions),
        }
    )
