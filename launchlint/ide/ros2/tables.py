"""What launch's front ends let stand where, as completion asks it."""

from __future__ import annotations

from collections.abc import Iterator

from launchlint.syntax.ros2.tables import PARAMETER, PARAMETER_TYPES, TAGS, Attribute, Children, Conditions, Kind, Parameters, distribution

TYPE_CHECKING = False
if TYPE_CHECKING:
    from launchlint.syntax.ros2.tables import Read

_HOLD = ("launch", "group", "timer")


class TablesOfRos2:
    """Tags, attributes and values of launch's XML for one distribution."""

    def __init__(self, distro: str) -> None:
        self._known = distribution(distro)

    def tags(self, parent: str) -> Iterator[tuple[str, tuple[str, ...], bool]]:
        """As :meth:`launchlint.ide.tables.Tables.tags`."""
        if not parent:
            yield "launch", (), True
        elif parent in _HOLD:
            for name, tag in TAGS.items():
                if name in self._known.tags:
                    needed = tuple(each.name for each in tag.reads if isinstance(each, Attribute) and each.required)
                    yield name, needed, name in _HOLD
        for read in self._reads(parent):
            if isinstance(read, Children):
                yield read.name, tuple(each.name for each in read.reads if isinstance(each, Attribute) and each.required), False
            elif isinstance(read, Parameters):
                yield "param", ("name", "value"), False

    def _reads(self, tag: str) -> tuple[Read, ...]:
        known = TAGS.get(tag)
        if known is not None:
            return known.reads
        inner = (each for outer in TAGS.values() for each in outer.reads if isinstance(each, Children) and each.name == tag)
        return next((each.reads for each in inner), ())

    def attributes(self, tag: str, parent: str) -> Iterator[tuple[str, bool, str]]:
        """As :meth:`launchlint.ide.tables.Tables.attributes`."""
        if tag == "param":
            yield from ((name, False, "") for name in PARAMETER)
        outer = next((each for each in self._reads(parent) if isinstance(each, Children) and each.name == tag), None)
        for read in self._reads(tag) if outer is None else outer.reads:
            if isinstance(read, Attribute):
                yield read.name, read.required, read.kind.value
            elif isinstance(read, Conditions):
                yield "if", False, "true or false"
                yield "unless", False, "true or false"

    def values(self, tag: str, attribute: str) -> tuple[str, ...]:
        """As :meth:`launchlint.ide.tables.Tables.values`."""
        if (tag, attribute) == ("param", "type"):
            return PARAMETER_TYPES
        if attribute == "output":
            return ("screen", "log", "both", "own_log", "full")
        found = next((each for each in self._reads(tag) if isinstance(each, Attribute) and each.name == attribute), None)
        return ("true", "false") if found is not None and found.kind in (Kind.FLAG, Kind.FLAG_OR_TEXT) else ()


def commands(distro: str) -> tuple[str, ...]:
    """What may stand first in ``$(…)``."""
    return tuple(distribution(distro).substitutions)
