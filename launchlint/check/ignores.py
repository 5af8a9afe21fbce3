"""Rules that are off for some files (``per-file-ignores``)."""

from __future__ import annotations

import os
from collections.abc import Mapping

NONE: frozenset[str] = frozenset()


class PerFileIgnores:
    """Which rules the configuration turns off for which files.

    ``rules`` maps patterns (:mod:`launchlint.workspace.patterns`), relative to ``directory``, to rule IDs. ``root`` is what the paths of
    findings are relative to.
    """

    __slots__ = ("_directory", "_known", "_root", "_rules")

    def __init__(self, rules: Mapping[str, tuple[str, ...]], directory: str, root: str) -> None:
        self._rules = rules
        self._directory = directory
        self._root = root
        self._known: dict[str, frozenset[str]] = {}

    @property
    def written(self) -> object:
        """Equal for equal settings."""
        return (sorted(self._rules.items()), self._directory, self._root)

    def off(self, path: str) -> frozenset[str]:
        """IDs of the rules that are off for the file that findings call ``path``."""
        if not self._rules:
            return NONE
        known = self._known.get(path)
        if known is None:
            from launchlint.workspace.patterns import matches

            inside = os.path.relpath(os.path.join(self._root, path), self._directory).replace(os.sep, "/")
            known = frozenset(rule for pattern, rules in self._rules.items() if matches(pattern, inside) for rule in rules)
            self._known[path] = known
        return known
