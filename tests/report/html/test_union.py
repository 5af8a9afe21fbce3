"""Two states of one launch file as one."""

from __future__ import annotations

from typing import Any

from launchlint.graph.topology import Container, TopologyParam
from launchlint.report.html.union import Union, alone, united
from tests.graph import tiny


def marks(marked: Any) -> list[tuple[str, str]]:
    """Names with their marks; what has gone has its places in the former state."""
    for each in marked:
        assert each.base == (each.mark == "removed")
    return [(each.item.name, each.mark) for each in marked]


def told(union: Union) -> list[tuple[str, str, str]]:
    return [(each.item.node, each.item.name, each.mark) for each in union.connections]


def test_one_state_has_no_marks() -> None:
    union = alone(tiny.topology("/a > /x", "/b < /x"))
    assert marks(union.nodes) == [("/a", ""), ("/b", "")]
    assert marks(union.channels) == [("/x", "")]
    assert told(union) == [("/a", "/x", ""), ("/b", "/x", "")]


def test_two_states() -> None:
    before = tiny.topology("/a > x=/x", "/b < x=/x", "/gone > /z")
    after = tiny.topology("/a > x=/x", "/b < x=/y", "/new > /y", nodes=[tiny.node("/a", "demo/other")])
    union = united(before, after)
    assert marks(union.nodes) == [("/a", "changed"), ("/b", ""), ("/new", "added"), ("/gone", "removed")]
    assert marks(union.channels) == [("/x", ""), ("/y", "added"), ("/z", "removed")]
    assert told(union) == [
        ("/a", "/x", ""),
        ("/b", "/y", "changed"),
        ("/new", "/y", "added"),
        ("/gone", "/z", "removed"),
        ("/b", "/x", "removed"),
    ]


def test_a_file_that_is_new_and_one_that_has_gone() -> None:
    topology = tiny.topology("/a > /x", configurations=("", "sim:=true"))
    assert marks(united(None, topology).nodes) == [("/a", "added")]
    assert marks(united(topology, None).nodes) == [("/a", "removed")]
    assert united(topology, None).configurations == ("", "sim:=true")


def test_configurations_of_both_states() -> None:
    before, after = tiny.topology("/a > /x", configurations=("", "old:=1")), tiny.topology("/a > /x", configurations=("", "new:=1"))
    assert united(before, after).configurations == ("", "new:=1", "old:=1")


def test_params_go_by_name_and_value() -> None:
    def params(**values: str) -> Any:
        return tiny.topology("/a > /x")._replace(
            params=tuple(TopologyParam(f"/{name}", value, "", (), ()) for name, value in values.items())
        )

    union = united(params(same="1", other="1", gone="1"), params(same="1", other="2", new="1"))
    assert marks(union.params) == [("/same", ""), ("/other", "changed"), ("/new", "added"), ("/gone", "removed")]


def test_of_values_that_are_cut_what_is_left_counts() -> None:
    def value(text: str) -> Any:
        return tiny.topology("/a > /x")._replace(params=(TopologyParam("/p", text, "", (), ()),))

    assert marks(united(value("abcd…"), value("abcdef…")).params) == [("/p", "")]
    assert marks(united(value("abcd…"), value("abXdef…")).params) == [("/p", "changed")]
    assert marks(united(value("abcd"), value("abcdef")).params) == [("/p", "changed")]


def test_containers_are_the_same_whatever_line_they_stand_in() -> None:
    def containers(line: int, *inner: str) -> list[Container]:
        outer = Container(f"f:{line}:1", "group", "/r", "/r", f"f:{line}:1", "")
        return [outer, *(Container(f"f:{line}:1 > {name}", "group", name, f"/r{name}", f"f:{line}:9", outer.id) for name in inner)]

    before = tiny.topology("/a > /x", containers=containers(3, "/old", "/both"))
    after = tiny.topology("/a > /x", "/n > /x", containers=containers(7, "/both"))
    union = united(before, after)
    seen = {id(each): each for each in union.containers.values()}.values()
    assert [(each.item.label, each.mark, union.containers[each.item.parent].item.label if each.item.parent else "") for each in seen] == [
        ("/r", "", ""),
        ("/both", "", "/r"),
        ("/old", "removed", "/r"),
    ]
    assert union.containers["base f:3:1"] is union.containers["f:7:1"]
    assert union.containers["base f:3:1 > /both"] is union.containers["f:7:1 > /both"]
