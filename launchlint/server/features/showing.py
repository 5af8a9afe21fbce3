"""Symbols, folding, selections, hints, lenses, and who includes whom."""

from __future__ import annotations

import os

from lsprotocol import types

from launchlint.ide import calls, hints, outline
from launchlint.server.addresses import path_of
from launchlint.server.documents import Document
from launchlint.server.service import Service
from launchlint.source import Span

_SYMBOLS = {
    "node": types.SymbolKind.Object,
    "arg": types.SymbolKind.Variable,
    "include": types.SymbolKind.Module,
    "group": types.SymbolKind.Namespace,
    "param": types.SymbolKind.Property,
    "remap": types.SymbolKind.Interface,
    "machine": types.SymbolKind.Constant,
    "file": types.SymbolKind.File,
    "topic": types.SymbolKind.Event,
    "other": types.SymbolKind.Null,
}


def register(server: Service) -> None:
    """Show the shape of files, and what they amount to."""

    @server.feature(types.TEXT_DOCUMENT_DOCUMENT_SYMBOL)
    async def symbols(params: types.DocumentSymbolParams) -> list[types.DocumentSymbol]:
        found = await server.view_at_once(params.text_document.uri)
        return [] if found is None else [_symbol(found[0], each) for each in outline.symbols(found[1])]

    @server.feature(types.WORKSPACE_SYMBOL)
    async def workspace_symbols(params: types.WorkspaceSymbolParams) -> list[types.WorkspaceSymbol]:
        return [
            types.WorkspaceSymbol(server.documents.location(each.target), each.name, _SYMBOLS[each.what], container_name=each.container)
            for snapshot in server.snapshots()
            for each in outline.workspace_symbols(snapshot, params.query)
        ]

    @server.feature(types.TEXT_DOCUMENT_FOLDING_RANGE)
    async def folding(params: types.FoldingRangeParams) -> list[types.FoldingRange]:
        found = await server.view_at_once(params.text_document.uri)
        if found is None:
            return []
        document, view = found
        made = []
        for span, comment in outline.folding(view):
            range_ = document.lines.range(span)
            made.append(types.FoldingRange(range_.start.line, range_.end.line, kind=types.FoldingRangeKind.Comment if comment else None))
        return made

    @server.feature(types.TEXT_DOCUMENT_SELECTION_RANGE)
    async def selections(params: types.SelectionRangeParams) -> list[types.SelectionRange]:
        found = await server.view_at_once(params.text_document.uri)
        if found is None:
            return []
        document, view = found
        return [_nested(document, outline.selections(view, document.lines.offset(each))) for each in params.positions]

    @server.feature(types.TEXT_DOCUMENT_LINKED_EDITING_RANGE)
    async def linked(params: types.LinkedEditingRangeParams) -> types.LinkedEditingRanges | None:
        found = await server.view_at_once(params.text_document.uri)
        pair = None if found is None else outline.tag_names(found[1], found[0].lines.offset(params.position))
        return None if found is None or pair is None else types.LinkedEditingRanges([found[0].lines.range(each) for each in pair])

    @server.feature(types.TEXT_DOCUMENT_INLAY_HINT)
    async def inlay(params: types.InlayHintParams) -> list[types.InlayHint]:
        found = await server.view(params.text_document.uri)
        if found is None:
            return []
        document, view = found
        span = document.lines.span(params.range)
        return [types.InlayHint(document.lines.position(each.offset), each.text) for each in hints.hints(view, span.start, span.end)]

    @server.feature(types.TEXT_DOCUMENT_CODE_LENS)
    async def lenses(params: types.CodeLensParams) -> list[types.CodeLens]:
        found = await server.view(params.text_document.uri)
        if found is None:
            return []
        document, view = found
        made = []
        for each in hints.lenses(view):
            command = types.Command(each.text, f"launchlint.{each.command}", arguments=[document.address])
            made.append(types.CodeLens(document.lines.range(each.span), command))
        return made

    @server.feature(types.TEXT_DOCUMENT_PREPARE_CALL_HIERARCHY)
    async def prepare(params: types.CallHierarchyPrepareParams) -> list[types.CallHierarchyItem]:
        found = await server.view(params.text_document.uri)
        return [] if found is None else [_item(server, found[0].file)]

    @server.feature(types.CALL_HIERARCHY_INCOMING_CALLS)
    async def incoming(params: types.CallHierarchyIncomingCallsParams) -> list[types.CallHierarchyIncomingCall]:
        file = path_of(params.item.uri)
        made = []
        for snapshot in server.snapshots():
            for call in calls.incoming(snapshot, file or ""):
                ranges = [server.documents.lines(each.file).range(each.span) for each in call.at]
                made.append(types.CallHierarchyIncomingCall(_item(server, call.file), ranges))
        return made

    @server.feature(types.CALL_HIERARCHY_OUTGOING_CALLS)
    async def outgoing(params: types.CallHierarchyOutgoingCallsParams) -> list[types.CallHierarchyOutgoingCall]:
        file = path_of(params.item.uri)
        made = []
        for snapshot in server.snapshots():
            for call in calls.outgoing(snapshot, file or ""):
                ranges = [server.documents.lines(each.file).range(each.span) for each in call.at]
                made.append(types.CallHierarchyOutgoingCall(_item(server, call.file), ranges))
        return made


def _symbol(document: Document, symbol: outline.Symbol) -> types.DocumentSymbol:
    return types.DocumentSymbol(
        symbol.name or "?",
        _SYMBOLS[symbol.what],
        document.lines.range(symbol.whole),
        document.lines.range(symbol.name_span),
        detail=symbol.detail,
        children=[_symbol(document, each) for each in symbol.children],
    )


def _nested(document: Document, spans: list[Span]) -> types.SelectionRange:
    made: types.SelectionRange | None = None
    for span in reversed(spans):
        made = types.SelectionRange(document.lines.range(span), made)
    assert made is not None
    return made


def _item(server: Service, file: str) -> types.CallHierarchyItem:
    start = types.Range(types.Position(0, 0), types.Position(0, 0))
    return types.CallHierarchyItem(os.path.basename(file), types.SymbolKind.File, server.documents.address(file), start, start)
