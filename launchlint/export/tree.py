"""The exported file as a tree, and the text of it."""

from __future__ import annotations

import re
from typing import Union

from launchlint.export.written import CannotExport, Condition

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import TypeAlias

SHORT = 60
"""Characters of YAML that may stand on the line of its tag."""
_FORBIDDEN = re.compile("[^\t\n\r\x20-\ud7ff\ue000-\ufffd\U00010000-\U0010ffff]")
_ESCAPES = {"&": "&amp;", "<": "&lt;", ">": "&gt;", '"': "&quot;", "\n": "&#10;", "\r": "&#13;", "\t": "&#9;"}
_TEXT_ESCAPES = {"&": "&amp;", "<": "&lt;", ">": "&gt;", "\r": "&#13;"}


class Note:
    """A comment: the text between its brackets. ``apart``: a blank line stands before it; ``beside``: it follows in the same line."""

    __slots__ = ("apart", "beside", "text")

    def __init__(self, text: str, *, apart: bool = False, beside: bool = False) -> None:
        self.text = text
        self.apart = apart
        self.beside = beside


class Out:
    """An element to be written. ``text`` is YAML, with ``children`` empty; ``apart``: a blank line stands before it."""

    __slots__ = ("apart", "attributes", "children", "tag", "text")

    def __init__(self, tag: str, attributes: dict[str, str], condition: Condition | None = None) -> None:
        self.tag = tag
        self.attributes = attributes if condition is None else {condition.attribute: condition.written.text, **attributes}
        self.children: list[Piece] = []
        self.text = ""
        self.apart = False

    @property
    def conditional(self) -> bool:
        """Whether it has a condition of its own."""
        return "if" in self.attributes or "unless" in self.attributes


Piece: TypeAlias = Union[Note, Out]  # noqa: UP007 - a union of names that are looked up later


def remark(text: str) -> str:
    """``text`` as it may stand in a comment."""
    text = _FORBIDDEN.sub("\ufffd", text).replace("\r", " ")
    return re.sub("-(?=-)|-$", "- ", text)


def one_line(text: str) -> str:
    """``text`` as it may stand behind a ``#``."""
    return " ".join(_FORBIDDEN.sub("\ufffd", text).replace("\x85", " ").replace("\u2028", " ").replace("\u2029", " ").splitlines())


def render(header: list[str], pieces: list[Piece], step: int) -> str:
    """The whole file, each level ``step`` blanks further in, with comments of one line at its top. Raises CannotExport for a character
    that XML cannot hold.
    """
    lines = ["<launch>", *(f"{' ' * step}<!-- {remark(line)} -->" for line in header)]
    if pieces:
        pieces[0].apart = True
    _lines(pieces, " " * step, " " * step, lines)
    lines.append("</launch>")
    text = "\n".join(lines) + "\n"
    bad = _FORBIDDEN.search(text)
    if bad is not None:
        raise CannotExport(f"a value holds the character U+{ord(bad[0]):04X}, which cannot stand in XML")
    return text


def _lines(pieces: list[Piece], indent: str, step: str, lines: list[str]) -> None:
    above = ""
    for piece in pieces:
        if isinstance(piece, Note) and piece.beside:
            lines[-1] += f" <!--{piece.text}-->"
            continue
        tag = piece.tag if isinstance(piece, Out) else ""
        if piece.apart or (above == "arg" and tag != "arg"):
            lines.append("")
        above = tag
        if isinstance(piece, Note):
            lines.append(f"{indent}<!--{piece.text}-->")
            continue
        attributes = "".join(f' {name}="{_escaped(value)}"' for name, value in piece.attributes.items())
        start = f"{indent}<{piece.tag}{attributes}"
        if piece.text:
            lines.append(f"{start}>{_yaml(piece.text, indent, step)}</{piece.tag}>")
        elif piece.children:
            lines.append(f"{start}>")
            _lines(piece.children, indent + step, step, lines)
            lines.append(f"{indent}</{piece.tag}>")
        else:
            lines.append(f"{start}/>")


def _escaped(value: str) -> str:
    return "".join(_ESCAPES.get(char, char) for char in value)


def _yaml(text: str, indent: str, step: str) -> str:
    """The content of a ``<rosparam>``: on one line if it is a short one, else below the tag and indented with it, unless that would change
    it.
    """
    from launchlint.evaluate.ros1.rosparam import YamlError, YamlUnknown, load

    lines = text.split("\n")
    while lines and (not lines[0].strip() or lines[0].rstrip() == "---"):
        del lines[0]
    while lines and not lines[-1].strip():
        del lines[-1]
    inner = indent + step
    margin = min((len(line) - len(line.lstrip(" ")) for line in lines if line.strip()), default=0)
    shifted = "\n" + "".join(f"{inner}{line[margin:]}\n" if line.strip() else "\n" for line in lines) + indent
    short = lines[0].strip() if len(lines) == 1 else ""
    wanted = short if short and len(short) <= SHORT and "#" not in short else shifted
    try:
        before, after = load(text), load(wanted)
        same = repr(before.data) == repr(after.data) and [each[:2] for each in before.entries] == [each[:2] for each in after.entries]
    except (YamlError, YamlUnknown):
        same = False
    return _character_data(wanted if same else text)


def _character_data(text: str) -> str:
    if "&" not in text and "<" not in text and "\r" not in text:
        return text.replace("]]>", "]]&gt;")
    if "]]>" in text or "\r" in text:
        return "".join(_TEXT_ESCAPES.get(char, char) for char in text)
    return f"<![CDATA[{text}]]>"
