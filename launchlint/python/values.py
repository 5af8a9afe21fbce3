"""What an expression of a followed program stands for.

Python's own ``str``, ``int``, ``float``, ``bool``, ``bytes`` and ``None`` stand for themselves; everything else is one of the classes here.
"""

from __future__ import annotations

from typing import Any

from launchlint.named_tuple import NamedTuple

TYPE_CHECKING = False
if TYPE_CHECKING:
    import ast
    from collections.abc import Iterator, Sequence

    from launchlint.python.source import Routine, Source

Value = Any
"""A value as described above; the classes here are told apart with ``isinstance``."""

SIGNS = ("\ue000", "\ue001")
"""In a :class:`Text`: parts that stand for something absolute (they begin with a slash); what they are, only the recogniser knows."""

ITEMS, ENTRIES, COMPLETE, KIND = "\0items", "\0entries", "\0complete", "\0kind"
"""Keys of the content of lists and dicts; no attribute can be called so."""

ALIKE = "alike"
"""What stands under ``COMPLETE``, beside True and False, for a list or dict that :func:`alike` has made."""

UNORDERED = ("set", "frozenset", "listing")
"""Kinds of :class:`Seq` whose order is nobody's; a ``listing`` is a list otherwise, as of the names in a directory."""

MORE = "\0more"
"""Among the arguments that have names: there may be others that are not known (``**unknown``)."""

MOST_ALTERNATIVES = 8
MOST_ITEMS = 256
MOST_EXACT = 20_000
"""Items of a list where a program is followed to the letter."""
MOST_ANCESTORS, MOST_BASES = 60, 30
LONGEST_TEXT = 1_000


class Text(NamedTuple):
    """A string of which parts come from outside: ``template`` is spelled as in the library format; :data:`SIGNS` may be in it."""

    template: str


class Unknown:
    """Any value at all; ``reason`` says why it is not known, where somebody asks for that, and ``place`` where it came to be.

    Two of them are never told apart by what they say: ask with ``isinstance``.
    """

    __slots__ = ("place", "reason")

    def __init__(self, reason: str = "", place: Any = None) -> None:
        self.reason = reason
        self.place = place

    def __repr__(self) -> str:
        return "UNKNOWN"


UNKNOWN = Unknown()


class Quiet(Unknown):
    """Any value at all, of something that raises no exception: only what is done with the value may."""

    __slots__ = ()


class Outside:
    """A value that comes from outside of the program, and of which a recogniser knows where from. As text it is a template."""

    __slots__ = ()

    def template(self) -> str:
        """What ``str()`` makes of it."""
        raise NotImplementedError

    def item(self, index: Value) -> Value:
        """``self[index]``."""
        return UNKNOWN

    def method(self, name: str, positional: Sequence[Value]) -> Value:
        """The value of a call of a method, as of a string."""
        return UNKNOWN

    def otherwise(self, default: Value) -> Value:
        """``self or default``, where that is one value of its kind; MISSING where it is one of the two."""
        return MISSING


class Thing:
    """What a recogniser knows as one thing: it counts as true and is never None. Two of them may be equal."""

    __slots__ = ()


class Failure(Thing):
    """An exception: ``type`` is the class that it is of, as a value."""

    __slots__ = ("arguments", "type")

    def __init__(self, type_: Value, arguments: tuple[Value, ...] = ()) -> None:
        self.type = type_
        self.arguments = arguments


class Missing:
    """No value: a variable that is not set, a default that is not given."""

    __slots__ = ()


MISSING = Missing()


class Seq:
    """A list, tuple or set. Its content is in a mapping, so that changing it can be taken back: its items and whether they are all.

    Of one that is not complete, whatever else is in it may be like what is known of it: see :func:`alike`.
    ``kind`` is ``list``, ``tuple``, ``range``, one of :data:`UNORDERED`, ``view`` (of a dict) or ``iterator`` (its items are taken once).
    An item that may be there or not is a :class:`Choice` with one alternative.
    """

    __slots__ = ("_made", "content")

    def __init__(self, items: list[Value], complete: bool = True, is_tuple: bool = False, kind: str = "list") -> None:
        self._made = "tuple" if is_tuple else kind
        self.content: dict[Any, Any] = {ITEMS: items[:MOST_EXACT], COMPLETE: complete and len(items) <= MOST_EXACT}

    @property
    def kind(self) -> str:
        """What it is: a list may turn into a listing, and back."""
        kind: str = self.content.get(KIND, self._made)
        return kind

    @property
    def is_tuple(self) -> bool:
        """Whether it is known to be a tuple."""
        return self.kind == "tuple"

    @property
    def is_sure(self) -> bool:
        """Whether it is known how many items there are, and in which order."""
        return self.complete and not any(map(is_maybe, self.items))

    @property
    def items(self) -> list[Value]:
        """The items that are known, in order."""
        items: list[Value] = self.content[ITEMS]
        return items

    @property
    def complete(self) -> bool:
        """Whether there are no others."""
        return self.content[COMPLETE] is True

    @property
    def is_alike(self) -> bool:
        """Whether others, if there are any, are like those that are known."""
        return self.content[COMPLETE] is ALIKE


class Key:
    """A tuple as the key of a dict."""

    __slots__ = ("items",)

    def __init__(self, items: tuple[Any, ...]) -> None:
        self.items = items

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Key) and self.items == other.items

    def __hash__(self) -> int:
        return hash(self.items)


class Map:
    """A dict with constant keys; ``content`` as for :class:`Seq`, with ``entries``."""

    __slots__ = ("content",)

    def __init__(self, entries: dict[Any, Value], complete: bool = True) -> None:
        self.content: dict[Any, Any] = {ENTRIES: entries, COMPLETE: complete}

    @property
    def entries(self) -> dict[Any, Value]:
        """What is known of it."""
        entries: dict[Any, Value] = self.content[ENTRIES]
        return entries

    @property
    def complete(self) -> bool:
        """Whether there is nothing else in it."""
        return self.content[COMPLETE] is True

    @property
    def is_alike(self) -> bool:
        """Whether all else in it, if there is anything, is like what is known."""
        return self.content[COMPLETE] is ALIKE

    @property
    def is_sure(self) -> bool:
        """Whether it is known which keys there are."""
        return self.complete and not any(map(is_maybe, self.entries.values()))


def alike(made: Seq | Map) -> Seq | Map:
    """A new list or dict of which each item that is not known was worked out as one that stands for all like it.

    ``[f"/robot{number}" for number in range(count)]`` is one of ``/robot{any}`` where ``count`` is not known.
    """
    known = made.items if isinstance(made, Seq) else made.entries
    if not made.complete and len(known) < MOST_EXACT:
        made.content[COMPLETE] = ALIKE
    return made


class Argv(NamedTuple):
    """``sys.argv`` from ``offset`` on."""

    offset: int


class Scope:
    """Variables of a module, function or class, and where to look further; of a comprehension ``around`` is what it stands in.

    ``own`` are the names that a function writes: they are its own even before it has written them.
    """

    __slots__ = ("around", "module", "outer", "own", "shared", "variables")

    def __init__(self, module: Module, outer: Scope | None) -> None:
        self.module = module
        self.outer = outer
        self.around: Scope | None = None
        self.own: frozenset[str] = frozenset()
        self.variables: dict[Any, Any] = {}
        self.shared: dict[str, Scope] = {}


class Module:
    """A module whose source is followed. ``stars`` are the names of modules from which everything was imported and cannot be followed."""

    __slots__ = ("name", "path", "routines", "scope", "set_later", "stars")

    def __init__(self, name: str, path: str, source: Source | None) -> None:
        self.name = name
        self.path = path
        self.routines: tuple[Routine, ...] = () if source is None else source.routines
        self.set_later: frozenset[str] = frozenset() if source is None else source.set_later
        self.scope = Scope(self, None)
        self.stars: list[str] = []


class Function(NamedTuple):
    """A function or lambda with the scope it was made in; ``owner`` is the class whose body it stands in."""

    node: ast.FunctionDef | ast.AsyncFunctionDef | ast.Lambda
    scope: Scope
    defaults: tuple[Value, ...]
    keyword_defaults: tuple[tuple[str, Value], ...]
    owner: Class | None = None
    kind: str = ""


class Class:
    """A class with its attributes and bases, in the order in which they are searched."""

    __slots__ = ("attributes", "bases", "name", "order", "scope")

    def __init__(self, name: str, bases: list[Value], scope: Scope) -> None:
        self.name = name
        self.bases = bases
        self.scope = scope
        self.attributes = scope.variables
        above = bases[:MOST_BASES]
        self.order: tuple[Value, ...] = (self, *_merged([*(_order(base) for base in above), above]))[:MOST_ANCESTORS]
        """Itself and everything it inherits from, each once, in the order in which Python looks for an attribute (C3)."""

    def behind(self, after: Class) -> tuple[Value, ...]:
        """What ``super()`` in the class ``after`` means for objects of this one."""
        at = next((at for at, each in enumerate(self.order) if each is after), None)
        return after.order[1:] if at is None else self.order[at + 1 :]


def _order(base: Value) -> list[Value]:
    return list(base.order) if isinstance(base, Class) else [base]


def _merged(lists: list[list[Value]]) -> Iterator[Value]:
    """The order of base classes that keeps that of each list; that of the first list where there is no such order."""
    lists = [each for each in lists if each]
    while lists:
        heads = [each[0] for each in lists]
        free = (head for head in heads if not any(_is_same(head, other) for each in lists for other in each[1:]))
        head = next(free, heads[0])
        yield head
        lists = [rest for each in lists if (rest := [other for other in each if not _is_same(other, head)])]


def _is_same(one: Value, other: Value) -> bool:
    return one is other or (isinstance(one, External) and one == other)


class Instance:
    """An object of a followed class."""

    __slots__ = ("attributes", "type")

    def __init__(self, type_: Class) -> None:
        self.type = type_
        self.attributes: dict[Any, Any] = {}


class Bound(NamedTuple):
    """A method of an object: a followed function, or the name of a method of a built-in or recognised value."""

    receiver: Value
    function: Value


class Super(NamedTuple):
    """``super()``: the attributes of ``receiver``, an object or a class, behind those of the class ``after``."""

    after: Class
    receiver: Value


class External(NamedTuple):
    """Something of a module that is not followed, by its full name: ``os.getcwd``."""

    name: str


class Handle:
    """An object that a recognised call made, a parser of arguments for one. ``state`` holds what its methods need."""

    __slots__ = ("kind", "state")

    def __init__(self, kind: str, state: dict[Any, Any]) -> None:
        self.kind = kind
        self.state = state


class Partial(NamedTuple):
    """``functools.partial``."""

    function: Value
    positional: tuple[Value, ...]
    keywords: tuple[tuple[str, Value], ...]


class Choice(NamedTuple):
    """One of several values, each with the condition under which it is that one (empty: not known)."""

    alternatives: tuple[tuple[str, Value], ...]


def is_maybe(value: Value) -> bool:
    """Whether an item of a list, or an entry of a dict, may be there or not."""
    return isinstance(value, Choice) and len(value.alternatives) == 1


def alternatives(value: Value) -> tuple[tuple[str, Value], ...]:
    """The values that ``value`` can be, with conditions; one without condition where there is no choice."""
    return value.alternatives if isinstance(value, Choice) else (("", value),)


def choice(options: list[tuple[str, Value]]) -> Value:
    """One of ``options``; flattened, the same value once."""
    flat: list[tuple[str, Value]] = []
    for condition, value in options:
        for inner, each in alternatives(value):
            if each is MISSING:
                continue
            both = conjunction((condition, inner))
            for at, (known, other) in enumerate(flat):
                if same(other, each):
                    flat[at] = ("" if not known or not both or known != both else known, other)
                    break
            else:
                flat.append((both, each))
    if not flat:
        return MISSING
    if len(flat) == 1:
        return flat[0][1]
    return UNKNOWN if len(flat) > MOST_ALTERNATIVES else Choice(tuple(flat))


def same(one: Value, other: Value) -> bool:
    """Whether two values are the same thing."""
    if one is other or (isinstance(one, Unknown) and isinstance(other, Unknown)):
        return True
    simple = (str, int, float, bool, bytes, type(None), Text, External, Thing, Argv)
    return type(one) is type(other) and isinstance(one, simple) and bool(one == other)


def conjunction(conditions: tuple[str, ...] | list[str]) -> str:
    """All of several conditions as text, each once."""
    return " and ".join(dict.fromkeys(each for each in conditions if each))
