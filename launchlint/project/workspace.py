"""A workspace held open: texts that are not saved yet, what was found in each entry file, and what a change of a file undoes.

It is worked on in small steps by one thread at a time: :meth:`OpenWorkspace.hold` and :meth:`OpenWorkspace.reread` say what has changed,
:attr:`OpenWorkspace.waiting` which entry files are to be checked again, :meth:`OpenWorkspace.work` checks one of them. Nothing depends on
the current directory.
"""

from __future__ import annotations

import os
from collections.abc import Callable, Collection, Iterable, Iterator, Mapping
from contextlib import contextmanager

from launchlint.baseline import load
from launchlint.check.dialects import sort_out
from launchlint.check.entry import EntryResult
from launchlint.check.merge import Outcome, Overview, merge, overview
from launchlint.check.options import EntryRequest
from launchlint.check.surroundings import CONTENT_ENDS, CONTENT_NAMES, ENTRY_ENDS
from launchlint.finding import Finding, Location
from launchlint.order import ordered
from launchlint.project.asked import EntryOptions
from launchlint.project.drawing import Drawing
from launchlint.project.known import without_known
from launchlint.project.reach import Reach
from launchlint.project.selection import per_file_ignores
from launchlint.project.watcher import Understood, Watcher
from launchlint.source import Place, Source, Span
from launchlint.syntax.decode import decode
from launchlint.syntax.recovery import Recovered, changed_from, is_readable, recovered
from launchlint.workspace.configuration import FILE_NAME
from launchlint.workspace.crawl import ROSPACK
from launchlint.workspace.discovery import is_launch_text, may_be_launch_file
from launchlint.workspace.looking import unnoted
from launchlint.workspace.reading import standing_in
from launchlint.workspace.source_lists import is_source_list
from launchlint.workspace.states import places_of

TYPE_CHECKING = False
if TYPE_CHECKING:
    from launchlint.check.fixing import Fixing


BROKEN = "LL101"
"""The rule that says why a text cannot be read."""


class OpenWorkspace:
    """The entry files below a directory, and what is known of each. Raises LaunchlintError where its configuration cannot be used.

    ``cache`` is the directory in which indices of libraries, and what was read of sources, are kept.

    A text that cannot be read since somebody is writing it is judged as it is, as ``check`` would; what else there is to say of it comes
    from the text that was recovered from it (:mod:`launchlint.syntax.recovery`), checked beside it.
    """

    def __init__(self, root: str, cache: str | None = None) -> None:
        self.root = os.path.abspath(root)
        self.texts: dict[str, bytes] = {}
        self.broken: dict[str, Recovered] = {}
        self._readable: dict[str, str] = {}
        self._beside: Watcher | None = None
        self._cache = cache
        self._checkpoint: Callable[[], None] | None = None
        self._open()

    def _open(self) -> None:
        """Read the configuration, and start anew."""
        asked = EntryOptions((self.root,), root=self.root)
        self.asked = asked
        self.options = asked.options(cache=self._cache)
        self.per_file = per_file_ignores(asked.configuration, self.root)
        baseline = asked.configuration.baseline
        self._known = None if baseline is None else load(baseline)
        self._results: dict[EntryRequest, EntryResult] = {}
        self._reach = Reach()
        self._whole: Overview | None = None
        self._guessed: dict[EntryRequest, EntryResult] = {}
        self._understood: dict[EntryRequest, Understood] = {}
        self._seen_text: dict[EntryRequest, str] = {}
        self._waiting: dict[EntryRequest, None] = {}
        self._refresh()
        self._discover()

    def _refresh(self) -> None:
        """Packages, libraries and sources are looked at again when they are next asked for."""
        with self._looking():
            self.checker = Watcher(self.options, self.texts, remember=True)
        if self._checkpoint is not None:
            self.checker.session.checkpoint = self._checkpoint
        self._whole = None
        self._look_beside()

    def _look_beside(self) -> None:
        """Make the checker for which broken texts hold what was recovered from them."""
        texts = {file: each.text.encode("utf-8", "surrogateescape") for file, each in self.broken.items()}
        self._beside = self.checker.holding(texts) if texts else None

    def _discover(self) -> None:
        """Find the entry files; those that are new wait to be checked, those that are gone are forgotten."""
        with self._looking():
            found, _ = self.asked.requests()
            kept = sort_out(found, self.texts.keys(), self.checker.session).kept  # what is open was asked for
        self.requests = dict.fromkeys(kept)
        files = {request.at for request in kept}
        for file, data in self.texts.items():
            if file not in files and may_be_launch_file(file) and not os.path.exists(file) and _is_below(file, self.root) and data:
                self.requests[EntryRequest(file, file)] = None
        for request in [each for each in self._results if each not in self.requests]:
            del self._results[request]
            self._reach.drop(request)
            self._guessed.pop(request, None)
            self._understood.pop(request, None)
        self._whole = None
        self._waiting = {each: None for each in self.requests if each in self._waiting or each not in self._results}

    @contextmanager
    def _looking(self) -> Iterator[None]:
        with standing_in(self.texts):
            yield

    def stop_where(self, checkpoint: Callable[[], None]) -> None:
        """``checkpoint`` is called every now and then; it raises :class:`~launchlint.evaluate.session.Stopped` to stop the work."""
        self._checkpoint = checkpoint
        self.checker.session.checkpoint = checkpoint

    # -- what has changed ------------------------------------------------------------------------------------------

    def hold(self, texts: Mapping[str, bytes | None]) -> None:
        """Files (absolute) hold ``texts`` instead of what is on disk, or again (None) what is there."""
        read = self.checker.session.read
        opened = texts.keys() - self.texts.keys() - {request.at for request in self.requests}
        closed = {file for file, data in texts.items() if data is None}
        changed: dict[str, bytes | None] = {}
        another = False
        for file, data in texts.items():
            before = self.texts.get(file)
            held = before if before is not None else read(file).data
            if data is not None and held is not None and may_be_launch_file(file):
                another = another or is_launch_text(file, held) != is_launch_text(file, data)
            if data is None:
                self.texts.pop(file, None)
                if before is not None and before != _on_disk(file):
                    changed[file] = None
                self.broken.pop(file, None)
                self._readable.pop(file, None)
            else:
                self.texts[file] = data
                self._recover(file, data)
                if held != data:
                    changed[file] = data
        # Also where nothing changed: what is on disk may do so, and must not be read over the text.
        self.checker = self.checker.holding(dict(texts))
        self._look_beside()
        self._undo(changed)
        if closed or another or any(map(may_be_launch_file, opened)):
            self._discover()

    def _recover(self, file: str, data: bytes) -> None:
        """Note how a text can be read, where it cannot as it is: as far as it goes, else as it could be read last."""
        self.broken.pop(file, None)
        if not may_be_launch_file(file):
            return
        text = decode(data).text
        found = recovered(text, file)
        if found.edits and not is_readable(found.text, file):
            found = changed_from(text, self._readable[file]) if file in self._readable else found
        if found.edits:
            self.broken[file] = found
        self._readable[file] = found.text

    def reread(self, files: Collection[str]) -> None:
        """Files (absolute) were written, made or removed on disk."""
        named = {os.path.basename(file) for file in files}
        if FILE_NAME in named:
            self._open()
            return
        self._undo(dict.fromkeys(file for file in files if file not in self.texts), on_disk=True)

    def _undo(self, changed: Mapping[str, bytes | None], *, on_disk: bool = False) -> None:
        """What hangs on ``changed`` files is to be worked out again."""
        if not changed:
            return
        manifests = [file for file in changed if os.path.basename(file) in ROSPACK.manifests]
        if any(map(_is_of_surroundings, changed.keys() - set(manifests))):
            self._wait_all()
            return
        before = [self.checker.packages.described_by(file) for file in manifests]
        self.checker.states.forget(places_of(changed, listed=on_disk))
        with self._looking():
            again = set(self._reach.reading(changed))
            seen = self._reach.seeing(changed, listed=on_disk)
        appeared = on_disk and any(map(may_be_launch_file, changed))
        sources = (on_disk and any(map(_is_source, changed))) or bool(manifests)
        if seen or sources or appeared:
            self._refresh()
        else:
            with self._looking():
                self.checker.packages.texts_changed(changed, listed=on_disk)
            if on_disk:
                self.checker = self.checker.holding({file: self.texts.get(file) for file in changed})
                self._look_beside()
        with self._looking():
            if any(kind is None or self.checker.packages.described_by(file) != kind for file, kind in zip(manifests, before, strict=True)):
                again.update(self.requests)  # another package, or one of another kind: everybody who names one asks which there are
            elif sources:
                again.update(self._with_other_programs())
        self._wait((*again, *seen))
        if appeared:
            self._discover()

    def _with_other_programs(self) -> Iterator[EntryRequest]:
        """The entry files that start a program of which the sources say something else now."""
        own = self.checker.own
        for request, result in self._results.items():
            programs = result.programs
            if any(own is None or own.of(ware).digest((package, table, name)) != known for ware, package, table, name, known in programs):
                yield request

    def _keep(self, request: EntryRequest, understood: Understood, guessed: EntryResult | None) -> None:
        """Take what was found in an entry file; ``guessed`` comes from texts that stand in for broken ones."""
        result, before = understood.result, self._results.get(request)
        self._results[request] = result
        self._seen_text[request] = self._text(request)
        self._understood[request] = understood
        self._waiting.pop(request, None)
        if guessed is None:
            self._guessed.pop(request, None)
        else:
            self._guessed[request] = guessed
        self._reach.put(request, result, *(() if guessed is None else (guessed,)))
        if before is None or before.summary != result.summary:
            self._whole = None

    def _wait_all(self) -> None:
        self._refresh()
        self._wait(self.requests)
        self._discover()

    def _wait(self, requests: Iterable[EntryRequest]) -> None:
        for request in requests:
            if request in self.requests:
                self._waiting[request] = None

    # -- the work --------------------------------------------------------------------------------------------------

    def waiting(self, files: Collection[str] = ()) -> list[EntryRequest]:
        """The entry files that are to be checked: ``files`` (absolute) first, then those that lead to them, then the rest."""
        wanted = frozenset(files)

        def rank(request: EntryRequest) -> int:
            known = self._results.get(request)
            reaches = known is not None and any(name in wanted for name, _ in known.dependencies)
            return 0 if request.at in wanted else 1 if reaches else 2

        return sorted(self._waiting, key=rank)

    def work(self, request: EntryRequest, first: Callable[[], None] | None = None) -> None:
        """Check one entry file. Raises what the checkpoint raises; then it goes on waiting.

        ``first`` is called when it has been checked as it is given, and other configurations are not looked at yet: until then, what was
        found in those before is taken to be true still.
        """

        def so_far(result: EntryResult) -> None:
            before = self._results.get(request)
            if first is None:
                return
            interim = result if before is None else self._with_others(result, before, self._seen_text.get(request, ""))
            self._results[request] = interim
            self._seen_text[request] = self._text(request)
            self._reach.put(request, interim)
            if before is None:
                self._whole = None
            first()

        with self._looking():
            understood = self.checker.understand(request, so_far)
            result = understood.result
            beside, guess = self._beside, None
            if beside is not None and any(name in self.broken for name, _ in result.dependencies):
                guess = beside.understand(request)
        self._keep(request, Understood(result, (guess or understood).configurations), None if guess is None else guess.result)

    def _text(self, request: EntryRequest) -> str:
        data = self.texts.get(request.at)
        return "" if data is None else decode(data).text

    def _with_others(self, result: EntryResult, before: EntryResult, text: str) -> EntryResult:
        """``result`` of the given configuration, with what others showed ``before``, when the entry file held ``text``."""
        request = result.request
        source = Source(result.path, self._text(request), request.at)
        moved = changed_from(text, source.text)
        known = {finding.key for finding in result.findings}
        others = []
        for finding in before.findings:
            at = finding.location
            if finding.arguments == request.arguments or at.path != result.path or moved.is_lost(at.start, at.end):
                continue
            place = Place(source, Span(moved.forth(at.start), moved.forth(at.end)))
            others.append(finding._replace(location=Location.of(place), fix=None))
        visited = dict(before.visited) | dict(result.visited)
        return result._replace(
            findings=(*result.findings, *(each for each in others if each.key not in known)),
            visited=tuple((path, tuple(sorted({*visited[path], *dict(before.visited).get(path, ())}))) for path in visited),
            summary=before.summary,
            dependencies=before.dependencies, looks=before.looks, programs=before.programs, variables=before.variables,
        )  # fmt: skip

    def settle(self) -> None:
        """Check all that waits."""
        for request in self.waiting():
            self.work(request)

    def forget_all_but(self, files: Collection[str]) -> None:
        """Keep the evaluations of entry files that lead to ``files`` only; what was found in the others is kept."""
        wanted = frozenset(files)
        for request, known in list(self._understood.items()):
            if not any(name in wanted for name, _ in known.result.dependencies):
                del self._understood[request]

    # -- what came of it -------------------------------------------------------------------------------------------

    def outcome(self, files: Collection[str] | None = None) -> Outcome:
        """The findings of all entry files that have been checked, as ``launchlint check`` would tell them.

        Of ``files`` (absolute), where these are given: then only what tells of them is joined, however many entry files there are.
        """
        requests: Iterable[EntryRequest] = self.requests
        paths = None if files is None else frozenset(map(self.checker.session.shown, files))
        if paths is not None:
            telling = self._reach.telling(paths)
            requests = telling if len(telling) < 2 else [each for each in self.requests if each in telling]
        results = [self._results[request] for request in requests if request in self._results]
        with self._looking(), unnoted():
            whole = self._overview()
            packages, per_file, asked = self.checker.packages, self.per_file, (self.root,)
            found = merge(results, self.options, packages, per_file, asked=asked, whole=whole)
            guessed = [self._guessed[request] for request in requests if request in self._guessed]
            if guessed:
                more = merge(guessed, self.options, packages, per_file, workspace=False, asked=asked).findings
                found = found._replace(findings=tuple(ordered([*found.findings, *self._in_broken(more, found.findings)])))
        if paths is not None:
            found = found._replace(findings=tuple(each for each in found.findings if each.location.path in paths))
        return found if self._known is None else without_known(found, self._known)

    def _overview(self) -> Overview:
        """What hangs on the summaries of all entry files, worked out when one of these has changed."""
        if self._whole is None:
            summaries = [self._results[request].summary for request in self.requests if request in self._results]
            self._whole = overview(summaries, self.options, self.checker.packages, (self.root,))
        return self._whole

    def _in_broken(self, guessed: Iterable[Finding], told: Iterable[Finding]) -> Iterator[Finding]:
        """What was found in texts that were recovered, where it stands in the broken ones, and is not told already.

        What is broken itself is told of the text as it is, not of what was made of it: that can be broken, too, where nothing better
        is had.
        """
        known = {finding.key for finding in told}
        for file, recovery in self.broken.items():
            shown = self.checker.session.shown(file)
            source = Source(shown, decode(self.texts[file]).text, file)
            for finding in guessed:
                at = finding.location
                if at.path != shown or finding.rule == BROKEN:
                    continue
                start, end = recovery.back(at.start), recovery.back(at.end)
                if not recovery.is_lost(start, end):
                    found = finding._replace(location=Location.of(Place(source, Span(start, end))), fix=None)
                    if found.key not in known:
                        yield found

    def understood(self) -> tuple[Understood, ...]:
        """The entry files whose evaluations are kept."""
        return tuple(self._understood.values())

    # -- mending ---------------------------------------------------------------------------------------------------

    def refusal(self, finding: Finding) -> str:
        """Why the fix of a finding must not be made, as ``check --fix`` would say it; empty where it may.

        That is proved on the entry files that tell of the files it changes.
        """
        paths = [] if finding.fix is None else [finding.location.path, *(edit.path for edit in finding.fix.edits)]
        with self._looking(), unnoted():
            return self._fixing(paths, unsafe=True).refusal(finding)

    def repaired(self, file: str) -> bytes | None:
        """What ``file`` (absolute) holds when all safe fixes have been made in it and nowhere else; None where there are none."""
        with self._looking(), unnoted():
            fixed = self._fixing([self.checker.session.shown(file)], only=file, unsafe=False).run()
        return fixed.files[file][1] if file in fixed.files else None

    def _fixing(self, paths: Collection[str], *, unsafe: bool, only: str | None = None) -> Fixing:
        from launchlint.check.fixing import Fixing

        telling = self._reach.telling(paths)
        results = [self._results[request] for request in self.requests if request in telling]
        return Fixing(
            self.checker,
            results,
            self.per_file,
            asked=(self.root,),
            may_change=lambda name: only is None or os.path.normpath(name) == only,
            told=lambda outcome: outcome if self._known is None else without_known(outcome, self._known),
            unsafe=unsafe,
        )

    # -- for those who show it -------------------------------------------------------------------------------------

    def drawing(self, files: Collection[str]) -> Drawing:
        """What the pages of ``files`` (absolute) are made from; a broken text is drawn as far as it goes."""
        requests = {request.at: request for request in reversed(self.requests) if request.at in files}
        texts = {**self.texts, **{file: each.text.encode("utf-8", "surrogateescape") for file, each in self.broken.items()}}
        return Drawing(requests, texts, self.options, self.per_file)

    def including(self) -> dict[str, tuple[str, ...]]:
        """Each entry file that has been checked, as shown, and the files that it leads to."""
        return {each.path: each.summary.included for each in self._results.values()}


def _on_disk(file: str) -> bytes | None:
    try:
        with open(file, "rb") as stream:
            return stream.read()
    except OSError:
        return None


def _is_below(file: str, directory: str) -> bool:
    return file.startswith(directory.rstrip(os.sep) + os.sep)


def _is_of_surroundings(file: str) -> bool:
    """Whether every result may hang on what the file holds (:mod:`launchlint.check.surroundings`)."""
    name = os.path.basename(file)
    return name in CONTENT_NAMES or (name.endswith(CONTENT_ENDS) and not name.endswith(ENTRY_ENDS)) or is_source_list(name)


def _is_source(file: str) -> bool:
    return file.endswith((".py", ".cpp", ".cc", ".cxx", ".c", ".h", ".hpp", ".hh", ".hxx", ".in", ".msg", ".srv", ".action", ".cfg"))
