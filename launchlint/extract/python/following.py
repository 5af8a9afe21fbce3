"""A program of ROS as it is followed: what it makes and asks for, with the conditions and the doubts."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from launchlint.extract.fact import Doubt, Fact
from launchlint.extract.python.arguments import Call
from launchlint.extract.python.dialect import Dialect
from launchlint.python.interpreter import Interpreter
from launchlint.python.memory import Exhausted
from launchlint.python.values import Value, conjunction

CATEGORIES = ("publishers", "subscribers", "services", "clients", "actions", "params")
MOST_FACTS = 5_000
MOST_DOUBTS = 200
LONGEST_CONDITION = 300


class Following(Interpreter):
    """What recognised calls need: notes of facts and doubts, and what only the program as a whole can tell."""

    dialect: Dialect
    facts: list[Fact]
    doubts: dict[Doubt, None]
    starts: list[str]
    """The conditions under which the program becomes a node."""
    when: str
    options: dict[str, int]
    """How its command line is read: options with how many values follow."""
    uses_ros: bool

    def doubt(self, reason: str, path: str, line: int, categories: tuple[str, ...] = CATEGORIES) -> None:
        """Note why there may be more of some categories."""
        if len(self.doubts) < MOST_DOUBTS:
            for category in categories:
                self.doubts.setdefault(Doubt(category, reason, path, line))

    def note(self, fact: Mapping[str, Any], condition: str) -> None:
        """Note a fact under the conditions that hold here and ``condition``."""
        if len(self.facts) >= MOST_FACTS:
            raise Exhausted
        everything = conjunction([*self.conditions, condition])
        if len(everything) > LONGEST_CONDITION:
            everything = everything[: LONGEST_CONDITION - 1] + "…"
        self.facts.append(Fact(**{"when": self.when, **fact}, condition=everything))
        self.outcome += 1

    def libraries(self) -> frozenset[str]:
        """The libraries of Python that its package says it needs."""
        raise NotImplementedError

    def configuration(self, package: str, name: str, namespace: Value, made: Call) -> None:
        """Note the params of ``package.cfg.<name>Config`` below a namespace."""
        raise NotImplementedError

    def plugin(self, name: Value, made: Call) -> None:
        """Make the rqt plugin of this name."""
        raise NotImplementedError

    def test_classes(self) -> list[Value]:
        """The classes of the program itself."""
        raise NotImplementedError

    def configured(self, name: Value, type_: Value, default: Value, made: Call) -> None:
        """Note a param that a ``.cfg`` file describes."""
        raise NotImplementedError
