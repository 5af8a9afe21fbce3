"""What is left when each cause is told once, and still says one thing several times: one idea that was wrong, applied to several lines.

A rule says the same sentence of several lines of one file, but for words of these lines, and names one other thing beside them (the file
that takes none of the args, the program that reads none of the params): that is one edit of one kind. Where a sentence names nothing but
its own line, as that a file does not exist, each line is a mistake of its own. So are two of which one has a repair and the other none.

A rule that knows more of its findings says itself what is one idea, by a function ``idea``.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence

from launchlint.finding import Finding
from launchlint.late import late
from launchlint.rules.judging.joined import joined, said_of, spokesman
from launchlint.rules.registry import find

_MOST_SAID = 6
_WORD = late(r"[^\s,:;()'\"<>=]{1,500}")
_NAME = late(r"(?=.{0,500}[/_.])(?=.{0,500}[^\W\d]).{0,500}[^.]")


Idea = Callable[[Finding], "tuple[object, ...] | None"]
"""What is the same for findings of a rule that one idea has brought about; None of one of which the rule knows no such."""


def by_idea(findings: Iterable[Finding]) -> list[list[int]]:
    """The numbers of those ``findings`` that say one thing, together, in the order in which the first of each comes."""
    found: dict[object, list[int]] = {}
    for number, finding in enumerate(findings):
        known = _known(finding.rule)
        idea = (known and known(finding)) or _sentence(finding)
        found.setdefault(number if idea is None else (finding.rule, finding.severity, *idea), []).append(number)
    return list(found.values())


def told_of_one(findings: Sequence[Finding]) -> Finding:
    """What one idea comes to: as :func:`joined`, and in notes what is said of the same place, and other advice for other places."""
    first = spokesman(findings)
    here = [each for each in findings if each is not first and each.location == first.location]
    notes = [f"likewise: {said_of(each)[0]}" for each in here]
    advice = [first.help]
    for each in findings:
        if each.location != first.location and each.help and not any(_is_alike(each.help, other) for other in advice):
            advice.append(each.help)
            notes.append(f"{each.location.path}:{each.location.line}: {each.help}")
    related = tuple(dict.fromkeys(item for each in (first, *here) for item in each.related))
    said = first._replace(notes=tuple(dict.fromkeys((*first.notes, *notes[:_MOST_SAID]))), related=related)
    return joined([said, *(each for each in findings if each is not first)], said)


def _is_alike(help: str, other: str) -> bool:
    """Whether two helps say the same, but for names: as many words, of which at least half are the same."""
    words, others = help.split(), other.split()
    return len(words) == len(others) and 2 * sum(map(str.__eq__, words, others)) >= len(words)


def _known(name: str) -> Idea | None:
    """How the rule ``name`` says what is one idea, where it does."""
    rule = find(name)
    return None if rule is None else getattr(rule.load(), "idea", None)


def _sentence(finding: Finding) -> tuple[object, ...] | None:
    """What is said of a line of a file, without the words of the line; None where it names nothing else."""
    place = finding.location
    own = frozenset(_WORD.findall(place.text))
    said = _without(own, said_of(finding)[0])
    others = {word for word in said if _NAME.fullmatch(word)}
    if not others - {place.path}:
        return None
    return (place.path, finding.label, said, _without(own, finding.help), finding.fix is None)


def _without(own: frozenset[str], text: str) -> tuple[str, ...]:
    """The words of ``text``, with nothing for those of its line."""
    return tuple("" if word in own else word for word in _WORD.findall(text))
