"""Parameter files as rcl reads them, each once in a session: those on disk by their names, those that launch writes by their texts."""

from __future__ import annotations

from launchlint.evaluate.ros2.parameters import source_of
from launchlint.named_tuple import NamedTuple
from launchlint.rcl import parameter_files
from launchlint.rcl.refused import Refused
from launchlint.rcl.table import Table
from launchlint.source import Source, Span
from launchlint.yaml import events
from launchlint.yaml.tree import YamlBeyond

TYPE_CHECKING = False
if TYPE_CHECKING:
    from launchlint.evaluate.ros2.parameters import Performs


def add_file(file: str, table: Table, asks: Performs) -> Refused | None:
    """Read a file into ``table``; its refusal, if rcl refuses it. Raises YamlBeyond."""
    alone = table_of(file, asks)
    return None if isinstance(alone, Table) and table.merge(alone) else _add_events(file, table, asks)


def _add_events(file: str, table: Table, asks: Performs) -> Refused | None:
    """The same, event by event: what is in the table already may change what the file says."""
    read = asks.session.read(file)
    if read.data is None:
        return Refused(f"the file {file} cannot be read: {read.reason}")
    source = source_of(file, read.data, asks)
    recorded = asks.session.loaded.get(f"events {file}")
    if recorded is None:
        try:
            read.data.decode("utf-8")
            recorded = events.Recorded(source.text, "rcl")
        except UnicodeDecodeError as error:
            at = len(read.data[: error.start].decode("utf-8", "replace").removeprefix("\ufeff"))
            recorded = Refused(f"it is not UTF-8 text (byte {error.start})", Span(at, at), source)
        asks.session.loaded[f"events {file}"] = recorded
    return recorded if isinstance(recorded, Refused) else parameter_files.add_events(recorded, source, table)


def table_of(file: str, asks: Performs) -> Table | Refused | None:
    """What one file holds by itself; None for one that is beyond all bounds."""
    name = f"table {file}{'' if asks.tags_count else ' without tags'}"
    if name not in asks.session.loaded:
        table = Table()
        table.tags = asks.tags_count
        try:
            asks.session.loaded[name] = _add_events(file, table, asks) or table
        except YamlBeyond:
            asks.session.loaded[name] = None
    known: Table | Refused | None = asks.session.loaded[name]
    return known


class Content(NamedTuple):
    """What launch writes to a file for the start of a node, with what it holds by itself: None if it is beyond all bounds."""

    source: Source
    alone: Table | Refused | None


def content_of(file: str, text: str, asks: Performs) -> Content:
    """A ``text`` that launch writes for a node, made from ``file`` (or nothing). The same text is the same content, with one source."""

    def read() -> Content:
        source, table = Source(file, text), Table()
        table.tags = asks.tags_count
        try:
            return Content(source, parameter_files.add(source, table) or table)
        except YamlBeyond:
            return Content(source, None)

    return asks.session.by_text.once(text, (Content, file, asks.tags_count), read)


def add_content(content: Content, table: Table) -> Refused | None:
    """Read what launch has written into ``table``; its refusal, if rcl refuses it. Raises YamlBeyond."""
    alone = content.alone
    return None if isinstance(alone, Table) and table.merge(alone) else parameter_files.add(content.source, table)
