"""Values of ROS 2 launch files taken apart, with the place of every piece."""

from __future__ import annotations

import time

import pytest
from hypothesis import given
from hypothesis import strategies as st

from launchlint.problem import Problem
from launchlint.source import Place, Source, Span
from launchlint.syntax.ros2.description import Substitution, Text
from launchlint.syntax.ros2.problems import UnreadableSubstitution
from launchlint.syntax.ros2.substitutions import parse
from launchlint.syntax.ros2.tables import Distribution
from launchlint.syntax.ros2.written import Written


class OneLine(Written):
    """A text that is a whole file."""

    def __init__(self, text: str) -> None:
        super().__init__(text, Place(Source("value", text), Span(0, len(text))))

    def at(self, start: int, end: int) -> Place:
        return Place(self.place.source, Span(start, end))


def read(text: str, distro: str = "jazzy") -> tuple[Text, list[Problem]]:
    problems: list[Problem] = []
    return parse(OneLine(text), Distribution(distro), problems), problems


def short(text: Text) -> list[object]:
    """Pieces in short: texts as they are, substitutions as lists that begin with their name."""
    return [each if isinstance(each, str) else [each.name, *(short(word) for word in each.arguments)] for each in text.pieces]


CASES: dict[str, list[object]] = {
    "": [],
    "plain": ["plain"],
    r"a\b\\c": ["ab\\c"],
    "$": ["$"],
    "${HOME} $ (x)": ["${HOME} $ (x)"],
    r"\$(var x)": ["$(var x)"],
    "$(dirname)/a": [["dirname"], "/a"],
    "a$(var x)b$(var y)": ["a", ["var", ["x"]], "b", ["var", ["y"]]],
    "$(env A b)": [["env", ["A"], ["b"]]],
    "$(env A '')": [["env", ["A"], []]],
    "$(env A 'b c')": [["env", ["A"], ["b c"]]],
    "$(env A \"b 'c'\")": [["env", ["A"], ["b 'c'"]]],
    r"$(eval '\'a\' == \'b\'')": [["eval", ["'a' == 'b'"]]],
    "$(eval '$(var x) + (1)')": [["eval", [["var", ["x"]], " + (1)"]]],
    "$(eval '$(var \"x\")')": [["eval", [["var", ['"x"']]]]],
    "$(var $(var x)_y)": [["var", [["var", ["x"]], "_y"]]],
    r"$(env A \(b\))": [["env", ["A"], ["(b)"]]],
    r"$(env A b\'c)": [["env", ["A"], ["b'c"]]],
    "$(find-exec a$b)": [["find-exec", ["a$b"]]],
    "$(var a\nb)": [["var", ["a\nb"]]],
}


@pytest.mark.parametrize("text", CASES)
def test_pieces(text: str) -> None:
    made, problems = read(text)
    assert short(made) == CASES[text]
    assert not problems


BAD = {
    "$()": "$( wants a name behind it",
    "$( var x)": "no blank may stand behind $(",
    "$(var  x)": "two blanks stand between words",
    "$(var x )": "a blank stands before the )",
    "$(var\tx)": "only a blank may stand between words",
    "$(var x": "it is not closed",
    "$(var 'x)": "a ' is not closed",
    "$(var a'b)": "a quote stands in a word",
    "$(var 'a'b)": "something stands right behind the closing quote",
    "$(var a(b))": "a parenthesis stands in a word",
    r"$(var x\)": "it is not closed",
    "$(var $(var)": "it is not closed",
}


@pytest.mark.parametrize("text", BAD)
def test_what_cannot_be_read(text: str) -> None:
    made, problems = read(f"a {text}")
    (problem,) = problems
    assert isinstance(problem, UnreadableSubstitution)
    assert problem.refused
    assert problem.reason == BAD[text]
    assert problem.place.text.startswith("$(")
    assert [each.name for each in made.pieces if isinstance(each, Substitution)] == [""]


def test_places_of_words_and_of_substitutions_in_each_other() -> None:
    made, _ = read("a$(eval '$(var x) + 1')")
    outer = made.pieces[1]
    assert isinstance(outer, Substitution)
    assert outer.place.span == (1, 23)
    assert outer.arguments[0].place.text == "$(var x) + 1"
    inner = outer.arguments[0].pieces[0]
    assert isinstance(inner, Substitution)
    assert inner.place.text == "$(var x)"
    assert inner.arguments[0].place.text == "x"


@pytest.mark.parametrize(
    ("text", "distro", "kinds"),
    [
        ("$(arg x)", "jazzy", ["of-ros1"]),
        ("$(var x)", "jazzy", []),
        ("$(var)", "jazzy", ["substitution-arity"]),
        ("$(var a b c)", "jazzy", ["substitution-arity"]),
        ("$(dirname x)", "jazzy", ["substitution-arity"]),
        ("$(if true a)", "jazzy", []),
        ("$(if true a)", "humble", ["not-in-distribution"]),
        ("$(param a 5)", "rolling", []),
        ("$(param a 5)", "humble", ["not-in-distribution"]),
        ("$(param a 5 6)", "humble", ["substitution-arity"]),
        ("$(any a b)", "jazzy", ["broken-in-frontend"]),
        ("$(any a b)", "humble", ["not-in-distribution"]),
        ("$(path-join a b)", "rolling", ["not-in-distribution"]),
        ("$(eval 'x' 'os')", "jazzy", []),
        ("$(eval 'x' $(var m))", "jazzy", ["broken-in-frontend"]),
        ("$(nope $(arg a)) $(var)", "jazzy", ["of-ros1", "unknown-substitution", "substitution-arity"]),
    ],
)
def test_names_and_words_by_distribution(text: str, distro: str, kinds: list[str]) -> None:
    _, problems = read(text, distro)
    assert [problem.kind for problem in problems] == kinds
    assert all(problem.refused for problem in problems)


def test_inner_substitutions_are_refused_first() -> None:
    _, problems = read("$(nope $(arg a))")
    assert [problem.place.text for problem in problems] == ["$(arg a)", "$(nope $(arg a))"]


@given(st.text(alphabet="$()ab'\"\\ \n\t", max_size=40))
def test_any_text_has_pieces_or_a_problem(text: str) -> None:
    made, problems = read(text)
    assert bool(problems) or "$(" not in text or any(isinstance(each, (str, Substitution)) for each in made.pieces)


@pytest.mark.parametrize("piece", ["$(", "$(a ", "$(a '", "$(a b)", "'", "\\", "$(a $(b c) "])
def test_great_values_take_linear_time(piece: str) -> None:
    began = time.process_time()
    read(piece * 20_000)
    assert time.process_time() - began < 5
