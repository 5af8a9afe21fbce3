"""Bytes to what a ROS 2 launch file describes, by the rules of launch's front ends for XML and YAML.

Which of them reads a file: the one that its name is for, then the other (``launch.frontend.Parser.load``). No text is both, so that its
first character tells; the name says which of them is to explain what neither can read. Both give entities
(:mod:`launchlint.syntax.ros2.entity`), and these become actions in the order in which launch reads them, depth first: a file is read to
its end before anything of it is executed, so that a mistake under ``if="false"`` is one.
"""

from __future__ import annotations

import re
from collections.abc import Iterator

from launchlint.named_tuple import NamedTuple
from launchlint.problem import Problem
from launchlint.source import Origin, Place, Source, Span
from launchlint.syntax.problems import MalformedXml, UnreadableFile
from launchlint.syntax.ros2.description import Description
from launchlint.syntax.ros2.parsing import Parser
from launchlint.syntax.ros2.problems import KeyTwice, MalformedXml2, MalformedYaml, UnreadText, WrongRoot, YamlForm
from launchlint.syntax.ros2.tables import DEFAULT, distribution

TYPE_CHECKING = False
if TYPE_CHECKING:
    from launchlint.syntax.ros2.entity import Entity
    from launchlint.syntax.ros2.unresolved import Unresolved
    from launchlint.syntax.ros2.yaml_data import Twice
    from launchlint.syntax.tree import Document

_ENDS = (".yaml", ".yml")
_ENCODING = re.compile(rb"""(\s*<\?xml[^>]*?\bencoding\s*=\s*)(["'])([A-Za-z][\w.-]*)\2""")
_LAUNCH = "launch"


class Reading(NamedTuple):
    """What was read.

    ``problems`` are in the order in which launch meets them, each with its place in this file (an origin without includes). Those with
    ``refused`` are each enough for launch to refuse the file, and the first of them is the one that it names; after a problem the reading
    goes on, so that ``description`` holds whatever could be understood.

    ``document`` is the tree of an XML file, None for YAML and Python.

    ``unresolved`` says what of a program could not be told without running it, in the order in which it was met.
    """

    description: Description
    problems: tuple[Problem, ...]
    source: Source
    document: Document | None = None
    unresolved: tuple[Unresolved, ...] = ()

    @property
    def refusal(self) -> Problem | None:
        """The problem for which launch refuses to load the file, if any."""
        return next((problem for problem in self.problems if problem.refused), None)


def read(data: bytes, path: str, file: str | None = None, distro: str = DEFAULT, parsed: Document | None = None) -> Reading:
    """Read the content of a launch file in XML or YAML; never raises.

    Args:
        data: the whole file.
        path: the name shown to people.
        file: the name under which the file was opened: its ending says which front end explains what none can read.
        distro: the distribution of ROS 2 whose tags, attributes and substitutions count.
        parsed: what XML makes of the file, where that is known.
    """
    try:
        text = data.decode("utf-8-sig")
    except UnicodeDecodeError as error:
        return _not_utf8(Source(path, data.decode("utf-8", "replace"), file), data, error.start)
    parser = Parser(distribution(distro))
    start = text.lstrip()[:1]
    if start == "<" or (start == "" and not (file or path).endswith(_ENDS)):
        return _xml(data, path, file, parser, parsed)
    reading = _yaml(Source(path, text, file), parser)
    if reading is None:
        return _xml(data, path, file, parser, parsed)
    return reading


def _not_utf8(source: Source, data: bytes, start: int) -> Reading:
    at = Span(len(data[:start].decode("utf-8-sig", "replace")), len(data[:start].decode("utf-8-sig", "replace")) + 1)
    problem: Problem
    if source.file.endswith(_ENDS):
        problem = MalformedYaml(origin=Origin(Place(source, at)), refused=True, message="this is not UTF-8 text", reason="character")
    else:
        problem = MalformedXml2(
            origin=Origin(Place(source, at)),
            refused=True,
            message="this is not UTF-8 text",
            code="UnicodeDecodeError",
            hint="launch reads every file as UTF-8, whatever its first line says; save the file in UTF-8",
            opened="",
            closed="",
        )
    return Reading(Description((), Place(source, Span(0, 0))), (problem,), source)


def _xml(data: bytes, path: str, file: str | None, parser: Parser, parsed: Document | None) -> Reading:
    from launchlint.syntax.parse import parse
    from launchlint.syntax.ros2.xml import XmlEntity

    as_utf8 = _as_utf8(data)
    document = parse(as_utf8, path, file) if parsed is None or as_utf8 is not data else parsed
    source = document.source
    for problem in document.problems:
        if isinstance(problem, MalformedXml):
            parser.problems.append(MalformedXml2(**vars(problem)))
        elif isinstance(problem, UnreadableFile):
            parser.problems.append(problem)
    root = document.root
    if root is None or parser.problems:
        return Reading(Description((), Place(source, Span(0, 0))), tuple(parser.problems), source, document)
    entity = XmlEntity(root, document, parser.distribution.digits_are_flags)
    if entity.tag != _LAUNCH:
        parser.problems.append(WrongRoot(origin=Origin(entity.name_place), refused=True, tag=root.tag))
    description = _description(entity, parser)
    return Reading(description, (*parser.problems, *_unread_text(document)), source, document)


def _unread_text(document: Document) -> Iterator[Problem]:
    """What stands between tags and is no blank."""
    for element in document.elements:
        for text in element.texts:
            if text.value.isspace():
                continue
            words = text.value.strip()
            start = text.span.start + max(text.raw.find(words), 0)
            at = Span(start, min(start + len(words), text.span.end))
            yield UnreadText(
                origin=Origin(document.place(at)),
                text=text.value,
                parent=element.tag,
                behind_tag=document.source.text.endswith("/>", 0, text.span.start),
            )


def _as_utf8(data: bytes) -> bytes:
    """``data``, which is UTF-8, without another encoding in its declaration: launch has decoded the text before XML looks at it."""
    declared = _ENCODING.match(data)
    if declared is None or declared[3].lower() in (b"utf-8", b"us-ascii") or len(declared[3]) < 5:
        return data
    return data[: declared.start(3)] + b"utf-8" + declared[2] + b" " * (len(declared[3]) - 5) + data[declared.end() :]


def _yaml(source: Source, parser: Parser) -> Reading | None:
    """What stands in YAML; None where it is for XML to explain why the file cannot be read."""
    from launchlint.syntax.ros2.yaml_data import load
    from launchlint.syntax.ros2.yaml_entity import YamlEntity
    from launchlint.yaml.refusals import YamlError
    from launchlint.yaml.tree import YamlBeyond

    ours = not source.file.endswith(".xml")
    everything = Place(source, Span(0, 0))
    problem: Problem
    twice: list[Twice] = []
    try:
        item = load(source.text, twice)
    except YamlError as error:
        at = min(error.offset, len(source.text))
        origin = Origin(Place(source, Span(at, min(at + 1, len(source.text)))))
        problem = MalformedYaml(origin=origin, refused=True, message=error.message, reason=error.kind)
        return Reading(Description((), everything), (problem,), source) if ours else None
    except YamlBeyond as beyond:
        problem = UnreadableFile(origin=Origin(Place(source, Span(beyond.offset, beyond.offset))), reason=beyond.message)
        return Reading(Description((), everything), (problem,), source)
    entries = item.data if item is not None and isinstance(item.data, dict) else {}
    if len(entries) != 1:
        if not ours:
            return None
        place = everything if not entries else Place(source, list(entries.values())[1].key)
        problem = WrongRoot(origin=Origin(place), refused=True, tag="", keys=len(entries))
        parser.problems.append(problem)
        if _LAUNCH not in entries:
            return Reading(Description((), everything), tuple(parser.problems), source)
        tag = _LAUNCH
    else:
        (tag,) = entries
    entity = YamlEntity(tag, entries[tag].value, entries[tag].key, source)
    if tag != _LAUNCH:
        parser.problems.append(WrongRoot(origin=Origin(entity.name_place), refused=True, tag=tag))
    elif entity.shapeless() is not None:
        origin = Origin(entity.name_place)
        parser.problems.append(YamlForm(origin=origin, refused=True, tag=tag, attribute="", shape="children"))
        return Reading(Description((), everything), tuple(parser.problems), source)
    return Reading(_description(entity, parser), (*parser.problems, *_keys_twice(source, twice)), source)


def _keys_twice(source: Source, twice: list[Twice]) -> Iterator[Problem]:
    """The keys of which launch sees only the last."""
    for key, last, first, same in twice:
        related = ((Place(source, first), "the first one, which is lost"),)
        yield KeyTwice(origin=Origin(Place(source, last)), related=related, key=key, same=same)


def _description(entity: Entity, parser: Parser) -> Description:
    if entity.tag != _LAUNCH:
        return Description((), entity.place)
    return Description(parser.actions(entity.children(parser.problems), entity.tag), entity.place)
