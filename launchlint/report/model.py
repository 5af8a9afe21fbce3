"""What would be started: as a table for people, and as JSON with the keys other tools compare."""

from __future__ import annotations

import json
import re
from collections.abc import Mapping
from hashlib import sha1
from typing import Any

from launchlint.model import ROS2, Binary, Command, Launch, Node, ParameterSetting, Unknown
from launchlint.report.escape import visible
from launchlint.verdict import LOADS, Verdict


def as_object(launch: Launch, file: str, error: tuple[str, str] | None, verdict: Verdict = LOADS) -> dict[str, Any]:
    """The model as one JSON object; ``error`` is (rule ID, message) of the first reason why its launcher refuses the file here.

    ``verdict`` is what people are told of that: it sets apart what only this machine lacks. Each dialect has keys of its own.
    """
    if launch.dialect == ROS2:
        from launchlint.report.launched import as_object as launched

        return launched(launch, file, error, verdict)
    return {
        "file": file,
        "verdict": "ok" if error is None else "error",
        "error": None if error is None else {"rule": error[0], "message": error[1]},
        "outcome": verdict.as_object(),
        "args": dict(sorted(launch.arguments.items())),
        "nodes": [_node(node) for node in launch.nodes],
        "tests": [_test(test) for test in launch.tests],
        "params": {name: _parameter(launch.parameters[name].value) for name in sorted(launch.parameters)},
        "clear_params": [namespace for namespace, _ in launch.clear_params],
        "machines": {
            machine.name: {
                "address": machine.address,
                "assignable": machine.assignable,
                "env_loader": machine.env_loader,
                "password": machine.password is not None,
                "ssh_port": machine.ssh_port,
                "timeout": machine.timeout,
                "user": machine.user,
            }
            for machine in sorted(launch.machines.values())
        },
        "executables": [_step(*step) for step in launch.executables],
        "files": list(launch.files),
        "includes": [
            {"file": include.file, "ns": include.namespace, "from": include.origin.place.source.path,
             "args": {name: _text(value) for name, value in sorted(include.arguments.items())}}
            for include in launch.includes
        ],
        "findings": [],
    }  # fmt: skip


def _text(value: object) -> object:
    return None if isinstance(value, Unknown) else value


def _step(command: str, parameter: str, file: str) -> str:
    words = ["ros/bin/rosparam", command, *([file] if command == "dump" else []), parameter]
    return " ".join(words)


def _node(node: Node) -> dict[str, Any]:
    return {
        "name": node.name or None,
        "ns": node.namespace,
        "fqn": node.full_name if node.name else None,
        "pkg": node.package,
        "type": node.executable,
        "machine": node.machine,
        "args": node.arguments,
        "remaps": [[remap.source, remap.target] for remap in node.remaps],
        "env": [[setting.name, setting.value] for setting in node.environment],
        "output": node.output,
        "respawn": node.respawn,
        "respawn_delay": node.respawn_delay,
        "required": node.required,
        "cwd": node.cwd,
        "launch_prefix": node.launch_prefix,
        "file": node.file,
    }


def _test(test: Node) -> dict[str, Any]:
    return {**_node(test), "test_name": test.test_name, "time_limit": test.time_limit, "retry": test.retry}


def _parameter(value: Any) -> dict[str, Any]:
    if isinstance(value, Command):
        return {"type": "command", "value": value.line}
    if isinstance(value, Binary):
        return {"type": "binary", "sha1": value.sha1, "len": value.length}
    if isinstance(value, Unknown):
        return {"type": "unknown", "value": value.text}
    if isinstance(value, bool):
        return {"type": "bool", "value": value}
    if isinstance(value, int):
        return {"type": "int", "value": value}
    if isinstance(value, float):
        return {"type": "double", "value": value if value == value and abs(value) != float("inf") else repr(value)}
    if isinstance(value, str):
        return {"type": "str", "value": value}
    if value is None:
        return {"type": "null", "value": None}
    if isinstance(value, bytes):
        return {"type": "binary", "sha1": sha1(value, usedforsecurity=False).hexdigest(), "len": len(value)}
    if isinstance(value, dict):
        return {"type": "dict", "value": _plain({str(key): item for key, item in value.items()})}
    if isinstance(value, (list, tuple)):
        return {"type": "list", "value": _plain(value)}
    return {"type": type(value).__name__, "value": str(value)}


def _plain(value: Any) -> Any:
    """``value`` as JSON can hold it: NaN and infinities as words, dates and the like as text."""
    return json.loads(re.sub(r"\b(NaN|-?Infinity)\b", r'"\1"', json.dumps(value, default=str)))


def table(launch: Launch, verdict: Verdict) -> str:
    """What would be started, for people: nodes with their remaps and parameters, then the other parameters."""
    lines: list[str] = []
    if verdict.word == "refused":
        lines += [f"{verdict.launcher} refuses this file: {visible(verdict.reason)} ({verdict.rule}); what can be known of it:", ""]
    elif verdict.word == "cannot be told":
        lines += [f"whether {verdict.launcher} loads this file cannot be told here: {visible(verdict.why)}; what can be known of it:", ""]
    if verdict.elsewhere:
        lines += [visible(verdict.with_args), ""]
    lines += _programs(launch)
    own: dict[str, list[ParameterSetting]] = {}
    rest: list[ParameterSetting] = []
    private = {node.full_name + "/": node.full_name for node in (*launch.nodes, *launch.tests)}
    for name in sorted(launch.parameters):
        owner = next((private[name[: at + 1]] for at in _slashes(name) if name[: at + 1] in private), None)
        (rest if owner is None else own.setdefault(owner, [])).append(launch.parameters[name])
    for title, nodes in (("NODES", launch.nodes), ("TESTS", launch.tests)):
        if nodes:
            lines.append(title)
        for node in nodes:
            lines += _node_lines(node, own.get(node.full_name, []), launch.parameters)
        if nodes:
            lines.append("")
    if rest:
        lines += ["PARAMETERS", *(f"  {visible(setting.name)} = {_shown(setting.value)}" for setting in rest), ""]
    if launch.machines:
        lines += [
            "MACHINES",
            *(f"  {visible(machine.name)}  {visible(machine.address)}:{machine.ssh_port}" for machine in launch.machines.values()),
            "",
        ]
    if not lines:
        lines = ["nothing is started", ""]
    return "\n".join(lines)


def _programs(launch: Launch) -> list[str]:
    """What of the launch files in Python is not known, and why."""
    lines: list[str] = []
    for file in launch.followed:
        if file.state == "resolved":
            continue
        lines.append(f"{visible(file.source.path)} is known {'not at all' if file.state == 'not' else 'in part'} without running it:")
        numbered = ((place.source.position(place.span.start).line, reason) for place, reason in file.reasons)
        lines += [f"  line {line}: {visible(reason)}" for line, reason in dict.fromkeys(numbered)]
    return [*lines, ""] if lines else []


def _slashes(name: str) -> list[int]:
    return [at for at in range(len(name) - 1, 0, -1) if name[at] == "/"]


def _node_lines(node: Node, parameters: list[ParameterSetting], known: Mapping[str, ParameterSetting]) -> list[str]:
    flags = [word for word, on in (("required", node.required), ("respawn", node.respawn)) if on]
    maybe = next((str(each.text) for each in node.conditions if each.attribute == "maybe"), None)
    if maybe is not None:
        flags.append(f"maybe: {maybe}")
    if node.machine:
        flags.append(f"on {node.machine}")
    program = f"{node.package}/{node.executable}" if node.plugin is None else node.plugin
    if node.container:
        flags.append(f"in {node.container}")
    start = f"  {visible(node.full_name if node.name else node.namespace + '(anonymous)')}  {visible(program)}"
    lines = [start + (f"  [{', '.join(map(visible, flags))}]" if flags else "")]
    if node.arguments:
        lines.append(f"      args   {visible(node.arguments)}")
    lines += [f"      remap  {visible(remap.source)} -> {visible(remap.target)}" for remap in node.remaps]
    lines += [f"      env    {visible(setting.name)}={visible(setting.value)}" for setting in node.environment]
    prefix = len(node.full_name) + 1
    lines += [f"      param  ~{visible(setting.name[prefix:])} = {_shown(setting.value)}" for setting in parameters]
    lines += [f"      param  {visible(name)} = {_shown(value)}" for name, (_, value) in sorted((node.own or {}).items())]
    return lines


def _shown(value: Any) -> str:
    if isinstance(value, Command):
        return f"output of: {visible(value.line)}"
    if isinstance(value, Unknown):
        return f"unknown ({visible(value.reason)})"
    if isinstance(value, Binary):
        return f"{value.length} bytes"
    text = visible(value if isinstance(value, str) else repr(value))
    return text if len(text) <= 100 else f"{text[:97]}…"
