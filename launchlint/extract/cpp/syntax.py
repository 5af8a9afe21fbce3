"""C++ source as a plain tree: what tree-sitter reads, without comments and punctuation, each node with its line.

A file is parsed whole and never preprocessed: both sides of every ``#if`` are in the tree, but for those amid a list of arguments, of which
the first side is. What tree-sitter cannot make sense of is an
``ERROR`` node; macros that would make one of sound code are blanked out beforehand, line numbers unchanged.
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from functools import lru_cache
from itertools import count

from launchlint.errors import UsageError

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    from tree_sitter import Parser, Tree, TreeCursor

_MOST_NODES = 1_500_000
_DEEPEST = 400
_FEWEST_STEPS = 2_000
_STEPS_OF_KILOBYTE = 40
"""Of the parser, each some hundred operations. Real sources take 5 to 18 for a kilobyte; what it cannot read may take thousands."""
_ERROR = 0xFFFF
_NO_FIELDS: dict[str, Node] = {}
_NO_CHILDREN: list[Node] = []
"""Of all leaves: nothing is ever added to them."""

_BLANKED = re.compile(
    r"^[ \t]*(?:PLUGINLIB_\w+|NODELET_\w+|EIGEN_MAKE_ALIGNED_\w+|Q_(?:OBJECT|PROPERTY|ENUMS|INTERFACES|DECLARE\w*)|GZ_REGISTER_\w+"
    r"|ROS_DEPRECATED|POINT_CLOUD_REGISTER_POINT_STRUCT|BOOST_CLASS_EXPORT\w*|CLASS_LOADER_\w+)\b",
    re.MULTILINE,
)
# Begins with a letter, not with a boundary: so it is looked for fast.
_EXPORTED = tuple(
    re.compile(rf"{each}(?<!\w{each})[ \t]+([A-Z][A-Z0-9_]+(?:\([^()\n]*\))?)(?=[ \t]+[A-Za-z_]\w*[ \t\n]*(?:final[ \t]*)?[:{{\n])")
    for each in ("class", "struct")
)
_SLOTS = re.compile(r"\b(?:public|private|protected)[ \t]+(Q_SLOTS|slots)[ \t]*:|^[ \t]*(Q_SIGNALS|signals)[ \t]*:", re.MULTILINE)
_ATTRIBUTE = re.compile(
    r"__attribute__[ \t]*\(\([^()\n]*(?:\([^()\n]*\)[^()\n]*)*\)\)|\bROS_FORCE_INLINE\b|\b__forceinline\b|\bROS_DEPRECATED\b"
    r"|\b(?:ABSL_)?(?:(?:PT_)?GUARDED_BY|(?:EXCLUSIVE|SHARED)_LOCKS_REQUIRED|LOCKS_EXCLUDED)[ \t]*\([^()\n]*\)"
)
_WORDS_OF_SLOTS = ("slots", "SLOTS", "signals", "SIGNALS")
_WORDS_OF_ATTRIBUTES = ("__attribute__", "ROS_FORCE_INLINE", "__forceinline", "ROS_DEPRECATED", "GUARDED_BY", "LOCKS_")
_WORDS_OF_LOOPS = ("FOREACH", "foreach")
_ADJACENT = re.compile(r"(?<==)([ \t]*[A-Z][A-Z0-9_]{2,})((?:[ \t]+[A-Z][A-Z0-9_]{2,})+)(?=[ \t]*;)")
_EACH = re.compile(r"\b(?:BOOST_|Q_)?FOREACH[ \t]*\(|\bforeach[ \t]*\(|\bQ_FOREACH[ \t]*\(")
_WORDS_OF_TESTS = ("TEST_CASE", "SCENARIO")
_TESTS = re.compile(r'^[ \t]*(TEST_CASE|SCENARIO)[ \t\n]*\([ \t\n]*(?:"(?:[^"\\\n]|\\.)*"[ \t\n,]*){1,4}\)(?=[ \t\n]*\{)', re.MULTILINE)

_AMID = re.compile(r"[,(][ \t]*(?://[^\n]{0,200})?\n(?=[ \t]*#[ \t]*if)")
_DIRECTIVE = re.compile(r"[ \t]*#[ \t]*(if|el|endif)")
_NEVER = re.compile(r"[ \t]*#[ \t]*if[ \t]+0\b")
_LONGEST_CONDITIONAL = 200
_MOST_ENDLESS = 20
_MOST_ERRORS = 200
LONGEST_CONDITION = 160
"""Characters of one condition."""


class Node:
    """One node: ``kind`` as the grammar calls it, its named ``children`` in order, ``fields`` by the grammar's names, ``line`` from 1.

    Of several nodes that the grammar calls alike, ``fields`` has the first one, and :meth:`every` has all.

    ``kept`` is for what a reader has worked out of the node, and the next one need not; None where that is nothing.

    Lines are counted, its source ``text`` is decoded, and what stands in the body of a function is converted when they are asked for: most
    of it never is.
    """

    __slots__ = ("_below", "_end", "_others", "_source", "_start", "children", "fields", "kept", "kind", "line", "text")

    children: list[Node]
    fields: dict[str, Node]
    kept: object
    line: int
    text: str
    _below: tuple[TreeCursor, int]
    _others: Sequence[tuple[str, Node]]

    def __init__(self, kind: str, source: bytes, start: int, end: int) -> None:
        self.kind = kind
        self.children = _NO_CHILDREN
        self.fields = _NO_FIELDS
        self._source = source
        self._start = start
        self._end = end

    def __getattr__(self, name: str) -> Any:
        # Asked for what has no value yet.
        if name == "text":
            self.text = self._source[self._start : self._end].decode("utf-8", "replace")
            return self.text
        if name == "line":
            self.line = self._source.count(b"\n", 0, self._start) + 1
            return self.line
        if name == "_others":
            return ()
        if name == "kept":
            return None
        if name in ("children", "fields"):
            cursor, depth = self._below
            del self._below
            self.children, self.fields = _NO_CHILDREN, _NO_FIELDS
            _convert(cursor, self, depth)
            return getattr(self, name)
        raise AttributeError(name)

    def until_asked(self, cursor: TreeCursor, depth: int) -> None:
        """Put off what is below the node that the cursor is at, ``depth`` levels deep in its file."""
        self._below = (cursor, depth)
        del self.children, self.fields

    def until(self, inner: Node | None) -> str:
        """The source text before a node in it; all of it where there is none."""
        return self._source[self._start : self._end if inner is None else inner._start].decode("utf-8", "replace")

    @property
    def size(self) -> int:
        """The length of its source text in bytes."""
        return self._end - self._start

    def every(self, name: str) -> list[Node]:
        """All nodes that the grammar calls ``name`` in this one."""
        first = self.fields.get(name)
        return [] if first is None else [first, *(each for called, each in self._others if called == name)]

    def child(self, *kinds: str) -> Node | None:
        """The first child of one of these kinds."""
        return next((each for each in self.children if each.kind in kinds), None)

    def walk(self) -> list[Node]:
        """This node and all below it, in the order of the source."""
        found: list[Node] = []
        pending = [self]
        while pending:
            node = pending.pop()
            found.append(node)
            pending.extend(reversed(node.children))
        return found

    def __repr__(self) -> str:
        return f"Node({self.kind}, {self.line}, {self.text[:40]!r})"


@lru_cache(maxsize=1)
def _parser() -> Parser:
    try:
        import tree_sitter
        import tree_sitter_cpp
    except ImportError as error:
        raise UsageError(
            f"C++ is read with tree-sitter, which cannot be imported here ({error}): pip install tree-sitter "
            "tree-sitter-cpp, and try again. Python sources are read without it."
        ) from error
    return tree_sitter.Parser(tree_sitter.Language(tree_sitter_cpp.language()))


def _tree(source: bytes) -> Tree | None:
    """What the parser makes of a source; ``None`` where it takes too many steps: it goes back and forth in what it cannot read."""
    parser, steps = _parser(), count()
    most = _FEWEST_STEPS + len(source) * _STEPS_OF_KILOBYTE // 1024
    try:
        return parser.parse(lambda offset, _: source[offset:], progress_callback=lambda *_: next(steps) >= most)
    except ValueError:
        parser.reset()  # else it would go on where it stopped
        return None


class Root(Node):
    """The node of a whole file; ``errors`` are the parts of it that are not understood: the line of each, and its text."""

    __slots__ = ("errors",)

    def __init__(self, source: bytes) -> None:
        super().__init__("translation_unit", source, 0, len(source))
        self.errors: list[tuple[int, str]] = []


def parse(source: bytes) -> Root:
    """The tree of a file.

    What is nested too deeply, or more than there is room for, is left out; all of it, where the parser takes too many steps.

    Raises:
        UsageError: tree-sitter is not installed.
    """
    source = _readable(source)
    tree = _tree(source)
    root = Root(source)
    if tree is None:
        root.errors.append((1, root.text))
        return root
    _note_errors(tree, root)
    _convert(tree.walk(), root, 0)
    return root


@lru_cache(maxsize=4096)
def shortened(text: str, longest: int = LONGEST_CONDITION) -> str:
    """Source text on one line, and not too long."""
    plain = " ".join("".join(char if char.isprintable() else " " for char in text[: longest * 4]).split())
    return plain if len(plain) <= longest else plain[: longest - 1] + "…"


def _note_errors(tree: Tree, root: Root) -> None:
    """Go through those parts of a tree that have an error in them, and note the outermost of each."""
    pending = [tree.root_node] if tree.root_node.has_error else []
    while pending and len(root.errors) < _MOST_ERRORS:
        node = pending.pop()
        if node.is_error:
            text = root._source[node.start_byte : node.end_byte].decode("utf-8", "replace")
            root.errors.append((node.start_point[0] + 1, text))
        else:
            pending += [each for each in node.children if each.has_error]


@lru_cache(maxsize=2048)
def parse_expression(text: str) -> Node | None:
    """The tree of one expression, as the value of a macro."""
    source = b"auto x = " + text.encode("utf-8", "replace") + b";"
    root = _converted(source)
    declaration = root.child("declaration")
    declarator = declaration.fields.get("declarator") if declaration else None
    return declarator.fields.get("value") if declarator else None


@lru_cache(maxsize=512)
def parse_statements(text: str) -> Node | None:
    """The tree of some statements, as the value of a macro."""
    source = b"void f() { " + text.encode("utf-8", "replace") + b"; }"
    root = _converted(source)
    function = root.child("function_definition")
    return function.fields.get("body") if function else None


def _converted(source: bytes) -> Node:
    root, tree = Node("translation_unit", source, 0, len(source)), _tree(source)
    if tree is not None:
        _convert(tree.walk(), root, 0)
    return root


def _convert(cursor: TreeCursor, root: Node, depth: int) -> None:
    """Put what is below the node that the cursor is at below ``root``."""
    if not cursor.goto_first_child():
        return
    kinds, named_kinds, field_names = _names()
    source = root._source
    parents = [root]
    count = 0
    while True:
        found = cursor.node
        field = cursor.field_id
        symbol = found.kind_id if found is not None else -1
        named = symbol in named_kinds
        descended = False
        if found is not None and (named or field is not None) and kinds[symbol] != "comment" and count < _MOST_NODES:
            count += 1
            kind = kinds[symbol]
            node = Node(kind, source, found.start_byte, found.end_byte)
            parent = parents[-1]
            if named:
                if parent.children:
                    parent.children.append(node)
                else:
                    parent.children = [node]  # most nodes are leaves: they have no list of their own
            if field is not None:
                _name(parent, field_names[field], node)
            if len(parents) + depth < _DEEPEST:
                if (kind == "compound_statement" or kind == "field_initializer_list") and parent.kind == "function_definition":
                    node.until_asked(found.walk(), len(parents) + depth)
                elif cursor.goto_first_child():
                    parents.append(node)
                    descended = True
        if descended:
            continue
        while not cursor.goto_next_sibling():
            if len(parents) == 1 or not cursor.goto_parent():
                return
            parents.pop()


@lru_cache(maxsize=1)
def _names() -> tuple[dict[int, str], frozenset[int], list[str]]:
    """What the grammar's numbers stand for: the kinds, those of them that are named, and the fields."""
    language = _parser().language
    if language is None:  # no parser is made without one
        return {}, frozenset(), []
    kinds = {each: language.node_kind_for_id(each) or "" for each in range(language.node_kind_count)}
    named = {each for each in kinds if language.node_kind_is_named(each)}
    fields = [language.field_name_for_id(each) or "" for each in range(language.field_count + 1)]
    return {**kinds, _ERROR: "ERROR"}, frozenset((*named, _ERROR)), fields


def _name(parent: Node, name: str, node: Node) -> None:
    if not parent.fields:
        parent.fields = {name: node}
    elif name not in parent.fields:
        parent.fields[name] = node
    elif isinstance(parent._others, list):
        parent._others.append((name, node))
    else:
        parent._others = [(name, node)]


def _readable(source: bytes) -> bytes:
    """``source`` with what the grammar stumbles over blanked out, of the same number of lines."""
    text = source.decode("utf-8", "replace").replace("\r\n", "\n").replace("\r", "\n").replace("\0", " ")
    text = _BLANKED.sub(lambda match: " " * len(match[0]), _calls_blanked(_one_side(text)))
    for exported in _EXPORTED:
        text = exported.sub(lambda match: match[0].replace(match[1], " " * len(match[1]), 1), text)
    # What stands in few files is looked for by its words first, which is many times as fast.
    if any(each in text for each in _WORDS_OF_SLOTS):
        text = _SLOTS.sub(lambda match: "public:" if match[2] else match[0].replace(match[1], ""), text)
    if any(each in text for each in _WORDS_OF_ATTRIBUTES):
        text = _ATTRIBUTE.sub(lambda match: " " * len(match[0]), text)
    # Macros side by side are strings side by side, which the grammar takes where one of them is a literal.
    text = _ADJACENT.sub(lambda match: f'{match[1]} ""{match[2]}', text)
    if any(each in text for each in _WORDS_OF_LOOPS):
        text = _loops(text)
    if any(each in text for each in _WORDS_OF_TESTS):
        text = _TESTS.sub(_without_strings, text)
    return text.encode()


def _without_strings(match: re.Match[str]) -> str:
    """The head of a test, whose name is a string, as that of a function; on as many lines as before."""
    return f"{match[1]}()" + "\n" * match[0].count("\n")


def _one_side(text: str) -> str:
    """The text with one side of each ``#if`` that stands amid a list of arguments, where the grammar has no place for it."""
    parts: list[str] = []
    at = endless = 0
    for match in _AMID.finditer(text):
        if match.end() < at or endless > _MOST_ENDLESS:
            continue
        kept = _side(text, match.end())
        endless += kept is None
        if kept is not None:
            parts += [text[at : match.end()], *kept]
            at = match.end() + sum(map(len, kept))
    return "".join([*parts, text[at:]])


def _side(text: str, start: int) -> list[str] | None:
    """The lines from ``#if`` to its ``#endif``, all blank but those of the first sides that can be; None where that is too long."""
    lines: list[str] = []
    sides: list[int] = []  # of this conditional and of those in it: which of their sides the line is on
    position = start
    while position < len(text) and len(lines) < _LONGEST_CONDITIONAL:
        end = text.find("\n", position) + 1 or len(text)
        directive = _DIRECTIVE.match(text, position, end)
        if directive is not None and directive[1] == "if":
            sides.append(-1 if _NEVER.match(text, position, end) else 0)
        elif directive is not None and directive[1] == "el":
            sides[-1] += 1
        lines.append(" " * (end - position - 1) + "\n" if directive is not None or any(sides) else text[position:end])
        if directive is not None and directive[1] == "endif":
            sides.pop()
            if not sides:
                return lines
        position = end
    return None


def _calls_blanked(text: str) -> str:
    """Macro calls that stand where a declaration would, without their arguments."""
    parts: list[str] = []
    at = 0
    for match in _BLANKED.finditer(text):
        if match.start() < at:
            continue
        end = match.end()
        while end < len(text) and text[end] in " \t":
            end += 1
        if end < len(text) and text[end] == "(":
            closing = _closing(text, end)
            if closing is None:
                continue
            end = closing + 1
            while end < len(text) and text[end] in " \t;":
                end += 1
        parts += [text[at : match.start()], re.sub(r"[^\n]", " ", text[match.start() : end])]
        at = end
    return "".join([*parts, text[at:]])


def _loops(text: str) -> str:
    """``BOOST_FOREACH(a, b)`` as ``for(a : b)``."""
    parts: list[str] = []
    at = 0
    for match in _EACH.finditer(text):
        if match.start() < at:
            continue
        comma = _closing(text, match.end() - 1, ",")
        if comma is None:
            continue
        parts += [text[at : match.start()], "for (", text[match.end() : comma], " : "]
        at = comma + 1
    return "".join([*parts, text[at:]])


def _closing(text: str, start: int, wanted: str = ")") -> int | None:
    """Where the parenthesis opened at ``start`` closes (or a comma inside it stands), at most 4,000 characters on."""
    level = 0
    angle = 0
    for position in range(start, min(len(text), start + 4000)):
        char = text[position]
        if char in "([{":
            level += 1
        elif char in ")]}":
            level -= 1
            if level == 0:
                return position if wanted == ")" else None
        elif wanted == "," and char in "<>":
            angle += 1 if char == "<" else -1
        elif char == wanted and level == 1 and angle <= 0:
            return position
    return None
