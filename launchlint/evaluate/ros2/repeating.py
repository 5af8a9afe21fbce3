"""What executing an action came to, for the next configuration of the same entry file: most of a launch is the same in all of them.

All that an action can depend on is compared: where the walk is, what is in force, and of the rest what was read before it was set. Where
all of it is equal once more, what came of the action is taken over, and nothing of it is executed.
"""

from __future__ import annotations

from typing import Any

from launchlint.evaluate.problems import UndeclaredArg
from launchlint.evaluate.ros2.context import Setting, Uses
from launchlint.evaluate.ros2.listing import Listings
from launchlint.model import Unknown
from launchlint.named_tuple import NamedTuple
from launchlint.source import IncludeStep, Place

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable, Mapping, Set

    from launchlint.evaluate.ros2.context import Value
    from launchlint.evaluate.ros2.executed_files import ExecutedFiles
    from launchlint.evaluate.ros2.parameters import GlobalSource
    from launchlint.evaluate.ros2.walk import Here, Walk
    from launchlint.model import Remap
    from launchlint.problem import Problem
    from launchlint.syntax.ros2.description import Action, Component

    Logs = tuple[list[Any], ...]
    """What the walk collects, in the order in which it comes."""
    Saying = tuple[tuple[object, ...] | None, Problem]
    Said = list[Saying]
    Key = tuple[int, tuple[int, ...], tuple[object, ...]]
    """An action, and the includes that lead to it: each by its identity; and what it is executed with."""
    Performed = Action | Component

_NOTHING: frozenset[tuple[str, tuple[str, int]]] = frozenset()
MOST_KEPT = 6
"""Outcomes of one action; the oldest goes first."""


class Situation(NamedTuple):
    """What an action depends on, but for launch configurations, ``$(dirname)`` and what has been told.

    ``remaps`` and ``parameters`` are None where there is no list, ``leaked`` says of each of them whether its group is closed already.
    ``remembers``: functions of programs may read what an earlier one has left.
    """

    here: Here
    unread: bool
    unread_environment: bool
    unread_parameters: bool
    environment: dict[str, Value | None]
    remaps: tuple[Remap, ...] | None
    parameters: tuple[GlobalSource, ...] | None
    leaked: tuple[bool, ...]
    remembers: bool

    @classmethod
    def of(cls, walk: Walk) -> Situation:
        """That of this moment."""
        context = walk.context
        remaps, parameters = context.remaps, context.parameters
        return cls(
            walk.here._replace(told=_NOTHING),
            context.unread,
            context.unread_environment,
            context.unread_parameters,
            dict(context.environment.changes),
            None if remaps is None else tuple(remaps),
            None if parameters is None else tuple(parameters),
            tuple(id(each) in context.leaked for each in (*(remaps or ()), *(parameters or ()))) if context.leaked else (),
            walk.remembers,
        )


class Outcome(NamedTuple):
    """What an ``action`` came to in its ``situation``, with what it did to the launch configurations.

    ``names`` are those that were set before it, where it looked through all of them, and ``overwritten`` those among them that it set, too.
    ``told`` says of the args that it asked for whether their absence had been told. ``place`` is what ``$(dirname)`` and ``$(filename)``
    said before it, where it read that, and ``placed`` what they say after it, where it set that. ``logged`` is what was added to each list
    of the walk.
    """

    action: Performed
    situation: Situation
    uses: Uses
    names: frozenset[str] | None
    overwritten: frozenset[str]
    told: Mapping[tuple[str, tuple[str, int]], bool]
    place: tuple[Value | None, Value | None] | None
    placed: tuple[Value | None, Value | None] | None
    asked: Mapping[tuple[int, ...], object]
    settings: tuple[tuple[str, Setting], ...]
    after: Situation
    work: int
    logged: tuple[tuple[Any, ...], ...]
    said: tuple[Saying, ...]

    def fits(self, action: Performed, situation: Situation, walk: Walk) -> bool:
        """Whether ``action`` would come to the same now."""
        if self.action is not action or not _is_like(self.situation, situation):
            return False
        configurations = walk.context.configurations
        for name, setting in self.uses.read.items():
            if not _is_same(configurations.get(name), setting):
                return False
        if any(walk.executed.get(way) is not found for way, found in self.asked.items()):
            return False
        if any((each in walk.here.told) is not told for each, told in self.told.items()):
            return False
        if self.place is not None and self.place != walk.context.here:
            return False
        return self.names is None or self.overwritten <= configurations.keys()

    def said_among(self, names: Set[str]) -> tuple[Saying, ...]:
        """The problems as they are where ``names`` are set before it: those that list what is set list other names then."""
        before = self.names
        if before is None or before == names:
            return self.said
        gone = before - names
        return tuple(
            (key, each.among(sorted({*names, *each.known} - gone)) if isinstance(each, UndeclaredArg) else each) for key, each in self.said
        )


def _is_same(one: Setting | None, other: Setting | None) -> bool:
    if one is other or one == other:
        return True
    if one is None or other is None or one[1:] != other[1:]:
        return False
    return _is_like(one.value, other.value)


def _is_like(one: object, other: object) -> bool:
    """Whether two values, or sequences or mappings of such, are equal, those that are not known by what is said of them.

    Of two :class:`Situation`: whether the same comes of an action in both.
    """
    if one is other or one == other:
        return True
    if type(one) is not type(other):
        return False
    if isinstance(one, Unknown) and isinstance(other, Unknown):
        return (one.text, one.reason, one.pattern) == (other.text, other.reason, other.pattern)
    if isinstance(one, tuple) and isinstance(other, tuple):
        return len(one) == len(other) and all(map(_is_like, one, other))
    if isinstance(one, dict) and isinstance(other, dict):
        return one.keys() == other.keys() and all(_is_like(value, other[key]) for key, value in one.items())
    return False


class Repeats:
    """The outcomes of all configurations of one entry file; ``files`` are the sets of files that were executed, the last one first."""

    def __init__(self) -> None:
        self._known: dict[Key, list[Outcome]] = {}
        self.listings = Listings()
        self.files: list[ExecutedFiles] = []
        self._steps: dict[tuple[int, int], IncludeStep] = {}

    def step(self, place: Place, parent: IncludeStep | None) -> IncludeStep:
        """The step from ``parent`` to an include: always the same one, so that it takes no time to compare origins."""
        known = self._steps.get((id(place), id(parent)))
        if known is None:
            known = self._steps[id(place), id(parent)] = IncludeStep(place, parent)
        return known

    def execute(self, walk: Walk, action: Performed, perform: Callable[[Walk, Any], None], of: tuple[object, ...] = ()) -> None:
        """Execute an action, or take over what came of it; ``of`` is what ``perform`` hangs on beside the walk."""
        key = (id(action), walk.here.way, of)
        situation = Situation.of(walk)
        outcomes = self._known.setdefault(key, [])
        for outcome in outcomes:
            if outcome.fits(action, situation, walk) and walk.has_left(outcome.work):
                _take_over(walk, outcome)
                return
        new = _executed(walk, action, perform, situation)
        if new is not None:
            outcomes.insert(0, new)
            del outcomes[MOST_KEPT:]


def _executed(walk: Walk, action: Performed, perform: Callable[[Walk, Any], None], situation: Situation) -> Outcome | None:
    """Execute an action; None where the next one cannot take over what comes of it."""
    context = walk.context
    around = context.uses
    uses = context.uses = Uses()
    lists = context.remaps, context.parameters
    logs = walk.logs
    starts = [len(log) for log in logs]
    executed = len(walk.executions)
    before, place = walk.here.told, context.here
    said, work, waiting, anonymous = len(walk.said), walk.looked_at, len(walk.waiting), walk.performer.anonymous
    perform(walk, action)
    context.uses = around
    around.join(uses, uses.added)
    after = Situation.of(walk)
    added = all(map(_only_adds, lists, (context.remaps, context.parameters), (situation.remaps, situation.parameters)))
    if not added or uses.open or len(walk.waiting) > waiting or anonymous != walk.performer.anonymous:
        return None
    configurations = context.configurations
    inside = {way for way, _ in walk.executions[executed:]}
    names = frozenset(configurations.keys() - uses.added) if uses.all_names else None
    return Outcome(
        action,
        situation,
        uses,
        names,
        frozenset() if names is None else names & uses.ever,
        {each: each in before for each in uses.told},
        place if uses.place_read else None,
        context.here if uses.placed else None,
        {way: found for way, found in uses.asked.items() if found is None or way not in inside},
        tuple((name, configurations[name]) for name in sorted(uses.written)),
        after,
        walk.looked_at - work,
        tuple(tuple(log[start:]) for log, start in zip(logs, starts, strict=True)),
        tuple(walk.said[said:]),
    )


def _only_adds(before: list[Any] | None, after: list[Any] | None, was: tuple[Any, ...] | None) -> bool:
    """Whether a list of the context, that held what ``was`` in it, has got nothing but more items at its end, or is new."""
    if was is None or before is None:
        return True
    return after is before and len(after) >= len(was) and all(one is other for one, other in zip(was, after, strict=False))


def _take_over(walk: Walk, outcome: Outcome) -> None:
    context, after, executed, begun = walk.context, outcome.after, len(walk.executions), len(walk.begun)
    said = outcome.said_among(context.configurations.keys())
    context.uses.join(outcome.uses, outcome.uses.written - context.configurations.keys())
    context.configurations.update(outcome.settings)
    if outcome.placed is not None:
        context.enter(*outcome.placed)
    context.unread, context.unread_environment, context.unread_parameters = after.unread, after.unread_environment, after.unread_parameters
    context.environment.restore(after.environment)
    context.remaps = _with_added(context.remaps, after.remaps)
    context.parameters = _with_added(context.parameters, after.parameters)
    items = (*(after.remaps or ()), *(after.parameters or ()))
    context.leaked.update((id(each), each) for each, has_leaked in zip(items, after.leaked, strict=False) if has_leaked)
    walk.looked_at += outcome.work
    for log, logged in zip(walk.logs, outcome.logged, strict=True):
        log.extend(logged)
    walk.executed.update(walk.executions[executed:])
    walk.running.update(walk.begun[begun:])
    for key, problem in said:
        walk.keep(problem, key)


def _with_added(items: list[Any] | None, after: tuple[Any, ...] | None) -> list[Any] | None:
    """A list of the context with what was added to it: the same list, where there is one."""
    if after is None:
        return None
    if items is None:
        return list(after)
    items.extend(after[len(items) :])
    return items
