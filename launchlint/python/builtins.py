"""Python's own functions, and the methods of strings, lists and dicts, as far as names are made with them."""

from __future__ import annotations

import re
from collections.abc import Callable, Sequence

from launchlint.python import containers, functions, strings
from launchlint.python.text import ANY, braces, distribute, joined, path_joined, template, text
from launchlint.python.values import (
    COMPLETE,
    ENTRIES,
    ITEMS,
    MISSING,
    MOST_EXACT,
    MOST_ITEMS,
    SIGNS,
    UNKNOWN,
    Argv,
    Choice,
    Class,
    External,
    Instance,
    Map,
    Outside,
    Seq,
    Text,
    Unknown,
    Value,
    alike,
    alternatives,
    choice,
    is_maybe,
)

TYPE_CHECKING = False
if TYPE_CHECKING:
    from launchlint.python.expressions import Expressions

NAMES = frozenset(
    """abs all any bool callable chr dict dir divmod enumerate filter float format frozenset getattr hasattr hash hex id input int
    isinstance
    issubclass iter len list map max min next object open ord pow print property range raw_input repr reversed round set setattr
    sorted staticmethod classmethod str sum super tuple type unicode unichr vars xrange zip basestring long file reduce eval exec compile
    globals locals __import__ bytes bytearray memoryview exit quit cmp apply delattr slice complex bin oct ascii breakpoint
    Exception ValueError KeyError IndexError TypeError IOError OSError RuntimeError AttributeError ImportError NotImplementedError
    KeyboardInterrupt SystemExit StopIteration AssertionError NameError ZeroDivisionError BaseException StandardError EOFError
    UnicodeDecodeError UnicodeEncodeError UnicodeError DeprecationWarning Warning UserWarning NotImplemented Ellipsis __debug__
    ConnectionError TimeoutError FileNotFoundError PermissionError ModuleNotFoundError ArithmeticError OverflowError LookupError
    ConnectionRefusedError ConnectionResetError BrokenPipeError InterruptedError BlockingIOError EnvironmentError FileExistsError
    MemoryError RecursionError SyntaxError SystemError IsADirectoryError NotADirectoryError WindowsError FutureWarning""".split()
)

KEEPING = frozenset("dict list tuple str isinstance len zip enumerate sorted set range xrange iter".split())
"""Those that call nothing they are given."""

_CHANGING = frozenset(("sort", "reverse", "discard", "remove", "pop", "clear", "popitem", "insert", "popleft", "rotate"))


def function(run: Expressions, name: str, positional: Sequence[Value], keywords: dict[str, Value]) -> Value:
    """The value of a call of a built-in function. Raises Raised where the program is followed to the letter."""
    made = run.exactly(lambda: run.spread(lambda *each: functions.call(run, name, each, keywords), *positional))
    if made is not MISSING and (made is not UNKNOWN or run.exact):
        return made
    if run.exact:
        return _of_unknown(run, name, positional)
    first = positional[0] if positional else MISSING
    if name in ("str", "unicode", "repr", "format", "ascii"):
        if name == "repr" or isinstance(first, (Seq, Map)):
            return UNKNOWN
        return "" if first is MISSING else distribute(as_text, first)
    if name in ("int", "float", "bool", "long", "abs", "round"):
        return _number(name, first)
    if name in ("list", "tuple", "set", "sorted", "reversed", "frozenset", "iter"):
        return _sequence(name, first, run)
    if name == "dict":
        entries = dict(first.entries) if isinstance(first, Map) else {}
        return Map({**entries, **keywords}, first is MISSING or (isinstance(first, Map) and first.complete))
    if name == "len":
        return _length(first)
    if name in ("range", "xrange"):
        return _range(positional)
    if name == "enumerate":
        items, complete = run.rounds(first)
        start = positional[1] if len(positional) > 1 else keywords.get("start", 0)
        start = start if isinstance(start, int) else 0
        return alike(Seq([Seq([start + at if complete else UNKNOWN, item]) for at, item in enumerate(items)], complete))
    if name == "zip":
        lists = [run.rounds(each) for each in positional]
        return Seq([Seq(list(each)) for each in zip(*(items for items, _ in lists), strict=False)], all(complete for _, complete in lists))
    if name == "isinstance" and len(positional) == 2:
        return _is_instance(positional[0], positional[1])
    if name in ("min", "max") and len(positional) > 1 and all(isinstance(each, (int, float)) for each in positional):
        return min(positional) if name == "min" else max(positional)
    return UNKNOWN


def _of_unknown(run: Expressions, name: str, positional: Sequence[Value]) -> Value:
    """What is known of the value of a built-in function all the same."""
    first = positional[0] if positional else MISSING
    if name in ("str", "format") and len(positional) == 1:
        return run.as_text(first)
    if name == "next":
        return run.unknown()
    if isinstance(first, Seq) and first.kind == "iterator":
        run.risks += 1
        return Seq([], False)  # its items may have been taken
    if name in ("list", "tuple", "sorted", "reversed", "iter", "set", "frozenset") and isinstance(first, (Seq, Map)):
        items, complete = run.rounds(first)
        known = [each for each in items if complete or each is not UNKNOWN]
        ordered = name in ("list", "tuple", "iter")
        return Seq(
            known if ordered or complete else [],
            complete and (ordered or name == "reversed"),
            kind=name if name in KEEPING_KIND else "list",
        )
    if name == "enumerate" and isinstance(first, Seq):
        items, complete = run.rounds(first)
        pairs: list[Value] = [
            Choice(((each.alternatives[0][0], Seq([UNKNOWN, each.alternatives[0][1]], is_tuple=True)),))
            if is_maybe(each)
            else Seq([UNKNOWN, each], is_tuple=True)
            for each in items
            if complete or each is not UNKNOWN
        ]
        return Seq(pairs, complete)
    return run.unknown()


KEEPING_KIND = ("list", "tuple", "set", "frozenset")


def as_text(value: Value) -> Value:
    """What ``str()`` makes of a value that is no list or dict, as far as it is known."""
    if isinstance(value, (Seq, Map)):
        return UNKNOWN
    return value if isinstance(value, (Outside, Text)) else text(template(value))


_NUMBERS: dict[str, Callable[[Value], Value]] = {"int": int, "long": int, "float": float, "bool": bool, "abs": abs, "round": round}


def _number(name: str, value: Value) -> Value:
    if value is MISSING:
        return UNKNOWN
    if isinstance(value, (Outside, Choice, Text)) and name in ("int", "float", "long"):
        return value
    try:
        if isinstance(value, (int, float, str)) and not (isinstance(value, str) and len(value) > 50):
            make: Callable[[Value], Value] = _NUMBERS[name]
            return make(value)
    except (ValueError, TypeError, OverflowError):
        return UNKNOWN
    return UNKNOWN


def _sequence(name: str, value: Value, run: Expressions) -> Value:
    if value is MISSING:
        return Seq([])
    if isinstance(value, Argv):
        return value
    if isinstance(value, (Seq, Map)) or (isinstance(value, str) and name != "iter"):
        items, complete = run.rounds(value)
        if name == "reversed":
            items = items[::-1]
        if name == "sorted" and all(isinstance(each, str) for each in items):
            items = sorted(items)
        return alike(Seq(list(items), complete))
    return UNKNOWN


def _length(value: Value) -> Value:
    if isinstance(value, str):
        return len(value)
    if isinstance(value, Seq) and value.is_sure:
        return len(value.items)
    return len(value.entries) if isinstance(value, Map) and value.complete else UNKNOWN


def _range(bounds: Sequence[Value]) -> Value:
    if 1 <= len(bounds) <= 3 and all(isinstance(each, int) and abs(each) < 1 << 31 for each in bounds) and (len(bounds) < 3 or bounds[2]):
        steps = range(*bounds)
        return Seq(list(steps)) if len(steps) <= MOST_ITEMS else Seq([], False)
    return Seq([], False)


_KINDS = {"str": "str basestring unicode", "bool": "bool int", "int": "int long", "float": "float", "NoneType": ""}


def _is_instance(value: Value, types: Value) -> Value:
    wanted = types.items if isinstance(types, Seq) else [types]
    names = {each.name.removeprefix("builtins.") for each in wanted if isinstance(each, External)}
    if isinstance(value, (str, bool, int, float)) or value is None:
        own = _KINDS[type(value).__name__].split()
        return bool(names.intersection(own)) if len(names) == len(wanted) else UNKNOWN
    if isinstance(value, Instance) and all(isinstance(each, Class) for each in wanted):
        return any(each is above for each in wanted for above in value.type.order)
    return UNKNOWN


def method(run: Expressions, receiver: Value, name: str, positional: Sequence[Value], keywords: dict[str, Value]) -> Value:
    """The value of a call of a method of a string, list or dict. Raises Raised where the program is followed to the letter."""
    made: Value = MISSING
    if run.exact and isinstance(receiver, Outside):
        made = receiver.method(name, positional)
        return run.unknown() if isinstance(made, Unknown) else made
    if isinstance(receiver, (Seq, Map)):
        if isinstance(receiver, Map) or run.exact or not (positional and isinstance(positional[0], Argv)):
            made = run.exactly(lambda: containers.method(run, receiver, name, positional, keywords))
    elif isinstance(receiver, str) and name not in ("encode", "decode"):
        made = run.exactly(lambda: run.spread(lambda *each: strings.method(run, receiver, name, each, keywords), *positional))
    if made is not MISSING and (made is not UNKNOWN or run.exact):
        return made
    if run.exact:
        run.risks += 1
        if isinstance(receiver, (Seq, Map)):
            return _partly(run, receiver, name, positional)
    if isinstance(receiver, Seq):
        return _seq_method(run, receiver, name, positional)
    if isinstance(receiver, Map):
        return _map_method(run, receiver, name, positional, keywords)
    if isinstance(receiver, Argv):
        return UNKNOWN
    return _text_method(run, receiver, name, positional, keywords)


def _text_method(run: Expressions, receiver: Value, name: str, positional: Sequence[Value], keywords: dict[str, Value]) -> Value:
    if name == "format" and isinstance(receiver, str):
        return braces(receiver, positional, keywords)
    if name == "join" and isinstance(receiver, str):
        items, complete = run.rounds(positional[0] if positional else UNKNOWN)
        parts = [part for item in items for part in (receiver, item)][1:]
        return joined(parts) if complete else UNKNOWN
    if name in ("encode", "decode"):
        return receiver
    if isinstance(receiver, str):
        return string_method(receiver, name, positional)
    if isinstance(receiver, Text):
        known = run.recogniser.text_method(receiver.template, name, positional)
        return _open_text_method(receiver.template, name, positional) if known is MISSING else known
    return receiver.method(name, positional) if isinstance(receiver, Outside) else UNKNOWN


_READING = frozenset("index count copy get keys values items union intersection difference issubset issuperset isdisjoint".split())


def _partly(run: Expressions, receiver: Seq | Map, name: str, positional: Sequence[Value]) -> Value:
    """A method of a list or dict of which it is not known what it does: what may have been changed is not known any more."""
    first = positional[0] if len(positional) == 1 else UNKNOWN
    if name in _READING:
        return _read_of(receiver, name, positional)
    if isinstance(receiver, Map):
        others = dict(first.entries) if name == "update" and isinstance(first, Map) else {}
        run.store(receiver.content, ENTRIES, dict(receiver.entries) if name == "setdefault" else others)
    elif name in ("extend", "update", "append", "add"):
        added = [each for each in run.rounds(first)[0] if each is not UNKNOWN] if name in ("extend", "update") else list(positional)
        run.store(receiver.content, ITEMS, [*receiver.items, *added][:MOST_EXACT])
    elif name not in ("sort", "reverse"):
        run.store(receiver.content, ITEMS, [each if is_maybe(each) else Choice((("", each),)) for each in receiver.items])
    run.store(receiver.content, COMPLETE, False)
    return None if name in ("extend", "update", "append", "add", "sort", "reverse", "insert", "remove", "discard", "clear") else UNKNOWN


def _read_of(receiver: Seq | Map, name: str, positional: Sequence[Value]) -> Value:
    """What is asked of a list or dict that is known in part: one of the values of a dict, by a key that is not known."""
    if not isinstance(receiver, Map) or name != "get" or not positional or not receiver.complete:
        return UNKNOWN
    default = positional[1] if len(positional) > 1 else None
    first = positional[0]
    if isinstance(first, (str, int)) and first in receiver.entries:
        return choice([*alternatives(receiver.entries[first]), ("", default)])
    return choice([*((f"{key!r} is asked for", each) for key, each in receiver.entries.items()), ("something else is asked for", default)])


_PURE = frozenset(
    """strip lstrip rstrip lower upper title capitalize replace split rsplit splitlines startswith endswith find rfind count index isdigit
    isalpha isalnum islower isupper isspace partition rpartition zfill removeprefix removesuffix swapcase""".split()
)


def string_method(receiver: str, name: str, positional: Sequence[Value]) -> Value:
    """The value of a call of a method of a string that is known."""
    if name not in _PURE or not all(isinstance(each, (str, int, type(None))) for each in positional) or len(receiver) > 1000:
        return UNKNOWN
    if any((isinstance(each, int) and abs(each) > 1000) or (isinstance(each, str) and len(each) > 100) for each in positional):
        return UNKNOWN
    try:
        result = getattr(receiver, name)(*positional)
    except (TypeError, ValueError, IndexError):
        return UNKNOWN
    return Seq(list(result)) if isinstance(result, (list, tuple)) else result


def _open_text_method(spelled: str, name: str, positional: Sequence[Value]) -> Value:
    """Methods of a string of which only parts are known."""
    if name in ("strip", "lstrip", "rstrip") and not positional:
        return Text(spelled)
    what = positional[0] if positional else None
    if name == "rstrip" and isinstance(what, str):
        end = spelled.rstrip(what)
        return text(end) if end[-1:] != "}" else text(end + ANY)
    if name == "lstrip" and isinstance(what, str) and spelled[:1] not in ("{", *SIGNS):
        return text(spelled.lstrip(what) if spelled.lstrip(what)[:1] not in ("{", *SIGNS, "") else ANY)
    if name in ("startswith", "endswith") and isinstance(what, str):
        literal = re.match(r"[^{}\ue000\ue001]*", spelled)
        if name == "startswith" and literal is not None and len(literal[0]) >= len(what):
            return literal[0].startswith(what)
        return UNKNOWN
    return UNKNOWN


def _seq_method(run: Expressions, receiver: Seq, name: str, positional: Sequence[Value]) -> Value:
    content = receiver.content
    first = positional[0] if positional else UNKNOWN
    if name in ("append", "add", "appendleft", "put", "insert"):
        item = positional[-1] if positional else UNKNOWN
        if len(receiver.items) < MOST_ITEMS:
            run.store(content, ITEMS, [*receiver.items, item])
        else:
            run.store(content, COMPLETE, False)
        return None
    if name in ("extend", "update"):
        items, complete = run.rounds(first)
        run.store(content, ITEMS, [*receiver.items, *(items if complete else [])][:MOST_ITEMS])
        run.store(content, COMPLETE, receiver.complete and complete and len(receiver.items) < MOST_ITEMS)
        return None
    if name == "index" and receiver.complete:
        return next((at for at, each in enumerate(receiver.items) if isinstance(each, str) and each == first), UNKNOWN)
    if name == "copy":
        return Seq(list(receiver.items), receiver.complete)
    if name in ("pop", "popleft") and receiver.complete and receiver.items:
        at = 0 if name == "popleft" else first if isinstance(first, int) and -len(receiver.items) <= first < len(receiver.items) else -1
        items = list(receiver.items)
        taken = items.pop(at)
        run.store(content, ITEMS, items)
        return taken
    if name in _CHANGING and name not in ("sort", "reverse"):
        run.store(content, COMPLETE, False)
    return UNKNOWN


def _map_method(run: Expressions, receiver: Map, name: str, positional: Sequence[Value], keywords: dict[str, Value]) -> Value:
    entries = receiver.entries
    first = positional[0] if positional else UNKNOWN
    parts = {"items": [Seq([key, value]) for key, value in entries.items()], "keys": list(entries), "values": list(entries.values())}
    part = parts.get(name.removeprefix("iter").removeprefix("view"))
    if part is not None:
        return alike(Seq(part, False)) if receiver.is_alike else Seq(part, receiver.complete)
    if name in ("get", "pop", "setdefault"):
        default = positional[1] if len(positional) > 1 else None
        if isinstance(first, (str, int, Text)):
            if first in entries:
                return entries[first]
            if name == "setdefault":
                run.store(receiver.content, ENTRIES, {**entries, first: default})
            return default if receiver.complete else UNKNOWN
        options = [*((f"{key!r} is asked for", each) for key, each in entries.items()), ("something else is asked for", default)]
        return choice(options) if receiver.complete else UNKNOWN
    if name == "update":
        other = first.entries if isinstance(first, Map) else {}
        run.store(receiver.content, ENTRIES, {**entries, **other, **keywords})
        run.store(receiver.content, COMPLETE, receiver.complete and (not positional or (isinstance(first, Map) and first.complete)))
        return None
    if name == "copy":
        return Map(dict(entries), receiver.complete)
    if name in _CHANGING:
        run.store(receiver.content, COMPLETE, False)
    return UNKNOWN


def path_function(name: str, positional: Sequence[Value]) -> Value:
    """``os.path.join`` and the like."""
    if name == "join":
        return path_joined(positional)
    first = positional[0] if positional else UNKNOWN
    if isinstance(first, str) and name in ("basename", "dirname", "normpath") and len(first) < 1000:
        import posixpath

        result: str = getattr(posixpath, name)(first)
        return result
    return UNKNOWN
