"""All libraries of a run as one."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest

from launchlint.library.lookup import Library, open_libraries
from launchlint.library.program import program
from launchlint.library.shipped import DIRECTORY, INDEX, Bundled, is_in_library
from launchlint.library.template import UNKNOWN
from tests.library.samples import Node, evidence, executable, library, written


def opened(tmp_path: Path, *documents: Any, bundled: bool = False) -> Library:
    return open_libraries(
        [written(tmp_path / f"{number}.json", document) for number, document in enumerate(documents)], bundled=bundled
    )  # fmt: skip


def published(found: Any) -> list[tuple[str, str]] | None:
    """Name and type of what the default variant of a program publishes."""
    return None if found is None else [(each.name, each.type) for each in found.variants[-1].declarations if each.category == "publishers"]


def node(type_: str, by: str | None = None) -> dict[str, Any]:
    entry = {"name": "x", "type": type_, **({"evidence": evidence(by)} if by else {})}
    return executable(publishers=[entry])


def test_the_last_library_wins(tmp_path: Path) -> None:
    documents = [library(demo={"executables": {"node": node(f"a/T{number}")}}) for number in range(3)]
    assert published(opened(tmp_path, *documents).executable("demo", "node")) == [("x", "a/T2")]


def test_unless_another_knows_better(tmp_path: Path) -> None:
    documents = [library(demo={"executables": {"node": node(f"a/{by.title()}", by)}}) for by in ("manual", "dynamic", "static")]
    assert published(opened(tmp_path, *documents).executable("demo", "node")) == [("x", "a/Manual")]


def test_a_users_library_comes_before_the_bundled_one(tmp_path: Path) -> None:
    mine = library(topic_tools={"executables": {"relay": executable(publishers=[{"name": "{arg:2|{arg:1}_relay}", "type": "a/Mine"}])}})
    found = opened(tmp_path, mine, bundled=True).executable("topic_tools", "relay")
    assert published(found) == [("{arg:2|{arg:1}_relay}", "a/Mine")]
    assert published(Library().executable("topic_tools", "relay")) == [("{arg:2|{arg:1}_relay}", "*")]


def test_what_is_not_known(tmp_path: Path) -> None:
    known = opened(tmp_path, library(demo={"executables": {"failed": {"status": "failed"}, "empty": {}}}))
    assert [known.executable("demo", name) for name in ("failed", "empty", "none")] == [None, None, None]
    assert (known.executable("none", "none"), known.nodelet("demo/None")) == (None, None)
    assert known.executables("demo") == ("empty", "failed")


def test_a_program_that_is_no_node_has_no_names(tmp_path: Path) -> None:
    found = opened(tmp_path, library(demo={"executables": {"tool": {"class": "none"}}})).executable("demo", "tool")
    assert found is not None
    assert (found.client, [(each.name, each.declarations) for each in found.variant(Node())]) == ("none", [("default", ())])


def test_like(tmp_path: Path) -> None:
    first = library(demo={"executables": {"a": {"like": "b"}, "b": {"like": "far/c"}}})
    second = library(far={"executables": {"c": {"like": "d"}, "d": node("a/D")}})
    known = opened(tmp_path, first, second)
    found = known.executable("demo", "a")
    assert found is not None
    assert (found.package, found.name, published(found)) == ("demo", "a", [("x", "a/D")])


def test_like_of_nodelets(tmp_path: Path) -> None:
    first = library(demo={"nodelets": {"demo/A": {"like": "far/B"}}})
    second = library(odd={"nodelets": {"far/B": node("a/B")}})
    assert published(opened(tmp_path, first, second).nodelet("demo/A")) == [("x", "a/B")]


@pytest.mark.parametrize("executables", [
    {"n0": {"like": "n0"}},
    {"n0": {"like": "n1"}, "n1": {"like": "demo/n0"}},
    {"n0": {"like": "nowhere"}},
    {"n0": {"like": "nowhere/n0"}},
    {**{f"n{number}": {"like": f"n{number + 1}"} for number in range(6)}, "n6": executable()},
])  # fmt: skip
def test_like_that_leads_nowhere(tmp_path: Path, executables: Any) -> None:
    assert opened(tmp_path, library(demo={"executables": executables})).executable("demo", "n0") is None


def test_a_circle_of_nodelets(tmp_path: Path) -> None:
    nodelets = {"demo/A": {"like": "demo/B"}, "demo/B": {"like": "demo/A"}}
    assert opened(tmp_path, library(demo={"nodelets": nodelets})).nodelet("demo/A") is None


def test_nodelets_and_names(tmp_path: Path) -> None:
    first = library(demo={"nodelets": {"demo/A": node("a/One", "static")}, "executables": {"n": executable()}})
    second = library(demo={"nodelets": {"demo/A": node("a/Two", "dynamic"), "demo/B": executable()}, "complete": ["nodelets"]}, other={})
    known = opened(tmp_path, first, second)
    assert published(known.nodelet("demo/A")) == [("x", "a/Two")]
    assert (known.nodelets("demo"), known.executables("demo"), known.packages()) == (("demo/A", "demo/B"), ("n",), ("demo", "other"))
    assert (known.has_all_nodelets("demo"), known.has_all_nodelets("other")) == (True, False)
    assert len(known.digests) == 2


def test_variants() -> None:
    fast, slow, never = ({"match": {"param": name}} for name in ("~fast", "~slow", "~never"))
    data = {"variants": {"default": {}, "1_fast": fast, "2_slow": slow, "3_never": never, "lost": {}}}
    found = program("demo", "node", data)

    def chosen(**params: Any) -> list[str]:
        return [variant.name for variant in found.variant(Node(params={f"~{name}": value for name, value in params.items()}))]

    assert chosen() == ["default"]
    assert chosen(slow=True) == ["2_slow"]
    assert chosen(fast=True, slow=True) == ["1_fast"]
    assert chosen(fast=UNKNOWN, slow=True) == ["1_fast", "2_slow"]
    assert chosen(slow=UNKNOWN) == ["2_slow", "default"]


@pytest.mark.parametrize(
    "name",
    [
        "",
        ".",
        "..",
        "../bundled/tf",
        "/etc/passwd",
        "tf\0",
        "tf.json",
        "index",
        "a/b",
        "x" * 300,
        "x" * 100_000,
        "größe",
        "tf\n",
        "\ud800",
        "-",
    ],
)
def test_hostile_packages(name: str) -> None:
    bundled = Bundled()
    assert bundled.package(name) is None
    assert bundled.package_of_class(name) is None
    assert bundled.package_of_class(f"{name}/Nodelet") is None
    assert Library().executable(name, name) is None


def test_the_bundled_library_is_read_package_by_package() -> None:
    bundled = Bundled()
    tf = bundled.package("tf")
    assert tf is not None
    assert "static_transform_publisher" in tf["executables"]
    assert {f"{name}.json" for name in bundled.names()} | {INDEX} == {path.name for path in Path(DIRECTORY).glob("*.json")}


def test_nodelet_classes_are_found(tmp_path: Path) -> None:
    """By the index where their name does not tell the package; also where its first part is a package that knows nothing of it."""
    files = {
        "demo": library(demo={"nodelets": {"demo/A": executable()}}),
        "far": library(far={"nodelets": {"demo/B": executable(), "Plain": executable()}}),
    }
    for name, document in files.items():
        written(tmp_path / f"{name}.json", document)
    (tmp_path / INDEX).write_text(json.dumps({"nodelets": {"demo/B": "far", "Plain": "far"}}))
    bundled = Bundled(directory=str(tmp_path))
    assert [bundled.package_of_class(name) for name in ("demo/A", "demo/B", "Plain", "demo/C")] == ["demo", "far", "far", None]


@pytest.mark.parametrize(
    ("name", "known"), [("amcl", True), ("zzyzx", False), ("index", False), ("../bundled/amcl", False), ("", False), ("a" * 300, False)]
)
def test_which_packages_the_shipped_library_knows(name: str, known: bool) -> None:
    assert is_in_library(name) is known


def test_what_a_distribution_removed() -> None:
    shipped = Library()
    assert shipped.removed("robot_state_publisher", "executables", "state_publisher") == {
        "in": "noetic",
        "instead": "robot_state_publisher",
    }
    assert shipped.removed("robot_state_publisher", "executables", "robot_state_publisher") is None
    assert shipped.removed("zzyzx", "executables", "zzyzx") is None


def test_a_library_of_ones_own_may_still_have_it(tmp_path: Path) -> None:
    own = library(robot_state_publisher={"executables": {"state_publisher": executable()}})
    assert opened(tmp_path, own, bundled=True).removed("robot_state_publisher", "executables", "state_publisher") is None


def test_which_lists_of_executables_are_whole(tmp_path: Path) -> None:
    found = opened(tmp_path, library(a={"complete": ["executables"]}, b={"complete": ["nodelets"]}))
    assert [found.has_all_executables(package) for package in ("a", "b", "c")] == [True, False, False]
