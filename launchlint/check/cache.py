"""Results of earlier runs, used again where nothing they depend on has changed.

What every result depends on (:mod:`.surroundings`) is in the name of the database. What one result depends on is checked for each: the
content of every file that was read, the value of every environment variable, what was there wherever a rule looked around, and the sources
of the programs that were asked for. All of that is looked at once, and before anything is computed, so that a result never says of itself
that it was made from something newer than it was.
"""

from __future__ import annotations

import hashlib
import os
from collections.abc import Callable, Iterable, Sequence
from contextlib import suppress
from typing import Any

from launchlint.check.codec import entry_from_json, entry_to_json, file_from_json, file_to_json, names_of
from launchlint.check.entry import EntryChecker, EntryResult
from launchlint.check.file import INTERNAL_ERROR, FileResult
from launchlint.check.in_order import ReadOnce
from launchlint.check.options import EntryRequest
from launchlint.check.own_code import own_code
from launchlint.check.rows import BROKEN, Rows, dump, forget_oldest, sealed
from launchlint.check.surroundings import Surroundings, user
from launchlint.workspace.contents import Contents
from launchlint.workspace.looking import PART, state
from launchlint.workspace.states import Look, Looks, States
from launchlint.workspace.text_parts import part_state

_CONTENTS_END = ".contents.json"


class Cache:
    """What is kept for one set of options and workspaces. Whatever goes wrong with it, the check goes on without."""

    def __init__(self, directory: str, checker: EntryChecker) -> None:
        held = remember(directory, checker)
        self._session = checker.session
        self._variables = checker.options.variables
        self._own = checker.own
        self._held = held
        self._states = checker.states = States(self._state)
        if self._own is not None:
            self._own.use(self._states)
        self._digests: dict[str, str] = {}
        self._programs: dict[tuple[str, ...], str] = {}
        self._shared: dict[str, bool] = {}
        self._files: dict[str, FileResult | None] = {}
        self._fetched: dict[str, dict[str, Any]] = {"files": {}, "shared": {}}
        self._surroundings = Surroundings(checker.options, checker.packages, held, held.version)
        name = self._surroundings.name
        self._rows = Rows(directory, None if name is None else f"{name}.sqlite")

    def look_up(self, requests: Sequence[EntryRequest]) -> list[EntryResult | None]:
        """For each request its result, where it is known and still true."""
        keys = [_key(request) if _is_plain(request) else "" for request in requests]
        values = dict(self._rows.values("entries", keys))
        self._fetch_for(values.values())
        fine_of = ReadOnce()
        return [self._look_up(request, values.get(key), fine_of) for request, key in zip(requests, keys, strict=True)]

    def _look_up(self, request: EntryRequest, value: Any, fine_of: ReadOnce) -> EntryResult | None:
        if value is None:
            return None
        try:
            dependencies, variables, looks, shared, programs, entry = value
            if any(self._variables.get(name) != text for name, text in variables):
                return None
            if any(self._digest(path) != known for path, known in dependencies) or not self._holds(looks, shared):
                return None
            if any(self._program(ware, package, table, name) != known for ware, package, table, name, known in programs):
                return None
            files = {name: file for name in names_of(entry) if (file := self._file(name)) is not None}
            return entry_from_json(entry, request, files, fine_of)
        except BROKEN:
            return None

    def _fetch_for(self, values: Iterable[Any]) -> None:
        """Fetch at once what these values of entries hang on."""
        entries = list(values)
        self._fetch("files", _gathered(entries, lambda value: names_of(value[5])))
        files = self._fetched["files"].values()
        self._fetch("shared", _gathered(entries, lambda value: value[3]) | _gathered(files, lambda value: value[2]))

    def _fetch(self, table: str, keys: Iterable[str]) -> None:
        fetched = self._fetched[table]
        asked = [key for key in keys if key not in fetched]
        found = dict(self._rows.values(table, asked))
        fetched.update((key, found.get(key)) for key in asked)

    def _row(self, table: str, key: str) -> Any:
        if key not in self._fetched[table]:
            self._fetch(table, (key,))
        return self._fetched[table][key]

    def _digest(self, path: str) -> str:
        """As that of what the session reads of a file, which is not read where it is the one that was read before."""
        known = self._digests.get(path)
        if known is None:
            known = self._digests[path] = self._held.sha1(path) or self._session.read(path).digest
        return known

    def _program(self, *program: str) -> str:
        """What is known of a program, as a digest; empty where that is nothing."""
        if program not in self._programs:
            ware, package, table, name = program
            self._programs[program] = "" if self._own is None else self._own.of(ware).digest((package, table, name))
        return self._programs[program]

    def _file(self, key: str) -> FileResult | None:
        """The result of one launch file, where it is known and still true."""
        if key not in self._files:
            self._files[key] = None
            value = self._row("files", key)
            if value is not None:
                known, looks, shared, told = value
                result = file_from_json(told)
                path = os.path.abspath(os.path.join(self._session.root, result.path))
                if self._digest(path) == known and self._holds(looks, shared):
                    self._files[key] = result
        return self._files[key]

    def _holds(self, looks: Iterable[Look], shared: Iterable[str]) -> bool:
        """Whether all is as it was, where one result looked around, and where it did together with others."""
        return all(map(self._shared_holds, shared)) and all(self._states.of(path) == known for path, known in looks)

    def _shared_holds(self, name: str) -> bool:
        if name not in self._shared:
            looks = self._row("shared", name)
            self._shared[name] = looks is not None and self._holds(looks, ())
        return self._shared[name]

    def _state(self, path: str) -> str:
        """What there is at a path; of a part of a text it takes time to find, and is known where the text was read before."""
        if PART not in path:
            known = self._surroundings.state(path)
            return state(path) if known is None else known
        file, _, part = path.partition(PART)
        try:
            return self._held.fact(file, f"part {part}", lambda data: part_state(data, part), str, str)
        except OSError:
            return state(path)

    def store(self, results: Iterable[EntryResult]) -> None:
        """Keep the results of this run."""
        if not self._rows.is_open:
            return
        entries: dict[str, str] = {}
        files: dict[str, str] = {}
        shared: dict[str, str] = {}

        def around(looks: Looks) -> tuple[list[Look], list[str]]:
            for each in looks.shared:
                if each.name not in shared:
                    shared[each.name] = sealed(each.name, self._unsaid(each.looks))
            return self._unsaid(looks.own), [each.name for each in looks.shared]

        try:
            for result in results:
                if not _is_plain(result.request) or _has_crashed(result):
                    continue
                digests = dict(result.dependencies)
                for file in result.files:
                    if file.key not in files:
                        content = digests[os.path.abspath(os.path.join(self._session.root, file.path))]
                        files[file.key] = sealed(file.key, [content, *around(file.looks), file_to_json(file)])
                value = [result.dependencies, result.variables, *around(result.looks), result.programs, entry_to_json(result)]
                key = _key(result.request)
                entries[key] = sealed(key, value)
        except BROKEN:
            return
        gone = [name for name, holds in self._shared.items() if not holds]
        self._rows.write({"shared": shared, "entries": entries, "files": files}, {"shared": gone})

    def _unsaid(self, looks: Iterable[Look]) -> list[Look]:
        """The looks of which the name of the database says nothing."""
        return [look for look in looks if not self._surroundings.say(*look)]

    def close(self) -> None:
        """Close the database."""
        self._rows.close()


def _gathered(values: Iterable[Any], names: Callable[[Any], Iterable[str]]) -> set[str]:
    """The ``names`` that stand in ``values``, as far as these are what was written."""
    found: set[str] = set()
    for value in values:
        with suppress(*BROKEN):
            found.update(names(value))
    return found


def _is_plain(request: EntryRequest) -> bool:
    """Whether the file is judged as what it is; text that stands in for another file is not kept."""
    return request.file == request.at


def _has_crashed(result: EntryResult) -> bool:
    findings = (*result.findings, *(guarded.finding for file in result.files for guarded in file.findings))
    return any(finding.rule == INTERNAL_ERROR for finding in findings)


def _key(request: EntryRequest) -> str:
    return dump([request.file, request.at, request.arguments, request.declared])


def remember(directory: str, checker: EntryChecker) -> Contents:
    """What the files of the workspaces hold, as far as an earlier run has kept it in ``directory``, for whatever ``checker`` looks at."""
    held = checker.packages.held
    if held is None:
        options = checker.options
        name = hashlib.sha1(dump([user(), options.workspaces]).encode(), usedforsecurity=False).hexdigest()
        file = os.path.join(directory, f"{name}{_CONTENTS_END}")
        if not os.path.exists(file):
            with suppress(OSError):
                forget_oldest(directory, _CONTENTS_END)
        held = checker.packages.held = Contents(file)
        held.begin(own_code(held))
    return held
