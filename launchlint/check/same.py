"""A run of which nothing can be another than of an earlier one: what that told is told again, and no result is looked at.

That is so where every file that was met is as it was by what ``stat`` says of it (:mod:`launchlint.workspace.contents`), and so is all that
anything hung on of which that says nothing: what had changed a moment ago, and what is not met, in hidden directories and outside of the
workspaces.
"""

from __future__ import annotations

import hashlib
from collections.abc import Iterable, Sequence
from contextlib import suppress
from typing import Any

from launchlint.check.cache import Cache, Hang
from launchlint.check.codec import outcome_from_json, outcome_to_json
from launchlint.check.ignores import PerFileIgnores
from launchlint.check.merge import Outcome
from launchlint.check.options import EntryRequest, Options
from launchlint.check.rows import BROKEN, sealed
from launchlint.workspace.looking import PART, QUESTION, Looked
from launchlint.workspace.states import Look

_ROW = "outcome"
_MOST_RECENT = 1_000
"""Files changed so recently that their content has to be looked at; where there are more, nothing is kept."""


class SameRun:
    """What was told of a run of the same ``requests``."""

    def __init__(
        self, cache: Cache, requests: Sequence[EntryRequest], asked: tuple[str, ...], options: Options, per_file: PerFileIgnores
    ) -> None:
        self._cache = cache
        wanted = repr((requests, asked, sorted(options.severities.items()), per_file.written))
        self._key = hashlib.sha1(wanted.encode("utf-8", "surrogateescape"), usedforsecurity=False).hexdigest()

    def outcome(self) -> Outcome | None:
        """What was told, where it would be told again."""
        row = self._cache.rows("held", (_ROW,)).get(_ROW)
        with suppress(*BROKEN):
            if row is not None:
                key, files, hang, outcome = row.value
                if key == self._key and files == self._cache.surroundings.all_files and self._is_true(*hang):
                    return outcome_from_json(outcome)
        return None

    def _is_true(self, contents: Iterable[Look], variables: Iterable[tuple[str, str | None]], looks: Iterable[Look]) -> bool:
        cache = self._cache
        return (
            all(cache.variables.get(name) == text for name, text in variables)
            and all(cache.digest(path) == known for path, known in contents)
            and all(cache.states.of(path) == known for path, known in looks)
        )

    def keep(self, outcome: Outcome, hangs: Sequence[Hang], looked: Looked) -> None:
        """Keep what is told now, from results that hang on ``hangs``, and ``looked`` at besides."""
        if outcome.crashed or len(self._cache.surroundings.recent) > _MOST_RECENT:
            return
        with suppress(*BROKEN):
            files, hang = self._cache.surroundings.all_files, self._elsewhere(hangs, looked)
            self._cache.write({"held": {_ROW: sealed(_ROW, [self._key, files, hang, outcome_to_json(outcome)])}}, {}, {})

    def _elsewhere(self, hangs: Sequence[Hang], looked: Looked) -> list[Any]:
        """All that the files that were met do not tell, or not for certain since they are recent: contents, variables, looks."""
        cache, recent = self._cache, self._cache.surroundings.recent
        told: dict[str, bool] = {}

        def is_elsewhere(path: str) -> bool:
            known = told.get(path)
            if known is None:
                is_told = path.startswith(QUESTION) or (path.partition(PART)[0] not in recent and cache.surroundings.has_met(path))
                known = told[path] = not is_told
            return known

        contents: dict[str, str] = {}
        variables: dict[str, str | None] = {}
        around = frozenset().union(looked.paths, *looked.wholes)
        looks = {path: cache.states.of(path) for path in sorted(around) if is_elsewhere(path)}
        for hang in hangs:
            variables.update(hang.variables)
            contents.update((path, known) for path, known in hang.dependencies if is_elsewhere(path))
        looks.update((path, known) for path, known in cache.looks_of(hangs, looked.answers) if is_elsewhere(path))
        return [list(contents.items()), list(variables.items()), list(looks.items())]
