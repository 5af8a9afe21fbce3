"""What substitutions of nav2_common are replaced by: files that are written when they are performed, with other values or texts in them.

The files are written to no disk: the session keeps them, under names that nothing else has.
Source: ``nav2_common.launch`` (RewrittenYaml, ReplaceString, HasNodeParams, LaunchConfigAsBool).
"""

from __future__ import annotations

import copy
from collections.abc import Callable, Iterator
from typing import Any

from launchlint.evaluate.ros2.context import Value
from launchlint.evaluate.ros2.performing import Failure, Performer
from launchlint.evaluate.ros2.typed import load_file
from launchlint.model import Unknown
from launchlint.syntax.ros2.description import AS_BOOL, Substitution
from launchlint.yaml.refusals import YamlError
from launchlint.yaml.tree import YamlBeyond

_TRUE = ("true", "1", "yes", "on")
_DEEPEST = 60
_LONGEST = 1 << 20


class _NotKnown(Exception):
    """A word of the substitution is not known, or more than is worked out comes of it."""


def as_bool(performer: Performer, substitution: Substitution) -> Value:
    """``LaunchConfigAsBool(name)``: True or False."""
    return _given(performer, substitution, lambda words: "True" if words[0].strip().lower() in _TRUE else "False")


def replaced(performer: Performer, substitution: Substitution) -> Value:
    """``ReplaceString(source_file, replacements)``: words are the file, then each text with what is put in its place."""

    def make(words: list[str]) -> str:
        text = _read(performer, substitution, words[0])
        lines = text.splitlines(keepends=True)
        for name, value in zip(words[1::2], words[2::2], strict=False):
            if not name or text.count(name) * len(value) > _LONGEST:
                raise _NotKnown
            lines = [line.replace(name, value) for line in lines]
        return performer.session.write("".join(lines).encode("utf-8"))

    return _given(performer, substitution, make)


def has_params(performer: Performer, substitution: Substitution) -> Value:
    """``HasNodeParams(source_file, node_name)``: True or False."""

    def make(words: list[str]) -> str:
        data = _loaded(performer, substitution, words[0])
        return "True" if isinstance(data, dict) and words[1] in data else "False"

    return _given(performer, substitution, make)


def rewritten(performer: Performer, substitution: Substitution) -> Value:
    """``RewrittenYaml``: words are the file, the root key, whether types are converted; then kind, name and value of each rewrite."""

    def make(words: list[str]) -> str:
        from launchlint.evaluate.ros2.started import dumped

        file, root, converts, *rest = words
        data = copy.deepcopy(_loaded(performer, substitution, file))
        if not isinstance(data, dict):
            raise _NotKnown
        rewrites = list(zip(rest[::3], rest[1::3], rest[2::3], strict=False))
        of = {kind: {name: value for each, name, value in rewrites if each == kind} for kind in ("param", "key", "value")}
        _set_leaves(data, {name: _converted(value, converts == "True") for name, value in of["param"].items()}, 0)
        _set_paths(data, {name: _converted(value, converts == "True") for name, value in of["param"].items()})
        _rename(data, of["key"], 0)
        values = {name: _converted(value, converts == "True") for name, value in of["value"].items()}
        for key in list(data) if values else ():
            data[key] = _revalued(data[key], values, 0)
        return performer.session.write(dumped({root: data} if root else data).encode("utf-8"))

    return _given(performer, substitution, make)


def _given(performer: Performer, substitution: Substitution, make: Callable[[list[str]], str]) -> Value:
    words: list[str] = []
    for each in substitution.arguments:
        word = performer.perform(each)
        if isinstance(word, Unknown):
            return Unknown(substitution.place.text, word.reason)
        words.append(word)
    kept = performer.session.loaded
    key = "\0".join((substitution.name, *words))
    try:
        if key not in kept or substitution.name == AS_BOOL:
            kept[key] = make(words)
        made: str = kept[key]
        return made
    except (_NotKnown, RecursionError):
        return Unknown(substitution.place.text, "what is made of the file is not known")


def _read(performer: Performer, substitution: Substitution, file: str) -> str:
    read = performer.session.read(file)
    if read.data is None:
        from launchlint.evaluate.missing_file import missing_file  # only a file that is not there pays for it

        origin = performer.where(substitution.place)
        raise Failure(missing_file(performer.session, origin, "source_file", file, read.reason, environment=False, refused=True))
    performer.spend(len(read.data), substitution.place)
    return read.data.decode("utf-8", "replace")


def _loaded(performer: Performer, substitution: Substitution, file: str) -> Any:
    text = _read(performer, substitution, file)
    kept = performer.session.loaded.get(f"yaml {file}")
    if kept is None:
        try:
            kept = performer.session.loaded[f"yaml {file}"] = (load_file(text),)
        except (YamlError, YamlBeyond):
            raise _NotKnown from None
    return kept[0]


def _converted(value: str, converts: bool) -> Any:
    if converts and len(value) < 400:
        try:
            return float(value) if "." in value else int(value)
        except ValueError:
            pass
    return {"true": True, "false": False}.get(value.lower(), value)


def _set_leaves(data: dict[Any, Any], rewrites: dict[str, Any], depth: int) -> None:
    """Every key of a name gets its value, on all levels."""
    for key, child in list(data.items()):
        if isinstance(child, dict) and depth < _DEEPEST:
            _set_leaves(child, rewrites, depth + 1)
        if key in rewrites:
            data[key] = rewrites[key]


def _paths(data: Any, before: str, depth: int = 0) -> Iterator[str]:
    pairs = data.items() if isinstance(data, dict) else enumerate(data) if isinstance(data, list) else None
    if pairs is None or depth > _DEEPEST:
        yield before
        return
    for key, value in pairs:
        yield from _paths(value, f"{before}.{key}" if before else str(key), depth + 1)


def _set_paths(data: dict[Any, Any], rewrites: dict[str, Any]) -> None:
    """Whole paths get their values; those of params are made where they are not there."""
    dotted = {name: value for name, value in rewrites.items() if "." in name}
    if not dotted:
        return
    there = set(_paths(data, ""))
    for name, value in dotted.items():
        if name in there or "ros__parameters" in name.split("."):
            _set_path(data, name.split("."), value)


def _set_path(data: Any, keys: list[str], value: Any) -> None:
    for key in keys[:-1]:
        if isinstance(data, list):
            if not key.isdecimal() or int(key) >= len(data):
                raise _NotKnown
            data = data[int(key)]
        elif isinstance(data, dict):
            if not isinstance(data.get(key, {}), (dict, list)):
                raise _NotKnown
            data = data.setdefault(key, {})
        else:
            raise _NotKnown
    if isinstance(data, list):
        if not keys[-1].isdecimal() or int(keys[-1]) >= len(data):
            raise _NotKnown
        data[int(keys[-1])] = value
    else:
        data[keys[-1]] = value


def _rename(data: dict[Any, Any], names: dict[str, str], depth: int) -> None:
    if not names or depth > _DEEPEST:
        return
    for key in list(data):
        value = data[key]
        if key in names:
            data[names[key]] = data.pop(key)
        if isinstance(value, dict):
            _rename(value, names, depth + 1)


def _revalued(value: Any, values: dict[str, Any], depth: int) -> Any:
    if depth > _DEEPEST:
        raise _NotKnown
    if isinstance(value, dict):
        return {key: _revalued(each, values, depth + 1) for key, each in value.items()}
    if isinstance(value, list):
        return [_revalued(each, values, depth + 1) for each in value]
    return values.get(str(value), value)
