"""The YAML in a ``<rosparam>``, moved as a whole to where its element stands."""

from __future__ import annotations

import re

from launchlint.syntax.ros1.substitutions import opens

_BLANK = " \n"
_NOT_FREE = re.compile(r"^[ ]*(?:\t|---|\.\.\.|%)|[|>][-+0-9]*[ ]*(?:#.*)?$|[&\t]", re.MULTILINE)
"""What may change with its column, or say so: tabs, marks of documents, texts of several lines, and references of XML."""


def indented(text: str, column: int, closing: int) -> str:
    """``text``, all between the two tags, with its keys at ``column`` and what follows its last line end, the end tag, at ``closing``.

    All lines move by the same number of blanks, and YAML reads the same afterwards; where that cannot be, ``text`` as it is.
    """
    first, *lines = text.split("\n")
    if first.strip(_BLANK) or not lines or _NOT_FREE.search(text) is not None or opens(text):
        return text
    depths = [len(line) - len(line.lstrip(" ")) for line in lines]
    keys = [depth for line, depth in zip(lines, depths, strict=True) if line.strip(_BLANK) and not line.lstrip(" ").startswith("#")]
    if not keys:
        return text
    by = column - min(keys)
    if any(depth + by < 0 for line, depth in zip(lines, depths, strict=True) if line.strip(_BLANK)):
        return text
    moved = [" " * (depth + by) + line[depth:] if line.strip(_BLANK) else line for line, depth in zip(lines, depths, strict=True)]
    if not lines[-1].strip(_BLANK):
        moved[-1] = " " * closing
    result = "\n".join([first, *moved])
    return result if result == text or _is_same(text, result) else text


def unindented(text: str) -> str:
    """``text`` without the blanks that all its lines begin with, and those before the end tag: equal for texts that a move tells apart."""
    first, *lines = text.split("\n")
    if first.strip(_BLANK) or not lines or _NOT_FREE.search(text) is not None:
        return text
    depth = min((len(line) - len(line.lstrip(" ")) for line in lines if line.strip(_BLANK)), default=0)
    free = [line[depth:] if line.strip(_BLANK) else line for line in lines]
    if not lines[-1].strip(_BLANK):
        free[-1] = ""
    return "\n".join([first, *free])


def _is_same(one: str, other: str) -> bool:
    from launchlint.evaluate.ros1.rosparam import YamlError, YamlUnknown, load

    try:
        before, after = load(one, unroll=False), load(other, unroll=False)
    except (YamlError, YamlUnknown):
        return False
    return repr(before.data) == repr(after.data)
