"""A Python file as a syntax tree that is safe to walk through."""

from __future__ import annotations

import ast
import codecs
import re
import warnings

from launchlint.python.python2 import rewritten
from launchlint.workspace.looking import read_bytes

LARGEST_FILE = 1 << 20
"""In bytes."""
DEEPEST_TREE = 120
"""Levels of a syntax tree."""

_CODING = re.compile(rb"^[ \t\f]*#.*?coding[:=][ \t]*([-\w.]+)")


class SourceError(ValueError):
    """A file that cannot be followed; ``str(error)`` says why, as the end of a sentence that begins with its name."""


class Routine:
    """What a function says, those in it included: names that it calls (the last word of each) and what stands before, what it writes.

    ``fills`` are the names of what it puts things into, or takes them out of, itself.
    """

    __slots__ = ("calls", "fills", "globals", "name", "node", "roots", "writes")

    def __init__(self, node: ast.FunctionDef | ast.AsyncFunctionDef) -> None:
        self.node = node
        self.name = node.name
        self.calls: set[str] = set()
        self.roots: set[str] = set()
        self.globals: set[str] = set()
        self.writes: set[str] = set()
        self.fills: set[str] = set()


class Source:
    """A syntax tree, and what one walk through it tells.

    ``routines`` are its functions, ``imports`` its import statements, ``set_later`` names of attributes and global variables that functions
    other than constructors write, or put things into; ``makes_code`` is whether it uses ``eval`` and the like.
    """

    __slots__ = ("imports", "makes_code", "routines", "set_later", "size", "tree")

    def __init__(self, tree: ast.Module, size: int) -> None:
        self.tree = tree
        self.size = size
        self.routines: tuple[Routine, ...] = ()
        self.imports: tuple[ast.Import | ast.ImportFrom, ...] = ()
        self.set_later: frozenset[str] = frozenset()
        self.makes_code = False
        _look_through(self)


def parse(path: str) -> Source:
    """The file at ``path``, which may be Python 3 or Python 2.

    Raises:
        SourceError: it cannot be read, is too large, or is no Python.
    """
    try:
        data = read_bytes(path, LARGEST_FILE)
    except OSError as error:
        raise SourceError(f"cannot be read: {error.strerror or error}") from None
    return parse_text(_decoded(data))


def parse_text(text: str) -> Source:
    """Python source. Raises :class:`SourceError`."""
    try:
        tree = _tree(text)
    except SyntaxError as error:
        try:
            tree = _tree(rewritten(text))
        except (SyntaxError, ValueError):
            raise SourceError(f"is not Python: line {error.lineno or 0}: {error.msg}") from None
    return Source(tree, len(text))


def _look_through(source: Source) -> None:
    """Fill in what is to be known of a tree. Raises :class:`SourceError` where it is nested too deep."""
    routines: list[Routine] = []
    imports: list[ast.Import | ast.ImportFrom] = []
    later: set[str] = set()
    nobody: tuple[Routine, ...] = ()
    level: list[tuple[ast.AST, tuple[Routine, ...]]] = [(source.tree, nobody)]
    for _ in range(DEEPEST_TREE):
        below: list[tuple[ast.AST, tuple[Routine, ...]]] = []
        for node, around in level:
            kind = type(node)
            if kind is ast.FunctionDef or kind is ast.AsyncFunctionDef:
                routine = Routine(node)  # type: ignore[arg-type]
                routines.append(routine)
                around = (*around, routine)
            elif around:
                _note(node, around, later)
            if kind is ast.Name:
                source.makes_code = source.makes_code or node.id in _MAKING_CODE  # type: ignore[attr-defined]
                continue
            if kind is ast.Constant:
                continue
            if kind is ast.Attribute:
                source.makes_code = source.makes_code or node.attr == "__import__"  # type: ignore[attr-defined]
            if kind is ast.Import or kind is ast.ImportFrom:
                imports.append(node)  # type: ignore[arg-type]
            for name in kind._fields:
                child = getattr(node, name, None)
                if isinstance(child, ast.AST):
                    if type(child) not in _LEAVES:
                        below.append((child, around))
                elif isinstance(child, list):
                    below += [(each, around) for each in child if isinstance(each, ast.AST)]
        if not below:
            for each in routines:
                if each.name != "__init__":
                    later |= each.writes & each.globals
                    later |= (
                        each.fills - each.writes - {argument.arg for argument in ast.walk(each.node.args) if isinstance(argument, ast.arg)}
                    )
            source.routines, source.imports, source.set_later = tuple(routines), tuple(imports), frozenset(later)
            return
        level = below
    raise SourceError("is nested too deep")


def _note(node: ast.AST, around: tuple[Routine, ...], later: set[str]) -> None:
    kind = type(node)
    if kind is ast.Call:
        word, root = called(node)  # type: ignore[arg-type]
        for each in around:
            each.calls.add(word)
            each.roots.add(root)
        if word in _FILLING and isinstance(node.func, ast.Attribute):  # type: ignore[attr-defined]
            _note_filled(node.func.value, around, later)  # type: ignore[attr-defined]
    elif kind is ast.Subscript and type(node.ctx) is not ast.Load:  # type: ignore[attr-defined]
        _note_filled(node.value, around, later)  # type: ignore[attr-defined]
    elif kind is ast.Attribute and type(node.ctx) is ast.Store:  # type: ignore[attr-defined]
        if any(each.name != "__init__" for each in around):
            later.add(node.attr)  # type: ignore[attr-defined]
    elif kind is ast.Name and type(node.ctx) is ast.Store:  # type: ignore[attr-defined]
        for each in around:
            each.writes.add(node.id)  # type: ignore[attr-defined]
    elif kind is ast.Global:
        for each in around:
            each.globals.update(node.names)  # type: ignore[attr-defined]


def _note_filled(node: ast.expr, around: tuple[Routine, ...], later: set[str]) -> None:
    """Note the list or dict that something is put into, or taken out of."""
    if isinstance(node, ast.Attribute):
        if any(each.name != "__init__" for each in around):
            later.add(node.attr)
    elif isinstance(node, ast.Name):
        around[-1].fills.add(node.id)


def called(node: ast.Call) -> tuple[str, str]:
    """The last word and the first of what is called: ``publish`` and ``self`` of ``self.pub.publish()``; empty where it is no name."""
    function: ast.expr = node.func
    last = function.attr if isinstance(function, ast.Attribute) else function.id if isinstance(function, ast.Name) else ""
    while isinstance(function, ast.Attribute):
        function = function.value
    return last, function.id if isinstance(function, ast.Name) else ""


_MAKING_CODE = frozenset(("eval", "exec", "execfile", "__import__"))
_FILLING = frozenset(("append", "appendleft", "add", "extend", "update", "insert", "put", "setdefault", "pop", "remove", "clear"))
"""Methods that change how many things a list or dict holds."""
_LEAVES = (ast.Load, ast.Store, ast.Del)


def _tree(text: str) -> ast.Module:
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")  # invalid escapes are common in old sources
            return ast.parse(text)
    except (RecursionError, MemoryError):
        raise SourceError("is nested too deep") from None
    except SyntaxError:
        raise
    except ValueError as error:  # null bytes, numbers with too many digits
        raise SourceError(f"is not Python: {error}") from None


def _decoded(data: bytes) -> str:
    for line in data.split(b"\n", 2)[:2]:
        match = _CODING.match(line)
        if match is not None:
            try:
                codec = codecs.lookup(match[1].decode("ascii", "replace"))
                if codec.name not in ("utf-8", "ascii", "iso8859-1", "iso8859-15", "cp1252", "euc_jp", "shift_jis", "gbk", "gb2312"):
                    break
                return _uncoded(data.decode(codec.name, "replace"))
            except LookupError:
                break
    return _uncoded(data.decode("utf-8-sig", "replace"))


def _uncoded(text: str) -> str:
    """Without a byte order mark."""
    return text.removeprefix("\ufeff")
