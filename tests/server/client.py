"""A client that speaks to a server in a process of its own, with what it was told."""

from __future__ import annotations

import asyncio
import sys
import time
from collections.abc import AsyncIterator
from contextlib import asynccontextmanager
from pathlib import Path

from lsprotocol import types
from pygls.lsp.client import LanguageClient

from launchlint.server.service import PATIENCE

TRIES = 6
"""How often a busy machine is asked again."""
ROOT = Path(__file__).resolve().parent.parent.parent


class Client(LanguageClient):
    """Remembers the diagnostics of each file, and how often they were told."""

    def __init__(self) -> None:
        super().__init__("launchlint-tests", "1")
        self.diagnostics: dict[str, list[types.Diagnostic]] = {}
        self.told: list[types.PublishDiagnosticsParams] = []
        self.errors: list[str] = []
        self.versions: dict[str, int] = {}

        @self.feature(types.TEXT_DOCUMENT_PUBLISH_DIAGNOSTICS)
        def published(params: types.PublishDiagnosticsParams) -> None:
            self.diagnostics[params.uri] = list(params.diagnostics)
            self.told.append(params)

        @self.feature(types.WINDOW_SHOW_MESSAGE)
        def shown(params: types.ShowMessageParams) -> None:
            self.errors.append(params.message)

        @self.feature(types.WINDOW_LOG_MESSAGE)
        def logged(params: types.LogMessageParams) -> None:
            self.errors.append(params.message)

    def open(self, path: Path, text: str | None = None) -> str:
        """Open a file; returns its address."""
        uri = path.as_uri()
        language = {".py": "python", ".yaml": "yaml"}.get(path.suffix, "xml")
        given = path.read_bytes().decode("utf-8") if text is None else text
        self.versions[uri] = 1
        self.text_document_did_open(types.DidOpenTextDocumentParams(types.TextDocumentItem(uri, language, 1, given)))
        return uri

    def change(self, uri: str, text: str) -> None:
        """All of the text is another one."""
        self._change(uri, types.TextDocumentContentChangeWholeDocument(text))

    def type(self, uri: str, line: int, character: int, text: str, end: tuple[int, int] | None = None) -> None:
        """Put ``text`` at a place, or over what stands from there to ``end``."""
        last = types.Position(line, character) if end is None else types.Position(*end)
        self._change(uri, types.TextDocumentContentChangePartial(types.Range(types.Position(line, character), last), text))

    def _change(self, uri: str, change: types.TextDocumentContentChangeEvent) -> None:
        self.versions[uri] += 1
        named = types.VersionedTextDocumentIdentifier(self.versions[uri], uri)
        self.text_document_did_change(types.DidChangeTextDocumentParams(named, [change]))

    async def settled(self, uri: str) -> list[types.Diagnostic]:
        """The diagnostics once the server has looked at the text as it is now: it answers then, or when it has lost its patience."""
        for _ in range(TRIES):
            started = time.monotonic()
            await self.text_document_inlay_hint_async(
                types.InlayHintParams(types.TextDocumentIdentifier(uri), types.Range(types.Position(0, 0), types.Position(0, 0)))
            )
            if time.monotonic() - started < PATIENCE:
                break
        await asyncio.sleep(0)
        return self.diagnostics.get(uri, [])


@asynccontextmanager
async def connected(root: Path, encodings: list[types.PositionEncodingKind] | None = None) -> AsyncIterator[Client]:
    """A client of a server that holds ``root`` open."""
    client = Client()
    await client.start_io(sys.executable, "-m", "launchlint", "server", cwd=str(ROOT))
    item = types.ClientCompletionItemOptions(snippet_support=True)
    capabilities = types.ClientCapabilities(
        general=types.GeneralClientCapabilities(position_encodings=encodings),
        text_document=types.TextDocumentClientCapabilities(
            completion=types.CompletionClientCapabilities(completion_item=item),
            hover=types.HoverClientCapabilities(content_format=[types.MarkupKind.Markdown]),
        ),
    )
    folder = types.WorkspaceFolder(root.as_uri(), root.name)
    await client.initialize_async(types.InitializeParams(capabilities=capabilities, root_uri=root.as_uri(), workspace_folders=[folder]))
    client.initialized(types.InitializedParams())
    try:
        yield client
    finally:
        await asyncio.wait_for(client.shutdown_async(None), 20)
        client.exit(None)
        await asyncio.wait_for(client.stop(), 20)
    assert client.errors == []
