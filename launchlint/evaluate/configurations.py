"""Every configuration that matters: the default one, then the fewest further ones that take every branch at least once.

A condition that was not taken (or only taken) is turned by giving another value to one of the entry file's args on which it depends. Each
configuration is a concrete command line, so each finding comes with the command that shows it.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from launchlint.evaluate.assemble import Evaluation
from launchlint.evaluate.launch import evaluate
from launchlint.evaluate.session import Session
from launchlint.model import Argument, Branch, Unknown

MOST_EVALUATIONS = 48
"""Evaluations of one entry file, tried ones included; real files need 1.6 on average."""

BOOLEANS = ("true", "false", "1", "0")

Side = tuple[str, int, str, bool]


def configurations(session: Session, file: str, given: tuple[tuple[str, str], ...] = ()) -> Iterator[Evaluation]:
    """Evaluate ``file`` as given, then with single args changed until every reachable side of every condition has been seen.

    Args in ``given`` stay as they are. Only configurations that show something new are yielded.
    """
    pinned = frozenset(name for name, _ in given)
    first = evaluate(session, file, given, pinned)
    yield first
    waiting = [first]
    seen = _sides(first)
    tried: set[tuple[tuple[str, str], ...]] = {()}
    evaluations = 1
    while waiting:
        base = waiting.pop(0)
        for branch in base.launch.branches:
            if branch.taken is None or not branch.steered_by:
                continue
            wanted = _side(branch, not branch.taken)
            if wanted in seen:
                continue
            for name, value in _candidates(branch, base.launch.declared):
                changes = (*(pair for pair in base.launch.given[len(given) :] if pair[0] != name), (name, value))
                if tuple(sorted(changes)) in tried or dict(base.launch.given).get(name) == value:
                    continue
                tried.add(tuple(sorted(changes)))
                if evaluations >= MOST_EVALUATIONS:
                    return
                evaluations += 1
                evaluation = evaluate(session, file, (*given, *changes), pinned)
                sides = _sides(evaluation)
                if sides <= seen:
                    continue
                seen |= sides
                yield evaluation
                waiting.append(evaluation)
                if wanted in seen:
                    break


def _side(branch: Branch, taken: bool) -> Side:
    return (branch.element.source.path, branch.element.span.start, branch.attribute, taken)


def _sides(evaluation: Evaluation) -> set[Side]:
    return {_side(branch, branch.taken) for branch in evaluation.launch.branches if branch.taken is not None}


def _candidates(branch: Branch, declared: tuple[Argument, ...]) -> Iterator[tuple[str, str]]:
    """Args and values that may turn the condition: the opposite boolean, or what an ``$(eval …)`` compares with.

    An arg with a text for default is not given a boolean: nobody would start the file like that, and what goes wrong then is no mistake.
    """
    defaults = {argument.name: argument.default for argument in declared if argument.origin.step is None and not argument.passed}
    for name, value in _turning(branch, defaults):
        default = defaults.get(name)
        if value not in BOOLEANS or not isinstance(default, str) or default.strip().lower() in BOOLEANS:
            yield name, value


def _turning(branch: Branch, defaults: Mapping[str, str | Unknown | None]) -> Iterator[tuple[str, str]]:
    names = sorted(branch.steered_by)
    text = branch.text.strip()
    literals: dict[str, tuple[str, ...]] = {}
    if text.startswith("$(eval "):
        from launchlint.evaluate.ros1.expression import compared_literals

        literals = compared_literals(text[7:-1])
        for name in names:
            for value in literals.get(name, ()):
                if value.strip():
                    yield name, value
    # An arg compared under another name in an included file: its literals may fit any of the args it comes from.
    others = sorted({value for name, values in literals.items() if name not in names for value in values if value.strip()})
    positive = branch.taken is (branch.attribute == "unless")
    for name in names:
        yield name, "true" if positive else "false"
        if len(names) == 1 or defaults.get(name) in others:
            for value in others:
                yield name, value
        yield name, "false" if positive else "true"
