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
from contextlib import suppress
from typing import Any

from launchlint.check.cache import Cache, Hang, digest_of, key_of
from launchlint.check.codec import at_files_from_json, at_files_to_json, member_from_json, member_to_json
from launchlint.check.entry import EntryResult
from launchlint.check.gathered import AtFile, Member, Standing, files_shown, gathered
from launchlint.check.merge import is_part
from launchlint.check.options import EntryRequest
from launchlint.check.rows import BROKEN, SEAL, dump, sealed
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
        with made_to_stay(), suppress(*BROKEN):
            self._read()

    def forget(self) -> None:
        """What is kept is of no use."""
        self._seals: dict[str, dict[str, str]] = {"groups": {}, "told": {}}
        self._parts: frozenset[str] = frozenset()
        self._before: dict[str, Member] = {}
        self._told: dict[str, dict[str, AtFile]] = {}
        self._true: dict[str, Hang] = {}

    def _read(self) -> None:
        """Read what is kept, all of it or nothing."""
        row = self._cache.rows("held", (_TOGETHER,)).get(_TOGETHER)
        if row is None:
            return
        asked, count, groups, told, parts = row.value
        if asked != self._asked:
            self._fits = len(self._requests) >= count  # else what is kept of more is worth more
            return
        found = self._cache.rows("groups", list(groups))
        files = self._cache.rows("told", list(told))
        if any(key not in found or found[key].seal != seal for key, seal in groups.items()):
            return
        if any(key not in files or files[key].seal != seal for key, seal in told.items()):
            return
        self._cache.fetch_for("groups", found)
        members = {key: tuple(map(member_from_json, each.value[-1])) for key, each in found.items()}
        self._told = {key: at_files_from_json(each.value) for key, each in files.items()}
        self._seals = {"groups": groups, "told": told}
        self._parts = frozenset(parts)
        self._before = {member.key: member for several in members.values() for member in several}
        for key, each in found.items():
            is_whole = {member.key for member in members[key]} == set(self._keys.get(key, ()))
            if is_whole and self._cache.is_true("groups", key, each):
                files_read, variables, looks, programs, _ = each.value
                self._true[key] = Hang(each.seal, files_read, variables, looks, programs, ())

    @property
    def unknown(self) -> list[EntryRequest]:
        """The requests of which it is not known that their results are as they were."""
        return [request for key, request in self._requests.items() if not self._holds(key, request)]

    def _holds(self, key: str, request: EntryRequest) -> bool:
        return key in self._before and _directory(request.file) in self._true

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
        standing = Standing(result.path, result.outcome, result.sight)
        return Member(key, "" if hang is None else hang.seal, tuple(sorted(files_shown(result))), result.summary, standing)

    def files(self, results: Sequence[EntryResult], members: Sequence[Member], parts: frozenset[str]) -> dict[str, AtFile] | None:
        """What is told of each file, with the ``results`` of those that were unknown; None where too little is kept to tell."""
        concerned = self._concerned(members, parts)
        new = {key_of(result.request): result for result in results}
        showing = {member.key: member.seal for member in members if not concerned.isdisjoint(member.shown)}
        more = self._cache.results({key: self._requests[key] for key in showing if key not in new}, showing)
        if more is None:
            return None
        several = [*more, *(new[key] for key in showing if key in new)]
        again = gathered(several, [each for each in several if not is_part(each.summary, parts)], concerned)
        told = {path: file for files in self._told.values() for path, file in files.items() if path not in concerned}
        return {**told, **again}

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

    def _keep(self, members: Sequence[Member], files: Mapping[str, AtFile], parts: frozenset[str]) -> list[Hang] | None:
        by_key = {member.key: member for member in members}
        groups: dict[str, str] = {}
        said: dict[str, tuple[Look, ...]] = {}
        hanging: list[Hang] = []
        for directory, keys in self._keys.items():
            several = [by_key[key] for key in keys]
            if directory in self._true and all(self._before.get(each.key) is each for each in several):
                hanging.append(self._true[directory])
                continue
            hangs = [self._cache.hang_of(each.key) for each in several]
            whole = [each for each in hangs if each is not None]
            if len(whole) < len(hangs):
                return None  # something of this run is not kept, so that the next one could not tell what has changed since
            together = _together(whole)
            hanging.append(together)
            groups[directory] = sealed(directory, [*together[1:-1], list(map(member_to_json, several))])
            said[directory] = together.said
        told = _by_directory(files)
        other = {directory: each for directory, each in told.items() if each != self._told.get(directory)}
        rows = {directory: sealed(directory, at_files_to_json(each)) for directory, each in other.items()}
        seals = {
            "groups": _seals(self._keys, self._seals["groups"], groups),
            "told": _seals(told, self._seals["told"], rows),
        }
        if groups or rows or seals != self._seals or parts != self._parts:
            whole_row = [self._asked, len(self._requests), seals["groups"], seals["told"], sorted(parts)]
            gone = {table: [key for key in self._seals[table] if key not in seals[table]] for table in seals}
            held = {_TOGETHER: sealed(_TOGETHER, whole_row)}
            self._cache.write({"groups": groups, "told": rows, "held": held}, said, gone)
        return hanging


def _seals(keys: Collection[str], before: Mapping[str, str], rows: Mapping[str, str]) -> dict[str, str]:
    return {key: rows[key][:SEAL] if key in rows else before[key] for key in keys}


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
