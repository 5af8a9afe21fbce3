"""Evaluate one entry file: the one door through which other rooms come in."""

from __future__ import annotations

import sys
from collections.abc import Iterable, Mapping, Set

from launchlint.evaluate.assemble import Evaluation, assemble, not_loadable
from launchlint.evaluate.block import Block, Side, Value
from launchlint.evaluate.names import as_namespace
from launchlint.evaluate.ros1.entering import Entering
from launchlint.evaluate.ros1.file import NO_DEFAULTS, Declaration, Exhausted, Progress
from launchlint.evaluate.ros1.launch_tags import enter
from launchlint.evaluate.session import Read, Session
from launchlint.finding import whole_file
from launchlint.late import late
from launchlint.named_tuple import NamedTuple
from launchlint.source import Origin, Source
from launchlint.syntax.problems import RootNotLaunch, UnreadableFile

DEEPEST_STACK = 12_000
"""Python frames: 900 nested groups or 300 nested includes need about 3,000; both depths are bounded where they are read."""
_ASSIGNMENT = late(r"(?:[~/A-Za-z]|__?)[\w/]*")


def command_line(pairs: Iterable[tuple[str, str]]) -> dict[str, str]:
    """The args roslaunch takes from ``name:=value`` words (rosgraph.names.load_mappings).

    Empty values, ``_private:=`` parameters and names that are no names are dropped silently, as roslaunch does.
    """
    arguments: dict[str, str] = {}
    for name, value in pairs:
        name, value = name.strip(), value.strip()
        if not name or not value or ":=" in value or "\n" in value or _ASSIGNMENT.fullmatch(name) is None:
            continue
        if len(name) > 1 and name[0] == "_" and name[1] != "_":
            continue
        arguments[name] = value
    return arguments


class Entered(NamedTuple):
    """An entry file worked out in one configuration, and not yet put together."""

    block: Block
    file: str
    arguments: Mapping[str, str]
    given: tuple[tuple[str, str], ...]
    pinned: frozenset[str]

    def assembled(self) -> Evaluation:
        """What it comes to."""
        return assemble(self.block, self.file, self.arguments, self.given, self.pinned)


def evaluate(
    session: Session,
    file: str,
    given: tuple[tuple[str, str], ...] = (),
    pinned: frozenset[str] = frozenset(),
    defaults: Mapping[Declaration, Value] = NO_DEFAULTS,
) -> Evaluation:
    """What ``roslaunch FILE name:=value …`` would start. Never raises for anything the file holds.

    ``pinned`` names args that people fixed, which therefore do not count as steering any condition. ``defaults`` are taken in place of
    empty defaults, by where the arg is declared.
    """
    entered = enter_entry(session, file, given, pinned, defaults)
    return entered.assembled() if isinstance(entered, Entered) else entered


def enter_entry(
    session: Session,
    file: str,
    given: tuple[tuple[str, str], ...] = (),
    pinned: frozenset[str] = frozenset(),
    defaults: Mapping[Declaration, Value] = NO_DEFAULTS,
) -> Entered | Evaluation:
    """As :func:`evaluate`, up to the dear step of putting the included files together; the whole of it where nothing can be started."""
    progress = Progress(defaults, frozenset(session.named(path) for path, _ in defaults))
    if sys.getrecursionlimit() < DEEPEST_STACK:
        sys.setrecursionlimit(DEEPEST_STACK)
    document = session.document(file)
    if isinstance(document, Read):
        source = Source(session.shown(file), "", file)
        problem = UnreadableFile(origin=Origin(whole_file(source)), refused=True, reason=document.reason)
        return not_loadable(source, None, given, problem)
    if document.launch is None:
        nothing = RootNotLaunch(origin=Origin(whole_file(document.source)), refused=True)
        return not_loadable(document.source, document, given, document.problems[0] if document.problems else nothing)
    arguments = command_line(given)
    namespace = next((value for name, value in given if name == "__ns"), session.variable("ROS_NAMESPACE") or "/")
    try:
        namespace = as_namespace(namespace)
    except ValueError:
        namespace = "/"
    values: dict[str, Value] = dict(arguments)
    entering = Entering(file, namespace, values, pass_all=False, private_above=False, default_machine=None, is_entry=True)
    try:
        block = enter(session, document, entering, file, progress)
    except Exhausted as exhausted:
        return not_loadable(document.source, document, given, exhausted.args[0])
    return Entered(block, file, arguments, given, pinned)


def enter_unless_seen(
    session: Session, file: str, given: tuple[tuple[str, str], ...], pinned: frozenset[str], seen: Set[Side] | None
) -> Evaluation | None:
    """As :func:`evaluate`; None where no side of a condition would be taken that is not in ``seen``."""
    entered = enter_entry(session, file, given, pinned)
    if not isinstance(entered, Entered):
        return entered
    return None if seen is not None and entered.block.sides <= seen else entered.assembled()
