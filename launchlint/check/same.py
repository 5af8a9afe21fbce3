"""A run of which nothing can be another than of an earlier one: what that told is told again, and no result is looked at.

That is so where every file that was met is as it was by what ``stat`` says of it (:mod:`launchlint.workspace.contents`), and so is all that
anything hung on of which that says nothing: what had changed a moment ago, and what is not met, in hidden directories and outside of the
workspaces.

Where some results are new, and say what those said that were there before, what is told of all of them is as it was, too, while all is as
it was that was looked at to tell it.
"""

from __future__ import annotations

import hashlib
from collections.abc import Iterable, Sequence
from contextlib import suppress
from typing import Any

from launchlint.check.cache import Cache, Hang
from launchlint.check.codec import outcome_from_json, outcome_to_json
from launchlint.check.groups import Groups
from launchlint.check.ignores import PerFileIgnores
from launchlint.check.merge import Outcome
from launchlint.check.options import EntryRequest, Options
from launchlint.check.rows import BROKEN, SEAL, sealed
from launchlint.workspace.looking import PART, QUESTION, Looked
from launchlint.workspace.states import Look

_RUN = "run"
"""The row of a run that may be the same: what it hangs on, and the seal of the row of what was told."""
_TELLING = "telling"
"""The row that joins what was kept of single results (:attr:`Groups.seal`), what was looked at to tell it, and what was told."""
_LOOKED = "looked"
_OUTCOME = "outcome"
_MOST_RECENT = 1_000
"""Files changed so recently that their content has to be looked at; where there are more, nothing is kept."""

TYPE_CHECKING = False
if TYPE_CHECKING:
    from launchlint.check.entry import EntryResult


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
        with suppress(*BROKEN):
            key, files, hang, outcome = self._row(_RUN)
            if key == self._key and files == self._cache.surroundings.all_files and self._is_true(*hang):
                return outcome_from_json(self._row(_OUTCOME, outcome))
        return None

    def told_again(self, groups: Groups, results: Sequence[EntryResult]) -> Outcome | None:
        """What was told, where the ``results`` of those that were unknown change nothing of it."""
        surroundings, states = self._cache.surroundings, self._cache.states
        with suppress(*BROKEN):
            key, seal, stamp, *seals = self._row(_TELLING)
            if (key, seal, stamp) != (self._key, groups.seal, surroundings.stamp) or not groups.say_the_same(results):
                return None
            looks, answers, unmet = self._row(_LOOKED, seals[0])
            if all(states.of(path) == known for path, known in (*looks, *answers)):
                outcome = outcome_from_json(self._row(_OUTCOME, seals[1]))
                self._cache.store(())  # what was answered meanwhile
                hangs = groups.keep_the_same(results)
                if hangs is not None:
                    self._keep(hangs, {*unmet, *surroundings.recent}, [question for question, _ in answers], groups, seals, {})
                return outcome
        return None

    def _row(self, name: str, seal: str = "") -> Any:
        """What is in a row, with this seal where one is given. Raises KeyError where there is none."""
        row = self._cache.rows("held", (name,))[name]
        if seal and row.seal != seal:
            raise KeyError(name)
        return row.value

    def _is_true(self, contents: Iterable[Look], variables: Iterable[tuple[str, str | None]], looks: Iterable[Look]) -> bool:
        cache = self._cache
        return (
            all(cache.variables.get(name) == text for name, text in variables)
            and all(cache.digest(path) == known for path, known in contents)
            and all(cache.states.of(path) == known for path, known in looks)
        )

    def keep(self, outcome: Outcome, hangs: Sequence[Hang], looked: Looked, groups: Groups) -> None:
        """Keep what is told now, from results that hang on ``hangs`` and are kept in ``groups``, and ``looked`` at besides."""
        if outcome.crashed:
            return
        cache = self._cache
        with suppress(*BROKEN):
            around = frozenset().union(looked.paths, *looked.wholes)
            answers = [(each.question, each.state) for each in looked.answers]
            unsaid = cache.parted((path, cache.states.of(path)) for path in sorted(around))[0]
            unmet = [path for path, _ in unsaid if not path.startswith(QUESTION) and not cache.surroundings.has_met(path)]
            told = sealed(_OUTCOME, outcome_to_json(outcome))
            rows = {_LOOKED: sealed(_LOOKED, [unsaid, answers, unmet]), _OUTCOME: told}
            if not cache.surroundings.are_as_met({path.partition(PART)[0] for path, _ in unsaid}):
                return  # something has changed while this was told
            seals = [rows[name][:SEAL] for name in (_LOOKED, _OUTCOME)]
            self._keep(hangs, around, [question for question, _ in answers], groups, seals, rows)

    def _keep(
        self,
        hangs: Sequence[Hang],
        around: Iterable[str],
        questions: Iterable[str],
        groups: Groups,
        seals: Sequence[str],
        rows: dict[str, str],
    ) -> None:
        rows[_TELLING] = sealed(_TELLING, [self._key, groups.seal, self._cache.surroundings.stamp, *seals])
        if len(self._cache.surroundings.recent) <= _MOST_RECENT:
            files, hang = self._cache.surroundings.all_files, self._elsewhere(hangs, around, questions)
            rows[_RUN] = sealed(_RUN, [self._key, files, hang, seals[-1]])
        self._cache.write({"held": rows}, {}, {})

    def _elsewhere(self, hangs: Sequence[Hang], around: Iterable[str], questions: Iterable[str]) -> list[Any]:
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
        looks = {path: cache.states.of(path) for path in sorted(around) if is_elsewhere(path)}
        for hang in hangs:
            variables.update(hang.variables)
            contents.update((path, known) for path, known in hang.dependencies if is_elsewhere(path))
        looks.update((path, known) for path, known in cache.looks_of(hangs, questions) if is_elsewhere(path))
        return [list(contents.items()), list(variables.items()), list(looks.items())]
