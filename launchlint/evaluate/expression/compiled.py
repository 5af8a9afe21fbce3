"""Expression text to syntax tree, with bounds before anything is parsed, and with places in the text."""

from __future__ import annotations

import ast
import re
import warnings
from functools import lru_cache

from launchlint.evaluate.expression.errors import ExpressionError, UnknownValue

LONGEST_TEXT = 20_000
MOST_TOKENS = 3_000
MOST_BRACKETS = 100
DEEPEST_TREE = 120
_MOST_KEPT = 512

_TOKEN = re.compile(r"\w+|[^\w\s]")
_BRACKET = re.compile(r"[(\[{}\])]")
_LINE_END = re.compile(r"\r\n|\r|\n")


class Compiled:
    """A parsed expression; ``text`` is the whole text, ``skipped`` the number of leading blanks that Python does not see."""

    __slots__ = ("_lines", "skipped", "text", "tree")

    def __init__(self, text: str, skipped: int, tree: ast.Expression) -> None:
        self.text = text
        self.skipped = skipped
        self.tree = tree
        self._lines: list[int] | None = None

    def span(self, node: ast.AST) -> tuple[int, int]:
        """Start and end of ``node`` in ``text``, in code points."""
        line, column = getattr(node, "lineno", None), getattr(node, "col_offset", None)
        end_line, end_column = getattr(node, "end_lineno", None), getattr(node, "end_col_offset", None)
        if line is None or column is None or end_line is None or end_column is None:
            return 0, len(self.text)
        return self._offset(line, column), self._offset(end_line, end_column)

    def _offset(self, line: int, column: int) -> int:
        """Code point of a line (from 1) and a column in UTF-8 bytes (from 0), as the tree counts."""
        if self._lines is None:
            self._lines = line_starts(self.text, self.skipped)
        if line > len(self._lines):
            return len(self.text)
        start = self._lines[line - 1]
        if self.text.isascii():
            return min(start + column, len(self.text))
        rest = self.text[start : start + column].encode("utf-8", "surrogatepass")[:column]
        return start + len(rest.decode("utf-8", "ignore"))


def compiled(text: str) -> Compiled:
    """The tree of ``text``, parsed once. Raises ExpressionError (kind SyntaxError) and UnknownValue (too large)."""
    if len(text) > LONGEST_TEXT:
        raise UnknownValue(f"the expression is longer than {LONGEST_TEXT} characters")
    result = _outcome(text)
    if isinstance(result, Compiled):
        return result
    raise result.with_traceback(None)


@lru_cache(maxsize=_MOST_KEPT)  # every configuration of every entry file that reaches a file asks for the same expressions
def _outcome(text: str) -> Compiled | ExpressionError | UnknownValue:
    try:
        return _compile(text)
    except (ExpressionError, UnknownValue) as error:
        return error


def line_starts(text: str, skipped: int) -> list[int]:
    """Offsets in ``text`` where the lines of Python's view of it begin."""
    return [skipped, *(match.end() for match in _LINE_END.finditer(text, skipped))]


def _compile(text: str) -> Compiled:
    _check_size(text)
    source = text.lstrip(" \t")  # as Python's eval does
    skipped = len(text) - len(source)
    try:
        with warnings.catch_warnings():  # "is" with a literal and the like: not ours to print
            warnings.simplefilter("ignore")
            tree = _parse(source)
            _check_depth(tree)
            compile(tree, "<eval>", "eval", dont_inherit=True)  # finds what the grammar does not, such as a yield outside a function
    except SyntaxError as error:
        start, end = _place(error, text, skipped)
        raise ExpressionError(
            f"this is not an expression that Python can read (Python says: {type(error).__name__}: {error.msg})", start, end, "SyntaxError"
        ) from None
    except ValueError as error:  # a null character, half a surrogate pair, a number of thousands of digits
        raise ExpressionError(
            f"this text cannot be read as an expression (Python says: {type(error).__name__}: {error})", 0, len(text), type(error).__name__
        ) from None
    except (RecursionError, MemoryError):
        raise UnknownValue("the expression is nested too deeply to be looked into") from None
    return Compiled(text, skipped, tree)


def _parse(source: str) -> ast.Expression:
    tree = compile(source, "<eval>", "eval", ast.PyCF_ONLY_AST, dont_inherit=True)
    assert isinstance(tree, ast.Expression)
    return tree


def _check_size(text: str) -> None:
    """Refuse what could hurt the parser: it must not even see such text."""
    depth = 0
    for bracket in _BRACKET.finditer(text):
        depth += 1 if bracket[0] in "([{" else -1
        if depth > MOST_BRACKETS:
            raise UnknownValue(f"the expression nests more than {MOST_BRACKETS} brackets")
    if len(text) > MOST_TOKENS and len(_TOKEN.findall(text)) > MOST_TOKENS:
        raise UnknownValue(f"the expression has more than {MOST_TOKENS} words and signs")


def _check_depth(tree: ast.AST) -> None:
    level, depth = [tree], 0
    while level:
        depth += 1
        if depth > DEEPEST_TREE:
            raise UnknownValue("the expression is nested too deeply to be looked into")
        level = [child for node in level for child in ast.iter_child_nodes(node)]


def _place(error: SyntaxError, text: str, skipped: int) -> tuple[int, int]:
    starts = line_starts(text, skipped)
    line, column = error.lineno or 1, error.offset or 1
    if line > len(starts):
        return max(0, len(text) - 1), len(text)
    start = min(starts[line - 1] + max(column, 1) - 1, max(0, len(text) - 1))
    end_line, end_column = getattr(error, "end_lineno", None), getattr(error, "end_offset", None)
    end = starts[end_line - 1] + end_column - 1 if end_line and end_column and end_line <= len(starts) else 0
    return start, min(max(end, start + 1), len(text))
