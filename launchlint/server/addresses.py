"""Between addresses (file:///…) and names of files."""

from __future__ import annotations

import os
from urllib.parse import quote, unquote, urlsplit


def path_of(address: str) -> str | None:
    """The absolute name of the file at ``address``; None where it is no file (a text that has no name yet)."""
    parts = urlsplit(address)
    if parts.scheme != "file":
        return None
    return os.path.normpath(unquote(parts.path, errors="surrogateescape"))


def address_of(path: str) -> str:
    """The address of an absolute file name."""
    return "file://" + quote(path.encode("utf-8", "surrogateescape"), safe="/-._~")
