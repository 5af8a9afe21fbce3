"""The args that a launch file shows before anything of it is executed (launch.LaunchDescription.get_launch_arguments).

``ros2 launch --show-args`` prints them, and before an include is executed those without a default must be among what it passes. Included
files are looked into as far as their names can be told without a context. What launch does with conditions here is followed to the letter:
a condition makes what stands directly below it conditional, and neither what stands in a group below that nor what is included by it.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping

from launchlint.evaluate.ros2.performing import Failure, Performer
from launchlint.model import Unknown
from launchlint.named_tuple import NamedTuple
from launchlint.syntax.ros2.description import Action, Argument, Description, Group, Handler, Include, Maybe, Reset, Timer

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import TypeAlias

    from launchlint.evaluate.ros2.context import Value

    Names: TypeAlias = frozenset[str] | None
    """What includes pass, all together; None where that cannot be told without a context, which launch does not expect."""
    Changes: TypeAlias = tuple[tuple[str, Value | None], ...]
    Way: TypeAlias = tuple[int, ...]
    """The includes that lead to a file, each by its identity."""


class Shown(NamedTuple):
    """An arg that is shown. ``through``: the place among :attr:`Listing.passed` of what the includes that lead to it pass, None for those
    of the file itself. ``include``: the include of the file through which it is reached.
    """

    argument: Argument
    conditional: bool
    through: int | None
    include: Include | None


class Listing(NamedTuple):
    """The args that one file shows and that must be given, the first of each name; ``passed``: for each of its includes, what that and
    those below it pass.
    """

    required: tuple[Shown, ...]
    passed: tuple[Names, ...]


class _Below(NamedTuple):
    """What an included file adds."""

    shown: tuple[tuple[Argument, bool], ...]
    passed: Names


_NOTHING = _Below((), frozenset())


class Listings:
    """What has been listed for one entry file, by file and by what the environment was."""

    def __init__(self) -> None:
        self.files: dict[tuple[int, Changes], Listing] = {}
        self.below: dict[tuple[str, Changes], _Below] = {}
        self.included: dict[tuple[int, Changes], _Below] = {}
        self.reached: dict[int, tuple[tuple[Action, bool], ...]] = {}


class Lister:
    """Lists files.

    ``read`` gives the description of a file, None where launch cannot load it; ``performer`` has an empty context; ``kept`` is what has
    been listed already.
    """

    def __init__(self, performer: Performer, read: Callable[[str], Description | None], kept: Listings) -> None:
        self._performer = performer
        self._read = read
        self._kept = kept
        self._open: set[str] = set()

    def list(self, description: Description) -> Listing:
        """The args that a file shows and that must be given."""
        key = (id(description), self._changes())
        known = self._kept.files.get(key)
        if known is None:
            known = self._kept.files[key] = self._listed(description)
        return known

    def _changes(self) -> Changes:
        """What has been done to the environment."""
        return tuple(self._performer.context.environment.changes.items())

    def _listed(self, description: Description) -> Listing:
        shown: dict[str, Shown] = {}
        passed: list[Names] = []
        for action, conditional in self._reached(description):
            if isinstance(action, Argument):
                shown.setdefault(action.name, Shown(action, conditional or action.condition is not None, None, None))
            elif isinstance(action, Include):
                below = self._included(action)
                passed.append(_together(self._names(action), below.passed))
                for argument, uncertain in below.shown:
                    shown.setdefault(argument.name, Shown(argument, uncertain, len(passed) - 1, action))
        required = (each for each in shown.values() if not each.conditional and each.argument.default is None)
        return Listing(tuple(required), tuple(passed))

    def list_executed(self, description: Description, executed: Mapping[Way, Description], way: Way = ()) -> dict[str, Shown]:
        """The same when all has been executed: launch knows the files of the includes that it has executed, whatever their names are made
        of. ``executed`` has them by the includes that lead to them.
        """
        shown: dict[str, Shown] = {}
        for action, conditional in self._reached(description):
            if isinstance(action, Argument):
                if action.name not in shown:
                    shown[action.name] = Shown(action, conditional or action.condition is not None, None, None)
            elif isinstance(action, Include):
                inner = (*way, id(action))
                if inner in executed:
                    for each in self.list_executed(executed[inner], executed, inner).values():
                        shown.setdefault(each.argument.name, each)
                    continue
                for argument, uncertain in self._included(action).shown:
                    shown.setdefault(argument.name, Shown(argument, uncertain, None, action))
        return shown

    def _reached(self, description: Description) -> tuple[tuple[Action, bool], ...]:
        """The args and includes of a file: see :func:`_reached`."""
        key = id(description)
        if key not in self._kept.reached:
            self._kept.reached[key] = tuple(_reached(description.actions, conditional=False))
        return self._kept.reached[key]

    def _included(self, include: Include) -> _Below:
        """What the file of an include adds; nothing where it cannot be told, or includes itself."""
        if self._open:
            return self._found(include)
        again = (id(include), self._changes())
        known = self._kept.included.get(again)
        if known is None:
            known = self._kept.included[again] = self._found(include)
        return known

    def _found(self, include: Include) -> _Below:
        """The same, looked for; what a file adds is kept by its name."""
        if include.description is not None:
            return self._all_below(include.description)
        try:
            file = self._performer.perform(include.file)
        except Failure:
            return _NOTHING
        if isinstance(file, Unknown) or file in self._open:
            return _NOTHING
        key = (file, self._changes())
        known = self._kept.below.get(key)
        if known is None:
            description = self._read(file)
            if description is None:
                return _NOTHING
            self._open.add(file)
            known = self._kept.below[key] = self._all_below(description)
            self._open.remove(file)
        return known

    def _all_below(self, description: Description) -> _Below:
        shown: dict[str, tuple[Argument, bool]] = {}
        passed: Names = frozenset()
        for action, conditional in self._reached(description):
            if isinstance(action, Argument):
                shown.setdefault(action.name, (action, conditional or action.condition is not None))
            elif isinstance(action, Include):
                below = self._included(action)
                passed = _together(passed, _together(self._names(action), below.passed))
                for argument, uncertain in below.shown:
                    shown.setdefault(argument.name, (argument, uncertain))
        return _Below(tuple(shown.values()), passed)

    def _names(self, include: Include) -> Names:
        try:
            names = [self._performer.perform(pair.name) for pair in include.arguments]
        except Failure:
            return None
        return frozenset(name for name in names if isinstance(name, str))


def _together(left: Names, right: Names) -> Names:
    return None if left is None or right is None else left | right


def _reached(actions: tuple[Action, ...], *, conditional: bool) -> Iterator[tuple[Action, bool]]:
    """The args and includes in ``actions`` and the groups among them, with whether launch calls them conditional.

    Nothing behind a ``<reset>`` can be set from outside any more, nor anything in a group that forgets what was set.
    """
    for action in actions:
        if isinstance(action, Reset):
            return
        if isinstance(action, (Argument, Include)):
            yield action, conditional
        elif isinstance(action, Group):
            if action.scoped is False or action.forwarding is not False:
                yield from _reached(action.actions, conditional=action.condition is not None)
        else:
            later = action.actions if isinstance(action, (Timer, Maybe, Handler)) else ()
            if isinstance(later, tuple):
                yield from _reached(later, conditional=True)
