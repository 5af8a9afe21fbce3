"""Results of an earlier run taken as they are, a directory of entry files at a time, with what was told of each file that they show.

All that the entry files of one directory hang on is kept once for all of them: where it is as it was, none of them is looked at by itself.
What was told of a file is taken as it is, too, while no entry file shows anything else of it: only what a change concerns is read, and
gathered anew.

One row says which rows belong together, by their seals: where another run has written some of them since, none is taken.
"""

from __future__ import annotations

import hashlib
import os
from collections.abc import Collection, Iterable, Mapping, Sequence
from typing import Any

from launchlint.check.cache import Cache, Hang, key_of
from launchlint.check.codec import at_files_from_json, at_files_to_json, member_from_json, member_to_json
from launchlint.check.entry import EntryResult
from launchlint.check.gathered import AtFile, Member, Standing, files_shown, gathered
from launchlint.check.merge import is_part
from launchlint.check.options import EntryRequest
from launchlint.check.rows import BROKEN, SEAL, digest_of, dump, sealed
from launchlint.garbage import made_to_stay
from launchlint.workspace.states import Look

_TOGETHER = "whole"
"""The key of the row that says which rows belong together."""


class Groups:
    """What is kept of a run of ``requests``; ``asked`` are the paths that people gave."""

    def __init__(self, cache: Cache, requests: Sequence[EntryRequest], asked: tuple[str, ...]) -> None:
        self._cache = cache
        self._asked = hashlib.sha1(dump(asked).encode(), usedforsecurity=False).hexdigest()
        self._requests = {key_of(request): request for request in requests}
        self._keys: dict[str, list[str]] = {}
        for key, request in self._requests.items():
            self._keys.setdefault(_directory(request.file), []).append(key)
        self._fits = True
        self.forget()
        with made_to_stay():
            try:
                self._find()
            except BROKEN:
                self.forget()

    def forget(self) -> None:
        """What is kept is of no use."""
        self.seal = ""
        self._seals: dict[str, dict[str, str]] = {"groups": {}, "told": {}}
        self._parts: frozenset[str] = frozenset()
        self._written: dict[str, Any] = {}
        self._before: dict[str, Member] = {}
        self._told: dict[str, dict[str, AtFile]] = {}
        self._true: dict[str, Hang] = {}
        self._last: tuple[Any, dict[str, AtFile]] | None = None

    def _find(self) -> None:
        """Find what is kept, all of it or nothing, and what of it is true."""
        row = self._cache.rows("held", (_TOGETHER,)).get(_TOGETHER)
        if row is None:
            return
        asked, count, groups, told, parts = row.value
        if asked != self._asked:
            self._fits = len(self._requests) >= count  # else what is kept of more is worth more
            return
        found = self._cache.rows("groups", list(groups))
        if any(key not in found or found[key].seal != seal for key, seal in groups.items()):
            return
        self._cache.fetch_for("groups", found)
        self._seals = {"groups": groups, "told": told}
        self._parts = frozenset(parts)
        self._written = {member[0]: member for each in found.values() for member in each.value[-1]}
        for key, each in found.items():
            is_whole = {member[0] for member in each.value[-1]} == set(self._keys.get(key, ()))
            if is_whole and self._cache.is_true("groups", key, each):
                files_read, variables, looks, programs, _ = each.value
                self._true[key] = Hang(each.seal, files_read, variables, looks, programs, ())
        self.seal = row.seal

    def read(self) -> bool:
        """Read all of it; False where that cannot be done any more."""
        try:
            with made_to_stay():
                self._before = {key: member_from_json(each) for key, each in self._written.items()}
                return self._read_told(self._seals["told"])
        except BROKEN:
            return False

    def _read_told(self, directories: Iterable[str]) -> bool:
        """Read what was told of the files in ``directories``; False where another run has written that since."""
        seals = self._seals["told"]
        rows = self._cache.rows("told", [each for each in directories if each in seals and each not in self._told])
        self._told.update((key, at_files_from_json(row.value)) for key, row in rows.items() if row.seal == seals[key])
        return all(each in self._told for each in directories if each in seals)

    def say_the_same(self, results: Sequence[EntryResult]) -> bool:
        """Whether ``results``, of those that were unknown, say the same as before, and so do all of the files of which they show anything.

        Then all that is told is what was told, if that does not hang on anything else.
        """
        try:
            return self._written.keys() == self._requests.keys() and self._say_the_same(results)
        except BROKEN:
            return False

    def _say_the_same(self, results: Sequence[EntryResult]) -> bool:
        new = {key_of(result.request): result for result in results}
        now = {key: self._new(key, result) for key, result in new.items()}
        others = {key: member for key, member in now.items() if not member.seal or member.seal != self._written[key][1]}
        if not all(member.seal and _unsealed(member_to_json(member)) == _unsealed(self._written[key]) for key, member in others.items()):
            return False
        shown = frozenset(path for member in others.values() for path in member.shown)
        seals = {key: each[1] for key, each in self._written.items() if not shown.isdisjoint(each[2])}
        again = self._gathered(new, {**seals, **{key: member.seal for key, member in others.items()}}, shown, self._parts)
        if again is None or not self._read_told({_directory(path) for path in shown}):
            return False
        return all(again.get(path) == self._told.get(_directory(path), {}).get(path) for path in shown)

    def keep_the_same(self, results: Sequence[EntryResult]) -> list[Hang] | None:
        """As :meth:`keep`, where ``results`` say the same as before."""
        now = [self._new(key_of(result.request), result) for result in results]
        try:
            return self._keep(now, None, self._parts)
        except BROKEN:
            return None

    @property
    def unknown(self) -> list[EntryRequest]:
        """The requests of which it is not known that their results are as they were."""
        return [request for key, request in self._requests.items() if not self._holds(key, request)]

    def _holds(self, key: str, request: EntryRequest) -> bool:
        return key in self._written and _directory(request.file) in self._true

    def members(self, results: Iterable[EntryResult]) -> list[Member]:
        """What is needed of each request, in order, with the ``results`` of those that were unknown."""
        new = {key_of(result.request): result for result in results}
        found = []
        for key in self._requests:
            result = new.get(key)
            found.append(self._before[key] if result is None else self._member(key, result))
        return found

    def _member(self, key: str, result: EntryResult) -> Member:
        before, hang = self._before.get(key), self._cache.hang_of(key)
        if before is not None and hang is not None and before.seal == hang.seal:
            return before  # one that is as it was, beside others that are not
        return self._new(key, result)

    def _new(self, key: str, result: EntryResult) -> Member:
        hang = self._cache.hang_of(key)
        standing = Standing(result.path, result.outcome, result.sight)
        return Member(key, "" if hang is None else hang.seal, tuple(sorted(files_shown(result))), result.summary, standing)

    def files(self, results: Sequence[EntryResult], members: Sequence[Member], parts: frozenset[str]) -> dict[str, AtFile] | None:
        """What is told of each file, with the ``results`` of those that were unknown; None where too little is kept to tell."""
        concerned = self._concerned(members, parts)
        new = {key_of(result.request): result for result in results}
        showing = {member.key: member.seal for member in members if not concerned.isdisjoint(member.shown)}
        again = self._gathered(new, showing, concerned, parts)
        if again is None:
            return None
        told = {path: file for files in self._told.values() for path, file in files.items() if path not in concerned}
        return {**told, **again}

    def _gathered(
        self, new: Mapping[str, EntryResult], showing: Mapping[str, str], concerned: frozenset[str], parts: frozenset[str]
    ) -> dict[str, AtFile] | None:
        """What is told of ``concerned`` files, of which those entry files show anything that are ``showing``, with their seals."""
        asked = dict(showing), concerned, parts
        if self._last is not None and self._last[0] == asked:
            return self._last[1]
        more = self._cache.results({key: self._requests[key] for key in showing if key not in new}, showing)
        if more is None:
            return None
        several = [*more, *(new[key] for key in showing if key in new)]
        found = gathered(several, [each for each in several if not is_part(each.summary, parts)], concerned)
        self._last = asked, found
        return found

    def _concerned(self, members: Sequence[Member], parts: frozenset[str]) -> frozenset[str]:
        """The files of which something else may be told than before."""
        found: set[str] = set()
        now = {member.key: member for member in members}
        for key in now.keys() | self._before.keys():
            before, member = self._before.get(key), now.get(key)
            if before is not member or member is None or is_part(member.summary, parts) != is_part(member.summary, self._parts):
                found.update(path for each in (before, member) if each is not None for path in each.shown)
        return frozenset(found)

    def keep(self, members: Sequence[Member], files: Mapping[str, AtFile], parts: frozenset[str]) -> list[Hang] | None:
        """Keep all of it for the next run. Returns what it hangs on; None where not all is kept."""
        try:
            return self._keep(members, files, parts) if self._fits else None
        except BROKEN:
            return None

    def _keep(self, members: Sequence[Member], files: Mapping[str, AtFile] | None, parts: frozenset[str]) -> list[Hang] | None:
        """``files`` is None where what is told of them is as it was."""
        by_key = {member.key: member for member in members}
        groups: dict[str, str] = {}
        said: dict[str, tuple[Look, ...]] = {}
        hanging: list[Hang] = []
        for directory, keys in self._keys.items():
            if directory in self._true:  # none of these was unknown
                hanging.append(self._true[directory])
                continue
            several = [by_key[key] for key in keys]
            hangs = [self._cache.hang_of(each.key) for each in several]
            whole = [each for each in hangs if each is not None]
            if len(whole) < len(hangs):
                return None  # something of this run is not kept, so that the next one could not tell what has changed since
            together = _together(whole)
            hanging.append(together)
            groups[directory] = sealed(directory, [*together[1:-1], list(map(member_to_json, several))])
            said[directory] = together.said
        rows: dict[str, str] = {}
        seals = {"groups": _seals(self._keys, self._seals["groups"], groups), "told": self._seals["told"]}
        if files is not None:
            told = _by_directory(files)
            other = {directory: each for directory, each in told.items() if each != self._told.get(directory)}
            rows = {directory: sealed(directory, at_files_to_json(each)) for directory, each in other.items()}
            seals["told"] = _seals(told, self._seals["told"], rows)
        if groups or rows or seals != self._seals or parts != self._parts:
            whole_row = [self._asked, len(self._requests), seals["groups"], seals["told"], sorted(parts)]
            gone = {table: [key for key in self._seals[table] if key not in seals[table]] for table in seals}
            held = {_TOGETHER: sealed(_TOGETHER, whole_row)}
            self._cache.write({"groups": groups, "told": rows, "held": held}, said, gone)
            self.seal = held[_TOGETHER][:SEAL]
        return hanging


def _seals(keys: Collection[str], before: Mapping[str, str], rows: Mapping[str, str]) -> dict[str, str]:
    return {key: rows[key][:SEAL] if key in rows else before[key] for key in keys}


def _unsealed(member: Any) -> str:
    """What a member says, as :func:`member_to_json` gives it, whatever seal its result has."""
    return dump([member[0], *member[2:]])


def _directory(path: str) -> str:
    return os.path.dirname(path)


def _by_directory(files: Mapping[str, AtFile]) -> dict[str, dict[str, AtFile]]:
    found: dict[str, dict[str, AtFile]] = {}
    for path in sorted(files):
        found.setdefault(_directory(path), {})[path] = files[path]
    return found


def _together(hangs: Iterable[Hang]) -> Hang:
    """All that several results hang on, each once."""
    files: dict[str, str] = {}
    variables: dict[str, str | None] = {}
    looks: dict[str, str] = {}
    shared: dict[str, None] = {}
    answers: dict[str, str] = {}
    programs: dict[tuple[Any, ...], None] = {}
    said: dict[str, str] = {}
    for hang in hangs:
        files.update(hang.dependencies)
        variables.update(hang.variables)
        looks.update(hang.looks[0])
        shared.update(dict.fromkeys(hang.looks[1]))
        answers.update(hang.looks[2])
        programs.update(dict.fromkeys(map(tuple, hang.programs)))
        said.update(hang.said)
    around = [list(looks.items()), list(shared), list(answers.items()), digest_of(said.items())]
    return Hang("", list(files.items()), list(variables.items()), around, list(programs), tuple(said.items()))
