"""``launchlint server``."""

from __future__ import annotations

import click

from launchlint.errors import UsageError


@click.command("server")
@click.option("--stdio", is_flag=True, help="Speak over standard input and output; this is the default.")
@click.option("--tcp", type=click.IntRange(1, 65535), metavar="PORT", help="Listen on this port of 127.0.0.1 instead.")
def command(stdio: bool, tcp: int | None) -> int:
    """Serve an editor: what check would say while you type, and answers to what you ask of a word.

    Speaks the Language Server Protocol. Nothing from the opened files is executed.
    """
    if stdio and tcp is not None:
        raise UsageError("--stdio and --tcp exclude each other")
    try:
        from launchlint.server.start import serve
    except ImportError as error:
        if error.name is None or error.name.partition(".")[0] not in ("pygls", "lsprotocol", "attrs", "attr", "cattrs"):
            raise
        raise UsageError("the server needs pygls: pip install 'launchlint[server]'") from error
    serve(tcp)
    return 0
