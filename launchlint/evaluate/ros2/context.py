"""What is in force at one moment of a ROS 2 launch (launch.LaunchContext).

There is one flat set of launch configurations for all files; a group puts it back afterwards, an include does not. The environment is a set
of its own. What ``set_remap`` and ``set_parameter`` add to are lists: a group puts the same list back, with what was
added inside still in it. What ``$(dirname)`` says is changed by an include and put back by nobody.
"""

from __future__ import annotations

from collections.abc import Mapping, Set

from launchlint.evaluate.ros2.scopes import (
    Moment,
    SavedConfigurations,
    SavedEnvironment,
    doubtful_parameters,
    doubtful_remaps,
    either_changes,
    either_configurations,
    either_environment,
    either_setting,
    either_stack,
    is_same,
)
from launchlint.model import Remap, Unknown
from launchlint.named_tuple import NamedTuple

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Literal, TypeAlias

    from launchlint.evaluate.ros2.parameters import GlobalSource
    from launchlint.evaluate.session import Session
    from launchlint.source import IncludeStep, Origin

    How = Literal["given", "default", "let", "passed", "kept", "anonymous", "namespace", "missing"]

Value: TypeAlias = "str | Unknown"
NAMESPACE = "ros_namespace"
"""The launch configuration that holds the pushed namespace: it can be read and set like any other."""


class Setting(NamedTuple):
    """A launch configuration: its value, where it was set, and how.

    ``steer`` are the names that would have to be given another value for this one to change; ``outside``: it is made from an environment
    variable. ``missing``: an arg without a value, which has been told. ``same`` is the name whose value it is as a whole, if it is.
    ``way`` are the includes on the way to the file that set it or, where it was passed, was meant to get it, each by its identity.
    """

    value: Value
    origin: Origin | None
    how: How
    steer: frozenset[str] = frozenset()
    outside: bool = False
    same: str | None = None
    way: tuple[int, ...] = ()

    def is_left_at(self, way: tuple[int, ...]) -> bool:
        """Whether it was set for a file that has been executed to its end when one that ``way`` leads to is."""
        return way[: len(self.way)] != self.way


class Environment:
    """The environment variables, as what differs from those that launch was started with (None: not set any more)."""

    __slots__ = ("changes", "session")

    def __init__(self, session: Session) -> None:
        self.session = session
        self.changes: dict[str, Value | None] = {}

    def get(self, name: str) -> Value | None:
        """The value of a variable, None where it is not set."""
        return self.changes[name] if name in self.changes else self.session.ros2_variable(name)

    def set(self, name: str, value: Value | None) -> None:
        """Set a variable, or unset it."""
        self.changes[name] = value

    def restore(self, changes: Mapping[str, Value | None]) -> None:
        """Make the variables what they were."""
        if self.changes != changes:
            self.changes = dict(changes)


class Uses:
    """What some actions did with the launch configurations: each that they ``read`` before they set it, as it was (None: not set), those
    that they have ``written`` and among these the ``added``, which were not there before.

    ``asked``: the files that they looked into, by the includes that led to them, when these were executed already. ``told``: the args of
    which they asked whether their absence had been told. ``all_names``: they looked through the names of all configurations; ``ever`` are
    all that were written, those in scopes that are left again, too. ``placed``: they set what ``$(dirname)`` and ``$(filename)`` say;
    ``place_read``: they read it before. ``open``: they did more than can be said so.
    """

    __slots__ = ("added", "all_names", "asked", "ever", "open", "place_read", "placed", "read", "told", "written")

    def __init__(self) -> None:
        self.read: dict[str, Setting | None] = {}
        self.written: set[str] = set()
        self.added: set[str] = set()
        self.ever: set[str] = set()
        self.asked: dict[tuple[int, ...], object] = {}
        self.told: set[tuple[str, tuple[str, int]]] = set()
        self.all_names = False
        self.place_read = False
        self.placed = False
        self.open = False

    def join(self, later: Uses, added: Set[str]) -> None:
        """Add what was done by actions that were executed after these; ``added`` are the names that were not there before them."""
        for name, setting in later.read.items():
            if name not in self.written:
                self.read.setdefault(name, setting)
        self.written |= later.written
        self.added |= added
        self.ever |= later.ever
        self.told |= later.told
        self.place_read = self.place_read or (later.place_read and not self.placed)
        self.placed = self.placed or later.placed
        for way, found in later.asked.items():
            self.asked.setdefault(way, found)
        self.all_names = self.all_names or later.all_names
        self.open = self.open or later.open


class Context:
    """See the module.

    ``here`` is what ``$(dirname)`` and ``$(filename)`` say: where something hangs on it, ``place`` is asked for.
    ``unread``: a launch file was included that is not read, and may have set configurations of names that are not known; a scope puts that
    back, too. ``unread_environment`` says the same of variables, ``unread_parameters`` of params, which leak out of scopes. ``leaked`` are
    the remaps and params that were set in a scope whose end is passed, and are still in the lists, each by its identity. ``saved`` and
    ``saved_environments`` are the two stacks. ``uses`` is what is done with the configurations from now on. ``turning`` are the files whose
    loops are gone through, by the includes that lead to them.
    """

    __slots__ = (
        "configurations",
        "environment",
        "here",
        "leaked",
        "parameters",
        "remaps",
        "saved",
        "saved_environments",
        "turning",
        "unread",
        "unread_environment",
        "unread_parameters",
        "uses",
    )

    def __init__(self, session: Session) -> None:
        self.configurations: dict[str, Setting] = {}
        self.remaps: list[Remap] | None = None
        self.parameters: list[GlobalSource] | None = None
        self.environment = Environment(session)
        self.here: tuple[Value | None, Value | None] = (None, None)
        self.saved: list[SavedConfigurations] = []
        self.saved_environments: list[SavedEnvironment] = []
        self.turning: list[IncludeStep | None] = []
        self.unread = False
        self.unread_environment = False
        self.unread_parameters = False
        self.leaked: dict[int, Remap | GlobalSource] = {}
        self.uses = Uses()

    @property
    def directory(self) -> Value | None:
        """What ``$(dirname)`` says."""
        return self.place()[0]

    @property
    def file(self) -> Value | None:
        """What ``$(filename)`` says."""
        return self.place()[1]

    def place(self) -> tuple[Value | None, Value | None]:
        """What both say."""
        uses = self.uses
        uses.place_read = uses.place_read or not uses.placed
        return self.here

    def enter(self, directory: Value | None, file: Value | None) -> None:
        """Set what both say: a file is executed now."""
        self.uses.placed = True
        self.here = (directory, file)

    def get(self, name: str) -> Setting | None:
        """A launch configuration, None where it is not set."""
        setting = self.configurations.get(name)
        uses = self.uses
        if name not in uses.written:
            uses.read[name] = setting
        return setting

    def set(self, name: str, setting: Setting) -> None:
        """Set a launch configuration."""
        uses = self.uses
        uses.written.add(name)
        uses.ever.add(name)
        if name not in self.configurations:
            uses.added.add(name)
        self.configurations[name] = setting

    def unset(self, name: str) -> None:
        """Forget a launch configuration."""
        self.uses.open = True
        self.configurations.pop(name, None)

    def everything(self) -> Mapping[str, Setting]:
        """All launch configurations, to be looked through."""
        self.uses.open = True
        return self.configurations

    def names(self) -> tuple[str, ...]:
        """The names of all launch configurations that are set, sorted."""
        self.uses.all_names = True
        return tuple(sorted(self.configurations))

    def include_unread(self) -> None:
        """A launch file is included that is not read: whatever is not set here may be set by it."""
        self.unread = self.unread_environment = self.unread_parameters = True

    def push(self) -> None:
        """Begin a scope: everything is inherited."""
        self.push_configurations()
        self.push_environment()

    def pop(self) -> bool | None:
        """End a scope; whether there is one to end, None where that is not known."""
        environment = self.pop_environment()
        return self.pop_configurations() if environment else environment

    def push_configurations(self) -> None:
        """Keep the configurations as they are (launch.LaunchContext._push_launch_configurations)."""
        uses = self.uses
        self.saved.append(
            SavedConfigurations(
                self.configurations,
                self.remaps,
                self.parameters,
                len(self.remaps or ()),
                len(self.parameters or ()),
                self.unread,
                set(uses.written),
                set(uses.added),
            )
        )
        # What waits for later keeps the configurations it was met with: those of this scope are others from here on.
        self.configurations = dict(self.configurations)

    def pop_configurations(self) -> bool | None:
        """Put back those that were kept last; whether there are any. The lists of remaps and params are the ones of before, with whatever
        was added to them since.
        """
        if not self.saved:
            return False
        saved = self.saved.pop()
        self.configurations, self.remaps, self.parameters = saved.configurations, saved.remaps, saved.parameters
        self.leaked.update((id(each), each) for each in (self.remaps or ())[saved.remaps_count :])
        self.leaked.update((id(each), each) for each in (self.parameters or ())[saved.parameters_count :])
        self.unread = saved.unread
        self.uses.written, self.uses.added = saved.written, saved.added
        return saved.sure or None

    def push_environment(self) -> None:
        """Keep the environment as it is (launch.LaunchContext._push_environment)."""
        self.saved_environments.append(SavedEnvironment(dict(self.environment.changes), self.unread_environment))

    def pop_environment(self) -> bool | None:
        """Put back the one that was kept last; whether there is any."""
        if not self.saved_environments:
            return False
        saved = self.saved_environments.pop()
        self.environment.restore(saved.changes)
        self.unread_environment = saved.unread
        return saved.sure or None

    def forget(self, keep: Mapping[str, Setting]) -> None:
        """Drop all launch configurations but ``keep`` (ResetLaunchConfigurations), remaps and params among them."""
        self.uses.open = True
        self.configurations = dict(keep)
        self.remaps = None
        self.parameters = None

    def moment(self) -> Moment:
        """All that is in force now."""
        return Moment(
            dict(self.configurations),
            self.remaps,
            self.parameters,
            tuple(self.remaps or ()),
            tuple(self.parameters or ()),
            dict(self.environment.changes),
            self.unread,
            self.unread_environment,
            self.here,
            tuple(self.saved),
            tuple(self.saved_environments),
            frozenset(self.uses.written),
            self.uses.placed,
        )

    def doubt(self, before: Moment, reason: str) -> None:
        """All that was done since ``before`` may not have been done: what is in force is what was then, or what is now."""
        self._doubt_configurations(before, reason)
        self.environment.restore(either_changes(before.environment, self.environment.changes, reason))
        self.unread = self.unread or before.unread
        self.unread_environment = self.unread_environment or before.unread_environment
        if self.uses.placed and not before.placed:
            self.uses.place_read = True
        if self.here != before.here:
            self.here = (Unknown("$(dirname)", reason), Unknown("$(filename)", reason))
        self._doubt_lists(before, reason)
        self.saved = either_stack(before.saved, self.saved, lambda one, other: either_configurations(one, other, reason))
        self.saved_environments = either_stack(
            before.saved_environments, self.saved_environments, lambda one, other: either_environment(one, other, reason)
        )

    def _doubt_configurations(self, before: Moment, reason: str) -> None:
        was, now, uses = before.configurations, self.configurations, self.uses
        for name in (*was, *(name for name in tuple(now) if name not in was)):
            one, other = was.get(name), now.get(name)
            if one is other:
                continue
            if name not in before.written:
                uses.read.setdefault(name, one)
            self.set(name, one if one is not None and is_same(one, other) else either_setting(name, one, other, reason))

    def _doubt_lists(self, before: Moment, reason: str) -> None:
        """What was added to the lists may be in them; where they were left for others, all that is in any of them."""
        if self.remaps is not None and (self.remaps is before.remaps or before.remaps is None):
            self.remaps[len(before.remaps_then) :] = doubtful_remaps(self.remaps[len(before.remaps_then) :])
        elif self.remaps is not before.remaps:
            self.remaps = doubtful_remaps((*before.remaps_then, *(self.remaps or ())))
        if self.parameters is not None and (self.parameters is before.parameters or before.parameters is None):
            self.parameters[len(before.parameters_then) :] = doubtful_parameters(self.parameters[len(before.parameters_then) :], reason)
        elif self.parameters is not before.parameters:
            self.parameters = doubtful_parameters((*before.parameters_then, *(self.parameters or ())), reason)

    @property
    def namespace(self) -> Value | None:
        """The pushed namespace, if any."""
        setting = self.get(NAMESPACE)
        return None if setting is None else setting.value
