"""The params that templates and conditions see."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest

from launchlint.graph.parameters import Parameters
from launchlint.library.template import UNKNOWN
from tests.graph.sample import graph

LAUNCH = """
<param name="/a" value="1"/>
<param name="/b/c" value="text"/>
<param name="/b/d/e" value="true"/>
<rosparam param="/m">{x: {y: [1, 2]}, z: 5}</rosparam>
<rosparam param="/l">[1, 2]</rosparam>
<param name="/command" command="date"/>
<group ns="open"><rosparam command="load" file="$(optenv NOT_HERE)/x.yaml"/></group>
"""


def parameters(directory: Path, launch: str = LAUNCH) -> Parameters:
    found = graph(directory, launch, {}).launch
    return Parameters(found.parameters, found.more_parameters)


@pytest.mark.parametrize(
    ("name", "value"),
    [
        ("/a", 1),
        ("/b/c", "text"),
        ("/b", {"c": "text", "d": {"e": True}}),
        ("/b/d", {"e": True}),
        ("/m", {"x": {"y": [1, 2]}, "z": 5}),
        ("/m/x", {"y": [1, 2]}),
        ("/m/x/y", [1, 2]),
        ("/m/x/q", None),
        ("/l", [1, 2]),
        ("/l/x", None),
        ("/missing", None),
        ("/a/below", None),
        ("/command", UNKNOWN),
    ],
)
def test_value(name: str, value: Any, tmp_path: Path) -> None:
    assert parameters(tmp_path).value(name) == value


def test_what_is_set(tmp_path: Path) -> None:
    found = parameters(tmp_path)
    assert [name for name in ("/a", "/b", "/b/d", "/m/x", "/m/q", "/missing") if found.is_set(name)] == ["/a", "/b", "/b/d", "/m/x"]
    assert list(found.below("/b")) == ["/b/c", "/b/d/e"]
    setting = found.setting("/a")
    assert setting is not None
    assert setting.value == 1
    assert found.setting("/b") is None


@pytest.mark.parametrize(("name", "known"), [("/open/x", False), ("/open", False), ("/opener", True), ("/elsewhere", True)])
def test_a_namespace_with_more(name: str, known: bool, tmp_path: Path) -> None:
    found = graph(tmp_path, "", {}).launch
    assert (Parameters(found.parameters, ["/open/"]).value(name) is None) == known
