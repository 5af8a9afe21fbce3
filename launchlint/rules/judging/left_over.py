"""What looks like a substitution and stays in a value as it is: the names of files that have it are wrong for that one reason."""

from __future__ import annotations

from launchlint.evaluate.problems import UnexpandedSubstitution
from launchlint.rules.view import LaunchView
from launchlint.syntax.ros1.substitutions import parse, slip


def cause_at(problem: UnexpandedSubstitution) -> str:
    """What LL215 tells of together with all that follows: ``problem`` is its own. A slip of several letters is copied as it is."""
    if problem.extra:
        return f"left over {problem.place.source.path} {problem.place.span.start}"
    return f"left over {'in rosparam ' if problem.rosparam else ''}{problem.text.strip()}"


def left_over_in(name: str, view: LaunchView) -> str:
    """The cause of a file ``name`` that holds text which was meant to be replaced; empty where LL215 tells of no such text in it."""
    if "(" not in name and ")" not in name:
        return ""
    known = (each for each in view.launch.noticed(UnexpandedSubstitution) if not each.rosparam)
    held = [each for each in known if each.text.strip() in name]
    return cause_at(max(held, key=lambda each: len(each.text))) if held else ""


def meant_substitution(value: str) -> str:
    """The substitution that was probably meant by a value which holds something that is nearly one; empty where it holds none."""
    found = slip(parse(value))
    return f"$({' '.join(word.text for word in found.words)})" if found is not None and len(found.words) > 1 else ""
