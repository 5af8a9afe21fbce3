"""Actions back to what is said of them in a launch file: by the names of attributes and of inner tags.

The other way round is :mod:`launchlint.syntax.ros2.actions`. What each tag takes, and of which kind that is, stands in
:mod:`launchlint.syntax.ros2.tables`.
"""

from __future__ import annotations

from launchlint.named_tuple import NamedTuple
from launchlint.syntax.ros2 import description as described
from launchlint.syntax.ros2.description import Pair, Process, Remap
from launchlint.syntax.ros2.looping import FOR_LOOP
from launchlint.syntax.ros2.loops import Loop, is_loop

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable, Iterable, Mapping
    from typing import Any

    from launchlint.source import Place
    from launchlint.syntax.ros2.description import Action, Component, Condition, ParameterSource

    Values = Mapping[str, Any]


class Said(NamedTuple):
    """One tag.

    ``values`` are by the name of the attribute, None where it is not given; ``inner`` are the tags with a name of their own, by it;
    ``params`` and ``actions`` stand in it, too.
    """

    tag: str
    place: Place
    values: Values
    condition: Condition | None = None
    inner: Mapping[str, tuple[Said, ...]] = {}
    params: tuple[ParameterSource, ...] = ()
    actions: tuple[Action, ...] = ()


def said(action: Action) -> Said:
    """What a launch file says of ``action``."""
    tag, values, inner, params, actions = _SAY[type(action)](action)
    return Said(tag, action.place, values, action.condition, inner, params, actions)


_Found = tuple[str, "Values", "Mapping[str, tuple[Said, ...]]", "tuple[ParameterSource, ...]", "tuple[Action, ...]"]


def _plain(tag: str, **values: object) -> _Found:
    return tag, values, {}, (), ()


def _arg(action: described.Argument) -> _Found:
    values = {"name": action.name, "default": action.default, "description": action.description or None}
    choices = tuple(Said("choice", action.place, {"value": each}) for each in action.choices or ())
    return "arg", values, {"choice": choices}, (), ()


def _include(action: described.Include) -> _Found:
    return "include", {"file": action.file}, {"arg": _pairs("arg", action.arguments)}, (), ()


def _group(action: described.Group) -> _Found:
    values = {"scoped": action.scoped is not False and None, "forwarding": action.forwarding is not False and None}
    return "group", values, {"keep": _pairs("keep", action.keep)}, (), action.actions


def _executable(action: described.Executable) -> _Found:
    values = {"cmd": action.command, "name": action.process.name, **_process(action.process)}
    return "executable", values, {"env": _pairs("env", action.process.additional_environment)}, (), ()


def _node(action: described.Node) -> _Found:
    values = {
        "pkg": action.package,
        "exec": action.executable,
        "name": action.name,
        "namespace": action.namespace,
        "exec_name": action.process.name,
        "args": action.arguments or None,
        "ros_args": action.ros_arguments or None,
        **_process(action.process),
    }
    inner = {
        "env": _pairs("env", action.process.additional_environment),
        "remap": _remaps(action.remaps),
        "composable_node": _components(action.components),
    }
    return ("node_container" if action.kind == "container" else "node"), values, inner, action.parameters, ()


def _load(action: described.LoadComponents) -> _Found:
    return "load_composable_node", {"target": action.target}, {"composable_node": _components(action.components)}, (), ()


def _set_parameter(action: described.SetParameter) -> _Found:
    return _plain("set_parameter", name=action.name, value=action.value.value)


def _append(action: described.AppendEnvironment) -> _Found:
    prepend = None if action.prepend is False else action.prepend
    return _plain("append_env", name=action.name, value=action.value, prepend=prepend, separator=action.separator)


def _timer(action: described.Timer) -> _Found:
    return "timer", {"period": action.period, "cancel_on_shutdown": action.cancel_on_shutdown}, {}, (), action.actions


def _process(process: Process) -> Values:
    return {
        "cwd": process.cwd,
        "launch-prefix": process.prefix,
        "output": process.output,
        "respawn": process.respawn,
        "respawn_delay": process.respawn_delay,
        "respawn_max_retries": process.respawn_max_retries,
        "sigterm_timeout": process.sigterm_timeout,
        "sigkill_timeout": process.sigkill_timeout,
        "emulate_tty": process.emulate_tty,
        "shell": process.shell,
        "on_exit": process.on_exit,
    }


def _pairs(tag: str, pairs: Iterable[Pair]) -> tuple[Said, ...]:
    return tuple(Said(tag, each.place, {"name": each.name, "value": each.value}) for each in pairs)


def _remaps(remaps: Iterable[Remap]) -> tuple[Said, ...]:
    return tuple(Said("remap", each.place, {"from": each.source, "to": each.target}) for each in remaps)


def _components(components: Iterable[Component]) -> tuple[Said, ...]:
    return tuple(
        Said(
            "composable_node",
            each.place,
            {"pkg": each.package, "plugin": each.plugin, "name": each.name, "namespace": each.namespace},
            each.condition,
            {
                "remap": _remaps(each.remaps),
                "extra_arg": tuple(
                    Said("extra_arg", extra.place, {"name": extra.name, "value": None if extra.value is None else extra.value.value})
                    for extra in each.extra_arguments
                ),
            },
            each.parameters,
        )
        for each in components
    )


def _loop(action: described.Opaque) -> _Found:
    loop = action.call
    assert isinstance(loop, Loop)
    if loop.kind == FOR_LOOP:
        return "for", {"name": loop.name, "len": loop.over}, {}, (), loop.actions
    return "for_each", {"values": loop.over}, {}, (), loop.actions


_SAY: Mapping[type, Callable[[Any], _Found]] = {
    described.Argument: _arg,
    described.Let: lambda action: _plain("let", name=action.name, value=action.value),
    described.Include: _include,
    described.Group: _group,
    described.Executable: _executable,
    described.Node: _node,
    described.LoadComponents: _load,
    described.PushNamespace: lambda action: _plain("push_ros_namespace", namespace=action.namespace),
    described.SetRemap: lambda action: _plain("set_remap", **{"from": action.source, "to": action.target}),
    described.SetParameter: _set_parameter,
    described.SetParametersFromFile: lambda action: _plain("set_parameters_from_file", filename=action.file),
    described.SetEnvironment: lambda action: _plain("set_env", name=action.name, value=action.value),
    described.UnsetEnvironment: lambda action: _plain("unset_env", name=action.name),
    described.AppendEnvironment: _append,
    described.ResetEnvironment: lambda action: _plain("reset_env"),
    described.Reset: lambda action: ("reset", {}, {"keep": _pairs("keep", action.keep)}, (), ()),
    described.SetLogDirectory: lambda action: _plain("set_ros_log_dir", new_log_dir=action.directory),
    described.Log: lambda action: _plain("log", message=action.message),
    described.Shutdown: lambda action: _plain("shutdown", reason=action.reason),
    described.Timer: _timer,
    described.Opaque: _loop,
}
"""By the class of the action. ``SetUseSimTime`` is not among them: the front ends cannot make it."""
_SAYABLE = frozenset(_SAY)


def is_sayable(action: Action) -> bool:
    """Whether a declarative launch file can hold the action: a loop, but no function of a program."""
    return is_loop(action) if isinstance(action, described.Opaque) else type(action) in _SAYABLE
