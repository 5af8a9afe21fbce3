"""``<executable>``, and what every process that is started has (launch.actions.ExecuteLocal, launch.descriptions.Executable)."""

from __future__ import annotations

from collections.abc import Iterable

from launchlint.evaluate.ros2.context import Value
from launchlint.evaluate.ros2.problems import UnsplittablePrefix
from launchlint.evaluate.ros2.setting_actions import truth
from launchlint.evaluate.ros2.walk import Walk
from launchlint.model import Executable, Process, Unknown, shown_text
from launchlint.named_tuple import NamedTuple
from launchlint.source import Place
from launchlint.syntax.problems import InvalidValue
from launchlint.syntax.ros2 import description as described
from launchlint.syntax.ros2.description import Text
from launchlint.words import split_words

TYPE_CHECKING = False
if TYPE_CHECKING:
    from launchlint.model import Role

OUTPUTS = ("screen", "log", "both", "own_log", "full")
PREFIX = "launch-prefix"
VARIABLES_PER_ACTION = 8
"""How many environment variables that a process is given count as one more action: each process has them all."""


class Prepared(NamedTuple):
    """A process that is ready to be started; ``unknown`` are the roles whose values are not known."""

    words: tuple[Value, ...]
    label: Value
    cwd: Value | None
    prefix: Value
    environment: dict[str, str | None]
    respawn: bool
    output: Value
    unknown: frozenset[Role]
    open_environment: bool = False


def prepare(walk: Walk, process: described.Process, words: Iterable[Value], tag: str, place: Place) -> Prepared:
    """The rest of what launch works out before it starts a process whose words have been performed, in its order.

    A ``launch-prefix`` that is a launch configuration counts where the tag has none, and names the process.
    """
    words = tuple(words)
    unknown: set[Role] = set()
    prefix: Value = ""
    if process.prefix is not None:
        prefix = walk.value(process.prefix)
    else:
        setting = walk.context.get(PREFIX)
        if setting is not None:
            prefix = setting.value
    first = words[0] if words else ""
    if isinstance(prefix, str):
        try:
            before = split_words(prefix)
            first = before[0] if before else first
        except ValueError:
            at = place if process.prefix is None else process.prefix.place
            walk.record(UnsplittablePrefix(origin=walk.at(at), refused=True, value=prefix))
    else:
        unknown.add("prefix")
    label = first if isinstance(first, Unknown) else first.rpartition("/")[2]
    if process.name is not None:
        label = walk.value(process.name)
    cwd = walk.optional(process.cwd)
    if isinstance(cwd, Unknown):
        unknown.add("cwd")
    environment = _environment(walk, process, place)
    respawn: bool | None = False
    if isinstance(process.respawn, Text):
        respawn = truth(walk, process.respawn, tag, "respawn")
    elif process.respawn is not None:
        respawn = process.respawn
    output: Value = "log" if process.output is None else walk.value(process.output)
    if isinstance(output, Unknown):
        unknown.add("output")
    elif output not in OUTPUTS and process.output is not None:
        at = process.output.place
        walk.record(
            InvalidValue(origin=walk.at(at), refused=True, tag=tag, attribute="output", value=output,
                         expected="one of " + ", ".join(OUTPUTS), choices=OUTPUTS)
        )  # fmt: skip
    return Prepared(words, label, cwd, prefix, environment, bool(respawn), output, frozenset(unknown), walk.context.unread_environment)


def _environment(walk: Walk, process: described.Process, place: Place) -> dict[str, str | None]:
    """What differs from the environment that launch was started with."""
    environment = walk.context.environment
    walk.spend(len(environment.changes) // VARIABLES_PER_ACTION, place)
    after: dict[str, Value | None] = dict(environment.changes)
    if process.replaces_environment:
        after = dict.fromkeys((*environment.session.environment, *environment.changes))
    for pair in (*process.environment, *process.additional_environment):
        name, value = walk.value(pair.name), walk.value(pair.value)
        if isinstance(name, str):
            after[name] = value
    changed: dict[str, str | None] = {}
    for name, given in after.items():
        if given != environment.session.variable(name):
            changed[name] = given if given is None else text_of(given)
    return changed


def text_of(value: Value) -> str:
    """A value as it is shown: what is known of it, and what is written where nothing is."""
    return shown_text(value)


def process_of(prepared: Prepared, process: described.Process, arguments: Iterable[Value], ros_arguments: Iterable[Value]) -> Process:
    """What the model says of it."""
    on_exit = process.on_exit if process.on_exit is None or isinstance(process.on_exit, str) else "actions"
    return Process(
        tuple(map(text_of, arguments)),
        tuple(map(text_of, ros_arguments)),
        text_of(prepared.label),
        prepared.environment,
        bool(process.shell),
        on_exit,
        process.respawn_delay,
        prepared.open_environment,
    )


def executable(walk: Walk, action: described.Executable) -> None:
    """``<executable>``."""
    process = action.process
    prepared = prepare(walk, process, [walk.value(word) for word in action.command], "executable", action.place)
    unknown: frozenset[Role] = frozenset(("executable",)) if any(isinstance(word, Unknown) for word in prepared.words) else frozenset()
    here = walk.here
    before = prefix_words(prepared.prefix)
    walk.programs.append(
        Executable(
            (*before, *map(text_of, prepared.words)), process_of(prepared, process, (), ()),
            None if prepared.cwd is None else text_of(prepared.cwd), text_of(prepared.output), text_of(prepared.prefix) or None,
            prepared.respawn, process.respawn_delay or 0.0, here.file, walk.at(action.place), here.scope, here.conditions, here.deferred,
            prepared.unknown | unknown,
        )
    )  # fmt: skip
    exits(walk, process)


def prefix_words(prefix: Value) -> tuple[str, ...]:
    """The words of a prefix; none where it cannot be split."""
    try:
        return tuple(split_words(text_of(prefix)))
    except ValueError:
        return ()


def exits(walk: Walk, process: described.Process) -> None:
    """What follows the end of a process is executed later."""
    if process.on_exit is not None and not isinstance(process.on_exit, str):
        walk.defer("on_exit", process.on_exit)
