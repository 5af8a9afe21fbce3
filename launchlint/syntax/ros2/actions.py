"""What was read of an entity to the action that it describes."""

from __future__ import annotations

from launchlint.syntax.ros2 import description as actions
from launchlint.syntax.ros2.description import Component, Parameter, Process, Remap, Text, TypedValue
from launchlint.syntax.ros2.fields import Fields
from launchlint.syntax.ros2.looping import FOR_EACH, FOR_LOOP
from launchlint.syntax.ros2.loops import Loop

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable
    from typing import Literal

    from launchlint.syntax.ros2.description import Action, ParameterSource


def _arg(read: Fields) -> Action | None:
    name = read.get("name", str)
    if name is None:
        return None
    choices = read.get("choice", tuple)
    given = None if choices is None else tuple(each.get("value", str) or "" for each in read.many("choice", Fields))
    return actions.Argument(name, read.text("default"), read.get("description", str) or "", given, read.place, read.condition)


def _let(read: Fields) -> Action:
    return actions.Let(read.must("name"), read.must("value"), read.place, read.condition)


def _include(read: Fields) -> Action:
    return actions.Include(read.must("file"), read.pairs("arg"), read.place, read.condition)


def _group(read: Fields) -> Action:
    scoped, forwarding = read.get("scoped", bool), read.get("forwarding", bool)
    return actions.Group(_actions(read), scoped is not False, forwarding is not False, read.pairs("keep"), read.place, read.condition)


def _executable(read: Fields) -> Action:
    return actions.Executable(read.many("cmd", Text), _process(read, read.text("name")), read.place, read.condition)


def _node(kind: Literal["node", "container"]) -> Callable[[Fields], Action]:
    def make(read: Fields) -> Action:
        return actions.Node(
            kind,
            read.text("pkg"),
            read.must("exec"),
            read.text("name"),
            read.text("namespace"),
            read.many("args", Text),
            read.many("ros_args", Text),
            _remaps(read),
            _parameters(read),
            _components(read),
            _process(read, read.text("exec_name")),
            read.place,
            read.condition,
        )

    return make


def _load(read: Fields) -> Action:
    return actions.LoadComponents(read.must("target"), _components(read), read.place, read.condition)


def _push(read: Fields) -> Action:
    return actions.PushNamespace(read.must("namespace"), read.place, read.condition)


def _set_remap(read: Fields) -> Action:
    return actions.SetRemap(read.must("from"), read.must("to"), read.place, read.condition)


def _set_parameter(read: Fields) -> Action:
    return actions.SetParameter(read.must("name"), TypedValue(read.must("value")), read.place, read.condition)


def _set_parameters(read: Fields) -> Action:
    return actions.SetParametersFromFile(read.must("filename"), read.place, read.condition)


def _use_sim_time(read: Fields) -> Action:
    return actions.SetUseSimTime(read.must("value"), read.place, read.condition)


def _set_env(read: Fields) -> Action:
    return actions.SetEnvironment(read.must("name"), read.must("value"), read.place, read.condition)


def _unset_env(read: Fields) -> Action:
    return actions.UnsetEnvironment(read.must("name"), read.place, read.condition)


def _append_env(read: Fields) -> Action:
    prepend = read.text("prepend") or read.get("prepend", bool) or False
    return actions.AppendEnvironment(read.must("name"), read.must("value"), prepend, read.text("separator"), read.place, read.condition)


def _reset_env(read: Fields) -> Action:
    return actions.ResetEnvironment(read.place, read.condition)


def _reset(read: Fields) -> Action:
    return actions.Reset(read.pairs("keep"), read.place, read.condition)


def _log_directory(read: Fields) -> Action:
    return actions.SetLogDirectory(read.must("new_log_dir"), read.place, read.condition)


def _log(read: Fields) -> Action:
    return actions.Log(read.must("message"), None, read.place, read.condition)


def _shutdown(read: Fields) -> Action:
    return actions.Shutdown(read.text("reason") or Text(("reason not given",), read.place), read.place, read.condition)


def _timer(read: Fields) -> Action:
    period = read.get("period", float)
    cancelled = read.text("cancel_on_shutdown") or read.get("cancel_on_shutdown", bool)
    return actions.Timer(read.must("period") if period is None else period, _actions(read), read.place, read.condition, cancelled)


def _loop(kind: str, over: str) -> Callable[[Fields], Action]:
    def make(read: Fields) -> Action:
        return actions.Opaque(Loop(kind, read.must(over), read.get("name", str), _actions(read), read.place), read.place, read.condition)

    return make


def _actions(read: Fields) -> tuple[Action, ...]:
    return read.get("actions", tuple) or ()


def _parameters(read: Fields) -> tuple[ParameterSource, ...]:
    return read.get("param", tuple) or ()


def _remaps(read: Fields) -> tuple[Remap, ...]:
    return tuple(Remap(each.must("from"), each.must("to"), each.place) for each in read.many("remap", Fields))


def _components(read: Fields) -> tuple[Component, ...]:
    return tuple(
        Component(
            each.must("pkg"),
            each.must("plugin"),
            each.must("name"),
            each.text("namespace"),
            _remaps(each),
            _parameters(each),
            tuple(Parameter(pair.name, TypedValue(pair.value), (), pair.place) for pair in each.pairs("extra_arg")),
            each.place,
            each.condition,
        )
        for each in read.many("composable_node", Fields)
    )


def _process(read: Fields, name: Text | None) -> Process:
    sigterm, sigkill = (_seconds(read, name) for name in ("sigterm_timeout", "sigkill_timeout"))
    return Process(
        name=name,
        cwd=read.text("cwd"),
        prefix=read.text("launch-prefix"),
        output=read.text("output"),
        respawn=read.text("respawn"),
        respawn_delay=read.get("respawn_delay", float),
        respawn_max_retries=read.get("respawn_max_retries", int),
        sigterm_timeout=sigterm,
        sigkill_timeout=sigkill,
        emulate_tty=read.get("emulate_tty", bool),
        shell=read.get("shell", bool),
        on_exit="shutdown" if read.get("on_exit", str) is not None else None,
        additional_environment=read.pairs("env"),
    )


def _seconds(read: Fields, name: str) -> Text | None:
    number = read.get(name, float)
    return None if number is None else Text((str(number),), read.place)


MAKE: dict[str, Callable[[Fields], Action | None]] = {
    "arg": _arg,
    "let": _let,
    "include": _include,
    "group": _group,
    "executable": _executable,
    "node": _node("node"),
    "node_container": _node("container"),
    "load_composable_node": _load,
    "push_ros_namespace": _push,
    "push-ros-namespace": _push,
    "set_remap": _set_remap,
    "set_parameter": _set_parameter,
    "set_parameters_from_file": _set_parameters,
    "set_use_sim_time": _use_sim_time,
    "set_env": _set_env,
    "unset_env": _unset_env,
    "append_env": _append_env,
    "reset_env": _reset_env,
    "reset": _reset,
    "set_ros_log_dir": _log_directory,
    "log": _log,
    "shutdown": _shutdown,
    "timer": _timer,
    "ros_timer": _timer,
    "for": _loop(FOR_LOOP, "len"),
    "for_each": _loop(FOR_EACH, "values"),
}
"""By the name of the tag."""
