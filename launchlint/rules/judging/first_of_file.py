"""A problem that stands at many places of a file is told once: at the first of them."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from launchlint.problem import Problem
from launchlint.rules.rule import Fine, Rule


def all_but_first(rule: Rule, noticed: Iterable[tuple[Problem, str]]) -> Iterator[Fine]:
    """Say that ``rule`` has nothing to tell at the further places of the problems that are about the same thing in the same file.

    ``noticed`` are the problems, each with what it is about. The first one of another configuration may be one of those further places,
    so that each configuration has to say it.
    """
    places: dict[tuple[str, str], list[Problem]] = {}
    for problem, about in noticed:
        places.setdefault((problem.place.source.path, about), []).append(problem)
    firsts = {(path, min(problem.place.span.start for problem in problems)) for (path, _), problems in places.items()}
    for (path, _), problems in places.items():
        for problem in problems:
            if (path, problem.place.span.start) not in firsts:
                yield rule.fine(problem.origin)
