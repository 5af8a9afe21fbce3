"""Actions that keep what is set and put it back, or forget it: groups, and what a program may do by itself."""

from __future__ import annotations

from launchlint.evaluate.ros2.context import Setting
from launchlint.evaluate.ros2.problems import NothingToPop
from launchlint.evaluate.ros2.setting_actions import configure
from launchlint.evaluate.ros2.walk import Walk
from launchlint.model import Scope
from launchlint.syntax.ros2 import description as described
from launchlint.syntax.ros2.description import Pair

TYPE_CHECKING = False
if TYPE_CHECKING:
    from launchlint.evaluate.ros2.context import Value

KEPT_PER_ACTION = 5
"""How many configurations and variables that a program keeps by itself count as one more action: it may do that without end."""


def group(walk: Walk, action: described.Group) -> None:
    """``<group>``: what is kept is evaluated inside (launch.actions.GroupAction)."""
    context, outer = walk.context, walk.here
    scoped = action.scoped is not False  # a text is always true to launch, whatever it says
    namespace = context.namespace
    below = namespace.rstrip("/") + "/" if isinstance(namespace, str) else "/"
    walk.here = outer._replace(scope=Scope("group", walk.at(action.place), below, outer.scope))
    if scoped:
        walk.spend_on_inherited(action.place)
        context.push()
    if scoped and action.forwarding is False:
        context.environment.restore({})
        forget(walk, action.keep)
    else:
        for pair in action.keep:
            configure(walk, pair)
    walk.execute(action.actions)
    if scoped:
        _taken_off(walk, context.pop(), action)
    walk.here = outer


def reset(walk: Walk, action: described.Reset) -> None:
    """``<reset>``."""
    forget(walk, action.keep)


def forget(walk: Walk, keep: tuple[Pair, ...]) -> None:
    """Forget all launch configurations but those of ``keep``, which are evaluated before."""
    kept: dict[str, Setting] = {}
    for pair in keep:
        name = walk.value(pair.name)
        value, steer, outside = walk.known(pair.value)
        if isinstance(name, str):
            kept[name] = Setting(value, walk.at(pair.place), "kept", steer, outside, way=walk.here.way)
    walk.context.forget(kept)


def reset_environment(walk: Walk, action: described.ResetEnvironment) -> None:
    """``<reset_env>``: as it was when launch was started."""
    walk.context.environment.restore({})


def replace_environment(walk: Walk, action: described.ReplaceEnvironment) -> None:
    """Nothing is left of the environment but what is given, which is worked out before (launch.actions.ReplaceEnvironmentVariables)."""
    given: dict[str, Value | None] = {}
    for pair in action.variables:
        name, value = walk.value(pair.name), walk.value(pair.value)
        if isinstance(name, str):
            given[name] = value
    walk.context.environment.restore({**dict.fromkeys(walk.session.environment), **given})


def push(walk: Walk, action: described.Push) -> None:
    """The environment or the launch configurations are kept (launch.actions.PushEnvironment, PushLaunchConfigurations)."""
    context = walk.context
    context.uses.open = True
    is_environment = action.what == "environment"
    walk.spend(len(context.environment.changes if is_environment else context.configurations) // KEPT_PER_ACTION, action.place)
    if is_environment:
        context.push_environment()
    else:
        context.push_configurations()


def pop(walk: Walk, action: described.Pop) -> None:
    """Those that were kept last are put back (launch.actions.PopEnvironment, PopLaunchConfigurations)."""
    context = walk.context
    context.uses.open = True
    _taken_off(walk, context.pop_environment() if action.what == "environment" else context.pop_configurations(), action)


def turn(walk: Walk, action: described.Turn) -> None:
    """One turn of a loop: what is in force beside the launch configurations is put back at its end (launch.LaunchContext._pop_locals)."""
    context = walk.context
    directory, file = context.place()
    context.turning.append(walk.here.step)
    walk.execute(action.actions)
    context.turning.pop()
    context.enter(directory, file)


def _taken_off(walk: Walk, done: bool | None, action: described.Pop | described.Group) -> None:
    """Launch stops where nothing is kept that could be put back; ``done``: whether there was, None where that is not known. What is not
    read may keep something, too.
    """
    if done is False and not walk.unread:
        what = action.what if isinstance(action, described.Pop) else ""
        walk.record(NothingToPop(origin=walk.at(action.place), refused=True, what=what))
    elif not done and walk.here.deferred is None:
        walk.unsettled.append(walk.here.file)
