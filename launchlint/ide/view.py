"""One open file at one moment: its text, what that means, and the entry files that lead to it."""

from __future__ import annotations

from collections.abc import Iterator
from functools import cached_property

from launchlint.dialects.door import dialect_of
from launchlint.evaluate.session import Read
from launchlint.ide.mention import Mention, at
from launchlint.model import ROS1
from launchlint.named_tuple import NamedTuple
from launchlint.source import Source, Span
from launchlint.syntax.recovery import Recovered, recovered
from launchlint.syntax.tree import Document

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Mapping, Sequence

    from launchlint.dialects.record import Dialect
    from launchlint.evaluate.session import Session
    from launchlint.fix.format.style import Style
    from launchlint.graph.connections import Endpoint
    from launchlint.library.lookup import Library
    from launchlint.model import Argument, Include, Launch, Node, ParameterSetting, Remap
    from launchlint.project.watcher import Configuration, Understood
    from launchlint.syntax.tree import Attribute, Element
    from launchlint.workspace.packages import Packages


class Snapshot(NamedTuple):
    """What was known when all that is open had been looked at: it does not change any more.

    ``entries`` are the entry files whose evaluations are kept; ``including`` says for an entry file (as shown) which files it leads to,
    for all that have been checked; ``broken`` are texts that were recovered, by file (absolute).
    """

    session: Session
    library: Library
    style: Style
    entries: Sequence[Understood]
    including: Mapping[str, tuple[str, ...]]
    broken: Mapping[str, Recovered]

    @property
    def packages(self) -> Packages:
        """All packages that can be seen."""
        return self.session.packages

    def back(self, shown: str, offset: int) -> int:
        """Where an offset in what was evaluated of a file is in the text that people see."""
        recovery = self.broken.get(self.session.named(shown))
        return offset if recovery is None else recovery.back(offset)


class Target(NamedTuple):
    """A stretch of a file (absolute): where something is."""

    file: str
    span: Span


class View:
    """A file as people see it (``text``), and what is known of it."""

    def __init__(self, snapshot: Snapshot, file: str, text: str) -> None:
        self.snapshot = snapshot
        self.file = file
        self.shown = snapshot.session.shown(file)
        self.text = text
        self.recovery: Recovered = recovered(text, file)
        if self.recovery.edits and file in snapshot.broken:
            self.recovery = self.recovery if self.recovery.text == snapshot.broken[file].text else snapshot.broken[file]
        data = self.recovery.text.encode("utf-8", "surrogateescape")
        known = snapshot.session.read(file).data
        self.session = snapshot.session if known == data else snapshot.session.with_texts({file: data})

    @cached_property
    def dialect(self) -> Dialect:
        """Whose launch file it is."""
        return dialect_of(self.session, self.file)

    @cached_property
    def document(self) -> Document:
        """Its tree; of YAML and Python only the text, with what it describes."""
        found = self.dialect.parse(self.session, self.file)
        return Document(Source(self.shown, self.recovery.text, self.file)) if isinstance(found, Read) else found

    @cached_property
    def mentions(self) -> tuple[Mention, ...]:
        """The words in it that mean something."""
        return mentions_in(self.document, self.dialect.name == ROS1)

    def mention_at(self, offset: int) -> Mention | None:
        """The word at an offset of the text."""
        return at(self.mentions, self.recovery.forth(offset))

    def seen(self, span: Span) -> Span:
        """A stretch of what was read, as it is in the text."""
        return Span(self.recovery.back(span.start), self.recovery.back(span.end))

    def element_at(self, offset: int) -> Element | None:
        """The innermost element around an offset of the text."""
        place = self.recovery.forth(offset)
        after = self.document.element_from(place + 1)
        elements = self.document.elements
        if not elements:
            return None
        element: Element | None = elements[(len(elements) if after is None else after.index) - 1]
        while element is not None and not element.span.start <= place < max(element.span.end, element.start_span.end):
            element = element.parent
        return element

    def attribute_at(self, offset: int) -> tuple[Element, Attribute] | None:
        """The attribute at an offset of the text, name or value, with its element."""
        place = self.recovery.forth(offset)
        element = self.element_at(offset)
        if element is None:
            return None
        found = next((each for each in element.attributes.values() if each.span.start <= place <= each.span.end), None)
        return None if found is None else (element, found)

    # -- what is evaluated ---------------------------------------------------------------------------------------

    @cached_property
    def entries(self) -> list[Understood]:
        """The entry files that lead here, this one first."""
        found = [each for each in self.snapshot.entries if any(name == self.file for name, _ in each.result.dependencies)]
        return sorted(found, key=lambda each: (each.result.request.at != self.file, len(each.result.dependencies), each.result.path))

    @cached_property
    def configurations(self) -> list[Configuration]:
        """All their configurations."""
        return [configuration for each in self.entries for configuration in each.configurations]

    @property
    def launches(self) -> Iterator[Launch]:
        """What they start."""
        return (each.evaluation.launch for each in self.configurations)

    def items_at(self, offset: int) -> list[int]:
        """Where the items begin that stand at an offset of the text, innermost first."""
        if self.document.root is not None:
            element = self.element_at(offset)
            found = []
            while element is not None:
                found.append(element.span.start)
                element = element.parent
            return found
        place = self.recovery.forth(offset)
        starts = {each.item for each in self.mentions} | {node.origin.place.span.start for node in self.nodes}
        before = [start for start in starts if start <= place]
        return [max(before)] if before else []

    @cached_property
    def nodes(self) -> list[Node]:
        """The nodes that are written here, in all configurations."""
        return [node for launch in self.launches for node in (*launch.nodes, *launch.tests) if node.origin.place.source.path == self.shown]

    def nodes_of(self, item: int) -> list[Node]:
        """Those that begin at ``item``."""
        return [node for node in self.nodes if node.origin.place.span.start == item]

    def remaps_of(self, item: int) -> list[tuple[Configuration, Node, Remap]]:
        """What became of the remap that begins at ``item``: the nodes on which it acts."""
        return [
            (configuration, node, remap)
            for configuration in self.configurations
            for node in (*configuration.evaluation.launch.nodes, *configuration.evaluation.launch.tests)
            for remap in node.remaps
            if remap.origin.place.source.path == self.shown and remap.origin.place.span.start == item
        ]

    def includes_of(self, item: int | None = None) -> list[Include]:
        """The includes that are written here, or that which begins at ``item``."""
        return [
            include
            for launch in self.launches
            for include in launch.includes
            if include.origin.place.source.path == self.shown and item in (None, include.origin.place.span.start)
        ]

    def settings_of(self, item: int) -> list[ParameterSetting]:
        """The params that are set by what begins at ``item``."""
        return [
            setting
            for launch in self.launches
            for setting in launch.parameter_settings
            if setting.origin.place.source.path == self.shown and setting.origin.place.span.start == item
        ]

    def declarations(self, name: str) -> list[Argument]:
        """The declarations of an arg in this file, as they were evaluated."""
        return [
            argument
            for launch in self.launches
            for argument in launch.declared
            if argument.name == name and not argument.passed and argument.origin.place.source.path == self.shown
        ]


def mentions_in(document: Document, of_ros1: bool) -> tuple[Mention, ...]:
    """The words of a launch file that mean something."""
    if of_ros1:
        from launchlint.ide.ros1.mentions import mentions

        return mentions(document)
    if document.description is None:
        return ()
    from launchlint.ide.ros2.mentions import mentions as mentions_of_ros2

    return mentions_of_ros2(document.description, document.source)


def is_made_by(endpoint: Endpoint, remap: Remap) -> bool:
    """Whether a name on the graph is what it is by ``remap``."""
    key = remap.origin.place.key
    return any(each.rule.remap is not None and each.rule.remap.origin.place.key == key for each in endpoint.applied)
