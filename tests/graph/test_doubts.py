"""Who may be at an empty end of a name."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from launchlint.graph.doubts import MayBe, doubts
from tests.graph.sample import STRING, graph, program

KNOWN: dict[str, Any] = {
    "p": {
        "executables": {
            "say": program(publishers=[{"name": "out", "type": STRING}]),
            "open": program(subscribers=[{"name": "in", "type": STRING}], open={"publishers": "it has plugins"}),
        }
    }
}
SAY = '<node pkg="p" type="say" name="say" ns="near"/>'


def test_nobody_may_be_there_where_all_is_known(tmp_path: Path) -> None:
    assert doubts([graph(tmp_path, SAY, KNOWN)]) == {}


def test_a_node_that_nobody_knows_may_be(tmp_path: Path) -> None:
    found = doubts([graph(tmp_path, f'{SAY}<node pkg="q" type="stranger" name="u"/>', KNOWN)])
    assert list(found) == [("topic", "/near/out", False)]
    ((who,),) = found.values()
    assert (who.node, who.unknown) == ("/u", True)
    assert who.reason.startswith("it is not known what /u does: ")


def test_not_one_whose_names_lie_elsewhere(tmp_path: Path) -> None:
    assert doubts([graph(tmp_path, f'{SAY}<node pkg="q" type="stranger" name="u" ns="far"/>', KNOWN)]) == {}


def test_what_a_node_waits_for_comes_from_another_one(tmp_path: Path) -> None:
    one = '<node pkg="p" type="open" name="a"/>'
    assert doubts([graph(tmp_path, one, KNOWN)]) == {}
    both = doubts([graph(tmp_path, f'{one}<node pkg="p" type="open" name="b" ns="c"><remap from="in" to="said"/></node>', KNOWN)])
    assert both["topic", "/in", True] == (MayBe("/c/b", False, "/c/b may have more publishers: it has plugins"),)
    assert both["topic", "/c/said", True] == (MayBe("/a", False, "/a may have more publishers: it has plugins"),)


def test_configurations_are_taken_together(tmp_path: Path) -> None:
    (tmp_path / "one").mkdir()
    (tmp_path / "two").mkdir()
    alone = graph(tmp_path / "one", SAY, KNOWN)
    beside = graph(tmp_path / "two", f'{SAY}<node pkg="q" type="stranger" name="u"/>', KNOWN)
    assert doubts([alone, beside]) == doubts([beside])
