"""The functions and methods that a ``setup.py`` calls, as far as what they give can be known."""

from __future__ import annotations

import os
import posixpath
from collections import defaultdict
from collections.abc import Callable, Mapping, Sequence
from pathlib import PurePosixPath

from launchlint.workspace.ament.setup_files import Files
from launchlint.workspace.ament.setup_values import UNKNOWN, Method, Name, items

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import TypeAlias

    from launchlint.workspace.ament.setup_values import Value

    Given: TypeAlias = Sequence[Value]
    Named: TypeAlias = Mapping[str, Value]

_LONGEST = 100_000
_MOST_ITEMS = 20_000
_TEXT_METHODS = frozenset(
    """capitalize endswith format join lower lstrip partition removeprefix removesuffix replace rpartition rsplit rstrip split splitlines
    startswith strip title upper""".split()
)
_LIST_METHODS = frozenset(("append", "extend", "insert", "copy", "sort", "reverse", "remove", "add", "update"))
_TABLE_METHODS = frozenset(("items", "keys", "values", "get", "setdefault", "update", "copy"))
_PATH_ATTRIBUTES = frozenset(("name", "stem", "suffix", "parent", "parts"))


def attribute(value: Value, name: str) -> Value:
    """``value.name``."""
    if isinstance(value, Name):
        return {"os.sep": "/", "os.path.sep": "/", "os.curdir": "."}.get(f"{value.dotted}.{name}", Name(f"{value.dotted}.{name}"))
    if isinstance(value, PurePosixPath) and name in _PATH_ATTRIBUTES:
        return getattr(value, name)
    return UNKNOWN if value is UNKNOWN else Method(value, name)


def call_method(value: Value, name: str, given: Given, named: Named, files: Files) -> Value:
    """``value.name(…)``; lists and dictionaries change."""
    if isinstance(value, str):
        if name not in _TEXT_METHODS or UNKNOWN in [*given, *named.values()]:
            return UNKNOWN
        if name == "join":
            parts = items(given[0]) if given else None
            if parts is None or not all(isinstance(each, str) for each in parts) or sum(map(len, parts)) > _LONGEST:
                return UNKNOWN
            return value.join(parts)
        text = [str(each) if isinstance(each, PurePosixPath) else each for each in given]
        if name == "replace" and len(value) * max(1, *(len(str(each)) for each in text), 1) > _LONGEST:
            return UNKNOWN
        if name == "format" and (not _plain_format(value) or not all(isinstance(each, (str, int)) for each in (*text, *named.values()))):
            return UNKNOWN
        return getattr(value, name)(*text, **named)
    if isinstance(value, (list, set)) and name in _LIST_METHODS:
        return _change(value, name, given)
    if isinstance(value, dict) and name in _TABLE_METHODS:
        if name in ("items", "keys", "values"):
            return [tuple(each) if name == "items" else each for each in getattr(value, name)()]
        return getattr(value, name)(*given) if UNKNOWN not in given[:1] else UNKNOWN
    if isinstance(value, PurePosixPath):
        return _path_method(value, name, given, files)
    return UNKNOWN


def _plain_format(text: str) -> bool:
    """Whether the fields are bare: ``{0.x}`` reaches into objects, ``{:>9999999}`` makes long text."""
    inner = text.replace("{{", "").replace("}}", "")
    return all(
        part.partition("}")[0].isidentifier() or part.partition("}")[0].isdigit() or part.startswith("}") for part in inner.split("{")[1:]
    )


def _change(value: Value, name: str, given: Given) -> Value:
    if name == "copy":
        return value.copy()
    if name in ("extend", "update"):
        more = items(given[0]) if given else []
        more = [UNKNOWN] if more is None or len(value) + len(more) > _MOST_ITEMS else more
        value.update(more) if isinstance(value, set) else value.extend(more)
    elif isinstance(value, set):
        value.add(given[0])
    elif name == "append":
        value.append(given[0])
    elif name == "insert":
        value.insert(0, given[1])
    elif name == "remove" and given and isinstance(given[0], str) and given[0] in value:
        value.remove(given[0])
    return None


def _path_method(value: PurePosixPath, name: str, given: Given, files: Files) -> Value:
    path = str(value)
    found: Sequence[str] | bool | None
    if name in ("resolve", "absolute"):
        return PurePosixPath(os.path.normpath(os.path.join(files.root, path)))
    if name in ("as_posix", "__str__"):
        return path
    if name == "joinpath":
        return UNKNOWN if UNKNOWN in given else value.joinpath(*given)
    if name in ("relative_to", "with_suffix", "with_name"):
        return UNKNOWN if UNKNOWN in given else getattr(value, name)(*given)
    if name in ("glob", "rglob") and given and isinstance(given[0], str):
        found = files.glob(f"{path}/{'**/' if name == 'rglob' else ''}{given[0]}", recursive=True)
    elif name == "iterdir":
        listed = files.listed(path)
        found = None if listed is None else [os.path.join(path, each) for each in listed]
    elif name in ("is_file", "is_dir", "exists"):
        found = {"is_file": files.is_file, "is_dir": files.is_directory, "exists": files.exists}[name](path)
    else:
        found = None
    if found is None or isinstance(found, bool):
        return UNKNOWN if found is None else found
    return [PurePosixPath(each) for each in dict.fromkeys(found)]


def call_named(name: str, given: Given, named: Named, files: Files) -> Value:
    """A function of a module, or a builtin."""
    if name in _PATHS:
        return _PATHS[name](*map(str, given)) if given and all(isinstance(each, (str, PurePosixPath)) for each in given) else UNKNOWN
    if name in ("os.path.abspath", "os.path.realpath") and given and isinstance(given[0], (str, PurePosixPath)):
        return os.path.normpath(os.path.join(files.root, str(given[0])))
    if name == "os.path.relpath" and given and all(isinstance(each, (str, PurePosixPath)) for each in given):
        path, start = (os.path.join(files.root, str(each)) for each in (*given, ".")[:2])
        return os.path.relpath(path, start)
    if name in ("os.getcwd", "pathlib.Path.cwd"):
        return files.root if name == "os.getcwd" else PurePosixPath(files.root)
    if name in _LOOKS and given and isinstance(given[0], (str, PurePosixPath)):
        seen = _LOOKS[name](files, str(given[0]))
        return UNKNOWN if seen is None else seen
    if name in ("glob.glob", "glob.iglob") and given and isinstance(given[0], str):
        found = None if "root_dir" in named else files.glob(given[0], recursive=named.get("recursive") is True)
        return UNKNOWN if found is None else found
    if name in ("pathlib.Path", "pathlib.PurePath", "pathlib.PosixPath"):
        return PurePosixPath(*map(str, given)) if all(isinstance(each, (str, PurePosixPath)) for each in given) else UNKNOWN
    if name == "collections.defaultdict":
        return defaultdict(list) if given == [Name("list")] else UNKNOWN
    if name in ("itertools.chain", "itertools.chain.from_iterable"):
        return _chained(items(given[0]) if name.endswith("iterable") and given else list(given))
    does = _BUILTINS.get(name)
    return UNKNOWN if does is None else does(given)


def _chained(parts: Sequence[Value] | None) -> Value:
    listed = [items(each) for each in parts or ()]
    return UNKNOWN if parts is None else [item for each in listed for item in ([UNKNOWN] if each is None else each)]


def _as_list(given: Given) -> Value:
    listed = items(given[0]) if given else []
    return [UNKNOWN] if listed is None else listed


def _sorted(given: Given) -> Value:
    listed = _as_list(given)
    return sorted(listed) if all(isinstance(each, str) for each in listed) else listed


def _zipped(given: Given) -> Value:
    listed = [items(each) for each in given]
    known = [each for each in listed if each is not None]
    return list(zip(*known, strict=False)) if len(known) == len(listed) else UNKNOWN


def _text(given: Given) -> Value:
    return str(given[0]) if given and isinstance(given[0], (str, int, PurePosixPath)) else UNKNOWN


def _enumerated(given: Given) -> Value:
    listed = items(given[0]) if given else None
    return UNKNOWN if listed is None else list(enumerate(listed))


def _length(given: Given) -> Value:
    listed = items(given[0]) if given else None
    return UNKNOWN if listed is None or UNKNOWN in listed else len(listed)


def _table(given: Given) -> Value:
    return dict(given[0]) if given and isinstance(given[0], dict) else {} if not given else UNKNOWN


_BUILTINS: Mapping[str, Callable[[Given], Value]] = {
    "list": _as_list,
    "tuple": lambda given: tuple(_as_list(given)),
    "set": lambda given: list(dict.fromkeys(map(_hashable, _as_list(given)))),
    "sorted": _sorted,
    "reversed": lambda given: _as_list(given)[::-1],
    "zip": _zipped,
    "enumerate": _enumerated,
    "str": _text,
    "os.fspath": _text,
    "len": _length,
    "dict": _table,
    "print": lambda given: None,
}
_PATHS: Mapping[str, Callable[..., Value]] = {
    "os.path.join": posixpath.join,
    "os.path.basename": lambda path: posixpath.basename(path),
    "os.path.dirname": lambda path: posixpath.dirname(path),
    "os.path.normpath": lambda path: posixpath.normpath(path),
    "os.path.splitext": lambda path: posixpath.splitext(path),
    "os.path.split": lambda path: posixpath.split(path),
    "os.path.isabs": lambda path: path.startswith("/"),
}
_LOOKS: Mapping[str, Callable[[Files, str], Value]] = {
    "os.path.isfile": Files.is_file,
    "os.path.isdir": Files.is_directory,
    "os.path.exists": Files.exists,
    "os.listdir": Files.listed,
    "os.walk": Files.walk,
}


def _hashable(value: Value) -> Value:
    return value if isinstance(value, (str, int, PurePosixPath)) else UNKNOWN
