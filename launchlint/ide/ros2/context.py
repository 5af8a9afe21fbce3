"""What is being written at a place of a launch file in YAML or Python, told from the text in front of it: as in :mod:`..context`."""

from __future__ import annotations

import re
from collections.abc import Mapping
from itertools import takewhile

from launchlint.ide.context import Context, with_command
from launchlint.late import late
from launchlint.named_tuple import NamedTuple
from launchlint.source import Span
from launchlint.syntax.ros2.python.tables import class_of_kind, signature

_LINE = late(r"^([ ]*)((?:-[ ]+)*)(?:([\w$-]+)[ ]*:(?=[ ]|$)[ ]*)?(.*)")
_HOLDING = ("launch", "group")
"""The keys below which there is one action an item."""
_MOST_LINES = 2_000


class _Line(NamedTuple):
    """A line of YAML: the column of its key or value, whether it begins an item, its key and what follows that."""

    column: int
    item: bool
    key: str
    value: str


def yaml_context(text: str, offset: int) -> Context:
    """What is being written at ``offset`` of a launch file in YAML."""
    start = text.rfind("\n", 0, offset) + 1
    typed = text[start:offset]
    here = _line(typed)
    if here is None:
        return Context("", Span(offset, offset))
    before = [each for each in map(_line, text[:start].split("\n")[:-1][-_MOST_LINES:]) if each is not None]
    after = [each for each in map(_line, text[offset:].partition("\n")[2].split("\n")[:_MOST_LINES]) if each is not None]
    stack = _around(before, here)
    if not stack:
        return with_command(Context("", Span(offset, offset)), typed, offset)
    (tag, outer), parent = stack[0], stack[1][0] if len(stack) > 1 else ""
    own = dict(_beside(before[::-1], here, upward=True)) if not here.item else {}
    own.update(_beside(after, here, upward=False))
    listed = takewhile(lambda each: each.column >= here.column, reversed(before))
    siblings = tuple(each.value.strip("'\"") for each in listed if each.key == "name" and each.column == here.column)
    if here.key:
        word = here.value.lstrip("'\"")
        made = Context("value", Span(offset - len(word), offset), tag, here.key, own, parent, outer, siblings)
        return with_command(made, typed, offset)
    span = Span(offset - len(here.value), offset)
    if tag in _HOLDING:
        return Context("tag", span, parent=tag, outer=own)
    return Context("attribute", span, tag, "", own, parent, outer, siblings)


def _line(text: str) -> _Line | None:
    if text.lstrip().startswith("#"):
        return None
    match = _LINE.match(text)
    if match is None or not (match[2] or match[3] or match[4] or match[1]):
        return None
    value = match[4]
    if not match[3] and match[2].strip() == "" and value.strip() == "-":
        return None
    return _Line(len(match[1]) + len(match[2]), bool(match[2]), match[3] or "", value)


def _around(before: list[_Line], here: _Line) -> list[tuple[str, Mapping[str, str]]]:
    """The keys around a line, innermost first, each with the plain values beside it."""
    found: list[tuple[str, Mapping[str, str]]] = []
    column = here.column
    for number in range(len(before) - 1, -1, -1):
        each = before[number]
        if each.key and each.column < column and not each.value.strip():
            beside = dict(_beside(before[number - 1 :: -1], each, upward=True)) if number and not each.item else {}
            found.append((each.key, beside))
            column = each.column
    return found


def _beside(lines: list[_Line], here: _Line, *, upward: bool) -> list[tuple[str, str]]:
    """The keys with plain values that belong to the same mapping as ``here``."""
    found: list[tuple[str, str]] = []
    for each in lines:
        if each.column < here.column or (each.item and each.column == here.column and not upward):
            break
        if each.column == here.column and each.key:
            found.append((each.key, each.value.strip().strip("'\"")))
            if each.item:
                break
    return found


# -- Python ------------------------------------------------------------------------------------------------------

IN_XML: Mapping[str, str] = {
    "Node": "node", "LifecycleNode": "node", "ComposableNodeContainer": "node_container", "ComposableNode": "composable_node",
    "DeclareLaunchArgument": "arg", "LaunchConfiguration": "var", "SetLaunchConfiguration": "let", "ExecuteProcess": "executable",
    "FindPackageShare": "find", "FindPackagePrefix": "find", "get_package_share_directory": "find",
}  # fmt: skip
"""What the tag is called that stands in XML for a class of launch or launch_ros, where its values are completed as those of the tag are."""
_SHARE = ("package_name",)
"""What ament_index_python's get_package_share_directory takes."""

_KEYWORD = late(r"\b(\w+)\s*=\s*(?:[fr]?(['\"])([^'\"\n]*)\2)?")
XML_NAMES: Mapping[str, str] = {"package": "pkg", "package_name": "pkg", "executable": "exec"}
_MOST_BEHIND = 20_000


def keywords(call: str, distro: str) -> Mapping[str, bool]:
    """The arguments of a class of launch or launch_ros by its last word, in order: name, and whether it has to be given."""
    if call == "get_package_share_directory":
        return dict.fromkeys(_SHARE, True)
    known = signature(class_of_kind(call) or "", distro)
    return {} if known is None else {name: name in known.required for name in known.arguments}


def python_context(text: str, offset: int, distro: str) -> Context:
    """What is being written at ``offset`` of a launch file in Python: a keyword of a call, or a text that one is given."""
    opened = _opened(text[max(0, offset - _MOST_BEHIND) : offset])
    if opened is None:
        return Context("", Span(offset, offset))
    name, inside, quoted = opened
    known = keywords(name, distro)
    if not known:
        return Context("", Span(offset, offset))
    given = {XML_NAMES.get(match[1], match[1]): match[3] or "" for match in _KEYWORD.finditer(inside)}
    for match in _KEYWORD.finditer(_rest(text, offset)):
        given.setdefault(XML_NAMES.get(match[1], match[1]), match[3] or "")
    if quoted is None:
        word = re.search(r"(?<!\w)\w*$", inside)
        assert word is not None
        if re.search(r"(?:^|,)\s*\w*$", inside) is None:
            return Context("", Span(offset, offset))
        return Context("attribute", Span(offset - len(word[0]), offset), name, "", given)
    head = inside[: len(inside) - len(quoted) - 1].rstrip().rstrip("fr")
    keyword = re.search(r"\b(\w+)\s*=$", head)
    if keyword is None and head.strip():
        return Context("", Span(offset, offset))
    attribute = next(iter(known)) if keyword is None else keyword[1]
    given.pop(XML_NAMES.get(attribute, attribute), None)
    return Context("value", Span(offset - len(quoted), offset), IN_XML.get(name, name), XML_NAMES.get(attribute, attribute), given)


def _opened(text: str) -> tuple[str, str, str | None] | None:
    """The call around the end of ``text``: its name, what it has been given as far as no other call or list is, and the open string."""
    open_calls: list[int] = []
    quote, begun, number = "", 0, 0
    while number < len(text):
        letter = text[number]
        if quote:
            if letter == "\\":
                number += 1
            elif letter == quote or (letter == "\n" and len(quote) == 1):
                quote = ""
        elif letter in "'\"":
            quote, begun = letter, number + 1
        elif letter == "#":
            end = text.find("\n", number)
            if end < 0:
                return None
            number = end
        elif letter in "([{":
            open_calls.append(number)
        elif letter in ")]}" and open_calls:
            open_calls.pop()
        number += 1
    if not open_calls or text[open_calls[-1]] != "(":
        return None
    called = re.search(r"\b(\w+)\s*$", text[: open_calls[-1]])
    return None if called is None else (called[1], text[open_calls[-1] + 1 :], text[begun:] if quote else None)


def _rest(text: str, offset: int) -> str:
    """What the innermost call is given behind ``offset``, up to its end."""
    depth = 0
    for number, letter in enumerate(text[offset : offset + _MOST_BEHIND]):
        if letter in "([{":
            depth += 1
        elif letter in ")]}":
            depth -= 1
            if depth < 0:
                return text[offset : offset + number]
    return ""
