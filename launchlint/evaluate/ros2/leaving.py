"""What outlives the file or group that set it, and what is gone when it is read: ROS 2 launch has one context for all files.

An include puts nothing back, a group puts back all but two lists, and what waits for a timer is executed with what is in force at the end.
"""

from __future__ import annotations

from collections.abc import Callable, Container, Iterable, Iterator, Mapping, Sequence

from launchlint.evaluate.ros2.context import NAMESPACE, Setting, Value
from launchlint.evaluate.ros2.executed_files import is_python
from launchlint.evaluate.ros2.names_read import OF_LAUNCH, parts_of
from launchlint.evaluate.ros2.parameters import GlobalParameter
from launchlint.evaluate.ros2.performing import Failure, Performer
from launchlint.evaluate.ros2.problems import DefaultOverruled, LeaksFromGroup, NamespaceLeft, ScopeLost, UndeclaredRead
from launchlint.model import Remap, Unknown
from launchlint.source import Origin, Place
from launchlint.syntax.ros2 import description as described
from launchlint.syntax.ros2.description import Action, Description, Substitution, Text

TYPE_CHECKING = False
if TYPE_CHECKING:
    from launchlint.evaluate.ros2.executed_files import ExecutedFiles
    from launchlint.evaluate.ros2.parameters import GlobalSource
    from launchlint.evaluate.ros2.walk import Walk
    from launchlint.problem import Problem

_MOST_WORK = 200_000
_FROM_FILE = "set_parameters_from_file"
_STARTS = (described.Node, described.Include, described.LoadComponents, described.Executable)


def note_overruled(walk: Walk, action: described.Argument, setting: Setting) -> None:
    """Record that the default of an arg does not count, where nobody may know: see :class:`DefaultOverruled`.

    What a file was passed, or a file around it, is meant; so is a ``<let>`` of a file around.
    """
    way, origin = walk.here.way, setting.origin
    left = setting.is_left_at(way)
    if action.default is None or origin is None or origin.place.key == action.place.key:
        return
    if setting.how != "default" and not (left and setting.how in ("passed", "let")):
        return
    if left and not _starts_something(walk, setting.way):
        return  # it is there for what it sets
    default = _quietly(walk, action.default)
    if isinstance(default, str) and isinstance(setting.value, str) and default != setting.value:
        walk.record(
            DefaultOverruled(
                origin=walk.at(action.place),
                related=((origin.place, "this counts"),),
                name=action.name,
                default=default,
                value=setting.value,
                how=setting.how,
                left=left,
                same_file=setting.way == way,
                setter=origin.place.source.path,
            )
        )


def _quietly(walk: Walk, text: Text) -> Value | None:
    """What a text stands for, where nothing comes of working that out: nothing is recorded, and no name is made."""
    literal = text.literal
    if literal is not None:
        return literal
    if is_anonymous(text):
        return None
    mine = walk.performer
    quiet = Performer(mine.session, mine.context, mine.entry, mine.rules, mine.where, mine.spend, tell_nobody, mine.table)
    try:
        return quiet.perform(text)
    except Failure:
        return None


def is_anonymous(text: Text) -> bool:
    """Whether a name is made up for each start, as it is written."""
    return any(isinstance(part, Substitution) and part.name == "anon" for part, _ in parts_of(text))


def tell_nobody(problem: Problem) -> None:
    """What is only looked at in advance, or once more, is told of elsewhere."""


def undeclared(walk: Walk, files: ExecutedFiles) -> Iterator[Problem]:
    """What included files read and neither declare nor set, nor any file that they include: only who includes them does.

    ``files`` are those that were executed.
    """
    executed = walk.executed
    foreign: dict[tuple[tuple[int, ...], str], tuple[Origin, Setting]] = {}
    for way, name, origin, setting in walk.performer.foreign:
        foreign.setdefault((way, name), (origin, setting))
    if len(foreign) * len(executed) > _MOST_WORK:
        return
    for (way, name), (origin, setting) in foreign.items():
        description = executed.get(way)
        if description is None or setting.origin is None or name in OF_LAUNCH or name.startswith("anon"):
            continue
        if is_python(description):
            continue
        known = files.names_below(way)
        if known is None or any(name in names.declared or name in names.set for names in known):
            continue
        yield UndeclaredRead(
            origin=origin,
            related=((setting.origin.place, "set here"),),
            name=name,
            setter=setting.origin.place.source.path,
            left=setting.is_left_at(way) and _starts_something(walk, setting.way),
        )


def note_leaks(walk: Walk, place: Place, node: str) -> None:
    """Record what a group has set that is closed already, and that acts on the ``node`` at ``place``: it would get another value else."""
    context = walk.context
    if not context.leaked:
        return
    same = {*_same_params(context.parameters or (), context.leaked), *_same_remaps(context.remaps or (), context.leaked)}
    for each in (*(context.remaps or ()), *(context.parameters or ())):
        if id(each) in context.leaked and id(each) not in same:
            tag = "set_remap" if isinstance(each, Remap) else "set_parameter" if isinstance(each, GlobalParameter) else _FROM_FILE
            walk.record_once(LeaksFromGroup(origin=each.origin, related=((place, "and so acts on this, too"),), tag=tag, node=node))


def _same_params(given: Sequence[GlobalSource], leaked: Container[int]) -> Iterator[int]:
    """The identities of what has leaked of params that have one value with it and without it: of several the last counts.

    What a file sets is not looked at.
    """
    params = [each for each in given if isinstance(each, GlobalParameter)]
    if len(params) < len(given):
        return
    without = {each.name: each for each in params if id(each) not in leaked}
    last = {each.name: each for each in params}
    for each in params:
        own = without.get(each.name)
        if own is not None and _kind(own) is not None and _kind(own) == _kind(last[each.name]):
            yield id(each)


def _kind(param: GlobalParameter) -> tuple[object, ...] | None:
    """What two params that are the same agree in; None for one that is not known."""
    return (
        None if isinstance(param.name, Unknown) or isinstance(param.value, Unknown) else (type(param.value), repr(param.value), param.meant)
    )


def _same_remaps(given: Sequence[Remap], leaked: Container[int]) -> Iterator[int]:
    """The identities of what has leaked of remaps of one name that all lead to one other, one of them not leaked."""
    targets: dict[str, set[str]] = {}
    for each in given:
        targets.setdefault(each.source, set()).add(each.target)
    own = {each.source for each in given if each.source and id(each) not in leaked}
    yield from (id(each) for each in given if each.source in own and len(targets[each.source]) == 1)


def note_namespace(walk: Walk, own: Value | None, place: Place) -> None:
    """Record that something gets a namespace that an included file has pushed, and left when its end was reached."""
    setting = walk.context.get(NAMESPACE)
    if setting is None or setting.origin is None or not setting.is_left_at(walk.here.way) or not isinstance(setting.value, str):
        return
    absolute = own is not None and (not isinstance(own, str) or own.startswith("/"))
    if not absolute and _starts_something(walk, setting.way):
        walk.record_once(
            NamespaceLeft(
                origin=setting.origin,
                related=((place, "this gets it, too"),),
                namespace=setting.value,
                file=setting.origin.place.source.path,
            )
        )


def _starts_something(walk: Walk, way: tuple[int, ...]) -> bool:
    """Whether the file that ``way`` leads to is known to start anything, in whatever branch."""
    description = walk.context.uses.asked[way] = walk.executed.get(way)
    return description is not None and walk.session.once(description, _starts)


def _starts(description: Description) -> bool:
    """Whether anything is started by a file; else it is there for what it sets."""
    return any(isinstance(part, _STARTS) for part, _ in parts_of(description.actions))


def lost_in(
    actions: tuple[Action, ...],
    inside: Mapping[str, Setting],
    at_the_end: Mapping[str, Setting],
    kind: str,
    at: Callable[[Place], Origin],
) -> Iterator[Problem]:
    """What ``actions`` read that has a value in the group around them, and another one, or none, when they are executed."""
    if inside is at_the_end:
        return
    told: set[str] = set()
    own = set(_set_in(actions))
    for part, _ in parts_of(actions):
        name, place = _read_by(part)
        if name is None or place is None or name in told or name in own:
            continue
        meant, found = inside.get(name), at_the_end.get(name)
        if meant is None or not isinstance(meant.value, str) or (found is not None and not isinstance(found.value, str)):
            continue
        if name == NAMESPACE and not meant.value.strip("/"):
            continue  # the root, where everything is without one
        if found is None or found.value != meant.value:
            told.add(name)
            related = () if meant.origin is None else ((meant.origin.place, "its value in the group"),)
            yield ScopeLost(
                origin=at(place),
                related=related,
                name="" if name == NAMESPACE else name,
                value=meant.value,
                instead=None if found is None or not isinstance(found.value, str) else found.value,
                later=kind,
            )


def _read_by(part: object) -> tuple[str | None, Place | None]:
    """The configuration that a part of a description reads, and where."""
    if isinstance(part, Substitution):
        return (part.arguments[0].literal if part.name == "var" and len(part.arguments) == 1 else None), part.place
    if isinstance(part, (described.Node, described.Component)):
        namespace = part.namespace
        absolute = namespace is not None and bool(namespace.pieces) and str(namespace.pieces[0]).startswith("/")
        return (None if absolute else NAMESPACE), part.place
    return (NAMESPACE, part.place) if isinstance(part, described.Include) else (None, None)


def _set_in(actions: Iterable[Action]) -> Iterator[str]:
    for part, _ in parts_of(tuple(actions)):
        if isinstance(part, described.Argument):
            yield part.name
        elif isinstance(part, described.Let) and part.name.literal is not None:
            yield part.name.literal
