"""Addresses of lines on the forge."""

from __future__ import annotations

from urllib.parse import quote, urlsplit

from launchlint.errors import UsageError

_PLAIN = "!'()*"
"""What JavaScript's encodeURIComponent leaves as it is, beside letters, digits and ``-_.~``."""


def checked_prefix(text: str, what: str = "--source-url") -> str:
    """The prefix of links that somebody gave, with a slash at its end.

    Raises:
        UsageError: it is no http or https address.
    """
    try:
        parts = urlsplit(text)
        valid = parts.scheme in ("http", "https") and bool(parts.hostname)
    except ValueError:
        valid = False
    if not valid or not text.isascii() or any(character in text for character in "\"'<>\\^`{|} ?#") or not text.isprintable():
        raise UsageError(
            f"{what} {text}: give the http or https address below which the files are, such as https://github.com/OWNER/REPOSITORY/blob/main"
        )
    return text.rstrip("/") + "/"


def source_link(prefix: str, path: str, line: int) -> str:
    """The address of a line; empty where there is none: no prefix, or a file outside of the repository. As ``js/links.js``."""
    if not prefix or path.startswith(("/", "../")):
        return ""
    return f"{prefix}{'/'.join(quote(part, safe=_PLAIN) for part in path.split('/'))}#L{line}"
