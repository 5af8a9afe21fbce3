"""A page that is written over a former one: what is new says so, so that nothing else moves."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest

from launchlint.report.html.late import mark_late
from tests.report.html.pages import data_of, page

NODE = '<node name="{}" pkg="demo" type="talk.py"/>'


@pytest.fixture
def launch(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.chdir(tmp_path)
    (tmp_path / "package.xml").write_text("<package><name>demo</name><version>1.0.0</version></package>")
    file = tmp_path / "main.launch"
    file.write_text(f"<launch>{''.join(NODE.format(f'n{number}') for number in range(8))}\n</launch>")
    return file


def late() -> dict[str, int]:
    """The nodes that came late, with their turns."""
    [entry] = data_of(page("main.launch"))["entries"]
    return {each["name"]: each["late"] for each in entry["nodes"] if "late" in each}


def add(launch: Path, name: str) -> None:
    launch.write_text(launch.read_text().replace("<launch>", f"<launch>{NODE.format(name)}"))


def test_each_in_its_turn_until_too_much_is_new(launch: Path) -> None:
    assert late() == {}
    add(launch, "a")
    assert late() == {"/a": 1}
    again = page("main.launch")
    assert page("main.launch") == again
    add(launch, "z")
    assert late() == {"/a": 1, "/z": 2}
    add(launch, "b")
    add(launch, "c")
    assert late() == {}


def test_a_page_somewhere_else_knows_nothing_of_it(launch: Path) -> None:
    first = page("main.launch")
    Path("page.html").rename("elsewhere.html")
    assert page("main.launch") == first
    add(launch, "a")
    Path("page.html").unlink()
    assert late() == {}


TABLE = '{"files":["main.launch"],"entries":[{"file":0}]}'
WORD = '{"nodes":[{"name":"/a","late":"x"}],"channels":[],"connections":[]}'
ROWS = '{"$rows":1000000000,"columns":{"name":{"$all":"/a"}}}'


@pytest.mark.parametrize(
    "former",
    [
        "",
        "<html></html>",
        '<script type="application/json" id="launchlint-data">{</script>',
        '<script type="application/json" id="launchlint-data">[]\n1\n</script>',
        f'<script type="application/json" id="launchlint-data">{"[" * 100_000}</script>',
        f'<script type="application/json" id="launchlint-data">{TABLE}\n{{"nodes":{ROWS},"channels":[],"connections":[]}}\n</script>',
        f'<script type="application/json" id="launchlint-data">{TABLE}\n{WORD}\n</script>',
    ],
    ids=["empty", "other", "half", "list", "deep", "endless", "word"],
)
def test_what_is_no_page_is_none(former: str) -> None:
    node: dict[str, Any] = {"name": "/n"}
    entry = {"file": 0, "nodes": [node] * 8, "channels": [], "connections": []}
    mark_late({"base": None, "files": ["main.launch"], "entries": [entry]}, former)
    assert node == {"name": "/n"}
