"""Names and remap rules, as rcl resolves and refuses them."""

from __future__ import annotations

import pytest

from launchlint.rcl import remap
from launchlint.rcl.names import Names
from launchlint.rcl.refused import Refused
from launchlint.rcl.remap import Rule
from tests.rcl.conftest import Answers


def rules(*texts: str) -> list[Rule]:
    read = [remap.parse(text) for text in texts]
    return [rule for rule in read if isinstance(rule, Rule)]


@pytest.mark.parametrize(
    ("name", "expanded"),
    [
        ("scan", "/front/scan"),
        ("/scan", "/scan"),
        ("~/scan", "/front/lidar/scan"),
        ("~", "/front/lidar"),
        ("~s", "/front/lidars"),
        ("~sc", None),
        ("{node}/scan", "/front/lidar/scan"),
        ("{ns}/scan", "/front/scan"),
        ("{other}/scan", None),
        ("scan/", None),
        ("2d", None),
        ("scan/2d", None),
        ("scan-2d", None),
        ("", None),
    ],
)
def test_what_a_program_asks_for_is_expanded(name: str, expanded: str | None) -> None:
    assert Names("lidar", "/front").expand(name) == expanded


def test_the_first_matching_rule_counts_and_none_is_applied_twice() -> None:
    both = Names("lidar", "/front", rules("scan:=points", "/front/scan:=/other", "points:=cloud"))
    assert (both.topic("scan"), both.topic("points"), both.topic("/scan")) == ("/front/points", "/front/cloud", "/scan")


def test_a_rule_may_be_for_topics_or_services_or_one_node_only() -> None:
    lidar = Names("lidar", "/", rules("rostopic://a:=b", "rosservice://a:=c", "camera:x:=y", "lidar:x:=z"))
    assert (lidar.topic("a"), lidar.service("a"), lidar.topic("x")) == ("/b", "/c", "/z")


def test_names_of_nodes_are_remapped_first_and_rules_for_a_node_count_by_the_new_name() -> None:
    node = Names("lidar", "front", rules("__node:=front_lidar", "front_lidar:__ns:=/robot", "lidar:a:=b", "~/x:=y"))
    assert (node.full_name, node.topic("a"), node.topic("~/x")) == ("/robot/front_lidar", "/robot/a", "/robot/y")


def test_a_namespace_with_a_slash_at_its_end_makes_every_name_fail() -> None:
    node = Names("lidar", "", rules("__ns:=/robot/"))
    assert (node.full_name, node.topic("scan")) == ("/robot/lidar", None)


@pytest.mark.parametrize(
    ("text", "at", "reason"),
    [
        ("a-b:=c", 1, "a name cannot hold '-'"),
        ("a:=", 3, "the name is empty"),
        (":=a", 0, "the name is empty"),
        ("a/:=b", 2, "a name cannot end with a slash"),
        ("a//b:=c", 2, "two slashes stand side by side"),
        ("1a:=b", 0, "no part of a name can begin with a digit"),
        ("~a:=b", 0, "~ stands at the beginning of a name only, with a slash behind it"),
        ("a:={node}/b", 3, "names in { } are not filled in by remap rules"),
        ("*:=b", 0, "wildcards are not implemented in remap rules"),
        ("/**/a:=b", 1, "wildcards are not implemented in remap rules"),
        (r"a:=\1", 3, "references to a wildcard are not implemented in remap rules"),
        ("a__b:=c", 2, "a name cannot hold two underscores side by side"),
        ("a:=b:=c", 4, "a second := stands here"),
        ("a", 1, ":= is missing"),
        ("a b:=c", 1, "a name cannot hold a blank"),
        ("__ns:=q", 6, "the namespace must begin with a slash"),
        ("__node:=/q", 8, "a node name must follow, made of letters, digits and single underscores"),
    ],
)
def test_what_rcl_refuses_and_where(text: str, at: int, reason: str) -> None:
    refused = remap.parse(text)
    assert isinstance(refused, Refused)
    assert (refused.span.start, refused.reason) == (at, reason)


def test_recorded_answers(answers: Answers) -> None:
    for case in answers("names.jsonl.xz"):
        read = [remap.parse(f"{source}:={target}") for source, target in case["rules"]]
        if any(isinstance(rule, Refused) for rule in read):
            assert case["answer"] == {"refused": True}
            continue
        node = Names(case["node"], case["namespace"], [rule for rule in read if isinstance(rule, Rule)])
        asked = [node.topic(text[2:]) if text[0] == "t" else node.service(text[2:]) for text in case["asked"]]
        assert case["answer"] == {"name": node.node, "namespace": node.namespace, "names": asked}
