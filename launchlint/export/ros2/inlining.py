"""What a launch of ROS 2 executes, as the actions of one file that needs no other launch file.

The file is executed as launch would; beside that, each action that is executed leaves a copy of itself with the values of that moment. An
include scopes nothing in ROS 2, so what it brings stands in its place; launch configurations are gone, with the groups that are there only
for them.
"""

from __future__ import annotations

from collections import deque

from launchlint.evaluate.ros2.actions import execute
from launchlint.evaluate.ros2.including import enter
from launchlint.evaluate.ros2.names_read import OF_LAUNCH
from launchlint.evaluate.ros2.performing import Failure, rules_of
from launchlint.evaluate.ros2.programs import Live
from launchlint.evaluate.ros2.typed import TypeFault, convert
from launchlint.evaluate.ros2.walk import Exhausted, Walk
from launchlint.evaluate.session import Read
from launchlint.export.ros2.kept import Keeper, KeepingContext
from launchlint.export.ros2.texts import asked_variables
from launchlint.export.written import CannotExport
from launchlint.named_tuple import NamedTuple
from launchlint.source import Place
from launchlint.syntax.ros2 import description as described
from launchlint.syntax.ros2.description import Condition, Description, Pair, Process, Text, TypedValue, unknown
from launchlint.yaml.tree import YamlBeyond

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable, Iterable
    from typing import Any

    from launchlint.evaluate.ros2.walk import Body, Known, Weighed
    from launchlint.evaluate.session import Session
    from launchlint.syntax.ros2.description import Action, Component

    Pairs = tuple[tuple[str, str], ...]

LARGEST_EXPORT = 16 * 1024 * 1024
"""Characters of texts in one file."""
_EFFECTS = (
    described.Let,
    described.PushNamespace,
    described.SetRemap,
    described.SetParameter,
    described.SetParametersFromFile,
    described.SetUseSimTime,
    described.SetEnvironment,
    described.UnsetEnvironment,
    described.AppendEnvironment,
    described.ResetEnvironment,
    described.Reset,
    described.SetLogDirectory,
)
"""What a group keeps to itself."""
_GONE = (described.Argument, described.Let, described.Unset)
"""What only sets launch configurations."""
_AS_IT_IS = (described.Open, described.Unsettled, described.Fails, described.ResetEnvironment)


class Inlined(NamedTuple):
    """``description`` is of one file. What an include brought is a group that is not scoped, with a place of its own: by the identity of
    this place ``included`` holds the file, and the place. ``deciding`` are the environment variables that conditions ask for, each with the
    conditions.
    """

    description: Description
    included: dict[int, tuple[str, Place]]
    deciding: dict[str, list[Place]]


def inlined(session: Session, file: str, given: Pairs, decided: frozenset[str]) -> Inlined:
    """What ``ros2 launch FILE name:=value …`` executes; ``decided`` are environment variables that are written as what they say here.

    Raises CannotExport; the file must be one that the front end reads.
    """
    known = session.reading(file)
    assert not isinstance(known, Read)
    session.arguments = given
    walk = _Inliner(session, file, decided)
    for name, value in given:
        walk.set(name, Text((value,), known.description.place), known.description.place)
    try:
        enter(walk, file, known, dict(given))
        walk.finish()
    except Exhausted:
        raise CannotExport("it includes more than can be written into one file") from None
    if walk.unread:
        files = ", ".join(sorted({session.shown(each) for each in walk.unread}))
        if not any(file.endswith(".py") for file in walk.unread):
            raise CannotExport(f"not all that {files} includes is known")
    actions = _settled(walk.actions)
    return Inlined(Description(actions, known.description.place), walk.included, walk.deciding)


class _Later(NamedTuple):
    """An action that ``make`` makes of those in it, once all of them are known."""

    make: Callable[[tuple[Action, ...]], Action]
    actions: list[Any]


class _Inliner(Walk):
    """A walk that leaves what it executes in ``actions``."""

    CONTEXT = KeepingContext
    PERFORMER = Keeper
    context: KeepingContext
    performer: Keeper

    def __init__(self, session: Session, file: str, decided: frozenset[str]) -> None:
        super().__init__(session, file, rules_of(session.distro), frozenset(), lambda _, action: self._inline(action))
        self.performer.decided = decided
        self.performer.live = lambda place: Live(self, place)
        self.actions: list[Any] = []
        self.included: dict[int, tuple[str, Place]] = {}
        self.deciding: dict[str, list[Place]] = {}
        self._size = 0
        self._bodies: deque[list[Any]] = deque()
        self._later: list[Any] = []

    # -- the walk ------------------------------------------------------------------------------------------------------

    def known(self, text: Text) -> Known:
        """As any walk; what is set to the value will be written with the same pieces."""
        found = super().known(text)
        self.context.last = None if text.literal is not None else (found.value, self.performer.pieces)
        return found

    def weigh(self, condition: Condition) -> Weighed:
        """As any walk; what the environment decides is noted."""
        weighed = super().weigh(condition)
        if weighed.outside and weighed.taken is not None:
            pieces = self.performer.pieces
            if weighed.name is not None and weighed.name in self.context.configurations:
                pieces = self.context.pieces(weighed.name)
            for name in asked_variables(pieces):
                places = self.deciding.setdefault(name, [])
                if condition.place not in places:
                    places.append(condition.place)
        return weighed

    def defer(self, kind: str, actions: tuple[Action, ...], target: Place | None = None) -> None:
        """As any walk; what will be executed belongs to the action that is executed now."""
        super().defer(kind, actions, target)
        self._bodies.append(self._later)

    def execute_later(self, body: Body) -> None:
        """As any walk."""
        self.actions, outer = self._bodies.popleft(), self.actions
        super().execute_later(body)
        self.actions = outer

    def _inline(self, action: Action) -> None:
        condition = self._condition(action.condition)
        if isinstance(action, described.Group):
            self._group(action, condition)
        elif isinstance(action, described.Include):
            self._include(action, condition)
        elif isinstance(action, described.Maybe):
            self._inside(action, lambda actions: action._replace(actions=actions, condition=condition))
        elif isinstance(action, described.Opaque):
            self._inside(action, lambda actions: _plain_group(actions, action.place, condition), splice=condition is None)
        elif isinstance(action, described.Turn):
            self._inside(action, lambda actions: _plain_group(actions, action.place, None), splice=True)
        elif isinstance(action, (described.Timer, described.Handler)):
            self._deferring(action, condition)
        elif isinstance(action, (described.Node, described.Executable)):
            self._process(action, condition)
        elif isinstance(action, _GONE):
            execute(self, action)
            self._keep_setting(action)
        elif isinstance(action, _AS_IT_IS):
            self.actions.append(action._replace(condition=condition))
            execute(self, action)
        else:
            made = self._written(action, condition)
            self._execute_asking(action)
            self.actions.append(made)

    def _execute_asking(self, action: Action) -> None:
        """Execute an action for which files of params may be read that ask for launch configurations: these have to be there."""
        asked = len(self.performer.by_content)
        execute(self, action)
        for name in dict.fromkeys(self.performer.by_content[asked:]):
            if name in self.context.configurations:
                self._emit_let(name, Text(self.context.pieces(name), action.place), action.place)

    def _inside(self, action: Action, make: Callable[[tuple[Action, ...]], Action], *, splice: bool = False) -> None:
        """Execute an action whose own ones then stand in what ``make`` makes; with ``splice`` among those around it."""
        outer, inner = self.actions, self.actions if splice else []
        self.actions = inner
        execute(self, action)
        self.actions = outer
        if not splice and inner:
            outer.append(_Later(make, inner))

    def _include(self, action: described.Include, condition: Condition | None) -> None:
        at = len(self.files)
        for pair in action.arguments:
            self._set_by_launch(pair)
        place = action.place._replace()
        self._inside(action, lambda actions: _plain_group(actions, place, condition))
        if len(self.files) > at:
            self.included[id(place)] = (self.files[at], place)

    def _group(self, action: described.Group, condition: Condition | None) -> None:
        outer: list[Any] = self.actions
        inner: list[Any] = []
        is_fresh = action.scoped is not False and action.forwarding is False
        forgets = is_fresh and self._holds_anything()
        keep = tuple(self._rewritten(each) for each in action.keep if each.name.literal in OF_LAUNCH)
        made_up = self.performer.anonymous
        self.actions = inner
        execute(self, action)
        self.actions = outer
        if action.scoped is False or not (forgets or self.performer.anonymous > made_up or keep or any(map(_has_effect, inner))):
            if condition is None:
                outer += inner
            elif inner:
                outer.append(_Later(lambda actions: _plain_group(actions, action.place, condition), inner))
        elif inner:
            outer.append(_Later(lambda actions: described.Group(actions, True, not is_fresh, keep, action.place, condition), inner))

    def _holds_anything(self) -> bool:
        """Whether there is anything that a group could forget, but launch configurations that only files read."""
        context = self.context
        return bool(
            context.remaps or context.parameters or context.environment.changes or any(name in OF_LAUNCH for name in context.configurations)
        )

    def _deferring(self, action: described.Timer | described.Handler, condition: Condition | None) -> None:
        if isinstance(action, described.Handler):
            bare: Any = action._replace(actions=(), condition=condition)
        else:
            bare = self._written(action._replace(actions=()), condition)
        self._later = []
        self.actions.append(_Later(lambda actions: bare._replace(actions=actions), self._later))
        execute(self, action)

    def _process(self, action: described.Node | described.Executable, condition: Condition | None) -> None:
        process: Process = action.process
        ends = isinstance(process.on_exit, tuple)
        made = self._written(action._replace(process=process._replace(on_exit=None if ends else process.on_exit)), condition)
        self._later = []
        self._execute_asking(action)
        if ends:
            later = self._later
            self.actions.append(_Later(lambda actions: made._replace(process=made.process._replace(on_exit=actions)), later))
        else:
            self.actions.append(made)

    # -- launch configurations that launch reads -----------------------------------------------------------------------

    def set(self, name: str, value: Text, place: Place) -> None:
        """A launch configuration is set; nothing is left of it, unless launch itself reads it."""
        if name in OF_LAUNCH:
            self._emit_let(name, value, place)

    def _emit_let(self, name: str, value: Text, place: Place) -> None:
        self.actions.append(described.Let(Text((name,), place), value, place))

    def _set_by_launch(self, pair: Pair) -> None:
        name = pair.name.literal
        if name in OF_LAUNCH:
            self.actions.append(described.Let(pair.name, self._text(pair.value), pair.place))

    def _keep_setting(self, action: described.Argument | described.Let | described.Unset) -> None:
        name = action.name if isinstance(action.name, str) else action.name.literal
        if name not in OF_LAUNCH:
            return
        if name in self.context.configurations:
            self._emit_let(name, Text(self.context.pieces(name), action.place), action.place)
        else:
            self.actions.append(described.Unset(Text((name,), action.place), action.place))

    # -- what is written -----------------------------------------------------------------------------------------------

    def _condition(self, condition: Condition | None) -> Condition | None:
        """The condition of the action that is executed, where it is not known; None where it is decided."""
        if condition is None or not self.here.conditions or not self.here.conditions[-1].assumed:
            return None
        return self._kept_condition(condition)

    def _kept_condition(self, condition: Condition) -> Condition:
        return condition._replace(operands=tuple(map(self._text, condition.operands)))

    def _written(self, action: Any, condition: Condition | None) -> Any:
        """An action with its values as they are at this moment."""
        values = zip(action._fields, action, strict=True)
        fields = {name: self._rewritten(value, listed=name == "parameters") for name, value in values if name not in _OTHERWISE}
        if isinstance(action, described.Shutdown):  # its reason is never performed
            fields["reason"] = action.reason if action.reason.literal is not None else Text((action.reason.written,), action.reason.place)
        if isinstance(action, (described.Node, described.LoadComponents)):
            judged = self.rules.loads_by_condition or isinstance(action, described.Node)
            fields["components"] = tuple(self._components(action.components, judged=judged))
        return action._replace(**fields, condition=condition)

    def _components(self, components: Iterable[Component], *, judged: bool) -> Iterable[Component]:
        for component in components:
            condition: Condition | None = None
            if component.condition is not None:
                met = self.judge(component.condition, "composable_node", component.place)
                if judged and met is None:
                    continue
                condition = self._kept_condition(component.condition) if not judged or (met is not None and met.assumed) else None
            yield self._written(component, condition)

    def _rewritten(self, value: Any, *, listed: bool = False) -> Any:
        """``value`` with its texts as they are written; ``listed``: a param in it may be a list."""
        if isinstance(value, Text):
            return self._text(value)
        if isinstance(value, Place) or not isinstance(value, tuple):
            return value
        if isinstance(value, described.Parameter) and value.value is not None and listed:
            return value._replace(name=self._text(value.name), value=self._typed(value.value))
        made = [self._rewritten(each, listed=listed) for each in value]
        return type(value)(*made) if hasattr(value, "_fields") else tuple(made)

    def _text(self, text: Text) -> Text:
        literal = text.literal
        if literal is None:
            try:
                text = self.performer.written(text)
            except Failure as failure:
                self.record(failure.problem)
                return unknown("launch stops at it", text.place)
        self._size += sum(len(piece) if isinstance(piece, str) else 1 for piece in text.pieces)
        if self._size > LARGEST_EXPORT:
            raise CannotExport(f"the exported file would be larger than {LARGEST_EXPORT // (1024 * 1024)} MiB")
        return text

    def _typed(self, value: TypedValue) -> TypedValue:
        """A value; one that is a list, written as a text, is a list."""
        if not isinstance(value.value, Text):
            return value._replace(value=tuple(map(self._text, value.value)))
        text = self._text(value.value)
        if value.plain is not None or text.literal is None or value.value.literal is not None:
            return value._replace(value=text)
        try:
            found = convert(text.literal, value.type)
        except (TypeFault, YamlBeyond):
            return value._replace(value=text)
        if isinstance(found, list) and found:
            return TypedValue(tuple(Text((str(each),), text.place) for each in found), value.type, tuple(found))
        return value._replace(value=text)


_OTHERWISE = ("condition", "components", "place")


def _plain_group(actions: tuple[Action, ...], place: Place, condition: Condition | None) -> described.Group:
    """Actions that only stand together."""
    return described.Group(actions, False, True, (), place, condition)


def _has_effect(part: Any) -> bool:
    """Whether something acts on what follows it, as far as the end of the group around it."""
    if not isinstance(part, _Later):
        return isinstance(part, _EFFECTS)
    made = part.make(())
    return (
        isinstance(made, (described.Group, described.Maybe))
        and getattr(made, "scoped", False) is False
        and any(map(_has_effect, part.actions))
    )


def _settled(parts: Iterable[Any]) -> tuple[Action, ...]:
    """All actions, with those that stand in them."""
    return tuple(part.make(_settled(part.actions)) if isinstance(part, _Later) else part for part in parts)
