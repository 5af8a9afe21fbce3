"""What a picture shows: what is reachable in it is what is reachable in the graph, and no more."""

from __future__ import annotations

import time

import pytest
from hypothesis import given
from hypothesis import strategies as st

from launchlint.graph.difference import difference
from launchlint.graph.topology import Topology
from launchlint.report.graph.drawing import Arrow, Box, Drawing, draw
from tests.graph import tiny

CHANNELS = ("topic", "service", "action")


def box_of(name: str, drawing: Drawing) -> str | None:
    """The box that stands for a node."""
    boxes = {box.id for box in drawing.boxes}
    candidates = [f"node {name}"]
    parts = name.split("/")[1:-1]
    candidates += [f"folded /{'/'.join(parts[:number])}" for number in range(1, len(parts) + 1)]
    return next((each for each in candidates if each in boxes), None)


def reached(drawing: Drawing) -> set[tuple[str, str, str]]:
    """From which box one gets to which, by what kind of channel: along one arrow, or two with a channel's box between them."""
    boxes = {box.id: box for box in drawing.boxes}
    direct = {(each.source, each.target, each.kind) for each in drawing.arrows if boxes[each.source].kind not in CHANNELS}
    found = {each for each in direct if boxes[each[1]].kind not in CHANNELS}
    for source, middle, kind in direct - found:
        found |= {(source, each.target, kind) for each in drawing.arrows if each.source == middle}
    return {each for each in found if each[0] != each[1]}


def wanted(topology: Topology, drawing: Drawing) -> set[tuple[str, str, str]]:
    """The same from the pairs of the graph."""
    found = set()
    for giver, kind, _, taker in tiny.pairs(topology):
        first, second = box_of(giver, drawing), box_of(taker, drawing)
        assert first, giver
        assert second, taker
        if first != second:
            found.add((first, second, kind) if kind == "topic" else (second, first, kind))
    return found


def is_one_configuration(topology: Topology) -> bool:
    return len(topology.configurations) == 1


@given(tiny.topologies().filter(is_one_configuration), st.sampled_from([None, 4, 8, 30]), st.booleans())
def test_drawn_reachability_is_that_of_the_graph(topology: Topology, most: int | None, dangling: bool) -> None:
    drawing = draw(topology, most, dangling=dangling)
    if "left out" not in drawing.left_out:
        assert reached(drawing) == wanted(topology, drawing)


@given(tiny.topologies(), st.sampled_from([None, 30]))
def test_of_several_configurations_nothing_that_meets_is_missing(topology: Topology, most: int | None) -> None:
    drawing = draw(topology, most)
    assert wanted(topology, drawing) <= reached(drawing)


@given(tiny.topologies(), st.integers(1, 40), st.booleans())
def test_a_picture_is_never_too_large_and_always_whole(topology: Topology, most: int, dangling: bool) -> None:
    drawing = draw(topology, most, dangling=dangling)
    ids = [box.id for box in drawing.boxes]
    assert len(drawing.arrows) <= most
    assert len(ids) <= most
    assert len(set(ids)) == len(ids)
    assert {end for each in drawing.arrows for end in (each.source, each.target)} <= set(ids)
    parents = {box.parent for box in drawing.boxes} - {""}
    assert parents <= {box.id for box in drawing.boxes if box.kind == "namespace"}
    assert "1 nodes" not in drawing.left_out


@given(tiny.topologies(), tiny.topologies(), st.sampled_from([None, 12]))
def test_of_two_topologies_what_changed_is_there(before: Topology, after: Topology, most: int | None) -> None:
    found = difference(before, after)
    drawing = draw(after, most, found)
    gone, come = tiny.pairs(before) - tiny.pairs(after), tiny.pairs(after) - tiny.pairs(before)
    if most is None:
        names = {end for giver, _, _, taker in gone | come for end in (giver, taker)}
        changed = {each.node for each in (*found.connections_added, *found.connections_removed)}
        assert all(box_of(name, drawing) for name in changed)
        if is_one_configuration(before) and is_one_configuration(after):
            assert all(box_of(name, drawing) for name in names)
    assert {each.mark for each in drawing.arrows} <= {"", "added", "removed"}


def test_one_publisher_and_two_subscribers_are_two_arrows() -> None:
    assert draw(tiny.topology("/a > /x", "/b < /x", "/c < /x")).arrows == (
        Arrow("node /a", "node /b", "topic", ("/x",)),
        Arrow("node /a", "node /c", "topic", ("/x",)),
    )


def test_many_to_many_is_a_box_of_its_own_in_the_namespace_of_all() -> None:
    drawing = draw(tiny.topology("/r/a > /x", "/r/b > /x", "/r/c < /x", "/r/d < /x"))
    assert [box for box in drawing.boxes if box.kind == "topic"] == [Box("topic /x", "namespace /r", "topic", "/x", "")]
    assert [(each.source, each.target, each.labels) for each in drawing.arrows] == [
        ("node /r/a", "topic /x", ()),
        ("node /r/b", "topic /x", ()),
        ("topic /x", "node /r/c", ()),
        ("topic /x", "node /r/d", ()),
    ]


def test_services_point_from_client_to_server() -> None:
    assert [(each.source, each.target, each.kind) for each in draw(tiny.topology("/a serves /s", "/b calls /s")).arrows] == [
        ("node /b", "node /a", "service")
    ]


@pytest.mark.parametrize(("count", "shown"), [(1, ("/x0",)), (2, ("/x0", "/x1")), (3, ("3 topics",))])
def test_names_between_the_same_two_are_one_arrow(count: int, shown: tuple[str, ...]) -> None:
    facts = [fact for number in range(count) for fact in (f"/a > /x{number}", f"/b < /x{number}")]
    (arrow,) = draw(tiny.topology(*facts)).arrows
    assert arrow.shown == shown


def test_what_may_not_be_there_is_conditional() -> None:
    drawing = draw(tiny.topology("/a > /x?", "/b < /x", "/c > /y @sim:=true", "/d < /y", configurations=("", "sim:=true")))
    assert [(each.source, each.conditional) for each in drawing.arrows] == [("node /a", True), ("node /c", True)]


def test_who_never_runs_together_is_not_connected() -> None:
    assert draw(tiny.topology("/a > /x @-", "/b < /x @sim:=true", configurations=("", "sim:=true"))).arrows == ()


def test_dangling_names_are_shown_where_asked_for() -> None:
    topology = tiny.topology("/a > /x", "/b calls /s")
    assert draw(topology).arrows == ()
    assert [(each.source, each.target) for each in draw(topology, dangling=True).arrows] == [
        ("node /a", "topic /x"),
        ("node /b", "service /s"),
    ]


def test_a_namespace_with_nothing_but_another_one_is_one_box_with_it() -> None:
    drawing = draw(tiny.topology("/a/b/c/m > /x", "/a/b/c/n < /x", "/a/b/d/o < /x"))
    assert [(box.id, box.parent, box.label) for box in drawing.boxes if box.kind == "namespace"] == [
        ("namespace /a/b", "", "/a/b"),
        ("namespace /a/b/c", "namespace /a/b", "c"),
        ("namespace /a/b/d", "namespace /a/b", "d"),
    ]


def test_small_namespaces_are_opened_before_large_ones() -> None:
    facts = ["/small/a > /x", *(f"/large/b{number} < /x" for number in range(20))]
    drawing = draw(tiny.topology(*facts), 10)
    assert [(box.id, box.members) for box in drawing.boxes] == [("folded /large", 20), ("namespace /small", 0), ("node /small/a", 0)]
    assert drawing.left_out == "20 nodes are folded into their namespaces"
    assert drawing.arrows == (Arrow("node /small/a", "folded /large", "topic", ("/x",)),)


def test_nodes_without_connections_are_gathered() -> None:
    nodes = [tiny.node(f"/n{number}", knowledge="unknown" if number else "known") for number in range(5)]
    drawing = draw(tiny.topology("/a > /x", "/b < /x", nodes=nodes), 50)
    assert [(box.kind, box.label, box.detail) for box in drawing.boxes] == [
        ("node", "a", "demo/node"),
        ("node", "b", "demo/node"),
        ("others", "5 nodes without known connections", "4 of them unknown"),
    ]
    assert len(draw(tiny.topology("/a > /x", "/b < /x", nodes=nodes)).boxes) == 7


def test_what_does_not_fit_is_left_out_and_said() -> None:
    drawing = draw(tiny.topology("/hub > /x", *(f"/n{number} < /x" for number in range(50))), 10)
    assert (len(drawing.arrows), len(drawing.boxes), drawing.left_out) == (9, 10, "41 arrows and 41 boxes are left out")


def test_a_change_shows_old_and_new_and_nothing_else() -> None:
    before = tiny.topology("/a > out=/x", "/b < /x", "/c > /other", "/d < /other")
    after = tiny.topology("/a > out=/y", "/b < /x", "/c > /other", "/d < /other", "/e > /new")
    drawing = draw(after, None, difference(before, after))
    assert [(box.id, box.mark) for box in drawing.boxes] == [("node /a", ""), ("node /b", ""), ("node /e", "added"), ("topic /y", "added")]
    assert [(each.source, each.target, each.labels, each.mark) for each in drawing.arrows] == [
        ("node /a", "node /b", ("/x",), "removed"),
        ("node /a", "topic /y", (), "added"),
    ]
    assert drawing.left_out == "2 nodes did not change and are not shown"


def test_those_who_went_and_those_who_came_were_never_connected() -> None:
    """/old published /x, /new subscribes it now: there was never an arrow between them."""
    before, after = tiny.topology("/old > /x", "/c < /x"), tiny.topology("/new < /x", "/c < /x")
    drawing = draw(after, None, difference(before, after))
    assert [(each.source, each.target, each.mark) for each in drawing.arrows] == [("node /old", "node /c", "removed")]
    assert [(box.id, box.mark) for box in drawing.boxes] == [("node /c", ""), ("node /new", "added"), ("node /old", "removed")]


def test_a_deep_tree_and_a_hub_are_drawn_in_linear_time() -> None:
    deep = "".join(f"/n{number}" for number in range(1000))
    nodes = [*(f"{deep}/p{number} > /x" for number in range(1500)), *(f"{deep}/s{number} < /x" for number in range(1500))]
    levels = [f"{'/'.join(deep.split('/')[: number + 2])}/m > /y" for number in range(0, 1000, 5)]
    topology = tiny.topology(*nodes, *levels)
    started = time.process_time()
    for most in (None, 120, 10):
        draw(topology, most)
    assert time.process_time() - started < 5
