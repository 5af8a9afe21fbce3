"""Lists of objects as columns: what is written, and that nothing is lost."""

from __future__ import annotations

import json
from typing import Any

import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from launchlint.report.html.pack import PARTS, packed, script
from tests.report.html.pages import unpacked


@pytest.mark.parametrize(
    ("value", "written"),
    [
        ({"a": [1, "x", None]}, '{"a":[1,"x",null]}'),
        ([{"a": 1}], '[{"a":1}]'),
        ([{"a": 1}, {"a": 1}], '{"$rows":2,"columns":{"a":{"$all":1}}}'),
        ([{"a": 1}, {"a": 2}], '{"$rows":2,"columns":{"a":[1,2]}}'),
        ([{"a": False}, {"a": True}, {"a": True}], '{"$rows":3,"columns":{"a":[false,true,true]}}'),
        (
            [{"a": flag} for flag in [False, True] * 4],
            '{"$rows":8,"columns":{"a":{"$of":[false,true],"$at":"01010101"}}}',
        ),
        ([{"a": 1, "b": 2}, {"a": 1}], '{"$rows":2,"columns":{"a":{"$all":1},"b":{"$of":[2],"$at":"0."}}}'),
        (
            [{"a": "/robot/camera/image"}, {"a": "/robot/camera/info"}, {"a": "/robot/scan"}],
            '{"$rows":3,"columns":{"a":{"$front":["0/robot/camera/image","Fnfo","7scan"]}}}',
        ),
    ],
)  # fmt: skip
def test_what_is_written(value: Any, written: str) -> None:
    assert packed(value) == written
    assert unpacked(json.loads(written)) == value


CELLS = st.one_of(
    st.none(), st.booleans(), st.integers(-3, 300), st.text("/ab😀\u2028<$"), st.lists(st.text("ab"), max_size=2), st.just({"x": 1})
)
ROWS = st.lists(st.fixed_dictionaries({"name": st.text("/ab😀é", max_size=20)}, optional={"mark": CELLS, "only": CELLS}), max_size=20)


@settings(deadline=None, suppress_health_check=[HealthCheck.too_slow])  # the machine may be busy
@given(ROWS)
def test_nothing_is_lost(rows: list[dict[str, Any]]) -> None:
    value = {"entries": [{"nodes": rows}, {"nodes": rows[:1]}], "title": "x"}
    assert unpacked(json.loads(packed(value))) == value


def test_many_values_and_long_common_beginnings() -> None:
    long = "/robot" * 30
    rows = [{"name": f"{long}{number % 70}", "kind": number % 70, "pair": [number % 70, long]} for number in range(300)]
    text = packed(rows)
    assert unpacked(json.loads(text)) == rows
    assert text.startswith('{"$rows":300,"columns":{"name":{"$of":{"$front":["0/robot/robot')


def test_nothing_can_end_the_script_element() -> None:
    value = {"name": "</script><!--&\u2028\u2029", "entries": [], "library": []}
    written, library = script(value).split("\n")
    assert written == '{"name":"\\u003c/script\\u003e\\u003c!--\\u0026\\u2028\\u2029","entries":[]}'
    assert json.loads(written) == {"name": value["name"], "entries": []}
    assert library == "[]"


def test_what_is_read_later_stands_in_lines_of_its_own() -> None:
    parts: dict[str, Any] = {part: [{"name": f"line\nof {part}"}] for part in PARTS}
    data = {"title": "x", "entries": [{"file": 0, **parts}, {"file": 1, **parts}], "library": [{"name": "p"}, {"name": "q"}]}
    head, first, second, library = script(data).split("\n")
    assert unpacked(json.loads(head)) == {"title": "x", "entries": [{"file": 0}, {"file": 1}]}
    assert unpacked(json.loads(first)) == unpacked(json.loads(second)) == parts
    assert unpacked(json.loads(library)) == data["library"]
