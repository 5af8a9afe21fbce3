"""What is told of params and remaps that launch passes on without a word."""

from __future__ import annotations

from typing import Any

import pytest

from launchlint.evaluate.ros2.component_parameters import component_parameters
from launchlint.evaluate.ros2.judged_keys import Receiver, for_nobody, judged_component
from launchlint.evaluate.ros2.judged_parameters import judged
from launchlint.evaluate.ros2.parameter_problems import (
    ComponentKeyIgnored,
    LaterValueLost,
    ListBecomesText,
    NamedForUnnamed,
    NumberStaysText,
    ParameterDies,
    ParametersFileDies,
    ParametersForNobody,
    RemapDies,
    SetParameterDies,
    TextRetyped,
)
from launchlint.evaluate.ros2.parameters import Passed, node_parameters, set_parameter
from launchlint.evaluate.ros2.started import started
from launchlint.model import Remap
from launchlint.problem import Problem
from launchlint.source import Origin
from launchlint.syntax.ros2.description import ParameterSource, SetParameter, TypedValue
from tests.evaluate.ros2.asked import NOWHERE, Asked, file, param, plain, text, var


def told(
    asks: Asked, *own: ParameterSource, values: dict[str, str] | None = None, remaps: tuple[tuple[str, str], ...] = ()
) -> list[Problem]:
    """What is told of a node n with these params, behind a <set_parameter> for each of the values."""
    in_force = [set_parameter(SetParameter(text(name), TypedValue(text(value)), NOWHERE), asks) for name, value in (values or {}).items()]
    passed = node_parameters(own, in_force, None, asks)
    begun = started((), None, "n", None, passed, remaps, asks)
    return list(judged(passed, [Remap(*each, Origin(NOWHERE)) for each in remaps], begun, "/n", asks))


def facts(problems: list[Problem]) -> list[tuple[Any, ...]]:
    """Kind and fields, without places."""
    hidden = ("origin", "related", "refused", "assumed")
    return [(type(each), *(value for name, value in vars(each).items() if name not in hidden)) for each in problems]


def lines(problems: list[Problem]) -> list[str]:
    """Where the problems stand: the path and what is written there."""
    return [f"{each.place.source.path}: {each.place.text}" for each in problems]


def test_what_rcl_reads_as_something_else_is_told_where_a_text_is_meant() -> None:
    given = (
        param("axis", "y", type_="str"),
        param("number", var("q"), type_="str"),
        param("quoted", "5", type_="str"),
        param("exponent", "1e3"),
        plain("word", "abc"),
    )
    assert facts(told(Asked({"q": "1e3"}), *given)) == [
        (TextRetyped, "axis", "y", "bool", False),
        (TextRetyped, "number", "1e3", "double", False),
    ]


def test_a_list_of_texts_one_of_which_is_none_to_rcl_kills_the_node() -> None:
    (found,) = facts(told(Asked(), param("axes", "[x, y]")))
    assert (found[0], found[2]) == (ParameterDies, "/n")


def test_what_set_parameter_does_to_values() -> None:
    assert facts(told(Asked(), values={"list": "[1, 2]", "empty": "", "letter": "n", "bad-name": "1", "fine": "1e3", "number": "5"})) == [
        (ListBecomesText, "list", "(1, 2)"),
        (SetParameterDies, "empty", "", True, "the value is empty"),
        (TextRetyped, "letter", "n", "bool", True),
        (SetParameterDies, "bad-name", "1", False, "a parameter's name cannot hold '-' here"),
    ]


@pytest.mark.parametrize(
    ("source", "target", "side"),
    [("a-b", "c", "from"), ("a/", "c", "from"), ("", "c", "from"), ("a", "", "to"), ("a", "b-c", "to"), ("a", "b:=c", "to")],
)
def test_the_side_of_a_remap_that_kills_the_node(source: str, target: str, side: str) -> None:
    ((kind, *found, _, node),) = facts(told(Asked(), remaps=((source, target),)))
    assert (kind, found, node) == (RemapDies, [source, target, side], "/n")


def test_every_bad_remap_is_told_although_rcl_stops_at_the_first() -> None:
    assert len(told(Asked(), remaps=(("a-b", "c"), ("fine", "x"), ("d", "")))) == 2


def test_a_file_that_rcl_refuses_is_told_at_its_place() -> None:
    asks = Asked(files={"p.yaml": "n:\n  ros__parameters: {a: [1, b]}\n"})
    (problem,) = told(asks, file("/w/p.yaml"))
    assert isinstance(problem, ParametersFileDies)
    assert (problem.place.source.path, problem.place.text, problem.file, problem.node) == ("p.yaml", "b", "p.yaml", "/n")


def test_a_file_that_is_no_utf_8_is_refused() -> None:
    asks = Asked()
    asks.session.overlay["/w/p.yaml"] = b"n:\n  ros__parameters: {a: \xe4}\n"
    (problem,) = told(asks, file("/w/p.yaml"))
    assert isinstance(problem, ParametersFileDies)
    assert (problem.reason, problem.place.span.start) == ("it is not UTF-8 text (byte 26)", 26)


def test_an_exact_key_loses_against_a_later_wildcard() -> None:
    asks = Asked(files={"p.yaml": "n:\n  ros__parameters: {a: 1, b: 5}\n/**:\n  ros__parameters: {a: 2, b: 5}\n"})
    problems = told(asks, file("/w/p.yaml"))
    assert facts(problems) == [(LaterValueLost, "a", "/n", "1", "2", "n", "/**", False)]
    assert lines(problems) == ["p.yaml: 1"]


def test_a_param_of_the_launch_file_loses_against_a_key_that_came_after_the_wildcard() -> None:
    asks = Asked(files={"p.yaml": "/**:\n  ros__parameters: {x: 1}\nn:\n  ros__parameters: {a: 1}\n"})
    assert facts(told(asks, file("/w/p.yaml"), plain("a", 9))) == [(LaterValueLost, "a", "/n", "9", "1", "/**", "n", True)]


def test_what_is_set_for_all_nodes_may_be_overridden_and_a_later_file_may_win() -> None:
    asks = Asked(files={"one.yaml": "n:\n  ros__parameters: {a: 1}\n", "all.yaml": "/**:\n  ros__parameters: {a: 2}\n"})
    assert told(asks, file("/w/one.yaml"), values={"a": "9"}) == []
    assert told(asks, file("/w/one.yaml"), file("/w/all.yaml")) == []


def nobody(asks: Asked, *nodes: tuple[str | None, str]) -> list[tuple[Any, ...]]:
    """What is told of nodes with a file each: the node, the key, why it is thought to be meant."""
    receivers = [Receiver(name, False, tuple(node_parameters((file(path),), (), None, asks))) for name, path in nodes]
    found = [each for each in for_nobody(receivers, asks) if not isinstance(each, NamedForUnnamed)]
    assert all(isinstance(each, ParametersForNobody) for each in found)
    return [(getattr(each, "node", ""), getattr(each, "key", ""), getattr(each, "near", "")) for each in found]


def test_keys_that_reach_nobody() -> None:
    asks = Asked(
        files={
            "bare.yaml": "n:\n  ros__parameters: {a: 1}\n/**:\n  ros__parameters: {b: 1}\n",
            "typo.yaml": "controler:\n  ros__parameters: {a: 1}\n",
            "other.yaml": "lidar:\n  ros__parameters: {a: 1}\n",
            "all.yaml": "/**:\n  ros__parameters: {a: 1}\n",
            "empty.yaml": "",
        }
    )
    assert nobody(asks, ("/s/n", "/w/bare.yaml")) == [("/s/n", "n", "namespace")]
    assert nobody(asks, ("/n", "/w/bare.yaml")) == []
    assert nobody(asks, ("/s/n", "/w/bare.yaml"), ("/n", "/w/all.yaml")) == []
    assert nobody(asks, ("/controller", "/w/typo.yaml")) == [("/controller", "controler", "spelling")]
    assert nobody(asks, ("/controller", "/w/typo.yaml"), ("/s/controler", "/w/all.yaml")) == [("/controller", "", "")]
    assert nobody(asks, ("/n", "/w/other.yaml")) == [("/n", "", "")]
    assert nobody(asks, ("/n", "/w/all.yaml"), ("/n", "/w/empty.yaml"), (None, "/w/other.yaml")) == []
    assert nobody(asks, ("/s/n", "/w/bare.yaml"), (None, "/w/bare.yaml")) == []


def unnamed(asks: Asked, path: str, *, namespace: str = "/", anonymous: bool = False) -> list[tuple[bool, bool]]:
    """What is told of a node that the launch gives no name to: whether it is made up, and whether nothing can reach it."""
    given = tuple(node_parameters((file(path),), (), None, asks))
    name = "/talker_anon1" if anonymous else None
    other = Receiver("/listener", False, tuple(node_parameters((file("/w/all.yaml"),), (), None, asks)))
    found = for_nobody([Receiver(name, False, given, anonymous=anonymous, program="talker", namespace=namespace), other], asks)
    return [(each.anonymous, each.certain) for each in found if isinstance(each, NamedForUnnamed)]


def test_named_params_for_a_node_whose_name_the_launch_does_not_say() -> None:
    asks = Asked(
        files={
            "bare.yaml": "talker:\n  ros__parameters: {a: 1}\n",
            "front.yaml": "/front/talker:\n  ros__parameters: {a: 1}\n",
            "any.yaml": "/**/talker:\n  ros__parameters: {a: 1}\n",
            "two.yaml": "talker:\n  ros__parameters: {a: 1}\nlistener:\n  ros__parameters: {a: 1}\n",
            "all.yaml": "/**:\n  ros__parameters: {a: 1}\n",
        }
    )
    assert unnamed(asks, "/w/bare.yaml") == [(False, False)]
    assert unnamed(asks, "/w/bare.yaml", namespace="/front/") == [(False, True)]
    assert unnamed(asks, "/w/front.yaml", namespace="/front/") == [(False, False)]
    assert unnamed(asks, "/w/front.yaml") == [(False, True)]
    assert unnamed(asks, "/w/bare.yaml", anonymous=True) == [(True, False)]
    assert unnamed(asks, "/w/any.yaml", namespace="/front/") == []
    assert unnamed(asks, "/w/two.yaml", anonymous=True) == []


def component(asks: Asked, *own: ParameterSource) -> list[Problem]:
    passed: list[Passed] = []
    component_parameters(own, (), "n", "/s", asks, passed)
    return list(judged_component(passed, "/s/n", asks))


def test_keys_with_wildcards_say_nothing_to_a_composable_node() -> None:
    asks = Asked(files={"p.yaml": "/**/n:\n  ros__parameters: {a: 1}\n/*/m:\n  ros__parameters: {a: 1}\n/**:\n  ros__parameters: {b: 1}\n"})
    problems = component(asks, file("/w/p.yaml"))
    assert facts(problems) == [(ComponentKeyIgnored, "/w/p.yaml", "/**/n", "/s/n")]
    assert lines(problems) == ["p.yaml: /**/n"]


def test_numbers_that_stay_texts_for_a_composable_node() -> None:
    asks = Asked(files={"p.yaml": "/**:\n  ros__parameters: {a: 1e-3, b: 1.0e-3, c: y, d: '1e3'}\n"})
    problems = component(asks, file("/w/p.yaml"), param("e", "1e3"), param("f", "1e3", type_="str"))
    assert facts(problems) == [(NumberStaysText, "a", "1e-3", True), (NumberStaysText, "e", "1e3", False)]
