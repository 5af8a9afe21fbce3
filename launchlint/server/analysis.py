"""The thread in which an open workspace is looked at: what is open first, and all else when there is time.

A text that changes stops the work on what was there before. What is ready is handed over as a :class:`Ready`, which never changes.
"""

from __future__ import annotations

import asyncio
import logging
import threading
from collections.abc import Callable, Collection, Iterable, Mapping
from typing import TypeVar, cast

from launchlint.check.causes import told_once
from launchlint.errors import LaunchlintError
from launchlint.evaluate.session import Session, Stopped
from launchlint.finding import Finding
from launchlint.garbage import look
from launchlint.ide.view import Snapshot
from launchlint.named_tuple import NamedTuple
from launchlint.project.workspace import OpenWorkspace

TYPE_CHECKING = False
if TYPE_CHECKING:
    from launchlint.project.drawing import Drawing

Made = TypeVar("Made")

STACK = 256 << 20
"""Bytes of the thread's stack: as deep as files may include each other."""
PAUSE = 0.3
"""Seconds after a keystroke in which the next one may come: what is not open waits so long."""
BREATH = 0.01
"""Seconds without anything to do after which the last text is likely to have been the last for a moment."""
QUIET = 1.0
"""Seconds without anything to do after which there is time to look for garbage."""
_log = logging.getLogger("launchlint.server")


def _told(workspace: OpenWorkspace, files: Collection[str]) -> tuple[Finding, ...]:
    """What is found in each of ``files`` (absolute). What has its cause in another one, too, is told in both: each may be all one sees."""
    by_path: dict[str, list[Finding]] = {}
    for finding in workspace.outcome(files).findings:
        by_path.setdefault(finding.location.path, []).append(finding)
    return tuple(finding for found in by_path.values() for finding in told_once(found))


class Ready(NamedTuple):
    """What was found in texts of the given ``versions`` (by absolute file), and how they are drawn; ``whole``: nothing waits any more."""

    versions: Mapping[str, int]
    findings: tuple[Finding, ...]
    snapshot: Snapshot
    whole: bool
    drawing: Drawing


class First(NamedTuple):
    """What was found before all configurations had been looked at; the fields are those of :class:`Ready`."""

    versions: Mapping[str, int]
    findings: tuple[Finding, ...]
    session: Session


def _started(work: Callable[[], None]) -> threading.Thread:
    thread = threading.Thread(target=work, name="launchlint", daemon=True)
    before = threading.stack_size(STACK)
    try:
        thread.start()
    finally:
        threading.stack_size(before)
    return thread


async def in_deep_thread(work: Callable[[], Made]) -> Made:
    """What ``work`` gives, which may go as deep as the evaluation of launch files; it is done in a thread of its own."""
    loop = asyncio.get_running_loop()
    done: asyncio.Future[Made] = loop.create_future()

    def give(result: Made | None, error: Exception | None) -> None:
        if done.cancelled():
            return
        if error is not None:
            done.set_exception(error)
        else:
            done.set_result(cast("Made", result))

    def run() -> None:
        try:
            result = work()
        except Exception as error:  # it is raised where it is awaited
            loop.call_soon_threadsafe(give, None, error)
        else:
            loop.call_soon_threadsafe(give, result, None)

    _started(run)
    return await done


class Analysis:
    """One open workspace and its thread. ``tell`` is called in that thread with what is ready, ``fail`` with what keeps it from working."""

    def __init__(self, root: str, cache: str | None, tell: Callable[[Ready | First], None], fail: Callable[[str], None]) -> None:
        self.root = root
        self._cache = cache
        self._tell = tell
        self._fail = fail
        self._condition = threading.Condition()
        self._texts: dict[str, bytes | None] = {}
        self._versions: dict[str, int] = {}
        self._written: set[str] = set()
        self._jobs: list[tuple[str, int, Callable[[OpenWorkspace], None], Callable[[], object]]] = []
        self._ends = False
        self._thread = _started(self._run)

    def hold(self, file: str, data: bytes | None, version: int) -> None:
        """A file (absolute) holds ``data`` in the editor, or (None) is not open any more."""
        with self._condition:
            self._texts[file] = data
            if data is None:
                self._versions.pop(file, None)
            else:
                self._versions[file] = version
            self._condition.notify()

    def written(self, files: Iterable[str]) -> None:
        """Files (absolute) were written, made or removed."""
        with self._condition:
            self._written.update(files)
            self._condition.notify()

    async def ask(self, file: str, version: int, work: Callable[[OpenWorkspace], Made]) -> Made | None:
        """What ``work`` makes of the workspace, in its thread, while ``file`` (absolute) has that version; None where somebody types."""
        loop = asyncio.get_running_loop()
        done: asyncio.Future[Made | None] = loop.create_future()

        def give(made: Made | None) -> None:
            if not done.done():
                done.set_result(made)

        def run(workspace: OpenWorkspace) -> None:
            made = work(workspace)
            loop.call_soon_threadsafe(give, made)

        with self._condition:
            self._jobs.append((file, version, run, lambda: loop.call_soon_threadsafe(give, None)))
            self._condition.notify()
        return await done

    def end(self) -> None:
        """Stop, and wait until it has."""
        with self._condition:
            self._ends = True
            self._condition.notify()
        self._thread.join(timeout=5)

    # -- in the thread ---------------------------------------------------------------------------------------------

    def _checkpoint(self) -> None:
        if self._is_needed():
            raise Stopped

    def _answer(self, workspace: OpenWorkspace) -> None:
        """Do what was asked for, each as long as its file is as it was."""
        while self._jobs and not self._texts:
            with self._condition:
                file, version, run, give_up = self._jobs.pop(0)
                current = self._versions.get(file) == version
            jobs, self._jobs = self._jobs, []  # what else is asked for does not stop this
            try:
                if not current:
                    give_up()
                else:
                    run(workspace)
            except BaseException:
                give_up()
                raise
            finally:
                with self._condition:
                    self._jobs = [*jobs, *self._jobs]

    def _run(self) -> None:
        workspace: OpenWorkspace | None = None
        while not self._ends:
            workspace = self._worked(workspace)

    def _worked(self, workspace: OpenWorkspace | None) -> OpenWorkspace | None:
        """One step of the work. Returns the workspace; None where it is to be opened anew."""
        texts = {} if workspace is None else workspace.texts
        try:
            if workspace is None:
                workspace = OpenWorkspace(self.root, self._cache)
                workspace.stop_where(self._checkpoint)
            self._step(workspace)
        except Stopped:
            pass
        except LaunchlintError as error:
            self._fail(str(error))
            self._wait()
            workspace = None
        except Exception:  # a mistake of launchlint itself: the editor must not be left alone for it
            _log.exception("the workspace is opened anew")
            self._wait()
            workspace = None
        if workspace is None:
            with self._condition:
                self._texts = {**texts, **self._texts}
        return workspace

    def _wait(self) -> None:
        with self._condition:
            for seconds in (BREATH, QUIET):
                if self._condition.wait_for(self._is_needed, seconds):
                    return
                look(thoroughly=seconds == QUIET)
            self._condition.wait_for(self._is_needed)

    def _pause(self) -> None:
        with self._condition:
            self._condition.wait_for(self._is_needed, PAUSE)

    def _is_needed(self) -> bool:
        return bool(self._texts or self._written or self._jobs or self._ends)

    def _step(self, workspace: OpenWorkspace) -> None:
        with self._condition:
            texts, written = dict(self._texts), set(self._written)
            self._texts.clear()
            self._written.clear()
            versions = dict(self._versions)
        if written:
            workspace.reread(written)
        if texts:
            workspace.hold(texts)
        opened = set(versions)
        self._answer(workspace)
        waiting = workspace.waiting(opened)
        near = [each for each in waiting if each.at in opened]
        for request in near:
            workspace.work(request, lambda: self._tell_first(workspace, versions))
        rest = waiting[len(near) :]
        if rest and (texts or written):
            self._hand_over(workspace, versions, whole=False)
        if rest and texts:
            self._pause()
        for request in rest:
            self._checkpoint()
            workspace.work(request)
            workspace.forget_all_but(opened)
            look(thoroughly=False)
        self._hand_over(workspace, versions, whole=True)
        self._wait()

    def _tell_first(self, workspace: OpenWorkspace, versions: Mapping[str, int]) -> None:
        """What is known before all configurations have been looked at."""
        self._checkpoint()
        self._tell(First(versions, _told(workspace, versions), workspace.checker.session))

    def _hand_over(self, workspace: OpenWorkspace, versions: Mapping[str, int], *, whole: bool) -> None:
        self._checkpoint()
        findings = _told(workspace, versions)
        snapshot = Snapshot(
            workspace.checker.session, workspace.checker.library, workspace.options.style, workspace.understood(), workspace.including(),
            dict(workspace.broken),
        )  # fmt: skip
        self._tell(Ready(versions, findings, snapshot, whole, workspace.drawing(versions)))
