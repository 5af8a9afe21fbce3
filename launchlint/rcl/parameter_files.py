"""Parameter files as rcl reads them: by the events of libyaml, one after the other, into a table.

Source: ``rcl_yaml_param_parser/src/parse.c`` (``parse_file_events``, ``parse_key``, ``parse_value``). It builds no tree, so that it accepts
much that is not meant: it takes ``[{a: 1}]`` for a list under the name ``….a``, and of an empty mapping it loses count.
"""

from __future__ import annotations

from collections.abc import Iterable

from launchlint.rcl.names import is_namespace, is_node_name
from launchlint.rcl.parameter_value import Value, scalar
from launchlint.rcl.refused import Refused
from launchlint.rcl.table import Table
from launchlint.source import Source, Span
from launchlint.yaml import events
from launchlint.yaml.events import Event
from launchlint.yaml.refusals import YamlError
from launchlint.yaml.tree import YamlBeyond

TYPE_CHECKING = False
if TYPE_CHECKING:
    from launchlint.rcl.parameter_value import Scalar, Type
    from launchlint.rcl.table import Key

PARAMETERS = "ros__parameters"
MOST_CHARACTERS = 50_000_000
"""Of all names together, each with its namespaces; nothing is said about a file that comes to more."""

_ALIKE = {
    frozenset(("int", "double")): "write all of them with a point (1.0), or none",
    frozenset(("bool", "int")): "write true and false, or numbers",
    frozenset(("bool", "double")): "write true and false, or numbers",
}
"""What to write in a list of two types."""
LISTS: dict[str, Type] = {"bool": "bool[]", "int": "int[]", "double": "double[]", "str": "str[]"}
TYPES = {"bool": "true or false", "int": "a whole number", "double": "a number with a point", "str": "a text"}


_FORM = f"write the name of a node (or /** for all), below it {PARAMETERS}, and below that the names with their values"

_FLAT = "a list holds no lists: write all values into one list, or give each list a name of its own"
_UNMAPPED = "a list holds no mappings: give each of them a name, so that its keys are params (subscribers.first.topic)"


class _Stop(Exception):
    """rcl refuses the file here; ``instead`` is what to write."""

    def __init__(self, reason: str, event: Event, instead: str = _FORM) -> None:
        super().__init__(reason)
        self.reason = reason
        self.span = Span(event.start, event.end)
        self.instead = instead


def read(source: Source) -> Table | Refused:
    """What rcl reads in one file. Raises YamlBeyond for a text that is beyond all measure."""
    table = Table()
    return add(source, table) or table


def add(source: Source, table: Table) -> Refused | None:
    """Read one more file into ``table``, as rcl does with each ``--params-file``; its refusal, if it refuses it. Raises YamlBeyond."""
    return add_events(events.read(source.text, "rcl"), source, table)


def add_events(given: Iterable[Event], source: Source, table: Table) -> Refused | None:
    """The same from the events of the file."""
    reading = _Reading(source, table)
    try:
        for event in given:
            reading.take(event)
    except _Stop as stop:
        return Refused(stop.reason, stop.span, source, instead=stop.instead)
    except YamlError as error:
        return Refused(error.message, Span(error.offset, error.offset), source)
    return None


class _Reading:
    """Where rcl stands in a file.

    ``in_parameters``: below ``ros__parameters``. ``nested``: the last list was the first in another one. ``maps``: a mapping
    stands in this list. ``node`` and ``namespace`` are
    names that grow part by part; each knows by a count of its own of how many keys it is made, and rcl takes them back by looking for the
    last separator, whether or not a key held one.
    """

    __slots__ = (
        *("count", "depth", "in_list", "in_parameters", "key", "key_comes", "list_start", "list_type", "node_span", "namespace"),
        *("maps", "nested", "new_mapping", "node", "place", "source", "table", "values"),
    )

    def __init__(self, source: Source, table: Table) -> None:
        self.source = source
        self.table = table
        self.in_parameters = False
        self.depth = 0
        self.key_comes = True
        self.new_mapping = False
        self.in_list = False
        self.nested = False
        self.maps = False
        self.list_type = ""
        self.values: list[Scalar] = []
        self.list_start = 0
        self.node: tuple[str, int] = ("", 0)
        self.namespace: tuple[str, int] = ("", 0)
        self.key: Key | None = None
        self.place = 0
        self.node_span = Span(0, 0)
        self.count = 0

    def take(self, event: Event) -> None:
        """One event. Raises _Stop and YamlBeyond."""
        kind = event.kind
        if kind == events.SCALAR:
            if self.key_comes:
                self._key(event)
                self.key_comes = False
            else:
                self._value(event)
                self.key_comes = not self.in_list
        elif kind == events.MAPPING_START:
            self.depth += 1
            self.key_comes = True
            self.maps = self.in_list
            # The mapping of ros__parameters itself is no namespace of parameters.
            self.new_mapping = not (self.in_parameters and self.depth - (self.node[1] + 1) == 2)
        elif kind == events.MAPPING_END:
            self._close()
        elif kind == events.SEQUENCE_START:
            if self.key_comes:
                raise _Stop("a list stands here where a name must be", event, _FLAT if self.nested else _FORM)
            if not self.in_parameters:
                raise _Stop(f"a list stands outside of {PARAMETERS}", event)
            self.nested = self.in_list
            self.in_list = True
            self.maps = False
            self.list_type = ""
            self.list_start = event.start
        elif kind == events.SEQUENCE_END:
            self._list_ends(event)
        else:
            raise _Stop(f"rcl takes no aliases, and *{event.value[:60]} is one", event, "write out what it stands for")

    def _close(self) -> None:
        if self.in_parameters:
            if self.namespace[1]:
                self.namespace = _without_last(self.namespace, ".")
            else:
                self.in_parameters = False
        elif self.depth == self.node[1] + 1:
            self.node = _without_last(self.node, "/")
        self.depth -= 1

    def _key(self, event: Event) -> None:
        self.nested = False
        text = event.value.partition("\0")[0]
        if not event.value:
            raise _Stop("a name is empty", event, "give it a name")
        if not self.in_parameters:
            if text.startswith(PARAMETERS):
                self._parameters_begin(event)
            else:
                name, parts = self.node
                self.node = (name + ("/" if parts and not name.endswith("/") else "") + text if parts else text, parts + 1)
                self.node_span = Span(event.start, event.end)
                self._account(len(self.node[0]), event)
            return
        key = self.key
        if key is None or (self.new_mapping and self.place >= len(key.parameters)):
            raise _Stop(f"no parameter has a name before this mapping in {PARAMETERS}", event)
        if self.new_mapping:
            self.namespace = (key.parameters[self.place].name, self.namespace[1] + 1)
            self.new_mapping = False
        written = self.table.written(self.source, Span(event.start, event.end))
        if not self.namespace[1]:
            self.place = key.place(text, written)
        else:
            name = f"{self.namespace[0]}.{text}"
            self._account(len(name), event)
            self.place = key.place(self.namespace[0], written)
            key.rename(self.place, name)

    def _parameters_begin(self, event: Event) -> None:
        name, parts = self.node
        if not parts:
            raise _Stop(f"{PARAMETERS} must stand below the name of a node, and it stands below none", event)
        fault = _fault_of(name)
        if fault:
            raise _Stop(fault, event._replace(start=self.node_span.start, end=self.node_span.end), "write the name that the node has")
        self.key = self.table.key(name, self.source, self.node_span)
        self.node = _without_last(self.node, "/")
        self.in_parameters = True

    def _value(self, event: Event) -> None:
        if not self.in_parameters:
            raise _Stop(f"a value stands here where a node name, or {PARAMETERS} below one, must be", event)
        key = self.key
        if key is None or not key.parameters:
            raise _Stop(f"{PARAMETERS} must hold names with values, and has itself a value", event)
        if not event.value and not event.quoted:
            raise _Stop("a value is missing", event, 'write "" for an empty text, [] for an empty list, or leave the name out')
        value = scalar(event.value, event.quoted, event.tag if self.table.tags else None)
        parameter = key.parameters[min(self.place, len(key.parameters) - 1)]
        if not self.in_list:
            parameter.give(value)
            parameter.written = parameter.written._replace(value=Span(event.start, event.end))
        elif not self.list_type:
            self.list_type = value.type
            self.values = [value.data]
        elif self.list_type == value.type:
            self.values.append(value.data)
        else:
            first, this = TYPES[self.list_type], TYPES[value.type]
            instead = _ALIKE.get(frozenset((self.list_type, value.type)), "put quotes around all items that are meant as texts")
            instead = _UNMAPPED if self.maps else instead
            raise _Stop(f"all items of a list must be of one type: the first is {first}, this is {this}", event, instead)

    def _list_ends(self, event: Event) -> None:
        self.in_list = False
        self.key_comes = True
        if self.key is not None and self.place < len(self.key.parameters):
            parameter = self.key.parameters[self.place]
            parameter.written = parameter.written._replace(value=Span(self.list_start, event.end))
            if self.list_type:
                parameter.give(Value(LISTS[self.list_type], tuple(self.values)))

    def _account(self, characters: int, event: Event) -> None:
        self.count += characters
        if self.count > MOST_CHARACTERS:
            raise YamlBeyond(f"the names of this parameter file come to more than {MOST_CHARACTERS} characters", event.start)


def _without_last(name: tuple[str, int], separator: str) -> tuple[str, int]:
    """A name without what stands behind its last separator; a name made of one key is gone as a whole."""
    text, parts = name
    if parts <= 1:
        return "", 0
    head, found, _ = text.rpartition(separator)
    return (head if found else text), parts - 1


def _fault_of(key: str) -> str:
    """Why rcl takes ``key`` for no name of a node, with wildcards or without; empty if it does."""
    if key in ("/**", "/*"):
        return ""
    namespace, slash, name = key.rpartition("/")
    if slash:
        for part in namespace.lstrip("/").split("/") if namespace.strip("/") else []:
            if part not in ("*", "**") and not is_namespace(f"/{part}"):
                return f"{key[:100]} is no name of a node: {part[:60]!r} can be no part of a namespace"
        if "//" in key:
            return f"{key[:100]} is no name of a node: two slashes stand side by side"
    if name not in ("*", "**") and not is_node_name(name):
        what = f"{key[:100]} is no name of a node{f', since {name[:60]!r} is none' if slash else ''}"
        return f"{what} (letters, digits and underscores, no digit at the beginning)"
    return ""
