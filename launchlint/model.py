"""What would run: the one model every dialect lowers to.

A :class:`Launch` is what one entry file starts in one configuration: nodes, tests, parameters, machines, and what led to them. Each item
carries its :class:`~launchlint.source.Origin`. A value that cannot be known statically (an unset environment variable, a package that
is not here …) is an :class:`Unknown`; it is never guessed at and never causes a second problem.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from types import MappingProxyType

from launchlint.named_tuple import NamedTuple
from launchlint.problem import Problem
from launchlint.source import Origin, Place, Source

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any, Literal, TypeVar

    Kind = TypeVar("Kind", bound=Problem)
    Role = Literal[
        "package",
        "executable",
        "name",
        "test_name",
        "namespace",
        "arguments",
        "prefix",
        "machine",
        "output",
        "cwd",
        "remaps",
        "container",
    ]
    """What a part of a node is for, whatever a dialect calls what it is written in (``pkg``, ``ns``, ``args`` …)."""
    DialectName = Literal["ros1", "ros2"]
    """Who starts a launch file; what is done with it in a way of its own, :mod:`launchlint.dialects` holds."""
    NodeKind = Literal["node", "container", "lifecycle", "composable"]
    from typing import Final
else:
    Role = DialectName = str

ROS1: Final = "ros1"
ROS2: Final = "ros2"


class Unknown:
    """A value that cannot be known without running the system.

    ``text`` is what is written, ``reason`` why it is unknown, ``pattern`` what is known of the value: ``*`` stands for anything.
    """

    __slots__ = ("pattern", "reason", "text")

    def __init__(self, text: str, reason: str, pattern: str = "*") -> None:
        self.text = text
        self.reason = reason
        self.pattern = pattern

    def __repr__(self) -> str:
        return f"Unknown({self.text!r}, {self.reason!r})"


class StandIn(Unknown):
    """A value that is not known, for which its text is taken wherever values are compared: ``$(command …)``."""

    __slots__ = ()


class UnknownText(str):
    """The text of a value that is not known, where a text is wanted; ``reason`` says why it is not known."""

    __slots__ = ("reason",)
    reason: str

    def __new__(cls, text: str, reason: str) -> UnknownText:
        """As :class:`Unknown` has them."""
        made = super().__new__(cls, text)
        made.reason = reason
        return made


def shown_text(value: str | Unknown) -> str:
    """A value as a text: what is known of it, and what is written where nothing is."""
    if isinstance(value, str):
        return value
    return value.text if isinstance(value, StandIn) else UnknownText(value.text, value.reason)


class Command(NamedTuple):
    """The value of ``<param command=…>``: never run, so only the command line is known."""

    line: str


class Binary(NamedTuple):
    """The value of ``<param binfile=…>``: hexadecimal SHA-1 of the content and its length in bytes."""

    sha1: str
    length: int


class Scope(NamedTuple):
    """A ``<group>`` or ``<include>`` around an item: what contains it in the drawing, and where its names begin.

    ``namespace`` ends with ``/``. ``step`` is the include the group itself stands in.
    """

    kind: str
    origin: Origin
    namespace: str
    parent: Scope | None


class Condition(NamedTuple):
    """An ``if`` or ``unless`` that was taken on the way to an item; ``assumed`` where its value is unknown and was taken to be true.

    ``text`` is what it was judged by, ``name`` the launch configuration that it is compared with (ROS 2 only). The attribute ``maybe`` is
    none of the file's: it says that a program may put there what stands under it.
    """

    attribute: str
    place: Place
    assumed: bool = False
    text: str = ""
    name: str | None = None


class Branch(NamedTuple):
    """A condition that was met in this configuration.

    ``taken``: whether the element was evaluated; None where the value is unknown. ``element`` is the place of its start tag, ``tag`` the
    name of that, ``text`` the condition as written. ``steered_by`` are the args of the entry file on which it depends; ``open`` says
    whether anything outside the file (an arg it can be given, an environment variable) can change it. ``around`` are the args on which it
    depends whether it is met at all; None where that was not followed.
    """

    origin: Origin
    element: Place
    tag: str
    attribute: str
    text: str
    taken: bool | None
    steered_by: frozenset[str]
    open: bool
    around: frozenset[str] | None = None


class Remap(NamedTuple):
    """One remapping as roslaunch passes it: ``source:=target``, both canonicalised but not resolved.

    Where one of them is not known both are empty, and ``patterns`` is what is known of them: ``*`` stands for anything.
    """

    source: str
    target: str
    origin: Origin
    patterns: tuple[str, str] | None = None

    @property
    def key(self) -> tuple[str, tuple[str, str] | None]:
        """Of two rules with the same one, only the last counts."""
        return self.source, self.patterns


class EnvironmentSetting(NamedTuple):
    """One ``<env>`` that acts on a node."""

    name: str
    value: str
    origin: Origin


class ParameterSource(NamedTuple):
    """One of the things that give a ROS 2 node its params, in the order in which they stand on its command line.

    One of the first three is not None: a ``file``; the ``content`` of a file that launch writes for this start, with the file it is made
    ``of`` where it is a copy; or a ``rule`` (``name:=value``).
    """

    origin: Origin
    file: str | None = None
    content: Any = None
    rule: str | None = None
    of: str | None = None


class Process(NamedTuple):
    """What ROS 2 launch says of a process that it starts, beyond what every dialect says of a node.

    ``arguments`` and ``ros_arguments`` are words; ``label`` is what its output is marked with; ``environment`` is what differs from the
    environment that launch itself has (None: not set); ``open_environment``: there may be more. ``on_exit`` says what its end leads to:
    ``shutdown``, or ``actions``.
    """

    arguments: tuple[str, ...] = ()
    ros_arguments: tuple[str, ...] = ()
    label: str = ""
    environment: Mapping[str, str | None] = MappingProxyType({})
    shell: bool = False
    on_exit: str | None = None
    respawn_delay: float | None = None
    open_environment: bool = False


class OwnParameters(NamedTuple):
    """The params that a node ends up with, as :class:`Node` has them: ``own``, ``own_origins`` and ``own_shared``."""

    own: Mapping[str, tuple[str, Any]] | None
    own_origins: Mapping[str, Origin]
    own_shared: frozenset[str]


class Node(NamedTuple):
    """A node (or, with ``test_name``, a test) that would be started.

    ``namespace`` begins and ends with ``/``; ``executable`` is the ``type`` attribute; ``remaps`` stand in the order roslaunch passes
    them; ``respawn_delay`` and ``time_limit`` are seconds. ``places`` says by role where the values are written. ``unknown``
    names the roles whose value is not known; their fields hold the text as written, ``patterns`` what is known of the values
    (see :class:`Unknown`). With ``remaps`` among them, more remaps act on the node: ``open_remaps``, of names that are not known.

    The rest is of ROS 2. ``kind``: what starts it; a ``composable`` node is a ``plugin`` that is loaded into the ``container`` of that
    name. ``deferred`` names what it waits for (``timer``). ``has_namespace``: launch gives it one; else it has its own, as it has its own
    name where ``name`` is empty. ``sources`` are what its params come from, ``own`` what it ends up with: type and value by name, None if
    that cannot be known; ``own_origins`` says where these are written, as far as that is in a file, ``own_shared`` which of them a file
    gives to any node that matches a pattern; ``own_as`` says what these are under a full name that launch does not give. ``fatal`` is why
    rcl would refuse its command line, so that it dies when it starts, else empty.
    ``extra_arguments``: of a composable node, as ``own``. ``condition_ignored``: it is loaded although its condition does not hold.
    """

    name: str
    namespace: str
    package: str
    executable: str
    machine: str | None
    arguments: str
    remaps: tuple[Remap, ...]
    environment: tuple[EnvironmentSetting, ...]
    output: str | None
    respawn: bool
    respawn_delay: float
    required: bool
    cwd: str | None
    launch_prefix: str | None
    file: str
    origin: Origin
    places: Mapping[Role, Place]
    scope: Scope | None = None
    conditions: tuple[Condition, ...] = ()
    unknown: frozenset[Role] = frozenset()
    test_name: str | None = None
    time_limit: float = 60.0
    retry: int = 0
    patterns: Mapping[Role, str] = MappingProxyType({})
    open_remaps: tuple[Remap, ...] = ()
    kind: NodeKind = "node"
    plugin: str | None = None
    container: str | None = None
    deferred: str | None = None
    has_namespace: bool = True
    process: Process | None = None
    sources: tuple[ParameterSource, ...] = ()
    own: Mapping[str, tuple[str, Any]] | None = None
    own_origins: Mapping[str, Origin] = MappingProxyType({})
    own_shared: frozenset[str] = frozenset()
    own_as: Callable[[str], OwnParameters] | None = None
    fatal: str = ""
    extra_arguments: Mapping[str, tuple[str, Any]] = MappingProxyType({})
    condition_ignored: bool = False

    @property
    def full_name(self) -> str:
        """The name on the graph: namespace and name joined."""
        return self.namespace + self.name

    def knows(self, *roles: Role) -> bool:
        """Whether the values of all these ``roles`` are known."""
        return self.unknown.isdisjoint(roles)

    @property
    def is_test(self) -> bool:
        """Whether it is a ``<test>``: run by rostest only."""
        return self.test_name is not None


class ParameterSetting(NamedTuple):
    """One setting of a parameter. ``tag`` is ``param`` or ``rosparam``; ``value`` is a plain value, Command, Binary or Unknown.

    ``node`` is the full name of the node the setting stands in or is made private to, if any.
    """

    name: str
    value: Any
    origin: Origin
    tag: str
    scope: Scope | None = None
    conditions: tuple[Condition, ...] = ()
    node: str | None = None


class Machine(NamedTuple):
    """A ``<machine>``; ``timeout`` is seconds."""

    name: str
    address: str
    env_loader: str
    ssh_port: int
    user: str | None
    password: str | None
    assignable: bool
    timeout: float
    origin: Origin


class Argument(NamedTuple):
    """An ``<arg>`` of a launch file, or one passed by an ``<include>`` (then ``passed`` is true)."""

    name: str
    value: str | Unknown | None
    default: str | Unknown | None
    origin: Origin
    passed: bool = False
    in_group: bool = False


class Declaration(NamedTuple):
    """An ``<arg>`` that ROS 2 launch executed; ``given``: it had a value before. ``has_default`` and ``choices`` are as declared.

    ``maybe``: it is not known whether it is executed. ``file`` is the launch file that is executed, wherever it is written.
    """

    argument: Argument
    given: bool
    has_default: bool
    choices: tuple[str, ...] | None
    maybe: bool = False
    file: str = ""


class ListedArgument(NamedTuple):
    """An arg as ``ros2 launch --show-args`` lists it, without executing anything; ``conditional``: it may never be declared."""

    name: str
    required: bool
    conditional: bool
    place: Place


class Include(NamedTuple):
    """An ``<include>`` that was followed (``file`` is the name it was opened under) or could not be (``source`` is None).

    ROS 2: ``pushed`` is the namespace that was pushed before it, if any; ``deferred`` as for a :class:`Node`. ``within`` is the launch file
    that is executed.
    """

    file: str
    source: Source | None
    namespace: str
    arguments: Mapping[str, str | Unknown]
    pass_all_args: bool
    origin: Origin
    scope: Scope | None = None
    conditions: tuple[Condition, ...] = ()
    pushed: str | None = None
    deferred: str | None = None
    within: str = ""


class Executable(NamedTuple):
    """A program that ROS 2 launch starts as it is, whatever it is (``<executable>``): ``command`` are its words."""

    command: tuple[str, ...]
    process: Process
    cwd: str | None
    output: str | None
    launch_prefix: str | None
    respawn: bool
    respawn_delay: float
    file: str
    origin: Origin
    scope: Scope | None = None
    conditions: tuple[Condition, ...] = ()
    deferred: str | None = None
    unknown: frozenset[Role] = frozenset()


class ScopedSetting(NamedTuple):
    """A ``remap``, ``env`` or ``~param`` that stands outside a node and acts on what follows it in its scope.

    ``reached`` is how many nodes and tests it acts on, until another of the same key in the same scope replaces it; ``before`` are the
    nodes of the same scope that stand above it and so miss it. ``replaced`` is the earlier setting that it replaces in this way.
    ``scope_end`` is the offset in its file at which its scope ends.
    """

    kind: str
    key: str
    value: Any
    origin: Origin
    reached: int
    before: tuple[Place, ...]
    replaced: Place | None = None
    conditions: tuple[Condition, ...] = ()
    scope_end: int = 0


class Followed(NamedTuple):
    """A launch file that is a program (ROS 2): whether what it does could be told without running it, and of what not, and why."""

    source: Source
    state: Literal["resolved", "partly", "not"]
    reasons: tuple[tuple[Place, str], ...]


class Launch(NamedTuple):
    """What one entry file starts in one configuration.

    ``arguments`` is the configuration: what would be given as ``name:=value``. ``refused`` is the first problem for which roslaunch would
    refuse to load the file, else None. ``parameters`` holds the final setting of each name, ``parameter_settings`` all of them in order.
    ``executables`` are the rosparam dump and delete steps as ``(command, parameter, file)``. ``files`` are the names of the loaded launch
    files in order. ``complete`` is false where an include could not be followed, so that there may be more nodes than are known. In the
    namespaces ``more_parameters`` there may be more parameters than are known. ``dialect`` is that of the entry file.

    The rest is of ROS 2: the ``distro`` whose launch this is, and the file that names it, where it was taken from one, with all that
    are ``named`` (oldest first); ``programs`` that are no nodes; ``declarations``, those of :attr:`declared`
    as launch executed them; ``listed``, the args as people are shown them; ``late``, the first problem of each body that is executed
    later (a timer's) and fails then: it does not keep the file from being loaded; ``settled``: whether launch refuses the file can be told;
    ``followed`` are those of its files that are programs; ``transitions`` is where launch itself may take lifecycle nodes from one state to
    the next.
    """

    entry: Source
    arguments: Mapping[str, str]
    given: tuple[tuple[str, str], ...]
    refused: Problem | None
    problems: tuple[Problem, ...]
    nodes: tuple[Node, ...]
    tests: tuple[Node, ...]
    parameters: Mapping[str, ParameterSetting]
    parameter_settings: tuple[ParameterSetting, ...]
    clear_params: tuple[tuple[str, Origin], ...]
    machines: Mapping[str, Machine]
    executables: tuple[tuple[str, str, str], ...]
    includes: tuple[Include, ...]
    settings: tuple[ScopedSetting, ...]
    declared: tuple[Argument, ...]
    branches: tuple[Branch, ...]
    files: tuple[str, ...]
    complete: bool
    more_parameters: tuple[str, ...] = ()
    dialect: DialectName = ROS1
    distro: str = ""
    named_by: str = ""
    named: tuple[str, ...] = ()
    programs: tuple[Executable, ...] = ()
    declarations: tuple[Declaration, ...] = ()
    listed: tuple[ListedArgument, ...] = ()
    late: tuple[Problem, ...] = ()
    settled: bool = True
    followed: tuple[Followed, ...] = ()
    transitions: tuple[Place, ...] = ()

    @property
    def verdict(self) -> Literal["ok", "error", "unknown"]:
        """What its launcher does with it here and now: load it, refuse it, or what cannot be told."""
        return "error" if self.refused is not None else "ok" if self.settled else "unknown"

    def noticed(self, kind: type[Kind]) -> Iterator[Kind]:
        """The problems of one kind."""
        return (problem for problem in self.problems if isinstance(problem, kind))
