"""Values of launch files of ROS 1 as texts of ROS 2."""

from __future__ import annotations

from launchlint.export.from_ros1.expressions import NotTranslated, translated
from launchlint.export.ros2.losses import Left
from launchlint.export.ros2.texts import joined
from launchlint.source import Place
from launchlint.syntax.parts import Literal, Malformed
from launchlint.syntax.parts import Substitution as Written
from launchlint.syntax.ros1.substitutions import parse
from launchlint.syntax.ros2.description import Substitution, Text
from launchlint.syntax.ros2.of_ros1 import SUBSTITUTIONS

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Mapping

    from launchlint.evaluate.session import Session
    from launchlint.syntax.tree import Attribute, Document, Element

    Pieces = list[str | Substitution]


def _is_directory(piece: str | Substitution) -> bool:
    """Whether roslaunch takes what follows for a path in it, with or without a slash."""
    return isinstance(piece, Substitution) and piece.name == "find-pkg-share"


class Values:
    """Makes the texts of one file. ``values`` are its args, and ``settings`` its params by where they begin, as it is exported."""

    def __init__(self, session: Session, document: Document, file: str, values: Mapping[str, str], settings: Mapping[int, object]) -> None:
        self._session = session
        self._document = document
        self._file = file
        self._values = values
        self._settings = settings

    def set_to(self, element: Element) -> object:
        """What a param is set to in the configuration that is exported; None where that is not known."""
        return self._settings.get(element.start_span.start)

    def place(self, element: Element) -> Place:
        """Where an element begins."""
        return self._document.place(element.start_span)

    def is_set(self, element: Element) -> bool:
        """Whether a param is set in any configuration."""
        return element.start_span.start in self._settings

    def whole(self, element: Element) -> Place:
        """All of an element."""
        return self._document.place(element.span)

    def attribute(self, element: Element, name: str) -> Text | None:
        """The value of an attribute; None where it is not there. Raises Left."""
        attribute = element.attributes.get(name)
        return None if attribute is None else self.of(attribute)

    def of(self, attribute: Attribute) -> Text:
        """The value of an attribute. Raises Left."""
        return self.text(attribute.value, attribute.place(self._document.source))

    def text(self, value: str, place: Place) -> Text:
        """What stands in a launch file of ROS 1. Raises Left."""
        parts = parse(value)
        if parts.expression is not None:
            try:
                code = translated(
                    parts.expression.code,
                    self._values,
                    lambda name, word: Substitution(name, (Text((word,), place),), place),
                    lambda: self._directory(place),
                )
            except NotTranslated as reason:
                raise Left(place, reason.reason) from None
            return Text((Substitution("eval", (Text(joined(code), place),), place),), place)
        found: Pieces = []
        for part in parts.parts:
            if isinstance(part, (Literal, Malformed)):
                apart = bool(found) and _is_directory(found[-1]) and (part.text[0].isalnum() or part.text[0] in "._")
                found.append(f"/{part.text}" if apart else part.text)
            elif isinstance(part, Written):
                found += self._substitution(part, place)
        return Text(joined(found), place)

    def _substitution(self, part: Written, place: Place) -> Pieces:
        words = [word.text for word in part.words[1:]]
        command = part.command
        if command == "dirname":
            return self._directory(place)
        if command == "optenv" and words:
            default = Text((" ".join(words[1:]),) if words[1:] else (), place)
            return [Substitution("env", (Text((words[0],), place), default), place)]
        if len(words) != 1:
            return [part.text]
        return [Substitution(SUBSTITUTIONS.get(command, command), (Text((words[0],), place),), place)]

    def _directory(self, place: Place) -> Pieces:
        """The directory of the file: by its package, since ROS 2 forgets it behind an include."""
        package = self._session.packages.package_of(self._file)
        if package is None or not package.name or not self._file.startswith(package.directory + "/"):
            return [Substitution("dirname", (), place)]
        inside = self._file[len(package.directory) :].rpartition("/")[0]
        return [Substitution("find-pkg-share", (Text((package.name,), place),), place), inside]
