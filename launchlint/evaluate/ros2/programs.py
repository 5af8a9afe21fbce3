"""What only launch files in Python have: functions that launch calls, event handlers, and what is known of a program only in part.

What is in such a function, this room does not know: it is called with the context of the moment, and gives actions.
"""

from __future__ import annotations

from launchlint.evaluate.ros2.context import Setting
from launchlint.evaluate.ros2.performing import Failure
from launchlint.evaluate.ros2.walk import Walk
from launchlint.model import Condition, Unknown
from launchlint.syntax.ros2 import description as described
from launchlint.syntax.ros2.live import Stopped
from launchlint.syntax.ros2.unresolved import unresolved

TYPE_CHECKING = False
if TYPE_CHECKING:
    from launchlint.evaluate.ros2.context import Value
    from launchlint.source import Place
    from launchlint.syntax.ros2.description import Call, Text

STEPS_PER_ACTION = 30
MOST_GIVEN = 2_000
"""Actions that one function may give."""


class Live:
    """The context of a walk at the moment of a call (a :class:`~launchlint.syntax.ros2.live.LiveContext`)."""

    def __init__(self, walk: Walk, place: Place) -> None:
        self._walk = walk
        self._place = place

    @property
    def launch(self) -> object:
        """The walk."""
        return self._walk.launch

    def spend(self, steps: int) -> None:
        """Count work. Raises Exhausted."""
        self._walk.spend(steps // STEPS_PER_ACTION, self._place)

    def perform(self, text: Text) -> Value:
        """The string that a text stands for now. Raises Stopped."""
        self._walk.spend(1, self._place)
        try:
            return self._walk.performer.perform(text)
        except Failure as failure:
            raise Stopped(failure.problem) from None

    def holds(self, condition: described.Condition) -> bool | None:
        """Whether a condition holds now; None where that is not known. Raises Stopped."""
        self._walk.spend(1, self._place)
        try:
            return self._walk.weigh(condition).taken
        except Failure as failure:
            raise Stopped(failure.problem) from None

    def configuration(self, name: str) -> Value | None:
        """A launch configuration; None where it is not set."""
        setting = self._walk.context.get(name)
        if setting is not None:
            return setting.value
        return Unknown(name, "it may be set by what is not known") if self._walk.context.unread else None

    def configurations(self) -> dict[str, Value] | None:
        """All of them; None where there may be others."""
        if self._walk.context.unread:
            return None
        return {name: setting.value for name, setting in self._walk.context.everything().items()}

    def configure(self, name: str, value: Value) -> None:
        """Set a launch configuration."""
        self._walk.spend(1, self._place)
        self._walk.context.set(name, Setting(value, self._walk.at(self._place), "let"))

    def variable(self, name: str) -> Value | None:
        """An environment variable; None where it is not set."""
        return self._walk.context.environment.get(name)

    def environment(self) -> dict[str, Value | None]:
        """What differs from the environment that launch was started with."""
        return dict(self._walk.context.environment.changes)

    def unsettle(self) -> None:
        """From here on it is not known whether launch gets any further; what fails later keeps no file from being loaded."""
        if self._walk.here.deferred is None:
            self._walk.unsettled.append(self._walk.here.file)

    def set_variable(self, name: str, value: Value | None) -> None:
        """Set an environment variable, or unset it."""
        self._walk.context.environment.set(name, value)

    def remember(self) -> None:
        """What comes of later functions in this launch hangs on this one, which therefore has to be called in each launch."""
        self._walk.remembers = True
        self._walk.context.uses.open = True


def opaque(walk: Walk, action: described.Opaque) -> None:
    """A function: what it gives is executed at once (launch.actions.OpaqueFunction)."""
    walk.execute(_called(walk, action.call, action.place))


def _called(walk: Walk, call: Call, place: Place) -> tuple[described.Action, ...]:
    walk.spend(1, place)
    try:
        found = call(Live(walk, place))
    except Stopped as stopped:
        walk.record(stopped.problem.but(origin=walk.at(stopped.problem.place)))
        return ()
    walk.unresolved += unresolved(found)
    return found[:MOST_GIVEN]


def handler(walk: Walk, action: described.Handler) -> None:
    """What an event leads to is executed later (launch.actions.RegisterEventHandler)."""
    actions = action.actions
    if not isinstance(actions, tuple):
        actions = (described.Opaque(actions, action.place),)
    walk.defer(action.event, actions, action.target)


def transition(walk: Walk, action: described.Transition) -> None:
    """What may take lifecycle nodes from one state to the next (launch_ros.actions.LifecycleTransition, launch.actions.EmitEvent)."""
    walk.transitions.append(action.place)


def maybe(walk: Walk, action: described.Maybe) -> None:
    """What may be there: what it starts may be started, and what it sets is not known behind it."""
    outer = walk.here
    met = Condition("maybe", action.place, True, action.reason)
    walk.here = outer._replace(conditions=(*outer.conditions, met), assumed=True)
    walk.doubtfully(lambda: walk.execute(action.actions), action.reason)
    walk.here = walk.here._replace(conditions=outer.conditions, assumed=outer.assumed)


def unset(walk: Walk, action: described.Unset) -> None:
    """A launch configuration is forgotten."""
    name = walk.value(action.name)
    if isinstance(name, str):
        walk.context.unset(name)


def opened(walk: Walk, action: described.Open) -> None:
    """From here on there may be more than is known."""
    walk.unread.append(walk.here.file)
    unsettled(walk, action)
    walk.context.include_unread()


def unsettled(walk: Walk, action: described.Unsettled | described.Open) -> None:
    """Whether launch gets further than this is not known; what fails later keeps no file from being loaded."""
    Live(walk, action.place).unsettle()


def fails(walk: Walk, action: described.Fails) -> None:
    """Launch stops here."""
    walk.record(action.problem.but(origin=walk.at(action.problem.place)))
