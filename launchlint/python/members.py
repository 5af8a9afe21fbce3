"""Attributes of objects, classes and modules, by names that stand in the source or are worked out."""

from __future__ import annotations

import ast
from collections.abc import Sequence

from launchlint.python.attributes import lacks
from launchlint.python.expressions import Expressions
from launchlint.python.plain import SIMPLE
from launchlint.python.recogniser import Recogniser
from launchlint.python.text import may_be
from launchlint.python.values import (
    MISSING,
    UNKNOWN,
    Argv,
    Bound,
    Choice,
    Class,
    External,
    Failure,
    Function,
    Handle,
    Instance,
    Map,
    Module,
    Outside,
    Scope,
    Seq,
    Super,
    Text,
    Unknown,
    Value,
    alternatives,
    choice,
)

FIELDS = "\0fields"
"""In a class: the names that have an annotation, in order."""


def has_known_attributes(value: Value) -> bool:
    """Whether it is known which attributes an object has."""
    if isinstance(value, (*SIMPLE, Seq, Map, Text)):
        return True
    return isinstance(value, Instance) and all(isinstance(each, Class) or each == External("builtins.object") for each in value.type.order)


class Members(Expressions):
    """``value.name``."""

    def __init__(self, recogniser: Recogniser) -> None:
        super().__init__(recogniser)
        self.unknown_methods: set[str] = set()
        self.function_attributes: dict[int, dict[str, Value]] = {}
        self._asking = False
        """Whether a ``__getattr__`` is being followed: what is missing in there is not asked for again."""

    def call_function(self, function: Function, positional: list[Value], keywords: dict[str, Value]) -> Value:
        """Call a function of the program with its parameters bound."""
        raise NotImplementedError

    def submodule(self, module: Module, name: str) -> Value:
        """A module of a package, by its name in it; MISSING where there is none."""
        raise NotImplementedError

    def _names(self, word: str, positional: list[Value], scope: Scope) -> Value:
        """``locals()``, ``dir(x)`` and the like."""
        names: dict[Value, Value] = {}
        if not positional:
            names = dict((scope.module.scope if word == "globals" else scope).variables)
        elif isinstance(positional[0], (Instance, Class)):
            type_ = positional[0].type if isinstance(positional[0], Instance) else positional[0]
            for each in reversed([base for base in type_.order if isinstance(base, Class)]):
                names.update(each.attributes)
            names.update(positional[0].attributes)
        else:
            return UNKNOWN
        return Seq(sorted(str(name) for name in names)) if word == "dir" else Map(names)

    def _super(self, positional: list[Value], scope: Scope) -> Value:
        if len(positional) >= 2 and isinstance(positional[0], Class):
            return Super(positional[0], positional[1])
        here: Scope | None = scope
        while here is not None and "__class__" not in here.variables:
            here = here.outer
        if here is None:
            return UNKNOWN
        return Super(here.variables["__class__"], next(iter(here.variables.values()), UNKNOWN))

    def _getattr(self, word: str, positional: list[Value], node: ast.AST, scope: Scope) -> Value:
        if word == "getattr" and not isinstance(positional[1], str):
            for _, owner in alternatives(positional[0]):
                self._any_attribute(owner, positional[1], node, scope)
        if word == "hasattr" or not isinstance(positional[1], str):
            return UNKNOWN
        found = self.attribute(positional[0], positional[1], node, scope)
        return found if not isinstance(found, Unknown) or len(positional) < 3 else choice([("", UNKNOWN), ("", positional[2])])

    def _any_attribute(self, owner: Value, pattern: Value, node: ast.AST, scope: Scope) -> None:
        """An attribute is asked for by a name that is not known."""
        if isinstance(owner, External):
            for name in self.recogniser.mattering(owner.name):
                if may_be(name, pattern):
                    reason = f"something of {owner.name} is asked for by a name that is not known"
                    self.doubt(reason, scope.module.path, getattr(node, "lineno", 1))
                    break
            return
        names: list[str] = []
        if isinstance(owner, (Instance, Class)):
            type_ = owner.type if isinstance(owner, Instance) else owner
            names = [name for each in type_.order if isinstance(each, Class) for name in each.attributes]
        elif isinstance(owner, Module):
            names = list(owner.scope.variables)
        fitting = [name for name in dict.fromkeys(names) if may_be(name, pattern)]
        if isinstance(pattern, Text) or isinstance(owner, Module):
            self.escape([self.attribute(owner, name, node, scope) for name in fitting], "start")
        else:
            self.unknown_methods.update(fitting)

    def attribute(self, value: Value, name: str, node: ast.AST, scope: Scope) -> Value:
        """``value.name``."""
        if isinstance(value, Choice) and self.exact:
            return self.spread(lambda each: self.attribute(each, name, node, scope), value)
        if isinstance(value, Choice):
            return choice([(condition, self.attribute(each, name, node, scope)) for condition, each in value.alternatives])
        if isinstance(value, Instance):
            return self._of_instance(value, name)
        if isinstance(value, External):
            return self.recogniser.attribute(value.name, name)
        if isinstance(value, Module):
            found = value.scope.variables.get(name, MISSING)
            return self.submodule(value, name) if found is MISSING else found
        if isinstance(value, Class):
            return self._of_class(value, name, None, value)
        if isinstance(value, Super):
            return self._of_super(value, name)
        if isinstance(value, Handle):
            found = value.state.get(("attribute", name), MISSING)
            if found is MISSING:
                found = self.recogniser.member(value, name)
            return Bound(value, name) if found is MISSING else found
        if self.exact and lacks(value, name):
            return self.fails("AttributeError", f"object has no attribute {name!r}")
        if isinstance(value, (str, Text, Outside, Seq, Map, Argv)):
            return Bound(value, name)
        if isinstance(value, Failure):
            return self._of_failure(value, name)
        if isinstance(value, Unknown):
            self.risks += 1
            self.unknown_methods.add(name)
        code = value.function if isinstance(value, Bound) else value
        if isinstance(code, Function) and name in self.function_attributes.get(id(code.node), ()):
            return self.function_attributes[id(code.node)][name]
        if isinstance(value, Function) and name == "__name__" and not isinstance(value.node, ast.Lambda):
            return value.node.name
        return self.unknown()

    def _of_failure(self, value: Failure, name: str) -> Value:
        if name == "args":
            return Seq(list(value.arguments), is_tuple=True)
        return value.type if name == "__class__" else UNKNOWN

    def _of_instance(self, instance: Instance, name: str) -> Value:
        if name in instance.attributes:
            return instance.attributes[name]
        if name == "__class__":
            return instance.type
        found = self._of_class(instance.type, name, instance, instance.type)
        if isinstance(found, Unknown) and not any(isinstance(each, Class) and name in each.attributes for each in instance.type.order):
            asked = self._asked(instance, name)
            found = found if asked is MISSING else asked
        if isinstance(found, Unknown):
            self.unknown_methods.add(name)
            if self.exact and has_known_attributes(instance) and not name.startswith("__"):
                return self._lacking(instance, name)
        return found

    def _asked(self, instance: Instance, name: str) -> Value:
        """What ``__getattr__`` of the object's class gives for an attribute that it does not have; MISSING where there is none."""
        if name.startswith("__") or self._asking:
            return MISSING
        asked = self._found([each for each in instance.type.order if isinstance(each, Class)], "__getattr__", instance, instance.type)
        if not isinstance(asked, Bound) or not isinstance(asked.function, Function):
            return MISSING
        self._asking = True
        try:
            return self.call_function(asked.function, [instance, name], {})
        finally:
            self._asking = False

    def _lacking(self, instance: Instance, name: str) -> Value:
        """An attribute that an object does not have."""
        if any(isinstance(each, Class) and name in each.attributes for each in instance.type.order):
            return UNKNOWN
        if any(
            isinstance(each, Class) and {"__getattr__", "__getattribute__", FIELDS} & each.attributes.keys() for each in instance.type.order
        ):
            return UNKNOWN
        return self.fails("AttributeError", f"{instance.type.name!r} object has no attribute {name!r}")

    def _of_super(self, value: Super, name: str) -> Value:
        receiver = value.receiver
        type_ = receiver.type if isinstance(receiver, Instance) else receiver
        order = type_.behind(value.after) if isinstance(type_, Class) else value.after.order[1:]
        found = self._found(order, name, receiver if isinstance(receiver, Instance) else None, type_ if isinstance(type_, Class) else None)
        return External("builtins.object.__new__") if isinstance(found, Unknown) and name == "__new__" else found

    def _of_class(self, type_: Class, name: str, receiver: Instance | None, cls: Class | None) -> Value:
        if name == "__name__":
            return type_.name
        return self._found(type_.order, name, receiver, cls)

    def _found(self, order: Sequence[Value], name: str, receiver: Instance | None, cls: Class | None) -> Value:
        for base in order:
            if isinstance(base, External):
                if base.name == "builtins.object":
                    continue
                return Bound(receiver, External(f"{base.name}.{name}")) if receiver is not None else External(f"{base.name}.{name}")
            if isinstance(base, Class) and name in base.attributes:
                found = base.attributes[name]
                return choice([(condition, self._bound(each, receiver, cls)) for condition, each in alternatives(found)])
        return UNKNOWN

    def _bound(self, found: Value, receiver: Instance | None, cls: Class | None) -> Value:
        if not isinstance(found, Function):
            return found
        if found.kind == "static":
            return found
        if found.kind == "class":
            return Bound(cls, found)
        if receiver is None:
            return found
        return self.call_function(found, [receiver], {}) if found.kind == "property" else Bound(receiver, found)
