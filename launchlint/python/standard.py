"""Python's own library, as far as programs are made with it: threads and timers, modules by name, copies, named tuples, paths."""

from __future__ import annotations

from collections.abc import Callable, Mapping

from launchlint.python.call import Call
from launchlint.python.memory import Ended
from launchlint.python.values import MISSING, UNKNOWN, Argv, External, Handle, Map, Partial, Seq, Value, alternatives, choice

LONGEST_NAME = 300


def attribute(name: str, member: str) -> Value:
    """``name.member`` of a module that is not followed, of which nothing else is known."""
    full = f"{name}.{member}"
    if full == "sys.argv":
        return Argv(0)
    return External(full) if len(full) < LONGEST_NAME and full != "sys.maxsize" else UNKNOWN


def thread(made: Call) -> Value:
    """``threading.Thread``: what it runs is called."""
    target = made.get(1, "target")
    arguments = made.get(3, "args", Seq([]))
    keywords = made.get(4, "kwargs", Map({}))
    if target not in (MISSING, None):
        positional = list(arguments.items) if isinstance(arguments, Seq) else None
        made.run.arrange(target, "start", positional, dict(keywords.entries) if isinstance(keywords, Map) else {})
    return Handle("plain", {})


def _timer(made: Call) -> Value:
    target = made.get(1, "function")
    arguments = made.get(2, "args", Seq([]))
    if target not in (MISSING, None):
        made.run.arrange(target, "start", list(arguments.items) if isinstance(arguments, Seq) else None)
    return Handle("plain", {})


def _partial(made: Call) -> Value:
    if not made.positional:
        return UNKNOWN
    return Partial(made.positional[0], tuple(made.positional[1:]), tuple(made.keywords.items()))


def _end(made: Call) -> Value:
    raise Ended


def _empty_mapping(made: Call) -> Value:
    first = made.positional[-1] if made.positional else MISSING
    entries = first.entries if isinstance(first, Map) else {}
    return Map({**entries, **made.keywords}, not made.positional or isinstance(first, Map))


def _default_mapping(made: Call) -> Value:
    return Map({}, False)


def _empty_sequence(made: Call) -> Value:
    first = made.positional[0] if made.positional else MISSING
    return Seq(list(first.items), first.complete) if isinstance(first, Seq) else Seq([], first is MISSING)


def _copied(made: Call) -> Value:
    return made.positional[0] if made.positional else UNKNOWN


def _imported(made: Call) -> Value:
    """``importlib.import_module``: a module by a name that is worked out."""
    name = made.get(0, "name", UNKNOWN)
    return choice([(condition, made.run.module(each, made)) for condition, each in alternatives(name)])


def _loaded(made: Call) -> Value:
    made.run.module(UNKNOWN, made)
    return UNKNOWN


def _plain_class(made: Call) -> Value:
    """A class that is made by a call and has no methods that talk."""
    return External("builtins.object")


def _with_metaclass(made: Call) -> Value:
    return made.get(1, "base", External("builtins.object"))


def _wrapped(made: Call) -> Value:
    """``functools.wraps(f)``: a decorator that gives back what it gets."""
    return External("copy.copy")


HANDLERS: Mapping[str, Callable[[Call], Value]] = {
    "sys.exit": _end,
    "os._exit": _end,
    "os.abort": _end,
    "threading.Thread": thread,
    "multiprocessing.Process": thread,
    "threading.Timer": _timer,
    "functools.partial": _partial,
    "functools.wraps": _wrapped,
    "importlib.import_module": _imported,
    "imp.load_source": _loaded,
    "imp.load_module": _loaded,
    "importlib.util.spec_from_file_location": _loaded,
    "runpy.run_path": _loaded,
    "runpy.run_module": _loaded,
    "collections.namedtuple": _plain_class,
    "typing.NamedTuple": _plain_class,
    "six.with_metaclass": _with_metaclass,
    "future.utils.with_metaclass": _with_metaclass,
    "copy.copy": _copied,
    "copy.deepcopy": _copied,
    "collections.OrderedDict": _empty_mapping,
    "collections.defaultdict": _default_mapping,
    "collections.deque": _empty_sequence,
}
"""What a call of it, by its full name, gives."""
