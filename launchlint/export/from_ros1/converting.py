"""A launch file of ROS 1 as one of ROS 2, and the proof that it starts the same.

The proof takes what it includes as translated in the same way, and files of params as rewritten by a person.
"""

from __future__ import annotations

from itertools import islice

from launchlint.dialects.door import named
from launchlint.evaluate.session import Read, Session
from launchlint.export.from_ros1.proving import PLACEHOLDER, Dropped, difference
from launchlint.export.from_ros1.translating import translate
from launchlint.export.from_ros1.values import Values
from launchlint.export.ros2.carrying import carried
from launchlint.export.ros2.converting import XML, Converted, written
from launchlint.export.written import CannotExport
from launchlint.fix.format.style import Style
from launchlint.model import ROS1, ROS2
from launchlint.named_tuple import NamedTuple
from launchlint.source import Place
from launchlint.syntax.ros2.reading import Reading
from launchlint.syntax.ros2.tables import distribution

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Iterable

    from launchlint.model import Launch
    from launchlint.syntax.tree import Document

    Pairs = tuple[tuple[str, str], ...]
    Said = tuple[tuple[Place, str], ...]

MOST_CONFIGURATIONS = 20
MOST_FILES = 300
_REWRITTEN = f"/**: {{ros__parameters: {{{PLACEHOLDER}: 0}}}}\n".encode()
_OF_THIS_MACHINE = frozenset(
    ("package-not-found", "node-package-missing", "invalid-package-name", "required-arg-unset", "missing-file", "env-unset")
)
"""Problems of ROS 2 that say nothing about the translation: packages that are only here for ROS 1, or not here at all."""


class _File(NamedTuple):
    data: bytes
    lost: Said
    remarks: Said
    dropped: tuple[Place, ...]


def convert(session: Session, file: str, given: Pairs, style: Style, language: str) -> Converted:
    """``file``, a launch file of ROS 1, as one of ROS 2 in ``language``. Raises CannotExport; roslaunch must be able to read it."""
    launches = [each.launch for each in islice(named(ROS1).configurations(session, file, given), MOST_CONFIGURATIONS)]
    main = _translated(session, file, launches, style, language)
    others = dict.fromkeys(each for launch in launches for each in launch.files if each != file)
    texts: dict[str, bytes] = {file: main.data}
    dropped = list(main.dropped)
    for each in list(others)[:MOST_FILES]:
        part = _translated(session, each, launches, style, XML)
        texts[each] = part.data
        dropped += part.dropped
    _prove(session, file, launches, texts, Dropped(dropped))
    return Converted(main.data, main.lost, main.remarks)


def _translated(session: Session, file: str, launches: list[Launch], style: Style, language: str) -> _File:
    document = session.document(file)
    if isinstance(document, Read) or document.launch is None:
        raise CannotExport(f"{session.shown(file)} is no launch file that roslaunch can read")
    included = {
        each.origin.place.span.start: each.file
        for launch in reversed(launches)
        for each in launch.includes
        if each.origin.place.source.path == document.source.path
    }
    values: dict[str, str] = {}
    for launch in reversed(launches):
        for each in launch.declared:
            if each.origin.place.source.path == document.source.path and not each.passed:
                value = each.value if each.value is not None else each.default
                if isinstance(value, str):
                    values[each.name] = value
    settings = {
        each.origin.place.span.start: each.value
        for launch in reversed(launches)
        for each in launch.parameter_settings
        if each.origin.place.source.path == document.source.path
    }
    if launches and launches[0].entry.path == document.source.path:
        values.update(launches[0].arguments)
    made = translate(session, document, Values(session, document, file, values, settings), included)
    kept = carried(made.description, distribution(session.distro), xml=language == XML)
    lost = (*made.lost, *kept.lost)
    reading = Reading(kept.description, (), document.source, document)
    data = written(kept.description, reading, language, session.distro, style, lost)
    dropped = (*made.dropped, *(_element(document, each.place) for each in kept.lost))
    remarks = (*made.remarks, *kept.remarks)
    return _File(data, _said(lost), _said(remarks), dropped)


def _said(items: Iterable[object]) -> Said:
    return tuple(dict.fromkeys((each.place, each.words) for each in items))  # type: ignore[attr-defined]  # both kinds have them


def _element(document: Document, place: Place) -> Place:
    """The start tag around a place."""
    found = place
    for element in document.elements:
        start, end = element.start_span
        if start <= place.span.start < end:
            found = document.place(element.start_span)
    return found


def _prove(session: Session, file: str, launches: list[Launch], texts: dict[str, bytes], dropped: Dropped) -> None:
    """Raises CannotExport where something differs that is not said to be lost."""
    after = _holding(session, texts)
    files = {source.file for launch in _started(after, file, launches) for node in launch.nodes for source in node.sources if source.file}
    after = _holding(session, {**texts, **dict.fromkeys(sorted(files), _REWRITTEN)})
    for before, launch in zip(launches, _started(after, file, launches), strict=True):
        words = " ".join(f"{name}:={value}" for name, value in before.given)
        if before.refused is not None:
            continue
        found = difference(before, launch, dropped)
        if not found:
            refused = [each for each in launch.problems if each.refused and each.kind not in _OF_THIS_MACHINE]
            found = f"ros2 launch would refuse it ({refused[0].kind} in {refused[0].place.source.path})" if refused else ""
        if found:
            raise CannotExport(f"the written file would not do the same: {found}{f' (with {words})' if words else ''}")


def _started(session: Session, file: str, launches: list[Launch]) -> list[Launch]:
    return [named(ROS2).evaluate(session, file, each.given).launch for each in launches]


def _holding(session: Session, texts: dict[str, bytes]) -> Session:
    overlay = {**session.overlay, **texts}
    return Session(session.packages, session.environment, session.root, overlay, session.distro)
