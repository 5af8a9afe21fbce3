"""What one evaluation of a ROS 2 launch file says of its args: which values somebody would give them."""

from __future__ import annotations

from collections.abc import Iterator, Set

from launchlint.evaluate.assemble import Evaluation
from launchlint.evaluate.block import Side
from launchlint.evaluate.configurations import Way
from launchlint.evaluate.ros2.comparing import CAPITALS
from launchlint.evaluate.ros2.launch import evaluate
from launchlint.evaluate.ros2.repeating import Repeats
from launchlint.evaluate.session import Session
from launchlint.model import Branch

Pairs = tuple[tuple[str, str], ...]

_BOOLEANS = {"true": ("true", "false"), "false": ("true", "false"), "1": ("1", "0"), "0": ("1", "0")}
_CAPITALS = dict.fromkeys(CAPITALS, CAPITALS)


class ArgFlow:
    """The args of one evaluation, by what conditions and expressions that were reached compare them with."""

    def __init__(self, session: Session, evaluation: Evaluation) -> None:
        self._compared = evaluation.compared
        self._given = dict(evaluation.launch.given)
        self._defaults: dict[str, str] = {}
        for each in evaluation.launch.declarations:
            if each.has_default and not each.given and isinstance(each.argument.value, str):
                self._defaults.setdefault(each.argument.name, each.argument.value)

    def telling(self, given: Pairs) -> Pairs:
        """The args of ``given`` without those that get what they have by default."""
        return tuple(pair for pair in given if self._defaults.get(pair[0]) != pair[1])

    def has(self, pairs: Pairs) -> bool:
        """Whether all args of ``pairs`` have these values in this configuration."""
        return all(value == self._given.get(name, self._defaults.get(name)) for name, value in pairs)

    def literals(self, name: str) -> tuple[str, ...]:
        """What the arg ``name`` is compared with anywhere, and its choices; not the words of a boolean, which :meth:`turning` gives."""
        return tuple(value for value in self._compared.get(name, ()) if value.strip().lower() not in ("true", "false"))

    def turning(self, branch: Branch) -> Iterator[tuple[str, str]]:
        """Args with values that may turn a condition: what they are compared with, or the opposite boolean."""
        names = sorted(branch.steered_by)
        for name in names:
            for value in self.literals(name):
                yield name, value
        positive = branch.taken is (branch.attribute == "unless")
        for name in names:
            yes_and_no = self._booleans(name)
            if yes_and_no is not None:
                yield name, yes_and_no[0 if positive else 1]
                yield name, yes_and_no[1 if positive else 0]

    def _booleans(self, name: str) -> tuple[str, str] | None:
        """True and false as the arg would be given them; None where it is no boolean, by its value or by what is asked of it."""
        value = self._given.get(name, self._defaults.get(name))
        if value is None:
            asked = [each for each in self._compared.get(name, ()) if each.lower() in ("true", "false")]
            return CAPITALS if set(asked) & set(CAPITALS) else ("true", "false") if asked else None
        return _CAPITALS.get(value) or _BOOLEANS.get(value.strip().lower())

    def breaks_text(self, changes: Pairs) -> bool:
        """Never: only what is a boolean already is given another one."""
        return False


def ros2_launch() -> Way:
    """The way of ROS 2, for one entry file: what comes of an action is kept for the other configurations."""
    repeats = Repeats()

    def enter(session: Session, file: str, given: Pairs, pinned: frozenset[str], seen: Set[Side] | None) -> Evaluation | None:
        """Evaluate an entry file; whether there is anything new in it shows when it has been evaluated."""
        return evaluate(session, file, given, pinned, repeats)

    return Way(enter, ArgFlow, most_work=16_000)
