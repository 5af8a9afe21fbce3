"""Entities of a launch file in YAML.

Nothing is converted: a value has the type that YAML gives it, and where launch wants another one it refuses the file.
"""

from __future__ import annotations

from launchlint.source import Origin, Place, Source
from launchlint.syntax.ros2.entity import Entity, Value
from launchlint.syntax.ros2.problems import WantsFraction, WantsText, WrongValue, YamlForm
from launchlint.syntax.ros2.values import SCALARS, fits
from launchlint.syntax.ros2.words import EXPECTED
from launchlint.syntax.ros2.written import InYaml, Written
from launchlint.syntax.ros2.yaml_data import Entry, Item

TYPE_CHECKING = False
if TYPE_CHECKING:
    from launchlint.problem import Problem
    from launchlint.source import Span
    from launchlint.syntax.ros2.problems import Shape

_CHILDREN = "children"


class YamlEntity(Entity):
    """What stands behind a key: ``key`` is where the key is written."""

    __slots__ = ("_all_read", "_entries", "_item", "_key", "_read", "_source")

    def __init__(self, tag: str, item: Item, key: Span, source: Source) -> None:
        self.tag = tag
        self._item = item
        self._key = key
        self._source = source
        self._entries: dict[str, Entry] = item.data if isinstance(item.data, dict) else {}
        self._read: set[str] = set()
        self._all_read = False

    def _at(self, span: Span) -> Place:
        return Place(self._source, span)

    @property
    def name_place(self) -> Place:
        """The key."""
        return self._at(self._key)

    @property
    def place(self) -> Place:
        """The key; what stands behind it as well, where that is in the same line."""
        whole = self._at(self._key._replace(end=max(self._key.end, self._item.span.end)))
        return self.name_place if "\n" in whole.text else whole

    @property
    def given(self) -> tuple[str, ...]:
        """The keys."""
        return tuple(self._entries)

    def shapeless(self) -> Problem | None:
        """Whether there are no keys to look for."""
        return None if isinstance(self._item.data, (dict, list)) else self._form("mapping", self._key)

    def attribute_place(self, name: str) -> Place:
        """The key of the attribute."""
        return self._at(self._entries[name].key)

    def has(self, name: str) -> bool:
        """Whether it is written."""
        return name in self._entries

    def value(self, name: str, wanted: str, problems: list[Problem]) -> Value | None:
        """The value behind a key; its type is looked at, and never changed."""
        entry = self._entries.get(name)
        if entry is None:
            return None
        self._read.add(name)
        item = entry.value
        data = item.data
        if isinstance(data, list):
            plain = [each.data for each in item_list(item) if isinstance(each.data, SCALARS)]
            if len(plain) == len(data) and fits(plain, wanted, texts=True):
                return Value(plain, self._at(item.span), None, tuple(self._written(each) for each in item_list(item)))
        elif isinstance(data, SCALARS) and fits(data, wanted, texts=True):
            written = self._written(item)
            return Value(data, self._at(item.span) if written is None else written.place, written)
        problems.append(self._misfit(name, item, entry, wanted))
        return self._meant(item, wanted)

    def _meant(self, item: Item, wanted: str) -> Value | None:
        """What stands there once the refused value is in quotes, or has its point: that is told, and nothing that would follow from it."""
        if isinstance(item.data, (bool, int, float)) and item.span.end > item.span.start:
            place = self._at(item.span)
            if wanted == "str":
                return Value(place.text, place, InYaml(place.text, self._source, item.span))
            if wanted == "float" and not isinstance(item.data, bool):
                return Value(float(item.data), place, None)
        return None

    def _misfit(self, name: str, item: Item, entry: Entry, wanted: str) -> Problem:
        place = self._at(item.span if item.span.end > item.span.start else entry.key)
        if wanted == "str" and isinstance(item.data, SCALARS):
            return WantsText(origin=Origin(place), refused=True, tag=self.tag, attribute=name, found=item.words)
        if wanted == "float" and isinstance(item.data, int) and not isinstance(item.data, bool):
            return WantsFraction(origin=Origin(place), refused=True, tag=self.tag, attribute=name, value=place.text)
        value = place.text if "\n" not in place.text else item.words
        return WrongValue(origin=Origin(place), refused=True, tag=self.tag, attribute=name, value=value, expected=EXPECTED[wanted])

    def _written(self, item: Item) -> Written | None:
        return InYaml(item.data, self._source, item.span) if isinstance(item.data, str) else None

    def named(self, name: str, problems: list[Problem]) -> list[Entity] | None:
        """The mappings in the list behind a key."""
        entry = self._entries.get(name)
        if entry is None:
            return None
        self._read.add(name)
        items = item_list(entry.value)
        if not items or not isinstance(items[0].data, dict):
            problems.append(self._form("entities", entry.key, name))
            return []
        found: list[Entity] = []
        for each in items:
            if isinstance(each.data, dict):
                first = next(iter(each.data.values()), None)
                found.append(YamlEntity(name, each, each.span if first is None else first.key, self._source))
            else:
                problems.append(self._form("entity", each.span, name))
        return found

    def children(self, problems: list[Problem]) -> list[Entity]:
        """The actions in the list, or in the one behind ``children``."""
        self._all_read = True
        item, span = self._item, self._key
        if isinstance(item.data, dict):
            if _CHILDREN not in self._entries:
                problems.append(self._form("children", self._key))
                return []
            self._read.add(_CHILDREN)
            entry = self._entries[_CHILDREN]
            item, span = entry.value, entry.key
        if not isinstance(item.data, list):
            problems.append(self._form("children", span))
            return []
        found: list[Entity] = []
        for each in item_list(item):
            if isinstance(each.data, dict) and len(each.data) == 1:
                ((tag, entry),) = each.data.items()
                found.append(YamlEntity(tag, entry.value, entry.key, self._source))
            else:
                second = list(each.data.values())[1].key if isinstance(each.data, dict) and each.data else each.span
                problems.append(self._form("one-action", second))
        return found

    def _form(self, shape: Shape, span: Span, attribute: str = "") -> Problem:
        return YamlForm(origin=Origin(self._at(span)), refused=True, tag=self.tag, attribute=attribute, shape=shape)

    def unread(self) -> tuple[list[Entity], list[str]]:
        """What nobody asked for."""
        if isinstance(self._item.data, list) and not self._all_read:
            return [self], []
        return [], [name for name in self._entries if name not in self._read]


def item_list(item: Item) -> list[Item]:
    """The items of a list; none of anything else."""
    return item.data if isinstance(item.data, list) else []
