"""How long the language server takes.

    python -m tests.bench.server [--launch-files N]

One server in a process of its own, spoken to as an editor does. Keystroke → diagnostics: a letter is typed into a comment, an attribute's
value and a tag's name, in turn, and the time taken until the server has looked at that text. For launch files of 1, 50 and 300 nodes; wall
milliseconds, and those of the server's processor, which other work on the machine does not change.
"""

from __future__ import annotations

import argparse
import asyncio
import statistics
import tempfile
import time
from collections.abc import Awaitable, Callable
from pathlib import Path
from typing import NamedTuple

from lsprotocol import types

from tests.server.client import Client, connected

SIZES = (1, 50, 300)
KEYS = 40
PACKAGE = """<package format="2"><name>demo</name><version>1.0.0</version><description>A demo.</description>
<maintainer email="a@example.com">A</maintainer><license>MIT</license><exec_depend>turtlesim</exec_depend></package>
"""


def launch_file(nodes: int) -> str:
    """A launch file of that many nodes, each in a namespace, with a param and a remap; two args switch a third of them."""
    body = "".join(
        f"""  <group ns="robot{number}"{' if="$(arg sim)"' if number % 3 == 1 else ""}>
    <node name="turtle" pkg="turtlesim" type="turtlesim_node" output="screen">
      <param name="background_r" value="$(arg red)"/>
      <remap from="turtle1/cmd_vel" to="cmd_vel"/>
    </node>
  </group>
"""
        for number in range(nodes)
    )
    return f'<launch>\n  <!-- words -->\n  <arg name="sim" default="true"/>\n  <arg name="red" default="10"/>\n{body}</launch>\n'


def workspace(directory: Path, files: int) -> None:
    """Write the launch files that are measured, and as many small ones beside them."""
    (directory / ".git").mkdir()
    (directory / "launch").mkdir()
    (directory / "package.xml").write_text(PACKAGE, encoding="utf-8")
    for nodes in SIZES:
        (directory / "launch" / f"of_{nodes}.launch").write_text(launch_file(nodes), encoding="utf-8")
    for number in range(files):
        (directory / "launch" / f"other{number}.launch").write_text(launch_file(1), encoding="utf-8")


class Times(NamedTuple):
    """Milliseconds: what a clock shows, and what the server's processor worked."""

    wall: list[float]
    processor: list[float]


def processor(client: Client) -> float:
    """Milliseconds that the server has worked."""
    assert client._server is not None
    threads = Path(f"/proc/{client._server.pid}/task").glob("*/schedstat")
    return sum(int(each.read_text(encoding="ascii").split()[0]) for each in threads) / 1e6


async def timed(client: Client, work: Callable[[], Awaitable[object]], times: int) -> Times:
    """How long each call takes."""
    found = Times([], [])
    for _ in range(times):
        start, worked = time.perf_counter(), processor(client)
        await work()
        found.wall.append(1000 * (time.perf_counter() - start))
        found.processor.append(processor(client) - worked)
    return found


def told(name: str, times: Times) -> None:
    """One line: median and 95th percentile of either."""
    columns = [f"{statistics.median(each):9.1f} {sorted(each)[int(0.95 * (len(each) - 1))]:9.1f}" for each in times]
    print(f"{name:40} {' '.join(columns)}", flush=True)


async def first(client: Client, path: Path) -> str:
    """Open a file, and wait for its first diagnostics."""
    uri = client.open(path)
    while uri not in client.diagnostics:
        await asyncio.sleep(0.002)
    return uri


async def typed(client: Client, uri: str, number: int) -> None:
    """Type a letter, and wait until the diagnostics of that text are here."""
    line, character = ((1, 8), (3, 28), (1, 9))[number % 3]
    version = client.versions[uri] + 1
    client.type(uri, line, character, "x" if number % 3 != 1 else "1")
    if number % 3 == 1:  # what is found changes, so that it is told; else nothing is, and an answer says that the text was looked at
        while not any(each.uri == uri and each.version == version for each in client.told[-20:]):
            await asyncio.sleep(0.001)
            if await client.settled(uri) is not None:
                return
    await client.settled(uri)


async def measure(files: int) -> None:
    """All of it."""
    with tempfile.TemporaryDirectory() as name:
        directory = Path(name)
        workspace(directory, files)
        print(f"{'milliseconds':40} {'median':>9} {'95 %':>9} {'processor':>9} {'95 %':>9}")
        for nodes in SIZES:
            path = directory / "launch" / f"of_{nodes}.launch"
            starts = Times([], [])
            for _ in range(3):
                start = time.perf_counter()
                async with connected(directory) as client:
                    await first(client, path)
                    starts.wall.append(1000 * (time.perf_counter() - start))
                    starts.processor.append(processor(client))
            told(f"start to first diagnostics, {nodes} nodes", starts)
            async with connected(directory) as client:
                uri = await first(client, path)
                await client.settled(uri)
                if files:
                    await asyncio.sleep(files / 40)
                numbers = iter(range(KEYS))
                told(
                    f"keystroke to diagnostics, {nodes} nodes",
                    await timed(client, lambda c=client, u=uri, n=numbers: typed(c, u, next(n)), KEYS),
                )
                await asks(client, uri, nodes)
                if client._server is not None:
                    status = Path(f"/proc/{client._server.pid}/status").read_text(encoding="ascii")
                    memory = next(line.split()[1] for line in status.splitlines() if line.startswith("VmRSS"))
                    print(f"memory, {nodes} nodes and {files} other files: {int(memory) // 1024} MB")


async def asks(client: Client, uri: str, nodes: int) -> None:
    """What people ask, in the last node of the file."""
    named = types.TextDocumentIdentifier(uri)
    line = 4 + 6 * (nodes - 1) + 1
    node, remap = types.Position(line, 40), types.Position(line + 2, 22)
    arg = types.Position(line + 1, 48)
    told(f"hover, {nodes} nodes", await timed(client, lambda: client.text_document_hover_async(types.HoverParams(named, node)), 10))
    told(
        f"definition, {nodes} nodes",
        await timed(client, lambda: client.text_document_definition_async(types.DefinitionParams(named, arg)), 10),
    )
    told(
        f"completion, {nodes} nodes",
        await timed(client, lambda: client.text_document_completion_async(types.CompletionParams(named, remap)), 10),
    )


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--launch-files", type=int, default=0, help="small launch files that lie beside those that are measured")
    asyncio.run(measure(parser.parse_args().launch_files))
