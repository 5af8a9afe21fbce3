"""Joining what several sources say of the same program, with all evidence kept.

What a person wrote (``manual``, and what has no evidence at all) wins over what was seen (``dynamic``), that over what was read from source
(``static``); of equals the one given first. Two entries are the same interface where their names are equal with every template at its
default: a manual ``{param:~topic|scan}`` is what a probe saw as ``scan``. Join all sources in one call: a join of joins knows no more which
field came from where.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence

from launchlint.errors import LibraryError
from launchlint.library.format import CATEGORIES, FORMAT, KINDS, LISTS
from launchlint.library.template import default_text, is_template
from launchlint.model import ROS1

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

MANUAL, DYNAMIC, STATIC = 3, 2, 1
TRUST = {"manual": MANUAL, "dynamic": DYNAMIC, "static": STATIC}
MOST_ALIKE = 100
"""Entries of one name that are compared with another source's."""
_WHETHER = ("condition", "each", "when", "exists")
"""Keys that say whether there is such a name at all: their absence says something, too."""


class Clash(Exception):
    """Two libraries cannot both be true; ``str(error)`` says why."""


def merge_files(paths: Sequence[str]) -> str:
    """The text of one library made of several files, of equals the last one first.

    Raises:
        LibraryError: one of them cannot be read or is not a library, or they cannot both be true.
    """
    from launchlint.library.file import parse, read
    from launchlint.library.write import canonical

    documents = [parse(read(path), path) for path in reversed(paths)]
    try:
        return canonical(merge_libraries(documents))
    except Clash as clash:
        raise LibraryError(f"{', '.join(paths)}: these libraries cannot be joined: {clash}") from None


def merge_libraries(documents: Sequence[Mapping[str, Any]]) -> dict[str, Any]:
    """One library of several (validated) ones, the most trusted first.

    Raises:
        Clash: they say different things of one message type: then types of the same name do not connect.
    """
    merged: dict[str, Any] = {
        "format": FORMAT,
        "version": max(document["version"] for document in documents),
        **_agreed(documents, ("generator", "environment")),
    }
    sources = {source["id"]: source for document in reversed(documents) for source in document.get("sources", ())}
    if sources:
        merged["sources"] = [sources[key] for key in sorted(sources)]
    messages: dict[str, Any] = {}
    for document in documents:
        for name, message in document.get("messages", {}).items():
            known = messages.setdefault(name, message)
            if "md5" in known and "md5" in message and known["md5"] != message["md5"]:
                raise Clash(f"they were made with different versions of the message {name} (MD5 {known['md5']} and {message['md5']})")
            messages[name] = {**message, **known}
    if messages:
        merged["messages"] = messages
    names = sorted({name for document in documents for name in document["packages"]})
    merged["packages"] = {
        name: _packages(name, [document["packages"][name] for document in documents if name in document["packages"]]) for name in names
    }
    return merged


def _agreed(documents: Sequence[Mapping[str, Any]], keys: Iterable[str]) -> dict[str, Any]:
    """The keys on which all agree."""
    first = documents[0]
    return {key: first[key] for key in keys if key in first and all(document.get(key) == first[key] for document in documents)}


def _packages(package: str, known: Sequence[Mapping[str, Any]]) -> dict[str, Any]:
    if len({each.get("middleware", ROS1) for each in known}) > 1:
        raise Clash(f"{package} is a package of ROS 1 in one and of ROS 2 in another, and a library has a package once: keep two files")
    merged = _first(known, ("middleware", "version", "source", "build", "launch"))
    complete = list(dict.fromkeys(table for each in known for table in each.get("complete", ())))
    if complete:
        merged["complete"] = complete
    for table in KINDS:
        names = sorted({name for each in known for name in each.get(table, {})})
        if names:
            merged[table] = {name: merge_programs([each[table][name] for each in known if name in each.get(table, {})]) for name in names}
    return merged


def merge_programs(known: Sequence[Mapping[str, Any]]) -> dict[str, Any]:
    """One executable, nodelet class or component of what several libraries say of it, the most trusted first.

    One that could not be run adds its problems only; a reference to another program (``like``) holds where nothing else is known.
    """
    usable = [each for each in known if each.get("status") != "failed" and "variants" in each]
    problems = _without_repeats(problem for each in known for problem in each.get("problems", ()))
    if not usable:
        merged = dict(next((each for key in ("like", "class") for each in known if _says(each, key)), known[0]))
    else:
        ranked = sorted(usable, key=lambda each: -max((_trust_of_variant(variant) for variant in each["variants"].values()), default=0))
        merged = _first(ranked, ("class", "status", "removed", "hash", "options"))
        names = sorted({name for each in usable for name in each["variants"]})
        merged["variants"] = {name: _variants([each["variants"][name] for each in ranked if name in each["variants"]]) for name in names}
    return {**merged, "problems": problems} if problems else merged


def _says(known: Mapping[str, Any], key: str) -> bool:
    """Whether something without variants is ``like`` another program, or is known to be no node."""
    return key in known if key == "like" else known.get(key) == "none"


def _trust_of_variant(variant: Mapping[str, Any]) -> int:
    """That of its best entry; one without entries is a person's word. Frames say nothing of who knows its names."""
    return max((_trust(entry) for category in CATEGORIES for entry in variant.get(category, ())), default=MANUAL)


def _trust(entry: Mapping[str, Any]) -> int:
    return max((TRUST[evidence["by"]] for evidence in entry.get("evidence", ())), default=MANUAL)


def _variants(known: Sequence[Mapping[str, Any]]) -> dict[str, Any]:
    if len(known) == 1:
        return dict(known[0])
    merged = _first(known, ("match", "args", "env", "remap", "run", "node", "namespace", "lifecycle", "managed", "undeclared"))
    for category in LISTS:
        if any(category in each for each in known):
            merged[category] = _entries([each.get(category, ()) for each in known])
    best = max(_trust_of_variant(each) for each in known)
    opened: dict[str, Any] = {}
    literals: dict[str, None] = {}
    for each in known:
        if _trust_of_variant(each) == best:
            opened = {**each.get("open", {}), **opened}
            literals.update(dict.fromkeys(each.get("literals", ())))
    if opened:
        merged["open"] = opened
    if literals:
        merged["literals"] = list(literals)
    return merged


def _entries(lists: Sequence[Sequence[Mapping[str, Any]]]) -> list[dict[str, Any]]:
    """One list of several. Entries of the same list stay apart: they may share a name under different conditions."""
    groups: dict[tuple[str, str, str], list[list[Mapping[str, Any]]]] = {}
    for entries in sorted(lists, key=lambda entries: -max(map(_trust, entries), default=0)):
        taken: set[int] = set()
        for entry in entries:
            key = (default_text(entry["name"]), entry.get("role", ""), entry.get("node", ""))
            known = groups.setdefault(key, [])
            free = [group for group in known[:MOST_ALIKE] if id(group) not in taken]
            group = max(free, key=lambda group: _alike(group[0], entry), default=None)
            if group is None:
                group = []
                known.append(group)
            group.append(entry)
            taken.add(id(group))
    return [_entry(group) for known in groups.values() for group in known]


def _alike(one: Mapping[str, Any], other: Mapping[str, Any]) -> int:
    """How likely two entries of one name are the same: above all by their conditions, then by their types."""
    return 2 * all(one.get(key) == other.get(key) for key in ("condition", "each")) + (one.get("type") == other.get("type"))


def _entry(group: Sequence[Mapping[str, Any]]) -> dict[str, Any]:
    """One entry of those that say the same of one name."""
    ranked = sorted(group, key=lambda entry: -_trust(entry))
    best = ranked[0]
    entry = _first(ranked, sorted({key for each in ranked for key in each} - {"evidence", "md5"}))
    if _trust(best) == MANUAL:
        entry = {key: value for key, value in entry.items() if key not in _WHETHER or key in best}
    else:
        entry["name"] = next((each["name"] for each in ranked if is_template(each["name"])), best["name"])
    if "qos" in entry:
        entry["qos"] = {policy: value for each in reversed(ranked) for policy, value in each.get("qos", {}).items()}
    md5 = next((each["md5"] for each in ranked if "md5" in each and each.get("type", entry.get("type")) == entry.get("type")), None)
    if md5 is not None:
        entry["md5"] = md5
    evidence = _without_repeats(one for each in ranked for one in each.get("evidence", ()))
    if evidence or any("evidence" in each for each in ranked):
        entry["evidence"] = evidence
    return entry


def _first(known: Sequence[Mapping[str, Any]], keys: Iterable[str]) -> dict[str, Any]:
    """Of each key the first value that there is."""
    return {key: next(each[key] for each in known if key in each) for key in keys if any(key in each for each in known)}


def _without_repeats(items: Iterable[Any]) -> list[Any]:
    found: list[Any] = []
    seen: set[str] = set()
    for item in items:
        key = repr(sorted(item.items()))
        if key not in seen:
            seen.add(key)
            found.append(item)
    return found
