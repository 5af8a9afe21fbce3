"""What changed between two libraries: the interface of each node, evidence left aside."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import NamedTuple

from launchlint.library.format import CATEGORIES

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

_SINGULAR = {"publishers": "publisher", "subscribers": "subscriber", "services": "service", "clients": "service client",
             "actions": "action", "params": "param"}  # fmt: skip
_MISSING = object()


class Change(NamedTuple):
    """One change. ``kind`` is ``added``, ``removed`` or ``changed``; ``program`` is ``package/executable``; ``what`` the thing in words.

    ``before`` and ``after`` are JSON values, of what changed only; None where there is none.
    """

    kind: str
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
        for table, what in (("executables", "executable"), ("nodelets", "nodelet")):
            before, after = (each.get(package, {}).get(table, {}) for each in (old, new))
            for name in sorted({*before, *after}):
                program = f"{package}/{name}" if what == "executable" else name
                yield from _programs(program, what, before.get(name), after.get(name))


def _programs(program: str, what: str, old: Any, new: Any) -> Iterator[Change]:
    if old is None or new is None:
        yield Change("added" if old is None else "removed", program, "", what, program, None, None)
        return
    yield from _keys(program, "", what, program, old, new, {"class", "status", "like", "options"})
    before, after = old.get("variants", {}), new.get("variants", {})
    for variant in sorted({*before, *after}):
        if variant not in before or variant not in after:
            yield Change("added" if variant not in before else "removed", program, variant, "variant", variant, None, None)
            continue
        yield from _keys(program, variant, "variant", variant, before[variant], after[variant], {"match", "open"})
        for category in CATEGORIES:
            yield from _entries(program, variant, category, before[variant].get(category, ()), after[variant].get(category, ()))


def _entries(program: str, variant: str, category: str, old: Any, new: Any) -> Iterator[Change]:
    before, after = ({(entry["name"], entry.get("role", "")): entry for entry in entries} for entries in (old, new))
    for key in sorted({*before, *after}):
        what = f"{_SINGULAR[category]} {key[1]}".rstrip()
        if key not in before or key not in after:
            kind, entry = ("added", after[key]) if key not in before else ("removed", before[key])
            yield Change(kind, program, variant, what, key[0], None, entry.get("type"))
        else:
            yield from _keys(program, variant, what, key[0], before[key], after[key], {*before[key], *after[key]} - {"evidence"})


def _keys(program: str, variant: str, what: str, name: str, old: Any, new: Any, keys: set[str]) -> Iterator[Change]:
    differing = [key for key in sorted(keys) if old.get(key, _MISSING) != new.get(key, _MISSING)]
    if differing:
        before, after = ({key: each[key] for key in differing if key in each} for each in (old, new))
        yield Change("changed", program, variant, what, name, before, after)
