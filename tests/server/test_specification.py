"""Every request of the protocol on real launch files, by pytest-lsp's client: it holds each answer against what its editor says it can.

Its client is used as it is; the event loop is one of ours, so that pytest's asyncio plug-in has nothing to do (``-p no:asyncio``).
"""

from __future__ import annotations

import asyncio
import random
import shutil
import sys
from concurrent.futures import ThreadPoolExecutor
from contextlib import suppress
from pathlib import Path
from typing import Any

import pytest
from lsprotocol import types
from pygls.exceptions import JsonRpcException

from tests.server.client import ROOT

pytest_lsp = pytest.importorskip("pytest_lsp", reason="pytest-lsp is not installed")

EDITORS = ("visual_studio_code", "neovim", "emacs")
SAMPLE = 12
"""Places of each file that are asked about."""


def positions(text: str) -> list[types.Position]:
    """Some places of a text, the same in every run; the last one too."""
    chance = random.Random(text)
    offsets = sorted({*(chance.randrange(len(text) + 1) for _ in range(SAMPLE)), len(text)})
    return [types.Position(text.count("\n", 0, at), at - text.rfind("\n", 0, at) - 1) for at in offsets]


async def ask(client: Any, uri: str, text: str) -> set[str]:
    """Everything that is asked of one open file. Returns the requests that had an answer."""
    named = types.TextDocumentIdentifier(uri)
    lines = text.count("\n")
    whole = types.Range(types.Position(0, 0), types.Position(lines + 1, 0))
    options = types.FormattingOptions(2, True)
    answered: set[str] = set()

    def note(request: str, answer: Any) -> Any:
        if answer:
            answered.add(request)
        return answer

    for at in positions(text):
        note("hover", await client.text_document_hover_async(types.HoverParams(named, at)))
        note("definition", await client.text_document_definition_async(types.DefinitionParams(named, at)))
        context = types.ReferenceContext(True)
        note("references", await client.text_document_references_async(types.ReferenceParams(context, named, at)))
        note("highlight", await client.text_document_document_highlight_async(types.DocumentHighlightParams(named, at)))
        offered = note("completion", await client.text_document_completion_async(types.CompletionParams(named, at)))
        for item in offered.items[:2]:
            note("resolve", await client.completion_item_resolve_async(item))
        if await client.text_document_prepare_rename_async(types.PrepareRenameParams(named, at)):
            with suppress(JsonRpcException):  # the word is taken, or belongs to what lies elsewhere: the message says it
                note("rename", await client.text_document_rename_async(types.RenameParams(named, at, "another")))
        note("selection", await client.text_document_selection_range_async(types.SelectionRangeParams(named, [at])))
        note("linked", await client.text_document_linked_editing_range_async(types.LinkedEditingRangeParams(named, at)))
        point = types.Range(at, at)
        note("actions", await client.text_document_code_action_async(types.CodeActionParams(named, point, types.CodeActionContext([]))))
    actions = await client.text_document_code_action_async(types.CodeActionParams(named, whole, types.CodeActionContext([])))
    for action in note("actions", actions) or ():
        if isinstance(action, types.CodeAction) and action.edit is None:
            note("resolve action", await client.code_action_resolve_async(action))
    note("links", await client.text_document_document_link_async(types.DocumentLinkParams(named)))
    note("symbols", await client.text_document_document_symbol_async(types.DocumentSymbolParams(named)))
    note("workspace symbols", await client.workspace_symbol_async(types.WorkspaceSymbolParams("t")))
    note("folding", await client.text_document_folding_range_async(types.FoldingRangeParams(named)))
    note("hints", await client.text_document_inlay_hint_async(types.InlayHintParams(named, whole)))
    note("lenses", await client.text_document_code_lens_async(types.CodeLensParams(named)))
    note("formatting", await client.text_document_formatting_async(types.DocumentFormattingParams(named, options)))
    note("range", await client.text_document_range_formatting_async(types.DocumentRangeFormattingParams(named, whole, options)))
    items = await client.text_document_prepare_call_hierarchy_async(types.CallHierarchyPrepareParams(named, types.Position(0, 0)))
    for item in note("calls", items) or ():
        note("outgoing", await client.call_hierarchy_outgoing_calls_async(types.CallHierarchyOutgoingCallsParams(item)))
        note("incoming", await client.call_hierarchy_incoming_calls_async(types.CallHierarchyIncomingCallsParams(item)))
    note("diagnostics", client.diagnostics.get(uri))
    note("topology", await client.protocol.send_request_async("launchlint/topology", {"textDocument": {"uri": uri}}))
    return answered


async def session(root: Path, files: list[Path], editor: str) -> set[str]:
    """Open files one after another, ask everything, and close them."""
    client = pytest_lsp.LanguageClient()

    @client.feature(types.WINDOW_SHOW_MESSAGE)
    def shown(params: types.ShowMessageParams) -> None:
        client.messages.append(params)

    @client.feature(types.TEXT_DOCUMENT_PUBLISH_DIAGNOSTICS)
    def published(params: types.PublishDiagnosticsParams) -> None:
        client.diagnostics[params.uri] = params.diagnostics

    @client.feature(types.CLIENT_REGISTER_CAPABILITY)
    def registered(params: types.RegistrationParams) -> None:
        return None

    answered: set[str] = set()
    await client.start_io(sys.executable, "-m", "launchlint", "server", cwd=str(ROOT))
    folder = types.WorkspaceFolder(root.as_uri(), root.name)
    capabilities = pytest_lsp.client_capabilities(editor)
    given = types.InitializeParams(capabilities=capabilities, root_uri=root.as_uri(), workspace_folders=[folder])
    await client.initialize_session(given)
    try:
        for file in files:
            uri, text = file.as_uri(), file.read_bytes().decode("utf-8", "replace").replace("\r\n", "\n")
            language = {".py": "python", ".yaml": "yaml"}.get(file.suffix, "xml")
            client.text_document_did_open(types.DidOpenTextDocumentParams(types.TextDocumentItem(uri, language, 1, text)))
            answered |= await ask(client, uri, text)
            client.text_document_did_close(types.DidCloseTextDocumentParams(types.TextDocumentIdentifier(uri)))
    finally:
        await client.shutdown_session()
        await asyncio.wait_for(client.stop(), 20)
    assert client.messages == []
    assert client.error is None
    return answered


def converse(root: Path, files: list[Path], editor: str) -> set[str]:
    """One session, in a thread of its own: where a browser is driven, this one has a loop that runs."""
    with ThreadPoolExecutor(1) as thread:
        return thread.submit(lambda: asyncio.run(asyncio.wait_for(session(root, files, editor), 500))).result()


@pytest.mark.parametrize("editor", EDITORS)
def test_the_example(editor: str, tmp_path: Path) -> None:
    root = tmp_path / "example"
    shutil.copytree(ROOT / "examples", root)
    (root / ".git").mkdir()
    files = sorted(root.glob("turtles/*/launch/*.launch"))[:3]
    answered = converse(root, files, editor)
    assert answered >= {
        "hover", "definition", "references", "highlight", "completion", "selection", "symbols", "workspace symbols", "folding", "lenses",
        "calls", "topology", "diagnostics",
    }  # fmt: skip


@pytest.mark.corpus
def test_robots_of_the_corpus(corpus: Path) -> None:
    chance = random.Random(17)
    robots = sorted(path for path in corpus.glob("ros1/*/*") if path.is_dir() and any(path.glob("**/*.launch")))
    for root in chance.sample(robots, 3):
        files = sorted(root.glob("**/*.launch"))
        assert "symbols" in converse(root, chance.sample(files, min(2, len(files))), "visual_studio_code")
