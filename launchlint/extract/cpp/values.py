"""What a variable can hold, as far as the names of a node depend on it."""

from __future__ import annotations

from typing import Final

from launchlint.extract.cpp.declarations import Class, Function
from launchlint.extract.cpp.spelled_type import UNTYPED, Type
from launchlint.extract.cpp.syntax import Node
from launchlint.named_tuple import NamedTuple

TYPE_CHECKING = False
if TYPE_CHECKING:
    from launchlint.extract.cpp.frame import Frame


class Unknown:
    """A value of which nothing is known; there is one, :data:`UNKNOWN`."""

    __slots__ = ()

    def __repr__(self) -> str:
        return "UNKNOWN"


UNKNOWN: Final = Unknown()


class Text(NamedTuple):
    """A string, as a template of the library format; ``param`` says that it is the value of a param, which may be of another type."""

    template: str
    param: bool = False


class Number(NamedTuple):
    """A truth value or a number."""

    value: bool | int | float

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Number) and type(other.value) is type(self.value) and other.value == self.value

    def __ne__(self, other: object) -> bool:
        return not self == other

    def __hash__(self) -> int:
        return hash(self.value)


class Null:
    """The null pointer, an empty shared_ptr; there is one, :data:`NULL`."""

    __slots__ = ()

    def __repr__(self) -> str:
        return "NULL"


NULL: Final = Null()


class Handle(NamedTuple):
    """A ros::NodeHandle: its namespace is empty, ``~``, ``~/sub``, ``sub`` or ``/global``.

    In ROS 2 it is a node, or a sub-node with its namespace; ``node`` is then its key (:attr:`launchlint.extract.fact.Made.key`).
    """

    namespace: str
    node: str | None = None

    @property
    def word(self) -> str:
        """What people call it."""
        return "node handle" if self.node is None else "node"


class Items(NamedTuple):
    """The items of a list whose length is known. ``pairs`` of a map are Items, too."""

    items: tuple[Value, ...]


class Callable(NamedTuple):
    """Functions of one name, the object they are called on, and the arguments that are bound (a number: the place of an argument), and
    the template arguments that are given.
    """

    functions: tuple[Function, ...]
    this: Thing | None = None
    bound: tuple[int | Value, ...] | None = None
    types: tuple[Type, ...] = ()


class Closure:
    """A lambda expression and the frame it was made in."""

    __slots__ = ("frame", "node")

    def __init__(self, node: Node, frame: Frame) -> None:
        self.node = node
        self.frame = frame


class Either(NamedTuple):
    """One of several values, each with the source text of the condition under which it is that."""

    choices: tuple[tuple[str, Value], ...]


class Cell:
    """A variable.

    ``serial`` counts variables in the order they come into being; one that is ``changing`` is assigned by several functions.
    """

    __slots__ = ("changing", "constant", "serial", "type", "value")

    def __init__(self, value: Value, type_: Type = UNTYPED, serial: int = 0, constant: bool = False) -> None:
        self.value = value
        self.type = type_
        self.serial = serial
        self.constant = constant
        self.changing = False


class Thing:
    """An object. ``declared`` is its class where the sources have it; ``bindings`` are the class's template arguments."""

    __slots__ = ("bindings", "declared", "fields", "serial", "type")

    def __init__(self, type_: Type, declared: Class | None, serial: int, bindings: dict[str, Type] | None = None) -> None:
        self.type = type_
        self.declared = declared
        self.serial = serial
        self.bindings = bindings or {}
        self.fields: dict[str, Cell] = {}


Value = Unknown | Null | Text | Number | Handle | Items | Callable | Closure | Either | Thing


class Argument(NamedTuple):
    """An argument of a call: its value, the variable it stands in, and its source."""

    value: Value
    cell: Cell | None = None
    node: Node | None = None


def node_of(value: Value) -> Handle | None:
    """The node handle, or the node of ROS 2, that a value is; None where it is neither."""
    if isinstance(value, Thing):
        held = value.fields.get("<handle>")
        value = UNKNOWN if held is None else held.value
        return value if isinstance(value, Handle) and value.node is not None else None
    return value if isinstance(value, Handle) else None


MOST_CHOICES: Final = 8
MOST_OBJECTS: Final = 64
MOST_ITEMS: Final = 40


def choices(value: Value) -> tuple[tuple[str, Value], ...]:
    """The values that ``value`` can be, with the conditions: one without a condition, mostly."""
    return value.choices if isinstance(value, Either) else (("", value),)


_PLAIN = frozenset(("rclcpp::QoS", "rmw_qos_policy_t"))
"""Objects that are no more than values: beside one of them what is not known is another one, and not the same that was not followed."""


def _is_plain(value: Value) -> bool:
    return isinstance(value, Thing) and value.type.name in _PLAIN


def either(found: list[tuple[str, Value]]) -> Value:
    """One of several values; the same value twice is one, and what is no value gives way to one."""
    if len(found) == 1 or (len(found) == 2 and found[0][1] is found[1][1]):
        if not isinstance(found[0][1], Either):
            return found[0][1]
    elif len(found) == 2 and (found[0][1] is UNKNOWN or found[1][1] is UNKNOWN):
        other = found[1][1] if found[0][1] is UNKNOWN else found[0][1]
        if isinstance(other, (Number, Null)):
            return UNKNOWN
        if isinstance(other, (Thing, Handle, Callable, Closure)) and not _is_plain(other):
            return other
    flat: list[tuple[str, Value]] = []
    for condition, value in found:
        for inner, choice in choices(value):
            flat.append((both(condition, inner) if inner else condition, choice))
    distinct: dict[Value, str] = {}
    for condition, value in flat:
        if value not in distinct:
            distinct[value] = condition
        elif distinct[value] != condition:
            distinct[value] = ""
    if len(distinct) > 1:
        known: dict[Value, str] = {
            value: condition for value, condition in distinct.items() if not isinstance(value, (Unknown, Null)) and value != Text("")
        }
        if known and all(isinstance(value, (Thing, Handle, Callable, Closure)) and not _is_plain(value) for value in known):
            distinct = known
        elif all(isinstance(value, Items) for value in distinct):
            longest = max((value for value in distinct if isinstance(value, Items)), key=lambda value: len(value.items))
            if all(isinstance(value, Items) and longest.items[: len(value.items)] == value.items for value in distinct):
                return longest
            every = tuple(dict.fromkeys(item for value in distinct if isinstance(value, Items) for item in value.items))
            if len(every) <= MOST_ITEMS and all(isinstance(item, Thing) for item in every):
                return Items(every)
        elif Text("") in distinct and UNKNOWN not in distinct:
            distinct.pop(Text(""))
    if len(distinct) == 1:
        return next(iter(distinct))
    defaulted = _defaulted(list(distinct))
    if defaulted is not None:
        return defaulted
    most = MOST_OBJECTS if all(isinstance(value, Thing) for value in distinct) else MOST_CHOICES
    if len(distinct) > most or (UNKNOWN in distinct and all(isinstance(each, (Number, Unknown, Null)) for each in distinct)):
        return UNKNOWN
    return Either(tuple((condition, value) for value, condition in distinct.items()))


def _defaulted(values: list[Value]) -> Value | None:
    """``{param:x}`` or a constant: that is a param with a default."""
    if len(values) != 2:
        return None
    texts = [each for each in values if isinstance(each, Text) and each.template.startswith("{param:") and each.param]
    others = [each for each in values if each not in texts]
    if len(texts) != 1 or len(others) != 1:
        return None
    slot = texts[0].template.removesuffix("}").removesuffix("|")  # an empty text that was there before is no default
    constant = plain(others[0])
    return None if constant is None or "|" in slot or slot.count("{") != 1 or "}" in slot else Text(f"{slot}|{constant}}}", True)


def plain(value: Value) -> str | None:
    """The text of a constant."""
    if isinstance(value, Text):
        return value.template if "{" not in value.template and "}" not in value.template else None
    if isinstance(value, Number):
        return str(value.value).lower() if isinstance(value.value, bool) else str(value.value)
    return None


def both(first: str, second: str) -> str:
    """Two conditions as one."""
    if not first or first == second:
        return second
    return f"{first} and {second}" if second else first
