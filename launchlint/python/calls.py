"""Calls: functions, methods and classes of the program, and what is passed on to modules that are not followed."""

from __future__ import annotations

import ast
from collections.abc import Sequence

from launchlint.python import builtins
from launchlint.python.call import Call
from launchlint.python.expressions import Expressions
from launchlint.python.memory import ENDED, GOES_ON, Ended
from launchlint.python.recogniser import Recogniser
from launchlint.python.text import may_be
from launchlint.python.values import (
    MISSING,
    MORE,
    UNKNOWN,
    Argv,
    Bound,
    Choice,
    Class,
    External,
    Function,
    Handle,
    Instance,
    Map,
    Module,
    Outside,
    Partial,
    Scope,
    Seq,
    Super,
    Text,
    Unknown,
    Value,
    alternatives,
    choice,
    conjunction,
)

DEEPEST_CALL = 30
MOST_CALLBACKS = 500
MOST_INSTANCES = 2_000
MOST_SPENT = 15_000
"""Steps in calls of one function that made nothing, before it is not followed any more."""


class Callback:
    """A function that somebody else will call: with what, and under which conditions that was arranged."""

    __slots__ = ("condition", "function", "keywords", "known", "positional", "when")

    def __init__(self, function: Value, positional: list[Value] | None, keywords: dict[str, Value], when: str, condition: str) -> None:
        self.function = function
        self.known = positional is not None
        self.positional = positional or []
        self.keywords = keywords
        self.when = when
        self.condition = condition


class Calls(Expressions):
    """Calling and attributes."""

    def __init__(self, recogniser: Recogniser) -> None:
        super().__init__(recogniser)
        self.active: list[int] = []
        self.executed: set[int] = set()
        self.callbacks: list[Callback] = []
        self.arranged: set[tuple[int, int]] = set()
        self.instances: list[Instance] = []
        self.escaped: list[Instance] = []
        self.given_classes: list[Class] = []
        self.unknown_methods: set[str] = set()
        self.function_attributes: dict[int, dict[str, Value]] = {}
        self._returns: list[list[tuple[str, Value]]] = []
        self._yields: list[list[Value]] = []
        self._marks: list[int] = []
        self._spent: dict[int, int] = {}

    def execute(self, body: Sequence[ast.stmt], scope: Scope) -> int:
        """Go through statements; how that ended."""
        raise NotImplementedError

    def module(self, name: Value, made: Call) -> Value:
        """A module by a name that the program has worked out."""
        raise NotImplementedError

    def made_code(self, word: str, positional: list[Value], keywords: dict[str, Value], node: ast.AST, scope: Scope) -> Value:
        """Code, or the name of a module, that the program has worked out."""
        raise NotImplementedError

    def submodule(self, module: Module, name: str) -> Value:
        """A module of a package, by its name in it; MISSING where there is none."""
        raise NotImplementedError

    # -- calling ------------------------------------------------------------------------------------------------------

    def call(self, function: Value, positional: list[Value], keywords: dict[str, Value], node: ast.AST, scope: Scope) -> Value:
        """Call ``function`` from a place in the module of ``scope``."""
        if isinstance(function, Function):
            return self.call_function(function, positional, keywords)
        if isinstance(function, Bound):
            if isinstance(function.function, Function):
                return self.call_function(function.function, [function.receiver, *positional], keywords)
            return self.call_method(function.receiver, function.function, positional, keywords, node, scope)
        if isinstance(function, Class):
            return self.create(function, positional, keywords, node, scope)
        if isinstance(function, Partial):
            return self.call(function.function, [*function.positional, *positional], {**dict(function.keywords), **keywords}, node, scope)
        if isinstance(function, External):
            return self.call_external(function.name, positional, keywords, node, scope)
        if isinstance(function, Instance):
            method = self.attribute(function, "__call__", node, scope)
            if isinstance(method, Bound):
                return self.call(method, positional, keywords, node, scope)
        if isinstance(function, Choice):
            return choice([(condition, self.call(each, positional, keywords, node, scope)) for condition, each in function.alternatives])
        self._give([*positional, *keywords.values()], node, scope)
        return UNKNOWN

    def _give(self, values: list[Value], node: ast.AST, scope: Scope) -> None:
        """Values are given to something of which nothing is known."""
        self.escape(values, "start")
        for value in values:
            if isinstance(value, External) and self.recogniser.matters(value.name):
                self.doubt(f"{value.name} is given to code that is not known", scope.module.path, getattr(node, "lineno", 1))

    def call_external(self, name: str, positional: list[Value], keywords: dict[str, Value], node: ast.AST, scope: Scope) -> Value:
        """Call something of a module that is not followed."""
        if name.startswith("builtins."):
            word = name[len("builtins.") :]
            keywords = {key: value for key, value in keywords.items() if key != MORE}
            if word in ("exit", "quit"):
                raise Ended
            if word in ("eval", "exec", "execfile", "__import__"):
                return self.made_code(word, positional, keywords, node, scope)
            if word == "object.__new__" and positional and isinstance(positional[0], Class):
                return self.instance(positional[0])
            if word == "super":
                return self._super(positional, scope)
            if word in ("getattr", "hasattr") and len(positional) > 1:
                return self._getattr(word, positional, node, scope)
            if word == "setattr" and len(positional) == 3 and isinstance(positional[1], str) and isinstance(positional[0], Instance):
                self.store(positional[0].attributes, positional[1], positional[2])
                return None
            if word in ("locals", "globals", "vars", "dir") and (not positional or word in ("vars", "dir")):
                return self._names(word, positional, scope)
            if word in ("map", "filter") and len(positional) > 1:
                items, complete = self.rounds(positional[1])
                results = [self.call(positional[0], [item], {}, node, scope) for item in items]
                return Seq(results if word == "map" else items, complete and word == "map")
            if word not in builtins.KEEPING:
                self.escape([*positional, *keywords.values()], "start")
            return builtins.function(self, word, positional, keywords)
        return self.recogniser.call(name, positional, keywords, node, scope)

    def call_method(
        self, receiver: Value, name: Value, positional: list[Value], keywords: dict[str, Value], node: ast.AST, scope: Scope
    ) -> Value:
        """Call a method of something that is no object of a followed class."""
        if isinstance(name, External):  # a method that a followed class inherits from one that is not followed
            if isinstance(receiver, Instance) and name.name.endswith(".__init__"):
                self.recogniser.inherited(name.name[: -len(".__init__")], receiver, positional, keywords, node, scope)
                return None
            return self.recogniser.inherited_method(name.name, receiver, positional, keywords, node, scope)
        if isinstance(receiver, Handle):
            return self.recogniser.method(receiver, str(name), positional, keywords, node, scope)
        if isinstance(receiver, (str, Text, Outside, Seq, Map, Argv)):
            result = builtins.method(self, receiver, str(name), positional, keywords)
            if isinstance(result, Unknown):
                self.escape([*positional, *keywords.values()], "start")
            return result
        self.escape([*positional, *keywords.values()], "start")
        return UNKNOWN

    def call_function(self, function: Function, positional: list[Value], keywords: dict[str, Value]) -> Value:
        """Call a function of the program with its parameters bound."""
        node = function.node
        self.step()
        spent = self._spent.get(id(node), 0)
        if self.active.count(id(node)) >= 2 or len(self.active) >= DEEPEST_CALL or spent > MOST_SPENT:
            if id(node) not in self.executed:
                self.doubt("it calls functions in functions too deep to be followed", function.scope.module.path, node.lineno)
            return UNKNOWN
        begin, before = self.steps, (self.outcome, len(self.callbacks))
        result = self._run(function, positional, keywords)
        if before == (self.outcome, len(self.callbacks)):
            self._spent[id(node)] = spent + self.steps - begin
        else:
            self._spent[id(node)] = 0
        return result

    def _run(self, function: Function, positional: list[Value], keywords: dict[str, Value]) -> Value:
        node = function.node
        scope = Scope(function.scope.module, function.scope)
        self._bind(function, positional, keywords, scope)
        if function.owner is not None:
            scope.variables["__class__"] = function.owner
        self.executed.add(id(node))
        if isinstance(node, ast.Lambda):
            self.active.append(id(node))
            try:
                return self.evaluate(node.body, scope)
            finally:
                self.active.pop()
        mark = len(self.conditions)
        self._returns.append([])
        self._yields.append([])
        self._marks.append(mark)
        self.active.append(id(node))
        flow = ENDED
        try:
            flow = self.execute(node.body, scope)
        finally:
            self.active.pop()
            self._marks.pop()
            returned, yielded = self._returns.pop(), self._yields.pop()
            del self.conditions[mark:]
        if yielded:
            return Seq(yielded, False)
        if flow == ENDED and not returned:
            raise Ended
        if flow == GOES_ON:
            returned.append(("", None))
        return choice(returned)

    def returned(self, value: Value) -> None:
        """Take what a ``return`` gives."""
        if self._returns:
            self._returns[-1].append((conjunction(self.conditions[self._marks[-1] :]), value))

    def yielded(self, value: Value) -> None:
        """Take what a generator gives."""
        if self._yields:
            self._yields[-1].append(value)

    def _bind(self, function: Function, positional: list[Value], keywords: dict[str, Value], scope: Scope) -> None:
        arguments = function.node.args
        names = [each.arg for each in (*arguments.posonlyargs, *arguments.args)]
        variables = scope.variables
        for name, default in zip(names[len(names) - len(function.defaults) :], function.defaults, strict=True):
            variables[name] = default
        variables.update(function.keyword_defaults)
        variables.update(zip(names, positional, strict=False))
        known = {*names, *(each.arg for each in arguments.kwonlyargs)}
        if MORE in keywords:  # any of those that are not given otherwise may be given, too
            variables.update(dict.fromkeys(known.difference(names[: len(positional)]), UNKNOWN))
        variables.update({name: value for name, value in keywords.items() if name in known})
        for name in known:
            variables.setdefault(name, UNKNOWN)
        if arguments.vararg is not None:
            variables[arguments.vararg.arg] = Seq(positional[len(names) :])
        if arguments.kwarg is not None:
            others = {name: value for name, value in keywords.items() if name not in known and name != MORE}
            variables[arguments.kwarg.arg] = Map(others, MORE not in keywords)

    def create(self, type_: Class, positional: list[Value], keywords: dict[str, Value], node: ast.AST, scope: Scope) -> Value:
        """Make an object of a followed class."""
        instance: Value = self.instance(type_)
        maker = next((each.attributes["__new__"] for each in type_.order if isinstance(each, Class) and "__new__" in each.attributes), None)
        if isinstance(maker, Function):
            made = self.call_function(maker, [type_, *positional], keywords)
            instance = next((each for _, each in alternatives(made) if isinstance(each, Instance)), instance)
        place = (scope.module.path, getattr(node, "lineno", 1))
        for base in type_.order:
            if not isinstance(base, (Class, External)):
                self.doubt(f"{type_.name} inherits from a class that is not known", *place)
            elif isinstance(base, External) and self.recogniser.is_open(base.name):
                self.doubt(f"it inherits from {base.name}, whose source was not given", *place)
        foreign = False
        for base in type_.order:
            if isinstance(base, External) and base.name != "builtins.object" and not foreign:
                self.recogniser.inherited(base.name, instance, positional, keywords, node, scope)
                foreign = True
            elif isinstance(base, Class) and "__init__" in base.attributes:
                if foreign:  # whether the class before it calls it cannot be seen
                    self.escape([Bound(instance, each) for _, each in alternatives(base.attributes["__init__"])], "start")
                    break
                for _, each in alternatives(base.attributes["__init__"]):
                    if isinstance(each, Function):
                        self.call_function(each, [instance, *positional], keywords)
                break
        return instance

    def instance(self, type_: Class) -> Instance:
        """A new object of a class, before its constructor is called."""
        instance = Instance(type_)
        if len(self.instances) < MOST_INSTANCES:
            self.instances.append(instance)
        elif len(self.instances) == MOST_INSTANCES:
            self.doubt("it makes too many objects to be followed", type_.scope.module.path, 1)
        return instance

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

    # -- attributes -----------------------------------------------------------------------------------------------------

    def attribute(self, value: Value, name: str, node: ast.AST, scope: Scope) -> Value:
        """``value.name``."""
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
        if isinstance(value, (str, Text, Outside, Seq, Map, Argv)):
            return Bound(value, name)
        if isinstance(value, Unknown):
            self.unknown_methods.add(name)
        code = value.function if isinstance(value, Bound) else value
        if isinstance(code, Function) and name in self.function_attributes.get(id(code.node), ()):
            return self.function_attributes[id(code.node)][name]
        if isinstance(value, Function) and name == "__name__" and not isinstance(value.node, ast.Lambda):
            return value.node.name
        return UNKNOWN

    def _of_instance(self, instance: Instance, name: str) -> Value:
        if name in instance.attributes:
            return instance.attributes[name]
        if name == "__class__":
            return instance.type
        found = self._of_class(instance.type, name, instance, instance.type)
        if isinstance(found, Unknown):
            self.unknown_methods.add(name)
        return found

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

    def lost(self, values: list[Value]) -> None:
        """Values that can be one of too many to be told apart any more: what can be called may be."""
        self.escape(values, "start")

    # -- what others call -------------------------------------------------------------------------------------------------

    def escape(self, values: Sequence[Value], when: str, depth: int = 0) -> None:
        """Values are given to code that is not followed: it may call what can be called."""
        for value in values:
            for _, each in alternatives(value):
                if isinstance(each, (Function, Partial)) or (isinstance(each, Bound) and isinstance(each.function, Function)):
                    self.arrange(each, when)
                elif isinstance(each, Instance):
                    if not any(each is other for other in self.escaped):
                        self.escaped.append(each)
                elif isinstance(each, Class):
                    if any(isinstance(base, External) and not base.name.startswith("builtins.") for base in each.order):
                        self.arrange(each, when)
                    else:
                        self.given_classes.append(each)
                elif isinstance(each, (Seq, Map)) and depth < 4:
                    inner = each.items if isinstance(each, Seq) else list(each.entries.values())
                    self.escape(inner, when, depth + 1)

    def arrange(self, function: Value, when: str, positional: list[Value] | None = None, keywords: dict[str, Value] | None = None) -> None:
        """Have a function called when the program has come to its end; ``positional`` where it is known with what."""
        for _, each in alternatives(function):
            inner = each.function if isinstance(each, Partial) else each
            receiver = inner.receiver if isinstance(inner, Bound) else None
            code = inner.function if isinstance(inner, Bound) else inner
            if isinstance(code, (Instance, Class)):
                receiver = code
            elif not isinstance(code, Function):
                continue
            key = (id(code.node) if isinstance(code, Function) else 0, id(receiver))
            if key in self.arranged and positional is None:
                continue
            if len(self.callbacks) >= MOST_CALLBACKS:
                self.doubt("it has too many callbacks to be followed", "", 0)
                continue
            self.arranged.add(key)
            self.callbacks.append(Callback(each, positional, keywords or {}, when, conjunction(self.conditions)))
