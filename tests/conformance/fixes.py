"""``check --fix`` in memory, of one entry file of a random workspace."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from pathlib import Path

from launchlint.check.entry import EntryChecker
from launchlint.check.fixing import Fixed, Fixing
from launchlint.check.ignores import PerFileIgnores
from launchlint.check.merge import Outcome
from launchlint.check.options import EntryRequest, Options
from launchlint.rules.registry import RULES

EVERY_RULE = frozenset(rule.id for rule in RULES)


def safe(directory: Path, entry: str, variables: Mapping[str, str], distro: str = "") -> Fixed:
    """The safe fixes of all rules."""
    return _fixed(directory, entry, variables, distro, lambda outcome: outcome, unsafe=False)


def changing_nothing(directory: Path, entry: str, variables: Mapping[str, str], distro: str = "") -> Fixed:
    """The fixes of all rules, likely ones too, that are said to change nothing."""

    def told(outcome: Outcome) -> Outcome:
        return outcome._replace(findings=tuple(each for each in outcome.findings if each.fix is None or not each.fix.changes))

    return _fixed(directory, entry, variables, distro, told, unsafe=True)


def _fixed(
    directory: Path, entry: str, variables: Mapping[str, str], distro: str, told: Callable[[Outcome], Outcome], *, unsafe: bool
) -> Fixed:
    root, file = str(directory), str(directory / entry)
    checker = EntryChecker(Options(EVERY_RULE, (root,), True, variables, root, distro=distro))
    result = checker.check(EntryRequest(file, file))
    none_ignored = PerFileIgnores({}, root, root)
    fixing = Fixing(checker, [result], none_ignored, asked=(), may_change=lambda _: True, told=told, unsafe=unsafe)
    return fixing.run()
