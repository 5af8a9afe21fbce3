"""Follows a program from its start: which calls of the ROS interface are reached, and with what names.

Nothing is run. Values that matter to names (text, numbers, node handles, objects and functions) are followed through variables, members,
parameters and calls; both sides of an ``if`` are followed, and what they leave behind is joined. All of it is bounded in steps and depth.
"""

from __future__ import annotations

from collections.abc import Callable as Does
from collections.abc import Hashable, Sequence

from launchlint.extract.cpp import classes, overloads, places, statements
from launchlint.extract.cpp.declarations import Class, Declarations, Function, Parameter, parameters_of
from launchlint.extract.cpp.expressions import BY_KIND
from launchlint.extract.cpp.foreign import Foreign
from launchlint.extract.cpp.forgetting import forget
from launchlint.extract.cpp.frame import Frame
from launchlint.extract.cpp.instance import Instance
from launchlint.extract.cpp.naming import ANY, LOOSE, UNKNOWN_SPACE, Names, finished, is_loose
from launchlint.extract.cpp.spelled_type import DOUBLES, INTEGERS, UNTYPED, Type
from launchlint.extract.cpp.syntax import LONGEST_CONDITION, Node, shortened
from launchlint.extract.cpp.tables import Tables
from launchlint.extract.cpp.unseen import Unseen
from launchlint.extract.cpp.values import (
    UNKNOWN,
    Argument,
    Callable,
    Cell,
    Closure,
    Either,
    Items,
    Text,
    Thing,
    Value,
    both,
    choices,
    either,
)
from launchlint.extract.fact import Doubt, Fact, Made, Plugin, key_of
from launchlint.named_tuple import NamedTuple

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

_MOST_STEPS = 300_000
_DEEPEST = 110
_DEEPEST_CALL = 22
_MOST_PENDING = 2_000
_MOST_FACTS = 5_000
_MOST_ROUNDS = 4
_LARGEST_IRRELEVANT = 1_500
_LARGEST_PLAIN = 150
_MOST_STEPS_OF_IRRELEVANT = 3_000
"""Steps that one program is followed through one function that has nothing to do with names, and what that calls."""
_PLAIN = DOUBLES | INTEGERS | {"void"}
CATEGORIES = ("publishers", "subscribers", "services", "clients", "actions", "params")


class Pending(NamedTuple):
    """A function that is called later."""

    function: Callable | Closure
    when: str
    conditions: tuple[str, ...]
    instance: Instance | None
    exists: str


class Machine:
    """One run over one program."""

    def __init__(
        self,
        declarations: Declarations,
        tables: Tables,
        root: str = ".",
        plugins: Sequence[Plugin] = (),
        foreign: Foreign | None = None,
    ) -> None:
        self.declarations = declarations
        self.tables = tables
        self.foreign = foreign or Foreign()
        self.plugins = plugins
        self.instance: Instance | None = None
        self.is_loaded = False  # into the process of a nodelet manager
        self.root = root
        self.names = Names(declarations, self.foreign)
        self.facts: dict[Hashable, Fact] = {}
        self.noted = 0
        """How often a fact was noted, also one that is known."""
        self.doubts: dict[Doubt, None] = {}
        self.nodes: dict[str, Made] = {}
        self.set_here: set[str] = set()  # params that the program has set by now: of what type they were does not matter to it
        self.conditions: list[str] = []
        self.when = "start"
        self.exists = ""
        """What a lifecycle node is where its members run: ``configured``, ``active``; empty while it is made."""
        self.begun: tuple[str, int] | None = None
        """Where the client library of ROS 2 is begun."""
        self.strangers: dict[Doubt, None] = {}
        """Why there may be nodes that were not found, without a category."""
        self.objects: list[Thing] = []
        """Objects that are nodes of ROS 2."""
        self.horizon = 0
        self.touched = False
        self.too_deep = False
        self.serial = 0
        self.steps = 0
        self.spent: dict[Function, int] = {}  # steps in functions that have nothing to do with names, and in what they call
        self.depth = 0
        self.calls: list[Function] = []
        self.dispatched: dict[Function, int] = {}
        self.making: list[Class] = []
        self.loops = 0
        self.journals: list[dict[Cell, Value]] = []
        self.pending: list[Pending] = []
        self.queued: set[object] = set()
        self.globals: dict[str, Cell] = {}
        self.unseen = Unseen(self)
        self.temporary = Frame("", "", None, {})

    # -- following ----------------------------------------------------------------------------------------------------

    def evaluate(self, node: Node | None, frame: Frame) -> Value:
        """The value of an expression."""
        if node is None or not self.step():
            return UNKNOWN
        does = BY_KIND.get(node.kind)
        if does is None:
            return UNKNOWN
        self.depth += 1
        value = does(self, node, frame)
        self.depth -= 1
        return value

    def argument(self, node: Node, frame: Frame) -> Argument:
        """An argument that is the name of a variable."""
        if node.kind == "identifier" and self.step():
            local = frame.variable(node.text)
            if local is not None:
                return Argument(self.read(local), local, node)
        return Argument(*places.read(self, node, frame), node)

    def execute(self, node: Node, frame: Frame) -> str:
        """Follow a statement; ``return``, ``break``, ``continue``, or empty where the next one is reached."""
        if not self.step():
            return ""
        self.depth += 1
        signal = statements.execute(self, node, frame)
        self.depth -= 1
        return signal

    def step(self) -> bool:
        """Count one step; whether there may be another one."""
        self.steps += 1
        if self.steps < _MOST_STEPS and self.depth < _DEEPEST:
            return True
        if self.steps == _MOST_STEPS:
            self.doubt_all("the program is too long to be followed to its end", self.temporary.path, 1)
        if self.depth >= _DEEPEST and not self.too_deep:
            self.too_deep = True
            self.doubt_all("the program is nested too deeply to be followed to its end", self.calls[-1].path if self.calls else "", 1)
        return False

    def finish(self) -> None:
        """Follow the functions that are called later, until there are no more; then those that only other code calls."""
        self.unseen.variables()
        self._follow_later()
        while self.objects and self.steps < _MOST_STEPS:
            self.tables.follow(self, self.objects.pop(0))
            self._follow_later()
        for _ in range(_MOST_ROUNDS):
            if not self.unseen.queue():
                break
            self._follow_later()
        for declared, giver in self.unseen.made_elsewhere():
            line = 1 if giver.body is None else giver.body.line
            self.doubt_all(f"an object of {declared.name} may be made by code that is not here", giver.path, line)

    def _follow_later(self) -> None:
        while self.pending and self.steps < _MOST_STEPS:
            later = self.pending.pop(0)
            if isinstance(later.function, Callable) and not any(overloads.is_relevant(self, each) for each in later.function.functions):
                continue
            ways = self.unseen.with_objects(later.function) if isinstance(later.function, Callable) else [later.function]
            for each in ways:
                self.when, self.conditions, self.horizon = later.when, list(later.conditions), self.serial + 1
                self.instance, self.exists = later.instance, later.exists
                self.invoke(each, [])
        self.exists = ""

    # -- variables ----------------------------------------------------------------------------------------------------

    def cell(self, value: Value, type_: Type = UNTYPED, constant: bool = False) -> Cell:
        """A new variable."""
        self.serial += 1
        return Cell(value, type_, self.serial, constant)

    def read(self, cell: Cell) -> Value:
        """The value of a variable; one from before the current loop or callback may have another one by then."""
        if (cell.serial < self.horizon or cell.changing) and not cell.constant:
            self.touched = True
        return cell.value

    def write(self, cell: Cell, value: Value) -> None:
        """Assign."""
        if self.journals:
            self.journals[-1].setdefault(cell, cell.value)
        cell.value = value

    def branch(self, runs: Sequence[tuple[str, Does[[], str]]]) -> str:
        """Follow several ways, each under its condition, and join what they leave behind."""
        outcomes: list[tuple[str, str, dict[Cell, Value]]] = []
        for condition, run in runs:
            self.journals.append({})
            if condition:
                self.conditions.append(condition)
            try:
                signal = run()
            finally:
                if condition:
                    self.conditions.pop()
                before = self.journals.pop()
            outcomes.append((condition, signal, {cell: cell.value for cell in before}))
            for cell, value in before.items():
                cell.value = value
        going = [each for each in outcomes if not each[1]] or outcomes
        cells: dict[Cell, None] = {}
        for _, _, written in going:
            cells.update(dict.fromkeys(written))
        for cell in cells:
            ways = [(condition, written.get(cell, cell.value)) for condition, _, written in going]
            joined = either(ways)
            self.write(cell, joined)
            if isinstance(joined, (Items, Text)) and any(value != joined for _, value in ways):
                cell.changing = True  # it may be the shorter list, or the empty text
        signals = {signal for _, signal, _ in outcomes}
        if "" in signals or not signals:
            return ""
        return "return" if signals == {"return"} else min(signals)

    # -- calls --------------------------------------------------------------------------------------------------------

    def later(self, function: Value, when: str, conditions: tuple[str, ...] | None = None) -> None:
        """Have a function called when the start is over: a callback, a thread."""
        for _, each in choices(function):
            if not isinstance(each, (Callable, Closure)) or len(self.pending) > _MOST_PENDING:
                continue
            now = when if self.when == "start" or when == "message" else self.when
            bound = each.bound if isinstance(each, Callable) else None
            key: tuple[object, ...]
            key = (each.functions, each.this, bound, now) if isinstance(each, Callable) else (each.node, each.frame.this, now)
            if key not in self.queued:
                self.queued.add(key)
                self.pending.append(
                    Pending(each, now, tuple(self.conditions if conditions is None else conditions), self.instance, self.exists)
                )

    def invoke(self, function: Value, arguments: Sequence[Argument]) -> Value:
        """Call a function value."""
        if isinstance(function, Either):
            return either([(condition, self.invoke(each, arguments)) for condition, each in function.choices])
        if isinstance(function, Closure):
            return self._closure(function, arguments)
        if isinstance(function, Thing):
            found = overloads.chosen(self, classes.methods(self, function, "operator()"), arguments, None)
            return self.call(found, function, arguments) if found is not None else UNKNOWN
        if not isinstance(function, Callable):
            return UNKNOWN
        this = function.this
        given = list(arguments)
        if function.bound is not None:
            given = [Argument(UNKNOWN if isinstance(each, int) else each) for each in function.bound]
            for position, each in enumerate(function.bound):
                if isinstance(each, int) and 0 <= each < len(arguments):
                    given[position] = arguments[each]
        if this is None and given and function.functions and function.functions[0].owner:
            first = given[0].value
            if isinstance(first, Thing):
                this, given = first, given[1:]
        found = overloads.chosen(self, function.functions, given if arguments or function.bound is not None else None, this)
        if found is None:
            return UNKNOWN
        return self.call(found, this, given, dict(zip(found.template, function.types, strict=False)))

    def call(self, function: Function, this: Thing | None, arguments: Sequence[Argument], bindings: dict[str, Type] | None = None) -> Value:
        """Follow a function of the program with these arguments, in each of its definitions of which the preprocessor leaves one."""
        twins = overloads.twins(self, function)
        if len(twins) < 2:
            return self._follow(twins[0] if twins else function, this, arguments, bindings)
        results: list[tuple[str, Value]] = []
        ways = []
        for each in twins:
            condition = f"{each.name} is that of line {each.line}"

            def run(each: Function = each, condition: str = condition) -> str:
                results.append((condition, self._follow(each, this, arguments, bindings)))
                return ""

            ways.append((condition, run))
        self.branch(ways)
        return either(results)

    def _follow(self, function: Function, this: Thing | None, arguments: Sequence[Argument], bindings: dict[str, Type] | None) -> Value:
        if function.body is None or self.calls.count(function) > 1:
            return UNKNOWN
        self.unseen.visited.add(function)
        if len(self.calls) >= _DEEPEST_CALL or self.depth > _DEEPEST - 20:
            if overloads.tells(self, function):
                self.doubt_all(f"calls are nested too deeply to follow {function.name}", function.path, function.line)
            return UNKNOWN
        relevant = overloads.is_relevant(self, function)
        if not relevant:
            is_plain = function.returns.name in _PLAIN and not any(map(self._may_be_called, arguments))
            largest = _LARGEST_PLAIN if is_plain else _LARGEST_IRRELEVANT
            if function.body.size > largest or self.spent.get(function, 0) > _MOST_STEPS_OF_IRRELEVANT:
                forget(self, function, this)
                return UNKNOWN
        begun = self.steps
        owner = self.declarations.classes.get(function.owner)
        known = dict(classes.bindings_in(self, this, owner)) if this is not None else {}
        known.update(bindings or {})
        frame = Frame(function.path, function.scope, this, known)
        self.calls.append(function)
        horizon = self.horizon
        try:
            self.bind(function.parameters, overloads.with_defaults(self, function), arguments, frame)
            if function.last == function.owner.rpartition("::")[2]:
                classes.initialise(self, function, this, frame)
            self._body(function.body, frame)
        finally:
            self.calls.pop()
            self.horizon = horizon
            if not relevant:
                self.spent[function] = self.spent.get(function, 0) + self.steps - begun
        return either(frame.returns) if frame.returns else UNKNOWN

    def _may_be_called(self, given: Argument) -> bool:
        """Whether an argument is a function, or an object that can be called like one."""
        for _, value in choices(given.value):
            if isinstance(value, (Callable, Closure)) or (isinstance(value, Thing) and classes.methods(self, value, "operator()")):
                return True
        return False

    def _body(self, body: Node, frame: Frame) -> None:
        """Follow a body, and take the conditions of its early returns off afterwards."""
        conditions = list(self.conditions)
        self.execute(body, frame)
        self.conditions = conditions

    def _closure(self, closure: Closure, arguments: Sequence[Argument]) -> Value:
        body = closure.node.fields.get("body")
        if body is None or len(self.calls) >= _DEEPEST_CALL or self.depth > _DEEPEST - 20:
            return UNKNOWN
        outer = closure.frame
        self.unseen.visited.add(closure.node)
        frame = Frame(outer.path, outer.scope, outer.this, {}, outer)
        parameters = self.parameters(closure)
        self.bind(parameters, {}, arguments, frame)
        self._body(body, frame)
        return either(frame.returns) if frame.returns else UNKNOWN

    def parameters(self, closure: Closure) -> tuple[Parameter, ...]:
        """The parameters of a lambda."""
        declarator = closure.node.fields.get("declarator")
        return parameters_of(declarator.fields.get("parameters")) if declarator else ()

    def bind(self, parameters: Sequence[Parameter], defaults: dict[int, Node], arguments: Sequence[Argument], frame: Frame) -> None:
        """Give the parameters their values; references are the variable itself."""
        for position, parameter in enumerate(parameters):
            default = parameter.default or defaults.get(position)
            if position < len(arguments):
                given = arguments[position]
                if parameter.shared and given.cell is not None:
                    frame.variables[parameter.name] = given.cell
                    continue
                value = classes.converted(self, given.value, parameter.type, frame)
                if isinstance(value, (Callable, Closure)):
                    self.later(value, "message")  # it is kept, and called by whoever keeps it
            elif default is not None:
                value = classes.converted(self, self.evaluate(default, frame), parameter.type, frame)
            else:
                value = UNKNOWN
            if parameter.name:
                frame.variables[parameter.name] = self.cell(value, parameter.type)

    # -- what is found ------------------------------------------------------------------------------------------------

    def fact(self, category: str, name: Value, node: Node, frame: Frame, /, **more: Any) -> None:
        """Note an interface."""
        for condition, each in choices(name):
            text = each.template if isinstance(each, Text) else ANY
            spelled = finished(text)
            if UNKNOWN_SPACE in spelled or (LOOSE in text and ANY in spelled) or is_loose(spelled):
                where = UNKNOWN_SPACE if UNKNOWN_SPACE in spelled else ""
                self.doubt(category, f"{where}a name is not known before it runs: {shortened(node.text)}", node, frame)
            untyped = category == "params" and text in self.set_here
            self._fact(category, spelled, node, frame, condition, {**more, "value_type": ""} if untyped else more)

    def _fact(self, category: str, name: str, node: Node, frame: Frame, condition: str, more: dict[str, Any]) -> None:
        conditions = [*self.conditions, condition] if condition else self.conditions
        text = ""
        for each in dict.fromkeys(conditions):
            text = both(text, each)
        if len(text) > 3 * LONGEST_CONDITION:
            text = text[: 3 * LONGEST_CONDITION - 1] + "…"
        if len(self.facts) < _MOST_FACTS:
            self.note(Fact(category, name, frame.path, node.line, condition=text, when=self.when, exists=self.exists, **more))

    def note(self, fact: Fact) -> None:
        """Keep a fact; the same one twice is one."""
        if self.instance is not None:
            fact = fact._replace(name=self.instance.renamed(fact.name))
        self.noted += 1
        self.facts.setdefault(key_of(fact), fact)
        if len(self.facts) == _MOST_FACTS:
            self.doubt_all(f"only {_MOST_FACTS} names are listed", fact.path, fact.line)

    def doubt(self, category: str, reason: str, node: Node, frame: Frame) -> None:
        """Note why there may be more of a category."""
        if len(self.doubts) < _MOST_FACTS:
            self.doubts[Doubt(category, reason, frame.path, node.line)] = None

    def doubt_all(self, reason: str, path: str, line: int) -> None:
        """Note why there may be more of every category."""
        for category in CATEGORIES:
            self.doubts[Doubt(category, reason, path, line)] = None
