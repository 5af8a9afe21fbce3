"""Functions that were not followed although they may run: what only code that is not read calls, and what is called of unknown objects.

What is left over when a program has come to its end, and makes names, is followed where it is known how it comes to be called: a function
whose address was taken, a lambda that was kept, a virtual function of an object that a class from elsewhere is a base of, a member of the
name that was called of an object nobody knows.
"""

from __future__ import annotations

import re
from collections.abc import Iterable
from typing import TypeVar

from launchlint.extract.cpp.declarations import Class, Function
from launchlint.extract.cpp.frame import Frame
from launchlint.extract.cpp.spelled_type import Type
from launchlint.extract.cpp.syntax import Node
from launchlint.extract.cpp.values import Callable, Closure, Thing

TYPE_CHECKING = False
if TYPE_CHECKING:
    from launchlint.extract.cpp.machine import Machine

_MOST_SLOTS = 200
_MOST_OBJECTS = 20
_SLOT = re.compile(r"on_\w{1,200}_\w{1,200}")
_OF_QT = re.compile(r"Q[A-Z]\w*")
_GIVEN = re.compile(r"<[^<>;(){}]*>")
_WORD = re.compile(r"\w+")
_UNNAMED = re.compile(r"~|operator\W")

Taken = TypeVar("Taken", Callable, Closure)


class Unseen:
    """What one run over a program has seen, and what it has not."""

    def __init__(self, machine: Machine) -> None:
        self.machine = machine
        self.visited: set[Function | Node] = set()
        self.made: dict[Class, Thing] = {}
        self.blind: dict[str, None] = {}
        """Members that were called of an object that is not known."""
        self.nodes: list[Thing] = []
        """Objects that are nodes of ROS 2."""
        self.contained: dict[Class, None] = {}
        """Classes of which a container makes objects by itself."""
        self._taken: dict[object, Callable | Closure] = {}
        self._words: dict[str, list[Function]] | None = None
        self._tells: dict[Function, bool] = {}

    def taken(self, function: Taken, frame: Frame) -> Taken:
        """Note that a function was used as a value; it is given back."""
        if isinstance(function, Closure):
            self._taken.setdefault(function.node, function)
        elif function.functions not in self._taken:
            self._taken[function.functions] = function._replace(this=function.this or frame.this)
            if any(each.owner and (each.overrides or each.body is None) for each in function.functions):
                self.blind.setdefault(function.functions[0].last)  # of any class that overrides it
        return function

    def with_objects(self, function: Callable) -> list[Callable]:
        """A member function that is called later; of the object it was taken in, or of its class, where nobody said of which."""
        from launchlint.extract.cpp import classes

        first = function.functions[0] if function.functions else None
        if function.this is not None or function.bound is not None or first is None or not first.owner:
            return [function]
        taken = self._taken.get(function.functions)
        inside = taken.this if isinstance(taken, Callable) else None
        if inside is not None and inside.declared is not None and classes.is_a(self.machine, inside, first.owner):
            objects = self._others(inside.declared, inside)
        else:
            objects = self._of(first)
        return [function._replace(this=each) for each in objects] or [function]

    def variables(self) -> None:
        """Make the global objects that nothing has asked for: their constructors run before ``main()``."""
        from launchlint.extract.cpp import places

        machine = self.machine
        for node, path in machine.declarations.invocations:
            machine.evaluate(node, Frame(path, "", None, {}))
        for name, field in machine.declarations.variables.items():
            if name in machine.globals or field.pointer:
                continue
            frame = Frame(field.path, field.scope, None, {})
            declared = machine.names.declared(machine.names.resolve(field.type, frame)) if field.type.name else None
            if declared is not None and machine.declarations.members(declared.name):
                places.of_program(machine, name, frame)

    def queue(self) -> bool:
        """Have what is left over, and makes names, followed; whether there is anything."""
        machine = self.machine
        before = len(machine.pending)
        for value in list(self._taken.values()):
            if isinstance(value, Closure):
                if value.node not in self.visited:
                    machine.later(value, "message", ())
            elif self.visited.isdisjoint(value.functions) and any(self.tells(each) for each in value.functions):
                machine.later(value, "message", (f"{value.functions[0].last} is called",))
        for declared, thing in list(self.made.items()):
            base = self.foreign_base(declared)
            for each in self._called_by(declared, base) if base else ():
                for one in self._others(declared, thing):
                    machine.later(Callable((each,), one), "message", (f"{base} calls {each.last}",))
            for each in self._without_a_call(declared):
                for one in self._others(declared, thing):
                    machine.later(Callable((each,), one), "message", (f"{each.last} of {declared.name} is called",))
        for name in self.blind:
            for each in self._by_name().get(name, ()):
                for owner in () if each in self.visited else self._of(each):
                    if self.tells(each):
                        machine.later(Callable((each,), owner), "message", (f"{each.last} of {each.owner} is called",))
        for declared in self.contained:
            if declared not in self.made:
                self._make(declared)
        return len(machine.pending) > before

    def made_elsewhere(self) -> Iterable[tuple[Class, Function]]:
        """Classes that nothing here makes an object of, that make names, and that are given to a template: who reads that may make one.

        With each the first function that gives it. Only classes with a base from elsewhere: who has that calls what overrides it.
        """
        names, declarations = self.machine.names, self.machine.declarations
        givers: dict[str, Function] | None = None
        made = {name for declared in self.made for name in (declared.name, *(each.name for each in names.bases(declared.name)))}
        for declared in list(declarations.classes.values()):
            if declared.name in made or declared.template or not self.foreign_base(declared):
                continue
            members = (each for _, functions in declarations.members(declared.name) for each in functions if each.body is not None)
            if not any(each not in self.visited and self.tells(each) for each in members):
                continue
            if givers is None:
                givers = self._givers()
            giver = givers.get(declared.name.rpartition("::")[2])
            if giver is not None:
                yield declared, giver

    def _givers(self) -> dict[str, Function]:
        """The first function that gives a word to a template, by the word."""
        found: dict[str, Function] = {}
        for functions in self.machine.declarations.functions.values():
            for each in functions:
                for given in () if each.body is None else _GIVEN.findall(each.body.text):
                    for word in _WORD.findall(given):
                        found.setdefault(word, each)
        return found

    def _make(self, declared: Class) -> None:
        """Make one of the objects that a container makes by itself."""
        from launchlint.extract.cpp import classes, overloads

        machine = self.machine
        constructor = machine.declarations.functions.get(f"{declared.name}::{declared.name.rpartition('::')[2]}", [])
        if overloads.talks(machine, declared) and all(not each.parameters for each in constructor):
            machine.when, machine.conditions = "message", [f"a container holds a {declared.name}"]
            place = Node("declaration", b"", 0, 0)
            classes.make(machine, declared, Type(declared.name), [], place, Frame(declared.path, declared.scope, None, {}))

    def _of(self, function: Function) -> list[Thing]:
        """An object that has a member function; all of them where they are nodes, each of which has names of its own."""
        for declared, thing in self.made.items():
            if declared.name == function.owner or any(each.name == function.owner for each in self.machine.names.bases(declared.name)):
                return self._others(declared, thing)
        return []

    def _others(self, declared: Class, thing: Thing) -> list[Thing]:
        """An object, and the others of its class that are nodes as it is."""
        return [thing, *(each for each in self.nodes if each is not thing and each.declared is declared)][:_MOST_OBJECTS]

    def tells(self, function: Function) -> bool:
        """Whether a function that was not followed, or one that it calls and that was not either, makes names of ROS."""
        from launchlint.extract.cpp import overloads

        if function in self._tells:
            return self._tells[function]
        self._tells[function] = False
        pending, seen = [function], {function}
        found = False
        while pending and not found:
            each = pending.pop()
            text = each.body.text if each.body is not None else ""
            found = overloads.telling(self.machine, text)
            for word in () if found else overloads.words_of(text):
                for inner in self._by_name().get(word, ()):
                    if inner not in seen and inner not in self.visited:
                        seen.add(inner)
                        pending.append(inner)
        self._tells[function] = found
        return found

    def _by_name(self) -> dict[str, list[Function]]:
        if self._words is None:
            self._words = {}
            for functions in self.machine.declarations.functions.values():
                for each in functions:
                    if each.body is not None:
                        self._words.setdefault(each.last, []).append(each)
        return self._words

    def foreign_base(self, declared: Class) -> str:
        """A base class that is not among the sources, so that nobody knows what it calls."""
        names = self.machine.names
        for each in (declared, *names.bases(declared.name)):
            frame = Frame(each.path, each.name, None, {})
            for base in each.bases:
                resolved = names.resolve(base, frame)
                if names.declared(resolved) is None and resolved.name not in each.template:
                    return resolved.name
        return ""

    def _without_a_call(self, declared: Class) -> Iterable[Function]:
        """Operators and the destructor of a class, which no call names, where they make names and have not been followed."""
        for name, functions in self.machine.declarations.members(declared.name):
            if _UNNAMED.match(name):
                yield from (each for each in functions if each.body is not None and each not in self.visited and self.tells(each))

    def _called_by(self, declared: Class, base: str) -> Iterable[Function]:
        """Members of a class that its base class may call, have not been followed, and make names."""
        machine = self.machine
        is_widget = _OF_QT.fullmatch(base.rpartition("::")[2]) is not None
        found = 0
        for each in (declared, *machine.names.bases(declared.name)):
            for name, functions in machine.declarations.members(each.name):
                called = any(one.overrides for one in functions) or (is_widget and _SLOT.fullmatch(name) is not None)
                for one in functions if called else ():
                    if one.body is not None and one not in self.visited and found < _MOST_SLOTS and self.tells(one):
                        found += 1
                        yield one
