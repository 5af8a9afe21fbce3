"""A copy of a public program among the checked packages: what runs is the copy, what launchlint ships was said of the public version."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence

from launchlint.late import late
from launchlint.library.template import default_text, is_template
from launchlint.library.terms import CATEGORIES, FRAMES

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

Said = Mapping[str, "Any"]

DEFAULT = "default"
NOT_NAMED = {"text": "the sources that lie here do not have its name"}
"""The condition of what the public version has and the copy may have, too."""
ANY = "{any}"
_REMAPPED = late(r"\{remap:[^{}|]*\}[^{}]*")


def copy_first(own: Said, shipped: Sequence[Said], *, by_hand: bool) -> list[Said]:
    """What the sources of a copy say (``own``) and, behind it, what is left of the shipped entries: to be joined in this order.

    A category that the sources tell to its end is theirs alone. Of one that they leave open the shipped entries stay, with the types that
    the sources know; a name of them that no source has, neither in what was understood nor as a text, is uncertain. Where a person
    described the public version (``by_hand``), its names stand for those that the sources know in part. Where nothing but params is
    open, the ways in which the public version is started do not count either.
    """
    copy = _Copy(own.get("variants", {}).get(DEFAULT, {}))
    read_out = not copy.open - {"params"}
    rest: list[Said] = []
    for each in shipped:
        variants = each.get("variants", {})
        known = {name: copy.left(variant) for name, variant in variants.items() if name == DEFAULT or not read_out}
        rest.append({key: value for key, value in each.items() if key not in own} | {"variants": known})
    mine = copy.completed([variant for each in shipped for variant in each.get("variants", {}).values()])
    names = dict.fromkeys((DEFAULT, *(name for each in rest for name in each["variants"])))
    described = {name: [each["variants"][name] for each in rest if by_hand and name in each["variants"]] for name in names}
    return [{**own, "variants": {name: _without_parts(mine, described[name]) for name in names}}, *rest]


class _Copy:
    """What the sources of a copy say, and how far they were understood; ``open`` are the categories of which there may be more."""

    def __init__(self, variant: Said) -> None:
        self._variant = variant
        self.open = {
            each for each in CATEGORIES if each in variant.get("open", ()) or any(ANY in entry["name"] for entry in variant.get(each, ()))
        }
        self._types = {_key(each, entry): entry.get("type", "") for each in CATEGORIES for entry in variant.get(each, ())}
        self._ends = frozenset(_end(text) for text in variant.get("literals", ()))

    def left(self, variant: Said) -> dict[str, Any]:
        """What is left of a variant of the public version."""
        found: dict[str, Any] = {key: value for key, value in variant.items() if key not in (*CATEGORIES, "open")}
        if FRAMES in self._variant:
            found.pop(FRAMES, None)
        for category in self.open:
            if category in variant:
                found[category] = [self._doubted(category, entry) for entry in variant[category]]
        opened = {category: reason for category, reason in variant.get("open", {}).items() if category in self.open}
        return {**found, "open": opened} if opened else found

    def completed(self, variants: Iterable[Said]) -> dict[str, Any]:
        """What the sources say, with what the public version knows of the same names: types, and which part of a name is remapped."""
        known: dict[tuple[str, str, str], Said] = {}
        for variant in variants:
            for category in CATEGORIES:
                for entry in variant.get(category, ()):
                    known.setdefault(_key(category, entry), entry)
        found = dict(self._variant)
        for category in CATEGORIES:
            if category in found:
                found[category] = [_completed(entry, known.get(_key(category, entry))) for entry in found[category]]
        return found

    def _doubted(self, category: str, entry: Said) -> Said:
        type_ = self._types.get(_key(category, entry))
        if type_ is None:
            end = _end(default_text(entry["name"]))
            if not self._ends or end in self._ends or end.endswith("}"):
                return entry
            condition = entry.get("condition")
            return {**entry, "condition": NOT_NAMED if condition is None else {"all": [condition, NOT_NAMED]}}
        if type_ in ("", entry.get("type")):
            return entry
        return {**{key: value for key, value in entry.items() if key != "md5"}, "type": type_}


def _completed(entry: Said, other: Said | None) -> Said:
    if other is None:
        return entry
    found = dict(entry)
    if _REMAPPED.fullmatch(other["name"]) and not is_template(entry["name"]):
        found["name"] = other["name"]  # of a NodeHandle("camera"): a remapping of camera acts on all its names
    if not entry.get("type"):
        found.update({key: other[key] for key in ("type", "md5") if key in other})
    return found


def _without_parts(mine: Said, described: Sequence[Said]) -> Said:
    """``mine`` without names known in part, of the categories of which one of these has names, or says that there may be any more.

    Where one says that there may be more, names that the sources are not sure of say nothing else.
    """
    opened = {category for variant in described for category in variant.get("open", ())}
    told = opened | {category for variant in described for category in CATEGORIES if category in variant}
    return {key: [each for each in value if not _is_part(each, key in opened)] if key in told else value for key, value in mine.items()}


def _is_part(entry: Said, is_open: bool) -> bool:
    condition = entry.get("condition", {})
    unsure = "text" in condition or any("text" in each for each in condition.get("any", ()))
    return ANY in entry["name"] or (is_open and unsure)


def _key(category: str, entry: Said) -> tuple[str, str, str]:
    return category, default_text(entry["name"]), entry.get("role", "")


def _end(name: str) -> str:
    """The last part of a name: sources often put the parts of one together."""
    return name.rpartition("/")[2].lstrip("~")
