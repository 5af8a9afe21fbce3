"""Methods of lists, tuples, sets and dicts where all of their content is known, as Python has them."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from typing import Any

from launchlint.python.failures import failure, of_python
from launchlint.python.operations import equal
from launchlint.python.plain import NotPlain, key_of, of_key, plain, value_of
from launchlint.python.values import ENTRIES, ITEMS, KIND, MISSING, MOST_EXACT, Choice, Instance, Map, Seq, Value, alike, is_maybe

TYPE_CHECKING = False
if TYPE_CHECKING:
    from launchlint.python.expressions import Expressions

_SETS = ("set", "frozenset")


def method(run: Expressions, receiver: Seq | Map, name: str, positional: Sequence[Value], keywords: dict[str, Value]) -> Value:
    """The value of a call; MISSING where it is not known exactly, and nothing has been changed then. Raises Raised."""
    run.spend(len(receiver.content.get(ITEMS) or receiver.content.get(ENTRIES) or ()))
    if isinstance(receiver, Map):
        dict_method = _OF_DICT.get(name)
        return MISSING if dict_method is None else dict_method(run, receiver, list(positional), keywords)
    table = _OF_LIST if receiver.kind in ("list", "tuple", "listing") else _OF_SET if receiver.kind in _SETS else {}
    seq_method = table.get(name)
    if seq_method is None or (receiver.kind == "tuple" and name not in ("index", "count")):
        return MISSING
    if receiver.kind == "listing" and name not in ("append", "extend", "count", "remove", "sort", "clear"):
        return MISSING
    try:
        return seq_method(run, receiver, list(positional), keywords)
    except NotPlain:
        return MISSING


def _write(run: Expressions, receiver: Seq, items: list[Value]) -> None:
    run.store(receiver.content, ITEMS, items)


# -- lists ---------------------------------------------------------------------------------------------------------------------


def _append(run: Expressions, receiver: Seq, given: list[Value], keywords: dict[str, Value]) -> Value:
    if len(given) != 1 or len(receiver.items) >= MOST_EXACT:
        return MISSING
    _write(run, receiver, [*receiver.items, given[0]])
    return None


def _extend(run: Expressions, receiver: Seq, given: list[Value], keywords: dict[str, Value]) -> Value:
    if len(given) != 1:
        return MISSING
    items, complete = run.rounds(given[0])
    if not complete or len(receiver.items) + len(items) > MOST_EXACT:
        return MISSING
    _write(run, receiver, [*receiver.items, *items])
    return None


def _insert(run: Expressions, receiver: Seq, given: list[Value], keywords: dict[str, Value]) -> Value:
    if len(given) != 2 or not isinstance(given[0], int) or len(receiver.items) >= MOST_EXACT:
        return MISSING
    if not receiver.is_sure and given[0] != 0:
        return MISSING
    items = list(receiver.items)
    items.insert(given[0], given[1])
    _write(run, receiver, items)
    return None


def _pop(run: Expressions, receiver: Seq, given: list[Value], keywords: dict[str, Value]) -> Value:
    at = given[0] if given else -1
    if not receiver.is_sure or not isinstance(at, int):
        return MISSING
    items = list(receiver.items)
    try:
        taken = items.pop(at)
    except IndexError as error:
        raise of_python(error) from None
    _write(run, receiver, items)
    return taken


def _found(receiver: Seq, value: Value, begin: int = 0, end: int | None = None) -> int | None:
    """Where the first item is that is equal to a value; -1 where there is none, None where that is not known."""
    if not receiver.is_sure:
        return None
    for at, each in list(enumerate(receiver.items))[begin:end]:
        known = equal(each, value)
        if known is None:
            return None
        if known:
            return at
    return -1


def _remove(run: Expressions, receiver: Seq, given: list[Value], keywords: dict[str, Value]) -> Value:
    at = _found(receiver, given[0]) if len(given) == 1 else None
    if at is None:
        return MISSING
    if at < 0:
        raise failure("ValueError", "list.remove(x): x not in list")
    _write(run, receiver, [*receiver.items[:at], *receiver.items[at + 1 :]])
    return None


def _index(run: Expressions, receiver: Seq, given: list[Value], keywords: dict[str, Value]) -> Value:
    if not 1 <= len(given) <= 3 or not all(isinstance(each, int) and each >= 0 for each in given[1:]):
        return MISSING
    at = _found(receiver, *given)
    if at is None:
        return MISSING
    if at < 0:
        raise failure("ValueError", "is not in list")
    return at


def _count(run: Expressions, receiver: Seq, given: list[Value], keywords: dict[str, Value]) -> Value:
    if len(given) != 1 or not receiver.is_sure:
        return MISSING
    answers = [equal(each, given[0]) for each in receiver.items]
    return MISSING if None in answers else answers.count(True)


def _reverse(run: Expressions, receiver: Seq, given: list[Value], keywords: dict[str, Value]) -> Value:
    if given or not receiver.complete:
        return MISSING
    _write(run, receiver, receiver.items[::-1])
    return None


def _sort(run: Expressions, receiver: Seq, given: list[Value], keywords: dict[str, Value]) -> Value:
    if given or not receiver.is_sure:
        return MISSING
    items = run.sorted(receiver.items, keywords)
    if items is None:
        return MISSING
    _write(run, receiver, items)
    if receiver.kind == "listing":
        run.store(receiver.content, KIND, "list")
    return None


def _clear(run: Expressions, receiver: Seq, given: list[Value], keywords: dict[str, Value]) -> Value:
    _write(run, receiver, [])
    return None


def _copy(run: Expressions, receiver: Seq, given: list[Value], keywords: dict[str, Value]) -> Value:
    return Seq(list(receiver.items), receiver.complete, kind=receiver.kind)


# -- sets ----------------------------------------------------------------------------------------------------------------------


def distinct(items: Sequence[Value]) -> list[Value] | None:
    """Items, each once, in order; None where it is not known which are the same."""
    found: dict[Any, Value] = {}
    try:
        for each in items:
            found.setdefault(_hashed(each), each)
    except NotPlain:
        return None
    return list(found.values())


def _hashed(value: Value) -> Any:
    made = value if isinstance(value, (str, int, float, type(None))) else plain(value)
    try:
        hash(made)
    except TypeError as error:
        raise of_python(error) from None
    return made


def _add(run: Expressions, receiver: Seq, given: list[Value], keywords: dict[str, Value]) -> Value:
    items = distinct([*receiver.items, *given]) if len(given) == 1 and receiver.is_sure else None
    if items is None:
        return MISSING
    _write(run, receiver, items)
    return None


def _discard(run: Expressions, receiver: Seq, given: list[Value], keywords: dict[str, Value]) -> Value:
    if len(given) == 1 and (
        not isinstance(given[0], (Instance, Seq)) or (isinstance(given[0], Seq) and given[0].kind in ("list", "tuple"))
    ):
        _hashed(given[0])
    at = _found(receiver, given[0]) if len(given) == 1 else None
    if at is None:
        return MISSING
    if at >= 0:
        _write(run, receiver, [*receiver.items[:at], *receiver.items[at + 1 :]])
    return None


def _remove_of_set(run: Expressions, receiver: Seq, given: list[Value], keywords: dict[str, Value]) -> Value:
    if len(given) == 1 and not isinstance(given[0], (Instance, Seq)):
        _hashed(given[0])
    at = _found(receiver, given[0]) if len(given) == 1 else None
    if at is not None and at < 0:
        raise failure("KeyError", given[0])
    return _discard(run, receiver, given, keywords)


def _combined(operation: str, changes: bool = False) -> Callable[[Expressions, Seq, list[Value], dict[str, Value]], Value]:
    def combine(run: Expressions, receiver: Seq, given: list[Value], keywords: dict[str, Value]) -> Value:
        try:
            others = [plain(Seq(run.all_items(each))) for each in given]
            own = set(plain(receiver))
            made: Any = getattr(own, operation)(*others)
            if changes:
                _write(run, receiver, value_of(made).items)
                return None
            return value_of(frozenset(made) if receiver.kind == "frozenset" and isinstance(made, set) else made)
        except NotPlain:
            return MISSING
        except TypeError as error:
            raise of_python(error) from None

    return combine


# -- dicts ---------------------------------------------------------------------------------------------------------------------


def _key(receiver: Map, value: Value) -> Any:
    """The key of a dict in which all keys are known; MISSING where it is not known."""
    try:
        key = key_of(value)
        hash(key)
    except (NotPlain, TypeError):
        return MISSING
    known = isinstance(key, (str, int, float, type(None))) or not isinstance(value, (Map, Seq)) or hasattr(key, "items")
    return key if known and (receiver.complete or key in receiver.entries) else MISSING


def _get(run: Expressions, receiver: Map, given: list[Value], keywords: dict[str, Value]) -> Value:
    key = _known_key(receiver, given, keywords)
    if key is MISSING:
        return MISSING
    found = receiver.entries.get(key, given[1] if len(given) > 1 else None)
    return MISSING if is_maybe(found) else found


def _known_key(receiver: Map, given: list[Value], keywords: dict[str, Value]) -> Any:
    if not 1 <= len(given) <= 2 or keywords or not isinstance(given[0], (str, int, float, type(None), Seq)):
        return MISSING
    return _key(receiver, given[0])


def _take(run: Expressions, receiver: Map, given: list[Value], keywords: dict[str, Value]) -> Value:
    key = _known_key(receiver, given, keywords)
    if key is MISSING or is_maybe(receiver.entries.get(key)):
        return MISSING
    entries = dict(receiver.entries)
    if key in entries:
        taken = entries.pop(key)
        run.store(receiver.content, ENTRIES, entries)
        return taken
    if len(given) > 1:
        return given[1]
    raise failure("KeyError", given[0])


def _set_default(run: Expressions, receiver: Map, given: list[Value], keywords: dict[str, Value]) -> Value:
    key = _known_key(receiver, given, keywords)
    if key is MISSING or is_maybe(receiver.entries.get(key)):
        return MISSING
    if key not in receiver.entries:
        run.store(receiver.content, ENTRIES, {**receiver.entries, key: given[1] if len(given) > 1 else None})
    return receiver.entries[key]


def _pop_item(run: Expressions, receiver: Map, given: list[Value], keywords: dict[str, Value]) -> Value:
    if given or not receiver.is_sure:
        return MISSING
    if not receiver.entries:
        raise failure("KeyError", "popitem(): dictionary is empty")
    entries = dict(receiver.entries)
    key, value = entries.popitem()
    run.store(receiver.content, ENTRIES, entries)
    return Seq([of_key(key), value], is_tuple=True)


def _update(run: Expressions, receiver: Map, given: list[Value], keywords: dict[str, Value]) -> Value:
    added = entries_of(run, given[0]) if given else {}
    if added is None or len(given) > 1:
        return MISSING
    run.store(receiver.content, ENTRIES, {**receiver.entries, **added, **keywords})
    return None


def entries_of(run: Expressions, value: Value) -> dict[Any, Value] | None:
    """What ``dict(value)`` holds; None where that is not known."""
    if isinstance(value, Map):
        return dict(value.entries) if value.complete else None
    if not isinstance(value, Seq) or not value.is_sure:
        return None
    found: dict[Any, Value] = {}
    for each in run.all_items(value):
        pair = run.all_items(each) if isinstance(each, (Seq, str)) else []
        if len(pair) != 2:
            return None
        try:
            key = key_of(pair[0])
            hash(key)
        except (NotPlain, TypeError):
            return None
        if not isinstance(key, (str, int, float, type(None))) and not hasattr(key, "items"):
            return None
        found[key] = pair[1]
    return found


def _copy_of_dict(run: Expressions, receiver: Map, given: list[Value], keywords: dict[str, Value]) -> Value:
    return Map(dict(receiver.entries), receiver.complete)


def _clear_dict(run: Expressions, receiver: Map, given: list[Value], keywords: dict[str, Value]) -> Value:
    if not receiver.complete:
        return MISSING
    run.store(receiver.content, ENTRIES, {})
    return None


def _keys(run: Expressions, receiver: Map, given: list[Value], keywords: dict[str, Value]) -> Value:
    return _view(receiver, keys_of(receiver))


def _view(receiver: Map, parts: list[Value]) -> Value:
    """What a dict shows of its entries."""
    made = Seq(parts, receiver.complete, kind="view")
    return alike(made) if receiver.is_alike else made


def keys_of(receiver: Map) -> list[Value]:
    """The keys of a dict as values, in order."""
    return [Choice(((each.alternatives[0][0], of_key(key)),)) if is_maybe(each) else of_key(key) for key, each in receiver.entries.items()]


def _values(run: Expressions, receiver: Map, given: list[Value], keywords: dict[str, Value]) -> Value:
    return _view(receiver, list(receiver.entries.values()))


def _pairs(run: Expressions, receiver: Map, given: list[Value], keywords: dict[str, Value]) -> Value:
    pairs: list[Value] = []
    for key, value in receiver.entries.items():
        condition, known = value.alternatives[0] if is_maybe(value) else ("", value)
        pair = Seq([of_key(key), known], is_tuple=True)
        pairs.append(Choice(((condition, pair),)) if is_maybe(value) else pair)
    return _view(receiver, pairs)


_OF_LIST: Mapping[str, Callable[[Any, Seq, list[Value], dict[str, Value]], Value]] = {
    "append": _append,
    "extend": _extend,
    "insert": _insert,
    "pop": _pop,
    "remove": _remove,
    "index": _index,
    "count": _count,
    "reverse": _reverse,
    "sort": _sort,
    "clear": _clear,
    "copy": _copy,
}
_OF_SET: Mapping[str, Callable[[Any, Seq, list[Value], dict[str, Value]], Value]] = {
    "add": _add,
    "discard": _discard,
    "remove": _remove_of_set,
    "clear": _clear,
    "copy": _copy,
    "union": _combined("union"),
    "intersection": _combined("intersection"),
    "difference": _combined("difference"),
    "symmetric_difference": _combined("symmetric_difference"),
    "issubset": _combined("issubset"),
    "issuperset": _combined("issuperset"),
    "isdisjoint": _combined("isdisjoint"),
    "update": _combined("union", changes=True),
    "intersection_update": _combined("intersection", changes=True),
    "difference_update": _combined("difference", changes=True),
}
_OF_DICT: Mapping[str, Callable[[Any, Map, list[Value], dict[str, Value]], Value]] = {
    "get": _get,
    "pop": _take,
    "setdefault": _set_default,
    "popitem": _pop_item,
    "update": _update,
    "copy": _copy_of_dict,
    "clear": _clear_dict,
    "keys": _keys,
    "values": _values,
    "items": _pairs,
}
