"""Code actions and formatting."""

from __future__ import annotations

from lsprotocol import types

from launchlint.finding import Edit, Finding
from launchlint.ide import repair
from launchlint.ide.view import View
from launchlint.server.diagnostics import diagnostic
from launchlint.server.documents import Document
from launchlint.server.service import Service
from launchlint.source import Span

FIX_ALL = "source.fixAll.launchlint"


def register(server: Service) -> None:
    """Offer what can be done about findings."""

    @server.feature(
        types.TEXT_DOCUMENT_CODE_ACTION,
        types.CodeActionOptions(code_action_kinds=[types.CodeActionKind.QuickFix, FIX_ALL]),
    )
    async def actions(params: types.CodeActionParams) -> list[types.CodeAction]:
        found = await server.view(params.text_document.uri)
        if found is None:
            return []
        document, view = found
        findings = server.findings(document)
        span = document.lines.span(params.range)
        wanted = params.context.only
        made = [
            _action(server, view, document, each, types.CodeActionKind.QuickFix)
            for each in repair.actions(view, findings, span.start, span.end)
            if wanted is None or any(str(types.CodeActionKind.QuickFix.value).startswith(_word(kind)) for kind in wanted)
        ]
        if wanted is None or any(FIX_ALL.startswith(_word(kind)) for kind in wanted):
            everything = repair.all_safe(view, findings)
            if everything is not None:
                made.append(_action(server, view, document, everything, FIX_ALL))
        return made

    @server.feature(types.TEXT_DOCUMENT_FORMATTING)
    async def formatting(params: types.DocumentFormattingParams) -> list[types.TextEdit]:
        return await _formatted(server, params.text_document.uri, None)

    @server.feature(types.TEXT_DOCUMENT_RANGE_FORMATTING)
    async def range_formatting(params: types.DocumentRangeFormattingParams) -> list[types.TextEdit]:
        return await _formatted(server, params.text_document.uri, params.range)


def _word(kind: types.CodeActionKind | str) -> str:
    return kind.value if isinstance(kind, types.CodeActionKind) else kind


async def _formatted(server: Service, address: str, within: types.Range | None) -> list[types.TextEdit]:
    found = await server.view_at_once(address)
    if found is None:
        return []
    document, view = found
    edits = repair.format_edits(view)
    if within is not None:
        asked = document.lines.span(within)
        edits = [each for each in edits if each.span.start <= asked.end and asked.start <= each.span.end]
    return [types.TextEdit(document.lines.range(each.span), each.text) for each in edits]


def _action(server: Service, view: View, document: Document, action: repair.Action, kind: types.CodeActionKind | str) -> types.CodeAction:
    return types.CodeAction(
        title=action.title,
        kind=kind,
        diagnostics=_diagnostics(server, view, action.findings) if kind != FIX_ALL else None,
        is_preferred=(action.safe and action.fixes) or None,
        edit=types.WorkspaceEdit(changes=_changes(server, view, action.edits)),
    )


def _diagnostics(server: Service, view: View, findings: tuple[Finding, ...]) -> list[types.Diagnostic]:
    return [diagnostic(each, server.documents, view.snapshot.session) for each in findings]


def _changes(server: Service, view: View, edits: tuple[Edit, ...]) -> dict[str, list[types.TextEdit]]:
    found: dict[str, list[types.TextEdit]] = {}
    for edit in edits:
        file = view.session.named(edit.path)
        range_ = server.documents.lines(file).range(Span(edit.start, edit.end))
        found.setdefault(server.documents.address(file), []).append(types.TextEdit(range_, edit.text))
    return found
