"""Joining what several sources say of the same program, with all evidence kept.

What a person wrote (``manual``) wins over what was seen (``dynamic``), that over what was read from source (``static``); of equals the one
given first. Two entries are the same interface where their names are equal with every template at its default: a manual
``{param:~topic|scan}`` is what a probe saw as ``scan``.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence

from launchlint.library.format import CATEGORIES, FORMAT, VERSION
from launchlint.library.template import default_text

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

_TRUST = {"manual": 3, "dynamic": 2, "static": 1}


class Clash(Exception):
    """Two libraries cannot both be true; ``str(error)`` says why."""


def merge_libraries(documents: Sequence[Mapping[str, Any]]) -> dict[str, Any]:
    """One library of several (validated) ones, the most trusted first.

    Raises:
        Clash: they say different things of one message type: then types of the same name do not connect.
    """
    merged: dict[str, Any] = {"format": FORMAT, "version": VERSION, **_agreed(documents, ("generator", "environment"))}
    sources = {source["id"]: source for document in reversed(documents) for source in document.get("sources", ())}
    if sources:
        merged["sources"] = [sources[key] for key in sorted(sources)]
    messages: dict[str, Any] = {}
    for document in documents:
        for name, message in document.get("messages", {}).items():
            known = messages.setdefault(name, message)
            if known.get("md5", "") != message.get("md5", "") and known.get("md5") and message.get("md5"):
                raise Clash(f"they were made with different versions of the message {name} (MD5 {known['md5']} and {message['md5']})")
    if messages:
        merged["messages"] = messages
    names = sorted({name for document in documents for name in document["packages"]})
    merged["packages"] = {
        name: _packages([document["packages"][name] for document in documents if name in document["packages"]]) for name in names
    }
    return merged


def _agreed(documents: Sequence[Mapping[str, Any]], keys: Iterable[str]) -> dict[str, Any]:
    """The keys on which all agree."""
    first = documents[0]
    return {key: first[key] for key in keys if key in first and all(document.get(key) == first[key] for document in documents)}


def _packages(known: Sequence[Mapping[str, Any]]) -> dict[str, Any]:
    merged = _first(known, ("version", "source", "build", "launch"))
    complete = sorted({table for each in known for table in each.get("complete", ())})
    if complete:
        merged["complete"] = complete
    for table in ("executables", "nodelets"):
        names = sorted({name for each in known for name in each.get(table, {})})
        if names:
            merged[table] = {name: merge_programs([each[table][name] for each in known if name in each.get(table, {})]) for name in names}
    return merged


def merge_programs(known: Sequence[Mapping[str, Any]]) -> dict[str, Any]:
    """One executable or nodelet class of what several libraries say of it, the most trusted first.

    One that could not be run adds its problems only; a reference to another program (``like``) holds where nothing else is known.
    """
    usable = [each for each in known if each.get("status") != "failed" and "variants" in each]
    if not usable:
        return dict(next((each for each in known if "like" in each), known[0]))
    ranked = sorted(usable, key=lambda each: -max((_trust_of_variant(variant) for variant in each["variants"].values()), default=0))
    merged = _first(ranked, ("class", "hash", "options"))
    problems = [problem for each in known for problem in each.get("problems", ())]
    if problems:
        merged["problems"] = _without_repeats(problems)
    names = sorted({name for each in usable for name in each["variants"]})
    merged["variants"] = {
        name: _variants([each["variants"][name] for each in ranked if name in each["variants"]]) for name in names
    }  # fmt: skip
    return merged


def _trust_of_variant(variant: Mapping[str, Any]) -> int:
    return max((_trust(entry) for category in CATEGORIES for entry in variant.get(category, ())), default=0)


def _trust(entry: Mapping[str, Any]) -> int:
    return max((_TRUST[evidence["by"]] for evidence in entry.get("evidence", ())), default=0)


def _variants(known: Sequence[Mapping[str, Any]]) -> dict[str, Any]:
    if len(known) == 1:
        return dict(known[0])
    merged = _first(known, ("match", "args", "params", "env", "remap", "run"))
    for category in CATEGORIES:
        entries = _entries([entry for each in known for entry in each.get(category, ())])
        if entries:
            merged[category] = entries
    best = max(_trust_of_variant(each) for each in known)
    opened: dict[str, Any] = {}
    for each in known:
        if _trust_of_variant(each) == best:
            opened = {**each.get("open", {}), **opened}
    if opened:
        merged["open"] = opened
    return merged


def _entries(entries: Sequence[Mapping[str, Any]]) -> list[dict[str, Any]]:
    groups: dict[tuple[str, str], list[Mapping[str, Any]]] = {}
    for entry in entries:
        groups.setdefault((default_text(entry["name"]), entry.get("role", "")), []).append(entry)
    merged = []
    for group in groups.values():
        ranked = sorted(group, key=lambda entry: -_trust(entry))
        entry = _first(ranked, sorted({key for each in ranked for key in each} - {"evidence", "md5"}))
        md5 = next((each["md5"] for each in ranked if "md5" in each and each.get("type", entry.get("type")) == entry.get("type")), None)
        if md5 is not None:
            entry["md5"] = md5
        evidence = _without_repeats([one for each in ranked for one in each.get("evidence", ())])
        if evidence:
            entry["evidence"] = evidence
        merged.append(entry)
    return merged


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
