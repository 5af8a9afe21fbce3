"""What roslaunch lets stand where: its metamodel, as completion asks it."""

from __future__ import annotations

from collections.abc import Iterator

from launchlint.syntax.ros1.dialect import TAGS, tag_for
from launchlint.syntax.ros1.substitutions import COMMANDS


class TablesOfRos1:
    """Tags, attributes and values of roslaunch's XML."""

    def tags(self, parent: str) -> Iterator[tuple[str, tuple[str, ...], bool]]:
        """As :meth:`launchlint.ide.tables.Tables.tags`."""
        rule = TAGS.get(parent)
        for name in ("launch",) if rule is None else rule.children:
            child = TAGS[name]
            if not child.status:
                needed = (*child.required, *(("value",) if name == "param" else ()))
                yield name, needed, bool(child.children) and name != "node" and name != "include"

    def attributes(self, tag: str, parent: str) -> Iterator[tuple[str, bool, str]]:
        """As :meth:`launchlint.ide.tables.Tables.attributes`."""
        rule = tag_for(tag, TAGS.get(parent))
        for each in () if rule is None else rule.attributes:
            if not each.status:
                yield each.name, each.required, each.domain.expected

    def values(self, tag: str, attribute: str) -> tuple[str, ...]:
        """As :meth:`launchlint.ide.tables.Tables.values`."""
        rule = TAGS.get(tag)
        found = None if rule is None else rule.attribute(attribute)
        return () if found is None else found.domain.choices


TABLES = TablesOfRos1()


def commands() -> tuple[str, ...]:
    """What may stand first in ``$(…)``."""
    return (*COMMANDS, "eval")
