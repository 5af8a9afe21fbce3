"""Objects that a launch file in Python has made as the actions of a description; what is not known of them is said where it stands."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from functools import partial
from typing import Any

from launchlint.python.values import Bound, Choice, Class, Function, Handle, Instance, Partial, Seq, Unknown, Value, alternatives
from launchlint.source import Origin, Place
from launchlint.syntax.ros2 import description as described
from launchlint.syntax.ros2.description import Action, Component, Pair, Process, Remap, Substitution, Text, unknown
from launchlint.syntax.ros2.looping import FOR_EACH, FOR_LOOP
from launchlint.syntax.ros2.python.conditions import condition
from launchlint.syntax.ros2.python.parameters import extra_arguments, parameters, set_value
from launchlint.syntax.ros2.python.problems import StopsWithError
from launchlint.syntax.ros2.python.recogniser import EVENT
from launchlint.syntax.ros2.python.texts import TO_LAUNCH, Texts, pairs, why

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import TypeAlias

    Given: TypeAlias = Mapping[Any, Value]
    Calls: TypeAlias = Callable[[Value, list[Value], dict[str, Value], Place], described.Call]
    """Makes of a function and what it is called with what launch calls."""
    Loops: TypeAlias = Callable[[str, Value, Value, Place], described.Call]
    """Makes of the class of a loop, what it goes through and its function what launch calls."""

DEEPEST = 50
SOURCES = (
    "PythonLaunchDescriptionSource",
    "XMLLaunchDescriptionSource",
    "YAMLLaunchDescriptionSource",
    "AnyLaunchDescriptionSource",
    "FrontendLaunchDescriptionSource",
)
"""What includes load."""
IN_MEMORY = "LaunchDescriptionSource"
"""What holds the description itself."""
NOWHERE = "<string>"
"""Where such a description is said to be from, where nothing is said."""
_CONTEXT = Handle("context", {})
"""Stands among the arguments of a call for the context."""
_SHUTDOWN = "launch.events.Shutdown"
_EVENT = Unknown("what the event holds is known only when it happens")
_CALLABLE = (Function, Bound, Partial, Class, Instance)


_EMPTY = partial(
    StopsWithError, refused=True, error="RuntimeError", what="its source holds no launch description", stated=False, called=True,
    action="IncludeLaunchDescription",
)  # fmt: skip


def at(given: Given, name: str) -> Place:
    """Where an argument stands; the whole call where that cannot be told."""
    place: Place = given.get("places", {}).get(name, given["place"])
    return place


class Maker:
    """Makes actions of objects, each once: one object in two places gives the same action in both."""

    def __init__(self, texts: Texts, calls: Calls, loops: Loops) -> None:
        self.texts = texts
        self.calls = calls
        self.loops = loops
        self._made: dict[int, tuple[Handle, Action]] = {}
        self._files: dict[int, tuple[Handle, Text]] = {}
        self._descriptions: dict[int, tuple[Handle, described.Description]] = {}
        self._depth = 0

    def actions(self, value: Value, place: Place) -> tuple[Action, ...]:
        """The actions of a list, or of a LaunchDescription in it."""
        if value is None:
            return ()
        if self._depth > DEEPEST:
            return (described.Open("actions stand in actions without end", place),)
        self._depth += 1
        try:
            return self._actions(value, place)
        finally:
            self._depth -= 1

    def _actions(self, value: Value, place: Place) -> tuple[Action, ...]:
        found: list[Action] = []
        if isinstance(value, Instance):
            value = value.attributes.get(TO_LAUNCH, value)
        if isinstance(value, Seq):
            for each in value.items:
                found += self.actions(each, place)
            if not value.complete:
                found.append(described.Open("not all actions of a list are known", place))
        elif isinstance(value, Choice):
            for said, each in value.alternatives:
                inner = self.actions(each, place)
                if inner:
                    found.append(described.Maybe(inner, said or "it is not known which one it is", inner[0].place))
        elif isinstance(value, Handle) and value.kind == "LaunchDescription":
            found += self.actions(value.state["initial_entities"], value.state["place"])
        elif isinstance(value, Handle) and value.kind in _MAKE:
            found.append(self.action(value))
        elif isinstance(value, Handle) and value.kind in NOTHING:
            found += self._emitted(value)
        else:
            at = value.place if isinstance(value, Unknown) and value.place is not None else place
            found.append(described.Open(why(value, "an action that is not known"), at))
        return tuple(found)

    def _emitted(self, value: Handle) -> Iterator[Action]:
        """What an event does that is the same as an action; any other may be one that nodes change their state upon."""
        place, event = value.state["place"], value.state.get("event")
        if isinstance(event, Handle) and event.kind == EVENT and event.state.get("name") == _SHUTDOWN:
            yield described.Shutdown(self.texts.text("", place), place, condition(value.state, self.texts))
        elif value.kind in _TRANSITIONS:
            yield described.Transition(place, condition(value.state, self.texts))

    def action(self, value: Handle) -> Action:
        """One action."""
        known = self._made.get(id(value))
        if known is None:
            made = _MAKE[value.kind](self, value.state, value.state["place"])
            known = self._made[id(value)] = (value, made)
        return known[1]

    def file(self, source: Handle) -> Text:
        """What an include's source loads: one source gives the same text in all includes, as it reads its file once."""
        known = self._files.get(id(source))
        if known is None:
            text = self.texts.text(source.state["launch_file_path"], source.state["place"])
            known = self._files[id(source)] = (source, text)
        return known[1]

    def included(self, source: Handle, place: Place) -> described.Description:
        """What a source holds itself."""
        known = self._descriptions.get(id(source))
        if known is None:
            actions = self.actions(source.state["launch_description"], place)
            known = self._descriptions[id(source)] = (source, described.Description(actions, source.state["place"]))
        return known[1]

    # -- parts ---------------------------------------------------------------------------------------------------------

    def components(self, value: Value, place: Place) -> tuple[Component, ...]:
        """Composable nodes that are known."""
        found: list[Component] = []
        for each in value.items if isinstance(value, Seq) else []:
            sure = not isinstance(each, Choice)
            for said, one in alternatives(each):
                if isinstance(one, Handle) and one.kind == "ComposableNode":
                    made = self._component(one)
                    found.append(made if sure else made._replace(condition=described.Condition("maybe", (unknown(said, place),), place)))
        return tuple(found)

    def more_components(self, value: Value, place: Place) -> tuple[Action, ...]:
        """What says that there are composable nodes that are not known."""
        if value is None:
            return ()
        if not isinstance(value, Seq):
            return (described.Open(why(value, "composable nodes that are not known"), place),)
        odd = next((one for each in value.items for _, one in alternatives(each) if not isinstance(one, Handle)), None)
        if odd is None and value.complete:
            return ()
        return (described.Open("not all composable nodes are known" if odd is None else why(odd, "it is no composable node"), place),)

    def process(self, given: Given, place: Place) -> Process:
        """What all processes have."""
        optional = self.texts.optional
        return Process(
            name=optional(given.get("exec_name", given.get("name") if "cmd" in given else None), place),
            cwd=optional(given.get("cwd"), at(given, "cwd")),
            prefix=optional(given.get("prefix"), at(given, "prefix")),
            output=optional(given.get("output"), at(given, "output")),
            respawn=self.flag(given.get("respawn"), at(given, "respawn")),
            respawn_delay=_number(given.get("respawn_delay")),
            respawn_max_retries=_whole(given.get("respawn_max_retries")),
            sigterm_timeout=optional(given.get("sigterm_timeout"), at(given, "sigterm_timeout")),
            sigkill_timeout=optional(given.get("sigkill_timeout"), at(given, "sigkill_timeout")),
            emulate_tty=self.flag(given.get("emulate_tty"), at(given, "emulate_tty")),
            shell=given["shell"] if isinstance(given.get("shell"), bool) else None,
            on_exit=self.on_exit(given.get("on_exit"), at(given, "on_exit")),
            environment=self.pairs(given.get("env"), at(given, "env")),
            additional_environment=self.pairs(given.get("additional_env"), at(given, "additional_env")),
            replaces_environment=given.get("env") is not None,
        )

    def on_exit(self, value: Value, place: Place) -> Any:
        """What is done when a process ends."""
        if value is None:
            return None
        one = value.items[0] if isinstance(value, Seq) and value.complete and len(value.items) == 1 else value
        if isinstance(one, Handle) and one.kind == "Shutdown":
            return "shutdown"
        if isinstance(value, _CALLABLE):
            return (described.Opaque(self.calls(value, [_EVENT, _CONTEXT], {}, place), place),)
        return self.actions(value, place)

    def flag(self, value: Value, place: Place) -> Text | bool | None:
        """A truth value, or what is one when it is performed."""
        return value if value is None or isinstance(value, bool) else self.texts.text(value, place)

    def pairs(self, value: Value, place: Place) -> tuple[Pair, ...]:
        """Names with values, as far as they are known."""
        return tuple(Pair(name, each, place) for name, each in self._two_by_two(value, place, "not all of them are known"))

    def remaps(self, value: Value, place: Place) -> tuple[Remap, ...]:
        """Remaps, as far as they are known; one that is not known stands for those that are not."""
        return tuple(Remap(source, target, place) for source, target in self._two_by_two(value, place, "not all remaps are known"))

    def _two_by_two(self, value: Value, place: Place, otherwise: str) -> Iterator[tuple[Text, Text]]:
        """Two texts each, as far as they are known; at the end two that are not, for those that are not."""
        if value is None:
            return
        found, complete = pairs(value)
        for first, second in found:
            yield self.texts.text(first, place), self.texts.text(second, place)
        if not complete:
            reason = why(value, otherwise)
            yield unknown(reason, place), unknown(reason, place)

    def _component(self, value: Handle) -> Component:
        given, place = value.state, value.state["place"]
        texts = self.texts
        return Component(
            texts.text(given["package"], at(given, "package")),
            texts.text(given["plugin"], at(given, "plugin")),
            texts.optional(given.get("name"), at(given, "name")),
            texts.optional(given.get("namespace"), at(given, "namespace")),
            self.remaps(given.get("remappings"), at(given, "remappings")),
            parameters(given.get("parameters"), at(given, "parameters"), texts),
            extra_arguments(given.get("extra_arguments"), at(given, "extra_arguments"), texts),
            place,
            condition(given, texts),
        )


def _number(value: Value) -> float | None:
    return float(value) if isinstance(value, (int, float)) and not isinstance(value, bool) and abs(value) < 1e15 else None


def _whole(value: Value) -> int | None:
    return value if isinstance(value, int) and not isinstance(value, bool) and abs(value) < 1 << 31 else None


def _node(maker: Maker, given: Given, place: Place) -> Action:
    return _any_node(maker, given, place, "node", None)


def _container(maker: Maker, given: Given, place: Place) -> Action:
    return _any_node(maker, given, place, "container", given.get("composable_node_descriptions"))


def _lifecycle(maker: Maker, given: Given, place: Place) -> Action:
    made = _any_node(maker, given, place, "lifecycle", None)
    return made if given.get("autostart") in (None, False) else _with_more(made, (described.Transition(place),), place)


def _any_node(maker: Maker, given: Given, place: Place, kind: Any, components: Value) -> Action:
    texts = maker.texts
    made = described.Node(
        kind,
        texts.optional(given.get("package"), at(given, "package")),
        texts.text(given["executable"], at(given, "executable")),
        texts.optional(given.get("name"), at(given, "name")),
        texts.optional(given.get("namespace"), at(given, "namespace")),
        texts.texts(given.get("arguments"), at(given, "arguments")),
        texts.texts(given.get("ros_arguments"), at(given, "ros_arguments")),
        maker.remaps(given.get("remappings"), at(given, "remappings")),
        parameters(given.get("parameters"), at(given, "parameters"), texts),
        maker.components(components, place),
        maker.process(given, place),
        place,
        condition(given, texts),
    )
    return _with_more(made, maker.more_components(components, place), place)


def _with_more(made: Action, more: tuple[Action, ...], place: Place) -> Action:
    return described.Group((made, *more), False, True, (), place) if more else made


def _argument(maker: Maker, given: Given, place: Place) -> Action:
    name, choices = given["name"], given.get("choices")
    if not isinstance(name, str):
        return described.Open(why(name, "an argument of a name that is not known"), place)
    listed = choices.items if isinstance(choices, Seq) and choices.complete else []
    known = tuple(each for each in listed if isinstance(each, str))
    return described.Argument(
        name,
        maker.texts.optional(given.get("default_value"), at(given, "default_value")),
        given["description"] if isinstance(given.get("description"), str) else "",
        known if listed and len(known) == len(listed) else None,
        place,
        condition(given, maker.texts),
    )


def _group(maker: Maker, given: Given, place: Place) -> Action:
    scoped, forwarding = given.get("scoped", True), given.get("forwarding", True)
    keep = maker.pairs(given.get("launch_configurations"), at(given, "launch_configurations"))
    actions = maker.actions(given["actions"], place)
    made = described.Group(actions, scoped is not False, forwarding is not False, keep, place, condition(given, maker.texts))
    if isinstance(scoped, (Unknown, Choice)) or isinstance(forwarding, (Unknown, Choice)):
        return described.Group((made, described.Open("whether a group is scoped is not known", place)), False, True, (), place)
    return made


def _include(maker: Maker, given: Given, place: Place) -> Action:
    source = given["launch_description_source"]
    passed = maker.pairs(given.get("launch_arguments"), at(given, "launch_arguments"))
    when = condition(given, maker.texts)
    if isinstance(source, Handle) and source.kind == IN_MEMORY:
        if source.state.get("launch_description") is None:
            return described.Fails(_EMPTY(origin=Origin(place)), place, when)
        location = maker.texts.text(source.state.get("location", NOWHERE), place)
        return described.Include(location, passed, place, when, maker.included(source, place))
    known = isinstance(source, Handle) and source.kind in SOURCES
    file = maker.file(source) if known else maker.texts.text(source, place)
    return described.Include(file, passed, place, when)


def _executable(maker: Maker, given: Given, place: Place) -> Action:
    return described.Executable(
        maker.texts.texts(given["cmd"], at(given, "cmd")), maker.process(given, place), place, condition(given, maker.texts)
    )


def _load(maker: Maker, given: Given, place: Place) -> Action:
    components = given["composable_node_descriptions"]
    target = given["target_container"]
    if isinstance(target, Handle) and target.kind == "ComposableNodeContainer":
        text = _name_of(maker, target.state)
    else:
        text = maker.texts.text(target, place)
    made = described.LoadComponents(text, maker.components(components, place), place, condition(given, maker.texts))
    return _with_more(made, maker.more_components(components, place), place)


def _name_of(maker: Maker, given: Given) -> Text:
    """The full name of a container, which stands for it where it is given as an object."""
    place = given["place"]
    name = maker.texts.text(given["name"], at(given, "name"))
    return Text((Substitution(described.FULL_NAME, (maker.texts.text(given["namespace"], at(given, "namespace")), name), place),), place)


def _timer(maker: Maker, given: Given, place: Place) -> Action:
    number = _number(given["period"])
    period = maker.texts.text(given["period"], at(given, "period")) if number is None else number
    cancel = maker.flag(given.get("cancel_on_shutdown"), at(given, "cancel_on_shutdown"))
    return described.Timer(period, maker.actions(given["actions"], place), place, condition(given, maker.texts), cancel)


def _sim_time(maker: Maker, given: Given, place: Place) -> Action:
    value = given["value"]
    truth = value if isinstance(value, bool) else maker.texts.text(value, place)
    return described.SetUseSimTime(truth, place, condition(given, maker.texts))


def _append(maker: Maker, given: Given, place: Place) -> Action:
    texts = maker.texts
    prepend = maker.flag(given.get("prepend", False), at(given, "prepend"))
    name, value = texts.text(given["name"], at(given, "name")), texts.text(given["value"], at(given, "value"))
    separator = texts.optional(given.get("separator"), at(given, "separator"))
    return described.AppendEnvironment(name, value, False if prepend is None else prepend, separator, place, condition(given, texts))


def _opaque(maker: Maker, given: Given, place: Place) -> Action:
    arguments, keywords = given.get("args"), given.get("kwargs")
    listed = arguments.items if isinstance(arguments, Seq) else []
    named = {str(name): value for name, value in pairs(keywords)[0]} if keywords is not None else {}
    sure = (arguments is None or (isinstance(arguments, Seq) and arguments.complete)) and (keywords is None or pairs(keywords)[1])
    when = condition(given, maker.texts)
    if not sure or not isinstance(given["function"], _CALLABLE):
        reason = why(given["function"], "a function that is not looked into")
        return described.Group((described.Open(reason, place),), False, True, (), place, when)
    return described.Opaque(maker.calls(given["function"], [_CONTEXT, *listed], named, place), place, when)


def _loop(kind: str, over: str) -> Callable[[Maker, Given, Place], Action]:
    """What makes a ForLoop or ForEach, which go through the argument ``over``: a function that gives actions, as with OpaqueFunction."""

    def make(maker: Maker, given: Given, place: Place) -> Action:
        when = condition(given, maker.texts)
        if not isinstance(given["function"], _CALLABLE):
            reason = why(given["function"], "a function that is not looked into")
            return described.Group((described.Open(reason, place),), False, True, (), place, when)
        return described.Opaque(maker.loops(kind, given[over], given["function"], at(given, over)), place, when)

    return make


def _handler(maker: Maker, given: Given, place: Place) -> Action:
    handler = given["event_handler"]
    when = condition(given, maker.texts)
    if not isinstance(handler, Handle) or handler.kind not in HANDLERS:
        return described.Group((described.Open(why(handler, "an event handler that is not known"), place),), False, True, (), place, when)
    of = handler.state
    does = next((of[name] for name in HANDLERS[handler.kind] if of.get(name) is not None), None)
    actions: Any = ()
    if isinstance(does, _CALLABLE):
        actions = maker.calls(does, [_EVENT] if handler.kind == "OnProcessIO" else [_EVENT, _CONTEXT], {}, of["place"])
    elif does is not None:
        actions = maker.actions(does, of["place"])
    target = of.get("target_action")
    waits_for = target.state["place"] if isinstance(target, Handle) and target.kind in _PROCESSES else None
    return described.Handler(handler.kind, actions, place, when, waits_for)


HANDLERS: Mapping[str, tuple[str, ...]] = {
    "OnProcessExit": ("on_exit",),
    "OnProcessStart": ("on_start",),
    "OnProcessIO": ("on_stdout", "on_stderr", "on_stdin"),
    "OnShutdown": ("on_shutdown",),
    "OnExecutionComplete": ("on_completion",),
    "OnStateTransition": ("entities",),
    "EventHandler": ("entities",),
}
"""Event handlers, and which of their arguments say what they do."""
_PROCESSES = frozenset(("ExecuteProcess", "Node", "LifecycleNode", "ComposableNodeContainer"))
NOTHING = frozenset(("EmitEvent", "LifecycleTransition", "OpaqueCoroutine", "ReadyToTest", "UnregisterEventHandler"))
"""Actions that start no node and set nothing."""
_TRANSITIONS = frozenset(("EmitEvent", "LifecycleTransition", "OpaqueCoroutine"))
"""Those of them that may take lifecycle nodes from one state to the next."""


def _of(kind: Any, *roles: str) -> Callable[[Maker, Given, Place], Action]:
    """What makes an action all of whose arguments are texts."""

    def make(maker: Maker, given: Given, place: Place) -> Action:
        action: Action = kind(
            *(maker.texts.text(given.get(role, ""), at(given, role)) for role in roles), place, condition(given, maker.texts)
        )
        return action

    return make


def _set_parameter(maker: Maker, given: Given, place: Place) -> Action:
    value = set_value(given["value"], place, maker.texts)
    return described.SetParameter(maker.texts.text(given["name"], at(given, "name")), value, place, condition(given, maker.texts))


def _reset(maker: Maker, given: Given, place: Place) -> Action:
    kept = given.get("launch_configurations")
    made = described.Reset(maker.pairs(kept, at(given, "launch_configurations")), place, condition(given, maker.texts))
    if kept is None or pairs(kept)[1]:
        return made
    return described.Group((made, described.Open("which launch configurations are kept is not known", place)), False, True, (), place)


def _replace(maker: Maker, given: Given, place: Place) -> Action:
    variables = given.get("environment")
    if variables is not None and not pairs(variables)[1]:
        return described.Open("which environment variables there are from here on is not known", place)
    return described.ReplaceEnvironment(maker.pairs(variables, at(given, "environment")), place, condition(given, maker.texts))


def _log(maker: Maker, given: Given, place: Place) -> Action:
    return described.Log(maker.texts.text(given["msg"], at(given, "msg")), None, place, condition(given, maker.texts))


_MAKE: Mapping[str, Callable[[Maker, Given, Place], Action]] = {
    "DeclareLaunchArgument": _argument,
    "SetLaunchConfiguration": _of(described.Let, "name", "value"),
    "UnsetLaunchConfiguration": _of(described.Unset, "name"),
    "GroupAction": _group,
    "IncludeLaunchDescription": _include,
    "ExecuteProcess": _executable,
    "Node": _node,
    "LifecycleNode": _lifecycle,
    "ComposableNodeContainer": _container,
    "LoadComposableNodes": _load,
    "PushROSNamespace": _of(described.PushNamespace, "namespace"),
    "SetRemap": _of(described.SetRemap, "src", "dst"),
    "SetParameter": _set_parameter,
    "SetParametersFromFile": _of(described.SetParametersFromFile, "filename"),
    "SetUseSimTime": _sim_time,
    "SetEnvironmentVariable": _of(described.SetEnvironment, "name", "value"),
    "UnsetEnvironmentVariable": _of(described.UnsetEnvironment, "name"),
    "AppendEnvironmentVariable": _append,
    "PushEnvironment": lambda maker, given, place: described.Push("environment", place, condition(given, maker.texts)),
    "PopEnvironment": lambda maker, given, place: described.Pop("environment", place, condition(given, maker.texts)),
    "PushLaunchConfigurations": lambda maker, given, place: described.Push("configurations", place, condition(given, maker.texts)),
    "PopLaunchConfigurations": lambda maker, given, place: described.Pop("configurations", place, condition(given, maker.texts)),
    "ReplaceEnvironmentVariables": _replace,
    "ResetEnvironment": _of(described.ResetEnvironment),
    "ResetLaunchConfigurations": _reset,
    "SetROSLogDir": _of(described.SetLogDirectory, "new_log_dir"),
    "LogInfo": _log,
    "Shutdown": _of(described.Shutdown, "reason"),
    "TimerAction": _timer,
    "RosTimer": _timer,
    "OpaqueFunction": _opaque,
    FOR_LOOP: _loop(FOR_LOOP, "length"),
    FOR_EACH: _loop(FOR_EACH, "input_values"),
    "RegisterEventHandler": _handler,
}
