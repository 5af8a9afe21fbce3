"""How large the internal entities of a file would become, found out before any parser expands them.

expat guards itself against entity bombs only since version 2.4, and against stack overflow by long chains of
entities only since 2.7. So the declarations are read from the text first, by a scan that may count too much but never too little.
"""

from __future__ import annotations

import re

from launchlint.late import late
from launchlint.named_tuple import NamedTuple

MAX_EXPANSION = 8 * 1024 * 1024
"""Characters that all references of a file may expand to (expat's own activation threshold)."""

MAX_NESTING = 50
"""How deep entities may refer to each other."""

_DECLARATION = late(r"""<!ENTITY[ \t\r\n]+(?:%[ \t\r\n]+)?([^ \t\r\n"'<>&;%]+)[ \t\r\n]+(?:"([^"]*)"|'([^']*)')""")
_REFERENCE = late(r"&([^;&<\s#\"']+);")
_AMPERSAND = late(r"&#(?:38|x0*26);", re.IGNORECASE)
_HUGE = 1 << 62


class Expansion(NamedTuple):
    """What :func:`expansion` found.

    ``size``: characters that all references of the text become; ``too_deep``: more than MAX_NESTING entities in each
    other; ``first``: offset of the first declaration.
    """

    size: int
    too_deep: bool
    first: int


def expansion(text: str) -> Expansion:
    """Measure the entities declared in ``text``."""
    own: dict[str, int] = {}
    uses: dict[str, list[str]] = {}
    first = text.find("<!ENTITY")
    for match in _DECLARATION.finditer(text):
        value = match[2] if match[2] is not None else match[3]
        # "&#38;name;" in a declaration is "&name;" once it is used.
        value = _AMPERSAND.sub("&", value)
        name = match[1]
        own[name] = max(own.get(name, 0), len(value))
        uses.setdefault(name, []).extend(_REFERENCE.findall(value))
    sizes: dict[str, int] = {}
    depths: dict[str, int] = {}
    for name in own:
        _measure(name, own, uses, sizes, depths)
    total = 0
    for name in _REFERENCE.findall(text):
        total += sizes.get(name, 0)
    deepest = max(depths.values(), default=0)
    return Expansion(min(total, _HUGE), deepest > MAX_NESTING, first)


def _measure(name: str, own: dict[str, int], uses: dict[str, list[str]], sizes: dict[str, int], depths: dict[str, int]) -> None:
    """Fill ``sizes`` and ``depths`` for ``name`` and all it needs, without recursion. A cycle counts once: expat refuses it."""
    stack = [(name, False)]
    entered: set[str] = set()
    while stack:
        current, done = stack.pop()
        if current in sizes:
            continue
        if done:
            used = uses[current]
            sizes[current] = min(_HUGE, own[current] + sum(sizes.get(other, 0) for other in used))
            depths[current] = 1 + max((depths.get(other, 0) for other in used), default=0)
            continue
        if current in entered:
            continue
        entered.add(current)
        stack.append((current, True))
        stack.extend((other, False) for other in set(uses[current]) if other in own and other not in sizes)
