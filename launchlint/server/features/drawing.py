"""The topology beside the text: requests of launchlint's own, for editors that can show a page.

``launchlint/topology`` gives the page of a file, ``launchlint/topologyAt`` what of it is written at a position, and
``launchlint/topologyPlace`` where something on it is written. After the first of them, ``launchlint/topologyChanged`` says whenever the
page would be another one.
"""

from __future__ import annotations

from typing import Any

from lsprotocol import types

from launchlint.errors import LaunchlintError
from launchlint.ide.drawing import Shown, place_of, shown_at
from launchlint.server.analysis import in_deep_thread
from launchlint.server.service import Service

TOPOLOGY = "launchlint/topology"
AT = "launchlint/topologyAt"
PLACE = "launchlint/topologyPlace"


def register(server: Service) -> None:
    """Draw."""

    @server.feature(TOPOLOGY)
    async def topology(params: Any) -> dict[str, str] | None:
        """``{textDocument: {uri}}`` → ``{title, html}``; null where the file is not open, or no launch file."""
        document = server.document(str(params.textDocument.uri))
        ready = None if document is None else await server.up_to_date(document)
        if document is None or ready is None:
            return None
        wanted = ready.drawing.of(document.file)
        if wanted is None:
            return None
        server.watch_drawing(document)
        from launchlint.project.drawn import page_of  # of no use before somebody wants to see a page

        try:
            html = await in_deep_thread(lambda: page_of(wanted))
        except LaunchlintError as error:
            server.say(str(error))
            return None
        return {"title": wanted.request.at.rpartition("/")[2], "html": html}

    @server.feature(AT)
    async def at(params: Any) -> dict[str, str] | None:
        """``{textDocument: {uri}, position}`` → ``{kind, name}``, or null."""
        found = await server.view_at_once(str(params.textDocument.uri))
        if found is None:
            return None
        document, view = found
        position = types.Position(int(params.position.line), int(params.position.character))
        shown = shown_at(view, document.lines.offset(position))
        return None if shown is None else {"kind": shown.kind, "name": shown.name}

    @server.feature(PLACE)
    async def place(params: Any) -> types.Location | None:
        """``{textDocument: {uri}, kind, name}`` → a location, or null."""
        found = await server.view_at_once(str(params.textDocument.uri))
        target = None if found is None else place_of(found[1], Shown(str(params.kind), str(params.name)))
        return None if target is None else server.documents.location(target)
