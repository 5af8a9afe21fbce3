"""A launch file of ROS 2 in another of its languages, and the proof that it does the same."""

from __future__ import annotations

from itertools import islice

from launchlint.dialects.door import named
from launchlint.evaluate.session import Read, Session
from launchlint.export.ros2 import xml, yaml
from launchlint.export.ros2.calling import called
from launchlint.export.ros2.carrying import carried
from launchlint.export.ros2.comments import Comments
from launchlint.export.ros2.comparing import difference, launched, normal
from launchlint.export.ros2.losses import Lost
from launchlint.export.ros2.portable import Portable
from launchlint.export.ros2.shaping import shaped
from launchlint.export.ros2.texts import CannotWrite
from launchlint.export.written import CannotExport
from launchlint.fix.format.formatting import formatted
from launchlint.fix.format.style import Style
from launchlint.model import ROS2
from launchlint.named_tuple import NamedTuple
from launchlint.syntax.ros2.description import Open
from launchlint.syntax.ros2.reading import read
from launchlint.syntax.ros2.tables import distribution

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable, Iterator
    from typing import Any

    from launchlint.export.ros2.tree import Branch
    from launchlint.model import Launch
    from launchlint.source import Place
    from launchlint.syntax.ros2.description import Description
    from launchlint.syntax.ros2.reading import Reading

    Pairs = tuple[tuple[str, str], ...]
    Started = tuple[Session, str]

XML, YAML = "xml", "yaml"
ENDS = {XML: ".launch.xml", YAML: ".launch.yaml"}
PYTHON = ".py"
MOST_CONFIGURATIONS = 16
_DEPENDS = "here stands what it gives as this is exported; that may depend on"


class Converted(NamedTuple):
    """``data`` is the file; ``lost`` what it lacks; ``remarks`` what a person should know of it, each with its place."""

    data: bytes
    lost: tuple[tuple[Place, str], ...]
    remarks: tuple[tuple[Place, str], ...]


def convert(session: Session, file: str, given: Pairs, style: Style, language: str) -> Converted:
    """``file``, a launch file of ROS 2, in ``language``; what it does has been compared in every configuration.

    Raises CannotExport; the file must be one that the front end reads.
    """
    reading = session.reading(file)
    assert not isinstance(reading, Read)
    dialect = distribution(session.distro)
    whole = reading.description
    varying: tuple[Lost, ...] = ()
    if file.endswith(PYTHON):
        if all(isinstance(each, Open) for each in whole.actions) and whole.actions:
            reasons = dict.fromkeys(each.reason for each in whole.actions if isinstance(each, Open))
            raise CannotExport(f"what it does cannot be told without running it ({'; '.join(reasons)})")
        functions = called(session, file, reading, given)
        whole = functions.description
        varying = tuple(Lost(place, "a function", f"{_DEPENDS} {', '.join(names)}") for place, names in functions.asked)
    kept = carried(whole, dialect, xml=language == XML, portable=Portable(session, file) if file.endswith(PYTHON) else None)
    losses = (*varying, *kept.lost)
    data = written(kept.description, reading, language, session.distro, style, losses)
    prove(session, file, given, language, data, kept.description if losses else kept.less, reading)
    lost = tuple((each.place, each.words) for each in losses)
    return Converted(data, lost, tuple((each.place, each.words) for each in kept.remarks))


def written(description: Description, reading: Reading, language: str, distro: str, style: Style, lost: tuple[Lost, ...]) -> bytes:
    """``description``, which holds nothing but what can be written, as a file that was read again. Raises CannotExport."""
    try:
        root = shaped(description, distribution(distro))
        Comments(reading).put(root, lost)
        data = text_of(root, language, style)
    except CannotWrite as cannot:
        raise CannotExport(cannot.reason) from None
    require_same(data, description, language, distro)
    return data


def text_of(root: Branch, language: str, style: Style) -> bytes:
    """A tree of tags as a file in normal form. Raises CannotWrite."""
    text = xml.written(root, style.indent) if language == XML else yaml.written(root)
    return formatted(text.encode("utf-8"), f"launch{ENDS[language]}", style).data


def require_same(data: bytes, description: Description, language: str, distro: str) -> None:
    """Read a file that is written, and raise CannotExport where it does not say what it is to say."""
    again = read(data, f"launch{ENDS[language]}", distro=distro)
    if again.refusal is not None:
        raise CannotExport(f"launch would refuse what is written ({again.refusal.kind})")
    if normal(again.description.actions) != normal(description.actions):
        raise CannotExport("what is written would describe something else")


def prove(session: Session, file: str, given: Pairs, language: str, data: bytes, less: Description | None, reading: Reading) -> None:
    """Compare what is started, in every configuration of both. Raises CannotExport where that differs.

    ``less``: what the file describes without what is said to be lost, where anything is.
    """
    before, after, there = side_by_side(session, file, language, data, less, reading)
    found = disagreement((before, file), (after, there), given, lambda launch: launched(launch, {there: file}))
    if found:
        raise CannotExport(f"the written file would not do the same: {found}")


def disagreement(before: Started, after: Started, given: Pairs, seen: Callable[[Launch], dict[str, list[Any]]]) -> str:
    """What two files would do differently, as far as that is ``seen`` of a launch, in some configuration of either; empty where nothing."""
    evaluate = named(ROS2).evaluate
    known = [_configurations(*each, given) for each in (before, after)]
    for pairs in _to_compare(known[0], known[1], given):
        old, new = (done.get(pairs) or evaluate(*each, pairs).launch for done, each in zip(known, (before, after), strict=True))
        was = seen(old)
        found = difference(was, _listing_as(was, seen(new)))
        if found:
            words = " ".join(f"{name}:={value}" for name, value in pairs)
            return f"{found}{f' (with {words})' if words else ''}"
    return ""


def _listing_as(before: dict[str, list[Any]], after: dict[str, list[Any]]) -> dict[str, list[Any]]:
    """``after``; where it lists all args that ``before`` lists, and further ones, it is as good: launch looks ahead into plain includes."""
    more = all(each in after["listed arg"] for each in before["listed arg"])
    return {**after, "listed arg": before["listed arg"]} if more else after


def side_by_side(
    session: Session, file: str, language: str, data: bytes, less: Description | None, reading: Reading
) -> tuple[Session, Session, str]:
    """Two sessions, and the name of the written file in the second of them: its own, if that does not say it is a program."""
    there = file if not file.endswith(PYTHON) else f"{file.removesuffix(PYTHON).removesuffix('.launch')}{ENDS[language]}"
    before = session if less is None else session.with_reading(file, reading._replace(description=less))
    after = session.with_text(there, data)
    return before, after, there


def _configurations(session: Session, file: str, given: Pairs) -> dict[Pairs, Launch]:
    """What is started in each configuration, the one that is given first."""
    found = islice(named(ROS2).configurations(session, file, given), MOST_CONFIGURATIONS)
    return {each.launch.given: each.launch for each in found}


def _to_compare(before: dict[Pairs, Launch], after: dict[Pairs, Launch], given: Pairs) -> Iterator[Pairs]:
    """The configurations of both files; then with a value for each arg that has none."""
    yield from dict.fromkeys((*before, *after))
    listed = next(iter(before.values())).listed
    lacking = dict.fromkeys(each.name for each in listed if each.required and each.name not in dict(given))
    if lacking:
        for value in ("value_of_{}", "1"):
            yield (*given, *((name, value.format(name)) for name in lacking))
