"""``$(eval …)`` of roslaunch as that of ROS 2 launch: there, args are put into the text of an expression before it is computed.

roslaunch makes numbers and booleans of args that look like them; ROS 2 leaves that to whoever writes the expression. So each arg is written
as what it is used for: a text in quotes, a number as it is, a truth value as a comparison.
"""

from __future__ import annotations

import ast

from launchlint.evaluate.expression.compiled import compiled
from launchlint.evaluate.expression.errors import UnknownValue
from launchlint.evaluate.ros1.expression import ExpressionError
from launchlint.evaluate.ros1.expression.names import RESERVED
from launchlint.evaluate.ros1.values import automatic
from launchlint.syntax.ros2.description import Text

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable, Mapping

    from launchlint.syntax.ros2.description import Substitution

    Make = Callable[[str, str], Substitution]
    Pieces = list[str | Substitution]

_CALLS = {"find": "find-pkg-share", "env": "env", "anon": "anon"}
_TEXT, _NUMBER, _TRUTH = "text", "number", "truth"
_TRUTHS = {"true": "True", "false": "False"}


class NotTranslated(Exception):
    """ROS 2 has no way to say it; ``reason`` in plain words."""

    def __init__(self, reason: str) -> None:
        super().__init__(reason)
        self.reason = reason


def translated(code: str, values: Mapping[str, str], make: Make, directory: Callable[[], Pieces]) -> Pieces:
    """``code`` with substitutions in it. Raises NotTranslated.

    ``values`` are the args as they are in the configuration that is exported; ``make`` makes a substitution of its name and its word;
    ``directory`` gives what stands for ``dirname()``.
    """
    try:
        whole = compiled(code)
    except (ExpressionError, UnknownValue):
        raise NotTranslated("the expression is not understood") from None
    parents = {id(child): node for node in ast.walk(whole.tree) for child in ast.iter_child_nodes(node)}
    bound = {node.id for node in ast.walk(whole.tree) if isinstance(node, ast.Name) and not isinstance(node.ctx, ast.Load)}
    edits: list[tuple[int, int, Pieces]] = []
    inside: set[int] = set()
    for node in ast.walk(whole.tree):  # what is outside comes first
        if id(node) in inside:
            continue
        if isinstance(node, ast.Name) and node.id in _TRUTHS:
            edits.append((*whole.span(node), [_TRUTHS[node.id]]))
        elif isinstance(node, ast.Name) and node.id not in RESERVED and node.id not in bound:
            edits.append((*whole.span(node), _written(node, node.id, parents, values, make)))
        elif isinstance(node, ast.Call) and isinstance(node.func, ast.Name):
            name = node.func.id
            if name == "arg":
                edits.append((*whole.span(node), _written(node, _word(node), parents, values, make)))
            elif name == "dirname":
                edits.append((*whole.span(node), ["'", *directory(), "'"]))
            elif name in _CALLS and len(node.args) == 1:
                asked = _asked(node.args[0], make)
                inside.update(id(each) for each in ast.walk(node) if each is not node)
                edits.append((*whole.span(node), ["'", make(_CALLS[name], _word(node)) if asked is None else asked(_CALLS[name]), "'"]))
            elif name in ("optenv", "env", "anon", "find", "eval"):
                raise NotTranslated(f"{name}() in an expression has no counterpart")
    found: Pieces = []
    at = 0
    for start, end, pieces in sorted(edits, key=lambda edit: edit[:2]):
        if start < at:
            raise NotTranslated("the expression is not understood")
        found += [code[at:start], *pieces]
        at = end
    return [*found, code[at:]]


def _asked(node: ast.expr, make: Make) -> Callable[[str], Substitution] | None:
    """For the name of a package, or of a variable, that is that of an arg: what makes a substitution of it."""
    name = ""
    if isinstance(node, ast.Name) and node.id not in RESERVED:
        name = node.id
    elif isinstance(node, ast.Call) and isinstance(node.func, ast.Name) and node.func.id == "arg":
        name = _word(node)
    if not name:
        return None
    value = make("var", name)
    return lambda command: make(command, "")._replace(arguments=(Text((value,), value.place),))


def _word(call: ast.Call) -> str:
    if len(call.args) == 1 and isinstance(call.args[0], ast.Constant) and isinstance(call.args[0].value, str):
        return call.args[0].value
    raise NotTranslated("a name in an expression is computed")


def _written(node: ast.expr, name: str, parents: Mapping[int, ast.AST], values: Mapping[str, str], make: Make) -> Pieces:
    value = make("var", name)
    kind = _use(node, parents, values.get(name))
    if kind == _NUMBER:
        return [value]
    return ["'", value, "'"] if kind == _TEXT else ["('", value, "'.lower() in ('true', '1'))"]


def _use(node: ast.expr, parents: Mapping[int, ast.AST], value: str | None) -> str:
    """What an arg is used for."""
    parent = parents.get(id(node))
    own = None if value is None else _kind(automatic(value))
    if isinstance(parent, ast.Compare):
        others = [each for each in (parent.left, *parent.comparators) if each is not node]
        kinds = [_kind(each.value) for each in others if isinstance(each, ast.Constant)]
        kinds += [_TRUTH for each in others if isinstance(each, ast.Name) and each.id in _TRUTHS]
        return kinds[0] if kinds else own or _TEXT
    if isinstance(parent, (ast.BoolOp, ast.UnaryOp)) or (isinstance(parent, ast.IfExp) and parent.test is node):
        return _TRUTH if own != _NUMBER else _NUMBER
    if isinstance(parent, ast.BinOp):
        other = parent.right if parent.left is node else parent.left
        return _kind(other.value) if isinstance(other, ast.Constant) else own or _TEXT
    if isinstance(parent, ast.Expression):
        return own or _TEXT
    return _NUMBER if own == _NUMBER and not isinstance(parent, (ast.Call, ast.Attribute)) else _TEXT


def _kind(value: object) -> str:
    if isinstance(value, bool):
        return _TRUTH
    return _NUMBER if isinstance(value, (int, float)) else _TEXT
