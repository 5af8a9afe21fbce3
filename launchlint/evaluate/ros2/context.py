"""What is in force at one moment of a ROS 2 launch (launch.LaunchContext).

There is one flat set of launch configurations for all files; a group puts it back afterwards, an include does not. The environment is a set
of its own. What ``set_remap`` and ``set_parameter`` add to are lists: a group puts the same list back, with what was
added inside still in it. What ``$(dirname)`` says is changed by an include and put back by nobody.
"""

from __future__ import annotations

from collections.abc import Mapping, Set
from typing import NamedTuple

from launchlint.model import Remap, Unknown

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Literal, TypeAlias

    from launchlint.evaluate.ros2.parameters import GlobalSource
    from launchlint.evaluate.session import Session
    from launchlint.source import Origin

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
        return self.changes[name] if name in self.changes else self.session.variable(name)

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


class _Saved(NamedTuple):
    configurations: dict[str, Setting]
    remaps: list[Remap] | None
    parameters: list[GlobalSource] | None
    environment: dict[str, Value | None]
    unread: bool
    remaps_count: int
    parameters_count: int
    written: set[str]
    added: set[str]


class Context:
    """See the module.

    ``here`` is what ``$(dirname)`` and ``$(filename)`` say: where something hangs on it, ``place`` is asked for.
    ``unread``: a launch file was included that is not read, and may have set configurations and variables of names that are not known; a
    group puts that back, too. ``unread_parameters`` says the same of params, which leak out of groups. ``leaked`` are the remaps and params
    that were set in a group whose end is passed, and are still in the lists, each by its identity. ``uses`` is what is done with the
    configurations from now on.
    """

    __slots__ = (
        "configurations",
        "environment",
        "here",
        "leaked",
        "parameters",
        "remaps",
        "stack",
        "unread",
        "unread_parameters",
        "uses",
    )

    def __init__(self, session: Session) -> None:
        self.configurations: dict[str, Setting] = {}
        self.remaps: list[Remap] | None = None
        self.parameters: list[GlobalSource] | None = None
        self.environment = Environment(session)
        self.here: tuple[str | None, str | None] = (None, None)
        self.stack: list[_Saved] = []
        self.unread = False
        self.unread_parameters = False
        self.leaked: dict[int, Remap | GlobalSource] = {}
        self.uses = Uses()

    @property
    def directory(self) -> str | None:
        """What ``$(dirname)`` says."""
        return self.place()[0]

    @property
    def file(self) -> str | None:
        """What ``$(filename)`` says."""
        return self.place()[1]

    def place(self) -> tuple[str | None, str | None]:
        """What both say."""
        uses = self.uses
        uses.place_read = uses.place_read or not uses.placed
        return self.here

    def enter(self, directory: str | None, file: str | None) -> None:
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
        self.unread = self.unread_parameters = True

    def push(self) -> None:
        """Begin a scope: everything is inherited (PushLaunchConfigurations, PushEnvironment)."""
        uses = self.uses
        self.stack.append(
            _Saved(
                self.configurations,
                self.remaps,
                self.parameters,
                dict(self.environment.changes),
                self.unread,
                len(self.remaps or ()),
                len(self.parameters or ()),
                set(uses.written),
                set(uses.added),
            )
        )
        # What waits for later keeps the configurations it was met with: those of this scope are others from here on.
        self.configurations = dict(self.configurations)

    def pop(self) -> None:
        """End a scope. The lists of remaps and params are the ones of before, with whatever was added to them inside."""
        saved = self.stack.pop()
        self.configurations, self.remaps, self.parameters = saved.configurations, saved.remaps, saved.parameters
        self.leaked.update((id(each), each) for each in (self.remaps or ())[saved.remaps_count :])
        self.leaked.update((id(each), each) for each in (self.parameters or ())[saved.parameters_count :])
        self.environment.restore(saved.environment)
        self.unread = saved.unread
        self.uses.written, self.uses.added = saved.written, saved.added

    def forget(self, keep: Mapping[str, Setting]) -> None:
        """Drop all launch configurations but ``keep`` (ResetLaunchConfigurations), remaps and params among them."""
        self.uses.open = True
        self.configurations = dict(keep)
        self.remaps = None
        self.parameters = None

    @property
    def namespace(self) -> Value | None:
        """The pushed namespace, if any."""
        setting = self.get(NAMESPACE)
        return None if setting is None else setting.value
