"""Joining libraries: who wins, what is kept, what is the same."""

from __future__ import annotations

import json
from itertools import permutations
from typing import Any

import pytest

from launchlint.library.merge import Clash, merge_files, merge_libraries, merge_programs
from launchlint.library.write import canonical
from tests.library.samples import evidence, executable, library, one, publishers, written
from tests.library.test_schema import BUNDLED, EVERYTHING

MANUAL, DYNAMIC, STATIC = (evidence(by) for by in ("manual", "dynamic", "static"))


def joined(*lists: list[dict[str, Any]], category: str = "publishers") -> Any:
    """The entries of one variant made of several."""
    return merge_programs([executable(**{category: entries}) for entries in lists])["variants"]["default"][category]


def test_dynamic_wins_over_static_which_adds_what_it_knows() -> None:
    static = {"name": "scan", "type": "sensor_msgs/PointCloud", "latched": True, "condition": {"text": "if (x)"}, "evidence": STATIC}
    dynamic = {"name": "scan", "type": "sensor_msgs/LaserScan", "md5": "a" * 32, "queue": 5, "evidence": DYNAMIC}
    expected = {
        "name": "scan",
        "type": "sensor_msgs/LaserScan",
        "md5": "a" * 32,
        "latched": True,
        "queue": 5,
        "condition": {"text": "if (x)"},
        "evidence": DYNAMIC + STATIC,
    }
    assert joined([static], [dynamic]) == joined([dynamic], [static]) == [expected]


def test_what_a_person_wrote_wins() -> None:
    """Also in what it leaves out: a person who gives no condition says that there is none."""
    manual = {"name": "scan", "evidence": MANUAL}
    static = {"name": "scan", "type": "a/B", "when": "message", "condition": {"text": "if (x)"}, "evidence": STATIC}
    dynamic = {"name": "scan", "type": "a/C", "evidence": DYNAMIC}
    expected = {"name": "scan", "type": "a/C", "evidence": MANUAL + DYNAMIC + STATIC}
    for order in permutations(([manual], [static], [dynamic])):
        assert joined(*order) == [expected]


def test_no_evidence_is_a_persons_word() -> None:
    assert joined([{"name": "scan", "type": "a/C", "evidence": DYNAMIC}], [{"name": "scan", "type": "a/B"}]) == [
        {"name": "scan", "type": "a/B", "evidence": DYNAMIC}
    ]


def test_of_equals_the_first_wins() -> None:
    assert joined([{"name": "x", "queue": 1, "evidence": STATIC}], [{"name": "x", "queue": 2, "type": "a/B", "evidence": STATIC}]) == [
        {"name": "x", "queue": 1, "type": "a/B", "evidence": STATIC}
    ]


def test_the_sum_of_another_type_is_not_taken() -> None:
    dynamic, static = {"name": "x", "type": "a/B", "evidence": DYNAMIC}, {"name": "x", "type": "a/C", "md5": "c" * 32, "evidence": STATIC}
    assert joined([dynamic], [static]) == [{"name": "x", "type": "a/B", "evidence": DYNAMIC + STATIC}]


@pytest.mark.parametrize(
    ("one_name", "other_name", "expected"),
    [
        (("{param:~topic|scan}", MANUAL), ("scan", DYNAMIC), "{param:~topic|scan}"),
        (("{param:~topic|scan}", STATIC), ("scan", DYNAMIC), "{param:~topic|scan}"),
        (("scan", MANUAL), ("{param:~topic|scan}", STATIC), "scan"),
        (("{remap:image}/compressed", MANUAL), ("image/compressed", DYNAMIC), "{remap:image}/compressed"),
    ],
)
def test_a_template_is_what_a_probe_sees_at_its_default(one_name: Any, other_name: Any, expected: str) -> None:
    first, second = ({"name": name, "evidence": known} for name, known in (one_name, other_name))
    assert [entry["name"] for entry in joined([first], [second])] == [expected]
    assert [entry["name"] for entry in joined([second], [first])] == [expected]


def test_other_names_stay_apart() -> None:
    names = ["{param:~topic}", "{param:~topic|scan}", "/scan", "~scan", "{arg:1}"]
    assert [entry["name"] for entry in joined(*[[{"name": name}] for name in names])] == names


def test_entries_of_one_name_stay_apart() -> None:
    """A source that lists a name twice, under different conditions, knows more than one that saw it once."""
    on = {"name": "out", "type": "a/B", "condition": {"param": "~x"}, "evidence": MANUAL}
    off = {"name": "out", "type": "a/C", "condition": {"not": {"param": "~x"}}, "evidence": MANUAL}
    seen = {"name": "out", "type": "a/C", "evidence": DYNAMIC}
    for order in ([[on, off], [seen]], [[seen], [on, off]]):
        assert joined(*order) == [on, {**off, "evidence": MANUAL + DYNAMIC}]


def test_roles_stay_apart() -> None:
    server, client = ({"name": "go", "role": role} for role in ("server", "client"))
    assert joined([server], [client], category="actions") == [server, client]


def test_frames_are_joined_and_say_nothing_of_who_knows_the_names() -> None:
    frames = [{"name": "odom", "role": "child", "parent": "map", "evidence": MANUAL}, {"name": "odom", "role": "used"}]
    seen = executable(publishers=[{"name": "scan", "evidence": STATIC}], frames=frames, open={"params": "static"})
    other = executable(
        publishers=[{"name": "scan", "evidence": DYNAMIC}], frames=[frames[1] | {"through": "tf2"}], open={"clients": "seen"}
    )
    variant = merge_programs([seen, other])["variants"]["default"]
    assert variant["frames"] == [{"name": "odom", "role": "used", "through": "tf2"}, frames[0]]
    assert variant["open"] == {"clients": "seen"}


def test_open_is_what_the_most_trusted_say() -> None:
    manual = executable(publishers=[{"name": "a", "evidence": MANUAL}], open={"publishers": "plugins"})
    static = executable(publishers=[{"name": "a", "evidence": STATIC}], open={"clients": "computed"})
    assert merge_programs([static, manual])["variants"]["default"]["open"] == {"publishers": "plugins"}
    nothing_but_open = executable(open={"subscribers": "displays"})
    assert merge_programs([static, nothing_but_open])["variants"]["default"]["open"] == {"subscribers": "displays"}


FAILED = {"class": "roscpp", "status": "failed", "problems": [{"code": "display"}]}
LIKE = {"like": "other"}
KNOWN = executable(publishers=[{"name": "x"}])


@pytest.mark.parametrize(
    ("known", "expected"),
    [
        ([FAILED, KNOWN], {**KNOWN, "problems": [{"code": "display"}]}),
        ([KNOWN, LIKE], KNOWN),
        ([LIKE, KNOWN], KNOWN),
        ([FAILED, LIKE], {**LIKE, "problems": [{"code": "display"}]}),
        ([FAILED, FAILED], FAILED),
        ([FAILED, {"class": "none"}], {"class": "none", "problems": [{"code": "display"}]}),
        ([LIKE, {"like": "third"}], LIKE),
    ],
)
def test_programs_of_which_not_all_is_known(known: list[Any], expected: Any) -> None:
    assert merge_programs(known) == expected


def test_variants_are_joined_by_name() -> None:
    fast = {"match": {"arg": 1}, "publishers": [{"name": "fast"}]}
    both = merge_programs(
        [{"variants": {"default": {"publishers": [{"name": "a"}]}}}, {"variants": {"default": {"clients": []}, "fast": fast}}]
    )
    assert both == {"variants": {"default": {"publishers": [{"name": "a"}], "clients": []}, "fast": fast}}


def test_sources_messages_and_packages() -> None:
    first = {**library(a={"version": "1", "complete": ["nodelets"]}), "generator": "x", "messages": {"a/B": {"text": "t"}},
             "sources": [{"id": "s", "url": "u", "ref": "first"}]}  # fmt: skip
    second = {**library(a={"version": "2", "executables": {"n": KNOWN}}, b={}), "generator": "y", "messages": {"a/B": {"md5": "b" * 32}},
              "sources": [{"id": "s", "url": "u", "ref": "second"}, {"id": "r", "url": "u"}]}  # fmt: skip
    assert merge_libraries([first, second]) == {
        "format": "launchlint-library",
        "version": 1,
        "sources": [{"id": "r", "url": "u"}, {"id": "s", "url": "u", "ref": "first"}],
        "messages": {"a/B": {"text": "t", "md5": "b" * 32}},
        "packages": {"a": {"version": "1", "complete": ["nodelets"], "executables": {"n": KNOWN}}, "b": {}},
    }


def test_messages_that_clash() -> None:
    libraries = [{**library(), "messages": {"a/B": message}} for message in ({"text": "x"}, {"md5": "a" * 32}, {"md5": "b" * 32})]
    with pytest.raises(Clash) as clash:
        merge_libraries(libraries)
    assert str(clash.value) == f"they were made with different versions of the message a/B (MD5 {'a' * 32} and {'b' * 32})"


@pytest.mark.parametrize("path", [None, *BUNDLED], ids=lambda path: path.stem if path else "everything")
def test_a_library_joined_with_itself_is_itself(path: Any) -> None:
    document = EVERYTHING if path is None else json.loads(path.read_bytes())
    plain = {key: value for key, value in document.items() if key != "sources" or value}
    assert canonical(merge_libraries([document, document])) == canonical(plain)


def test_shards_may_be_joined_step_by_step() -> None:
    programs = [executable(publishers=[{"name": "x", "evidence": evidence("dynamic", str(number))}]) for number in range(4)]
    shards = [library(**{f"p{number % 2}": {"executables": {f"n{number}": each}}}) for number, each in enumerate(programs)]
    shards += [publishers({"name": "x", "evidence": STATIC}), publishers({"name": "x", "type": "a/B", "evidence": STATIC})]
    whole = canonical(merge_libraries(shards))
    stepwise = merge_libraries([merge_libraries(shards[:2]), merge_libraries([merge_libraries(shards[2:4]), *shards[4:]])])
    assert canonical(stepwise) == whole


def test_of_files_the_last_wins(tmp_path: Any) -> None:
    files = [written(tmp_path / f"{number}.json", one(executable(publishers=[{"name": "x", "queue": number}]))) for number in range(3)]
    assert json.loads(merge_files(files)) == one(executable(publishers=[{"name": "x", "queue": 2}]))
