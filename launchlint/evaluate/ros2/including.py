"""``<include>``, and how the entry file is entered (launch.actions.IncludeLaunchDescription)."""

from __future__ import annotations

import os

from launchlint.evaluate.problems import IncludeCycle, IncludeMissingArg, IncludeNotFound, RequiredArgUnset
from launchlint.evaluate.ros2.context import Setting
from launchlint.evaluate.ros2.passing import Entered
from launchlint.evaluate.ros2.problems import RequiredArgNotPassed
from launchlint.evaluate.ros2.setting_actions import configure
from launchlint.evaluate.ros2.walk import DEEPEST_INCLUDE, STARTING, Exhausted, Here, Told, Walk
from launchlint.evaluate.session import Read
from launchlint.model import Include, Scope, Unknown, shown_text
from launchlint.source import IncludeStep, Origin
from launchlint.syntax.ros2 import description as described
from launchlint.syntax.ros2.description import Description

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Mapping

    from launchlint.syntax.ros2.reading import Reading


def include(walk: Walk, action: described.Include) -> None:
    """Load the file, look at what it must be passed, pass the args one after the other, and execute it. Nothing of it is put back."""
    walk.spend(STARTING, action.place)
    file, steer, outside = walk.known(action.file)
    origin = walk.at(action.place)
    context = walk.context
    pushed = context.namespace
    below = pushed.rstrip("/") + "/" if isinstance(pushed, str) else "/"
    entry = Include(
        shown_text(file), None, below, {}, False, origin, walk.here.scope, walk.here.conditions,
        None if pushed is None else shown_text(pushed), walk.here.deferred, walk.here.file,
    )  # fmt: skip
    way = (*walk.here.way, id(action))
    if action.description is not None:
        _made(walk, action, action.description, entry, way, file)
        return
    if isinstance(file, Unknown):
        walk.includes.append(entry)
        walk.entered.append(Entered(way, walk.here.step, None, (), ""))
        _pass(walk, action, way)
        _unread(walk)
        return
    if len(walk.here.files) >= DEEPEST_INCLUDE - 1:
        _too_deep(walk, action, file)
    walk.session.checkpoint()
    known = walk.read(file)
    if isinstance(known, Read):
        walk.record(
            IncludeNotFound(origin=walk.at(action.file.place), refused=True, file=file, written=action.file.place.text,
                            reason=known.reason, environment=outside)
        )  # fmt: skip
        walk.includes.append(entry)
        walk.entered.append(Entered(way, walk.here.step, None, (), ""))
        _pass(walk, action, way)
        _unread(walk)
        return
    absolute = os.path.abspath(file)
    context.enter(os.path.dirname(absolute), absolute)
    outer = walk.here
    step = walk.step_to(action.place)
    _tell_refusals(walk, known, step)
    named = [(name, pair.place) for pair in action.arguments if isinstance(name := walk.value(pair.name), str)]
    names = [name for name, _ in named]
    told = _missing(walk, known.description, names, action)
    at = len(walk.includes)
    walk.includes.append(entry)
    walk.includes[at] = entry._replace(source=known.source, arguments=_pass(walk, action, way))
    scope = Scope("include", origin, below, outer.scope)
    walk.entered.append(
        Entered(
            way,
            step,
            _names_in(known),
            tuple((name, walk.at(place)) for name, place in named),
            known.source.path,
            known.refusal is not None,
        )
    )
    walk.executed[way] = known.description
    walk.executions.append((way, known.description))
    walk.here = Here(
        file, step, (*outer.files, absolute), scope, outer.conditions, outer.assumed, outer.deferred, outer.told | told, way,
        (*outer.sources, id(action.file)), outer.idle, outer.around | steer,
    )  # fmt: skip
    walk.performer.way = way
    _run(walk, known, file)
    walk.here, walk.performer.way = outer, outer.way
    if walk.session.hangs_on_arguments(file):
        context.uses.open = True


def _made(
    walk: Walk, action: described.Include, description: Description, entry: Include, way: tuple[int, ...], location: str | Unknown
) -> None:
    """Include what the program has made (launch.LaunchDescriptionSource): no file is read, and what it reads and declares the program does.

    Its location is taken for the path of the launch file, and for the directory too where there is no such file.
    """
    outer = walk.here
    file = location if isinstance(location, Unknown) else os.path.abspath(location)
    directory = os.path.dirname(file) if isinstance(file, str) and walk.session.exists(file) else location
    walk.context.enter(directory, file)
    names = [name for pair in action.arguments if isinstance(name := walk.value(pair.name), str)]
    told = _missing(walk, description, names, action)
    at = len(walk.includes)
    walk.includes.append(entry)
    walk.includes[at] = entry._replace(file=shown_text(file), arguments=_pass(walk, action, way))
    scope = Scope("include", walk.at(action.place), entry.namespace, outer.scope)
    walk.here = outer._replace(file=shown_text(file), scope=scope, told=outer.told | told)
    walk.execute(description.actions)
    walk.here = outer


def _unread(walk: Walk) -> None:
    """Go on behind an included file that is not read: it may start more nodes, and set what others read."""
    walk.unread.append(walk.here.file)
    walk.context.include_unread()


def enter(walk: Walk, file: str, known: Reading, given: Mapping[str, str]) -> None:
    """Execute the entry file with the args of the command line."""
    context = walk.context
    absolute = os.path.abspath(file)
    context.enter(os.path.dirname(absolute), absolute)
    _tell_refusals(walk, known, None)
    told = _missing(walk, known.description, list(given), None)
    for name, value in given.items():
        steer = frozenset() if name in walk.pinned else frozenset((name,))
        context.set(name, Setting(value, None, "given", steer, same=name))
    walk.here = Here(file, None, (absolute,), told=told)
    walk.entered.append(Entered((), None, _names_in(known), (), known.source.path, known.refusal is not None))
    _run(walk, known, file)


def _names_in(known: Reading) -> Description | None:
    """Where all that the file can read is written; not so of a program of which not all is known."""
    is_program = known.source.file.endswith(".py")
    return None if known.unresolved or (is_program and known.refusal is not None) else known.description


def _run(walk: Walk, known: Reading, file: str) -> None:
    walk.files.append(file)
    walk.readings.append(known)
    walk.execute(known.description.actions)


def _pass(walk: Walk, action: described.Include, way: tuple[int, ...]) -> dict[str, str | Unknown]:
    """Set the args: each of them before the next one is evaluated, so that later ones see earlier ones."""
    passed: dict[str, str | Unknown] = {}
    for pair in action.arguments:
        done = configure(walk, pair, passed=way)
        if done is not None:
            passed[done[0]] = done[1]
    return passed


def _tell_refusals(walk: Walk, known: Reading, step: IncludeStep | None) -> None:
    """What is wrong with a file as it is written: the whole of it is read before anything is executed."""
    for number, problem in enumerate(known.problems):
        walk.record(problem.but(origin=Origin(problem.place, step)), ("as it is written", known.source.path, number))


def _missing(
    walk: Walk, description: Description, names: list[str], action: described.Include | None
) -> frozenset[tuple[str, tuple[str, int]]]:
    """Tell which args without a default are not passed (to the entry file: not given), whatever is set already.

    What includes further below pass counts from the first arg on that is reached through them, as it does for launch.
    """
    listing = walk.lister.list(description)
    passed = set(names)
    told: set[tuple[str, tuple[str, int]]] = set()
    for shown in listing.required:
        argument = shown.argument
        if shown.through is not None:
            passed |= listing.passed[shown.through] or frozenset()
        at = (argument.name, argument.place.key)
        if argument.name in passed or walk.has_told(at):
            continue
        told.add(at)
        _tell_missing(walk, shown.argument, shown.include, names, action)
    return frozenset(told)


def _tell_missing(
    walk: Walk, argument: described.Argument, through: described.Include | None, names: list[str], action: described.Include | None
) -> None:
    related = ((argument.place, "declared here without a default"),)
    source = argument.place.source
    passed = tuple(sorted(names))
    if action is not None:
        origin = walk.at(action.file.place)
        if walk.context.get(argument.name) is not None:
            walk.record(
                RequiredArgNotPassed(origin=origin, refused=True, related=related, name=argument.name, file=source.path, passed=passed,
                                     target=source.file)
            )  # fmt: skip
            return
    elif through is None:
        walk.record(RequiredArgUnset(origin=walk.at(argument.place), refused=True, name=argument.name))
        return
    else:
        origin = walk.at(through.file.place)
    walk.record(
        IncludeMissingArg(origin=origin, refused=True, related=related, name=argument.name, file=source.path, passed=passed,
                          target=source.file, pass_all=False)
    )  # fmt: skip
    if walk.context.get(argument.name) is None:
        missing = Told(f"$(var {argument.name})", f"the arg {argument.name} has no value")
        steer = frozenset((argument.name,))
        walk.context.set(argument.name, Setting(missing, walk.at(argument.place), "missing", steer, same=argument.name))


def _too_deep(walk: Walk, action: described.Include, file: str) -> None:
    """Files that include each other without end: told at the include that leads back for the first time. Raises Exhausted."""
    files = (*walk.here.files, os.path.abspath(file))
    again = next((index for index, each in enumerate(files) if each in files[:index]), 0)
    start = files.index(files[again])
    cycle = files[start : again + 1] if again else files[-2:]
    places = (*(walk.here.step.outermost_first() if walk.here.step is not None else ()), action.place)
    step: IncludeStep | None = None
    for place in places[: max(again - 1, 0)]:
        step = IncludeStep(place, step)
    place = places[max(again - 1, 0)]
    shown = tuple(walk.session.shown(each) for each in cycle)
    raise Exhausted(IncludeCycle(origin=Origin(place, step), refused=True, cycle=shown, endless=bool(again), depth=len(files)))
