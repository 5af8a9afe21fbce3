"""The words of a launch file of ROS 1 that mean something, from its tree."""

from __future__ import annotations

import re
from collections.abc import Iterator

from launchlint.evaluate.ros1.expression import arguments_read
from launchlint.ide.mention import Mention
from launchlint.late import late
from launchlint.syntax.parts import Expression, Substitution
from launchlint.syntax.ros1.substitutions import parts_of

TYPE_CHECKING = False
if TYPE_CHECKING:
    from launchlint.ide.mention import Kind
    from launchlint.syntax.tree import Attribute, Document, Element

_WORD = late(r"[A-Za-z_]\w*|'[^'\\]*'|\"[^\"\\]*\"")
_COMMANDS: dict[str, Kind] = {"arg": "arg", "find": "package", "env": "variable", "optenv": "variable"}
_PLAIN: dict[tuple[str, str], Kind] = {
    **{(tag, "pkg"): "package" for tag in ("node", "test")},
    **{(tag, "type"): "executable" for tag in ("node", "test")},
    **{(tag, "name"): "node" for tag in ("node", "test")},
    **{(tag, "machine"): "machine" for tag in ("node", "test")},
    **{(tag, "ns"): "namespace" for tag in ("node", "test", "group", "include")},
    ("include", "file"): "file",
    ("rosparam", "file"): "file",
    ("param", "textfile"): "file",
    ("param", "name"): "param",
    ("rosparam", "param"): "param",
    ("remap", "from"): "topic",
    ("remap", "to"): "topic",
    ("machine", "name"): "machine",
    ("env", "name"): "variable",
}
_DECLARES = {("node", "name"), ("test", "name"), ("machine", "name"), ("remap", "to")}


def mentions(document: Document) -> tuple[Mention, ...]:
    """All of them, in order; of a tree that was recovered those that are left."""
    return tuple(each for element in document.elements for each in _of(element))


def _of(element: Element) -> Iterator[Mention]:
    tag = element.tag
    item = element.span.start
    for name, attribute in element.attributes.items():
        whole = attribute.value_span
        if tag == "arg" and name == "name":
            outer = element.parent
            passes = outer is not None and outer.tag == "include"
            at = outer.span.start if outer is not None and passes else item
            yield Mention("arg", attribute.value, whole, "passes" if passes else "declares", at, whole)
        elif (tag, name) in _PLAIN:
            role = "declares" if (tag, name) in _DECLARES else "reads"
            package = (element.get("pkg") or "") if name == "type" else ""
            yield Mention(_PLAIN[tag, name], attribute.value, whole, "declares" if role == "declares" else "reads", item, whole, package)
        if "$" in attribute.value:
            yield from _substituted(attribute, item)


def _substituted(attribute: Attribute, item: int) -> Iterator[Mention]:
    whole = attribute.value_span
    for part in parts_of(attribute).parts:
        if isinstance(part, Substitution) and part.command in _COMMANDS and len(part.words) > 1:
            word = part.words[1]
            yield Mention(_COMMANDS[part.command], word.text, attribute.span_of(word.start, word.end), "reads", item, whole)
        elif isinstance(part, Expression):
            read = arguments_read(part.code)
            for match in _WORD.finditer(part.code):
                name, inner = _unquoted(match)
                if name in read and (inner == match.start() or _is_called(part.code, match)):
                    start = part.code_start + inner
                    yield Mention("arg", name, attribute.span_of(start, start + len(name)), "reads", item, whole)


def _unquoted(match: re.Match[str]) -> tuple[str, int]:
    text = match[0]
    return (text[1:-1], match.start() + 1) if text[0] in "'\"" else (text, match.start())


def _is_called(code: str, match: re.Match[str]) -> bool:
    """Whether a text in quotes is the operand of ``arg(…)``."""
    return code[: match.start()].rstrip().endswith("arg(")


def declared(document: Document) -> Iterator[tuple[str, bool, str]]:
    """The args that a launch file takes, in order: name, whether it must be given, and what is said of it."""
    for element in document.elements:
        name = element.get("name")
        if element.tag == "arg" and name and (element.parent is None or element.parent.tag != "include") and element.get("value") is None:
            default = element.get("default")
            said = "" if default is None else f"default: {default}"
            yield name, default is None, " — ".join(filter(None, (said, element.get("doc") or "")))
