"""The state of a running server: documents, the workspaces that hold them, and what was found last."""

from __future__ import annotations

import asyncio
import os

from lsprotocol import types
from pygls.lsp.server import LanguageServer

from launchlint import __version__
from launchlint.check.run import default_directory
from launchlint.ide.repair import Replacement, changes
from launchlint.ide.view import Snapshot, View
from launchlint.server.addresses import path_of
from launchlint.server.analysis import Analysis, First, Ready
from launchlint.server.diagnostics import by_file
from launchlint.server.documents import Document, Documents
from launchlint.syntax.decode import decode
from launchlint.workspace.repository import repository_root

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Sequence

    from launchlint.finding import Finding

PATIENCE = 10.0
"""Seconds that a request waits until what it is about has been looked at."""


class Service(LanguageServer):
    """The server, with what its requests share. All of it lives in the thread of the event loop; analyses hand over to it."""

    def __init__(self) -> None:
        super().__init__("launchlint", f"v{__version__}", text_document_sync_kind=types.TextDocumentSyncKind.Incremental)
        self.documents = Documents()
        self.folders: list[str] = []
        self._analyses: dict[str, Analysis] = {}
        self._ready: dict[str, Ready] = {}
        self._published: dict[str, list[types.Diagnostic]] = {}
        self._changed: asyncio.Condition | None = None
        self._drawn: dict[str, tuple[object, ...]] = {}
        self._proved: dict[str, tuple[Ready | None, dict[int, bool]]] = {}

    # -- workspaces ----------------------------------------------------------------------------------------------

    def root_of(self, file: str) -> str:
        """The directory that is held open for a file: the folder of the editor that it lies in, else its repository."""
        around = [each for each in self.folders if file.startswith(each.rstrip(os.sep) + os.sep)]
        return max(around, key=len) if around else repository_root(os.path.dirname(file))

    def analysis_of(self, file: str) -> Analysis:
        """The workspace of a file, opened where it is not yet."""
        root = self.root_of(file)
        if root not in self._analyses:
            loop = asyncio.get_running_loop()

            def tell(ready: Ready | First) -> None:
                loop.call_soon_threadsafe(self._take, root, ready)

            def fail(message: str) -> None:
                loop.call_soon_threadsafe(self.say, message)

            self._analyses[root] = Analysis(root, default_directory(), tell, fail)
        return self._analyses[root]

    def written(self, files: list[str]) -> None:
        """Files were written, made or removed."""
        for analysis in self._analyses.values():
            analysis.written(files)

    def end(self) -> None:
        """Stop all work."""
        for analysis in self._analyses.values():
            analysis.end()
        self._analyses.clear()

    def say(self, message: str) -> None:
        """Show people what keeps the server from working."""
        self.window_show_message(types.ShowMessageParams(types.MessageType.Error, f"launchlint: {message}"))

    # -- what is ready -------------------------------------------------------------------------------------------

    def _take(self, root: str, ready: Ready | First) -> None:
        if any((known := self.documents.get(file)) is None or known.version != version for file, version in ready.versions.items()):
            return  # somebody has typed since: what is true of that text comes next
        if isinstance(ready, Ready):
            self._ready[root] = ready
        session = ready.session if isinstance(ready, First) else ready.snapshot.session
        for file, found in by_file(ready.findings, self.documents, session).items():
            document = self.documents.get(file)
            if document is not None and file in ready.versions and self._published.get(file) != found:
                self._published[file] = found
                self.text_document_publish_diagnostics(types.PublishDiagnosticsParams(document.address, found, document.version))
        if isinstance(ready, Ready):
            self._tell_of_drawings(ready)
        self._notifying = asyncio.ensure_future(self._notify())

    async def _notify(self) -> None:
        condition = self._condition()
        async with condition:
            condition.notify_all()

    def _condition(self) -> asyncio.Condition:
        if self._changed is None:
            self._changed = asyncio.Condition()
        return self._changed

    def watch_drawing(self, document: Document) -> None:
        """The drawing of an open file was asked for: from now on whoever shows it is told when it is out of date."""
        ready = self.ready_for(document)
        self._drawn[document.file] = () if ready is None else _evaluations(ready, document.file)

    def _tell_of_drawings(self, ready: Ready) -> None:
        for file, before in self._drawn.items():
            document = self.documents.get(file)
            now = _evaluations(ready, file)
            if document is not None and file in ready.versions and not _are_same(now, before):
                self._drawn[file] = now
                self.protocol.notify("launchlint/topologyChanged", {"uri": document.address})

    def forget(self, document: Document) -> None:
        """A file was closed: nothing is said of it any more."""
        self._drawn.pop(document.file, None)
        self._proved.pop(document.file, None)
        if self._published.pop(document.file, None):
            self.text_document_publish_diagnostics(types.PublishDiagnosticsParams(document.address, []))

    def ready_for(self, document: Document) -> Ready | None:
        """What was found when the workspace was last looked at, whatever was typed since."""
        return self._ready.get(self.root_of(document.file))

    async def up_to_date(self, document: Document, *, whole: bool = False) -> Ready | None:
        """What was found in the text as it is; None where that takes too long, or the text changes meanwhile."""
        version = document.version

        def found() -> Ready | None:
            ready = self.ready_for(document)
            good = ready is not None and ready.versions.get(document.file) == version and (ready.whole or not whole)
            return ready if good else None

        condition = self._condition()
        async with condition:
            try:
                await asyncio.wait_for(condition.wait_for(lambda: found() is not None or document.version != version), PATIENCE)
            except asyncio.TimeoutError:
                return None
        return found()

    def markup(self, kinds: Sequence[types.MarkupKind] | None, markdown: str) -> types.MarkupContent | str:
        """A text as the client can show it: ``kinds`` are those that it says it can; some say nothing of that."""
        if kinds and types.MarkupKind.Markdown in kinds:
            return types.MarkupContent(types.MarkupKind.Markdown, markdown)
        plain = markdown.replace("**", "").replace("`", "")
        return types.MarkupContent(types.MarkupKind.PlainText, plain) if kinds else plain

    # -- for requests --------------------------------------------------------------------------------------------

    def document(self, address: str) -> Document | None:
        """The open file at ``address``."""
        file = path_of(address)
        return None if file is None else self.documents.get(file)

    async def view(self, address: str, *, whole: bool = False) -> tuple[Document, View] | None:
        """An open file and what is known of its text as it is."""
        document = self.document(address)
        if document is None:
            return None
        ready = await self.up_to_date(document, whole=whole)
        return None if ready is None else (document, document.view(ready.snapshot))

    async def view_at_once(self, address: str) -> tuple[Document, View] | None:
        """The same, with what was known of an earlier text where it has just been changed: while somebody types."""
        document = self.document(address)
        if document is None:
            return None
        ready = self.ready_for(document)
        return await self.view(address) if ready is None else (document, document.view(ready.snapshot))

    def snapshots(self) -> list[Snapshot]:
        """What is known of each workspace."""
        return [each.snapshot for each in self._ready.values()]

    async def is_proved(self, document: Document, finding: Finding) -> bool:
        """Whether the fix of a finding may be made, as ``check --fix`` would make it."""
        ready = self.ready_for(document)
        proved = self._proved.get(document.file)
        if proved is None or proved[0] is not ready:
            proved = self._proved[document.file] = (ready, {})
        if id(finding) not in proved[1]:
            reason = await self.analysis_of(document.file).ask(document.file, document.version, lambda held: held.refusal(finding))
            if reason is None:
                return False
            proved[1][id(finding)] = not reason
        return proved[1][id(finding)]

    async def repaired(self, document: Document) -> list[Replacement]:
        """The changes that all safe fixes of an open file come to, proved together."""
        file = document.file
        after = await self.analysis_of(file).ask(file, document.version, lambda held: held.repaired(file) or b"")
        return changes(document.text, decode(after).text) if after else []

    def findings(self, document: Document) -> list[Finding]:
        """What was found in an open file."""
        ready = self.ready_for(document)
        shown = "" if ready is None else ready.snapshot.session.shown(document.file)
        return [] if ready is None else [each for each in ready.findings if each.location.path == shown]


def _evaluations(ready: Ready, file: str) -> tuple[object, ...]:
    """What a file comes to as an entry file: equal as long as nobody has looked at it again."""
    return tuple(
        configuration for each in ready.snapshot.entries if each.result.request.at == file for configuration in each.configurations
    )


def _are_same(some: tuple[object, ...], others: tuple[object, ...]) -> bool:
    return len(some) == len(others) and all(one is other for one, other in zip(some, others, strict=True))
