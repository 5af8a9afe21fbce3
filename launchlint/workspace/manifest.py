"""``package.xml`` and ``manifest.xml``: who a package is, and what it says it needs.

Formats: REP 127 (format 1), REP 140 (format 2), REP 149 (format 3) and rosbuild's ``manifest.xml``. Two readings of one file:
:func:`identify` is the quick one every crawl makes, :func:`read_manifest` the whole one, with places, for the few packages
that are looked at closely.
"""

from __future__ import annotations

import os
import re
from collections.abc import Callable, Mapping
from pyexpat import ExpatError, ParserCreate

from launchlint.late import late
from launchlint.named_tuple import NamedTuple
from launchlint.source import Place, Source, Span
from launchlint.workspace.reading import read_bytes

TYPE_CHECKING = False
if TYPE_CHECKING:
    from pyexpat import XMLParserType

PACKAGE_FILE = "package.xml"
MANIFEST_FILE = "manifest.xml"

# A bound against hostile files.
_LONGEST_ENTITY = 256

_COMMENT = late(r"<!--(.*?)(?:-->|\Z)", re.DOTALL)
_ENCODING = late(rb"""^<\?xml[^>]*?encoding\s*=\s*["']([A-Za-z0-9._-]+)["']""")

# What each tag stands for (catkin_pkg.package.parse_package_string). A format 1 file with exec_depend, or a format 2 file with
# run_depend, is refused by catkin_pkg; here the author's intention counts.
_KINDS: dict[str, tuple[str, ...]] = {
    "build_depend": ("build",),
    "buildtool_depend": ("buildtool",),
    "build_export_depend": ("build_export",),
    "buildtool_export_depend": ("buildtool_export",),
    "run_depend": ("build_export", "exec"),
    "exec_depend": ("exec",),
    "depend": ("build", "build_export", "exec"),
    "test_depend": ("test",),
    "doc_depend": ("doc",),
}


class _Broken(Exception):
    """The file cannot be used; ``str(error)`` says why."""


class Identity(NamedTuple):
    """Name of a package, whether it is a metapackage, and, where the file is broken, why (else empty)."""

    name: str
    metapackage: bool
    reason: str


class Dependency(NamedTuple):
    """One dependency tag: the package it names, the tag, the whole element's place (tags included), and the condition that it has."""

    name: str
    tag: str
    span: Span
    condition: str = ""

    @property
    def kinds(self) -> tuple[str, ...]:
        """Which of build, buildtool, build_export, buildtool_export, exec, test, doc it stands for."""
        return _KINDS[self.tag]


class Manifest(NamedTuple):
    """All that launchlint reads from a ``package.xml`` or ``manifest.xml``.

    ``format`` is 1, 2 or 3, and 0 for ``manifest.xml``. ``plugins`` are the values of ``<export><nodelet plugin="…"/></export>`` with
    ``${prefix}`` replaced by the package's directory. ``build_types`` are the texts of ``<export><build_type>``, ``build_conditions`` the
    condition of each of them. ``root_end`` is the place of the root's closing tag (``None`` where there is none), ``name_span`` that of
    the ``<name>`` element. ``people`` are the addresses of maintainers and authors in small letters, ``signatures`` their names as they are
    written, ``urls`` the type and the text of each ``<url>``, ``licences`` the texts of ``<license>``.
    """

    source: Source
    name: str
    format: int
    metapackage: bool
    dependencies: tuple[Dependency, ...]
    plugins: tuple[str, ...]
    build_types: tuple[str, ...]
    name_span: Span | None
    root_end: Span | None
    build_conditions: tuple[str, ...] = ()
    people: frozenset[str] = frozenset()
    urls: tuple[tuple[str, str], ...] = ()
    signatures: tuple[str, ...] = ()
    licences: tuple[str, ...] = ()

    @property
    def comments(self) -> list[str]:
        """What stands in its comments, in order."""
        return _COMMENT.findall(self.source.text)

    def under(self, context: Mapping[str, str]) -> Manifest:
        """What is left of it where the variables in its conditions (format 3, REP 149) are those of ``context``.

        A condition that is none counts as true: catkin_pkg refuses the file, and here the author's intention counts.
        """
        types = self._build_types(context)
        return self._replace(
            dependencies=tuple(each for each in self.dependencies if _applies(each.condition, context)),
            build_types=tuple(each for each, _ in types),
            build_conditions=tuple(condition for _, condition in types),
        )

    def _build_types(self, context: Mapping[str, str]) -> list[tuple[str, str]]:
        """The build types, each with its condition, of which that holds."""
        return [each for each in zip(self.build_types, self.build_conditions, strict=True) if _applies(each[1], context)]

    @property
    def ros_versions(self) -> frozenset[str]:
        """``1`` and ``2``, as far as it is built for them: by catkin, which goes without a build type, or by ament (REP 127, REP 149)."""
        found: set[str] = set()
        for version in ("1", "2"):
            types = [each for each, _ in self._build_types({"ROS_VERSION": version})] or ["catkin"]
            found.update("2" if each.startswith("ament") else version if each == "cmake" else "1" for each in types)
        return frozenset(found)

    @property
    def is_catkin(self) -> bool:
        """Built by catkin: a ``package.xml`` whose build type, where it has one, is catkin's (REP 127, REP 140, REP 149)."""
        return self.format > 0 and (not self.build_types or "catkin" in self.build_types)

    @property
    def is_ament(self) -> bool:
        """Built by ament only, thus for ROS 2."""
        return bool(self.build_types) and all(build_type.startswith("ament") for build_type in self.build_types)

    def depends(self, *kinds: str) -> frozenset[str]:
        """Names of the dependencies of these kinds; of all kinds where none is given."""
        return frozenset(each.name for each in self.dependencies if not kinds or not set(kinds).isdisjoint(each.kinds))

    @property
    def run_dependencies(self) -> frozenset[str]:
        """What counts as declared for a launch file (roslaunch.depends.calculate_missing: ``run_depends`` of catkin_pkg)."""
        return self.depends("exec", "build_export")

    @property
    def build_dependencies(self) -> tuple[str, ...]:
        """What ``ament_auto_find_build_dependencies()`` finds, sorted."""
        return tuple(sorted(self.depends("build", "buildtool", "build_export")))

    @property
    def test_dependencies(self) -> frozenset[str]:
        """``<test_depend>``, which counts as declared too where a launch file is a test."""
        return self.depends("test")

    @property
    def last_dependency(self) -> Place | None:
        """The last dependency element, after which a further one can be written."""
        if not self.dependencies:
            return None
        return Place(self.source, max(each.span for each in self.dependencies))


def identify(data: bytes) -> Identity:
    """Name and kind of the package that a ``package.xml`` with this content describes.

    As rospkg.rospack.list_by_path: the text of the root's ``<name>`` without blanks around it, and a metapackage is one with
    ``<export><metapackage/></export>``. Where rospkg would die of the file, the reason says so instead.
    """
    parser = ParserCreate(None, "}")
    _refuse_large_entities(parser)
    path: list[str] = []
    texts: list[str] = []
    found = {"name": False, "metapackage": False}
    only_name = b"metapackage" not in data and _is_ascii_like(data)

    def start(tag: str, attributes: dict[str, str]) -> None:
        path.append(tag)
        depth = len(path)
        if depth == 2:
            if tag == "name" and not found["name"]:
                found["name"] = True
                parser.CharacterDataHandler = texts.append
        elif depth == 3:
            # ElementTree's text of an element ends at its first child.
            parser.CharacterDataHandler = None
            if tag == "metapackage" and path[1] == "export":
                found["metapackage"] = True

    def end(tag: str) -> None:
        path.pop()
        if len(path) == 1:
            parser.CharacterDataHandler = None
            if only_name and found["name"]:  # the rest need only be well-formed, and the parser sees that alone
                parser.StartElementHandler = parser.EndElementHandler = None

    parser.StartElementHandler = start
    parser.EndElementHandler = end
    try:
        parser.Parse(data, True)
    except ExpatError as error:
        return Identity("", False, f"not well-formed XML: {_expat_message(error)}")
    except (_Broken, ValueError, LookupError) as error:
        return Identity("", False, str(error))
    finally:
        _let_go(parser)
    name = "".join(texts).strip(" \n\r\t")
    if not found["metapackage"]:
        if not found["name"]:
            return Identity("", False, "it has no <name>")
        if not name:
            return Identity("", False, "its <name> is empty")
    return Identity(name, found["metapackage"], "")


def _is_ascii_like(data: bytes) -> bool:
    """Whether letters of ASCII are one byte each in ``data``, and the same as in UTF-8; in doubt they are not."""
    head = data.partition(b"?>")[0].lower()
    return b"\0" not in head and (b"encoding" not in head or b"utf-8" in head)


def read_manifest(path: str, shown: str | None = None) -> Manifest:
    """Read a ``package.xml`` or ``manifest.xml`` whole, with places.

    Args:
        path: the file; its base name decides which of the two formats it is.
        shown: the path people see in messages; ``path`` where not given.

    Raises:
        OSError: the file cannot be read.
        ValueError: it is not well-formed XML, or not text.
    """
    return parse_manifest(read_bytes(path), path, shown)


def text_of(path: str) -> str:
    """The text of a manifest; empty where it cannot be read."""
    try:
        return _decode(read_bytes(path))
    except (OSError, ValueError):
        return ""


def parse_manifest(data: bytes, path: str, shown: str | None = None) -> Manifest:
    """As :func:`read_manifest`, for content that has been read already."""
    source = Source(shown or path, _decode(data), path)
    directory, file = os.path.split(path)
    old = file == MANIFEST_FILE
    name, name_span = os.path.basename(directory) if old else "", None
    number, metapackage, root_end = "1", False, None
    dependencies: list[Dependency] = []
    plugins: list[str] = []
    build_types: list[tuple[str, str]] = []
    people: set[str] = set()
    urls: list[tuple[str, str]] = []
    signatures: list[str] = []
    licences: list[str] = []
    for element in _elements(source.text):
        tag, attributes = element.tag, element.attributes
        condition = attributes.get("condition", "")
        if not element.parents:
            number, root_end = attributes.get("format", "1").strip(), element.closing
        elif element.parents[1:] == ("export",):
            if tag == "metapackage":
                metapackage = True
            elif tag == "build_type":
                build_types.append((element.text.strip(), condition))
            elif tag == "nodelet" and "plugin" in attributes:
                plugins.append(attributes["plugin"].replace("${prefix}", directory))
        elif len(element.parents) != 1:
            continue
        elif tag in ("maintainer", "author"):
            people.add(attributes.get("email", "").lower())
            signatures.append(element.text.strip())
        elif tag == "license":
            licences.append(element.text.strip())
        elif tag == "url":
            urls.append((attributes.get("type", ""), element.text.strip()))
        elif old:
            if tag == "depend":
                dependencies.append(Dependency(attributes.get("package", "").strip(), tag, element.span))
        elif tag == "name" and name_span is None:
            name, name_span = element.text.strip(), element.span
        elif tag in _KINDS:
            dependencies.append(Dependency(element.text.strip(), tag, element.span, condition))
    return Manifest(
        source,
        name,
        0 if old else int(number) if number in ("1", "2", "3") else 1,
        metapackage,
        tuple(each for each in dependencies if each.name),
        tuple(plugins),
        tuple(each for each, _ in build_types if each),
        name_span,
        root_end,
        tuple(condition for each, condition in build_types if each),
        frozenset(filter(None, people)),
        tuple(urls),
        tuple(filter(None, signatures)),
        tuple(licences),
    )


def _applies(condition: str, context: Mapping[str, str]) -> bool:
    if not condition:
        return True
    from launchlint.workspace.ament.conditions import holds

    try:
        return holds(condition, context)
    except ValueError:
        return True


class _Element:
    """An element of at most depth 2: its ancestors from the root down, its text up to the first child, its place."""

    __slots__ = ("attributes", "closing", "parents", "span", "tag", "text")

    def __init__(self, parents: tuple[str, ...], tag: str, attributes: dict[str, str], start: int) -> None:
        self.parents = parents
        self.tag = tag
        self.attributes = attributes
        self.text = ""
        self.span = Span(start, start)
        self.closing: Span | None = None


def _elements(text: str) -> list[_Element]:
    """Elements of depth 0 to 2 in the order of their start tags; ``ValueError`` where the text is not well-formed XML."""
    data = text.encode("utf-8", "replace")
    offset = _offsets(data)
    parser = ParserCreate("utf-8", "}")
    parser.buffer_text = True
    _refuse_large_entities(parser)
    found: list[_Element] = []
    open_elements: list[_Element | None] = []
    path: list[str] = []
    collecting: list[str] = []
    fresh = False  # nothing came since the last start tag

    def start(tag: str, attributes: dict[str, str]) -> None:
        nonlocal fresh
        if open_elements and (parent := open_elements[-1]) is not None and not parent.text:
            parent.text = "".join(collecting)
        collecting.clear()
        element = _Element(tuple(path), tag, attributes, offset(parser.CurrentByteIndex)) if len(path) < 3 else None
        if element is not None:
            found.append(element)
        open_elements.append(element)
        path.append(tag)
        fresh = True

    def characters(data: str) -> None:
        nonlocal fresh
        fresh = False
        collecting.append(data)

    def end(tag: str) -> None:
        nonlocal fresh
        path.pop()
        element = open_elements.pop()
        if element is not None:
            at = offset(parser.CurrentByteIndex)
            if fresh:
                element.text = ""
            elif not element.text:
                element.text = "".join(collecting)
            if fresh and text[at - 2 : at] == "/>":
                element.span = Span(element.span.start, at)
            else:
                element.closing = Span(at, text.find(">", at) + 1 or len(text))
                element.span = Span(element.span.start, element.closing.end)
        collecting.clear()
        fresh = False

    parser.StartElementHandler = start
    parser.EndElementHandler = end
    parser.CharacterDataHandler = characters
    try:
        parser.Parse(data, True)
    except ExpatError as error:
        raise ValueError(f"not well-formed XML: {_expat_message(error)}") from error
    except _Broken as error:
        raise ValueError(str(error)) from error
    finally:
        _let_go(parser)
    return found


def _let_go(parser: XMLParserType) -> None:
    """Of functions that know the parser: else the two hold each other, and what was read, until somebody looks for such circles."""
    parser.StartElementHandler = parser.EndElementHandler = parser.CharacterDataHandler = None


def _offsets(data: bytes) -> Callable[[int], int]:
    """A function from ever larger byte offsets in UTF-8 to offsets in code points."""
    if data.isascii():
        return lambda at: at
    last_byte = last_point = 0

    def offset(at: int) -> int:
        nonlocal last_byte, last_point
        if at > last_byte:
            last_point += len(data[last_byte:at].decode("utf-8", "replace"))
            last_byte = at
        return last_point

    return offset


def _refuse_large_entities(parser: XMLParserType) -> None:
    """Make the parser stop at entities that could grow: a manifest needs none, a bomb needs long or nested ones."""

    def declaration(
        name: str, parameter: bool, value: str | None, base: str | None, system: str | None, public: str | None, notation: str | None
    ) -> None:
        if parameter or value is None or len(value) > _LONGEST_ENTITY or "&" in value:
            raise _Broken("it declares XML entities that are external, nested or long")

    parser.EntityDeclHandler = declaration


def _expat_message(error: ExpatError) -> str:
    return str(error).replace(": line ", ", line ")


def _decode(data: bytes) -> str:
    """The text of an XML file: by its byte order mark, else by its declaration, else UTF-8; ``ValueError`` where that fails."""
    if data.startswith((b"\xff\xfe", b"\xfe\xff")):
        return data.decode("utf-16")
    if data.startswith(b"\xef\xbb\xbf"):
        return data[3:].decode("utf-8")
    declared = _ENCODING.match(data)
    try:
        return data.decode("utf-8" if declared is None else declared[1].decode("ascii"))
    except LookupError as error:
        raise ValueError(str(error)) from error
