"""The picture of a change: what is in it, that nothing in it overlaps, and that no name becomes markup."""

from __future__ import annotations

import struct
from collections.abc import Iterator
from pathlib import Path
from xml.etree import ElementTree

import pytest

from launchlint.errors import UsageError
from launchlint.report.graph.drawing import Arrow, Box, Drawing
from launchlint.report.picture import browser
from launchlint.report.picture.layers import layered
from launchlint.report.picture.sheet import sheet
from launchlint.report.picture.thumbnail import thumbnail
from launchlint.report.picture.vector import Section, svg

SVG = "{http://www.w3.org/2000/svg}"


def drawing(*arrows: tuple[str, str], alone: int = 0, mark: str = "") -> Drawing:
    names = dict.fromkeys([*(end for arrow in arrows for end in arrow), *(f"alone{number}" for number in range(alone))])
    boxes = tuple(Box(name, "", "node", name, "demo/talk") for name in names)
    return Drawing(boxes, tuple(Arrow(source, target, "topic", (f"/{source}",), mark=mark) for source, target in arrows), "")


def overlapping(areas: list[tuple[float, float, float, float]]) -> Iterator[tuple[object, object]]:
    for number, (left, top, width, height) in enumerate(areas):
        for other in areas[number + 1 :]:
            if left < other[0] + other[2] and other[0] < left + width and top < other[1] + other[3] and other[1] < top + height:
                yield areas[number], other


CHAIN = [("a", "b"), ("b", "c"), ("a", "c"), ("c", "d")]
CYCLE = [("a", "b"), ("b", "c"), ("c", "a"), ("b", "a")]
MANY = [(f"n{one}", f"n{(one * 7 + 3) % 20}") for one in range(20)] + [(f"n{one}", f"n{(one * 3 + 1) % 20}") for one in range(20)]


@pytest.mark.parametrize("arrows", [[], CHAIN, CYCLE, MANY, [("a", "a")]])
def test_nothing_overlaps(arrows: list[tuple[str, str]]) -> None:
    placed = sheet(drawing(*arrows, alone=30), lambda _: (100.0, 40.0), lambda _: (60.0, 18.0))
    areas = [(*place, *size) for _, place, size in (*placed.boxes, *placed.names)]
    assert list(overlapping(areas)) == []
    assert all(x >= 0 and x + width <= placed.width and y >= 0 and y + height <= placed.height for x, y, width, height in areas)


def test_arrows_point_to_the_right_but_for_those_that_close_a_cycle() -> None:
    sizes = dict.fromkeys("abcd", (10.0, 10.0))
    found = layered(sizes, [*CHAIN, ("d", "a")], 20, 10)
    ends = [line[-1][0] > line[0][0] for line in found.lines]
    assert ends == [True, True, True, True, False]
    assert [found.places[box][0] for box in "abcd"] == [0.0, 30.0, 60.0, 90.0]


def test_a_long_arrow_goes_around_what_is_between() -> None:
    found = layered(dict.fromkeys("abc", (10.0, 10.0)), [("a", "b"), ("b", "c"), ("a", "c")], 20, 10)
    top = found.places["b"][1]
    assert all(not top <= y <= top + 10 for x, y in found.lines[2] if 30 <= x <= 40)


def test_what_is_said_and_marked() -> None:
    changed = drawing(("a", "b"), mark="removed")
    text = svg([Section("x.launch", ["one connection lost"], changed)], compared=True, more=2)
    root = ElementTree.fromstring(text)
    assert [each.text for each in root.iter(f"{SVG}text")] == [
        *("gone", "x.launch", "one connection lost", "/a", "a", "demo/talk", "b", "demo/talk", "and 2 more launch files"),
    ]
    assert {each.get("class") for each in root.iter(f"{SVG}path")} == {"line removed", "head h-removed"}


def test_names_are_text() -> None:
    name = '<script>alert(1)</script>" onload="x\u202e'
    text = svg([Section(name, [name], Drawing((Box(name, f"namespace {name}", "node", name, name),), (), name))])
    root = ElementTree.fromstring(text)
    assert {each.tag.removeprefix(SVG) for each in root.iter()} <= {"svg", "title", "style", "rect", "text", "g", "path"}
    assert not any(key.startswith("on") for each in root.iter() for key in each.attrib)
    assert "\u202e" not in text
    assert "<text" not in thumbnail(drawing((name, "b")))


def test_without_a_browser_there_is_one_clear_message(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    monkeypatch.setenv("PATH", str(tmp_path))
    with pytest.raises(UsageError, match=r"a PNG is drawn by a browser, and none is here .*; write an \.svg instead"):
        browser.png(svg([Section("x", (), drawing())]))


@pytest.mark.chromium
def test_a_browser_draws_it() -> None:
    text = svg([Section("x.launch", (), drawing(("a", "b")))])
    size = ElementTree.fromstring(text)
    data = browser.png(text)
    assert data[:8] == b"\x89PNG\r\n\x1a\n"
    assert struct.unpack(">II", data[16:24]) == tuple(browser.SCALE * int(size.attrib[name]) for name in ("width", "height"))
