"""Who is at the other end of a connection."""

from __future__ import annotations

import time

from hypothesis import given

from launchlint.graph.partners import Partners
from launchlint.graph.topology import Topology
from tests.graph import tiny


@given(tiny.topologies())
def test_partners_are_the_pairs_of_the_plain_definition(topology: Topology) -> None:
    partners = Partners(topology)
    for each in topology.connections:
        when = set(each.only or topology.configurations)
        others = {
            other.node
            for other in topology.connections
            if (other.kind, other.name, other.offers) == (each.kind, each.name, not each.offers)
            if when & set(other.only or topology.configurations)
        }
        assert partners.of(each) == sorted(others - {each.node})
        assert partners.of(each, 2) == sorted(others - {each.node})[:2]
        assert partners.count(each) == len(others - {each.node})
        assert partners.is_its_own(each) == (each.node in others)


def test_those_of_other_configurations_are_no_partners() -> None:
    topology = tiny.topology("/a > /x @sim:=true", "/b < /x @-", "/c < /x", configurations=("", "sim:=true"))
    partners = Partners(topology)
    assert {each.node: partners.of(each) for each in topology.connections} == {"/a": ["/c"], "/b": [], "/c": ["/a"]}


def test_a_hub_with_thousands_on_each_side_is_never_paired() -> None:
    topology = tiny.topology(*(f"/p{number} > /x" for number in range(3000)), *(f"/s{number} < /x" for number in range(3000)))
    started = time.process_time()
    partners = Partners(topology)
    assert sum(partners.count(each) for each in topology.connections) == 2 * 3000 * 3000
    assert all(len(partners.of(each, 5)) == 5 for each in topology.connections)
    assert time.process_time() - started < 2
