"""What is known of a run when all entry files have been checked: what judges of its findings go by."""

from __future__ import annotations

import os
from collections.abc import Mapping, Set
from functools import cached_property

from launchlint.check.gathered import Shown
from launchlint.finding import Key
from launchlint.rules.view import EntrySummary
from launchlint.workspace.packages import Packages


class Known:
    """The packages, the directory that shown paths are relative to (``root``), and which entry files show what.

    ``reached``: by key of a finding the paths of the entry files that show it; a finding about a file alone is not among them.
    ``by_default``: the findings that some entry file shows as it is, without args. ``entries`` are the entry files.
    """

    def __init__(self, packages: Packages, root: str, shown: Mapping[Key, Shown], entries: tuple[EntrySummary, ...]) -> None:
        self.packages = packages
        self.root = root
        self.entries = entries
        self.reached: Mapping[Key, Set[str]] = {key: frozenset(each.entries) for key, each in shown.items()}
        self.by_default: Set[Key] = {key for key, each in shown.items() if each.by_default}
        self._files: dict[str, str] = {}

    def file(self, path: str) -> str:
        """The absolute path of a shown one."""
        known = self._files.get(path)
        if known is None:
            known = self._files[path] = os.path.abspath(os.path.join(self.root, path))
        return known

    @cached_property
    def included_by(self) -> Mapping[str, Set[str]]:
        """By path of a launch file the other entry files that lead there."""
        found: dict[str, set[str]] = {}
        for entry in self.entries:
            for path in entry.included:
                if path != entry.path:
                    found.setdefault(path, set()).add(entry.path)
        return found
