"""What changed between two libraries: the interface of each node, evidence left aside."""

from __future__ import annotations

import json
from collections.abc import Iterator, Mapping
from itertools import zip_longest

from launchlint.library.format import KINDS, LISTS
from launchlint.named_tuple import NamedTuple

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

_SINGULAR = {"publishers": "publisher", "subscribers": "subscriber", "services": "service", "clients": "service client",
             "actions": "action", "params": "param", "frames": "frame"}  # fmt: skip
_MISSING = object()


class Change(NamedTuple):
    """One change.

    Args:
        kind: ``added``, ``removed`` or ``changed``.
        package: the package.
        table: ``executables``, ``nodelets`` or ``components``.
        program: the executable, nodelet class or component.
        variant: the variant; empty where the program itself is what changed.
        what: what it is in words: ``executable``, ``variant``, ``publisher``, ``action server`` …
        name: its name.
        before: of an entry that went all there is to it, of something that changed the keys that did; else None.
        after: likewise.
    """

    kind: str
    package: str
    table: str
    program: str
    variant: str
    what: str
    name: str
    before: Any
    after: Any


def difference(old: Mapping[str, Any], new: Mapping[str, Any]) -> list[Change]:
    """The changes from one (validated) library to another, by package, program, variant, kind and name."""
    return list(_changes(old["packages"], new["packages"]))


def _changes(old: Mapping[str, Any], new: Mapping[str, Any]) -> Iterator[Change]:
    for package in sorted({*old, *new}):
        for table, what in KINDS.items():
            before, after = (each.get(package, {}).get(table, {}) for each in (old, new))
            for name in sorted({*before, *after}):
                yield from _programs(_Place(package, table, name), what, before.get(name), after.get(name))


class _Place(NamedTuple):
    """Where changes are."""

    package: str
    table: str
    program: str
    variant: str = ""


def _programs(place: _Place, what: str, old: Any, new: Any) -> Iterator[Change]:
    if old is None or new is None:
        yield Change("added" if old is None else "removed", *place, what, place.program, None, None)
        old, new = old or {}, new or {}
    else:
        yield from _keys(place, what, place.program, old, new, {"class", "status", "like", "options"})
    before, after = old.get("variants", {}), new.get("variants", {})
    for variant in sorted({*before, *after}):
        inner = place._replace(variant=variant)
        one, other = before.get(variant), after.get(variant)
        if one is not None and other is not None:
            yield from _keys(
                inner, "variant", variant, one, other, {"match", "open", "node", "namespace", "lifecycle", "managed", "undeclared"}
            )
        elif variant != "default":
            yield Change("added" if one is None else "removed", *inner, "variant", variant, None, None)
        for category in LISTS:
            yield from _entries(inner, _SINGULAR[category], (one or {}).get(category, ()), (other or {}).get(category, ()))


def _entries(place: _Place, what: str, old: Any, new: Any) -> Iterator[Change]:
    before, after = _by_name(old), _by_name(new)
    for name, role, node in sorted({*before, *after}):
        said = f"{what} {role}".rstrip()
        left, right = before.get((name, role, node), {}), after.get((name, role, node), {})
        gone = [left[text] for text in left if text not in right]
        come = [right[text] for text in right if text not in left]
        for one, other in zip_longest(gone, come):
            if one is not None and other is not None:
                yield from _keys(place, said, name, one, other, {*one, *other})
            else:
                yield Change("added" if one is None else "removed", *place, said, name, one, other)


def _by_name(entries: Any) -> dict[tuple[str, str, str], dict[str, Any]]:
    """The entries without their evidence, under their text; several of one name hold under different conditions."""
    found: dict[tuple[str, str, str], dict[str, Any]] = {}
    for entry in entries:
        plain = {key: value for key, value in entry.items() if key != "evidence"}
        found.setdefault((entry["name"], entry.get("role", ""), entry.get("node", "")), {})[_text(plain)] = plain
    return found


def _keys(place: _Place, what: str, name: str, old: Any, new: Any, keys: set[str]) -> Iterator[Change]:
    differing = [key for key in sorted(keys) if _text(old.get(key, _MISSING)) != _text(new.get(key, _MISSING))]
    if differing:
        before, after = ({key: each[key] for key in differing if key in each} for each in (old, new))
        yield Change("changed", *place, what, name, before, after)


def _text(value: Any) -> str:
    """A JSON value as text: for Python 1 and true are equal."""
    return "" if value is _MISSING else json.dumps(value, sort_keys=True)
