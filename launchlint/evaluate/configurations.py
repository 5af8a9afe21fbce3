"""Every configuration that matters: the default one, then the fewest further ones that take every branch at least once.

A condition that was not taken (or only taken) is turned by giving another value to one of the entry file's args on which it depends, or to
several where one is not enough. Each configuration is a concrete command line, so each finding comes with the command that shows it.

No value is made up: an arg gets what the files compare it with, and a boolean where they ask nothing but whether it is true. One that is
text anywhere its value goes (part of a path or name, compared with other words) never gets a boolean.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator
from itertools import islice, product

from launchlint.evaluate.assemble import Evaluation
from launchlint.evaluate.block import Side
from launchlint.evaluate.session import Session
from launchlint.model import Branch
from launchlint.named_tuple import NamedTuple

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable, Set
    from typing import Protocol, TypeAlias

    Pairs: TypeAlias = tuple[tuple[str, str], ...]
    """Args that are given, with their values."""
    Enter: TypeAlias = Callable[[Session, str, Pairs, frozenset[str], Set[Side] | None], Evaluation | None]
    """Evaluates an entry file; None where nothing but these sides of conditions would be seen."""

    class Flow(Protocol):
        """What one evaluation says of the args of its entry file."""

        def telling(self, given: Pairs) -> Pairs:
            """The args of ``given`` without those that get what they have anyway."""

        def has(self, pairs: Pairs) -> bool:
            """Whether all args of ``pairs`` have these values in this configuration."""

        def literals(self, name: str) -> tuple[str, ...]:
            """What the arg ``name`` is compared with anywhere."""

        def turning(self, branch: Branch) -> Iterator[tuple[str, str]]:
            """Args with values that may turn a condition: what it compares them with, or the opposite boolean."""

        def breaks_text(self, changes: Pairs) -> bool:
            """Whether a boolean went to an arg that turns out to be text in a file that only this configuration reaches."""


MOST_EVALUATIONS = 48
"""Evaluations of one entry file, tried ones included; real files need 1.6 on average."""

ENOUGH = 2
"""How often the same is tried in vain to turn a condition, when what takes several args is tried: it may turn another one by chance."""

MOST_TOGETHER = 3
MOST_COMBINATIONS = 24
"""Args that are changed together for one condition, and how many combinations of their values are tried."""


class Way(NamedTuple):
    """How the files of a dialect are evaluated, and what is known of their args then.

    ``most_work``: conditions, nodes, includes and args of all evaluations together: a launch of thousands of nodes is evaluated a few
    times only.
    """

    enter: Enter
    flow: Callable[[Session, Evaluation], Flow]
    most_work: int | None = None


def roslaunch() -> Way:
    """The way of ROS 1."""
    from launchlint.evaluate.ros1.arg_flow import ArgFlow
    from launchlint.evaluate.ros1.launch import enter_unless_seen

    return Way(enter_unless_seen, ArgFlow)


def configurations(session: Session, file: str, given: Pairs = (), way: Way | None = None) -> Iterator[Evaluation]:
    """Evaluate ``file`` as given, then with single args changed until every reachable side of every condition has been seen.

    Args in ``given`` stay as they are. Only configurations that show something new are yielded. Without a ``way`` it is that of ROS 1.
    """
    enter, flow_of, most_work = way or roslaunch()
    pinned = frozenset(name for name, _ in given)
    first = enter(session, file, given, pinned, None)
    assert first is not None  # nothing has been seen before
    yield first
    found = [(first, flow_of(session, first))]
    seen = _sides(first)
    tried: set[Pairs] = {()}
    vain = _Vain()
    evaluations = 1
    work = _work(first)
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
                    if vain.holds(wanted, pairs, changes, 1 if alone else ENOUGH):
                        continue
                    tried.add(tuple(sorted(changes)))
                    if evaluations >= MOST_EVALUATIONS:
                        return
                    evaluations += 1
                    session.checkpoint()
                    telling = found[0][1].telling(changes)
                    if flow.has(pairs) or (len(telling) < len(changes) and tuple(sorted(telling)) in tried):
                        continue  # args are given what they have anyway: all that can come of it has been seen
                    evaluation = enter(session, file, (*given, *changes), pinned, seen)
                    if evaluation is None:
                        continue
                    work += _work(evaluation)
                    if most_work is not None and work > most_work:
                        return
                    sides = _sides(evaluation)
                    vain.note(base, pairs, changes, evaluation, sides)
                    if sides <= seen:
                        continue
                    reached = flow_of(session, evaluation)
                    if reached.breaks_text(changes):
                        continue
                    seen |= sides
                    yield evaluation
                    waiting.append((evaluation, reached))
                    found.append((evaluation, reached))
                    if wanted in seen:
                        break


class _Vain:
    """What was tried to turn conditions, in vain: so it would be once more where all is the same that they are known to depend on."""

    def __init__(self) -> None:
        self._known: dict[tuple[Side, Pairs], Counter[frozenset[tuple[str, str | None]]]] = {}

    def note(self, base: Evaluation, pairs: Pairs, changes: Pairs, evaluation: Evaluation, sides: Set[Side]) -> None:
        """Behind ``base``, args ``changes``, among them ``pairs``, were given, and this came of it, with these sides of conditions."""
        if any(each.around is None for each in base.launch.branches):
            return
        hangs_on: dict[tuple[str, int], set[str]] = {}
        for each in (*base.launch.branches, *evaluation.launch.branches):
            hangs_on.setdefault(each.element.key, set()).update(each.steered_by, each.around or ())
        given, changed = dict(changes), {name for name, _ in pairs}
        for wanted, names in {_side(each, not each.taken): hangs_on[each.element.key] for each in _open_branches(base)}.items():
            if wanted not in sides and not names.isdisjoint(changed):
                values = frozenset((name, given.get(name)) for name in names)
                self._known.setdefault((wanted, pairs), Counter())[values] += 1

    def holds(self, wanted: Side, pairs: Pairs, changes: Pairs, enough: int) -> bool:
        """Whether ``changes``, among them ``pairs``, have been tried in vain so often to turn the condition to ``wanted``."""
        known = self._known.get((wanted, pairs))
        if not known:
            return False
        given = dict(changes)
        return any(count >= enough and all(given.get(name) == value for name, value in values) for values, count in known.items())


def _work(evaluation: Evaluation) -> int:
    launch = evaluation.launch
    return len(launch.branches) + len(launch.nodes) + len(launch.includes) + len(launch.declared)


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


def _candidates(branch: Branch, flow: Flow) -> Iterator[Pairs]:
    """Single args with values that may turn the condition: what an ``$(eval …)`` compares with, or the opposite boolean."""
    for name, value in flow.turning(branch):
        yield ((name, value),)


def _all_candidates(branch: Branch, flow: Flow, around: list[Branch]) -> Iterator[Pairs]:
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
        for name, value in flow.turning(each):
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
        document = base.documents.get(path)  # there is no tree of YAML
        element = None if document is None else document.element_from(start)
        if element is not None and element.start_span.start != start:
            element = None
        while element is not None:
            known = by_place.get((path, element.start_span.start))
            if known is not None and known is not branch and known.steered_by:
                found.append(known)
            element = element.parent
    return found
