"""Which function executes which action."""

from __future__ import annotations

from launchlint.evaluate.ros2 import components, including, nodes, processes, programs, scope_actions, setting_actions
from launchlint.evaluate.ros2.walk import Walk, tag_of
from launchlint.syntax.ros2 import description as described
from launchlint.syntax.ros2.description import Action

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable
    from typing import Any

_EXECUTE: dict[type, Callable[[Walk, Any], None]] = {
    described.Argument: setting_actions.argument,
    described.Let: setting_actions.let,
    described.Include: including.include,
    described.Group: scope_actions.group,
    described.Executable: processes.executable,
    described.Node: nodes.node,
    described.LoadComponents: components.load_components,
    described.PushNamespace: setting_actions.push_namespace,
    described.SetRemap: setting_actions.set_remap,
    described.SetParameter: setting_actions.set_parameter,
    described.SetParametersFromFile: setting_actions.set_parameters_from_file,
    described.SetUseSimTime: setting_actions.set_use_sim_time,
    described.SetEnvironment: setting_actions.set_environment,
    described.UnsetEnvironment: setting_actions.unset_environment,
    described.AppendEnvironment: setting_actions.append_environment,
    described.ResetEnvironment: scope_actions.reset_environment,
    described.ReplaceEnvironment: scope_actions.replace_environment,
    described.Push: scope_actions.push,
    described.Pop: scope_actions.pop,
    described.Reset: scope_actions.reset,
    described.SetLogDirectory: setting_actions.set_log_directory,
    described.Log: setting_actions.log,
    described.Shutdown: setting_actions.shutdown,
    described.Timer: setting_actions.timer,
    described.Handler: programs.handler,
    described.Transition: programs.transition,
    described.Opaque: programs.opaque,
    described.Turn: scope_actions.turn,
    described.Unset: programs.unset,
    described.Maybe: programs.maybe,
    described.Open: programs.opened,
    described.Unsettled: programs.unsettled,
    described.Fails: programs.fails,
}


_KEPT = frozenset((described.Include, described.Group, described.Node, described.LoadComponents, described.Opaque))
"""Actions that take long enough for it to pay to look whether it is known what comes of them."""


_STARTING = frozenset((described.Node, described.Executable))
"""Actions that start a process, which launch does once for each."""


def _is_started(walk: Walk, action: Action) -> bool:
    """Whether a process has been started by this very action, in the same file read once: launch stops (launch.actions.ExecuteLocal).

    Only objects of Python stand in two places, and only Python can give two includes one source. What waits for a process that this
    launch does not start is never executed.
    """
    if walk.here.idle:
        return False
    walk.running.add(action.place.key)
    walk.begun.append(action.place.key)
    key = (id(action), walk.here.sources)
    if key not in walk.started:
        walk.started[key] = action
        return False
    if walk.here.assumed:
        return False
    from launchlint.syntax.ros2.python.problems import ExecutedTwice

    walk.record(ExecutedTwice(origin=walk.at(action.place), refused=True, callee=tag_of(action)))
    return True


def execute(walk: Walk, action: Action) -> None:
    """Execute one action whose condition holds."""
    if type(action) in _STARTING and _is_started(walk, action):
        return
    perform = _EXECUTE[type(action)]
    if walk.repeats is None or type(action) not in _KEPT:
        perform(walk, action)
    else:
        walk.repeats.execute(walk, action, perform)
