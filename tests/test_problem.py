"""Problems: one class for each kind, frozen, with the fields that its rule needs."""

from __future__ import annotations

import pytest

import launchlint.evaluate.problems as evaluate
import launchlint.syntax.problems as syntax
from launchlint.evaluate.problems import IncludeNotFound, Ros2Parameters, UnexpandedSubstitution
from launchlint.problem import Problem
from launchlint.source import Origin, Place, Source, Span

HERE = Origin(Place(Source("a.launch", "<launch/>"), Span(1, 7)))
KINDS = [each for room in (syntax, evaluate) for each in vars(room).values() if isinstance(each, type) and each.__module__ == room.__name__]


def test_fields_do_not_change() -> None:
    problem = UnexpandedSubstitution(origin=HERE, text="$(arg", extra=False)
    with pytest.raises(AttributeError, match="UnexpandedSubstitution does not change"):
        problem.text = "else"  # type: ignore[misc]  # this is what it refuses
    assert (problem.text, problem.extra, problem.rosparam, problem.refused, problem.assumed) == ("$(arg", False, False, False, False)
    assert (problem.place, problem.related) == (HERE.place, ())


def test_another_one_with_changes() -> None:
    problem = UnexpandedSubstitution(origin=HERE, refused=True, text="$(arg", extra=True)
    other = problem.but(refused=False, assumed=True)
    assert (type(other), other.text, other.extra, other.refused, other.assumed) == (UnexpandedSubstitution, "$(arg", True, False, True)
    assert (problem.refused, problem.assumed) == (True, False)
    there = Origin(Place(Source("b.launch", ""), Span(0, 0)))
    assert (problem.but(origin=there).origin, problem.but().origin) == (there, HERE)


def test_kinds_have_names() -> None:
    assert IncludeNotFound(origin=HERE, file="", written="", reason="", environment=False).kind == "include-not-found"
    assert Ros2Parameters(origin=HERE, name="", count=0).kind == "ros2-parameters"
    names = [kind.__name__ for kind in KINDS]
    assert len(set(names)) == len(names) > 40


@pytest.mark.parametrize("kind", KINDS, ids=lambda kind: kind.__name__)
def test_every_kind_says_what_it_is(kind: type[Problem]) -> None:
    assert issubclass(kind, Problem)
    assert (kind.__doc__ or "").strip().endswith(".")
    assert not kind.__annotations__.keys() & Problem.__annotations__.keys()
