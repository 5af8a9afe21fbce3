"""The frames of one node: templates, conditions, and the param that says a name."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest

from launchlint.graph.frames import Frame
from tests.graph.sample import graph, program

ODOM: dict[str, Any] = {"name": "{param:~odom|{param:~old_odom|odom}}", "role": "child", "parent": "{param:~map|map}"}


def frames(directory: Path, entries: list[dict[str, Any]], attributes: str = "", inside: str = "") -> tuple[Frame, ...]:
    """Those of the node ``/ns/n``."""
    launch = f'<node pkg="p" type="t" name="n" ns="ns" {attributes}>{inside}</node>'
    return graph(directory, launch, {"p": {"executables": {"t": program(frames=entries)}}}).instances[0].frames


@pytest.mark.parametrize(
    ("entry", "attributes", "inside", "expected"),
    [
        (ODOM, "", "", [Frame("child", "odom", "map")]),
        (ODOM, "", '<param name="odom" value="/o"/>', [Frame("child", "/o", "map", "/ns/n/odom")]),
        (ODOM, "", '<param name="old_odom" value="o"/><param name="map" value="m"/>', [Frame("child", "o", "m", "/ns/n/old_odom")]),
        (ODOM, "", '<param name="odom" command="which"/>', [Frame("child", "", "map", "/ns/n/odom")]),
        ({"name": "{arg:2}", "role": "child", "parent": "{arg:1}"}, 'args="a b"', "", [Frame("child", "b", "a")]),
        ({"name": "{arg:2}", "role": "child", "parent": "{arg:1}"}, 'args="a"', "", []),
        ({"name": "map", "role": "used", "through": "tf2"}, "", "", [Frame("used", "map", through="tf2")]),
        ({"name": "map", "role": "used", "condition": {"param": "~x"}}, "", "", []),
        ({"name": "map", "role": "used", "condition": {"text": "if (x)"}}, "", "", [Frame("used", "map", certain=False)]),
        ({"name": "{any}", "role": "child", "urdf": "robot"}, "", "", [Frame("child", "", urdf="/ns/robot")]),
    ],
)
def test_frame(entry: dict[str, Any], attributes: str, inside: str, expected: list[Frame], tmp_path: Path) -> None:
    assert list(frames(tmp_path, [entry], attributes, inside)) == expected
