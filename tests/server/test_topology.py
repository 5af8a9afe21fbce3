"""The topology beside the text: drawn by the server, following cursor and keystrokes."""

from __future__ import annotations

import asyncio
from pathlib import Path
from typing import Any

import pytest

from tests.server.client import Client
from tests.server.test_requests import converse, place
from tests.server.workspace import MAIN, make


@pytest.fixture
def root(tmp_path: Path) -> Path:
    return make(tmp_path / "ws")


def test_the_topology_follows_cursor_and_keystrokes(root: Path) -> None:
    converse(root, _followed)


async def _followed(client: Client, root: Path) -> None:
    uri = client.open(root / "demo" / "launch" / "main.launch")
    named = {"textDocument": {"uri": uri}}
    heard: list[str] = []

    @client.feature("launchlint/topologyChanged")
    def changed(params: Any) -> None:
        heard.append(params.uri)

    async def drawn() -> Any:
        for _ in range(6):  # a busy machine may lose its patience
            found = await client.protocol.send_request_async("launchlint/topology", named)
            if found is not None:
                return found
        raise AssertionError("nothing was drawn")

    await client.settled(uri)
    page = await drawn()
    assert page.title == "main.launch"
    assert "<!DOCTYPE html>" in page.html[:20]
    assert "/teleop" in page.html
    assert heard == []

    async def at(word: str) -> tuple[str, str] | None:
        position = place(MAIN, word)
        asked = {**named, "position": {"line": position.line, "character": position.character}}
        found = await client.protocol.send_request_async("launchlint/topologyAt", asked)
        return None if found is None else (found.kind, found.name)

    assert await at("<rosparam") == ("node", "/turtle")
    assert await at('default="true"') is None
    asked = {**named, "kind": "node", "name": "/teleop"}
    where = await client.protocol.send_request_async("launchlint/topologyPlace", asked)
    assert (where.uri, where.range.start.line) == ((root / "demo" / "launch" / "part.launch").as_uri(), 2)
    asked = {**named, "kind": "topic", "name": "/turtle1/pose"}
    where = await client.protocol.send_request_async("launchlint/topologyPlace", asked)
    assert (where.uri, where.range.start.line) == (uri, 6)
    asked = {**named, "kind": "node", "name": "/nobody"}
    assert await client.protocol.send_request_async("launchlint/topologyPlace", asked) is None

    client.type(uri, 6, MAIN.split("\n")[6].index("turtle"), "sea_")
    await client.settled(uri)
    for _ in range(600):
        if heard:
            break
        await asyncio.sleep(0.1)
    assert set(heard) == {uri}
    assert "/sea_turtle" in (await drawn()).html
    assert "LL301" not in {each.code for each in client.diagnostics[uri]}


def test_what_is_no_open_launch_file_has_no_topology(root: Path) -> None:
    async def session(client: Client, root: Path) -> None:
        named = {"textDocument": {"uri": (root / "demo" / "launch" / "main.launch").as_uri()}}
        assert await client.protocol.send_request_async("launchlint/topology", named) is None

    converse(root, session)
