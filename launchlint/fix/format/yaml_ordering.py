"""Which args of a launch file in YAML can go to the start of their block: the list behind ``launch``, or behind a ``group``.

As in XML (:mod:`.ordering`), an arg goes up with the comments right above it, unless these may be about what follows, too. Lists in
brackets stay as they are.
"""

from __future__ import annotations

from collections.abc import Iterator

from launchlint.fix.format.ordering import Move
from launchlint.named_tuple import NamedTuple
from launchlint.yaml.refusals import YamlError
from launchlint.yaml.tree import MAPPING, SEQUENCE, Node, Reader, YamlBeyond, parse

_LAUNCH, _ARG, _GROUP, _CHILDREN = "launch", "arg", "group", "children"


class _Item(NamedTuple):
    """One action of a list, in whole lines: ``end`` is behind its last line, ``begins`` where the comments right above it begin."""

    tag: str
    begins: int
    start: int
    end: int


def moves(text: str) -> Iterator[Move]:
    """The args that do not stand at the start of their block. ``text`` has LF line ends and is in normal form."""
    try:
        root = parse(text, Reader("ros2 launch")).root
    except (YamlError, YamlBeyond):
        return
    met: set[int] = set()  # an alias may stand for a list that was looked at
    lists = [pair for pair in _pairs(root) if pair[0].value == _LAUNCH]
    while lists:
        key, value = lists.pop()
        key, value = next((pair for pair in _pairs(value) if pair[0].value == _CHILDREN), (key, value))
        if value.kind != SEQUENCE or id(value) in met:
            continue
        met.add(id(value))
        lists += [pair for each in value.value for pair in _pairs(each) if pair[0].value == _GROUP]
        items = _items(text, key, value)
        yield from [] if items is None else _of_block(text, _line_end(text, key.end), items)


def _of_block(text: str, target: int, items: list[_Item]) -> Iterator[Move]:
    others = False  # something else than an arg has been seen
    for number, item in enumerate(items):
        if item.tag != _ARG:
            others = True
        elif not others:
            target = item.end
        else:
            below = items[number + 1] if number + 1 < len(items) else None
            shared = below is not None and below.tag != _ARG and below.start == item.end  # the comments may be about what follows, too
            yield Move(item.start if shared else item.begins, item.end, target)


def _items(text: str, key: Node, value: Node) -> list[_Item] | None:
    """The actions of a list behind ``key``; None where it is not written one below the other, or speaks to launchlint in comments."""
    found: list[_Item] = []
    above = _line_end(text, key.end)
    nodes: list[Node] = value.value
    for number, node in enumerate(nodes):
        start = _line_start(text, node.start)
        dash = text[start : node.start]
        if start < above or dash.strip(" ") != "-":
            return None
        end = _line_start(text, nodes[number + 1].start) if number + 1 < len(nodes) else _after(text, node)
        end -= sum(map(len, _trailing(text[node.start : end], dash.index("-"))))
        lines = text[above:start].splitlines(keepends=True)
        if any("launchlint" in line for line in lines):  # it may be about its place
            return None
        begins = start
        while lines and lines[-1].strip():
            begins -= len(lines.pop())
        pairs = _pairs(node)
        found.append(_Item(str(pairs[0][0].value) if len(pairs) == 1 else "", begins, start, end))
        above = end
    return found


def _after(text: str, node: Node) -> int:
    """The first line behind ``node``, or behind comments that follow it: a block ends for the parser where the next thing begins."""
    start = _line_start(text, node.end)
    return start if start > node.start and not text[start : node.end].strip(" ") else _line_end(text, node.end)


def _trailing(text: str, column: int) -> Iterator[str]:
    """The blank lines and comments at the end of ``text`` that stand no deeper than ``column``: they are not of what is above them."""
    for line in reversed(text.splitlines(keepends=True)[1:]):
        words = line.lstrip(" ")
        if words.strip() and not (words.startswith("#") and len(line) - len(words) <= column):
            return
        yield line


def _pairs(node: Node | None) -> list[tuple[Node, Node]]:
    return node.value if node is not None and node.kind == MAPPING else []


def _line_start(text: str, offset: int) -> int:
    return text.rfind("\n", 0, offset) + 1


def _line_end(text: str, offset: int) -> int:
    found = text.find("\n", offset)
    return len(text) if found < 0 else found + 1
