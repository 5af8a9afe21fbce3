"""What is known of a run when all entry files have been checked: what judges of its findings go by."""

from __future__ import annotations

import os
from collections.abc import Mapping, Set
from functools import cached_property

from launchlint.finding import Key
from launchlint.rules.view import EntrySummary
from launchlint.workspace.packages import Packages


class Known:
    """The packages, the directory that shown paths are relative to (``root``), and which entry files show what.

    ``reached``: by key of a finding the paths of the entry files that show it; a finding about a file alone is not among them.
    ``by_default``: the findings that some entry file shows as it is, without args. ``entries`` are the entry files.
    """

    def __init__(
        self, packages: Packages, root: str, reached: Mapping[Key, Set[str]], by_default: Set[Key], entries: tuple[EntrySummary, ...]
    ) -> None:
        self.packages = packages
        self.root = root
        self.reached = reached
        self.by_default = by_default
        self.entries = entries

    def file(self, path: str) -> str:
        """The absolute path of a shown one."""
        return os.path.abspath(os.path.join(self.root, path))

    @cached_property
    def included_by(self) -> Mapping[str, Set[str]]:
        """By path of a launch file the other entry files that lead there."""
        found: dict[str, set[str]] = {}
        for entry in self.entries:
            for path in entry.included:
                if path != entry.path:
                    found.setdefault(path, set()).add(entry.path)
        return found
