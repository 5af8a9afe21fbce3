"""Calls: functions, methods and classes of the program, and what is passed on to modules that are not followed."""

from __future__ import annotations

import ast
from collections.abc import Sequence

from launchlint.python import builtins, functions
from launchlint.python.arguments import check_arguments, is_generator, own_names
from launchlint.python.call import Call
from launchlint.python.failures import Raised, failure, is_failure_class
from launchlint.python.letter import LATER, MORE_ITEMS
from launchlint.python.members import FIELDS, Members, has_known_attributes
from launchlint.python.memory import ENDED, GOES_ON, RETURNED, Ended, Exhausted
from launchlint.python.plain import SIMPLE
from launchlint.python.recogniser import Recogniser
from launchlint.python.text import ANY_TEXT
from launchlint.python.values import (
    MISSING,
    MORE,
    MOST_EXACT,
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
    Partial,
    Quiet,
    Scope,
    Seq,
    Text,
    Unknown,
    Value,
    alternatives,
    choice,
    conjunction,
    is_maybe,
)

DEEPEST_CALL = 30
MOST_CALLBACKS = 500
_PLAIN_BASES = ("abc.ABC", "typing.Protocol", "typing.Generic")
DATA = "\0data"
"""In a class: it is a data class."""
MOST_INSTANCES = 2_000
MOST_SPENT = 15_000
"""Steps in calls of one function that made nothing, before it is not followed any more."""


_KNOWN = frozenset("all any max min next reversed sum tuple list set frozenset iter callable type".split())
"""Functions that keep nothing of what they are given but in what they give back."""


def _python_class(type_: Class) -> Value:
    """The first class of exceptions outside of the program that a followed class is made of."""
    return next(each for each in type_.order if is_failure_class(each))


def _has(type_: Class, name: str) -> bool:
    return any(isinstance(each, Class) and name in each.attributes for each in type_.order)


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


class Calls(Members):
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
        if self.exact and isinstance(function, (*SIMPLE, Seq, Map, Failure)):
            return self.fails("TypeError", "object is not callable")
        if isinstance(function, Module):
            self.doubt(f"the module {function.name} is called, which no module can be", scope.module.path, getattr(node, "lineno", 1))
        self.risks += 1
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
                raise failure("SystemExit") if self.exact else Ended
            if self.exact:
                made = self._builtin_exactly(word, positional, keywords, node, scope)
                if made is not MISSING:
                    return made
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
            if word not in builtins.KEEPING and not (self.exact and word in _KNOWN):
                self.escape([*positional, *keywords.values()], "start")
            return builtins.function(self, word, positional, keywords)
        made = self.recogniser.call(name, positional, keywords, node, scope)
        self.risks += isinstance(made, Unknown) and not isinstance(made, Quiet)
        return made

    def _builtin_exactly(self, word: str, positional: list[Value], keywords: dict[str, Value], node: ast.AST, scope: Scope) -> Value:
        """Functions that call others, or ask for attributes; MISSING for all others, and where not enough is known."""
        first = positional[0] if positional else MISSING
        if word == "print":
            return None
        if word == "map" and len(positional) > 1:
            lists = [self.rounds(each) for each in positional[1:]]
            known = all(complete for _, complete in lists) and (
                len(lists) == 1 or not any(is_maybe(each) for one, _ in lists for each in one)
            )
            found: list[Value] = []
            for row in zip(*(items for items, _ in lists), strict=False):
                if len(lists) == 1 and is_maybe(row[0]):
                    said, value = row[0].alternatives[0]
                    found.append(Choice(((said, self.call(first, [value], {}, node, scope)),)))
                else:
                    found.append(self.call(first, list(row), {}, node, scope))
            return Seq(found, known, kind="iterator")
        if word == "filter" and len(positional) == 2:
            items, complete = self.rounds(positional[1])
            kept: list[Value] = []
            for each in items:
                known_of = self.truth(each if first is None else self.call(first, [each], {}, node, scope))
                if known_of is not False:
                    kept.append(each if known_of or is_maybe(each) else Choice((("", each),)))
            return Seq(kept, complete, kind="iterator")
        if word == "str" and len(positional) == 1 and isinstance(first, Instance):
            return self.as_text(first)
        if word == "len" and len(positional) == 1 and isinstance(first, Instance):
            return self._by_method(first, "__len__", [])
        if word in ("getattr", "hasattr") and len(positional) in (2, 3) and isinstance(positional[1], str) and has_known_attributes(first):
            try:
                value = self.attribute(first, positional[1], node, scope)
            except Raised:
                return False if word == "hasattr" else (positional[2] if len(positional) == 3 else MISSING)
            return True if word == "hasattr" else value
        if word == "delattr" and len(positional) == 2 and isinstance(first, Instance) and positional[1] in first.attributes:
            self.store(first.attributes, positional[1], MISSING)
            return None
        return MISSING

    def as_text(self, value: Value) -> Value:
        """``str(value)``."""
        if isinstance(value, Instance) and self.exact:
            if _has(value.type, "__str__") or _has(value.type, "__repr__"):
                return self._by_method(value, "__str__", [])
            if not any(is_failure_class(each) for each in value.type.order):
                return ANY_TEXT  # it says where it is in memory
            arguments = value.attributes.get("args")
            value = Failure(_python_class(value.type), tuple(arguments.items) if isinstance(arguments, Seq) else (UNKNOWN,))
        made = functions.text_of(self, value)
        return made if made is not MISSING else builtins.as_text(value)

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
        if self.exact and is_generator(node):
            return self._generator_of(function, positional, keywords)
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

    def begin(self) -> None:
        """Begin anew with the bounds: what is called from now on has nothing to do with the work of before."""
        self.steps = 0
        self._spent.clear()

    def _generator_of(self, function: Function, positional: list[Value], keywords: dict[str, Value]) -> Value:
        """What a generator function gives: it runs when something is taken of that."""

        def later() -> tuple[list[Value], bool]:
            made = self._run(function, positional, keywords)
            return (made.items, made.complete) if isinstance(made, Seq) else ([], True)

        made = Seq([], kind="iterator")
        made.content[LATER] = later
        return made

    def _run(self, function: Function, positional: list[Value], keywords: dict[str, Value]) -> Value:
        node = function.node
        scope = Scope(function.scope.module, function.scope)
        if self.exact:
            check_arguments(function, positional, keywords)
            scope.own = own_names(node)
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
        mark, opened = len(self.conditions), self.opened
        self._returns.append([])
        self._yields.append([])
        self._marks.append(mark)
        self.active.append(id(node))
        flow = ENDED
        try:
            flow = self.execute(node.body, scope)
            if self.opened > opened:
                flow = self._leave(opened, flow, scope)
        finally:
            self.active.pop()
            self._marks.pop()
            returned, yielded = self._returns.pop(), self._yields.pop()
            del self.conditions[mark:]
        if flow == ENDED and self.exact:
            raise self.raised or Ended
        if self.exact and is_generator(node):
            items = [each for each in yielded if each != MORE_ITEMS]
            return Seq(items, len(items) == len(yielded))
        if yielded:
            return Seq(yielded, False)
        if flow == ENDED and not returned:
            raise Ended
        if flow == GOES_ON:
            returned.append(("", None))
        return choice(returned)

    def _leave(self, opened: int, flow: int, scope: Scope) -> int:
        """All ways through a function come together at its end; how the function ends."""
        ways = self.settle(opened, flow)
        staying = [(condition, way) for condition, way in ways if way.flow != ENDED]
        if len(staying) < len(ways):
            self.may_end()
        if not staying:
            self.raised = ways[0][1].raised if len(ways) == 1 else None
            return ENDED
        self.unite(staying, scope.variables)
        return GOES_ON if any(way.flow == GOES_ON for _, way in staying) else RETURNED

    def returned(self, value: Value) -> None:
        """Take what a ``return`` gives."""
        if self._returns:
            self._returns[-1].append((conjunction(self.conditions[self._marks[-1] :]), value))

    def yielded(self, value: Value) -> None:
        """Take what a generator gives."""
        if self._yields:
            conditions = conjunction(self.conditions[self._marks[-1] :])
            self._yields[-1].append(Choice(((conditions, value),)) if conditions and self.exact and value != MORE_ITEMS else value)
            if len(self._yields[-1]) > MOST_EXACT:
                raise Exhausted

    def _bind(self, function: Function, positional: list[Value], keywords: dict[str, Value], scope: Scope) -> None:
        arguments = function.node.args
        names = [each.arg for each in (*arguments.posonlyargs, *arguments.args)]
        variables = scope.variables
        variables.update(dict.fromkeys(names, UNKNOWN))  # the first of them is what ``super()`` is for
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
            variables[arguments.vararg.arg] = Seq(positional[len(names) :], is_tuple=True)
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
            elif (
                isinstance(base, External)
                and self.recogniser.is_open(base.name)
                and not is_failure_class(base)
                and base.name not in _PLAIN_BASES
            ):
                self.doubt(f"it inherits from {base.name}, whose source was not given", *place)
        foreign = False
        if self.exact and self._made_of_fields(type_, instance, positional, keywords):
            return instance
        for base in type_.order:
            if self.exact and is_failure_class(base):
                self.store(instance.attributes, "args", Seq(positional, is_tuple=True))
                break
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
        else:
            if self.exact and (positional or keywords.keys() - {MORE}) and not foreign and not _has(type_, "__new__"):
                self.fails("TypeError", f"{type_.name}() takes no arguments")
        return instance

    def _made_of_fields(self, type_: Class, instance: Instance, positional: list[Value], keywords: dict[str, Value]) -> bool:
        """Make an object of a data class: whether the class is one."""
        if not any(isinstance(each, Class) and DATA in each.attributes for each in type_.order):
            return False
        fields: dict[str, Value] = {}
        for each in reversed([base for base in type_.order if isinstance(base, Class)]):
            for name in each.attributes.get(FIELDS, ()):
                fields[name] = each.attributes.get(name, MISSING)
        if MORE in keywords or len(positional) > len(fields) or set(keywords) - set(fields):
            raise failure("TypeError", f"{type_.name}.__init__() got other arguments than it takes")
        given = {**dict(zip(fields, positional, strict=False)), **keywords}
        for name, default in fields.items():
            value = given.get(name, default)
            if isinstance(value, Partial) and value.function == External("dataclasses.field") and self.here is not None:
                value = self.call(value.positional[0], [], {}, *self.here)
            if value is MISSING:
                raise failure("TypeError", f"{type_.name}.__init__() missing a required argument: {name!r}")
            self.store(instance.attributes, name, value)
        after = self.attribute(instance, "__post_init__", *self.here) if self.here is not None and _has(type_, "__post_init__") else None
        if isinstance(after, Bound) and self.here is not None:
            self.call(after, [], {}, *self.here)
        return True

    def instance(self, type_: Class) -> Instance:
        """A new object of a class, before its constructor is called."""
        instance = Instance(type_)
        if len(self.instances) < MOST_INSTANCES:
            self.instances.append(instance)
        elif len(self.instances) == MOST_INSTANCES:
            self.doubt("it makes too many objects to be followed", type_.scope.module.path, 1)
        return instance

    # -- attributes -----------------------------------------------------------------------------------------------------

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
