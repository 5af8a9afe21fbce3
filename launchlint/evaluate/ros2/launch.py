"""Evaluate one entry file as ``ros2 launch`` does: the one door through which other rooms come in."""

from __future__ import annotations

import sys
from collections import Counter

from launchlint.evaluate.assemble import Evaluation, not_loadable
from launchlint.evaluate.ros2.actions import execute
from launchlint.evaluate.ros2.executed_files import ExecutedFiles, executed_files
from launchlint.evaluate.ros2.including import enter
from launchlint.evaluate.ros2.judged_keys import for_nobody
from launchlint.evaluate.ros2.leaving import undeclared
from launchlint.evaluate.ros2.performing import rules_of
from launchlint.evaluate.ros2.programs import Live
from launchlint.evaluate.ros2.same_names import duplicates
from launchlint.evaluate.ros2.walk import Exhausted, Walk
from launchlint.evaluate.session import Read, Session
from launchlint.finding import whole_file
from launchlint.model import ROS2, Followed, Launch, ScopedSetting
from launchlint.source import Origin, Place, Source, Span
from launchlint.syntax.problems import UnreadableFile
from launchlint.syntax.ros2.description import Open, Unsettled
from launchlint.workspace.discovery import is_program

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Iterator
    from typing import Literal, TypeAlias

    State: TypeAlias = Literal["resolved", "partly", "not"]
    from launchlint.evaluate.ros2.repeating import Repeats
    from launchlint.syntax.ros2.live import LiveContext
    from launchlint.syntax.ros2.reading import Reading

DEEPEST_STACK = 12_000
"""Python frames: 200 nested includes with groups between them need some thousands."""


def evaluate(
    session: Session,
    file: str,
    given: tuple[tuple[str, str], ...] = (),
    pinned: frozenset[str] = frozenset(),
    repeats: Repeats | None = None,
) -> Evaluation:
    """What ``ros2 launch FILE name:=value …`` would start. Never raises for anything the file holds.

    ``pinned`` names args that people fixed, which therefore do not count as steering any condition. ``repeats`` holds what is known of the
    other configurations of the same entry file.
    """
    if sys.getrecursionlimit() < DEEPEST_STACK:
        sys.setrecursionlimit(DEEPEST_STACK)
    session.fresh = fresh
    session.arguments = given
    walk = Walk(session, file, rules_of(session.distro), pinned, execute, repeats)
    walk.performer.live = lambda place: Live(walk, place)
    known = walk.read(file)
    if isinstance(known, Read):
        source = Source(session.shown(file), "", file)
        problem = UnreadableFile(origin=Origin(whole_file(source)), refused=True, reason=known.reason)
        evaluation = not_loadable(source, None, given, problem)
        launch = evaluation.launch._replace(dialect=ROS2, distro=walk.rules.distro, named_by=session.named_by, named=session.meant.named)
        return evaluation._replace(launch=launch)
    files: ExecutedFiles | None = None
    try:
        enter(walk, file, known, dict(given))
        walk.finish()
        walk.here = walk.here._replace(assumed=False)
        for told in for_nobody(walk.receivers, walk.performer):
            walk.record_once(told)
        files = executed_files(walk, known.description)
        for told in undeclared(walk, files):
            walk.record(told)
        for told in duplicates(walk.nodes):
            walk.record(told)
        for told in files.useless:
            walk.record(told)
    except Exhausted as exhausted:
        walk.record(exhausted.args[0])
        walk.exhausted = True
    return _evaluation(walk, known, given, files or ExecutedFiles(walk, known.description))


def fresh(session: Session, file: str) -> LiveContext:
    """The context of a launch in which nothing has been executed: what a program has that makes one itself."""
    walk = Walk(session, file, rules_of(session.distro), frozenset(), execute)
    walk.performer.live = lambda place: Live(walk, place)
    return Live(walk, Place(Source(session.shown(file), "", file), Span(0, 0)))


def _followed(walk: Walk) -> Iterator[Followed]:
    """The programs among the files, each once, with what is not known of them."""
    seen: set[str] = set()
    for reading in walk.readings:
        path = reading.source.path
        if path in seen or not is_program(reading.source.file, reading.source.text[:1].encode()):
            continue
        seen.add(path)
        said = [*reading.unresolved, *(each for each in walk.unresolved if each.place.source.path == path)]
        only = [each for each in reading.description.actions if not isinstance(each, Unsettled)]
        nothing = len(only) == 1 and isinstance(only[0], Open)
        state: State = "not" if nothing else "partly" if said else "resolved"
        yield Followed(reading.source, state, tuple(dict.fromkeys((each.place, each.reason) for each in said)))


def _settings(walk: Walk) -> Iterator[ScopedSetting]:
    """The remaps that stand outside of nodes, each with how many nodes have it."""
    if not walk.set_remaps:
        return
    reached = Counter(remap.origin.place.key for node in walk.nodes for remap in node.remaps)
    for remap, conditions in walk.set_remaps:
        yield ScopedSetting("remap", remap.source, remap, remap.origin, reached[remap.origin.place.key], (), None, conditions)


def _evaluation(walk: Walk, known: Reading, given: tuple[tuple[str, str], ...], files: ExecutedFiles) -> Evaluation:
    session = walk.session
    launch = Launch(
        entry=known.source,
        arguments=dict(given),
        given=given,
        refused=walk.refused,
        problems=tuple(walk.problems),
        nodes=tuple(walk.nodes),
        tests=(),
        parameters={},
        parameter_settings=(),
        clear_params=(),
        machines={},
        executables=(),
        includes=tuple(walk.includes),
        settings=tuple(_settings(walk)),
        declared=tuple(each.argument for each in walk.declared),
        declarations=tuple(walk.declared),
        branches=tuple(walk.branches),
        files=tuple(walk.files),
        complete=not walk.unread and not walk.exhausted,
        dialect=ROS2,
        distro=walk.rules.distro,
        named_by=session.named_by,
        named=session.meant.named,
        programs=tuple(walk.programs),
        listed=files.listed,
        late=tuple(walk.late),
        settled=not walk.unsettled,
        followed=tuple(_followed(walk)),
        transitions=tuple(walk.transitions),
    )
    documents = {reading.source.path: reading.document for reading in walk.readings if reading.document is not None}
    compared: dict[str, dict[str, None]] = {}
    for name, values in walk.performer.compared:
        compared.setdefault(name, {}).update(dict.fromkeys(values))
    return Evaluation(launch, documents, {}, {name: tuple(values) for name, values in compared.items()})
