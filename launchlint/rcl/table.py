"""The parameters that a command line gives, by the node they are for: rcl fills one table from all files and ``-p`` rules.

Source: ``rcl_yaml_param_parser`` (``find_node``, ``find_parameter``, ``rcl_variant_t``); which keys reach a node is said by rclcpp's
``parameter_map_from`` and rclpy's counterpart.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from launchlint.named_tuple import NamedTuple
from launchlint.rcl.parameter_value import NONE, ScalarValue, Value
from launchlint.source import Span

TYPE_CHECKING = False
if TYPE_CHECKING:
    from launchlint.rcl.parameter_value import Type
    from launchlint.source import Source

ANY = "/**"
"""The key of a ``-p`` rule that names no node."""

# Of several values of different types that one parameter was given, this order says which one counts.
_ORDER: tuple[Type, ...] = ("bool", "int", "double", "str", "bool[]", "int[]", "double[]", "str[]")


class Written(NamedTuple):
    """Where a parameter was set last: its name and its value in ``source`` (None: on the command line).

    ``order`` grows with each name that is read, over all files.
    """

    source: Source | None
    name: Span
    value: Span
    order: int = 0


class Parameter:
    """One parameter of one key: what it was given, by type. A second value of the same type replaces the first; one of another does not.

    ``nested``: it stands in a mapping that is the value of another name.
    """

    __slots__ = ("given", "name", "nested", "written")

    def __init__(self, name: str, written: Written) -> None:
        self.name = name
        self.given: dict[Type, Value] = {}
        self.nested = False
        self.written = written

    def later(self, by: int) -> Parameter:
        """The same, read after ``by`` other names."""
        made = Parameter(self.name, self.written._replace(order=self.written.order + by))
        made.given = dict(self.given)
        made.nested = self.nested
        return made

    def give(self, value: Value | ScalarValue) -> None:
        """One more value."""
        self.given[value.type] = Value(value.type, value.data)

    @property
    def value(self) -> Value:
        """The value that counts: not the last one, where the types differ."""
        if len(self.given) == 1:
            return next(iter(self.given.values()))
        return next((self.given[type_] for type_ in _ORDER if type_ in self.given), NONE)


class Key:
    """What one key of a file is given, ``/ns/node`` or with wildcards; ``written`` is where it stands first."""

    __slots__ = ("_places", "name", "parameters", "written")

    def __init__(self, name: str, written: tuple[Source | None, Span]) -> None:
        self.name = name
        self.written = written
        self.parameters: list[Parameter] = []
        self._places: dict[str, int] = {}

    def place(self, name: str, written: Written) -> int:
        """Where the parameter ``name`` stands in the list; it is put there if it is new."""
        known = self._places.get(name)
        if known is not None:
            self.parameters[known].written = written
            return known
        self.parameters.append(Parameter(name, written))
        self._places[name] = len(self.parameters) - 1
        return len(self.parameters) - 1

    def rename(self, place: int, name: str) -> None:
        """The parameter there turns out to be the namespace of another one, whose name takes its place."""
        parameter = self.parameters[place]
        if self._places.get(parameter.name) == place:
            del self._places[parameter.name]
        parameter.name = name
        parameter.nested = True
        first = self._places.setdefault(name, place)
        if first > place:
            self._places[name] = place

    def would_rename(self, other: Key) -> bool:
        """Whether reading ``other`` after this one would make a parameter of this one the namespace of one of its own."""
        if not other.parameters or not self.parameters:
            return False
        names = self._places
        for parameter in other.parameters:
            if parameter.nested:
                at = parameter.name.find(".")
                while at >= 0:
                    if parameter.name[:at] in names:
                        return True
                    at = parameter.name.find(".", at + 1)
        return False

    def add(self, other: Key, by: int) -> None:
        """What ``other`` holds, read after this one and after ``by`` other names."""
        for parameter in other.parameters:
            known = None if parameter.nested else self._places.get(parameter.name)
            made = parameter.later(by)
            if known is None:
                self.parameters.append(made)
                self._places.setdefault(made.name, len(self.parameters) - 1)
            else:
                self.parameters[known].given.update(made.given)
                self.parameters[known].written = made.written


class Table:
    """All keys, in the order in which each of them came first. ``tags``: a tag such as ``!!str`` says of which type a value is.

    ``read`` counts the names that were read. A key may be that of another table, too, with the count of names that were read before it,
    until something is added to it.
    """

    __slots__ = ("_borrowed", "keys", "read", "tags")

    def __init__(self) -> None:
        self.keys: dict[str, Key] = {}
        self._borrowed: dict[str, int] = {}
        self.tags = True
        self.read = 0

    def written(self, source: Source | None, name: Span) -> Written:
        """The place of a name that is read now; its value follows."""
        self.read += 1
        return Written(source, name, name, self.read)

    def key(self, name: str, source: Source | None, span: Span) -> Key:
        """The key ``name``, which is made if it is new."""
        known = self.keys.get(name)
        if known is None:
            known = self.keys[name] = Key(name, (source, span))
        return self._own(known)

    def _own(self, key: Key) -> Key:
        before = self._borrowed.pop(key.name, None)
        if before is None:
            return key
        made = self.keys[key.name] = Key(key.name, key.written)
        made.add(key, before)
        return made

    def merge(self, other: Table) -> bool:
        """Take in what ``other`` holds, as if its file had been read into this table; False, and nothing is changed, where that differs."""
        for name, key in other.keys.items():
            mine = self.keys.get(name)
            if mine is not None and mine.would_rename(key):
                return False
        before, self.read = self.read, self.read + other.read
        for name, key in other.keys.items():
            mine = self.keys.get(name)
            if mine is None:
                self.keys[name] = key
                self._borrowed[name] = before
            else:
                self._own(mine).add(key, before)
        return True

    def order(self, key: Key, parameter: Parameter) -> int:
        """When a parameter was set last: a number that grows with each name that is read."""
        return parameter.written.order + self._borrowed.get(key.name, 0)

    def reaching(self, full_name: str) -> Iterator[Key]:
        """The keys that count for the node ``full_name``, in order: of two that set the same parameter the later one wins."""
        return (key for key in self.keys.values() if reaches(key.name, full_name))


def overrides(table: Table, full_name: str) -> Mapping[str, Value]:
    """The parameters with which the node ``full_name`` starts."""
    return {name: parameter.value for name, parameter in winning(table, full_name).items()}


def winning(table: Table, full_name: str) -> Mapping[str, Parameter]:
    """The same, each with where it was set."""
    return {parameter.name: parameter for key in table.reaching(full_name) for parameter in key.parameters}


def reaches(key: str, full_name: str) -> bool:
    """Whether what stands under ``key`` counts for the node ``full_name``; a bare ``n`` is ``/n`` and nothing else.

    ``*`` stands for one part of the name, ``**`` for any number of them, none as well.
    """
    if key == ANY:
        return True
    parts, name = key.lstrip("/").split("/") if key.startswith("/") else key.split("/"), full_name.lstrip("/").split("/")
    if "*" not in key:
        return parts == name
    reached = {0}
    for part in parts:
        if part == "**":
            reached = set(range(min(reached), len(name) + 1))
        else:
            reached = {at + 1 for at in reached if at < len(name) and part in ("*", name[at])}
        if not reached:
            return False
    return len(name) in reached
