"""Results of earlier runs, used again where nothing they depend on has changed.

What every result depends on is in the name of the database (:mod:`.surroundings`). What one result depends on is checked for each: the
content of every file that was read, the value of every environment variable, what was there wherever something looked around, what packages
answered, and the sources of the programs that were asked for. All of that is looked at once, and before anything is computed, so that a
result never says of itself that it was made from something newer than it was.

Most of where results look is in the workspaces, whose stamp says that nothing there has changed: then only what the stamp does not say is
looked at, and of the rest no more is read than that it held when the workspaces had this stamp.
"""

from __future__ import annotations

import hashlib
import os
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from contextlib import suppress
from typing import Any

from launchlint.check.answers import KeptAnswer, answers_from_json, answers_to_json
from launchlint.check.codec import entry_from_json, entry_to_json, file_from_json, file_to_json, names_of
from launchlint.check.entry import EntryChecker, EntryResult
from launchlint.check.file import INTERNAL_ERROR, FileResult
from launchlint.check.in_order import ReadOnce
from launchlint.check.options import EntryRequest
from launchlint.check.own_code import own_code
from launchlint.check.rows import BROKEN, SEAL, Row, Rows, digest_of, dump, forget_oldest, sealed, states_digest, with_digest
from launchlint.check.surroundings import Surroundings, user
from launchlint.named_tuple import NamedTuple
from launchlint.workspace.contents import Contents
from launchlint.workspace.looking import PART, QUESTION, Answer, Looked, state
from launchlint.workspace.questions import answer
from launchlint.workspace.states import Answered, Look, Looks, Shared, States
from launchlint.workspace.text_parts import known_state

_CONTENTS_END = ".contents.json"
_LOOKS = 2
"""Where a row of results has its looks: behind files and variables, before programs and the result."""
_HELD = "rows"
_HOLDING = ("entries", "files", "shared", "groups")
"""Tables of rows of which the stamp of the workspaces may tell."""
_ANSWERS = "answers"
_ALL = "all"
_PROGRAMS = "programs"

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import TypeVar

    from launchlint.knowledge.own import OwnSources
    from launchlint.knowledge.programs import Digest

    Made = TypeVar("Made")


class Hang(NamedTuple):
    """What the row of a result hangs on that has this ``seal``, as it is written; ``said``: what the stamp of the workspaces tells."""

    seal: str
    dependencies: Any
    variables: Any
    looks: Any
    programs: Any
    said: tuple[Look, ...]


class Cache:
    """What is kept for one set of options and workspaces. Whatever goes wrong with it, the check goes on without."""

    def __init__(self, directory: str, checker: EntryChecker) -> None:
        held = remember(directory, checker)
        self._session = checker.session
        self.variables = checker.options.variables
        self._own = checker.own
        self._held = held
        self.states = checker.states = States(self._state, self._kept_answer)
        if self._own is not None:
            self._own.use(self.states)
        self._digests: dict[str, str] = {}
        self._programs: dict[tuple[str, ...], str] = {}
        self._shared: dict[str, bool] = {}
        self._files: dict[str, FileResult | None] = {}
        self._fetched: dict[str, dict[str, Row | None]] = {"files": {}, "shared": {}, "said": {}}
        self._packages = checker.packages
        self.surroundings = Surroundings(checker.options, checker.packages, held, held.version)
        name = self.surroundings.name
        self._rows = Rows(directory, None if name is None else f"{name}.sqlite")
        self._held_before = frozenset(self._at_stamp(_HELD, str).split())  # the seals of the rows that held
        self._answers = self._read_answers()
        self._by_stamp: dict[str, str] = self._at_stamp(_ALL, dict)
        self._kept_programs: dict[str, dict[str, Digest]] | None = None
        self._holding: set[str] = set()
        self._held_written = self._held_before
        self._true: dict[str, Row] = {}
        self._given: dict[str, KeptAnswer] = {}
        self._given_written: dict[str, KeptAnswer] = {}
        self._paths: dict[str, frozenset[str] | None] = {}
        self._shared_now: dict[str, list[Look]] = {}
        self._stored: dict[str, Hang] = {}

    def look_up(self, requests: Sequence[EntryRequest]) -> list[EntryResult | None]:
        """For each request its result, where it is known and still true."""
        keys = [key_of(request) if is_plain(request) else "" for request in requests]
        rows = dict(self._rows.values("entries", keys))
        self.fetch_for("entries", rows)
        fine_of = ReadOnce()
        return [self._look_up(request, key, rows.get(key), fine_of) for request, key in zip(requests, keys, strict=True)]

    def _look_up(self, request: EntryRequest, key: str, row: Row | None, fine_of: ReadOnce) -> EntryResult | None:
        if row is None or not self.is_true("entries", key, row):
            return None
        result = self._result(request, row, fine_of)
        if result is not None:
            self._true[key] = row
        return result

    def is_true(self, table: str, key: str, row: Row) -> bool:
        """Whether all is as it was, on which a row of results hangs."""
        try:
            dependencies, variables, looks, programs, _ = row.value
            return (
                all(self.variables.get(name) == text for name, text in variables)
                and all(self.digest(path) == known for path, known in dependencies)
                and self._holds(table, key, row, *looks)
                and all(self._program(ware, package, table, name) == known for ware, package, table, name, known in programs)
            )
        except BROKEN:
            return False

    def results(self, requests: Mapping[str, EntryRequest], seals: Mapping[str, str]) -> list[EntryResult] | None:
        """What is kept of ``requests``, by their keys, of which it is known that all is true that has these ``seals``; else None."""
        rows = dict(self._rows.values("entries", list(requests)))
        if any(key not in rows or rows[key].seal != seals[key] for key in requests):
            return None
        self._fetch("files", _gathered(rows.values(), lambda value: names_of(value[-1])))
        fine_of = ReadOnce()
        found = [self._result(request, rows[key], fine_of) for key, request in requests.items()]
        return None if None in found else [each for each in found if each is not None]

    def _result(self, request: EntryRequest, row: Row, fine_of: ReadOnce) -> EntryResult | None:
        """What is in a row, and in those of the files of which it is made, where these are true."""
        try:
            entry = row.value[-1]
            files = {name: file for name in names_of(entry) if (file := self._file(name)) is not None}
            return entry_from_json(entry, request, files, fine_of)
        except BROKEN:
            return None

    def fetch_for(self, table: str, rows: Mapping[str, Row]) -> None:
        """Fetch at once what these rows of results hang on."""
        if table == "entries":
            self._fetch("files", _gathered(rows.values(), lambda value: names_of(value[-1])))
        files = self._fetched["files"]
        names = _gathered(rows.values(), lambda value: value[_LOOKS][1]) | _gathered(files.values(), lambda value: value[1][1])
        self._fetch("shared", names.union(*(each.names for each in self._answers.values())))
        tables = {table: rows, "files": files, "shared": self._fetched["shared"]}
        self._fetch("said", [_of(table, key) for table, known in tables.items() for key, row in known.items() if self._is_to_ask(row)])

    def _is_to_ask(self, row: Row | None) -> bool:
        """Whether it has to be asked what the stamp of the workspaces says of other rows."""
        return row is not None and row.seal not in self._held_before

    def _fetch(self, table: str, keys: Iterable[str]) -> None:
        fetched = self._fetched[table]
        asked = [key for key in keys if key not in fetched]
        found = dict(self._rows.values(table, asked))
        fetched.update((key, found.get(key)) for key in asked)

    def _row(self, table: str, key: str) -> Row | None:
        if key not in self._fetched[table]:
            self._fetch(table, (key,))
        return self._fetched[table][key]

    def _program(self, *program: str) -> str:
        """What is known of a program, as a digest; empty where that is nothing."""
        if program not in self._programs:
            ware, package, table, name = program
            if self._own is not None and self._kept_programs is None:
                self._kept_programs = self._read_programs(self._own)
            self._programs[program] = "" if self._own is None else self._own.of(ware).digest((package, table, name))
        return self._programs[program]

    def hang_of(self, key: str) -> Hang | None:
        """What the result of an entry file hangs on that was looked up, or stored, in this run; None where it is not kept."""
        row = self._true.get(key)
        if row is None:
            return self._stored.get(key)
        said = self._row("said", _of("entries", key))
        try:
            files, variables, looks, programs, _ = row.value
            if said is None or said.value[0] != looks[-1]:
                return None
            return Hang(row.seal, files, variables, looks, programs, tuple((path, self.states.of(path)) for path in said.value[1]))
        except BROKEN:
            return None

    def looks_of(self, hangs: Iterable[Hang], asked: Iterable[str]) -> Iterator[Look]:
        """All looks that rows of results hang on, and the kept answers to what was ``asked``; but those that the stamp tells of."""
        names: set[str] = set()
        questions = set(asked)
        programs: set[tuple[str, ...]] = set()
        for hang in hangs:
            yield from hang.looks[0]
            names.update(hang.looks[1])
            questions.update(question for question, _ in hang.looks[2])
            programs.update(tuple(each[:4]) for each in hang.programs)
        for question in questions:
            names.update((self._given.get(question) or self._answers[question]).names)
        for name in names:
            row = self._row("shared", name)
            yield from self._shared_now[name] if name in self._shared_now or row is None else row.value
        for ware, package, table, name in programs:
            if self._own is not None:
                yield from self._own.of(ware).looked((package, table, name))

    def digest(self, path: str) -> str:
        """As that of what the session reads of a file, which is not read where it is the one that was read before."""
        known = self._digests.get(path)
        if known is None:
            known = self._digests[path] = self._held.sha1(path) or self._session.read(path).digest
        return known

    def _file(self, key: str) -> FileResult | None:
        """The result of one launch file, where it is known and still true."""
        if key not in self._files:
            self._files[key] = None
            row = self._row("files", key)
            if row is not None:
                known, looks, told = row.value
                result = file_from_json(told)
                path = os.path.abspath(os.path.join(self._session.root, result.path))
                if self.digest(path) == known and self._holds("files", key, row, *looks):
                    self._files[key] = result
        return self._files[key]

    def _holds(
        self, table: str, key: str, row: Row, looks: Iterable[Look], shared: Iterable[str], answers: Iterable[Look], told: str
    ) -> bool:
        """Whether all is as it was, where one result looked around, and where it did together with others, and so are all answers.

        ``told``: the digest of what the stamp tells of, where the row has it: what is kept of that may be of another moment.
        """
        if not all(map(self._shared_holds, shared)):
            return False
        if any(self.states.of(path) != known for several in (looks, answers) for path, known in several):
            return False
        if self._is_to_ask(row):
            said = self._row("said", _of(table, key))
            if said is None or said.value[0] != states_digest(said.value[1], self.states) or said.value[0] != (told or said.value[0]):
                return False
        self._holding.add(row.seal)
        return True

    def _shared_holds(self, name: str) -> bool:
        if name not in self._shared:
            row = self._row("shared", name)
            self._shared[name] = row is not None and self._holds("shared", name, row, row.value, (), (), "")
        return self._shared[name]

    def _read_answers(self) -> dict[str, KeptAnswer]:
        """The answers that were given, by question."""
        for _, row in self._rows.values("held", (_ANSWERS,)):
            with suppress(*BROKEN):
                return answers_from_json(row.value)
        return {}

    def _answer(self, question: str) -> str:
        """The state of an answer: as it was given, where all that it hangs on is as it was; else as it is given now."""
        known = self._kept_answer(question) or self._by_stamp.get(question)
        if known is None:
            known = answer(self._packages, question)
            if question.split(" ")[1:2] == [_ALL]:
                self._by_stamp[question] = known
        return known

    def _kept_answer(self, question: str) -> str | None:
        """The state of an answer that was given, where all that it hangs on is as it was."""
        known = self._answers.get(question)
        return known.state if known is not None and all(map(self._shared_holds, known.names)) else None

    def kept_answer(self, question: str, anew: Callable[[], Looked]) -> Answer | None:
        """What was answered, where that is kept and all that it hangs on is as it was; ``anew`` tells that where it cannot be read."""
        known = self._answers.get(question)
        if known is None or not known.has_found or self._kept_answer(question) is None:
            return None
        try:
            answer = Answer(question, known.found, lambda: self._looked(known) or anew())
        except BROKEN:
            return None
        return answer if answer.state == known.state else None

    def _looked(self, known: KeptAnswer) -> Looked | None:
        """All that a kept answer hangs on; None where somebody has written that anew since."""
        several = [paths for name in known.names if (paths := self._shared_paths(name)) is not None]
        return Looked(frozenset(), tuple(several)) if len(several) == len(known.names) else None

    def _shared_paths(self, name: str) -> frozenset[str] | None:
        if name not in self._paths:
            unsaid, said = self._row("shared", name), self._row("said", _of("shared", name))
            self._paths[name] = None
            with suppress(*BROKEN):
                if unsaid is not None and said is not None:
                    self._paths[name] = frozenset((*(path for path, _ in unsaid.value), *said.value[1]))
        return self._paths[name]

    def _read_programs(self, own: OwnSources) -> dict[str, dict[str, Digest]]:
        """The digests of programs that an earlier run has kept, which are taken."""
        from launchlint.knowledge.programs import Digest

        found: dict[str, dict[str, Digest]] = {}
        for _, row in self._rows.values("held", (_PROGRAMS,)):
            with suppress(*BROKEN):
                for ware, digests in row.value.items():
                    read = {
                        name: Digest(digest, tuple((path, known) for path, known in looks)) for name, (digest, looks) in digests.items()
                    }
                    own.of(ware).remember(read)
                    found[ware] = read
        return found

    def _now_known(self) -> dict[str, str]:
        """The row of all digests of programs that were asked for, where they are others."""
        if self._own is None or self._kept_programs is None:
            return {}
        known = {each.middleware: each.digests for each in self._own.all if each.digests}
        return {} if known == self._kept_programs else {_PROGRAMS: sealed(_PROGRAMS, known)}

    def _at_stamp(self, key: str, kind: type[Made]) -> Made:
        """What is held under ``key``, of this kind, if it was when the workspaces had this stamp; else an empty one."""
        for _, row in self._rows.values("held", (key,)):
            with suppress(*BROKEN):
                stamp, value = row.value
                if stamp == self.surroundings.stamp and isinstance(value, kind):
                    return value
        return kind()

    def _state(self, path: str) -> str:
        """What there is at a path; of a part of a text it takes time to find, and is known where the text was read before."""
        if path.startswith(QUESTION):
            return self._answer(path)
        if PART not in path:
            known = self.surroundings.state(path)
            return state(path) if known is None else known
        file, _, part = path.partition(PART)
        try:
            return known_state(file, part, self._held)
        except OSError:
            return state(path)

    def store(self, results: Iterable[EntryResult]) -> None:
        """Keep the results of this run, and which of the earlier ones hold."""
        if not self._rows.is_open:
            return
        new: dict[str, dict[str, str]] = {"entries": {}, "files": {}, "shared": {}, "said": {}}

        def put(table: str, key: str, value: Any, said: Sequence[Look]) -> None:
            new[table][key] = sealed(key, value)
            new["said"][_of(table, key)] = sealed(_of(table, key), with_digest(said))

        def share(shared: Iterable[Shared]) -> list[str]:
            for each in shared:
                if each.name not in new["shared"]:
                    unsaid, said = self.parted(each.looks)
                    put("shared", each.name, unsaid, said)
                    self._shared_now[each.name] = unsaid
            return [each.name for each in shared]

        def give(each: Answered) -> None:
            if each.question not in given and (each.shared or self._kept_answer(each.question) != each.state):
                given[each.question] = KeptAnswer(each.state, share(each.shared), ())

        def give_found(each: Answer) -> None:
            known = given.get(each.question) or self._answers.get(each.question)
            if known is not None and not known.has_found and known.state == each.state:
                given[each.question] = known.with_found(each.found)

        def around(looks: Looks) -> tuple[list[Any], list[Look]]:
            for each in looks.answers:
                give(each)
            unsaid, said = self.parted(looks.own)
            return [unsaid, share(looks.shared), [each[:2] for each in looks.answers], digest_of(said)], said

        given = self._given
        try:
            for result in results:
                if not is_plain(result.request) or _has_crashed(result):
                    continue
                digests = dict(result.dependencies)
                for file in result.files:
                    if file.key not in new["files"]:
                        content = digests[os.path.abspath(os.path.join(self._session.root, file.path))]
                        looks, said = around(file.looks)
                        put("files", file.key, [content, looks, file_to_json(file)], said)
                looks, said = around(result.looks)
                key = key_of(result.request)
                hang = Hang("", result.dependencies, result.variables, looks, result.programs, tuple(said))
                put("entries", key, [*hang[1:-1], entry_to_json(result)], said)
                self._stored[key] = hang._replace(seal=new["entries"][key][:SEAL])
            for packages in (self._packages, self._packages.colcon):
                asked = packages.answers()
                for answered in self.states.answered(asked):  # asked again, or for the first time
                    give(answered)
                for answer in asked:
                    give_found(answer)
        except BROKEN:
            return
        held = {**self._now_holding(new), **self._now_answered(given)}
        gone = [name for name, holds in self._shared.items() if not holds]
        self._rows.write({**new, "held": held}, {"shared": gone, "said": [_of("shared", name) for name in gone]})

    def rows(self, table: str, keys: Sequence[str]) -> dict[str, Row]:
        """The rows of a table that are what was written, by their keys."""
        return dict(self._rows.values(table, keys))

    def write(self, rows: Mapping[str, Mapping[str, str]], said: Mapping[str, Sequence[Look]], gone: Mapping[str, Iterable[str]]) -> None:
        """Keep ``rows``, as :func:`sealed` makes them, by table and key, and what the stamp tells of groups among them."""
        told = {_of("groups", key): sealed(_of("groups", key), with_digest(looks)) for key, looks in said.items()}
        held = {**rows.get("held", {}), **self._now_holding(rows), **self._now_known()}
        held[_ALL] = sealed(_ALL, [self.surroundings.stamp, self._by_stamp])
        self._rows.write({**rows, "said": told, "held": held}, gone)

    def _now_holding(self, new: Mapping[str, Mapping[str, str]]) -> dict[str, str]:
        """The row that says which rows hold, where that is another one."""
        self._holding.update(row[:SEAL] for table, rows in new.items() if table in _HOLDING for row in rows.values())
        seals = self._held_before | self._holding
        if seals == self._held_written:
            return {}
        self._held_written = seals
        return {_HELD: sealed(_HELD, [self.surroundings.stamp, " ".join(sorted(seals))])}

    def _now_answered(self, given: Mapping[str, KeptAnswer]) -> dict[str, str]:
        """The row of all answers, where some were ``given`` in this run."""
        if given == self._given_written:
            return {}
        self._given_written = dict(given)
        holding = {
            question: known for question, known in self._answers.items() if all(self._shared.get(name, True) for name in known.names)
        }
        return {_ANSWERS: sealed(_ANSWERS, answers_to_json({**holding, **given}))}

    def parted(self, looks: Iterable[Look]) -> tuple[list[Look], list[Look]]:
        """The looks of which the stamp of the workspaces says nothing, and the others."""
        unsaid: list[Look] = []
        said: list[Look] = []
        for look in looks:
            (said if self._says(*look) else unsaid).append(look)
        return unsaid, said

    def _says(self, path: str, state: str) -> bool:
        return self.states.of(path) == state if path.startswith(QUESTION) else self.surroundings.say(path, state)

    def close(self) -> None:
        """Close the database."""
        self._rows.close()


def _gathered(rows: Iterable[Row | None], names: Callable[[Any], Iterable[str]]) -> set[str]:
    """The ``names`` that stand in the values of ``rows``, as far as these are what was written."""
    found: set[str] = set()
    for row in rows:
        if row is not None:
            with suppress(*BROKEN):
                found.update(names(row.value))
    return found


def _of(table: str, key: str) -> str:
    """The key of what the stamp of the workspaces said of a row."""
    return f"{table} {key}"


def is_plain(request: EntryRequest) -> bool:
    """Whether the file is judged as what it is; text that stands in for another file is not kept."""
    return request.file == request.at


def _has_crashed(result: EntryResult) -> bool:
    findings = (*result.findings, *(guarded.finding for file in result.files for guarded in file.findings))
    return any(finding.rule == INTERNAL_ERROR for finding in findings)


def key_of(request: EntryRequest) -> str:
    """The key of the row that has the result of a request."""
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
