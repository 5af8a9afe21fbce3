"""Comments of a launch file in Python, with what they stand before or behind."""

from __future__ import annotations

import ast
import io
import tokenize
from bisect import bisect_left

from launchlint.source import Source, Span
from launchlint.syntax.remarks import Remark


def remarks(source: Source) -> list[Remark]:
    """The comments of a program.

    One in a line of its own covers what begins in the next line with more than a comment: a statement, or an argument or item with all that
    is in it. One behind something covers what begins in its line. None where the file is no Python.
    """
    text = source.text
    if "#" not in text:
        return []
    try:
        tree = ast.parse(text)
        tokens = list(tokenize.generate_tokens(io.StringIO(text).readline))
    except (SyntaxError, ValueError, RecursionError, MemoryError, tokenize.TokenError):
        return []
    blocks = _blocks(tree, source)
    starts = sorted(blocks)
    top = next((each.lineno for each in tree.body if not _is_head(each)), len(source.line_starts) + 1)
    found: list[Remark] = []
    filled = {token.start[0] for token in tokens if token.type not in _BLANK}
    for token in tokens:
        if token.type != tokenize.COMMENT:
            continue
        line, column = token.start
        start = source.line_starts[line - 1] + column
        own = line not in filled
        behind = bisect_left(starts, line)
        first = (starts[behind] if behind < len(starts) else None) if own else line
        between = range(line + 1, first or line + 1)
        covers = blocks.get(first) if first is not None and not any(each in filled for each in between) else None
        span = Span(start, start + len(token.string))
        found.append(Remark(token.string[1:], span, Span(start + 1, span.end), covers, line < top))
    return found


_BLANK = frozenset((tokenize.COMMENT, tokenize.NL, tokenize.NEWLINE, tokenize.INDENT, tokenize.DEDENT, tokenize.ENDMARKER))


def _is_head(statement: ast.stmt) -> bool:
    """Whether a statement is a text or an import, as they stand on top of a file."""
    is_text = isinstance(statement, ast.Expr) and isinstance(statement.value, ast.Constant)
    return is_text or isinstance(statement, (ast.Import, ast.ImportFrom))


def _blocks(tree: ast.Module, source: Source) -> dict[int, Span]:
    """For each line what begins with its first character: the largest statement or expression."""
    found: dict[int, Span] = {}
    for node in ast.walk(tree):
        if not isinstance(node, (ast.stmt, ast.expr, ast.keyword)) or node.end_lineno is None or node.end_col_offset is None:
            continue
        line = source.line(node.lineno)
        if line.encode("utf-8", "replace")[: node.col_offset].strip():
            continue
        start = source.offset(node.lineno, node.col_offset)
        span = Span(start, source.offset(node.end_lineno, node.end_col_offset))
        if node.lineno not in found or span.end > found[node.lineno].end:
            found[node.lineno] = span
    return found
