"""The server with all its requests, and how it is reached."""

from __future__ import annotations

from launchlint.garbage import left_to_quiet_moments
from launchlint.server.features import asking, completing, drawing, repairing, showing, synchronising
from launchlint.server.service import Service


def made() -> Service:
    """A server that answers everything."""
    server = Service()
    for feature in (synchronising, asking, completing, repairing, showing, drawing):
        feature.register(server)
    return server


def serve(port: int | None = None) -> None:
    """Serve one client over standard input and output, or those that connect to ``port`` of this machine; returns when it ends."""
    server = made()
    with left_to_quiet_moments():
        if port is None:
            server.start_io()
        else:
            server.start_tcp("127.0.0.1", port)
