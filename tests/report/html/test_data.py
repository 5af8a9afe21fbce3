"""The data of a page against js/data.d.ts: all of it for one small repository, and what belongs to what."""

from __future__ import annotations

import json
import re
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from tests.cli.running import run, write
from tests.report.html.pages import data_of, page

DECLARATIONS = Path(__file__).resolve().parents[3] / "launchlint" / "report" / "html" / "js" / "data.d.ts"


def test_all_of_it(repository: Path, snapshot: Callable[[str, str], None]) -> None:
    data = data_of(page("--library", "library.json", "demo/launch/nav.launch"))
    data["version"] = "VERSION"
    snapshot("nav.json", json.dumps(data, indent=1, ensure_ascii=False) + "\n")


def declared() -> dict[str, dict[str, bool]]:
    """Interface of js/data.d.ts → its keys, and whether each must be there."""
    text = re.sub(r"/\*\*.*?\*/", "", DECLARATIONS.read_text(encoding="utf-8"), flags=re.DOTALL)
    bodies = re.findall(r"^export interface (\w+) \{\n(.*?)^\}", text, re.DOTALL | re.MULTILINE)
    return {name: {key: not mark for key, mark in re.findall(r"^  (\w+)(\??):", body, re.MULTILINE)} for name, body in bodies}


def test_the_declarations_are_true(repository: Path) -> None:
    data = data_of(page("--library", "library.json"))
    entries = data["entries"]
    found = {
        "ReportData": [data],
        "Finding": data["findings"],
        "Entry": entries,
        "Program": data["library"],
        "Container": [each for entry in entries for each in entry["containers"]],
        "Node": [each for entry in entries for each in entry["nodes"]],
        "Channel": [each for entry in entries for each in entry["channels"]],
        "Connection": [each for entry in entries for each in entry["connections"]],
        "Param": [each for entry in entries for each in entry["params"]],
        "Mend": [data["mend"], *(entry["mend"] for entry in entries)],
    }
    interfaces = declared()
    assert sorted(found) == sorted(interfaces)
    for name, items in found.items():
        assert items, name
        required = {key for key, must in interfaces[name].items() if must}
        assert {frozenset(item) for item in items} == {frozenset(required)}, name


def test_findings_stand_at_what_they_are_about(repository: Path) -> None:
    write(
        repository,
        {
            "demo/launch/wrong.launch": '<launch>\n<node name="a" pkg="demo" type="nothing.py"/>\n'
            '<node name="a" pkg="demo" type="talk.py"/>\n'
            '<node name="b" pkg="demo" type="listen.py"><param name="x y" value="1"/></node>\n</launch>\n'
        },
    )
    data = data_of(page("--library", "library.json", "--ignore", "LL7", "demo/launch/wrong.launch"))
    rules = [finding["rule"] for finding in data["findings"]]
    (entry,) = data["entries"]

    def at(items: Any) -> list[tuple[str, list[str]]]:
        return [(each["name"], [rules[index] for index in each["findings"]]) for each in items]

    assert at(entry["nodes"]) == [("/a", []), ("/a", ["LL301"]), ("/b", ["LL611", "LL507", "LL510"])]
    assert at(entry["channels"]) == [("/chatter", ["LL611"])]
    assert at(entry["params"]) == [("/b/x y", ["LL507", "LL510"])]
    assert entry["findings"] == list(range(len(rules)))


def test_what_the_launch_file_says_beside_the_graph(repository: Path) -> None:
    """Machines, settings that others override, findings that point at a node, the MD5 of types."""
    library = json.loads((repository / "library.json").read_text())
    publisher = library["packages"]["demo"]["executables"]["talk.py"]["variants"]["default"]["publishers"][0]
    publisher["md5"] = "992ce8a1687cec8c8bd883ec73ca41d1"
    write(
        repository,
        {
            "library.json": json.dumps(library),
            "demo/launch/more.launch": "<launch>\n"
            '<machine name="arm" address="10.0.0.2" env-loader="/env.sh"/>\n'
            '<param name="a/rate" value="1"/>\n'
            "<rosparam>{a: {rate: 2}}</rosparam>\n"
            '<node name="a" pkg="demo" type="talk.py" machine="arm"><param name="rate" value="3"/></node>\n'
            '<node name="b" pkg="demo" type="talk.py"/>\n'
            '<node name="b" pkg="demo" type="talk.py"/>\n'
            "</launch>\n",
        },
    )
    data = data_of(page("--library", "library.json", "--select", "LL301", "demo/launch/more.launch"))
    (entry,) = data["entries"]
    assert [(each["name"], each["machine"], each["findings"], each["related"]) for each in entry["nodes"]] == [
        ("/a", ["arm", "10.0.0.2"], [], []),
        ("/b", [], [], [0]),
        ("/b", [], [0], []),
    ]

    def told(param: Any) -> Any:
        return (param["name"], param["value"], param["place"][1], [(value, at[1]) for value, at in param["overrides"]])

    assert [told(each) for each in entry["params"]] == [("/a/rate", "3", 5, [("1", 3), ("2", 4)])]
    assert data["md5s"] == [["std_msgs/String", "992ce8a1687cec8c8bd883ec73ca41d1"]]


def test_a_finding_belongs_to_the_entries_that_reach_it(repository: Path) -> None:
    write(
        repository,
        {
            "demo/launch/first.launch": '<launch><include file="$(find demo)/launch/part.launch"/></launch>',
            "demo/launch/second.launch": "<launch/>",
            "demo/launch/part.launch": '<launch><node name="a" pkg="demo" type="talk.py" oops=""/></launch>',
        },
    )
    data = data_of(page("--select", "LL104"))
    assert [(data["files"][each["place"][0]], each["rule"]) for each in data["findings"]] == [("demo/launch/part.launch", "LL104")]
    assert {data["files"][each["file"]]: each["findings"] for each in data["entries"]} == {
        "demo/launch/first.launch": [0],
        "demo/launch/part.launch": [0],
        "demo/launch/nav.launch": [],
        "demo/launch/more.launch": [],
        "demo/launch/second.launch": [],
    }


def test_every_finding_of_check_is_on_the_page_and_at_an_entry(repository: Path) -> None:
    """Also what is told of a package, what one cause gives in files of different entries, and what only another entry evaluates."""
    wrong = '<launch><group if="$(eval arg(\'x\') == 7)"><node name="a" pkg="demo"/></group></launch>'
    write(
        repository,
        {
            "demo/launch/one.launch": '<launch><arg name="old"/><node name="a" pkg="turtlesim" type="turtlesim_node"/></launch>',
            "demo/launch/two.launch": '<launch><arg name="old"/><node name="a" pkg="turtlesim" type="turtlesim_node"/></launch>',
            "demo/launch/part.launch": wrong.replace("<launch>", '<launch><arg name="x" default="0"/>'),
            "demo/launch/seven.launch": '<launch>\n<include file="$(dirname)/part.launch"><arg name="x" value="7"/></include>\n</launch>',
            "broken/package.xml": "<package>",
        },
    )
    checked = json.loads(run(repository, "check", "--format", "json", "--exit-zero").output)
    data = data_of(page())

    def told(findings: Any) -> list[tuple[str, str, str]]:
        return [(each["rule"], each["severity"], each["message"]) for each in findings]

    assert told(data["findings"]) == told(checked["findings"])
    assert {rule for rule, _, _ in told(data["findings"])} >= {"LL105", "LL206", "LL701", "LL704"}
    assert {index for entry in data["entries"] for index in entry["findings"]} == set(range(len(data["findings"])))
    of_file = {data["files"][each["file"]]: [data["findings"][index]["rule"] for index in each["findings"]] for each in data["entries"]}
    assert "LL105" in of_file["demo/launch/part.launch"], "check of that file alone shows it, too"
    assert "LL701" in of_file["demo/launch/one.launch"]
    assert "LL701" in of_file["demo/launch/two.launch"]


def test_what_is_found_between_nodes_stands_at_the_group_or_include_around_it(repository: Path) -> None:
    part = '<launch>\n<arg name="unread" default="1"/>\n<node name="a" pkg="demo" type="talk.py"/>\n</launch>\n'
    write(
        repository,
        {
            "demo/launch/part.launch": part,
            "demo/launch/whole.launch": '<launch>\n<group ns="x">\n<node name="b" pkg="demo" type="talk.py" oops=""/>\n'
            '<include file="$(find demo)/launch/part.launch" oops=""/>\nwords\n</group>\n<wrong/>\n</launch>\n',
        },
    )
    data = data_of(page("--select", "LL103,LL104,LL107,LL206", "demo/launch/whole.launch"))
    (entry,) = data["entries"]
    rules = [f"{each['rule']}:{each['place'][1]}" for each in data["findings"]]
    at = {(each["kind"], each["label"]): [rules[index] for index in each["findings"]] for each in entry["containers"]}
    assert at == {("group", "/x"): ["LL107:5"], ("include", "demo/launch/part.launch"): ["LL206:2", "LL104:4"]}
    assert {each["name"]: [rules[index] for index in each["findings"]] for each in entry["nodes"]} == {"/x/a": [], "/x/b": ["LL104:3"]}
    assert len(entry["findings"]) == len(rules) == 5


def test_what_nobody_includes_comes_first_and_the_larger_before_the_smaller(repository: Path) -> None:
    write(repository, {"demo/launch/alone.launch": "<launch/>"})
    data = data_of(page())
    assert [data["files"][each["file"]] for each in data["entries"]] == [
        "demo/launch/nav.launch",
        "demo/launch/alone.launch",
        "demo/launch/more.launch",
    ]


def test_alternatives_of_one_name_have_each_their_own_connections(repository: Path) -> None:
    text = (
        '<launch><arg name="quiet" default="false"/>'
        '<node if="$(arg quiet)" name="a" pkg="demo" type="listen.py"/>'
        '<node unless="$(arg quiet)" name="a" pkg="demo" type="talk.py"/></launch>'
    )
    write(repository, {"demo/launch/either.launch": text})
    (entry,) = data_of(page("--library", "library.json", "demo/launch/either.launch"))["entries"]
    nodes = [(each["program"], [entry["configurations"][index] for index in each["only"]]) for each in entry["nodes"]]
    assert nodes == [("demo/listen.py", ["quiet:=true"]), ("demo/talk.py", [""])]
    connections = [(entry["nodes"][each["node"]]["program"], each["role"]) for each in entry["connections"]]
    assert connections == [("demo/talk.py", "publisher"), ("demo/listen.py", "subscriber")]


@pytest.mark.parametrize(("words", "programs"), [((), []), (("--library", "library.json"), ["demo/listen.py", "demo/talk.py"])])
def test_the_library_has_what_runs_and_what_was_given(repository: Path, words: tuple[str, ...], programs: list[str]) -> None:
    data = data_of(page(*words, "demo/launch/more.launch"))
    assert [f"{each['package']}/{each['name']}" for each in data["library"]] == programs


def test_the_share_of_known_nodes_is_that_of_check(repository: Path) -> None:
    write(
        repository,
        {"demo/launch/two.launch": '<launch><node name="a" pkg="away" type="x"/><node name="b" pkg="demo" type="talk.py"/></launch>'},
    )
    words = ("--library", "library.json", "demo/launch")
    data = data_of(page(*words))
    sight = json.loads(run(repository, "check", "--format", "json", *words).output)["sight"]
    assert (
        data["sight"]
        == [sight["known"], sight["nodes"]]
        == [sum(side) for side in zip(*(each["sight"] for each in data["entries"]), strict=True)]
    )
    for entry in data["entries"]:
        file = data["files"][entry["file"]]
        alone = json.loads(run(repository, "check", "--format", "json", "--library", "library.json", file).output)["sight"]
        assert entry["sight"] == [alone["known"], alone["nodes"]], file
        unknown = {each["program"] for each in entry["nodes"] if each["knowledge"] == "unknown"}
        assert unknown == {each["program"] for each in alone["unknown"]}


def test_one_command_and_one_sentence_make_all_known(repository: Path) -> None:
    nodes = "".join(f'<node name="n{number}" pkg="away{number % 2}" type="x{number}"/>' for number in range(4))
    mine = '<node name="m" pkg="demo" type="unknown.py"/><node name="o" pkg="demo" type="unknown.py"/>'
    write(repository, {"demo/launch/a b.launch": f"<launch>{nodes}{mine}</launch>", "demo/launch/away.launch": f"<launch>{nodes}</launch>"})
    (entry,) = data_of(page("demo/launch/a b.launch"))["entries"]
    assert entry["mend"] == {
        "command": "launchlint probe --unknown 'demo/launch/a b.launch'",
        "advice": "away0 and away1 are not in the workspace: put the sources there, or name their directory with --workspace, "
        "and launchlint reads them by itself",
    }
    assert [each["learn"] for each in entry["nodes"]] == ["probe", *["sources"] * 4, "probe"]
    (entry,) = data_of(page("demo/launch/away.launch"))["entries"]
    assert entry["mend"]["command"] == ""
    assert data_of(page("demo/launch"))["mend"]["command"] == "launchlint probe --unknown demo/launch"
    assert data_of(page("--library", "library.json", "demo/launch/nav.launch"))["mend"]["advice"] == ""


def test_who_may_be_where_nobody_is_known(repository: Path) -> None:
    talk, unknown = '<node name="talk" pkg="demo" type="talk.py"/>', '<node name="u" pkg="demo" type="unknown.py"/>'
    write(
        repository,
        {
            "demo/launch/sure.launch": f'<launch><group ns="near">{talk}</group><group ns="far">{unknown}</group></launch>',
            "demo/launch/doubtful.launch": f"<launch>{talk}{unknown}</launch>",
        },
    )
    may = {}
    for name in ("sure", "doubtful"):
        (entry,) = data_of(page("--library", "library.json", f"demo/launch/{name}.launch"))["entries"]
        may[name] = {each["name"]: each["may"] for each in entry["channels"]}
    assert may["doubtful"] == {"/chatter": [[False, "/u", True, ""]]}
    assert may["sure"] == {"/near/chatter": []}


def test_names_that_are_known_only_in_part(repository: Path) -> None:
    library = json.loads((repository / "library.json").read_text())
    publishers = library["packages"]["demo"]["executables"]["talk.py"]["variants"]["default"]["publishers"]
    publishers.append({"name": "~global_costmap/{any}", "type": "std_msgs/String"})
    launch = '<launch><node name="nav" pkg="demo" type="talk.py"/></launch>'
    write(repository, {"library.json": json.dumps(library), "demo/launch/part.launch": launch})
    (entry,) = data_of(page("--library", "library.json", "demo/launch/part.launch"))["entries"]
    assert [each["partly"] for each in entry["nodes"]] == [[["publishers", "/nav/global_costmap/*"]]]
