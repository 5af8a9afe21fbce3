"""Who could have a name that the graph does not show: nodes that nobody knows, bounded by what the launch file says of them."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest

from tests.graph.sample import STRING, graph, program, reasons

NODE: dict[str, Any] = {"p": {"executables": {"t": program(publishers=[{"name": "out", "type": STRING}])}}}


def who(tmp_path: Path, launch: str, name: str, packages: dict[str, Any] = NODE) -> list[tuple[str, bool]]:
    """The nodes that may publish ``name``, and whether something says so."""
    return [(each.node, each.named) for each in graph(tmp_path, launch, packages).may_offer("topic", name)]


@pytest.mark.parametrize(
    ("attributes", "name", "answer"),
    [
        ("", "/scan", [("/n", False)]),
        ("", "/front/scan", [("/n", False)]),
        ('ns="a"', "/a/scan", [("/a/n", False)]),
        ('ns="a"', "/a/b/scan", [("/a/n", False)]),
        ('ns="a"', "/scan", [("/a/n", False)]),  # many write global names of one part
        ('ns="a"', "/b/scan", []),
        ('ns="a"', "/ab/scan", []),
        ('ns="$(env NOT_HERE)"', "/b/scan", [("/unknown_namespace/n", False)]),
    ],
)
def test_a_node_that_nobody_knows_has_names_below_its_namespace(
    attributes: str, name: str, answer: list[tuple[str, bool]], tmp_path: Path
) -> None:
    assert who(tmp_path, f'<node pkg="q" type="stranger" name="n" {attributes}/>', name) == answer


@pytest.mark.parametrize(
    ("inside", "args", "named", "other"),
    [
        ('<remap from="x" to="/b/scan"/>', "", "/b/scan", "/b/map"),
        ('<remap from="x" to="/b/image"/>', "", "/b/image/compressed", "/b/map"),
        ('<remap from="x" to="/b/image"/>', "", "/b/camera_info", "/b/map"),
        ('<param name="topic" value="/b/scan"/>', "", "/b/scan", "/b/map"),
        ('<param name="topic" value="scan"/>', "", "/a/scan", "/b/scan"),
        ('<param name="topic" value="scan"/>', "", "/a/n/scan", "/b/scan"),
        ('<rosparam param="topics">[/b/scan, 5]</rosparam>', "", "/b/scan", "/b/map"),
        ('<param name="robot" value="/b"/>', "", "/b/scan", "/c/scan"),
        ("", "/b/scan 5", "/b/scan", "/b/map"),
        ("", "--topic=/b/scan", "/b/scan", "/b/map"),
    ],
)
def test_what_is_said_of_a_node_names_what_it_has(inside: str, args: str, named: str, other: str, tmp_path: Path) -> None:
    launch = f'<node pkg="q" type="stranger" name="n" ns="a" args="{args}">{inside}</node>'
    assert (who(tmp_path, launch, named), who(tmp_path, launch, other)) == ([("/a/n", True)], [])


def test_the_names_of_frames_are_no_topics(tmp_path: Path) -> None:
    launch = '<node pkg="q" type="stranger" name="n"><param name="odom_frame" value="odom"/><param name="map" value="map"/></node>'
    assert (who(tmp_path, launch, "/odom"), who(tmp_path, launch, "/map")) == ([("/n", False)], [("/n", True)])


def test_a_name_that_is_remapped_away_is_not_there(tmp_path: Path) -> None:
    inner = '<node pkg="q" type="stranger" name="n"><remap from="scan" to="scan_raw"/></node>'
    assert (who(tmp_path, inner, "/scan"), who(tmp_path, inner, "/scan_raw")) == ([], [("/n", True)])
    around = '<remap from="scan" to="scan_raw"/><node pkg="q" type="stranger" name="n"/>'
    assert (who(tmp_path, around, "/scan"), who(tmp_path, around, "/scan_raw")) == ([], [("/n", False)])


def test_params_for_everybody_may_be_read_by_whom_nobody_knows(tmp_path: Path) -> None:
    launch = '<param name="topic" value="/b/scan"/><node pkg="p" type="t" name="known"><param name="y" value="/c/scan"/></node>'
    stranger = '<node pkg="q" type="stranger" name="n" ns="a"/>'
    assert who(tmp_path, launch, "/b/scan") == []
    assert who(tmp_path, launch + stranger, "/b/scan") == [("/a/n", True)]
    assert who(tmp_path, launch + stranger, "/c/scan") == []


def test_a_program_that_is_open_may_have_any_name(tmp_path: Path) -> None:
    packages = {"p": {"executables": {"t": program(open={"publishers": "plugins"})}}}
    found = graph(tmp_path, '<node pkg="p" type="t" name="n" ns="a" args="/c/x"/>', packages)
    assert [(each.named, each.anything) for each in found.may_offer("topic", "/b/x")] == [(False, True)]
    assert [(each.named, each.anything) for each in found.may_offer("topic", "/c/x")] == [(True, True)]
    assert found.may_use("topic", "/b/x") == ()


def test_a_doubt_has_a_type(tmp_path: Path) -> None:
    packages = {"p": {"executables": {"t": program(publishers=[{"name": "{any}", "type": STRING}])}}}
    found = graph(tmp_path, '<node pkg="p" type="t" name="n"/>', packages)
    assert reasons(found.may_offer("topic", "/x", STRING)) == ["/n has publishers whose names cannot be known ({any})"]
    assert reasons(found.may_offer("topic", "/x", "my_msgs/String")) != []  # it may be a copy
    assert found.may_offer("topic", "/x", "std_msgs/Bool") == ()


def test_actions_count_for_their_topics_only(tmp_path: Path) -> None:
    packages = {"p": {"executables": {"t": program(open={"actions": "plugins"})}}}
    found = graph(tmp_path, '<node pkg="p" type="t" name="n"/>', packages)
    assert reasons(found.may_offer("topic", "/move/goal")) == ["/n may have more actions: plugins"]
    assert (found.may_offer("topic", "/move/scan"), found.may_offer("service", "/move/goal")) == ((), ())


def test_no_more_are_told_than_people_read(tmp_path: Path) -> None:
    launch = "".join(f'<node pkg="q" type="s" name="n{number}"><remap from="scan" to="x{number}"/></node>' for number in range(60))
    assert [each for each, _ in who(tmp_path, launch, "/x")] == ["/n0", "/n1", "/n2", "/n3", "/n4"]
    assert who(tmp_path, launch, "/scan") == [("/n49", False)]  # with so many of them some may have it by another way


@pytest.mark.parametrize(
    ("literals", "name", "answer"),
    [
        (["scan"], "/a/front/scan", (True, False)),
        (["/b/scan"], "/a/scan", (True, False)),
        (["map"], "/a/scan", (False, False)),
        (["scan"], "/b/scan", None),
        ([], "/b/scan", (False, True)),
    ],
)
def test_the_texts_in_its_sources_name_what_a_program_has(
    literals: list[str], name: str, answer: tuple[bool, bool] | None, tmp_path: Path
) -> None:
    packages = {"p": {"executables": {"t": program(open={"publishers": "a call"}, **({"literals": literals} if literals else {}))}}}
    found = graph(tmp_path, '<node pkg="p" type="t" name="n" ns="a"/>', packages).may_offer("topic", name)
    assert [(each.named, each.anything) for each in found] == ([] if answer is None else [answer])
