"""What changed between two topologies, and who has lost whom."""

from __future__ import annotations

import pytest
from hypothesis import given

from launchlint.graph.difference import Difference, Link, difference, moved
from launchlint.graph.topology import Connection, Topology
from launchlint.verdict import LOADS, Refusal, Verdict
from tests.graph import tiny

CONFIGURATIONS = ("", "sim:=true")


def lost(found: Difference) -> list[str]:
    """The lost links in short."""
    return [_short(link) for link in found.lost]


def _short(link: Link) -> str:
    now = "gone" if link.after is None else link.after.name
    default = " by default" if link.by_default else ""
    return f"{link.node} {link.role} {link.name} of {' '.join(link.partners)} ({link.total}){default}, now {now}"


def mirrored(link: Link) -> Link:
    return link._replace(before=link.after, after=link.before)


@given(tiny.topologies())
def test_nothing_changes_from_a_topology_to_itself(topology: Topology) -> None:
    assert difference(topology, topology).is_empty


@given(tiny.topologies(), tiny.topologies())
def test_the_way_back_is_the_mirror(before: Topology, after: Topology) -> None:
    there, back = difference(before, after), difference(after, before)
    assert there.nodes_added == back.nodes_removed
    assert there.channels_added == back.channels_removed
    assert there.connections_added == back.connections_removed
    assert set(there.connections_changed) == {(old, new) for new, old in back.connections_changed}
    assert set(there.nodes_changed) == {(old, new) for new, old in back.nodes_changed}
    assert [mirrored(link) for link in there.lost] == list(back.gained)
    assert [mirrored(link) for link in there.gained] == list(back.lost)


@given(tiny.topologies(), tiny.topologies())
def test_changes_lead_from_one_to_the_other(before: Topology, after: Topology) -> None:
    """What is added and what a change leads to is in the new graph and not in the old one, and the other way round."""
    found = difference(before, after)

    def names(connections: tuple[Connection, ...]) -> set[tuple[str, str, str]]:
        return {(each.node, each.role, each.name) for each in connections}

    old, new = names(before.connections), names(after.connections)
    came = names((*found.connections_added, *(pair.after for pair in found.connections_changed)))
    went = names((*found.connections_removed, *(pair.before for pair in found.connections_changed)))
    assert new - old <= came <= new
    assert old - new <= went <= old


@given(tiny.topologies(), tiny.topologies())
def test_who_is_lost_had_a_partner_for_certain_and_has_none_now(before: Topology, after: Topology) -> None:
    then, now = tiny.pairs(before), tiny.pairs(after)
    running = {each.name for each in after.nodes}
    for link in difference(before, after).lost:
        assert link.node in running
        assert any(link.node in (giver, taker) and (kind, name) == (link.kind, link.name) for giver, kind, name, taker in then)
        if not link.by_default and link.after is not None:
            channel = (link.after.kind, link.after.name)
            offers = link.after.offers
            assert not any((kind, name) == channel and link.node == (giver if offers else taker) for giver, kind, name, taker in now)


def test_a_remap_moves_the_publisher_away() -> None:
    found = difference(tiny.topology("/a > out=/x", "/b < /x"), tiny.topology("/a > out=/y", "/b < /x"))
    assert lost(found) == ["/a publisher /x of /b (1), now /y", "/b subscriber /x of /a (1), now /x"]
    assert [(pair.before.name, pair.after.name) for pair in found.connections_changed] == [("/x", "/y")]
    assert ([each.name for each in found.channels_added], found.channels_removed) == (["/y"], ())
    assert (found.connections_added, found.connections_removed, found.nodes_changed) == ((), (), ())


def test_both_moved_together_is_no_loss() -> None:
    found = difference(tiny.topology("/a > out=/x", "/b < in=/x"), tiny.topology("/a > out=/y", "/b < in=/y"))
    assert (lost(found), found.gained, len(found.connections_changed)) == ([], (), 2)


def test_another_partner_on_the_same_name_is_no_loss() -> None:
    found = difference(tiny.topology("/a > /x", "/b < /x"), tiny.topology("/c > /x", "/b < /x"))
    assert lost(found) == []
    assert ([each.name for each in found.nodes_removed], [each.name for each in found.nodes_added]) == (["/a"], ["/c"])


def test_the_same_name_under_another_declaration_is_no_loss() -> None:
    """Another program stands in for the old one, and says the same."""
    found = difference(tiny.topology("/a > scan=/x", "/b < /x"), tiny.topology("/a > laser=/x", "/b < /x"))
    assert lost(found) == []


def test_one_of_many_is_told_and_the_others_keep_their_partner() -> None:
    before = tiny.topology("/a > /x", *(f"/b{number} < in=/x" for number in range(7)))
    after = tiny.topology("/a > /x", "/b0 < in=/y", *(f"/b{number} < in=/x" for number in range(1, 7)))
    assert lost(difference(before, after)) == ["/b0 subscriber /x of /a (1), now /y"]


def test_partners_are_counted_and_a_few_named() -> None:
    before = tiny.topology("/a > out=/x", *(f"/b{number} < /x" for number in range(9)))
    after = tiny.topology("/a > out=/y", *(f"/b{number} < /x" for number in range(9)))
    assert lost(difference(before, after))[0] == "/a publisher /x of /b0 /b1 /b2 /b3 /b4 (9), now /y"


def test_what_was_not_certain_cannot_be_lost() -> None:
    for nodes in ([], [tiny.node("/a")]):
        assert lost(difference(tiny.topology("/a > /x?", "/b < /x"), tiny.topology("/b < /x", nodes=nodes))) == []


def test_topics_of_an_action_are_not_told_beside_it() -> None:
    before = tiny.topology("/a > /go/goal", "/b < /go/goal")
    topics = tuple(each._replace(action="/go") for each in before.connections)
    assert lost(difference(before._replace(connections=topics), tiny.topology("/b < /go/goal", nodes=[tiny.node("/a")]))) == []


def test_a_loss_is_told_beside_what_had_no_partner() -> None:
    before = tiny.topology("/a > /v", "/a > /x", "/b < /x")
    assert [link.name for link in difference(before, tiny.topology("/a > /v", "/b < /x")).lost] == ["/x", "/x"]


def test_hubs_and_plumbing_cannot_be_lost() -> None:
    assert lost(difference(tiny.topology("/a > /tf", "/b < /tf"), tiny.topology("/b < /tf"))) == []
    assert lost(difference(tiny.topology("/a > /bond", "/b < /bond", plumbing=["/bond"]), tiny.topology("/b < /bond"))) == []


def test_a_topic_that_many_hear_can_be_lost() -> None:
    heard = [f"/b{number} < /x" for number in range(70)]
    found = difference(tiny.topology("/a > /x", *heard, hubs=["/x"]), tiny.topology(*heard, nodes=[tiny.node("/a")]))
    assert (len(found.lost), lost(found)[0]) == (71, "/a publisher /x of /b0 /b1 /b10 /b11 /b12 (70), now gone")


def test_services_and_actions_can_be_lost() -> None:
    found = difference(
        tiny.topology("/a serves /s", "/b calls /s", "/a does /go", "/b asks /go"), tiny.topology("/b calls /s", "/b asks /go")
    )
    assert lost(found) == ["/b action client /go of /a (1), now /go", "/b client /s of /a (1), now /s"]


def test_a_loss_that_shows_by_default_only() -> None:
    before = tiny.topology("/a > /x", "/b < /x", configurations=CONFIGURATIONS)
    after = tiny.topology("/a > /x @sim:=true", "/b < /x", configurations=CONFIGURATIONS)
    assert lost(difference(before, after)) == [
        "/a publisher /x of /b (1) by default, now gone",
        "/b subscriber /x of /a (1) by default, now /x",
    ]


def test_a_loss_by_default_is_one_of_the_first_configuration() -> None:
    three = (*CONFIGURATIONS, "slow:=true")
    before = tiny.topology("/a > /x", "/b < /x", configurations=three)
    after = tiny.topology("/a > /x @sim:=true,slow:=true", "/b < /x", configurations=three)
    assert [(link.node, link.by_default) for link in difference(before, after).lost] == [("/a", True), ("/b", True)]
    other = tiny.topology("/a > /x @-,slow:=true", "/b < /x", configurations=three)
    assert difference(before, other).lost == ()


def test_a_name_that_another_declaration_has_now_is_what_is_shown() -> None:
    before = tiny.topology("/a > out=/x", "/b < /x")
    after = tiny.topology("/a > other=/x", "/b < /y")
    assert lost(difference(before, after)) == ["/a publisher /x of /b (1), now /x", "/b subscriber /x of /a (1), now gone"]


def test_of_several_names_that_it_has_now_the_first_is_shown() -> None:
    before = tiny.topology("/a > out=/x", "/b < /x", configurations=CONFIGURATIONS)
    after = tiny.topology("/a > out=/y @-", "/a > out=/z @sim:=true", "/b < /x", configurations=CONFIGURATIONS)
    assert lost(difference(before, after))[0] == "/a publisher /x of /b (1), now /y"
    other = tiny.topology("/a > left=/x", "/a > right=/x", "/b < /y", configurations=CONFIGURATIONS)
    after_all = difference(before, other).lost[0].after
    assert after_all is not None
    assert (after_all.declared, after_all.name) == ("left", "/x")


def test_a_loss_that_shows_by_default_only_where_there_was_one_configuration() -> None:
    before = tiny.topology("/a > /x", "/b < /x")
    after = tiny.topology("/a > /x @sim:=true", "/b < /x", configurations=CONFIGURATIONS)
    assert [link.by_default for link in difference(before, after).lost] == [True, True]
    assert [link.by_default for link in difference(after, before).gained] == [True, True]


def test_partners_that_never_run_together_are_none() -> None:
    before = tiny.topology("/a > /x", "/b < /x", configurations=CONFIGURATIONS)
    after = tiny.topology("/a > /x @-", "/b < /x @sim:=true", configurations=CONFIGURATIONS)
    assert lost(difference(before, after)) == ["/a publisher /x of /b (1), now /x", "/b subscriber /x of /a (1), now /x"]


def test_partners_that_run_together_now_are_a_change_though_each_is_as_it_was() -> None:
    three = (*CONFIGURATIONS, "slow:=true")
    apart = tiny.topology("/a > /x @sim:=true", "/b < /x @slow:=true", configurations=three)
    together = tiny.topology("/a > /x @sim:=true", "/b < /x @sim:=true", configurations=three)
    found = difference(apart, together)
    assert ([link.node for link in found.gained], found.connections_changed, found.is_empty) == (["/a", "/b"], (), False)


def test_a_condition_around_a_node_is_told_of_the_node_once() -> None:
    before = tiny.topology("/a > /x", configurations=CONFIGURATIONS)
    simulated = tiny.node("/a", only=("sim:=true",))
    found = difference(before, tiny.topology("/a > /x @sim:=true", nodes=[simulated], configurations=CONFIGURATIONS))
    assert [(pair.before.only, pair.after.only) for pair in found.nodes_changed] == [((), ("sim:=true",))]
    assert found.connections_changed == ()


def test_a_condition_around_a_remap_is_told_of_the_connection() -> None:
    before = tiny.topology("/a > out=/x", configurations=CONFIGURATIONS)
    after = tiny.topology("/a > out=/x @sim:=true", "/a > out=/y @-", configurations=CONFIGURATIONS)
    found = difference(before, after)
    changed = [(pair.before.name, pair.after.name, pair.after.only) for pair in found.connections_changed]
    assert (changed, [each.name for each in found.connections_added]) == ([("/x", "/x", ("sim:=true",))], ["/y"])


def test_other_args_with_the_same_effect_are_no_change() -> None:
    before = tiny.topology("/a > /x @sim:=true", "/b < /x", configurations=("", "sim:=true"))
    after = tiny.topology("/a > /x @simulated:=true", "/b < /x", configurations=("", "simulated:=true"))
    assert difference(before, after).is_empty


def test_programs_and_types_that_change() -> None:
    before = tiny.topology("/a > /x", nodes=[tiny.node("/a", "demo/old")])
    after = tiny.topology("/a > /x", nodes=[tiny.node("/a", "demo/new")])

    def typed(topology: Topology, type_: str) -> Topology:
        return topology._replace(
            connections=tuple(each._replace(type=type_) for each in topology.connections),
            channels=tuple(each._replace(types=(type_,)) for each in topology.channels),
        )

    found = difference(typed(before, "t/Old"), typed(after, "t/New"))
    assert [(pair.before.program, pair.after.program) for pair in found.nodes_changed] == [("demo/old", "demo/new")]
    assert [(pair.before.types, pair.after.types) for pair in found.channels_changed] == [(("t/Old",), ("t/New",))]
    assert [(pair.before.type, pair.after.type) for pair in found.connections_changed] == [("t/Old", "t/New")]
    assert difference(before, typed(after, "t/New")).channels_changed == ()


def test_an_unknown_node_that_came_in_makes_losses_uncertain() -> None:
    before, after = tiny.topology("/a > /x", "/b < /x"), tiny.topology("/b < /x")
    assert not difference(before, after).uncertain
    assert difference(before, after._replace(nodes=(*after.nodes, tiny.node("/c", knowledge="unknown")))).uncertain
    assert difference(before, after._replace(complete=False)).uncertain
    assert not difference(before, after._replace(nodes=(*after.nodes, tiny.node("/c", open=(("params", "many"),))))).uncertain
    for category in ("publishers", "clients"):
        assert difference(before, after._replace(nodes=(*after.nodes, tiny.node("/c", open=((category, "many"),))))).uncertain


def test_a_node_in_another_namespace_is_seen_again() -> None:
    before = tiny.topology(nodes=[tiny.node("/wheels"), tiny.node("/cam/a/driver"), tiny.node("/cam/b/driver")])
    after = tiny.topology(nodes=[tiny.node("/base/wheels"), tiny.node("/camera/a/driver"), tiny.node("/camera/b/driver")])
    assert moved(difference(before, after)) == {"/wheels": "/base/wheels"}


def test_one_node_that_two_could_be_is_not_seen_again() -> None:
    one, two = tiny.topology(nodes=[tiny.node("/driver")]), tiny.topology(nodes=[tiny.node("/a/driver"), tiny.node("/b/driver")])
    assert (moved(difference(one, two)), moved(difference(two, one))) == ({}, {})
    assert moved(difference(one, tiny.topology())) == {}, "nor is one that has only gone"


def test_a_node_that_talks_to_nobody_is_a_change() -> None:
    before, after = tiny.topology("/a > /x"), tiny.topology("/a > /x", nodes=[tiny.node("/a"), tiny.node("/b")])
    assert not difference(before, after).is_empty
    assert not difference(after, before).is_empty


REFUSED = Verdict("refused", "LL101", "it ends too early")
REFUSED_ELSEWHERE = LOADS._replace(elsewhere=(Refusal((("sim", "true"),), "LL101", "it ends too early"),))


@pytest.mark.parametrize(
    ("before", "after", "is_changed"),
    [
        (LOADS, LOADS, False),
        (LOADS, REFUSED, True),
        (LOADS, REFUSED_ELSEWHERE, True),
        (REFUSED, REFUSED._replace(reason="another one"), False),
        (None, REFUSED, False),
        (None, None, False),
    ],
)
def test_a_launch_file_that_no_longer_loads_is_a_change(before: Verdict | None, after: Verdict | None, is_changed: bool) -> None:
    same = tiny.topology("/a > /x")
    for one, other in ((before, after), (after, before)):
        found = difference(same._replace(verdict=one), same._replace(verdict=other))
        assert (found.loads_otherwise, found.is_empty) == (is_changed, not is_changed)
