"""Every side of every condition is taken by some configuration, and no configuration is there for nothing."""

from __future__ import annotations

import tempfile
from collections.abc import Sequence
from itertools import product
from pathlib import Path
from random import Random

import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from launchlint.evaluate.assemble import Evaluation
from launchlint.evaluate.configurations import MOST_EVALUATIONS, configurations
from launchlint.evaluate.ros1 import launch as room
from launchlint.evaluate.ros1.arg_flow import ArgFlow
from launchlint.evaluate.ros1.launch import Entered, enter_entry, evaluate
from tests.evaluate.comparison import MAIN, Case, case, inside, session_in, write

Given = tuple[tuple[str, str], ...]

SIM = '<arg name="sim" default="false"/>'
GUI = '<arg name="gui" default="false"/>'
MODE = '<arg name="mode" default="a"/>'
NUMBER = '<arg name="n" default="1"/>'


def evaluations(each: Case, directory: Path, pairs: Given = ()) -> list[Evaluation]:
    """Every configuration of ``each``, started with ``pairs``."""
    write(each, directory)
    with inside(directory):
        return list(configurations(session_in(directory), str(directory / MAIN), pairs))


def given_in(each: Case, directory: Path, pairs: Given = ()) -> list[dict[str, str]]:
    """The command line of every configuration."""
    return [dict(evaluation.launch.given) for evaluation in evaluations(each, directory, pairs)]


FOUND: dict[str, tuple[Case, list[dict[str, str]]]] = {
    "no condition": (case("[[n]]"), [{}]),
    "a condition that no arg steers": (case('[[n if="false"]][[m unless="$(optenv SIM 1)"]]'), [{}]),
    "an arg with value=": (case('<arg name="sim" value="false"/>[[n if="$(arg sim)"]]'), [{}]),
    "if": (case(SIM + '[[n if="$(arg sim)"]]'), [{}, {"sim": "true"}]),
    "unless": (case(SIM + '[[n unless="$(arg sim)"]]'), [{}, {"sim": "true"}]),
    "a default that is 1": (case('<arg name="sim" default="1"/>[[n if="$(arg sim)"]]'), [{}, {"sim": "0"}]),
    "both sides with two tags": (case(SIM + '[[n if="$(arg sim)"]][[m unless="$(arg sim)"]]'), [{}, {"sim": "true"}]),
    "one arg in twenty conditions": (case(SIM + "".join(f'[[n{number} if="$(arg sim)"]]' for number in range(20))), [{}, {"sim": "true"}]),
    "two args": (case(SIM + GUI + '[[n if="$(arg sim)"]][[m if="$(arg gui)"]]'), [{}, {"sim": "true"}, {"gui": "true"}]),
    "a condition inside another": (
        case(SIM + GUI + '<group if="$(arg sim)">[[m if="$(arg gui)"]]</group>'),
        [{}, {"sim": "true"}, {"sim": "true", "gui": "true"}],
    ),
    "two args in one condition, one is enough": (
        case('<arg name="sim" default="true"/>' + GUI + '[[n if="$(eval sim and gui)"]]'),
        [{}, {"gui": "true"}],
    ),
    "two args in one condition, both are needed": (
        case(SIM + GUI + '[[n if="$(eval sim and gui)"]]'),
        [{}, {"gui": "true", "sim": "true"}],
    ),
    "two texts in one condition": (
        case(MODE + '<arg name="world" default="a"/>' + "[[n if=\"$(eval mode == 'p' and world == 'q')\"]]"),
        [{}, {"mode": "p", "world": "q"}],
    ),
    "texts that are compared with": (
        case(MODE + "".join(f"[[n{text} if=\"$(eval mode == '{text}')\"]]" for text in "abc")),
        [{}, {"mode": "b"}, {"mode": "c"}],
    ),
    "a list of texts": (case(MODE + "[[n if=\"$(eval mode in ['b', 'c'])\"]]"), [{}, {"mode": "b"}]),
    "numbers": (case(NUMBER + '[[n if="$(eval n &gt;= 2)"]][[m if="$(eval n == 7)"]]'), [{}, {"n": "2"}, {"n": "7"}]),
    "an arg of a group": (case(f'<group>{SIM}[[n if="$(arg sim)"]]</group>'), [{}, {"sim": "true"}]),
    "an arg made from another": (
        case(SIM + '<arg name="real" value="$(eval not sim)"/>[[n if="$(arg real)"]]'),
        [{}, {"sim": "true"}],
    ),
    "an arg made by conditions": (
        case(SIM + '<arg name="x" value="1" if="$(arg sim)"/><arg name="x" value="0" unless="$(arg sim)"/>[[n if="$(arg x)"]]'),
        [{}, {"sim": "true"}],
    ),
    "an arg made by comparing another": (
        case(MODE + "<arg name=\"x\" value=\"$(eval 'true' if mode == 'z' else 'false')\"/>[[n if=\"$(arg x)\"]]"),
        [{}, {"mode": "z"}],
    ),
    "through an include": (
        case(
            SIM + '<include file="$(dirname)/i.launch"><arg name="fake" value="$(arg sim)"/></include>',
            files={"i.launch": '<arg name="fake"/>[[n if="$(arg fake)"]]'},
        ),
        [{}, {"sim": "true"}],
    ),
    "through an include, compared under another name": (
        case(
            MODE + '<include file="$(dirname)/i.launch"><arg name="kind" value="$(arg mode)"/></include>',
            files={"i.launch": '<arg name="kind"/>[[n if="$(eval kind == \'b\')"]]'},
        ),
        [{}, {"mode": "b"}],
    ),
    "through pass_all_args": (
        case(
            SIM + '<include file="$(dirname)/i.launch" pass_all_args="true"/>', files={"i.launch": '<arg name="sim"/>[[n if="$(arg sim)"]]'}
        ),
        [{}, {"sim": "true"}],
    ),
    "an arg of an included file that nobody passes": (
        case('<include file="$(dirname)/i.launch"/>', files={"i.launch": SIM + '[[n if="$(arg sim)"]]'}),
        [{}],
    ),
    "an include that is taken in one configuration only": (
        case(
            SIM + GUI + '<include file="$(dirname)/i.launch" if="$(arg sim)"><arg name="gui" value="$(arg gui)"/></include>',
            files={"i.launch": '<arg name="gui"/>[[n if="$(arg gui)"]]'},
        ),
        [{}, {"sim": "true"}, {"sim": "true", "gui": "true"}],
    ),
    "the same file by two ways": (
        case(
            SIM
            + '<include file="$(dirname)/i.launch" ns="a"><arg name="x" value="$(arg sim)"/></include>'
            + '<include file="$(dirname)/i.launch" ns="b"><arg name="x" value="true"/></include>',
            files={"i.launch": '<arg name="x"/>[[n if="$(arg x)"]]'},
        ),
        [{}],
    ),
    "a text is not given a boolean": (
        case('<arg name="file" default="map.yaml"/><group unless="$(eval file == \'\')">[[n]]</group>'),
        [{}],
    ),
    "a required arg is given what it is compared with, and no boolean": (
        case('<arg name="mode"/>[[n if="$(eval mode == \'fast\')"]]'),
        [{}, {"mode": "fast"}],
    ),
    "a required arg that is part of a path": (
        case('<arg name="map"/><group if="$(eval bool(map) and True)"><rosparam file="$(dirname)/$(arg map).yaml"/></group>'),
        [{}],
    ),
    "a boolean that is part of a name too": (
        case(SIM + '[[n if="$(arg sim)"]]<node pkg="p" type="t" name="driver_$(arg sim)"/>'),
        [{}, {"sim": "true"}],
    ),
    "what is true or false by default, but part of a name and no condition": (
        case(SIM + '[[n unless="$(eval not sim)"]]<node pkg="p" type="t" name="driver_$(arg sim)"/>'),
        [{}],
    ),
    "a word that says none": (
        case('<arg name="config" default="false"/><rosparam file="$(arg config)" unless="$(eval config == \'false\')"/>'),
        [{}],
    ),
    "an arg that is only text in a branch": (
        case('<arg name="map"/><group if="$(eval not map)">[[n]]</group><remap from="a" to="$(arg map)" if="false"/>'),
        [{}],
    ),
    "a required arg that an expression asks for its truth": (
        case('<arg name="gui"/><group if="$(eval not gui)">[[n]]</group><param name="gui" value="$(arg gui)"/>'),
        [{}, {"gui": "true"}, {"gui": "false"}],
    ),
    "an arg that is passed on and text there": (
        case(
            '<arg name="robot"/><group unless="$(eval not robot)">[[n]]</group>'
            '<include file="$(dirname)/i.launch"><arg name="type" value="$(arg robot)"/></include>',
            files={"i.launch": '<arg name="type"/><rosparam file="$(dirname)/$(arg type).yaml"/>'},
        ),
        [{}],
    ),
    "an arg that is passed on and has a text as default there": (
        case(
            '<arg name="robot"/><group unless="$(eval not robot)">[[n]]</group>'
            '<include file="$(dirname)/i.launch"><arg name="type" value="$(arg robot)"/></include>',
            files={"i.launch": '<arg name="type" default="arm"/>'},
        ),
        [{}],
    ),
    "an arg that is text in a file that only the other branch includes": (
        case(
            SIM + '<include if="$(eval not not sim)" file="$(dirname)/i.launch"><arg name="r" value="$(arg sim)"/></include>',
            files={"i.launch": '<arg name="r"/><rosparam file="$(dirname)/$(arg r).yaml"/>'},
        ),
        [{}],
    ),
    "what an arg of the same name is compared with in another file is not meant": (
        case(
            '<arg name="kind" default="a"/><param name="k" value="$(arg kind)" unless="$(eval kind == \'b\')"/>'
            '<include file="$(dirname)/i.launch"/>',
            files={"i.launch": '<arg name="kind" default="p"/>[[n if="$(eval kind == \'q\')"]]'},
        ),
        [{}, {"kind": "b"}],
    ),
    "a boolean that is part of a path in the args of a node": (
        case(SIM + '[[n if="$(arg sim)"]]<node pkg="p" type="t" name="m" args="-f $(dirname)/maps/map_$(arg sim).yaml"/>'),
        [{}],
    ),
    "a boolean that the args of a node hold as it is": (
        case(SIM + '[[n if="$(arg sim)"]]<node pkg="p" type="t" name="m" args="--sim $(arg sim) sim:=$(arg sim)"/>'),
        [{}, {"sim": "true"}],
    ),
    "a number that is an identity": (
        case('<arg name="id" default="1"/>[[n$(arg id) if="$(eval id == 2)"]]'),
        [{}, {"id": "2"}],
    ),
}


@pytest.mark.parametrize(("each", "expected"), [pytest.param(*found, id=name) for name, found in FOUND.items()])
def test_found(each: Case, expected: list[dict[str, str]], tmp_path: Path) -> None:
    assert given_in(each, tmp_path) == expected


def test_what_people_give_stays_as_it_is(tmp_path: Path) -> None:
    each = case(SIM + GUI + '[[n if="$(arg sim)"]][[m if="$(arg gui)"]]')
    assert given_in(each, tmp_path, (("sim", "false"),)) == [{"sim": "false"}, {"sim": "false", "gui": "true"}]


def test_what_a_configuration_is_launched_with(tmp_path: Path) -> None:
    first, second = evaluations(case(SIM + '[[n if="$(arg sim)"]]'), tmp_path)
    assert [node.name for node in first.launch.nodes] == []
    assert [node.name for node in second.launch.nodes] == ["n"]
    assert second.launch.arguments == {"sim": "true"}
    assert [(branch.attribute, branch.text, branch.taken, branch.steered_by, branch.open) for branch in second.launch.branches] == [
        ("if", "$(arg sim)", True, frozenset({"sim"}), True)
    ]


@pytest.mark.parametrize(
    ("text", "steered_by", "is_open"),
    [
        (SIM + '[[n if="$(arg sim)"]]', {"sim"}, True),
        ('<arg name="sim" value="0"/>[[n if="$(arg sim)"]]', set(), False),
        (SIM + '<arg name="a" value="$(arg sim)"/><arg name="b" default="$(arg a)"/>[[n if="$(arg b)"]]', {"b", "sim"}, True),
        (SIM + '<arg name="a" value="$(arg sim)"/><arg name="b" value="$(arg a)"/>[[n if="$(arg b)"]]', {"sim"}, True),
        ('[[n if="0"]]', set(), False),
        ('[[n if="$(optenv X 0)"]]', set(), True),
        ('<arg name="a" value="$(optenv X 0)"/>[[n if="$(arg a)"]]', set(), True),
        (SIM + "[[n if=\"$(eval arg('sim'))\"]]", {"sim"}, True),
        (SIM + GUI + '[[n if="$(eval sim or gui)"]]', {"sim", "gui"}, True),
    ],
)
def test_what_steers_a_condition(text: str, steered_by: set[str], is_open: bool, tmp_path: Path) -> None:
    branch = evaluations(case(text), tmp_path)[0].launch.branches[-1]
    assert (set(branch.steered_by), branch.open) == (steered_by, is_open)


def test_the_number_of_evaluations_is_bounded(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    count = 0

    def counted(*arguments: object) -> Entered | Evaluation:
        nonlocal count
        count += 1
        return enter_entry(*arguments)  # type: ignore[arg-type]

    monkeypatch.setattr(room, "enter_entry", counted)
    args = "".join(f'<arg name="a{number}" default="false"/>[[n{number} if="$(arg a{number})"]]' for number in range(60))
    # Of the conditions that nothing can turn, each would be tried with several values.
    dead = "".join(f'[[m{number} if="$(eval a{number} and a{number + 1} and not a{number})"]]' for number in range(50))
    found = given_in(case(args + dead), tmp_path)
    assert count == MOST_EVALUATIONS
    assert found[:3] == [{}, {"a0": "true"}, {"a1": "true"}]


SAME = {
    "its default": ('<arg name="mode" default="a"/>', 1),
    "a default that is made": ('<arg name="all" default="a"/><arg name="mode" default="$(arg all)"/>', 1),
    "asked for above its declaration": ("""[[m if="$(eval mode == 'a')"]]<arg name="mode" default="a"/>""", 2),
    "declared under a condition": ('<arg name="on" value="true"/><arg name="mode" default="a" if="$(arg on)"/>', 2),
    "declared twice": ('<arg name="mode" default="a"/><group><arg name="mode" default="b"/></group>', 2),
    "passed on above its declaration": ('<include file="none.launch" pass_all_args="true"/><arg name="mode" default="a"/>', 2),
    "another value": ('<arg name="mode" default="b"/>', 2),
}


@pytest.mark.parametrize(("declared", "evaluated"), [pytest.param(*each, id=name) for name, each in SAME.items()])
def test_a_value_that_an_arg_has_anyway_is_not_evaluated(
    declared: str, evaluated: int, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    given: list[object] = []

    def counted(*arguments: object) -> Entered | Evaluation:
        given.append(arguments[2])
        return enter_entry(*arguments)  # type: ignore[arg-type]

    monkeypatch.setattr(room, "enter_entry", counted)
    given_in(case(declared + """[[n if="$(eval mode == 'a')"]]"""), tmp_path)
    assert [each for each in given if each in ((), (("mode", "a"),))] == [(), (("mode", "a"),)][:evaluated]


ARGS = ("p", "q", "r")


def condition(random: Random) -> str:
    """A condition over some of the args."""
    one, other = random.choice(ARGS), random.choice(ARGS)
    forms = ("$(arg {0})", "$(eval not {0})", "$(eval {0} and {1})", "$(eval {0} or {1})", "$(eval {0} and not {1})", "$(eval {0} == {1})")
    return f'{random.choice(("if", "unless"))}="{random.choice(forms).format(one, other)}"'


def tree(random: Random, depth: int = 0) -> str:
    """Groups and nodes under conditions, some inside others."""
    text = ""
    for number in range(random.randint(1, 3)):
        inner = tree(random, depth + 1) if depth < 2 and random.random() < 0.5 else f"[[n{depth}{number}]]"
        text += f"<group {condition(random)}>{inner}</group>"
    return text


def boolean_case(random: Random) -> Case:
    """A file with three boolean args and conditions over them."""
    return case("".join(f'<arg name="{name}" default="{random.choice(("true", "false"))}"/>' for name in ARGS) + tree(random))


def sides(found: Sequence[Evaluation]) -> set[tuple[int, bool | None]]:
    return {(branch.element.span.start, branch.taken) for evaluation in found for branch in evaluation.launch.branches}


@settings(max_examples=80, deadline=None, derandomize=True, suppress_health_check=[HealthCheck.too_slow])
@given(st.builds(boolean_case, st.randoms(use_true_random=False)))
def test_what_some_values_of_the_args_reach_is_reached(each: Case) -> None:
    with tempfile.TemporaryDirectory() as name, inside(Path(name)):
        directory = Path(name)
        found = evaluations(each, directory)
        session = session_in(directory)
        every = [
            evaluate(session, str(directory / MAIN), tuple(zip(ARGS, values, strict=True)))
            for values in product(("true", "false"), repeat=len(ARGS))
        ]
        assert sides(found) == sides(every)
        reached: set[tuple[int, bool | None]] = set()
        for evaluation in found:
            assert evaluation is found[0] or sides([evaluation]) - reached
            reached |= sides([evaluation])


@settings(max_examples=60, deadline=None, derandomize=True, suppress_health_check=[HealthCheck.too_slow])
@given(st.builds(boolean_case, st.randoms(use_true_random=False)))
def test_what_is_not_evaluated_would_have_shown_nothing(each: Case) -> None:
    with tempfile.TemporaryDirectory() as name, pytest.MonkeyPatch.context() as patched:
        found = given_in(each, Path(name))
        patched.setattr(ArgFlow, "has", lambda self, pairs: False)
        patched.setattr(ArgFlow, "telling", lambda self, given: given)
        assert given_in(each, Path(name)) == found
