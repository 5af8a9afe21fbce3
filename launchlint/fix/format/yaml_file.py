"""A launch file in YAML in normal form.

Only the blanks at both ends of lines, those behind a dash, and blank lines change; so comments, quotes and the order of keys stay. That the
text means the same is proved by reading both. What stands behind ``# launchlint: format off`` only moves as a whole.
"""

from __future__ import annotations

from launchlint.fix.format.directives import directive
from launchlint.fix.format.style import Style
from launchlint.fix.format.yaml_layout import Layout, Line, Unusual
from launchlint.source import Source
from launchlint.yaml.refusals import YamlError
from launchlint.yaml.tree import YamlBeyond

TYPE_CHECKING = False
if TYPE_CHECKING:
    from launchlint.yaml.tree import Node

MOST_TIMES = 4
MOST_ADDED = 1 << 20


def yaml_normal_form(text: str, style: Style) -> str:
    """``text``, YAML with LF line ends, in normal form; as it is where that cannot be had.

    Raises:
        YamlError, YamlBeyond: it is no YAML.
    """
    from launchlint.yaml.tree import Reader, parse

    root = parse(text, Reader("ros2 launch")).root
    source = Source("", text)
    lines: dict[int, Line] = {}
    if root is not None:
        layout = Layout(source, style.indent)
        try:
            layout.place(root, 0)
            lines = layout.lines
        except Unusual:
            lines = {}
    written = text.split("\n")
    if sum(line.indent for line in lines.values()) > MOST_TIMES * len(text) + MOST_ADDED:
        return text
    result = _printed(written, lines) if lines else _tidied(written)
    try:
        other = parse(result, Reader("ros2 launch")).root
    except (YamlError, YamlBeyond):
        return text
    return result if _same(root, other) else text


def _printed(written: list[str], lines: dict[int, Line]) -> str:
    """The lines at their places, comments in lines of their own beside those that stood in their column."""
    result: list[str] = []
    kept = _kept(written, lines)
    begun = sorted(number for number, line in lines.items() if not line.inner)
    passed = 0  # how many of these are above
    open_above: list[tuple[int, int]] = []  # of those above, which each stand deeper than the one before: where they were and are
    for number, text in enumerate(written):
        line = lines.get(number)
        words = text.strip(" \t")
        if number in kept:
            result.append(" " * (_indent(text) + kept[number]) + text.lstrip(" ") if words else text)
            passed += line is not None and not line.inner
        elif line is not None and line.inner:
            result.append(" " * line.indent + text.lstrip(" ") if words else text)
        elif not words:
            if result and result[-1]:
                result.append("")
        elif line is None:
            below = [(_indent(written[each]), lines[each].indent) for each in begun[passed : passed + 1]]
            result.append(" " * _beside(_indent(text), open_above, below) + words)
        else:
            passed += 1
            own = _indent(text)
            while open_above and open_above[-1][0] >= own:
                open_above.pop()
            open_above.append((own, line.indent))
            words = words if line.gap < 0 else f"-{' ' * line.gap}{words[1:].lstrip(' ')}"
            result.append(" " * line.indent + words)
    while result and not result[-1] and len(written) - 2 not in kept:
        result.pop()
    return "\n".join(result) + "\n"


def _kept(written: list[str], lines: dict[int, Line]) -> dict[int, int]:
    """The lines that somebody wants to keep (``# launchlint: format off``), each with the number of columns by which all of them move.

    They end with ``# launchlint: format on``, else with the block that the comment stands in.
    """
    kept: dict[int, int] = {}
    since: int | None = None
    for number, text in enumerate([*written, None]):
        line = lines.get(number)
        words = "" if text is None else text.strip(" \t")
        inner = line is not None and line.inner
        word = directive(words[1:]) if words.startswith("#") and not inner else ""
        leaves = since is not None and bool(words) and not inner and _indent(text or "") < _indent(written[since])
        if since is not None and (text is None or leaves or word == "on"):
            begun = [each for each in range(since, number) if each in lines and not lines[each].inner]
            moved = lines[begun[0]].indent - _indent(written[begun[0]]) if begun else 0
            end = number - 1 if text is None else number  # the last line feed of the file is no line
            if begun and all(_indent(written[each]) + moved >= 0 for each in range(since, end) if written[each].strip(" \t")):
                kept.update(dict.fromkeys(range(since, end), moved))
            since = None
        if word == "off" and since is None:
            since = number
    return kept


def _beside(own: int, above: list[tuple[int, int]], below: list[tuple[int, int]]) -> int:
    """The indentation of a comment that had ``own``: that of a line which had the same, the next one first; else that of the next line."""
    same = next((new for old, new in (*below, *reversed(above)) if old == own), None)
    if same is not None:
        return same
    return below[0][1] if below else next((new for old, new in reversed(above) if old < own), own)


def _indent(text: str) -> int:
    return len(text) - len(text.lstrip(" "))


def _tidied(written: list[str]) -> str:
    """A text whose lines stay where they are ends with one line feed."""
    return "\n".join(written).rstrip("\n") + "\n"


def _same(before: Node | None, after: Node | None) -> bool:
    """Whether two trees hold the same, in the same order, with the same anchors shared."""
    pairs: list[tuple[Node, Node]] = []
    if (before is None) != (after is None):
        return False
    if before is not None and after is not None:
        pairs.append((before, after))
    met: dict[int, int] = {}
    while pairs:
        one, other = pairs.pop()
        if id(one) in met:
            if met[id(one)] != id(other):
                return False
            continue
        met[id(one)] = id(other)
        if (one.kind, one.tag) != (other.kind, other.tag):
            return False
        if isinstance(one.value, str) or isinstance(other.value, str):
            if one.value != other.value:
                return False
        elif len(one.value) != len(other.value):
            return False
        elif one.value and isinstance(one.value[0], tuple):
            pairs += [pair for first, second in zip(one.value, other.value, strict=True) for pair in zip(first, second, strict=True)]
        else:
            pairs += zip(one.value, other.value, strict=True)
    return True
