"""A nodelet that a program makes in its own process: its names are those of another node, and may be remapped by the program."""

from __future__ import annotations

from launchlint.extract.cpp.naming import ANY, NODE_NAME, finished
from launchlint.named_tuple import NamedTuple


class Instance(NamedTuple):
    """A nodelet that a program loads into itself: the full name it has, and what its names are remapped to, all unfinished."""

    name: str
    remappings: tuple[tuple[str, str], ...]

    def renamed(self, name: str) -> str:
        """A finished name of the nodelet as one of the program."""
        if self.name != NODE_NAME and "{param:~" in name:
            return ANY
        for before, after in self.remappings:
            target = finished(after)
            target = target[len("{remap:") : -1] if target.startswith("{remap:") and target.endswith("}") else target
            if name == before:
                return target
            for slot in ("{remap:", "{parent:"):
                if f"{slot}{before}}}" in name:
                    return name.replace(f"{slot}{before}}}", f"{slot}{target}}}") if "{" not in target else ANY
        if name.startswith("~") and self.name != NODE_NAME:
            return finished(f"{self.name}/{name[1:]}")
        return name
