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
ALL = "Fix all that launchlint can for certain"


def register(server: Service) -> None:
    """Offer what can be done about findings."""

    @server.feature(
        types.TEXT_DOCUMENT_CODE_ACTION,
        types.CodeActionOptions(code_action_kinds=[types.CodeActionKind.QuickFix, FIX_ALL], resolve_provider=True),
    )
    async def actions(params: types.CodeActionParams) -> list[types.CodeAction]:
        found = await server.view(params.text_document.uri)
        if found is None:
            return []
        document, view = found
        findings = server.findings(document)
        span = document.lines.span(params.range)
        wanted = params.context.only
        made = []
        if wanted is None or any(str(types.CodeActionKind.QuickFix.value).startswith(_word(kind)) for kind in wanted):
            offered = repair.actions(view, findings, span.start, span.end)
            proved = [each for each in offered if not each.fixes or await server.is_proved(document, each.findings[0])]
            made += [_action(server, view, document, each) for each in proved]
        if (wanted is None or any(FIX_ALL.startswith(_word(kind)) for kind in wanted)) and repair.has_safe(view, findings):
            everything = types.CodeAction(ALL, kind=FIX_ALL, data={"uri": document.address, "version": document.version})
            # Whoever asks for it alone is about to do it; a menu need not wait for what may never be chosen.
            made.append(await resolve(everything) if wanted is not None or not _resolves(server) else everything)
        return [each for each in made if each.edit is not None or each.data is not None]

    @server.feature(types.CODE_ACTION_RESOLVE)
    async def resolve(action: types.CodeAction) -> types.CodeAction:
        given = action.data if isinstance(action.data, dict) else {}
        document = server.document(str(given.get("uri", "")))
        if document is not None and document.version == given.get("version"):
            edits = await server.repaired(document)
            action.data = None
            if edits:
                changes = [types.TextEdit(document.lines.range(each.span), each.text) for each in edits]
                action.edit = types.WorkspaceEdit(changes={document.address: changes})
        return action

    @server.feature(types.TEXT_DOCUMENT_FORMATTING)
    async def formatting(params: types.DocumentFormattingParams) -> list[types.TextEdit]:
        return await _formatted(server, params.text_document.uri, None)

    @server.feature(types.TEXT_DOCUMENT_RANGE_FORMATTING)
    async def range_formatting(params: types.DocumentRangeFormattingParams) -> list[types.TextEdit]:
        return await _formatted(server, params.text_document.uri, params.range)


def _resolves(server: Service) -> bool:
    """Whether the client asks for the edit of an action when it is chosen."""
    able = server.client_capabilities.text_document
    actions = None if able is None else able.code_action
    return actions is not None and actions.resolve_support is not None and "edit" in actions.resolve_support.properties


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


def _action(server: Service, view: View, document: Document, action: repair.Action) -> types.CodeAction:
    return types.CodeAction(
        title=action.title,
        kind=types.CodeActionKind.QuickFix,
        diagnostics=_diagnostics(server, view, action.findings),
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
