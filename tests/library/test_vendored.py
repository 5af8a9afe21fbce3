"""A copy of a public program: what is left of the shipped entries beside what the sources of the copy say."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import pytest

from launchlint.library.merge import merge_programs
from launchlint.library.precedence import heard, suffices
from launchlint.library.vendored import NOT_NAMED
from tests.library.samples import evidence, executable


def entry(name: str, by: str, type_: str = "", **more: Any) -> dict[str, Any]:
    return {"name": name, **({"type": type_} if type_ else {}), **more, "evidence": evidence(by)}


def joined(own: dict[str, Any], shipped: dict[str, Any], given: Sequence[dict[str, Any]] = ()) -> dict[str, Any]:
    """What is known of a program: its variants."""
    variants: dict[str, Any] = merge_programs(heard(given, own, [shipped]))["variants"]
    return variants


def told(variant: dict[str, Any], category: str = "publishers") -> list[tuple[str, str, Any]]:
    return [(each["name"], each.get("type", ""), each.get("condition")) for each in variant.get(category, ())]


@pytest.mark.parametrize("by", ["manual", "dynamic"])
def test_what_the_sources_tell_to_the_end_is_theirs_alone(by: str) -> None:
    shipped = executable(publishers=[entry("heading", by, "a/Q"), entry("fix", by, "a/Fix")], services=[entry("reset", by)])
    known = joined(executable(publishers=[entry("fix", "static", "a/Fix2"), entry("vel", "static")]), shipped)
    assert told(known["default"]) == [("fix", "a/Fix2", None), ("vel", "", None)]
    assert not known["default"].get("services")


def test_a_type_that_the_sources_do_not_tell_is_that_of_the_public_version() -> None:
    known = joined(executable(publishers=[entry("fix", "static")]), executable(publishers=[entry("fix", "manual", "a/Fix", md5="0" * 32)]))
    assert told(known["default"]) == [("fix", "a/Fix", None)]
    assert [each["by"] for each in known["default"]["publishers"][0]["evidence"]] == ["static"]


@pytest.mark.parametrize("opened", [{"open": {"services": "who knows"}}, {"services": [entry("{any}/set", "static")]}])
def test_of_what_they_leave_open_the_shipped_entries_stay(opened: dict[str, Any]) -> None:
    own = executable(publishers=[entry("fix", "static")], **opened, literals=["~reset", "a/clear", "fix"])
    shipped = executable(
        publishers=[entry("heading", "manual")],
        services=[
            entry("reset", "manual"),
            entry("clear", "manual"),
            entry("load", "manual"),
            entry("save", "manual", condition={"param": "~save"}),
            entry("{arg:1}", "manual"),
        ],
    )
    known = joined(own, shipped)["default"]
    assert told(known) == [("fix", "", None)]
    assert {name: condition for name, _, condition in told(known, "services")} == {
        "reset": None,
        "clear": None,
        "load": NOT_NAMED,
        "save": {"all": [{"param": "~save"}, NOT_NAMED]},
        "{arg:1}": None,
    }


def test_of_what_they_leave_open_their_types_count() -> None:
    own = executable(publishers=[entry("fix", "static", "ours/Fix")], open={"publishers": "a loop"}, literals=["fix"])
    known = joined(own, executable(publishers=[entry("fix", "manual", "a/Fix", md5="0" * 32)]))["default"]
    assert told(known) == [("fix", "ours/Fix", None)]
    assert "md5" not in known["publishers"][0]


def test_without_texts_nothing_is_doubted() -> None:
    own = executable(publishers=[entry("fix", "static")], open={"publishers": "a loop"})
    assert told(joined(own, executable(publishers=[entry("heading", "manual")]))["default"]) == [("heading", "", None), ("fix", "", None)]


@pytest.mark.parametrize(("opened", "names"), [("params", ["default"]), ("services", ["default", "two"])])
def test_ways_of_starting_count_where_more_than_params_is_open(opened: str, names: list[str]) -> None:
    shipped = executable(publishers=[entry("heading", "manual")])
    shipped["variants"]["two"] = {"match": {"arg": 1}, "publishers": [entry("other", "manual")]}
    known = joined(executable(publishers=[entry("fix", "static")], open={opened: "a loop"}), shipped)
    assert {name: told(variant) for name, variant in known.items()} == {name: [("fix", "", None)] for name in names}


def test_the_libraries_of_the_user_come_first() -> None:
    by_hand, seen, read = (executable(publishers=[entry("x", by)]) for by in ("manual", "dynamic", "static"))
    assert [suffices([each]) for each in (by_hand, seen, read)] == [True, True, False]
    assert not suffices([])


def test_sources_that_say_nothing_leave_the_public_version_as_it_is() -> None:
    shipped = executable(publishers=[entry("heading", "manual")])
    assert heard([], {"class": "none", "variants": {"default": {}}}, [shipped]) == [shipped]


def test_only_a_person_knows_what_names_known_in_part_are() -> None:
    own = executable(publishers=[entry("fix", "static"), entry("{any}/image", "static")])
    found = [joined(own, executable(publishers=[entry("left/image", by)]))["default"] for by in ("manual", "dynamic")]
    assert [sorted(name for name, _, _ in told(each)) for each in found] == [["fix", "left/image"], ["fix", "left/image", "{any}/image"]]


@pytest.mark.parametrize(
    ("public", "name"),
    [("{remap:camera}/image", "{remap:camera}/image"), ("{param:~ns|camera}/image", "camera/image"), ("camera/image", "camera/image")],
)
def test_which_part_of_a_name_is_remapped_is_known_of_the_public_version(public: str, name: str) -> None:
    own = executable(publishers=[entry("camera/image", "static")])
    assert [each for each, _, _ in told(joined(own, executable(publishers=[entry(public, "manual")]))["default"])] == [name]


@pytest.mark.parametrize(("opened", "names"), [({}, ["fix", "robot_1/odom"]), ({"publishers": "robots of the world"}, ["fix"])])
def test_names_that_may_be_there_are_told_unless_a_person_leaves_it_open(opened: dict[str, str], names: list[str]) -> None:
    robot = entry("robot_1/odom", "static", condition={"text": "robots > 1"})
    own = executable(publishers=[entry("fix", "static"), robot], open={"publishers": "a loop"}, literals=["fix", "odom"])
    known = joined(own, executable(publishers=[entry("fix", "manual")], open=opened))["default"]
    assert [name for name, _, _ in told(known)] == names
