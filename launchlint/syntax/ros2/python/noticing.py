"""The interpreter that keeps account of what a launch file does wrong on the way, and whether Python gets there for certain."""

from __future__ import annotations

import ast
from collections.abc import Sequence

from launchlint.problem import Problem
from launchlint.python.failures import Asked
from launchlint.python.interpreter import Interpreter
from launchlint.python.recogniser import Recogniser
from launchlint.python.values import Handle, Scope, Value
from launchlint.python.walking import walk
from launchlint.source import Origin, Place
from launchlint.syntax.ros2.description import Action
from launchlint.syntax.ros2.python.ending import asks
from launchlint.syntax.ros2.python.idle import idle
from launchlint.syntax.ros2.python.problems import ConfigurationAsPythonValue
from launchlint.syntax.ros2.python.texts import SUBSTITUTIONS
from launchlint.syntax.ros2.python.uses import STOPS, uses

TYPE_CHECKING = False
if TYPE_CHECKING:
    from launchlint.python.modules import ModuleFinder
    from launchlint.syntax.ros2.python.problems import Use

_CATCHES_ALL = ("Exception", "BaseException", "TypeError", "AttributeError", "ValueError")


class Noticing(Interpreter):
    """Follows a program, and notes problems: each once, in the order in which Python meets them."""

    def __init__(self, recogniser: Recogniser, root: str, package: str, finder: ModuleFinder, beside: str) -> None:
        super().__init__(recogniser, root, package, finder, beside)
        self.problems: list[Problem] = []
        self.missing_package = ""  # the first that the program asked for and that is not here
        self.missing_variable = ""  # likewise of the environment, one that is not set
        self.asking: dict[Asked, Place] = {}  # what it asked for and would have stopped without, each with the first place
        self._told: set[tuple[type, tuple[str, int], str]] = set()
        self._caught = 0
        self._catching: set[int] = set()
        self._uses: dict[int, tuple[Use, ast.expr]] = {}
        self._idle: set[int] = set()

    def place(self, node: ast.AST, scope: Scope) -> Place:
        """Where something stands."""
        raise NotImplementedError

    def _key(self, problem: Problem) -> tuple[type, tuple[str, int], str]:
        words = " ".join(str(value) for name, value in sorted(vars(problem).items()) if isinstance(value, str))
        return type(problem), problem.place.key, words

    def record(self, problem: Problem) -> None:
        """Note ``problem``; where it is not certain that the program gets there, or gets no further, it is assumed."""
        key = self._key(problem)
        if key in self._told:
            return
        self._told.add(key)
        if not self._is_certain():
            problem = problem.but(refused=False, assumed=True)
        self.problems.append(problem)

    def asks(self, asked: Asked, place: Place) -> None:
        """Note that the program stops without what it asks for here; where it may not get here, no more than that is known.

        What it would do if it had that is followed all the same, as it is in XML and YAML: who reads launch files need not have what they
        are started with.
        """
        if self._is_certain():
            self.asking.setdefault(asked, place)
        else:
            self.risks += 1

    def asked(self, before: int) -> tuple[Action, ...]:
        """What stands for that which was asked for since ``before`` things were; it is noted again when it is asked for again."""
        found = list(self.asking.items())[before:]
        for asked, _ in found:
            del self.asking[asked]
        return tuple(asks(*each) for each in found)

    def _is_certain(self) -> bool:
        """Whether the program gets where it is for certain, and an exception would end it."""
        return not (self.conditions or len(self._logs) > self.kept or self._caught)

    def noticed(self, before: int) -> list[Problem]:
        """What was noted since there were ``before`` problems; it is noted again when it is met again."""
        found = self.problems[before:]
        del self.problems[before:]
        self._told = {self._key(problem) for problem in self.problems}
        return found

    def look_at(self, tree: ast.Module) -> None:
        """Notice how a module uses what may turn out to be substitutions, and where it catches errors."""
        self._uses.update(uses(tree))
        self._idle |= idle(tree)
        tries = (node for node in walk(tree) if isinstance(node, ast.Try))
        self._catching.update(id(node.body) for node in tries if any(_catches(handler.type) for handler in node.handlers))

    def evaluate(self, node: ast.expr | None, scope: Scope) -> Value:
        """The value of an expression; that of a substitution is none that Python could work with."""
        value = super().evaluate(node, scope)
        if type(value) is Handle and value.kind in SUBSTITUTIONS and id(node) in self._uses:
            self._used(value, node, scope)
        return value

    def _used(self, value: Handle, node: ast.expr | None, scope: Scope) -> None:
        self.risks += 1  # what its text is as an object may be no name, say
        use, whole = self._uses[id(node)]
        of = value.state.get("variable_name")
        self.record(
            ConfigurationAsPythonValue(
                origin=Origin(self.place(whole, scope)), refused=use in STOPS, use=use, name=value.kind,
                of=of if isinstance(of, str) and value.kind == "LaunchConfiguration" else "", idle=id(node) in self._idle,
            )
        )  # fmt: skip

    def execute(self, body: Sequence[ast.stmt], scope: Scope) -> int:
        """Go through statements; in a ``try`` that catches what launch raises, nothing is certain to stop the program."""
        caught = id(body) in self._catching
        self._caught += caught
        try:
            return super().execute(body, scope)
        finally:
            self._caught -= caught


def _catches(type_: ast.expr | None) -> bool:
    """Whether a handler catches what launch raises."""
    if type_ is None:
        return True
    return any(isinstance(each, (ast.Name, ast.Attribute)) and ast.unparse(each).endswith(_CATCHES_ALL) for each in walk(type_))
