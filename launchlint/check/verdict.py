"""The verdict on one entry file, from its model: whether its launcher loads it, refuses it, or whether that cannot be told from here.

A problem for which the launcher stops is a refusal where the rule that speaks of it says *error*: everybody who starts the file meets it.
Where the rule says less, or nothing, it stops for want of something that this check has not and somebody else may have.
"""

from __future__ import annotations

from launchlint.check.file import tell
from launchlint.dialects.door import named
from launchlint.evaluate.problems import DuplicateNode
from launchlint.finding import Severity
from launchlint.model import Launch
from launchlint.problem import Problem
from launchlint.rules.registry import RULES, rule_of
from launchlint.rules.rule import shortened
from launchlint.verdict import LOADS, Verdict

ALL_RULES = frozenset(rule.id for rule in RULES)
"""A verdict does not depend on the rules that somebody wants to hear of."""

CERTAIN = DuplicateNode
"""Of these the level of the rule says whether anybody starts it so; roslaunch refuses it in any case."""


def judged(launch: Launch, view: object) -> Verdict:
    """What its launcher makes of a launch as it stands; ``view`` is the one that rules look at."""
    launcher = named(launch.dialect).launcher
    if launch.refused is None:
        if not launch.settled:
            return Verdict("cannot be told", reason=_not_followed(launch), launcher=launcher)
        return LOADS._replace(launcher=launcher)
    missing: dict[str, None] = {}
    reason = ""
    for problem in launch.problems:
        if not problem.refused:
            continue
        what = _missing(problem)
        if what in missing:
            continue
        told = list(tell(problem, view, ALL_RULES))
        certain = isinstance(problem, CERTAIN)
        sure = next((finding for finding in told if certain or finding.severity is Severity.ERROR), None)
        if sure is not None:
            return Verdict("refused", sure.rule, sure.message, launcher=launcher)
        if what:
            missing[what] = None
        else:
            reason = reason or (told[0].message if told else plainly(problem))
    return Verdict("cannot be told", rule_of(type(launch.refused)), reason, tuple(missing), launcher=launcher)


def plainly(problem: Problem) -> str:
    """Why the launcher refuses a file, where the rule for it keeps silent because it need not be a mistake of the file."""
    lacks = problem.lacks
    return f"{' '.join(lacks)} is not here" if lacks else problem.kind.replace("-", " ")


def _not_followed(launch: Launch) -> str:
    """Why it is not known whether launch gets through its files in Python: the first reason of the first that is known least."""
    rank = ("not", "partly")
    least = min((each for each in launch.followed if each.reasons), key=lambda each: rank.index(each.state), default=None)
    if least is not None:
        place, reason = least.reasons[0]
        return f"{least.source.path} is not known as a whole: line {least.source.position(place.span.start).line}: {shortened(reason)}"
    return "what it asks of code that is not looked into may fail"


def _missing(problem: Problem) -> str:
    """What would have to be there so that the launcher does not stop at a problem; empty where that has no name."""
    what, name = problem.lacks or ("", "")
    return f"{what} {shortened(name)}" if name else ""
