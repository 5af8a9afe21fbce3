"""Regular expressions that are compiled when they are first used.

To compile one takes as long as to import a small module, and a check of one file needs few of those that the rules have.
"""

from __future__ import annotations

import re

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

_METHODS = ("search", "match", "fullmatch", "finditer", "findall", "split", "sub", "subn", "pattern", "flags", "groups", "groupindex")


class _Late:
    def __init__(self, text: str, flags: int) -> None:
        self._late = text, flags

    def __getattr__(self, name: str) -> Any:
        compiled = re.compile(*self._late)
        self.__dict__.update((each, getattr(compiled, each)) for each in _METHODS)
        return getattr(compiled, name)


if TYPE_CHECKING:
    late = re.compile
else:

    def late(text: str, flags: int = 0) -> _Late:
        """As :func:`re.compile`; what is wrong with ``text`` shows at the first use."""
        return _Late(text, flags)
