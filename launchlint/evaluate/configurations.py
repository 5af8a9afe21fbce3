"""Every configuration that matters: the default one, then the fewest further ones that take every branch at least once.

A condition that was not taken (or only taken) is turned by giving another value to one of the entry file's args on which it depends, or to
several where one is not enough. Each configuration is a concrete command line, so each finding comes with the command that shows it.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from itertools import islice, product

from launchlint.evaluate.assemble import Evaluation
from launchlint.evaluate.launch import evaluate
from launchlint.evaluate.session import Session
from launchlint.model import Argument, Branch, Unknown

TYPE_CHECKING = False
if TYPE_CHECKING:
    from launchlint.syntax.tree import Document

MOST_EVALUATIONS = 48
"""Evaluations of one entry file, tried ones included; real files need 1.6 on average."""

MOST_TOGETHER = 3
MOST_COMBINATIONS = 24
"""Args that are changed together for one condition, and how many combinations of their values are tried."""

BOOLEANS = ("true", "false", "1", "0")

Pairs = tuple[tuple[str, str], ...]
Side = tuple[str, int, str, bool]


def configurations(session: Session, file: str, given: tuple[tuple[str, str], ...] = ()) -> Iterator[Evaluation]:
    """Evaluate ``file`` as given, then with single args changed until every reachable side of every condition has been seen.

    Args in ``given`` stay as they are. Only configurations that show something new are yielded.
    """
    pinned = frozenset(name for name, _ in given)
    first = evaluate(session, file, given, pinned)
    yield first
    found = [first]
    seen = _sides(first)
    tried: set[Pairs] = {()}
    evaluations = 1
    # What takes one arg and one look at the condition comes first, for all conditions; then what takes more.
    for candidates in (_candidates, _all_candidates):
        waiting = list(found)
        while waiting:
            base = waiting.pop(0)
            before = base.launch.given[len(given) :]
            for branch in _open_branches(base):
                wanted = _side(branch, not branch.taken)
                if wanted in seen:
                    continue
                for pairs in candidates(branch, base):
                    changed = {name for name, _ in pairs}
                    changes = (*(pair for pair in before if pair[0] not in changed), *pairs)
                    if set(changes) == set(before) or tuple(sorted(changes)) in tried:
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
                    found.append(evaluation)
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


def _candidates(branch: Branch, base: Evaluation) -> Iterator[Pairs]:
    """Single args with values that may turn the condition: the opposite boolean, or what an ``$(eval …)`` compares with."""
    defaults = _defaults(base.launch.declared)
    for name, value in _turning(branch, defaults):
        if _is_plausible(defaults.get(name), value):
            yield ((name, value),)


def _all_candidates(branch: Branch, base: Evaluation) -> Iterator[Pairs]:
    """As :func:`_candidates`; then what other expressions compare the args with (``value="$(eval mode == 'sim')"``), then several args at
    once.

    Among several are those of the conditions around this one: ``<group if="$(eval sim or gui)">`` has to stay taken while ``sim`` is
    turned in it.
    """
    yield from _candidates(branch, base)
    defaults = _defaults(base.launch.declared)
    elsewhere = _compared(base.documents.values(), branch.steered_by)
    for name in sorted(elsewhere):
        for value in elsewhere[name]:
            if _is_plausible(defaults.get(name), value):
                yield ((name, value),)
    around = _around(branch, base)
    names = sorted(branch.steered_by.union(*(each.steered_by for each in around)))
    if not 2 <= len(names) <= MOST_TOGETHER:
        return
    values: dict[str, dict[str | None, None]] = {
        name: {None: None, **dict.fromkeys(value for value in elsewhere.get(name, ()) if _is_plausible(defaults.get(name), value))}
        for name in names
    }
    for each in (branch, *around):
        for name, value in _turning(each, defaults):
            if _is_plausible(defaults.get(name), value):
                values[name][value] = None
    combinations = (
        tuple((name, value) for name, value in zip(names, together, strict=True) if value is not None)
        for together in product(*(values[name] for name in names))
    )
    yield from islice((pairs for pairs in combinations if len(pairs) > 1), MOST_COMBINATIONS)


def _around(branch: Branch, base: Evaluation) -> list[Branch]:
    """The conditions that ``branch`` stands under, in its own file and in those that include it."""
    by_place: dict[tuple[str, int], Branch] = {}
    for each in base.launch.branches:
        by_place.setdefault((each.element.source.path, each.element.span.start), each)
    found = []
    for place in (branch.element, *branch.origin.chain):
        path = place.source.path
        start = place.span.start
        element = next((each for each in base.documents[path].elements if each.start_span.start == start), None)
        while element is not None:
            known = by_place.get((path, element.start_span.start))
            if known is not None and known is not branch and known.steered_by:
                found.append(known)
            element = element.parent
    return found


def _compared(documents: Iterable[Document], names: frozenset[str]) -> dict[str, tuple[str, ...]]:
    """What the ``$(eval …)`` of all reached files compare ``names`` with."""
    from launchlint.evaluate.ros1.expression import compared_literals

    found: dict[str, dict[str, None]] = {}
    for document in documents:
        for element in document.elements:
            for attribute in element.attributes.values():
                if attribute.value.startswith("$(eval "):
                    for name, values in compared_literals(attribute.value[7:-1]).items():
                        if name in names:
                            found.setdefault(name, {}).update(dict.fromkeys(value for value in values if value.strip()))
    return {name: tuple(values) for name, values in found.items()}


def _defaults(declared: tuple[Argument, ...]) -> dict[str, str | Unknown | None]:
    """The defaults of the args of the entry file."""
    return {argument.name: argument.default for argument in declared if argument.origin.step is None and not argument.passed}


def _is_plausible(default: str | Unknown | None, value: str) -> bool:
    """Whether somebody would give ``value`` to an arg with this default.

    Nobody gives a boolean where the default is another text, and what goes wrong then is no mistake of the file.
    """
    return value not in BOOLEANS or not isinstance(default, str) or default.strip().lower() in BOOLEANS


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
