"""One cause, one finding: what many findings say for one and the same reason is told once, at one of their places.

Suppressions, baselines and fixes work on the single findings; this is the last step before people see them. A rule whose module has a
function ``together`` says itself what several of its findings of one cause (worst first) come to; else the first of them speaks for all.
One with a function ``of_copies`` joins, in a second step, those of its joined findings that say the same of one copy after another. Last,
what one idea has brought about is told once: see :mod:`launchlint.check.one_idea`.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence

from launchlint.finding import Finding, Severity
from launchlint.named_tuple import NamedTuple
from launchlint.order import most_severe_first, ordered, total
from launchlint.rules.judging.joined import joined, spokesman
from launchlint.rules.registry import find

_SHORTEST_LINE = 40
"""Characters of a line that two people would not write alike by chance."""
_SHORTEST_HABIT = 20
"""Characters of one that stands in several files alike, not by chance."""
_LONGEST_SAYING = 80
"""Characters from which nobody says the same of two places by chance: it names what one copied from the other."""
_SEVERAL = 3


class Told(NamedTuple):
    """A finding as people see it, and the single ones ``of`` one cause that it stands for: itself, where it is the only one."""

    finding: Finding
    of: tuple[Finding, ...]


def told_once(findings: Iterable[Finding]) -> tuple[Finding, ...]:
    """What people see of ``findings``: see :func:`told_with_theirs`."""
    return tuple(each.finding for each in told_with_theirs(findings))


def told_with_theirs(findings: Iterable[Finding]) -> tuple[Told, ...]:
    """``findings`` in report order; one for all of one :attr:`Finding.cause`, with the places of the others. Each stands in one of them.

    Mistakes of which a rule says the very same in one file are one, too: people make them in one go. So are those of which it says the same
    where the same is written: one was copied. So are those of files that were copied from each other under another number or side.
    """
    result: list[Told] = []
    alike: dict[str | tuple[str, ...], list[Finding]] = {}
    for finding in ordered(findings):
        if not finding.cause and finding.severity is Severity.INFO:
            result.append(Told(finding, (finding,)))
            continue
        cause = finding.cause or (finding.rule, finding.severity.word, finding.location.path, finding.message, finding.help)
        alike.setdefault(cause, []).append(finding)
    if not alike:
        return tuple(result)
    groups = _with_copies(alike.values())
    if len(groups) > 1:
        from launchlint.check.siblings import with_siblings

        groups = with_siblings(groups, _knows_copies)
    told = [Told(_told(group) if len(group) > 1 else group[0], tuple(group)) for group in groups]
    told = sorted(_of_copies(told), key=lambda each: total(each.finding))
    return tuple(sorted([*result, *_of_ideas(told)], key=lambda each: total(each.finding)))


def _with_copies(groups: Iterable[list[Finding]]) -> list[list[Finding]]:
    """``groups`` of one cause each; those together whose rule says the same words of the same line: it was copied to other files.

    A short line that only two have may be chance; of one in three files somebody made a habit.
    """
    found: dict[object, list[list[Finding]]] = {}
    for group in groups:
        first = spokesman(group)
        line = first.message if len(first.message) >= _LONGEST_SAYING else first.location.text.strip()
        copied = len(line) >= _SHORTEST_LINE
        habit = not copied and len(line) >= _SHORTEST_HABIT and all(each.message == first.message for each in group)
        same = (first.rule, first.severity, first.message, first.help, line, copied) if copied or habit else id(group)
        found.setdefault(same, []).append(group)
    result: list[list[Finding]] = []
    for key, copies in found.items():
        if len(copies) >= _SEVERAL or (isinstance(key, tuple) and key[-1]):
            result.append([finding for group in copies for finding in group])
        else:
            result.extend(copies)
    return result


def _of_copies(told: Iterable[Told]) -> Iterator[Told]:
    """``told`` of one cause each; one for those that say the same of copies, where their rule knows such."""
    by_rule: dict[str, list[Told]] = {}
    for each in told:
        by_rule.setdefault(each.finding.rule, []).append(each)
    for name, several in by_rule.items():
        copies = _knows_copies(name) if len(several) > 1 else None
        yield from several if copies is None else _standing_for(list(copies([each.finding for each in several])), several)


def _of_ideas(told: Sequence[Told]) -> Iterator[Told]:
    """``told`` of one cause each; one for those of one idea."""
    if len({each.finding.rule for each in told}) == len(told):
        yield from told
        return
    from launchlint.check.one_idea import by_idea, told_of_one

    for numbers in by_idea([each.finding for each in told]):
        several = [told[number] for number in numbers]
        if len(several) == 1:
            yield several[0]
        else:
            yield Told(told_of_one([each.finding for each in several]), tuple(ordered([one for each in several for one in each.of])))


def _knows_copies(name: str) -> Callable[[Sequence[Finding]], Iterable[Finding]] | None:
    """How the rule ``name`` joins its findings about copies itself, where it does."""
    rule = find(name)
    return None if rule is None else getattr(rule.load(), "of_copies", None)


def _standing_for(findings: Sequence[Finding], told: Sequence[Told]) -> Iterator[Told]:
    """``findings``, which a rule made of those ``told``, with what each stands for: what is gone stands in one that has its place."""
    left = {id(each.finding): each for each in told}
    own = [left.pop(id(finding), None) for finding in findings]
    joined_ones = [number for number, known in enumerate(own) if known is None] or list(range(len(findings)))
    places = {number: {findings[number].location, *(each.location for each in findings[number].related)} for number in joined_ones}
    taken: dict[int, list[Finding]] = {}
    for each in left.values():
        number = next((number for number in joined_ones if each.finding.location in places[number]), joined_ones[0])
        taken.setdefault(number, []).extend(each.of)
    for number, (finding, known) in enumerate(zip(findings, own, strict=True)):
        yield Told(finding, tuple(ordered([*(known.of if known else ()), *taken.get(number, ())])))


def _told(findings: Sequence[Finding]) -> Finding:
    """One finding for ``findings``, as the rule of the one that speaks for them says."""
    from launchlint.check import copied, copied_block, fragments

    first = spokesman(findings)
    if first.cause.startswith(fragments.PREFIX):
        return fragments.told_together(most_severe_first(findings))
    if first.cause.startswith(copied_block.PREFIX):
        return copied_block.told_together(most_severe_first(findings))
    if first.cause.startswith(copied.PREFIX):
        return copied.told_together(most_severe_first(findings))
    rule = find(first.rule)
    together: Callable[[Sequence[Finding]], Finding] | None = None if rule is None else getattr(rule.load(), "together", None)
    return joined(findings) if together is None else together(most_severe_first(findings))
