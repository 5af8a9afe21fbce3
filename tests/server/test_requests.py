"""Every request of the protocol, put to a server in a process of its own."""

from __future__ import annotations

import asyncio
from collections.abc import Awaitable, Callable
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import pytest
from lsprotocol import types
from pygls.exceptions import JsonRpcException

from tests.server.client import Client, connected
from tests.server.workspace import FILES, MAIN, make

Session = Callable[[Client, Path], Awaitable[None]]


def converse(root: Path, session: Session, encodings: list[types.PositionEncodingKind] | None = None) -> None:
    """Run one session with a server of its own, in a thread of its own: where a browser is driven, this one has a loop that runs."""

    async def run() -> None:
        async with connected(root, encodings) as client:
            await asyncio.wait_for(session(client, root), 120)

    with ThreadPoolExecutor(1) as thread:
        thread.submit(lambda: asyncio.run(run())).result()


def place(text: str, word: str, inside: int = 1, number: int = 0) -> types.Position:
    """A position in the ``number``-th occurrence of ``word``."""
    at = -1
    for _ in range(number + 1):
        at = text.index(word, at + 1)
    before = text[: at + inside]
    return types.Position(before.count("\n"), len(before) - before.rfind("\n") - 1)


@pytest.fixture
def root(tmp_path: Path) -> Path:
    return make(tmp_path / "ws")


def test_a_session_in_ros_1(root: Path) -> None:
    converse(root, _in_ros_1)


async def _in_ros_1(client: Client, root: Path) -> None:
    launch = root / "demo" / "launch"
    uri = client.open(launch / "main.launch")
    named = types.TextDocumentIdentifier(uri)
    part = (launch / "part.launch").as_uri()
    whole = types.Range(types.Position(0, 0), types.Position(99, 0))
    found = await client.settled(uri)
    assert [(each.code, each.range.start.line) for each in found] == [("LL206", 2), ("LL301", 9)]
    assert found[0].code_description == types.CodeDescription("https://launchlint.readthedocs.io/en/stable/rules/LL206/")
    assert [each.location.range.start.line for each in found[1].related_information or ()] == [6]

    async def hover(word: str, inside: int = 1) -> str:
        said = await client.text_document_hover_async(types.HoverParams(named, place(MAIN, word, inside)))
        assert said is not None
        assert isinstance(said.contents, types.MarkupContent)
        return said.contents.value

    assert "required" in await hover('name="rate"', 7)
    assert "`10`" in await hover('name="rate"', 7)
    assert "- `true`" in await hover("$(arg sim)", 8)
    assert "takes these args" in await hover("/launch/part", 3)
    assert str(root / "demo") in await hover("$(find demo)", 8)
    assert "/turtle1/pose" in await hover('type="turtlesim_node"', 8)

    async def definition(word: str, inside: int) -> list[tuple[str, int]]:
        targets = await client.text_document_definition_async(types.DefinitionParams(named, place(MAIN, word, inside)))
        assert isinstance(targets, (list, tuple))
        return [(each.uri, each.range.start.line) for each in targets if isinstance(each, types.Location)]

    assert await definition("$(arg sim)", 8) == [(uri, 1)]
    assert await definition('name="rate"', 7) == [(part, 1)]
    assert await definition("/launch/part", 3) == [(part, 0)]
    assert await definition("$(find demo)", 8) == [((root / "demo" / "package.xml").as_uri(), 0)]
    asked = types.ReferenceParams(types.ReferenceContext(True), named, place(MAIN, 'name="rate"', 7))
    references = await client.text_document_references_async(asked)
    assert sorted((each.uri, each.range.start.line) for each in references or ()) == [(uri, 4), (part, 1), (part, 3)]
    span = await client.text_document_prepare_rename_async(types.PrepareRenameParams(named, place(MAIN, 'name="rate"', 7)))
    assert span == types.Range(types.Position(4, 15), types.Position(4, 19))
    edit = await client.text_document_rename_async(types.RenameParams(named, place(MAIN, 'name="rate"', 7), "hertz"))
    assert edit is not None
    changes = edit.changes or {}
    assert {address: [each.range.start.line for each in edits] for address, edits in changes.items()} == {uri: [4], part: [1, 3]}
    with pytest.raises(JsonRpcException, match="cannot be a name"):
        await client.text_document_rename_async(types.RenameParams(named, place(MAIN, 'name="rate"', 7), "2 words"))
    marks = await client.text_document_document_highlight_async(types.DocumentHighlightParams(named, place(MAIN, "$(arg sim)", 8)))
    assert [each.range.start.line for each in marks or ()] == [1, 3]
    links = await client.text_document_document_link_async(types.DocumentLinkParams(named))
    assert [each.target for each in links or ()] == [part, (root / "demo" / "config" / "turtle.yaml").as_uri()]
    symbols = await client.text_document_document_symbol_async(types.DocumentSymbolParams(named))
    assert [each.name for each in symbols or ()] == ["sim", "unused", "$(find demo)/launch/part.launch", "turtle", "turtle"]
    everywhere = await client.workspace_symbol_async(types.WorkspaceSymbolParams("teleop"))
    assert {each.name for each in everywhere or ()} >= {"/teleop"}
    folds = await client.text_document_folding_range_async(types.FoldingRangeParams(named))
    assert sorted((each.start_line, each.end_line) for each in folds or ()) == [(0, 10), (3, 5), (6, 8)]
    around = await client.text_document_selection_range_async(types.SelectionRangeParams(named, [place(MAIN, "$(arg sim)", 8)]))
    assert around is not None
    assert around[0].parent is not None
    assert around[0].range.start == place(MAIN, "$(arg sim)", 6)
    pair = await client.text_document_linked_editing_range_async(types.LinkedEditingRangeParams(named, place(MAIN, "<include", 2)))
    assert pair is not None
    assert [each.start.line for each in pair.ranges] == [3, 5]
    lenses = await client.text_document_code_lens_async(types.CodeLensParams(named))
    assert next(each.command.title for each in lenses or () if each.command) == "3 nodes, 0 connections"
    hints = await client.text_document_inlay_hint_async(types.InlayHintParams(named, whole))
    assert [each.label for each in hints or ()] == [" = true …"]
    formatted = await client.text_document_formatting_async(types.DocumentFormattingParams(named, types.FormattingOptions(2, True)))
    assert [each.range.start.line for each in formatted or ()] == [3]
    lines = types.Range(types.Position(8, 0), types.Position(9, 0))
    asked_range = types.DocumentRangeFormattingParams(named, lines, types.FormattingOptions(2, True))
    assert not await client.text_document_range_formatting_async(asked_range)
    items = await client.text_document_prepare_call_hierarchy_async(types.CallHierarchyPrepareParams(named, types.Position(0, 0)))
    assert items is not None
    calls = await client.call_hierarchy_outgoing_calls_async(types.CallHierarchyOutgoingCallsParams(items[0]))
    assert [each.to.uri for each in calls or ()] == [part]
    back = await client.call_hierarchy_incoming_calls_async(types.CallHierarchyIncomingCallsParams((calls or ())[0].to))
    assert [each.from_.uri for each in back or ()] == [uri]
    await _fixes(client, uri, named, whole)


async def _fixes(client: Client, uri: str, named: types.TextDocumentIdentifier, whole: types.Range) -> None:
    """Fixes are offered, and silence; after a fix the finding is gone."""
    actions = await client.text_document_code_action_async(types.CodeActionParams(named, whole, types.CodeActionContext([])))
    titles = [each.title for each in actions or ()]
    assert "Remove the arg (LL206)" in titles
    assert "Silence LL301 duplicate-node-name here" in titles
    chosen = next(each for each in actions or () if isinstance(each, types.CodeAction) and each.title.startswith("Silence LL301"))
    assert chosen.edit is not None
    (edit,) = (chosen.edit.changes or {})[uri]
    client.type(uri, edit.range.start.line, edit.range.start.character, edit.new_text)
    assert [each.code for each in await client.settled(uri) if each.code == "LL301"] == []


def test_what_is_completed(root: Path) -> None:
    converse(root, _completed)


async def _completed(client: Client, root: Path) -> None:
    uri = client.open(root / "demo" / "launch" / "main.launch")
    await client.settled(uri)

    async def complete(typed: str) -> list[str]:
        """What is offered where ``typed`` was typed on a line of its own in front of the second node."""
        lines = MAIN.split("\n")
        client.change(uri, "\n".join([*lines[:9], typed, *lines[9:]]))
        asked = types.CompletionParams(types.TextDocumentIdentifier(uri), types.Position(9, len(typed)))
        offered = await client.text_document_completion_async(asked)
        assert isinstance(offered, types.CompletionList)
        return [each.label for each in offered.items]

    assert {"node", "include", "/launch"} <= set(await complete("  <"))
    assert "pkg" in await complete('  <node name="x" ')
    assert "screen" in await complete('  <node name="x" output="')
    assert (await complete('  <node pkg="'))[0] == "demo"
    assert "turtlesim_node" in await complete('  <node pkg="turtlesim" type="')
    assert "arg" in await complete('  <remap from="a" to="$(')
    assert "sim" in await complete('  <remap from="a" to="$(arg ')
    assert "demo" in await complete('  <include file="$(find ')
    assert "$(find demo)/launch/part.launch" in await complete('  <include file="')
    assert await complete('  <include file="$(find demo)/launch/part.launch"> <arg name="') == ["rate"]
    assert "turtle1/pose" in await complete('  <node name="turtle" pkg="turtlesim" type="turtlesim_node"> <remap from="')
    assert "/turtle1/pose" in await complete('  <node name="turtle" pkg="turtlesim" type="turtlesim_node"> <remap from="turtle1/pose" to="')


@pytest.mark.parametrize("name", ["world.launch.xml", "part.launch.yaml", "turtle.launch.py"])
def test_a_session_in_ros_2(root: Path, name: str) -> None:
    async def session(client: Client, root: Path) -> None:
        text = FILES[f"demo2/launch/{name}"]
        uri = client.open(root / "demo2" / "launch" / name)
        named = types.TextDocumentIdentifier(uri)
        await client.settled(uri)
        word = {"world.launch.xml": "$(var world", "part.launch.yaml": "$(var speed", "turtle.launch.py": "LaunchConfiguration('name"}[name]
        at = place(text, word, len(word) - 1)
        targets = await client.text_document_definition_async(types.DefinitionParams(named, at))
        assert isinstance(targets, (list, tuple))
        assert [each.uri for each in targets if isinstance(each, types.Location)] == [uri]
        said = await client.text_document_hover_async(types.HoverParams(named, at))
        assert said is not None
        assert "**arg**" in str(said.contents)
        assert await client.text_document_document_symbol_async(types.DocumentSymbolParams(named))

    converse(root, session)


@pytest.mark.parametrize("unit", [types.PositionEncodingKind.Utf8, types.PositionEncodingKind.Utf16])
def test_positions_are_counted_as_the_client_counts(root: Path, unit: types.PositionEncodingKind) -> None:
    text = '<launch>\r\n\t<!-- 😀 --><arg name="unused" default="é"/>\r\n</launch>\r\n'
    file = root / "demo" / "launch" / "odd.launch"
    file.write_bytes(b"\xef\xbb\xbf" + text.encode())

    async def session(client: Client, root: Path) -> None:
        uri = client.open(file, text)
        found = [each for each in await client.settled(uri) if each.code == "LL206"]
        before = text.split("\r\n")[1].partition('unused"')[0]
        width = len(before.encode()) if unit == types.PositionEncodingKind.Utf8 else len(before.encode("utf-16-le")) // 2
        assert [(each.range.start.line, each.range.start.character) for each in found] == [(1, width)]

    converse(root, session, [unit])


def test_what_is_saved_elsewhere_counts(root: Path) -> None:
    async def session(client: Client, root: Path) -> None:
        uri = client.open(root / "demo" / "launch" / "main.launch")
        await client.settled(uri)
        part = root / "demo" / "launch" / "part.launch"
        part.write_text("<launch/>\n", encoding="utf-8")
        client.workspace_did_change_watched_files(
            types.DidChangeWatchedFilesParams([types.FileEvent(part.as_uri(), types.FileChangeType.Changed)])
        )
        for _ in range(600):
            if "LL203" in [each.code for each in client.diagnostics[uri]] or len(client.diagnostics[uri]) > 2:
                break
            await asyncio.sleep(0.1)
        assert any("rate" in each.message for each in client.diagnostics[uri])
        client.text_document_did_close(types.DidCloseTextDocumentParams(types.TextDocumentIdentifier(uri)))

    converse(root, session)
