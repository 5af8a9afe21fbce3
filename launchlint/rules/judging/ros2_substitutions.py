"""What LL207 says of substitutions that launch in ROS 2 cannot read or make."""

from __future__ import annotations

import re
from collections.abc import Iterator

from launchlint.finding import Finding, Fix
from launchlint.plural import counted
from launchlint.rules.edits import LOADS2, fix, write_over
from launchlint.rules.rule import Rule
from launchlint.source import Place, Span
from launchlint.spelling import closest, surely
from launchlint.syntax.ros2.problems import SubstitutionArity, UnknownSubstitution, UnreadableSubstitution

_NOTES = ("ros2 launch refuses the file, also where the value is never used",)
# Not the grammar of substitutions: what it finds is one that launch cannot read, and would without these blanks.
_BLANKS = re.compile(r"\$\( *([A-Za-z][\w-]*)((?: +[^\s'\"()$\\]+)*) *\)")
_SAME = {"find-package-share": "find-pkg-share", "find-package": "find-pkg-share", "exec-in-package": "exec-in-pkg", "parameter": "param"}


def tell(problem: UnreadableSubstitution | UnknownSubstitution | SubstitutionArity, rule: Rule) -> Iterator[Finding]:
    """Say what is wrong with it."""
    place = problem.place
    shown = place.text[:60] + ("…" if len(place.text) > 60 else "")
    if isinstance(problem, UnreadableSubstitution):
        yield rule.at(
            problem.origin,
            f"{shown} cannot be read: {problem.reason}",
            related=tuple((at, "here") for at, _ in problem.related),
            notes=_NOTES,
            help=problem.related[0][1] if problem.related else "",
            fix=_blanks(place),
        )
        return
    if isinstance(problem, SubstitutionArity):
        wanted = _words(problem.fewest, problem.most)
        too_many = "put what holds blanks in quotes" if problem.most else "remove what stands behind the name"
        if problem.name == "eval":
            too_many = "put the expression in quotes: $(eval '…'), and texts in it in quotes of the other sort"
        advice = too_many if problem.count > problem.most else f"give it {wanted}"
        message = f"$({problem.name} …) takes {wanted}, and has {problem.count}"
        yield rule.at(problem.origin, message, notes=_NOTES, help=advice, cause=f"{place.source.path} {place.text}")
        return
    name = problem.name
    near = _SAME.get(name) or closest(name, problem.known)
    sure = near is not None and (name in _SAME or surely(name, problem.known) == near)
    yield rule.at(
        problem.origin,
        f"there is no substitution {name}",
        label="unknown to launch",
        notes=_NOTES,
        help=f"did you mean {near}?" if near is not None else f"there are {', '.join(problem.known)}",
        fix=None if near is None else _renamed(place, name, near, safe=sure),
        cause=f"{place.source.path} {name}",
    )


def _words(fewest: int, most: int) -> str:
    if fewest == most:
        return counted(fewest, "word") if fewest else "no words"
    return f"{fewest} or {most} words"


def _renamed(place: Place, name: str, near: str, *, safe: bool) -> Fix | None:
    start = place.span.start + len("$(")
    return fix(f"write {near}", write_over(Place(place.source, Span(start, start + len(name))), name, near), safe=safe, changes=LOADS2)


def _blanks(place: Place) -> Fix | None:
    """One blank between words, where blanks are all that is wrong."""
    match = _BLANKS.match(place.text)
    if match is None:
        return None
    text = f"$({' '.join((match[1], *match[2].split()))})"
    at = Place(place.source, Span(place.span.start, place.span.start + match.end()))
    return fix(f"write {text}", write_over(at, match[0], text), safe=True, changes=LOADS2) if text != match[0] else None
