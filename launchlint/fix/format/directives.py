"""``<!-- launchlint: format off -->`` and ``<!-- launchlint: format on -->``: what stands between them stays as it is written."""

from __future__ import annotations

import re

from launchlint.fix.format.tokens import Token

_DIRECTIVE = re.compile(r"\s*launchlint\s*:\s*format\s*(?::\s*)?(on|off)\b.*", re.IGNORECASE | re.DOTALL)


def directive(comment: str) -> str:
    """``on`` or ``off`` where the text of a comment (without its brackets) says so, else the empty string."""
    match = _DIRECTIVE.fullmatch(comment)
    return "" if match is None else match[1].lower()


def regions(tokens: list[Token]) -> dict[int, int]:
    """For each token after which formatting is off, the number of the token with which it is on again.

    That is the next ``on`` inside the same element, else the end tag of that element, or the end of the file.
    """
    found: dict[int, int] = {}
    waiting: list[int | None] = [None]  # for each open element the ``off`` that is not ended yet
    for number, token in enumerate(tokens):
        if token.kind == "start":
            waiting.append(None)
        elif token.kind == "end":
            since = waiting.pop()
            if since is not None:
                found[since] = number
        elif token.kind == "comment" and "launchlint" in token.text.lower():
            word = directive(token.text[4:-3])
            if word == "off" and waiting[-1] is None:
                waiting[-1] = number
            elif word == "on" and waiting[-1] is not None:
                found[waiting[-1]] = number
                waiting[-1] = None
    if waiting[0] is not None:
        found[waiting[0]] = len(tokens)
    return found
