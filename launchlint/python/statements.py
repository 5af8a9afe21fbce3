"""Statements: both ways through every ``if``, loops over what is known, functions and classes made, modules imported."""

from __future__ import annotations

import ast
from collections.abc import Callable, Iterator, Sequence

from launchlint.python import builtins
from launchlint.python.comprehensions import MOST_ROUNDS
from launchlint.python.conditions import negated, written
from launchlint.python.definitions import SETTER
from launchlint.python.expressions import DEEPEST
from launchlint.python.failures import failure
from launchlint.python.letter import hashable
from launchlint.python.members import FIELDS
from launchlint.python.memory import BROKEN, CONTINUED, ENDED, GOES_ON, RETURNED, Branch, Ended
from launchlint.python.plain import SIMPLE
from launchlint.python.recogniser import Recogniser
from launchlint.python.values import (
    COMPLETE,
    ENTRIES,
    ITEMS,
    UNKNOWN,
    Argv,
    Bound,
    Class,
    External,
    Function,
    Handle,
    Instance,
    Map,
    Module,
    Scope,
    Seq,
    Super,
    Unknown,
    Value,
    alternatives,
    is_maybe,
)
from launchlint.python.writing import Writing


class Statements(Writing):
    """Execution."""

    def __init__(self, recogniser: Recogniser) -> None:
        super().__init__(recogniser)
        self._changed: dict[int, list[tuple[ast.expr, bool]]] = {}

    def execute(self, body: Sequence[ast.stmt], scope: Scope) -> int:
        """Go through statements; how that ended."""
        for statement in body:
            self.step()
            method = _EXECUTE.get(type(statement))
            if method is None or self.depth > DEEPEST:
                continue
            self.depth += 1
            try:
                flow = method(self, statement, scope)
            except Ended as error:
                self.raised = error
                return ENDED
            finally:
                self.depth -= 1
            if flow:
                return flow
        return GOES_ON

    # -- simple statements ----------------------------------------------------------------------------------------------

    def _expression(self, node: ast.Expr, scope: Scope) -> int:
        if not isinstance(node.value, ast.Constant):
            self.evaluate(node.value, scope)
        return GOES_ON

    def _assign(self, node: ast.Assign, scope: Scope) -> int:
        value = self.evaluate(node.value, scope)
        for target in node.targets:
            self.assign(target, value, scope)
        return GOES_ON

    def _annotated(self, node: ast.AnnAssign, scope: Scope) -> int:
        if node.value is not None:
            self.assign(node.target, self.evaluate(node.value, scope), scope)
        if "__qualname__" in scope.variables and isinstance(node.target, ast.Name):
            self.store(scope.variables, FIELDS, (*scope.variables.get(FIELDS, ()), node.target.id))
        return GOES_ON

    def _augmented(self, node: ast.AugAssign, scope: Scope) -> int:
        left = self.evaluate(node.target, scope)
        right = self.evaluate(node.value, scope)
        if isinstance(left, Seq) and isinstance(node.op, ast.Add) and not (self.exact and left.kind != "list"):
            builtins.method(self, left, "extend", [right], {})
        elif self.exact and (word := _in_place(left, type(node.op), right)):
            builtins.method(self, left, word, [right], {})
        else:
            self.assign(node.target, self.combine(left, type(node.op), right), scope)
        return GOES_ON

    def assign(self, target: ast.expr, value: Value, scope: Scope) -> None:
        """Write to a variable, attribute, item or several of them."""
        if isinstance(target, ast.Name):
            self.store(scope.shared.get(target.id, scope).variables, target.id, value)
        elif isinstance(target, ast.Attribute):
            owners = self.evaluate(target.value, scope)
            if self.exact:
                self._each(owners, scope, lambda each: self._set_attribute(each, target.attr, value))
                return
            for _, owner in alternatives(owners):
                self._set_attribute(owner, target.attr, value)
        elif isinstance(target, (ast.Tuple, ast.List)):
            self._unpack(target.elts, value, scope)
        elif isinstance(target, ast.Subscript):
            if self.exact:
                owner = self.evaluate(target.value, scope)
                self._each(owner, scope, self._writing(self._slice(target.slice, scope), value))
                return
            index = self.evaluate(target.slice, scope)
            for _, owner in alternatives(self.evaluate(target.value, scope)):
                self._set_item(owner, index, value)
        elif isinstance(target, ast.Starred):
            self.assign(target.value, UNKNOWN, scope)

    def _set_attribute(self, owner: Value, name: str, value: Value) -> None:
        if isinstance(owner, Super):
            owner = owner.receiver
        key = f"{SETTER}{name}"
        if isinstance(owner, Instance):
            setter = next((each.attributes[key] for each in owner.type.order if isinstance(each, Class) and key in each.attributes), None)
            if isinstance(setter, Function):
                self.call_function(setter, [owner, value], {})
            else:
                self.store(owner.attributes, name, value)
        elif isinstance(owner, Class):
            self.store(owner.attributes, name, value)
        elif isinstance(owner, Module):
            self.store(owner.scope.variables, name, value)
        elif isinstance(owner, Handle):
            self.store(owner.state, ("attribute", name), value)
        elif isinstance(owner, Function):
            self.store(self.function_attributes.setdefault(id(owner.node), {}), name, value)
        elif not isinstance(value, Unknown):
            self.escape([value], "start")

    def _set_item(self, owner: Value, index: Value, value: Value) -> None:
        if self.exact and isinstance(owner, (*SIMPLE, Function)):
            raise failure("TypeError", "object does not support item assignment")
        if self.exact and isinstance(owner, (Seq, Map, Instance)):
            self._set_item_exactly(owner, index, value)
            return
        if isinstance(owner, Map) and hashable(index) and len(owner.entries) < 1_000 and not (owner.is_alike and index in owner.entries):
            self.store(owner.content, ENTRIES, {**owner.entries, index: value})
        elif isinstance(owner, Seq) and isinstance(index, int) and -len(owner.items) <= index < len(owner.items):
            items = list(owner.items)
            if owner.is_alike:  # what stands for all of its like stays
                items.append(value)
            else:
                items[index] = value
            self.store(owner.content, ITEMS, items)
        elif isinstance(owner, (Map, Seq)):
            self.store(owner.content, COMPLETE, False)
            self.escape([value], "start")
        else:
            self.risks += 1
            if not isinstance(value, Unknown):
                self.escape([value], "start")

    def _unpack(self, targets: Sequence[ast.expr], value: Value, scope: Scope) -> None:
        items: list[Value] = [UNKNOWN] * len(targets)
        starred = any(isinstance(each, ast.Starred) for each in targets)
        if self.exact:
            self._unpack_exactly(targets, value, scope)
            return
        if isinstance(value, Seq) and value.complete and len(value.items) == len(targets) and not starred:
            items = value.items
        elif isinstance(value, Argv):
            items = [self.item(value, at) for at in range(len(targets))]
        for target, item in zip(targets, items, strict=True):
            self.assign(target, item, scope)

    def _return(self, node: ast.Return, scope: Scope) -> int:
        self.returned(self.evaluate(node.value, scope))
        return RETURNED

    def _raise(self, node: ast.Raise, scope: Scope) -> int:
        if self.exact:
            return self.raise_exactly(node, scope)
        if node.exc is not None:
            self.evaluate(node.exc, scope)
        return ENDED

    def _break(self, node: ast.Break, scope: Scope) -> int:
        return BROKEN

    def _continue(self, node: ast.Continue, scope: Scope) -> int:
        return CONTINUED

    def _assert(self, node: ast.Assert, scope: Scope) -> int:
        if self.exact:
            return self.assert_exactly(node, scope)
        self.evaluate(node.test, scope)
        return GOES_ON

    def _global(self, node: ast.Global, scope: Scope) -> int:
        for name in node.names:
            scope.shared[name] = scope.module.scope
        return GOES_ON

    def _nonlocal(self, node: ast.Nonlocal, scope: Scope) -> int:
        for name in node.names:
            outer = scope.outer
            while outer is not None and name not in outer.variables:
                outer = outer.outer
            if outer is not None:
                scope.shared[name] = outer
        return GOES_ON

    def lookup(self, name: str, scope: Scope) -> Value:
        """The value of a variable."""
        here: Scope | None = scope.shared.get(name, scope)
        if name in scope.own and name not in scope.variables and name not in scope.shared:
            raise failure("UnboundLocalError", f"cannot access local variable {name!r} where it is not associated with a value")
        while here is not None:
            if name in here.variables:
                return here.variables[name]
            here = here.outer
            if here is not None and "__qualname__" in here.variables and here is not scope:
                here = here.outer  # the names in a class body are not seen in its methods
        if name in builtins.NAMES:
            return External(f"builtins.{name}")
        if self.exact and not scope.module.stars:
            raise failure("NameError", f"name {name!r} is not defined")
        return self.from_stars(name, scope.module)

    def from_stars(self, name: str, module: Module) -> Value:
        """A name that some ``from x import *`` may have brought."""
        raise NotImplementedError

    # -- ways ---------------------------------------------------------------------------------------------------------

    def _if(self, node: ast.If, scope: Scope) -> int:
        if self.exact:
            return self.if_exactly(node, scope)
        known = self.truth(self.evaluate(node.test, scope))
        if known is not None:
            now, other = (node.body, node.orelse) if known else (node.orelse, node.body)
            if not changes_later(node.test, scope.module):
                return self.execute(now, scope)
            with self.branch("") as first:
                first.flow = self.execute(now, scope)
            said = negated(written(node.test)) if known else written(node.test)
            with self.branch(said) as later:
                later.flow = self.execute(other, scope)
            return self._meet([("", first), (said, later)], scope)
        said = written(node.test)
        otherwise = negated(said)
        with self.branch(said) as first:
            first.flow = self.execute(node.body, scope)
        with self.branch(otherwise) as second:
            second.flow = self.execute(node.orelse, scope)
        return self._meet([(said, first), (otherwise, second)], scope)

    def _meet(self, ways: list[tuple[str, Branch]], scope: Scope) -> int:
        """Go on behind an ``if``. What follows a way out of a function or loop stands under the condition of the other ways."""
        self.join(ways, scope.variables)
        flows = [way.flow for _, way in ways]
        if GOES_ON not in flows:
            return next((flow for flow in flows if flow != ENDED), ENDED)
        if any(flow in (BROKEN, CONTINUED, RETURNED) for flow in flows):
            staying = [condition for condition, way in ways if way.flow == GOES_ON]
            if len(staying) == 1 and staying[0]:
                self.conditions.append(staying[0])
        return GOES_ON

    def _else(self, node: ast.For | ast.AsyncFor | ast.While, scope: Scope) -> int:
        """The ``else`` of a loop: it may be passed over where there is a way to break out of the loop."""
        if not node.orelse:
            return GOES_ON
        if not any(isinstance(each, ast.Break) for statement in node.body for each in ast.walk(statement)):
            return self.execute(node.orelse, scope)
        with self.branch("") as branch:
            branch.flow = self.execute(node.orelse, scope)
        self.join([("", branch), ("", Branch())], scope.variables)
        return GOES_ON

    def _for(self, node: ast.For | ast.AsyncFor, scope: Scope) -> int:
        if self.exact:
            return self.for_exactly(node, scope)
        items, complete = self.rounds_of_each(self.evaluate(node.iter, scope))
        mark = len(self.conditions)
        if not items and changes_later(node.iter, scope.module):
            items, complete = [UNKNOWN], False
        if not complete:
            return self._some_rounds(node, items, scope)
        flow = GOES_ON
        for item in items:
            for condition, each in alternatives(item):
                if condition:
                    with self.branch(condition) as branch:
                        self.assign(node.target, each, scope)
                        branch.flow = self.execute(node.body, scope)
                    self.join([(condition, branch), (negated(condition), Branch())], scope.variables)
                else:
                    self.assign(node.target, each, scope)
                    flow = self.execute(node.body, scope)
            if flow in (BROKEN, RETURNED, ENDED):
                break
            flow = GOES_ON
        del self.conditions[mark:]
        if flow in (RETURNED, ENDED):
            return flow
        return GOES_ON if flow == BROKEN else self._else(node, scope)

    def _some_rounds(self, node: ast.For | ast.AsyncFor, items: list[Value], scope: Scope) -> int:
        """A loop of which not all rounds are known."""
        self._widen(node.body, scope)
        said = " ".join(f"for {ast.unparse(node.target)} in {written(node.iter)}".split())
        for each in items:
            condition, item = each.alternatives[0] if is_maybe(each) else ("", each)
            with self.branch(said if isinstance(item, Unknown) else condition) as branch:
                self.assign(node.target, item, scope)
                branch.flow = self.execute(node.body, scope)
                if branch.flow in (BROKEN, CONTINUED):
                    branch.flow = GOES_ON
            self.join([(said, branch), (negated(said), Branch())], scope.variables)
        return self._else(node, scope)

    def _while(self, node: ast.While, scope: Scope) -> int:
        if self.exact:
            return self.while_exactly(node, scope)
        mark = len(self.conditions)
        constant = isinstance(node.test, ast.Constant) or not any(isinstance(each, ast.Compare) for each in ast.walk(node.test))
        flow = GOES_ON
        for _ in range(MOST_ROUNDS):
            known = self.truth(self.evaluate(node.test, scope))
            if known is None or constant:
                break
            if not known and changes_later(node.test, scope.module):
                known = None
                break
            if not known:
                del self.conditions[mark:]
                return self._else(node, scope)
            flow = self.execute(node.body, scope)
            if flow in (BROKEN, RETURNED, ENDED):
                del self.conditions[mark:]
                return GOES_ON if flow == BROKEN else flow
        if known is False and not changes_later(node.test, scope.module):
            return self.execute(node.orelse, scope)
        self._widen(node.body, scope)
        if known:
            flow = self.execute(node.body, scope)
        else:
            with self.branch("") as branch:
                flow = branch.flow = self.execute(node.body, scope)
            self.join([(written(node.test), branch), (negated(written(node.test)), Branch())], scope.variables)
            flow = GOES_ON
        del self.conditions[mark:]
        return flow if flow in (RETURNED, ENDED) else GOES_ON

    def _widen(self, body: Sequence[ast.stmt], scope: Scope) -> None:
        """Variables that a loop makes of their own old value are unknown in its rounds."""
        key = id(body)
        if key not in self._changed:
            self._changed[key] = [target for statement in body for target in _changed(statement)]
        for target, augmented in self._changed[key]:
            if not augmented or not isinstance(self._quiet(target, scope), (Seq, Map)):
                self.assign(target, UNKNOWN, scope)

    def _quiet(self, target: ast.expr, scope: Scope) -> Value:
        return self.evaluate(target, scope) if isinstance(target, (ast.Name, ast.Attribute)) else UNKNOWN

    def _try(self, node: ast.Try, scope: Scope) -> int:
        if self.exact:
            return self.try_exactly(node, scope)
        flow = self.execute(node.body, scope)
        if flow == GOES_ON:
            flow = self.execute(node.orelse, scope)
        ways: list[tuple[str, Branch]] = [("", Branch())]
        ways[0][1].flow = flow
        for handler in node.handlers:
            said = f"except {ast.unparse(handler.type)}" if handler.type is not None else "except"
            with self.branch(said) as branch:
                if handler.name:
                    self.assign(ast.Name(handler.name, ast.Store()), UNKNOWN, scope)
                branch.flow = self.execute(handler.body, scope)
            ways.append((said, branch))
        self.join(ways, scope.variables)
        flows = [way.flow for _, way in ways]
        result = GOES_ON if GOES_ON in flows else next((each for each in flows if each != ENDED), ENDED)
        return self.execute(node.finalbody, scope) or result

    def _with(self, node: ast.With | ast.AsyncWith, scope: Scope) -> int:
        if self.exact:
            return self.with_exactly(node, scope)
        left: list[Instance] = []
        for item in node.items:
            value = self.evaluate(item.context_expr, scope)
            entered = value if isinstance(value, (Instance, Handle)) else UNKNOWN
            if isinstance(value, Instance):
                left.append(value)
                enter = self.attribute(value, "__enter__", node, scope)
                entered = self.call(enter, [], {}, node, scope) if isinstance(enter, Bound) else value
            if item.optional_vars is not None:
                self.assign(item.optional_vars, entered, scope)
        flow = self.execute(node.body, scope)
        for value in reversed(left):
            leave = self.attribute(value, "__exit__", node, scope)
            if flow == GOES_ON and isinstance(leave, Bound):
                self.call(leave, [UNKNOWN] * 3, {}, node, scope)
        return flow

    def _match(self, node: ast.Match, scope: Scope) -> int:
        if self.exact:
            return self.match_exactly(node, scope)
        self.evaluate(node.subject, scope)
        subject = ast.unparse(node.subject)
        ways: list[tuple[str, Branch]] = []
        for case in node.cases:
            said = f"{subject} is {ast.unparse(case.pattern)}"
            with self.branch(said) as branch:
                for each in ast.walk(case.pattern):
                    if isinstance(each, (ast.MatchAs, ast.MatchStar)) and each.name is not None:
                        self.assign(ast.Name(each.name, ast.Store()), UNKNOWN, scope)
                branch.flow = self.execute(case.body, scope)
            ways.append((said, branch))
        return self._meet([*ways, ("", Branch())], scope)


def _in_place(left: Value, operation: type[ast.operator], right: Value) -> str:
    """The method that changes what stands left of an operator such as ``|=``; empty where there is none."""
    if isinstance(left, Map):
        return _IN_PLACE.get(("dict", operation), "")
    if isinstance(left, Seq) and isinstance(right, Seq) and left.kind == "set" and right.kind in ("set", "frozenset"):
        return _IN_PLACE.get(("set", operation), "")
    return ""


_IN_PLACE: dict[tuple[str, type[ast.operator]], str] = {
    ("set", ast.BitOr): "update",
    ("set", ast.BitAnd): "intersection_update",
    ("set", ast.Sub): "difference_update",
    ("dict", ast.BitOr): "update",
}
"""Operators that change what stands left of them."""


def _changed(statement: ast.stmt) -> Iterator[tuple[ast.expr, bool]]:
    """What a statement makes of its own old value, and whether by ``+=`` and the like."""
    for each in ast.walk(statement):
        if isinstance(each, ast.AugAssign):
            yield each.target, True
        elif isinstance(each, ast.Assign) and len(each.targets) == 1 and isinstance(each.value, (ast.BinOp, ast.Call)):
            target = each.targets[0]
            if isinstance(target, (ast.Name, ast.Attribute)):
                own = ast.dump(target).replace("Store()", "Load()")
                if any(isinstance(part, type(target)) and ast.dump(part) == own for part in ast.walk(each.value)):
                    yield target, False


def changes_later(test: ast.expr, module: Module) -> bool:
    """Whether a condition asks for an attribute or global variable that some function sets: it may be otherwise when it is asked again."""
    later = module.set_later
    return bool(later) and any(
        (isinstance(each, ast.Attribute) and each.attr in later) or (isinstance(each, ast.Name) and each.id in later)
        for each in ast.walk(test)
    )


_EXECUTE: dict[type[ast.stmt], Callable[[Statements, Value, Scope], int]] = {
    ast.Expr: Statements._expression,
    ast.Assign: Statements._assign,
    ast.AnnAssign: Statements._annotated,
    ast.AugAssign: Statements._augmented,
    ast.Delete: Statements._delete,
    ast.Return: Statements._return,
    ast.Raise: Statements._raise,
    ast.Break: Statements._break,
    ast.Continue: Statements._continue,
    ast.Assert: Statements._assert,
    ast.Global: Statements._global,
    ast.Nonlocal: Statements._nonlocal,
    ast.If: Statements._if,
    ast.For: Statements._for,
    ast.AsyncFor: Statements._for,
    ast.While: Statements._while,
    ast.Try: Statements._try,
    ast.With: Statements._with,
    ast.AsyncWith: Statements._with,
    ast.Match: Statements._match,
    ast.FunctionDef: Statements._function_definition,
    ast.AsyncFunctionDef: Statements._function_definition,
    ast.ClassDef: Statements._class_definition,
    ast.Import: Statements._import,
    ast.ImportFrom: Statements._import_from,
}
