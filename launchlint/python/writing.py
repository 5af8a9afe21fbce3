"""Items and attributes written and deleted, to the letter."""

from __future__ import annotations

import ast
from collections.abc import Callable, Sequence

from launchlint.python.exact import Exact
from launchlint.python.failures import failure, of_python
from launchlint.python.memory import GOES_ON
from launchlint.python.plain import SIMPLE
from launchlint.python.values import (
    COMPLETE,
    ENTRIES,
    ITEMS,
    MISSING,
    MOST_EXACT,
    UNKNOWN,
    Choice,
    Class,
    Instance,
    Key,
    Map,
    Scope,
    Seq,
    Value,
    is_maybe,
)


class Writing(Exact):
    """Assignments and ``del`` of a program that is followed to the letter."""

    def _set_item(self, owner: Value, index: Value, value: Value) -> None:
        raise NotImplementedError

    def _each(self, owners: Value, scope: Scope, write: Callable[[Value], None]) -> None:
        """Write to what may be one of several things."""
        if not isinstance(owners, Choice):
            write(owners)
            return
        self.either([(condition, self._each_one(each, write)) for condition, each in owners.alternatives], scope)

    def _each_one(self, owner: Value, write: Callable[[Value], None]) -> Callable[[], Value]:
        return lambda: write(owner)

    def _writing(self, index: Value, value: Value) -> Callable[[Value], None]:
        return lambda owner: self._set_item(owner, index, value)

    def _set_item_exactly(self, owner: Seq | Map | Instance, index: Value, value: Value) -> None:
        if isinstance(owner, Instance):
            self._by_method(owner, "__setitem__", [index, value])
            return
        if isinstance(owner, Map):
            if isinstance(index, slice):
                raise failure("TypeError", "unhashable type: 'slice'")
            key = self.key(index)
            known = isinstance(key, (str, int, float, type(None), Key)) and len(owner.entries) < MOST_EXACT
            self.spend(len(owner.entries))
            self.store(owner.content, ENTRIES, {**owner.entries, key: value} if known else {})
            if not known:
                self.store(owner.content, COMPLETE, False)
            return
        if owner.kind in ("tuple", "range", "set", "frozenset"):
            raise failure("TypeError", f"{owner.kind!r} object does not support item assignment")
        items = list(owner.items)
        self.spend(len(items))
        if isinstance(index, (str, float, type(None), Seq, Map)):
            raise failure("TypeError", "list indices must be integers or slices")
        try:
            if isinstance(index, slice) and owner.is_sure:
                more, complete = self.rounds(value)
                if complete:
                    items[index] = more
                    self.store(owner.content, ITEMS, items)
                    return
            elif isinstance(index, int) and owner.is_sure:
                items[index] = value
                self.store(owner.content, ITEMS, items)
                return
        except (IndexError, ValueError) as error:
            raise of_python(error) from None
        self.store(owner.content, ITEMS, [each if is_maybe(each) else Choice((("", each),)) for each in items])
        self.store(owner.content, COMPLETE, False)

    def _unpack_exactly(self, targets: Sequence[ast.expr], value: Value, scope: Scope) -> None:
        if isinstance(value, Choice):
            self._each(value, scope, lambda each: self._unpack_exactly(targets, each, scope))
            return
        items, complete = self.rounds(value)
        star = next((at for at, each in enumerate(targets) if isinstance(each, ast.Starred)), None)
        if not complete or any(map(is_maybe, items)):
            for each in targets:
                self.assign(each, UNKNOWN, scope)
            return
        if len(items) < len(targets) - (star is not None) or (star is None and len(items) > len(targets)):
            raise failure("ValueError", "not enough values to unpack" if len(items) < len(targets) else "too many values to unpack")
        if star is not None:
            behind = len(items) - (len(targets) - star - 1)
            items = [*items[:star], Seq(items[star:behind]), *items[behind:]]
        for target, item in zip(targets, items, strict=True):
            self.assign(target.value if isinstance(target, ast.Starred) else target, item, scope)

    def _delete(self, node: ast.Delete, scope: Scope) -> int:
        for target in node.targets:
            if isinstance(target, ast.Name):
                if self.exact and target.id not in scope.shared.get(target.id, scope).variables:
                    raise failure("NameError", f"name {target.id!r} is not defined")
                self.store((scope.shared.get(target.id, scope) if self.exact else scope).variables, target.id, MISSING)
            elif self.exact:
                self._delete_exactly(target, scope)
        return GOES_ON

    def _delete_exactly(self, target: ast.expr, scope: Scope) -> None:
        if isinstance(target, (ast.Tuple, ast.List)):
            for each in target.elts:
                self._delete(ast.Delete([each]), scope)
        elif isinstance(target, ast.Attribute):
            owner = self.evaluate(target.value, scope)
            if isinstance(owner, (Instance, Class)) and target.attr in owner.attributes:
                self.store(owner.attributes, target.attr, MISSING)
            elif isinstance(owner, Instance):
                raise failure("AttributeError", target.attr)
        elif isinstance(target, ast.Subscript):
            index = self._slice(target.slice, scope)
            self._each(self.evaluate(target.value, scope), scope, lambda owner: self._delete_item(owner, index))

    def _delete_item(self, owner: Value, index: Value) -> None:
        if isinstance(owner, Map):
            key = self.key(index)
            if not isinstance(key, (str, int, float, type(None), Key)) or not owner.complete or is_maybe(owner.entries.get(key)):
                self.store(owner.content, ENTRIES, {})
                self.store(owner.content, COMPLETE, False)
                self.risks += 1
            elif key not in owner.entries:
                raise failure("KeyError", index)
            else:
                self.store(owner.content, ENTRIES, {each: value for each, value in owner.entries.items() if each != key})
        elif isinstance(owner, Seq) and owner.kind == "list":
            if not owner.is_sure or not isinstance(index, (int, slice)):
                self.store(owner.content, ITEMS, [each if is_maybe(each) else Choice((("", each),)) for each in owner.items])
                self.store(owner.content, COMPLETE, False)
                self.risks += 1
                return
            items = list(owner.items)
            try:
                del items[index]
            except IndexError as error:
                raise of_python(error) from None
            self.store(owner.content, ITEMS, items)
        elif isinstance(owner, (Seq, *SIMPLE)):
            raise failure("TypeError", "object doesn't support item deletion")
        else:
            self.risks += 1
