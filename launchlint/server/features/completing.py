"""Completion."""

from __future__ import annotations

from lsprotocol import types

from launchlint.ide.completion import Choice
from launchlint.ide.completion import completion as choices
from launchlint.ide.documentation import documentation
from launchlint.server.documents import Document
from launchlint.server.service import Service

MOST = 1_000
_KINDS = {
    "tag": types.CompletionItemKind.Class,
    "attribute": types.CompletionItemKind.Property,
    "value": types.CompletionItemKind.EnumMember,
    "package": types.CompletionItemKind.Module,
    "executable": types.CompletionItemKind.Function,
    "file": types.CompletionItemKind.File,
    "arg": types.CompletionItemKind.Variable,
    "substitution": types.CompletionItemKind.Keyword,
    "name": types.CompletionItemKind.Interface,
    "param": types.CompletionItemKind.Field,
}


def register(server: Service) -> None:
    """Say what may be written."""

    @server.feature(
        types.TEXT_DOCUMENT_COMPLETION,
        types.CompletionOptions(trigger_characters=["<", '"', "'", "(", " ", "/", "$"], resolve_provider=True),
    )
    async def completion(params: types.CompletionParams) -> types.CompletionList:
        found = await server.view_at_once(params.text_document.uri)
        if found is None:
            return types.CompletionList(is_incomplete=True, items=[])
        document, view = found
        able = server.client_capabilities.text_document
        items = None if able is None or able.completion is None else able.completion.completion_item
        snippets = bool(items is not None and items.snippet_support)
        offered = choices(view, document.lines.offset(params.position))
        return types.CompletionList(
            is_incomplete=len(offered) > MOST,
            items=[_item(each, document, number, snippets=snippets) for number, each in enumerate(offered[:MOST])],
        )

    @server.feature(types.COMPLETION_ITEM_RESOLVE)
    async def resolve(item: types.CompletionItem) -> types.CompletionItem:
        """With what is said of it, which is worked out for what somebody looks at alone."""
        given = item.data if isinstance(item.data, dict) else {}
        found = await server.view_at_once(str(given.get("uri", "")))
        if found is not None and item.documentation is None:
            said = documentation(found[1], str(given.get("what", "")), item.label, item.detail or "")
            able = server.client_capabilities.text_document
            items = None if able is None or able.completion is None else able.completion.completion_item
            item.documentation = server.markup(None if items is None else items.documentation_format, said) if said else None
        return item


def _item(choice: Choice, document: Document, number: int, *, snippets: bool) -> types.CompletionItem:
    as_snippet = choice.snippet and snippets
    text = choice.text if as_snippet or not choice.snippet else choice.label
    return types.CompletionItem(
        choice.label,
        kind=_KINDS[choice.what],
        detail=choice.detail or None,
        sort_text=f"{choice.rank}{number:05}",
        filter_text=choice.label,
        insert_text_format=types.InsertTextFormat.Snippet if as_snippet else types.InsertTextFormat.PlainText,
        text_edit=types.TextEdit(document.lines.range(choice.span), text),
        data={"uri": document.address, "what": choice.what},
    )
