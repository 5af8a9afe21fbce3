"""Objects that a launch file in Python has made as the actions of a description."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any

from launchlint.python.values import Handle, Map, Seq, Value
from launchlint.source import Place
from launchlint.syntax.ros2 import description as described
from launchlint.syntax.ros2.description import Action, Component, Condition, Pair, Process, Remap, Text
from launchlint.syntax.ros2.python.parameters import extra_arguments, number, parameters, set_value
from launchlint.syntax.ros2.python.texts import NotUnderstood, known, pairs, text

_SOURCES = {
    "PythonLaunchDescriptionSource": (".py",),
    "XMLLaunchDescriptionSource": (".xml", ".launch"),
    "YAMLLaunchDescriptionSource": (".yaml", ".yml"),
    "AnyLaunchDescriptionSource": ("",),
    "FrontendLaunchDescriptionSource": (".xml", ".launch", ".yaml", ".yml"),
}
"""What includes load, and how the names of those files end."""
_CONDITIONS: Mapping[str, Any] = {"IfCondition": "if", "UnlessCondition": "unless"}


class Maker:
    """Makes actions of objects, each once: one object in two places is executed twice, which launch does not allow."""

    def __init__(self) -> None:
        self._made: set[int] = set()

    def actions(self, value: Value, place: Place) -> tuple[Action, ...]:
        """The actions of a list, or of a LaunchDescription in it. Raises NotUnderstood."""
        found: list[Action] = []
        for each in _listed(value, place):
            if isinstance(each, Handle) and each.kind == "LaunchDescription":
                self.once(each)
                found += self.actions(each.state["initial_entities"], each.state["place"])
            else:
                found.append(self.action(each, place))
        return tuple(found)

    def action(self, value: Value, place: Place) -> Action:
        """One action. Raises NotUnderstood."""
        if not isinstance(value, Handle) or value.kind not in _MAKE:
            raise NotUnderstood("an action that is not known", place)
        self.once(value)
        return _MAKE[value.kind](self, value.state, value.state["place"])

    def once(self, value: Handle) -> None:
        """Note that an object is used: what is used twice is executed twice. Raises NotUnderstood."""
        if id(value) in self._made:
            raise NotUnderstood("one object that is executed twice", value.state["place"])
        self._made.add(id(value))

    # -- parts ---------------------------------------------------------------------------------------------------------

    def components(self, value: Value, place: Place) -> tuple[Component, ...]:
        """Composable nodes."""
        return tuple(_component(each, place) for each in _listed(value, place))

    def process(self, given: Mapping[Any, Value], place: Place) -> Process:
        """What all processes have."""
        on_exit = given.get("on_exit")
        after: Any = None
        if on_exit is not None:
            one = on_exit.items[0] if isinstance(on_exit, Seq) and on_exit.complete and len(on_exit.items) == 1 else on_exit
            after = "shutdown" if isinstance(one, Handle) and one.kind == "Shutdown" else self.actions(on_exit, place)
        return Process(
            name=_optional(given.get("exec_name"), place),
            cwd=_optional(given.get("cwd"), place),
            prefix=_optional(given.get("prefix"), place),
            output=_optional(given.get("output"), place),
            respawn=_flag(given.get("respawn"), place),
            respawn_delay=_number(given.get("respawn_delay"), place),
            respawn_max_retries=_whole(given.get("respawn_max_retries"), place),
            sigterm_timeout=_optional(given.get("sigterm_timeout"), place),
            sigkill_timeout=_optional(given.get("sigkill_timeout"), place),
            emulate_tty=_flag(given.get("emulate_tty"), place),
            shell=_plain_flag(given.get("shell"), place),
            on_exit=after,
            environment=_given_environment(given, place),
            additional_environment=_pairs(given.get("additional_env"), place),
        )


def _given_environment(given: Mapping[Any, Value], place: Place) -> tuple[Pair, ...]:
    if given.get("env") is not None:
        raise NotUnderstood("an environment of its own", place)
    return ()


def _listed(value: Value, place: Place) -> list[Value]:
    if value is None:
        return []
    if not isinstance(value, Seq) or not value.complete:
        raise NotUnderstood("a list of which not all items are known", place)
    return value.items


def _texts(value: Value, place: Place) -> tuple[Text, ...]:
    return tuple(text(each, place) for each in _listed(value, place))


def _optional(value: Value, place: Place) -> Text | None:
    return None if value is None else text(value, place)


def _flag(value: Value, place: Place) -> Text | bool | None:
    return value if value is None or isinstance(value, bool) else text(value, place)


def _plain_flag(value: Value, place: Place) -> bool | None:
    if value is None or isinstance(value, bool):
        return value
    raise NotUnderstood("a value that is neither True nor False", place)


def _number(value: Value, place: Place) -> float | None:
    if value is None:
        return None
    if isinstance(value, (int, float)) and not isinstance(value, bool):
        return float(number(value, place))
    raise NotUnderstood("a number that is not known", place)


def _whole(value: Value, place: Place) -> int | None:
    if value is None or (isinstance(value, int) and not isinstance(value, bool)):
        return None if value is None else int(number(value, place))
    raise NotUnderstood("a number that is not known", place)


def _pairs(value: Value, place: Place) -> tuple[Pair, ...]:
    if value is None:
        return ()
    return tuple(Pair(text(name, place), text(each, place), place) for name, each in pairs(value, place))


def _remaps(value: Value, place: Place) -> tuple[Remap, ...]:
    if value is None:
        return ()
    if not isinstance(value, Seq) or not all(isinstance(each, Seq) and each.is_tuple for each in value.items):
        raise NotUnderstood("remappings that are no tuples", place)
    return tuple(Remap(text(source, place), text(target, place), place) for source, target in pairs(value, place))


def condition(given: Mapping[Any, Value]) -> Condition | None:
    """The condition of an action. Raises NotUnderstood."""
    value = given.get("condition")
    if value is None:
        return None
    if isinstance(value, Handle) and value.kind in _CONDITIONS:
        place = value.state["place"]
        return Condition(_CONDITIONS[value.kind], (text(value.state["predicate_expression"], place),), place)
    raise NotUnderstood("a condition of another kind", given["place"])


def _component(value: Value, place: Place) -> Component:
    if not isinstance(value, Handle) or value.kind != "ComposableNode":
        raise NotUnderstood("a composable node that is not known", place)
    given, place = value.state, value.state["place"]
    return Component(
        text(given["package"], place),
        text(given["plugin"], place),
        _optional(given.get("name"), place),
        _optional(given.get("namespace"), place),
        _remaps(given.get("remappings"), place),
        parameters(given.get("parameters"), place),
        extra_arguments(given.get("extra_arguments"), place),
        place,
        condition(given),
    )


def _node(maker: Maker, given: Mapping[Any, Value], place: Place) -> Action:
    return _any_node(maker, given, place, "node", ())


def _container(maker: Maker, given: Mapping[Any, Value], place: Place) -> Action:
    return _any_node(maker, given, place, "container", maker.components(given.get("composable_node_descriptions"), place))


def _lifecycle(maker: Maker, given: Mapping[Any, Value], place: Place) -> Action:
    return _any_node(maker, given, place, "lifecycle", ())


def _any_node(maker: Maker, given: Mapping[Any, Value], place: Place, kind: Any, components: tuple[Component, ...]) -> Action:
    return described.Node(
        kind,
        _optional(given.get("package"), place),
        text(given["executable"], place),
        _optional(given.get("name"), place),
        _optional(given.get("namespace"), place),
        _texts(given.get("arguments"), place),
        _texts(given.get("ros_arguments"), place),
        _remaps(given.get("remappings"), place),
        parameters(given.get("parameters"), place),
        components,
        maker.process(given, place),
        place,
        condition(given),
    )


def _argument(maker: Maker, given: Mapping[Any, Value], place: Place) -> Action:
    choices = given.get("choices")
    return described.Argument(
        known(given["name"], place),
        _optional(given.get("default_value"), place),
        given["description"] if isinstance(given.get("description"), str) else "",
        None if choices is None else tuple(known(each, place) for each in _listed(choices, place)),
        place,
        condition(given),
    )


def _let(maker: Maker, given: Mapping[Any, Value], place: Place) -> Action:
    return described.Let(text(given["name"], place), text(given["value"], place), place, condition(given))


def _group(maker: Maker, given: Mapping[Any, Value], place: Place) -> Action:
    scoped, forwarding = given.get("scoped", True), given.get("forwarding", True)
    if not isinstance(scoped, bool) or not isinstance(forwarding, bool):
        raise NotUnderstood("a value that is neither True nor False", place)
    keep = _pairs(given.get("launch_configurations"), place)
    return described.Group(maker.actions(given["actions"], place), scoped, forwarding, keep, place, condition(given))


def _include(maker: Maker, given: Mapping[Any, Value], place: Place) -> Action:
    source = given["launch_description_source"]
    if not isinstance(source, Handle) or source.kind not in _SOURCES:
        raise NotUnderstood("an include of what is not known", place)
    maker.once(source)
    file = text(source.state["launch_file_path"], source.state["place"])
    last = file.pieces[-1] if file.pieces else ""
    while not isinstance(last, str) and last.name == "path-join" and last.arguments and last.arguments[-1].pieces:
        last = last.arguments[-1].pieces[-1]
    if not isinstance(last, str) or not last.endswith(_SOURCES[source.kind]):
        raise NotUnderstood("an include of a file that its source may not be for", place)
    passed = given.get("launch_arguments")
    if isinstance(passed, Map):
        raise NotUnderstood("launch_arguments that are a dict", place)
    return described.Include(file, _pairs(passed, place), place, condition(given))


def _executable(maker: Maker, given: Mapping[Any, Value], place: Place) -> Action:
    process = maker.process(given, place)
    return described.Executable(_texts(given["cmd"], place), process, place, condition(given))


def _load(maker: Maker, given: Mapping[Any, Value], place: Place) -> Action:
    components = maker.components(given["composable_node_descriptions"], place)
    return described.LoadComponents(text(given["target_container"], place), components, place, condition(given))


def _timer(maker: Maker, given: Mapping[Any, Value], place: Place) -> Action:
    period = given["period"]
    is_number = isinstance(period, (int, float)) and not isinstance(period, bool)
    after: Text | float = float(number(period, place)) if is_number else text(period, place)
    cancel = _flag(given.get("cancel_on_shutdown"), place)
    return described.Timer(after, maker.actions(given["actions"], place), place, condition(given), cancel)


def _sim_time(maker: Maker, given: Mapping[Any, Value], place: Place) -> Action:
    raise NotUnderstood("use_sim_time for all nodes", place)


def _append(maker: Maker, given: Mapping[Any, Value], place: Place) -> Action:
    prepend = _flag(given.get("prepend", False), place)
    separator = _optional(given.get("separator"), place)
    name, value = text(given["name"], place), text(given["value"], place)
    return described.AppendEnvironment(name, value, False if prepend is None else prepend, separator, place, condition(given))


_MAKE: Mapping[str, Callable[[Maker, Mapping[Any, Value], Place], Action]] = {
    "DeclareLaunchArgument": _argument,
    "SetLaunchConfiguration": _let,
    "GroupAction": _group,
    "IncludeLaunchDescription": _include,
    "ExecuteProcess": _executable,
    "Node": _node,
    "LifecycleNode": _lifecycle,
    "ComposableNodeContainer": _container,
    "LoadComposableNodes": _load,
    "PushROSNamespace": lambda maker, given, place: described.PushNamespace(text(given["namespace"], place), place, condition(given)),
    "SetRemap": lambda maker, given, place: described.SetRemap(
        text(given["src"], place), text(given["dst"], place), place, condition(given)
    ),
    "SetParameter": lambda maker, given, place: described.SetParameter(
        text(given["name"], place), set_value(given["value"], place), place, condition(given)
    ),
    "SetParametersFromFile": lambda maker, given, place: described.SetParametersFromFile(
        text(given["filename"], place), place, condition(given)
    ),
    "SetUseSimTime": _sim_time,
    "SetEnvironmentVariable": lambda maker, given, place: described.SetEnvironment(
        text(given["name"], place), text(given["value"], place), place, condition(given)
    ),
    "UnsetEnvironmentVariable": lambda maker, given, place: described.UnsetEnvironment(text(given["name"], place), place, condition(given)),
    "AppendEnvironmentVariable": _append,
    "ResetEnvironment": lambda maker, given, place: described.ResetEnvironment(place, condition(given)),
    "LogInfo": lambda maker, given, place: described.Log(text(given["msg"], place), None, place, condition(given)),
    "Shutdown": lambda maker, given, place: described.Shutdown(text(given.get("reason", ""), place), place, condition(given)),
    "TimerAction": _timer,
    "RosTimer": _timer,
}
