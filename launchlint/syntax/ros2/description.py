"""What a ROS 2 launch file describes: actions, and the texts and conditions in them, before anything is executed.

All front ends (XML, YAML and Python) make these, each with its place; :mod:`launchlint.evaluate.ros2` executes them in document order, with
a context that says what the texts stand for. Fields have the names that launch and launch_ros give them in Python.

Source: ``launch.actions``, ``launch_ros.actions``, ``launch.substitutions`` and their ``parse`` methods for launch's front ends.
"""

from __future__ import annotations

from launchlint.named_tuple import NamedTuple
from launchlint.problem import Problem
from launchlint.source import Place

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Literal, TypeAlias

    from launchlint.syntax.ros2.live import Call as Call
    from launchlint.syntax.ros2.live import Gives as Gives

NOT_KNOWN = "?"
"""The name of a substitution whose value is not known; its argument says why. No front end can write it. A second argument is a text that
stands for the value where values are compared."""
FULL_NAME = "?name"
"""The name of a substitution that gives the full name of a container, by its namespace and name, as the container was given it."""
CALLED = "?called"
"""The name of a substitution of a class that a program has made itself: what it gives, a call says (Python only)."""
AS_BOOL, REWRITTEN, REPLACED, HAS_PARAMS = "?as-bool", "?rewritten", "?replaced", "?has-params"
"""The names of substitutions that nav2_common brings (Python only)."""


class Substitution(NamedTuple):
    """``$(name argument …)``: computed when its action is executed. ``name`` is the front end's (``var``, ``find-pkg-share``).

    Where the front end refused it, it stands here all the same, with any name and arguments (with an empty name, where the value could not
    be read at all): what it gives is unknown, and told of already. An argument ``''`` is a text without pieces. ``call`` says what one of
    the name :data:`CALLED` gives.
    """

    name: str
    arguments: tuple[Text, ...]
    place: Place
    call: Gives | None = None

    @property
    def written(self) -> str:
        """What stands in the file; a question mark where there is nothing that could be read."""
        return self.place.text if self.name else "?"


class Text(NamedTuple):
    """A value of an action: pieces that are joined to one string when the action is executed. Without pieces it is the empty string."""

    pieces: tuple[str | Substitution, ...]
    place: Place

    @property
    def literal(self) -> str | None:
        """The string itself, where nothing in it is computed."""
        if not self.pieces:
            return ""
        return self.pieces[0] if len(self.pieces) == 1 and isinstance(self.pieces[0], str) else None

    @property
    def written(self) -> str:
        """What stands in the file: this text may be no more than one word of what stands at its place."""
        return "".join(piece if isinstance(piece, str) else piece.written for piece in self.pieces)


def unknown(reason: str, place: Place) -> Text:
    """A text of which nothing is known."""
    return Text((Substitution(NOT_KNOWN, (Text((reason,), place),), place),), place)


class Condition(NamedTuple):
    """Whether an action is executed: ``if`` and ``unless`` have one operand; ``equals`` and ``not-equals`` (Python only) two.

    Of a program: a condition may be ``unknown``, and it may be unknown whether there is the action at all (``maybe``);
    the operand says why.
    """

    kind: Literal["if", "unless", "equals", "not-equals", "unknown", "maybe"]
    operands: tuple[Text, ...]
    place: Place


class Pair(NamedTuple):
    """A name with a value: an arg passed to an include, a variable kept by a group, an environment variable, an extra argument."""

    name: Text
    value: Text
    place: Place


class Remap(NamedTuple):
    """One remapping, as written."""

    source: Text
    target: Text
    place: Place


class TypedValue(NamedTuple):
    """The value of a ``<param>``: ``type`` is what launch's ``type`` attribute says (None: to be guessed by launch's YAML rules).

    ``value`` is one text, or a tuple of them where the front end gave a list (``value-sep``, a list in YAML or in an XML value). What
    launch knows as a value already when it reads the file stands in ``plain``: numbers, booleans, and texts without substitutions, which
    it does not look into again. ``plain`` is None where the text is to be computed and then read as a ``type``; for a list it is a tuple
    of the same length, with None for each item that is to be computed.
    """

    value: Text | tuple[Text, ...]
    type: str | None = None
    plain: bool | int | float | str | tuple[bool | int | float | str | None, ...] | None = None


class Parameter(NamedTuple):
    """``<param name value>``; ``nested`` holds its own ``<param>`` children, and then there is no value."""

    name: Text
    value: TypedValue | None
    nested: tuple[Parameter, ...]
    place: Place


class ParameterFile(NamedTuple):
    """``<param from allow_substs>``. A text in ``allow_substs`` is judged when the node is executed, one without pieces, too."""

    file: Text
    allow_substs: Text | bool
    place: Place


class Parameters(NamedTuple):
    """A dict of params (Python only): launch writes one file of them, whatever their number."""

    entries: tuple[Parameter, ...]
    place: Place


ParameterSource: TypeAlias = "Parameter | Parameters | ParameterFile"


class Argument(NamedTuple):
    """``<arg>``: declares, and sets the default where nothing is set."""

    name: str
    default: Text | None
    description: str
    choices: tuple[str, ...] | None
    place: Place
    condition: Condition | None = None


class Let(NamedTuple):
    """``<let>``."""

    name: Text
    value: Text
    place: Place
    condition: Condition | None = None


class Include(NamedTuple):
    """``<include>``. ``description`` is what comes of no file (Python only): it is said to be from ``file`` then."""

    file: Text
    arguments: tuple[Pair, ...]
    place: Place
    condition: Condition | None = None
    description: Description | None = None


class Group(NamedTuple):
    """``<group>``: ``keep`` are the launch configurations that it sets (``GroupAction(launch_configurations=…)``)."""

    actions: tuple[Action, ...]
    scoped: bool | Text
    forwarding: bool | Text
    keep: tuple[Pair, ...]
    place: Place
    condition: Condition | None = None


class Process(NamedTuple):
    """What every started process has. Fields that the file does not give are None.

    ``command`` is the ``cmd`` of ``<executable>`` as words of texts; ``arguments`` the ``args``, split as launch splits them (see
    ``ExecuteProcess._parse_cmdline``), ``ros_arguments`` likewise. ``replaces_environment``: ``environment`` is all that it is given
    (Python only).
    """

    name: Text | None = None
    cwd: Text | None = None
    prefix: Text | None = None
    output: Text | None = None
    respawn: Text | bool | None = None
    respawn_delay: float | None = None
    respawn_max_retries: int | None = None
    sigterm_timeout: Text | None = None
    sigkill_timeout: Text | None = None
    emulate_tty: Text | bool | None = None
    shell: bool | None = None
    on_exit: Literal["shutdown"] | tuple[Action, ...] | None = None
    environment: tuple[Pair, ...] = ()
    additional_environment: tuple[Pair, ...] = ()
    replaces_environment: bool = False


class Executable(NamedTuple):
    """``<executable cmd>``."""

    command: tuple[Text, ...]
    process: Process
    place: Place
    condition: Condition | None = None


class Node(NamedTuple):
    """``<node>``, ``<node_container>`` and (Python) ``LifecycleNode``.

    ``namespace`` None: not given. ``package`` None: an executable on the path.
    """

    kind: Literal["node", "container", "lifecycle"]
    package: Text | None
    executable: Text
    name: Text | None
    namespace: Text | None
    arguments: tuple[Text, ...]
    ros_arguments: tuple[Text, ...]
    remaps: tuple[Remap, ...]
    parameters: tuple[ParameterSource, ...]
    components: tuple[Component, ...]
    process: Process
    place: Place
    condition: Condition | None = None


class Component(NamedTuple):
    """``<composable_node>``: part of a container or of ``<load_composable_node>``."""

    package: Text
    plugin: Text
    name: Text | None
    namespace: Text | None
    remaps: tuple[Remap, ...]
    parameters: tuple[ParameterSource, ...]
    extra_arguments: tuple[Parameter, ...]
    place: Place
    condition: Condition | None = None


class LoadComponents(NamedTuple):
    """``<load_composable_node target>``."""

    target: Text
    components: tuple[Component, ...]
    place: Place
    condition: Condition | None = None


class PushNamespace(NamedTuple):
    """``<push_ros_namespace>``."""

    namespace: Text
    place: Place
    condition: Condition | None = None


class SetRemap(NamedTuple):
    """``<set_remap>``."""

    source: Text
    target: Text
    place: Place
    condition: Condition | None = None


class SetParameter(NamedTuple):
    """``<set_parameter>``."""

    name: Text
    value: TypedValue
    place: Place
    condition: Condition | None = None


class SetParametersFromFile(NamedTuple):
    """``<set_parameters_from_file>``."""

    file: Text
    place: Place
    condition: Condition | None = None


class SetUseSimTime(NamedTuple):
    """``<set_use_sim_time>``."""

    value: Text | bool
    place: Place
    condition: Condition | None = None


class SetEnvironment(NamedTuple):
    """``<set_env>``."""

    name: Text
    value: Text
    place: Place
    condition: Condition | None = None


class UnsetEnvironment(NamedTuple):
    """``<unset_env>``."""

    name: Text
    place: Place
    condition: Condition | None = None


class AppendEnvironment(NamedTuple):
    """``<append_env>``."""

    name: Text
    value: Text
    prepend: Text | bool
    separator: Text | None
    place: Place
    condition: Condition | None = None


class ResetEnvironment(NamedTuple):
    """``<reset_env>``."""

    place: Place
    condition: Condition | None = None


class ReplaceEnvironment(NamedTuple):
    """``ReplaceEnvironmentVariables`` (Python only): from here on the environment is ``variables``, and nothing else."""

    variables: tuple[Pair, ...]
    place: Place
    condition: Condition | None = None


class Push(NamedTuple):
    """``PushEnvironment``, ``PushLaunchConfigurations`` (Python only): they are kept, as at the beginning of a group."""

    what: Literal["environment", "configurations"]
    place: Place
    condition: Condition | None = None


class Pop(NamedTuple):
    """``PopEnvironment``, ``PopLaunchConfigurations`` (Python only): those that were kept last are put back, as at the end of a group."""

    what: Literal["environment", "configurations"]
    place: Place
    condition: Condition | None = None


class Reset(NamedTuple):
    """``<reset>``: forgets the launch configurations but those in ``keep``."""

    keep: tuple[Pair, ...]
    place: Place
    condition: Condition | None = None


class SetLogDirectory(NamedTuple):
    """``<set_ros_log_dir>``."""

    directory: Text
    place: Place
    condition: Condition | None = None


class Log(NamedTuple):
    """``<log>``."""

    message: Text
    level: Text | None
    place: Place
    condition: Condition | None = None


class Shutdown(NamedTuple):
    """``<shutdown>``."""

    reason: Text
    place: Place
    condition: Condition | None = None


class Timer(NamedTuple):
    """``<timer>`` and ``<ros_timer>``: ``actions`` are executed later."""

    period: Text | float
    actions: tuple[Action, ...]
    place: Place
    condition: Condition | None = None
    cancel_on_shutdown: Text | bool | None = None


class Handler(NamedTuple):
    """``RegisterEventHandler`` (Python only): what is executed when something happens, later; ``event`` is the class of the handler.

    ``actions`` are what it executes, or a function that gives them then. ``target`` is the place of the action whose process it waits
    for, if that is known.
    """

    event: str
    actions: tuple[Action, ...] | Call
    place: Place
    condition: Condition | None = None
    target: Place | None = None


class Transition(NamedTuple):
    """What may take lifecycle nodes from one state to the next (Python only): ``LifecycleTransition``, an event that asks for that."""

    place: Place
    condition: Condition | None = None


class Opaque(NamedTuple):
    """``OpaqueFunction`` and the loops: what is called when it is executed, with the context of that moment, gives further actions."""

    call: Call
    place: Place
    condition: Condition | None = None


class Turn(NamedTuple):
    """One turn of a loop (XML and YAML only): at its end ``$(dirname)`` and ``$(filename)`` say what they said before it."""

    actions: tuple[Action, ...]
    place: Place
    condition: Condition | None = None


class Unset(NamedTuple):
    """``UnsetLaunchConfiguration`` (Python only)."""

    name: Text
    place: Place
    condition: Condition | None = None


class Maybe(NamedTuple):
    """Actions of a program of which it is not known whether they are there, and why."""

    actions: tuple[Action, ...]
    reason: str
    place: Place
    condition: Condition | None = None


class Open(NamedTuple):
    """Here a program may have put any other actions, for a ``reason``."""

    reason: str
    place: Place
    condition: Condition | None = None


class Unsettled(NamedTuple):
    """Here a program may end with an error, for a ``reason``."""

    reason: str
    place: Place
    condition: Condition | None = None


class Fails(NamedTuple):
    """Here launch stops when it comes to it: ``problem`` is what it stops for (Python only)."""

    problem: Problem
    place: Place
    condition: Condition | None = None


Action: TypeAlias = (
    "Argument | Let | Include | Group | Executable | Node | LoadComponents | PushNamespace | SetRemap | SetParameter"
    " | SetParametersFromFile | SetUseSimTime | SetEnvironment | UnsetEnvironment | AppendEnvironment | ResetEnvironment"
    " | ReplaceEnvironment | Push | Pop | Reset | SetLogDirectory | Log | Shutdown | Timer | Handler | Transition | Opaque | Turn | Unset"
    " | Maybe | Open | Unsettled | Fails"
)


class Description(NamedTuple):
    """All that one file describes, in order; ``actions`` hold what could be understood where launch refuses the file."""

    actions: tuple[Action, ...]
    place: Place
