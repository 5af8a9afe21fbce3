"""Actions that change the context: configurations, namespace, environment, what is set for all nodes."""

from __future__ import annotations

import os

from launchlint.evaluate.problems import InvalidNamespace, RequiredArgUnset
from launchlint.evaluate.ros2 import parameters
from launchlint.evaluate.ros2.comparing import note_choices, same_as
from launchlint.evaluate.ros2.context import NAMESPACE, Setting, Value
from launchlint.evaluate.ros2.leaving import note_namespace, note_overruled
from launchlint.evaluate.ros2.names import absolute, namespace_fault, prefixed
from launchlint.evaluate.ros2.performing import Failure
from launchlint.evaluate.ros2.problems import ChoiceRefused, NeverWorks
from launchlint.evaluate.ros2.walk import Told, Walk
from launchlint.model import Argument as Declared
from launchlint.model import Declaration, Remap, Unknown
from launchlint.syntax.problems import InvalidValue
from launchlint.syntax.ros2 import description as described
from launchlint.syntax.ros2.description import Pair, Text

TYPE_CHECKING = False
if TYPE_CHECKING:
    from launchlint.evaluate.ros2.context import How
    from launchlint.source import Origin

ENVIRONMENT_SEPARATOR = os.pathsep


def argument(walk: Walk, action: described.Argument) -> None:
    """``<arg>``: a default is performed only where nothing is set (launch.actions.DeclareLaunchArgument.execute)."""
    name, origin = action.name, walk.at(action.place)
    setting = walk.context.get(name)
    given = setting is not None
    if setting is not None:
        note_overruled(walk, action, setting)
    else:
        if action.default is None:
            if not walk.has_told((name, action.place.key)):
                walk.record(RequiredArgUnset(origin=origin, refused=True, name=name))
            told = Told(f"$(var {name})", f"the arg {name} has no value")
            setting = Setting(told, origin, "missing", frozenset((name,)), same=name, way=walk.here.way)
        else:
            value, steer, outside = walk.known(action.default)
            setting = Setting(value, origin, "default", steer | {name}, outside, name, walk.here.way)
        walk.context.set(name, setting)
    value = setting.value
    written = None if action.default is None else action.default.literal
    default = None if action.default is None else written if written is not None else Unknown(action.default.place.text, "it is computed")
    in_group = walk.here.scope is not None and walk.here.scope.kind == "group"
    note_choices(walk.performer, name, action.choices)
    if action.choices is not None and isinstance(value, str) and value not in action.choices:
        walk.record(ChoiceRefused(origin=origin, refused=True, name=name, value=value, choices=action.choices, given=given))
    walk.declared.append(
        Declaration(
            Declared(name, value, default, origin, False, in_group),
            given,
            action.default is not None,
            action.choices,
            walk.here.assumed,
            walk.here.file,
        )
    )


def let(walk: Walk, action: described.Let) -> None:
    """``<let>``."""
    configure(walk, Pair(action.name, action.value, action.place))


def configure(walk: Walk, pair: Pair, *, passed: tuple[int, ...] | None = None) -> tuple[str, Value] | None:
    """Set a launch configuration (launch.actions.SetLaunchConfiguration); its name and value, None where the name is not known.

    ``passed`` is the way to the file that it is passed to, if it is.
    """
    value, steer, outside = walk.known(pair.value)
    name = walk.value(pair.name)
    if isinstance(name, Unknown):
        return None
    how: How = "let" if passed is None else "passed"
    origin: Origin | None = walk.at(pair.place)
    way = walk.here.way if passed is None else passed
    before = walk.context.get(name)
    if passed is not None and before is not None and before.value == value and not before.is_left_at(walk.here.way):
        origin, way = before.origin, before.way  # it would have it anyway
    walk.context.set(name, Setting(value, origin, how, steer, outside, same_as(walk.performer, pair.value), way))
    return name, value


def push_namespace(walk: Walk, action: described.PushNamespace) -> None:
    """``<push_ros_namespace>``: there is no way to pop it but the end of a group (launch_ros.actions.PushROSNamespace)."""
    pushed, steer, outside = walk.known(action.namespace)
    before = walk.context.namespace
    note_namespace(walk, pushed, action.place)
    after: Value
    if isinstance(pushed, Unknown) or isinstance(before, Unknown):
        unknown = pushed if isinstance(pushed, Unknown) else before
        after = Unknown(pushed if isinstance(pushed, str) else pushed.text, unknown.reason if isinstance(unknown, Unknown) else "")
    else:
        joined = absolute(prefixed(before, pushed)) or "/"
        after = joined
        if namespace_fault(joined):
            walk.record(InvalidNamespace(origin=walk.at(action.namespace.place), refused=True, namespace=pushed, private=False))
            after = Told(pushed, "it is no namespace")
    walk.context.set(NAMESPACE, Setting(after, walk.at(action.place), "namespace", steer, outside, way=walk.here.way))
    scope = walk.here.scope
    if scope is not None and isinstance(after, str):
        walk.here = walk.here._replace(scope=scope._replace(namespace=after.rstrip("/") + "/"))


def set_remap(walk: Walk, action: described.SetRemap) -> None:
    """``<set_remap>``: added to one list, which is made in the scope of the first (launch_ros.actions.SetRemap)."""
    remap = remapping(walk, described.Remap(action.source, action.target, action.place))
    if walk.context.remaps is None:
        walk.context.remaps = []
    walk.context.remaps.append(remap)
    walk.set_remaps.append((remap, walk.here.conditions))


def remapping(walk: Walk, remap: described.Remap) -> Remap:
    """A rule with both sides performed, the source first."""
    source, target = walk.value(remap.source), walk.value(remap.target)
    if isinstance(source, str) and isinstance(target, str):
        return Remap(source, target, walk.at(remap.place))
    patterns = tuple(side if isinstance(side, str) else side.pattern for side in (source, target))
    return Remap("", "", walk.at(remap.place), (patterns[0], patterns[1]))


def set_parameter(walk: Walk, action: described.SetParameter) -> None:
    """``<set_parameter>``."""
    try:
        made = parameters.set_parameter(action, walk.performer)
    except Failure as failure:
        walk.record(failure.problem)
        return
    if walk.context.parameters is None:
        walk.context.parameters = []
    walk.context.parameters.append(made)


def set_parameters_from_file(walk: Walk, action: described.SetParametersFromFile) -> None:
    """``<set_parameters_from_file>``: whether the file is there is seen when the first node after it is started."""
    file = walk.value(action.file)
    if walk.context.parameters is None:
        walk.context.parameters = []
    walk.context.parameters.append(parameters.GlobalFile(file, walk.at(action.file.place)))


def set_use_sim_time(walk: Walk, action: described.SetUseSimTime) -> None:
    """``<set_use_sim_time>``: what XML and YAML give to it is never the boolean that it wants."""
    if isinstance(action.value, Text):
        walk.record(NeverWorks(origin=walk.at(action.place), refused=True, tag="set_use_sim_time"))


def set_environment(walk: Walk, action: described.SetEnvironment) -> None:
    """``<set_env>``."""
    name, value = walk.value(action.name), walk.value(action.value)
    if isinstance(name, str):
        walk.context.environment.set(name, value)


def unset_environment(walk: Walk, action: described.UnsetEnvironment) -> None:
    """``<unset_env>``: not an error where it is not set."""
    name = walk.value(action.name)
    if isinstance(name, str):
        walk.context.environment.set(name, None)


def append_environment(walk: Walk, action: described.AppendEnvironment) -> None:
    """``<append_env>``: appended or prepended, with a separator; only set where the variable is not set yet."""
    name, value = walk.value(action.name), walk.value(action.value)
    prepend: bool | None = action.prepend if isinstance(action.prepend, bool) else truth(walk, action.prepend, "append_env", "prepend")
    separator = ENVIRONMENT_SEPARATOR if action.separator is None else walk.value(action.separator)
    if isinstance(name, Unknown):
        return
    before = walk.context.environment.get(name)
    after: Value = value
    if before is not None:
        parts = (value, separator, before) if prepend else (before, separator, value)
        if prepend is not None and all(isinstance(part, str) for part in parts):
            after = "".join(part for part in parts if isinstance(part, str))
        else:
            after = Unknown("", "a part of it is not known")
    walk.context.environment.set(name, after)


def truth(walk: Walk, text: Text, tag: str, attribute: str) -> bool | None:
    """What the text of an attribute means that has to be a truth value; None where that is not known, or none (which is recorded)."""
    value = walk.value(text)
    if isinstance(value, Unknown):
        return None
    known = walk.performer.boolean(value)
    if known is None:
        walk.record(
            InvalidValue(
                origin=walk.at(text.place),
                refused=True,
                tag=tag,
                attribute=attribute,
                value=value,
                expected="true or false",
                choices=("true", "false"),
            )
        )
    return known


def set_log_directory(walk: Walk, action: described.SetLogDirectory) -> None:
    """``<set_ros_log_dir>``: below the directory of before, unless it is absolute."""
    directory = walk.value(action.directory)
    environment = walk.context.environment
    before = environment.get("ROS_LOG_DIR")
    if before is None:
        home = environment.get("HOME")
        before = f"{home}/.ros/log" if isinstance(home, str) else Unknown("", "the log directory is made at the start")
    known = isinstance(directory, str) and isinstance(before, str)
    environment.set("ROS_LOG_DIR", os.path.join(before, directory) if known else directory)  # type: ignore[arg-type]


def log(walk: Walk, action: described.Log) -> None:
    """``<log>``."""
    walk.value(action.message)


def shutdown(walk: Walk, action: described.Shutdown) -> None:
    """``<shutdown>``: an event like any other, so that what follows is still executed; its reason is never performed."""


def timer(walk: Walk, action: described.Timer) -> None:
    """``<timer>`` and ``<ros_timer>``: the actions in it are executed later."""
    walk.defer("timer", action.actions)
