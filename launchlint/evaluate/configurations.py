"""Every configuration that matters: the default one, then the fewest further ones that take every branch at least once.

A condition that was not taken (or only taken) is turned by giving another value to one of the entry file's args on which it depends, or to
several where one is not enough. Each configuration is a concrete command line, so each finding comes with the command that shows it.

No value is made up: an arg gets what the files compare it with, and a boolean where they ask nothing but whether it is true. One that is
text anywhere its value goes (part of a path or name, compared with other words) never gets a boolean.
"""

from __future__ import annotations

from collections.abc import Iterator
from itertools import islice, product

from launchlint.evaluate.assemble import Evaluation
from launchlint.evaluate.block import Side
from launchlint.evaluate.ros1.arg_flow import ArgFlow, Pairs
from launchlint.evaluate.ros1.launch import Entered, enter_entry
from launchlint.evaluate.session import Session
from launchlint.model import Branch
from launchlint.syntax.ros1.substitutions import expression_in

MOST_EVALUATIONS = 48
"""Evaluations of one entry file, tried ones included; real files need 1.6 on average."""

MOST_TOGETHER = 3
MOST_COMBINATIONS = 24
"""Args that are changed together for one condition, and how many combinations of their values are tried."""


def configurations(session: Session, file: str, given: tuple[tuple[str, str], ...] = ()) -> Iterator[Evaluation]:
    """Evaluate ``file`` as given, then with single args changed until every reachable side of every condition has been seen.

    Args in ``given`` stay as they are. Only configurations that show something new are yielded.
    """
    pinned = frozenset(name for name, _ in given)
    entered = enter_entry(session, file, given, pinned)
    first = entered.assembled() if isinstance(entered, Entered) else entered
    yield first
    found = [(first, ArgFlow(session, first))]
    seen = _sides(first)
    tried: set[Pairs] = {()}
    evaluations = 1
    # What takes one arg and one look at the condition comes first, for all conditions; then what takes more.
    for alone in (True, False):
        waiting = list(found)
        while waiting:
            base, flow = waiting.pop(0)
            before = base.launch.given[len(given) :]
            places = {} if alone else _by_place(base)
            for branch in _open_branches(base):
                wanted = _side(branch, not branch.taken)
                if wanted in seen:
                    continue
                for pairs in _candidates(branch, flow) if alone else _all_candidates(branch, flow, _around(branch, base, places)):
                    changed = {name for name, _ in pairs}
                    changes = (*(pair for pair in before if pair[0] not in changed), *pairs)
                    if set(changes) == set(before) or tuple(sorted(changes)) in tried:
                        continue
                    tried.add(tuple(sorted(changes)))
                    if evaluations >= MOST_EVALUATIONS:
                        return
                    evaluations += 1
                    telling = found[0][1].telling(changes)
                    if flow.has(pairs) or (len(telling) < len(changes) and tuple(sorted(telling)) in tried):
                        continue  # args are given what they have anyway: all that can come of it has been seen
                    entered = enter_entry(session, file, (*given, *changes), pinned)
                    if isinstance(entered, Entered) and entered.block.sides <= seen:
                        continue
                    evaluation = entered.assembled() if isinstance(entered, Entered) else entered
                    sides = _sides(evaluation)
                    if sides <= seen:
                        continue
                    reached = ArgFlow(session, evaluation)
                    if _breaks_text(changes, reached):
                        continue
                    seen |= sides
                    yield evaluation
                    waiting.append((evaluation, reached))
                    found.append((evaluation, reached))
                    if wanted in seen:
                        break


def _open_branches(base: Evaluation) -> Iterator[Branch]:
    """The conditions that an arg can turn; one of unknown value (a required arg that nobody gave) as not taken and as taken."""
    for branch in base.launch.branches:
        if branch.steered_by and branch.taken is not None:
            yield branch
        elif branch.steered_by:
            yield branch._replace(taken=False)
            yield branch._replace(taken=True)


def _side(branch: Branch, taken: bool) -> Side:
    return (branch.element.source.path, branch.element.span.start, branch.attribute, taken)


def _sides(evaluation: Evaluation) -> set[Side]:
    return {_side(branch, branch.taken) for branch in evaluation.launch.branches if branch.taken is not None}


def _candidates(branch: Branch, flow: ArgFlow) -> Iterator[Pairs]:
    """Single args with values that may turn the condition: what an ``$(eval …)`` compares with, or the opposite boolean."""
    for name, value in _turning(branch, flow):
        yield ((name, value),)


def _all_candidates(branch: Branch, flow: ArgFlow, around: list[Branch]) -> Iterator[Pairs]:
    """As :func:`_candidates`; then what other expressions compare the args with (``value="$(eval mode == 'sim')"``), then several args at
    once.

    Among several are those of the conditions ``around`` this one: ``<group if="$(eval sim or gui)">`` has to stay taken while ``sim`` is
    turned in it.
    """
    yield from _candidates(branch, flow)
    for name in sorted(branch.steered_by):
        for value in flow.literals(name):
            yield ((name, value),)
    names = sorted(branch.steered_by.union(*(each.steered_by for each in around)))
    if not 2 <= len(names) <= MOST_TOGETHER:
        return
    values: dict[str, dict[str | None, None]] = {
        name: {None: None, **(dict.fromkeys(flow.literals(name)) if name in branch.steered_by else {})} for name in names
    }
    for each in (branch, *around):
        for name, value in _turning(each, flow):
            values[name][value] = None
    combinations = (
        tuple((name, value) for name, value in zip(names, together, strict=True) if value is not None)
        for together in product(*(values[name] for name in names))
    )
    yield from islice((pairs for pairs in combinations if len(pairs) > 1), MOST_COMBINATIONS)


def _by_place(base: Evaluation) -> dict[tuple[str, int], Branch]:
    """The conditions, by where their elements stand."""
    by_place: dict[tuple[str, int], Branch] = {}
    for each in base.launch.branches:
        by_place.setdefault(each.element.key, each)
    return by_place


def _around(branch: Branch, base: Evaluation, by_place: dict[tuple[str, int], Branch]) -> list[Branch]:
    """The conditions that ``branch`` stands under, in its own file and in those that include it."""
    found = []
    for place in (branch.element, *branch.origin.chain):
        path = place.source.path
        start = place.span.start
        element = base.documents[path].element_from(start)
        if element is not None and element.start_span.start != start:
            element = None
        while element is not None:
            known = by_place.get((path, element.start_span.start))
            if known is not None and known is not branch and known.steered_by:
                found.append(known)
            element = element.parent
    return found


def _turning(branch: Branch, flow: ArgFlow) -> Iterator[tuple[str, str]]:
    names = sorted(branch.steered_by)
    expression = expression_in(branch.text)
    if expression is not None:
        path = branch.origin.place.source.path
        for name in names:
            for value in flow.literals_in(name, path, expression):
                yield name, value
    positive = branch.taken is (branch.attribute == "unless")
    for name in names:
        for value in flow.booleans(name, positive):
            yield name, value


def _breaks_text(changes: Pairs, flow: ArgFlow) -> bool:
    """Whether a boolean went to an arg that turns out to be text in a file that only this configuration reaches."""
    return any(value in ("true", "false") and flow.nature(name).text for name, value in changes)
