"""A problem that stands at many places of a file is told once: at the first of them."""

from __future__ import annotations

from collections.abc import Iterator

from launchlint.model import Launch
from launchlint.problem import Problem
from launchlint.rules.rule import Fine, Rule


def all_but_first(rule: Rule, launch: Launch, kind: str, fact: str) -> Iterator[Fine]:
    """Say that ``rule`` has nothing to tell at the further places of the problems of ``kind`` that have the same ``fact`` in the same file.

    The first one of another configuration may be one of those, so that each configuration has to say it.
    """
    places: dict[tuple[str, str], list[Problem]] = {}
    for problem in launch.problems:
        if problem.kind == kind:
            places.setdefault((problem.place.source.path, problem.facts[fact]), []).append(problem)
    firsts = {(path, min(problem.place.span.start for problem in problems)) for (path, _), problems in places.items()}
    for (path, _), problems in places.items():
        for problem in problems:
            if (path, problem.place.span.start) not in firsts:
                yield rule.fine(problem.origin)
