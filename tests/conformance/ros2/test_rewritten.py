"""Random workspaces after the commands that must not change what they mean."""

from __future__ import annotations

from collections import Counter
from pathlib import Path

import pytest

from launchlint.fix.format.formatting import Formatted
from launchlint.fix.format.style import Style
from tests.conformance.ros2 import rewritten
from tests.conformance.ros2.front_end import WHY_NOT, front_end


def test_what_is_launched_stays() -> None:
    judged = rewritten.judged(range(4_000_000, 4_000_080), None)
    assert [each for each in judged if each.difference] == []
    done = Counter(each.command.split(" of ")[0] for each in judged)
    assert done.keys() == {"format", "fix", "to xml", "to yaml", "flatten"}
    assert min(done.values()) > 8


@pytest.mark.slow
def test_what_ros2_launch_starts_stays() -> None:
    real = front_end(rewritten.DISTRO)
    if real is None:
        pytest.skip(WHY_NOT)
    judged = rewritten.judged(range(4_100_000, 4_100_040), real)
    assert [each for each in judged if each.difference] == []
    assert sum(each.command.endswith(rewritten.BY_LAUNCH) for each in judged) > 60


def test_a_change_is_seen(monkeypatch: pytest.MonkeyPatch) -> None:
    def without_nodes(data: bytes, path: str, style: Style) -> Formatted:
        return Formatted(data.replace(b'name="n', b'name="m').replace(b'"name": "n', b'"name": "m'))

    monkeypatch.setattr(rewritten, "formatted", without_nodes)
    judged = rewritten.judged(range(4_000_000, 4_000_030), None)
    assert sum(bool(each.difference) for each in judged if each.command == "format") > 3
    assert not any(each.difference for each in judged if each.command == "flatten")


def test_where_a_workspace_stands_does_not_count() -> None:
    sides = [
        rewritten.compared({"verdict": "ok", "nodes": [{"file": f"/tmp/{name}/pk/a.launch.{end}"}]}, "to yaml", f"pk/a.launch.{end}",
                           Path(f"/tmp/{name}"))
        for name, end in (("w1", "xml"), ("w1x2", "yaml"))
    ]  # fmt: skip
    assert sides[0] == sides[1]
    assert rewritten.first_difference({"a": [1, {"b": 1}]}, {"a": [1, {"b": True}]}) == ".a[1].b: before 1, after True"
