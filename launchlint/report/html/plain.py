"""Text from files that others wrote, made fit for the page: nothing invisible, nothing endless, nothing of this machine."""

from __future__ import annotations

import re
from collections.abc import Sequence

from launchlint.report.escape import visible

LONGEST_NAME = 400
"""Characters of a name that are shown."""
LONGEST_TEXT = 2_000
"""Characters of a message or value that are shown."""
LONGEST_LINE = 400
"""Characters of a source line that are shown."""


class Plain:
    """Makes text plain. ``roots`` are directories of this machine, absolute, with what is shown in their place."""

    def __init__(self, roots: Sequence[tuple[str, str]] = ()) -> None:
        self._shown = {root.rstrip("/"): instead for root, instead in roots if root.strip("/")}
        longest_first = sorted(self._shown, key=lambda root: (-len(root), root))
        # A root counts as a whole path only: /ws does not stand in /home/ws, nor in /ws2.
        pattern = rf"(?<![\w.~/-])(?:{'|'.join(map(re.escape, longest_first))})(?![\w.-])"
        self._roots = re.compile(pattern) if longest_first else None
        self._names: dict[str, str] = {}
        self._texts: dict[str, str] = {}

    def name(self, text: str) -> str:
        """A name on the graph, or a word such as a type: as :func:`visible`, and cut where it is endless."""
        known = self._names.get(text)
        if known is None:
            known = self._names[text] = visible(_cut(text, LONGEST_NAME))
        return known

    def text(self, text: str) -> str:
        """Words for people, a value or a path."""
        known = self._texts.get(text)
        if known is None:
            shown = text
            if self._roots is not None and "/" in text:
                shown = self._roots.sub(lambda match: self._shown[match[0]], text)
            known = self._texts[text] = visible(_cut(shown, LONGEST_TEXT))
        return known

    def path(self, text: str) -> str:
        """The path of a file."""
        shown = self.text(text)
        return shown.removeprefix("./")

    @staticmethod
    def line(text: str) -> str:
        """A source line: each character is still one, tabs stay, what is invisible is U+FFFD; cut where it is endless."""
        text = _cut(text, LONGEST_LINE)
        return text if text.isprintable() else "".join(each if each.isprintable() or each in "\t\u3000" else "\ufffd" for each in text)


def _cut(text: str, longest: int) -> str:
    return text if len(text) <= longest else f"{text[: longest - 1]}…"
