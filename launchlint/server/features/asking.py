"""Hover, definition, references, highlights, links, renaming."""

from __future__ import annotations

from lsprotocol import types
from pygls.exceptions import JsonRpcInvalidParams

from launchlint.ide import hover as saying
from launchlint.ide import navigation
from launchlint.server.addresses import address_of
from launchlint.server.service import Service


def register(server: Service) -> None:
    """Answer what is asked about a word."""

    @server.feature(types.TEXT_DOCUMENT_HOVER)
    async def hover(params: types.HoverParams) -> types.Hover | None:
        found = await server.view(params.text_document.uri)
        if found is None:
            return None
        document, view = found
        said = saying.hover(view, document.lines.offset(params.position))
        if said is None:
            return None
        able = server.client_capabilities.text_document
        kinds = None if able is None or able.hover is None else able.hover.content_format
        return types.Hover(server.markup(kinds, said.markdown), document.lines.range(said.span))

    @server.feature(types.TEXT_DOCUMENT_DEFINITION)
    async def definition(params: types.DefinitionParams) -> list[types.Location]:
        found = await server.view(params.text_document.uri)
        if found is None:
            return []
        document, view = found
        return [server.documents.location(each) for each in navigation.definition(view, document.lines.offset(params.position))]

    @server.feature(types.TEXT_DOCUMENT_REFERENCES)
    async def references(params: types.ReferenceParams) -> list[types.Location]:
        found = await server.view(params.text_document.uri, whole=True)
        if found is None:
            return []
        document, view = found
        offset = document.lines.offset(params.position)
        targets = navigation.references(view, offset, declaration=params.context.include_declaration)
        return [server.documents.location(each) for each in targets]

    @server.feature(types.TEXT_DOCUMENT_DOCUMENT_HIGHLIGHT)
    async def highlight(params: types.DocumentHighlightParams) -> list[types.DocumentHighlight]:
        found = await server.view_at_once(params.text_document.uri)
        if found is None:
            return []
        document, view = found
        kinds = {True: types.DocumentHighlightKind.Write, False: types.DocumentHighlightKind.Read}
        return [
            types.DocumentHighlight(document.lines.range(each.target.span), kinds[each.declares])
            for each in navigation.highlights(view, document.lines.offset(params.position))
        ]

    @server.feature(types.TEXT_DOCUMENT_DOCUMENT_LINK, types.DocumentLinkOptions())
    async def links(params: types.DocumentLinkParams) -> list[types.DocumentLink]:
        found = await server.view_at_once(params.text_document.uri)
        if found is None:
            return []
        document, view = found
        return [types.DocumentLink(document.lines.range(each.span), address_of(each.file)) for each in navigation.links(view)]

    @server.feature(types.TEXT_DOCUMENT_PREPARE_RENAME)
    async def prepare_rename(params: types.PrepareRenameParams) -> types.Range | None:
        found = await server.view(params.text_document.uri)
        if found is None:
            return None
        document, view = found
        span = navigation.renamable(view, document.lines.offset(params.position))
        return None if span is None else document.lines.range(span)

    @server.feature(types.TEXT_DOCUMENT_RENAME, types.RenameOptions(prepare_provider=True))
    async def rename(params: types.RenameParams) -> types.WorkspaceEdit | None:
        found = await server.view(params.text_document.uri, whole=True)
        if found is None:
            return None
        document, view = found
        try:
            changes = navigation.rename(view, document.lines.offset(params.position), params.new_name)
        except ValueError as error:
            raise JsonRpcInvalidParams(str(error)) from error
        edits: dict[str, list[types.TextEdit]] = {}
        for change in changes:
            file = change.target.file
            range_ = server.documents.lines(file).range(change.target.span)
            edits.setdefault(server.documents.address(file), []).append(types.TextEdit(range_, change.text))
        return types.WorkspaceEdit(changes=edits)
