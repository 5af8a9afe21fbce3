"""The page: its parts, what it allows, and what it says where there is nothing to show."""

from __future__ import annotations

import re
from base64 import b64encode
from hashlib import sha256
from pathlib import Path

import pytest

from launchlint.report.html.page import SCRIPTS
from tests.bench.report import write_launch
from tests.report.html.pages import Elements, data_of, page


def hashes(texts: list[str]) -> str:
    return " ".join(f"'sha256-{b64encode(sha256(text.encode()).digest()).decode()}'" for text in texts)


def policy(elements: Elements) -> str:
    return next(
        str(attributes["content"]) for tag, attributes in elements.found if attributes.get("http-equiv") == "Content-Security-Policy"
    )


def text_of(html: str, id_: str) -> str:
    """The text of the table (or other element) of this id, cells with a bar between them, one line for each row."""
    body = re.search(rf'<(\w+)[^>]*id="{id_}"[^>]*>(.*?)</\1>', html, re.DOTALL)
    assert body is not None, id_
    rows = re.split(r"<tr\b[^>]*>", body[2])
    cells = ([re.sub(r"<[^>]+>", "", cell).strip() for cell in re.split(r"<t[dh]\b[^>]*>", row)[1:]] for row in rows)
    return "\n".join(" | ".join(row) for row in cells if row)


def test_skeleton(repository: Path) -> None:
    elements = Elements(page("--library", "library.json"))
    assert elements.ids() == [
        "bar", "verdict", "counts", "controls", "pages", "tree", "stage", "landing", "drawing", "overview", "panel", "tables",
        "table-findings", "findings-0", "table-nodes", "table-topics", "table-params", "unknown", "table-unknown", "library", "program-0",
        "program-1", "foot", "launchlint-data",
    ]  # fmt: skip


def test_tables_say_all_without_scripts(repository: Path) -> None:
    html = page("--library", "library.json", "demo/launch/nav.launch")
    assert text_of(html, "table-nodes") == (
        "Node | Program | Known | Place | Findings\n"
        "/driver | demo/unknown.py | unknown | demo/launch/more.launch:2 | \n"
        "/robot/listener | demo/listen.py | known | demo/launch/nav.launch:8 | 1\n"
        "/robot/talker | demo/talk.py | known | demo/launch/nav.launch:4 | "
    )
    assert text_of(html, "table-topics") == (
        "Topic | Type | Publishers | Subscribers\n/robot/news | std_msgs/Int32, std_msgs/String | /robot/talker | /robot/listener"
    )
    assert text_of(html, "table-params") == (
        "Param | Value | Place | Overrides | Read by\n/robot/talker/rate | 5 | demo/launch/nav.launch:5 |  | /robot/talker"
    )
    assert text_of(html, "table-findings").splitlines()[1] == (
        "warning | LL611 type-mismatch | /robot/talker publishes /robot/news as std_msgs/String, but /robot/listener subscribes to it as "
        "std_msgs/Int32 | demo/launch/nav.launch:9 | give one of the two another name, or put a node between them that converts"
    )
    assert text_of(html, "table-unknown") == (
        "Program | Nodes | Why | What helps\ndemo/unknown.py | 1 | it is a script, but not Python | the command above"
    )


def test_the_policy_allows_what_is_in_the_page_and_nothing_else(repository: Path) -> None:
    elements = Elements(page())
    data, *scripts = elements.scripts
    assert data.startswith("{")
    assert len(scripts) == len(SCRIPTS)
    assert policy(elements) == (
        f"default-src 'none'; style-src {hashes(elements.styles)}; script-src {hashes(scripts)}; base-uri 'none'; form-action 'none'"
    )
    assert [
        attributes for _, attributes in elements.found if "style" in attributes or any(name.startswith("on") for name in attributes)
    ] == []


def test_separate_assets(repository: Path) -> None:
    html = page("--separate-assets")
    elements = Elements(html)
    assert policy(elements) == "default-src 'none'; style-src 'self'; script-src 'self'; base-uri 'none'; form-action 'none'"
    linked = [attributes.get("src") or attributes["href"] for tag, attributes in elements.found if tag == "link" or "src" in attributes]
    assert linked == ["page.style.css", "page.elk.js", "page.report.js"]
    assert sorted(path.name for path in repository.glob("page.*")) == ["page.elk.js", "page.html", "page.report.js", "page.style.css"]
    inline = page()
    for name in linked:
        assert (repository / str(name)).read_text(encoding="utf-8") in inline


def test_nothing_of_this_machine_shows(repository: Path) -> None:
    (repository / "demo" / "launch" / "path.launch").write_text(
        '<launch><param name="map" value="$(find demo)/maps/a.yaml"/><param name="ws" command="cat $(find demo)/x"/></launch>',
        encoding="utf-8",
    )
    html = page("--library", "library.json")
    assert str(repository) not in html
    assert [(each["name"], each["value"]) for entry in data_of(html)["entries"] for each in entry["params"]] == [
        ("/robot/talker/rate", "5"),
        ("/map", "./demo/maps/a.yaml"),
        ("/ws", "output of: cat ./demo/x"),
    ]


def test_links_to_the_forge(repository: Path) -> None:
    html = page("--source-url", "https://example.org/tree", "--library", "library.json")
    assert '<a href="https://example.org/tree/demo/launch/nav.launch#L9">demo/launch/nav.launch:9</a>' in html


def test_no_launch_file(repository: Path) -> None:
    (repository / "empty").mkdir()
    html = page("empty")
    assert "There is no launch file to show." in html
    assert data_of(html)["entries"] == []


def test_no_nodes_and_refused(repository: Path) -> None:
    file = repository / "demo" / "launch" / "bad.launch"
    file.write_text("<launch>", encoding="utf-8")
    html = page(str(file.relative_to(repository)))
    assert "Nothing to draw: no node is started. roslaunch refuses demo/launch/bad.launch: " in html


def test_a_package_that_is_not_on_this_machine_is_no_refusal(repository: Path) -> None:
    file = repository / "demo" / "launch" / "away.launch"
    file.write_text(
        '<launch><include file="$(find turtlebot3_bringup)/launch/robot.launch"/><node name="a" pkg="demo" type="talk.py"/></launch>',
        encoding="utf-8",
    )
    (entry,) = data_of(page(str(file.relative_to(repository))))["entries"]
    assert (entry["verdict"], entry["why"], entry["complete"]) == ("cannot be told", "it needs the package turtlebot3_bringup", False)


def test_nobody_says_that_no_nodes_are_started_where_that_is_not_known(repository: Path) -> None:
    for name, gives in (("open", "somewhere.actions()"), ("empty", "[]")):
        program = (
            "import somewhere\nfrom launch import LaunchDescription\n\n\n"
            f"def generate_launch_description():\n    return LaunchDescription({gives})\n"
        )
        (repository / "demo" / "launch" / f"{name}.launch.py").write_text(program, encoding="utf-8")
    html = page("demo/launch/open.launch.py", "demo/launch/empty.launch.py")
    assert "Nothing to draw: which nodes are started is not known." in html
    assert "Nothing to draw: no node is started." in page("demo/launch/empty.launch.py")
    opened, empty = sorted(html.split('<li class="card')[1:], key=lambda card: "open.launch.py" not in card)
    assert 'class="no-picture">no nodes known<' in opened
    assert "not all could be followed" in opened
    assert 'class="no-picture">no nodes<' in empty
    assert "not all could be followed" not in empty.partition("</li>")[0]


def test_a_page_about_fifty_nodes_is_small(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path / "cache"))
    write_launch(tmp_path, 50)
    html = page("main.launch", "--library", "library.json")
    assert [len(entry["nodes"]) for entry in data_of(html)["entries"]] == [50]
    assert len(html.encode()) <= 2_200_000


@pytest.mark.parametrize(("namespace", "said"), [("/", "nobody here, but /u (not known) may"), ("/far", "nobody")])
def test_tables_say_nobody_with_the_doubt_that_is_there(namespace: str, said: str, repository: Path) -> None:
    unknown = f'<node name="u" ns="{namespace}" pkg="demo" type="unknown.py"/>'
    talk = '<node name="talk" ns="near" pkg="demo" type="talk.py"/>'
    (repository / "demo" / "launch" / "doubt.launch").write_text(f"<launch>{unknown}{talk}</launch>", encoding="utf-8")
    html = page("--library", "library.json", "demo/launch/doubt.launch")
    assert text_of(html, "table-topics").splitlines()[1] == f"/near/chatter | std_msgs/String | /near/talk | {said}"
    assert "1 of 2 nodes known." in html
    assert (
        '<pre class="command" tabindex="0" role="group" aria-label="Command">launchlint probe --unknown demo/launch/doubt.launch</pre>'
        in html
    )
