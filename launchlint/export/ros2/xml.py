"""A tree of tags as the text of a launch file in XML."""

from __future__ import annotations

import re

from launchlint.export.ros2.scalars import yaml
from launchlint.export.ros2.texts import CannotWrite
from launchlint.export.tree import remark

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Iterable

    from launchlint.export.ros2.tree import Branch, Plain

_FORBIDDEN = re.compile("[^\t\n\r\x20-\ud7ff\ue000-\ufffd\U00010000-\U0010ffff]")
_ESCAPES = {"&": "&amp;", "<": "&lt;", ">": "&gt;", "\n": "&#10;", "\r": "&#13;", "\t": "&#9;"}


def written(root: Branch, step: int = 2) -> str:
    """The whole file. Raises CannotWrite for a character that XML cannot hold."""
    lines: list[str] = []
    _write(root, "", " " * step, lines)
    return "\n".join(lines) + "\n"


def attribute_text(value: Plain, *, typed: bool) -> str:
    """A value as the text of an attribute; ``typed``: launch reads it as YAML. Raises CannotWrite."""
    if typed or isinstance(value, list):
        return yaml(value)
    if isinstance(value, bool):
        return "true" if value else "false"
    return value if isinstance(value, str) else repr(value)


def check(text: str) -> None:
    """Raise CannotWrite where XML has no way to hold ``text``."""
    bad = _FORBIDDEN.search(text)
    if bad is not None:
        raise CannotWrite(f"the character U+{ord(bad[0]):04X} cannot stand in XML")


def _write(branch: Branch, indent: str, step: str, lines: list[str]) -> None:
    _comments(branch.above, indent, lines)
    words = [branch.tag]
    for name, value in branch.attributes.items():
        text = attribute_text(value, typed=name in branch.typed)
        check(text)
        words.append(f"{name}={_quoted(text)}")
    start = f"{indent}<{' '.join(words)}"
    beside = "".join(f" <!-- {remark(each)} -->" for each in branch.beside)
    inner = branch.inner
    if not inner and not branch.below:
        lines.append(f"{start}/>{beside}")
        return
    lines.append(f"{start}>{beside}")
    for each in inner:
        _write(each, indent + step, step, lines)
    _comments(branch.below, indent + step, lines)
    lines.append(f"{indent}</{branch.tag}>")


def _quoted(text: str) -> str:
    """In double quotes, unless single ones save escapes."""
    escaped = "".join(_ESCAPES.get(char, char) for char in text)
    if '"' in escaped and "'" not in escaped:
        return f"'{escaped}'"
    return '"' + escaped.replace('"', "&quot;") + '"'


def _comments(texts: Iterable[str], indent: str, lines: list[str]) -> None:
    for text in texts:
        if not text:
            lines.append("")
            continue
        parts = remark(text).split("\n")
        if len(parts) == 1:
            lines.append(f"{indent}<!-- {parts[0]} -->")
        else:
            lines.append(f"{indent}<!-- {parts[0]}".rstrip())
            lines += [f"{indent}     {each}".rstrip() for each in parts[1:-1]]
            lines.append(f"{indent}     {parts[-1]} -->")
