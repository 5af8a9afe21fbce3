"""What launch makes of the params of a node, and what the node ends up with."""

from __future__ import annotations

from typing import Any

import pytest

from launchlint.evaluate.problems import ParamFileMissing
from launchlint.evaluate.ros2.component_parameters import component_parameters, extra_arguments
from launchlint.evaluate.ros2.parameters import GlobalFile, GlobalParameter, Passed, node_parameters, set_parameter
from launchlint.evaluate.ros2.started import started
from launchlint.model import Unknown
from launchlint.source import Origin, Place, Source, Span
from launchlint.syntax.ros2.description import Parameter, ParameterSource, SetParameter, TypedValue
from tests.evaluate.ros2.asked import NOWHERE, Asked, Stopped, file, param, plain, text, var

HERE = Origin(NOWHERE)
EXACT = "n:\n  ros__parameters: {a: 1, b: 1}\n"
ANY = "/**:\n  ros__parameters: {a: 2, c: 2}\n"


def contents(*given: ParameterSource, asks: Asked | None = None) -> list[Any]:
    return [each.content["/**"]["ros__parameters"] for each in node_parameters(given, (), None, asks or Asked())]


def starts(passed: list[Passed], asks: Asked, name: str | None = "n", namespace: str | None = None) -> dict[str, Any]:
    result = started((), None, name, namespace, passed, (), asks)
    assert result.refused is None, result.refused
    return {key: value.data for key, value in (result.parameters or {}).items()}


@pytest.mark.parametrize(
    ("value", "type_", "found"),
    [
        ("5", None, 5),
        ("5", "str", "5"),
        ("5", "float", 5.0),
        ("1", "bool", True),
        ("yes", "bool", True),
        ("1e3", None, "1e3"),
        ("", None, ""),
        ("[1, 2]", None, [1, 2]),
        ("[]", None, []),
        ("[a, b]", "list_of_str", ["a", "b"]),
        ("a b", None, "a b"),
        ("'5'", None, "5"),
    ],
)
def test_a_computed_value_is_typed_when_it_is_performed(value: str, type_: str | None, found: Any) -> None:
    assert contents(param("v", var("q"), type_=type_), asks=Asked({"q": value})) == [{"v": found}]


@pytest.mark.parametrize(
    ("value", "type_", "reason"),
    [
        ("null", None, "YAML reads it as null, and that is no value of a parameter"),
        ("a: b", None, "YAML reads it as a mapping, and that is no value of a parameter"),
        ("2020-01-01", None, "YAML reads it as a date, and that is no value of a parameter"),
        ("[1, 2.0]", None, "the items of a list must all be of one type"),
        ("x", "int", "'x' is not a whole number, and type is int"),
        ("2", "bool", "YAML reads it as a whole number, and type is bool"),
        ("[1, a]", "list_of_int", "the items of a list must all be of one type"),
        ("{", None, "it is no YAML: "),
    ],
)
def test_a_computed_value_may_be_refused(value: str, type_: str | None, reason: str) -> None:
    with pytest.raises(Stopped) as stopped:
        contents(param("v", var("q"), type_=type_), asks=Asked({"q": value}))
    assert reason in getattr(stopped.value.problem, "reason", "")


def test_what_the_front_end_knows_is_not_read_again() -> None:
    assert contents(plain("v", "5")) == [{"v": "5"}]


def test_params_in_params_are_joined_and_each_outer_one_is_a_file_of_its_own() -> None:
    nested = Parameter(text("a"), None, (plain("b", 1), Parameter(text("c"), None, (plain("d", "x"),), NOWHERE)), NOWHERE)
    assert contents(nested, plain("e", True)) == [{"a.b": 1, "a.c.d": "x"}, {"e": True}]


def test_lists_are_known_item_by_item() -> None:
    asks = Asked({"q": "5"})
    some = TypedValue((text(var("q")), text("6")), None, (None, 6))
    assert contents(Parameter(text("v"), some, (), NOWHERE), asks=asks) == [{"v": [5, 6]}]
    mixed = TypedValue((text(var("q")), text("b")), None, (None, "b"))
    with pytest.raises(Stopped):
        contents(Parameter(text("v"), mixed, (), NOWHERE), asks=asks)


def test_what_is_written_stands_under_the_full_name_if_launch_knows_it() -> None:
    (given,) = node_parameters((plain("v", 1),), (), "/s/n", Asked())
    assert given.content == {"/s/n": {"ros__parameters": {"v": 1}}}


def test_a_text_that_yaml_takes_for_a_text_is_written_without_quotes_and_rcl_reads_it_again() -> None:
    asks = Asked()
    given = [plain("a", "1e3"), plain("b", "y"), plain("c", "5"), plain("d", "inf"), plain("e", "0o10"), plain("f", "x: y")]
    assert starts(node_parameters(given, (), None, asks), asks) == {
        "a": 1000.0,
        "b": True,
        "c": "5",
        "d": float("inf"),
        "e": "0o10",
        "f": "x: y",
    }


def test_files_in_order_and_a_missing_one_is_left_out() -> None:
    asks = Asked(files={"exact.yaml": EXACT, "any.yaml": ANY})
    passed = node_parameters((file("/w/exact.yaml"), file("/w/none.yaml"), file("any.yaml"), file("/w//any.yaml")), (), None, asks)
    assert [each.file for each in passed] == ["/w/exact.yaml", "/w/any.yaml"]
    assert [(type(each), getattr(each, "file", "")) for each in asks.noticed] == [
        (ParamFileMissing, "/w/none.yaml"),
        (ParamFileMissing, "any.yaml"),
    ]
    assert starts(passed, asks) == {"a": 2, "b": 1, "c": 2}


def test_substitutions_in_a_file_are_performed_where_that_is_asked_for() -> None:
    asks = Asked({"q": "5"}, {"p.yaml": 'n:\n  ros__parameters: {a: $(var q), b: "$(var q)"}\n'})
    passed = node_parameters((file("/w/p.yaml", True),), (), None, asks)
    assert [(each.content, each.of) for each in passed] == [({"n": {"ros__parameters": {"a": 5, "b": "5"}}}, "/w/p.yaml")]
    assert starts(passed, asks) == {"a": 5, "b": "5"}
    with pytest.raises(Stopped):
        node_parameters((file("/w/none.yaml", True),), (), None, asks)


def test_the_same_text_is_read_once_and_each_node_knows_who_gave_it() -> None:
    asks = Asked({"q": "5"}, {"p.yaml": "n:\n  ros__parameters: {a: $(var q)}\n"})
    here, there = (Origin(Place(Source(name, name), Span(0, 1))) for name in "ab")

    def origins(*given: Origin) -> list[Origin | None]:
        passed = [node_parameters((file("/w/p.yaml", True),), (), None, asks)[0]._replace(origin=each) for each in given]
        begun = started((), None, "n", None, passed, (), asks)
        assert begun.parameters is not None
        return [value.origin for value in begun.parameters.values()]

    assert [origins(here), origins(there), origins(here, there), origins(there, here)] == [[here], [there], [there], [here]]
    assert len(asks.session.by_text) == 2, "what PyYAML makes of it, and what rcl does"


def test_params_that_are_set_for_all_nodes_come_first_and_lists_become_texts() -> None:
    asks = Asked({"q": "[1, 2]", "e": ""})
    one = set_parameter(SetParameter(text("l"), TypedValue(text(var("q"))), NOWHERE), asks)
    passed = node_parameters((plain("l2", 1),), (one, GlobalParameter("a", "True", True, HERE)), None, asks)
    assert [each.rule for each in passed] == ["l:=(1, 2)", "a:=True", None]
    assert starts(passed, asks) == {"l": "(1, 2)", "a": True, "l2": 1}
    empty = set_parameter(SetParameter(text("v"), TypedValue(text(var("e"))), NOWHERE), asks)
    refused = started((), None, "n", None, node_parameters((), (empty,), None, asks), (), asks).refused
    assert refused is not None
    assert refused.reason == "the value is empty"


def test_an_unknown_value_is_no_problem_and_what_the_node_has_is_not_known() -> None:
    asks = Asked()
    (given,) = node_parameters((param("v", var("q")),), (), None, asks)
    assert isinstance(given.content["/**"]["ros__parameters"]["v"], Unknown)
    found = started((), None, "n", None, [given], (), asks).parameters
    assert found is not None
    assert isinstance(found["v"][1], Unknown)


def test_a_node_that_rcl_refuses() -> None:
    result = started((), None, "n", None, [], [("a-b", "c")], Asked())
    assert result.refused is not None
    assert result.refused.reason == "a name cannot hold '-'"


def test_without_a_name_from_launch_params_for_all_are_known_and_others_under_a_name() -> None:
    asks = Asked()
    everybody = started((), None, None, None, node_parameters((plain("v", 1),), (), None, asks), (), asks)
    assert (starts_with(everybody.parameters), everybody.refused) == ({"v": 1}, None)
    asks = Asked(files={"p.yaml": "/n:\n  ros__parameters: {a: 5}\n"})
    somebody = started((), None, None, None, node_parameters((file("/w/p.yaml"),), (), None, asks), (), asks)
    assert somebody.parameters is None
    assert somebody.called is not None
    assert [starts_with(somebody.called(name)) for name in ("/n", "/other")] == [{"a": 5}, {}]


def starts_with(parameters: Any) -> dict[str, Any]:
    return {name: value.data for name, value in parameters.items()}


def components(*given: ParameterSource, asks: Asked, name: str = "n", namespace: str | None = None) -> dict[str, Any]:
    found, complete = component_parameters(given, (), name, namespace, asks)
    assert complete
    return dict(found)


def test_composable_nodes_get_values_as_yaml_reads_them() -> None:
    asks = Asked(files={"p.yaml": "/**:\n  ros__parameters: {a: 1e3, b: [1, 2.0], c: {d: y}}\n"})
    assert components(file("/w/p.yaml"), plain("e", "1e3"), asks=asks) == {
        "a": ("str", "1e3"),
        "b": ("double[]", [1.0, 2.0]),
        "c.d": ("str", "y"),
        "e": ("str", "1e3"),
    }


@pytest.mark.parametrize(
    ("key", "reached"),
    [("/**", True), ("/s/n", True), ("s/n", True), ("n", False), ("/n", False), ("/*/n", False), ("/**/n", False), ("/s/*", False)],
)
def test_which_keys_count_for_a_composable_node(key: str, reached: bool) -> None:
    asks = Asked(files={"p.yaml": f'"{key}":\n  ros__parameters: {{a: 1}}\n'})
    assert bool(components(file("/w/p.yaml"), asks=asks, namespace="/s")) == reached


def test_without_ros__parameters_the_whole_file_counts_for_a_composable_node() -> None:
    assert components(file("/w/p.yaml"), asks=Asked(files={"p.yaml": "x:\n  y: 1\n"})) == {"x.y": ("int", 1)}


@pytest.mark.parametrize(
    "text_of_file",
    ["", "- a\n", "n:\n  ros__parameters: {a: }\n", "n:\n  ros__parameters: {a: []}\n", "n:\n  ros__parameters: {a: [1, b]}\n", "n: {"],
)
def test_files_that_launch_refuses_for_composable_nodes(text_of_file: str) -> None:
    with pytest.raises(Stopped):
        components(file("/w/p.yaml"), asks=Asked(files={"p.yaml": text_of_file}))


def test_what_is_set_for_all_nodes_reaches_composable_nodes_with_its_type() -> None:
    asks = Asked(files={"any.yaml": ANY})
    in_force = (GlobalParameter("l", "(1, 2)", (1, 2), HERE), GlobalFile("/w/any.yaml", HERE))
    assert component_parameters((), in_force, "n", None, asks) == ({"l": ("int[]", [1, 2]), "a": ("int", 2), "c": ("int", 2)}, True)


def test_extra_arguments_are_typed() -> None:
    assert extra_arguments((param("use_intra_process_comms", "true"),), Asked()) == {"use_intra_process_comms": ("bool", True)}
