"""One launch file of ROS 2 that needs no other, and the proof that it starts the same."""

from __future__ import annotations

import os

from launchlint.dialects.door import named
from launchlint.evaluate.session import Read, Session
from launchlint.export.ros2.carrying import carried
from launchlint.export.ros2.comments import Comments
from launchlint.export.ros2.comparing import difference, renumbered, started
from launchlint.export.ros2.converting import XML, YAML, require_same, side_by_side, text_of
from launchlint.export.ros2.inlining import Inlined, inlined
from launchlint.export.ros2.portable import Portable
from launchlint.export.ros2.shaping import shaped
from launchlint.export.ros2.texts import CannotWrite, asked_variables
from launchlint.export.written import CannotExport
from launchlint.model import ROS2
from launchlint.named_tuple import NamedTuple
from launchlint.plural import counted
from launchlint.syntax.ros2.description import AppendEnvironment, Description, Group, SetEnvironment, Timer, UnsetEnvironment
from launchlint.syntax.ros2.tables import distribution

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Iterable, Iterator, Mapping, Sequence

    from launchlint.export.ros2.carrying import Carried
    from launchlint.export.ros2.tree import Branch
    from launchlint.fix.format.style import Style
    from launchlint.model import Launch
    from launchlint.source import Place
    from launchlint.syntax.ros2.description import Action

    Pairs = tuple[tuple[str, str], ...]

MOST_ATTEMPTS = 20
MOST_VARIABLES = 8
"""Environment variables whose other values take part in the proof."""


class Flat(NamedTuple):
    """As :class:`~launchlint.export.ros2.converting.Converted`; ``fixed`` says what holds the values of this machine, and why."""

    data: bytes
    lost: tuple[tuple[Place, str], ...]
    remarks: tuple[tuple[Place, str], ...]
    fixed: tuple[str, ...]


def language_of(file: str) -> str:
    """The language that a flat file is written in, if nobody says: its own, and XML for a program."""
    return YAML if file.endswith((".yaml", ".yml")) else XML


def flatten(session: Session, file: str, given: Pairs, style: Style, language: str) -> Flat:
    """What ``file``, started with ``given``, executes, as one file. What is started has been compared, also with other values of the
    environment variables that it reads. Raises CannotExport; the file must be one that ros2 launch loads.
    """
    original = named(ROS2).evaluate(session, file, given).launch
    decided: dict[str, str] = {}
    for _ in range(MOST_ATTEMPTS):
        flat = inlined(session, file, given, frozenset(decided))
        kept = carried(flat.description, distribution(session.distro), xml=language == XML, portable=Portable(session, file))
        fixed = tuple(_fixed(session, decided, flat.deciding))
        try:
            data = _text(session, kept, flat, original, fixed, style, language)
        except CannotWrite as cannot:
            raise CannotExport(cannot.reason) from None
        require_same(data, _spliced(kept.description, flat), language, session.distro)
        proof = _Proof(session, file, given, flat.description, kept.less, data, language)
        found = proof.disproved(sorted(asked_variables(kept.description.actions)))
        if found is None:
            lost = tuple((each.place, each.words) for each in kept.lost)
            remarks = tuple((each.place, each.words) for each in kept.remarks)
            return Flat(data, lost, remarks, fixed)
        variable, reason = found
        again = {variable} if variable else asked_variables(kept.description.actions).keys() & _changed(kept.description.actions)
        if not again - decided.keys():
            raise CannotExport(f"the exported file would not start the same: {reason}")
        decided.update(dict.fromkeys(again, reason))
    raise CannotExport("too much in it depends on each other")


def _fixed(session: Session, decided: Mapping[str, str], deciding: Mapping[str, Sequence[Place]]) -> Iterator[str]:
    """What holds the values of this machine."""
    for name in sorted({*decided, *deciding}):
        value = session.variable(name)
        places = deciding.get(name, ())
        why = (
            f"otherwise {decided[name]}" if name in decided else f"{counted(len(places), 'condition asks for it', 'conditions ask for it')}"
        )
        where = places[0].source if places else None
        first = "" if where is None else f", the first in {where.path}:{where.position(places[0].span.start).line}"
        yield f"the environment variable {name}, {'not set' if value is None else repr(value)} here, since {why}{first}"


def _changed(actions: Iterable[Action]) -> set[str]:
    """The environment variables that the launch itself sets."""
    found: set[str] = set()
    for action in actions:
        if isinstance(action, (Group, Timer)):
            found |= _changed(action.actions)
        elif isinstance(action, (SetEnvironment, UnsetEnvironment, AppendEnvironment)) and action.name.literal:
            found.add(action.name.literal)
    return found


# -- what is written ---------------------------------------------------------------------------------------------------


def _spliced(description: Description, flat: Inlined) -> Description:
    """The same without the groups that say what an include brought."""
    return description._replace(actions=tuple(_without_groups(description.actions, flat)))


def _without_groups(actions: Iterable[Action], flat: Inlined) -> Iterator[Action]:
    for action in actions:
        if isinstance(action, (Group, Timer)):
            inner = tuple(_without_groups(action.actions, flat))
            if isinstance(action, Group) and action.condition is None and id(action.place) in flat.included:
                yield from inner
                continue
            action = action._replace(actions=inner)
        yield action


def _text(
    session: Session,
    kept: Carried,
    flat: Inlined,
    launch: Launch,
    fixed: Iterable[str],
    style: Style,
    language: str,
) -> bytes:
    """The file. Raises CannotWrite."""
    root = shaped(kept.description, distribution(session.distro))
    included = {id(each): flat.included[id(each.place)][0] for each in _everything(root) if id(each.place) in flat.included}
    lost = list(kept.lost)
    for branch, file in ((root, launch.entry.file), *((each, included[id(each)]) for each in _everything(root) if id(each) in included)):
        reading = session.reading(file)
        assert not isinstance(reading, Read)
        mine = [each for each in lost if each.place.source.file == file]
        lost = [each for each in lost if each.place.source.file != file]
        Comments(reading).put(branch, mine, frozenset(included))
    root.actions = _Splicing(session, included).spliced(root, launch.entry.file)
    words = " ".join(f"{name}:={value}" for name, value in launch.given)
    origin = f"Flattened by launchlint from {os.path.basename(launch.entry.path)}{f', started with {words}' if words else ''}."
    head = [origin, *(f"Fixed: {each}" for each in fixed)]
    first = root.actions[0].above if root.actions else root.below
    first[:0] = head if first[:1] == [""] else [*head, ""]
    return text_of(root, language, style)


def _everything(branch: Branch) -> Iterator[Branch]:
    for each in branch.inner:
        yield each
        yield from _everything(each)


class _Splicing:
    """Takes out the groups that say what an include brought, and says so in comments."""

    def __init__(self, session: Session, included: Mapping[int, str]) -> None:
        self._session = session
        self._included = included

    def spliced(self, branch: Branch, file: str) -> list[Branch]:
        """What stands in ``branch``, which is of ``file``."""
        found: list[Branch] = []
        speaking = file
        waiting: list[str] = []  # what stands at the end of an included file
        for each in branch.actions or ():
            included = self._included.get(id(each))
            if each.actions is not None:
                each.actions = self.spliced(each, included or file)
            if included is None and speaking != file:
                waiting += ["", f"back in {self._title(file)}"]
                del each.above[: each.above[:1] == [""]]
                speaking = file
            elif included is not None:
                waiting += [*each.above, *each.beside, f"from {self._title(included)}"]
                each.above, each.beside = [], []
            spliced = [each]
            if included is not None and not each.attributes.keys() - {"scoped"}:
                spliced = each.actions or []
                speaking = included
            if spliced:
                spliced[0].above[:0] = waiting
                waiting = each.below if spliced[0] is not each else []
            found += spliced
        branch.below[:0] = waiting
        return found

    def _title(self, file: str) -> str:
        """A file by its package, or as people see it."""
        package = self._session.packages.package_of(file)
        if package is None or not package.name:
            return self._session.shown(file)
        return f"{package.name}/{os.path.relpath(file, package.directory)}"


# -- the proof ---------------------------------------------------------------------------------------------------------


class _Proof:
    """The file and the flat one, to be started side by side; where something is lost, with ``less``, the rest of what is executed."""

    def __init__(
        self, session: Session, file: str, given: Pairs, whole: Description, less: Description | None, data: bytes, language: str
    ) -> None:
        self._session = session
        self._file = file
        self._given = given
        self._whole = whole
        self._less = less
        self._data = data
        self._language = language

    def disproved(self, variables: list[str]) -> tuple[str, str] | None:
        """The environment variable that must not stay open (none: empty), and the difference that shows it; None where all is the same."""
        found = self._difference(self._session)
        if found:
            return "", found
        for name in variables[:MOST_VARIABLES]:
            for value in ("true", "false", f"value_of_{name}"):
                found = self._difference(self._in(name, value))
                if found:
                    return name, f"with {name}={value} in the environment {found}"
        return None

    def _difference(self, session: Session) -> str:
        original = self._launch(session, self._file, self._given)
        if original.refused is not None and session is not self._session:
            return ""
        reading = session.reading(self._file)
        assert not isinstance(reading, Read)
        before, after, there = side_by_side(session, self._file, self._language, self._data, self._less, reading)
        flat = self._launch(after, there, ())
        if self._less is None:
            return _differs(original, flat)
        whole = session.with_reading(self._file, reading._replace(description=self._whole))
        return _differs(original, self._launch(whole, self._file, ())) or _differs(self._launch(before, self._file, ()), flat)

    @staticmethod
    def _launch(session: Session, file: str, given: Pairs) -> Launch:
        return named(ROS2).evaluate(session, file, given).launch

    def _in(self, name: str, value: str) -> Session:
        session = self._session
        return Session(session.packages, {**session.environment, name: value}, session.root, session.overlay, session.asked_distro)


def _differs(before: Launch, after: Launch) -> str:
    old, new = started(before), started(after)
    return "" if old == new or renumbered(old) == renumbered(new) else difference(old, new)
