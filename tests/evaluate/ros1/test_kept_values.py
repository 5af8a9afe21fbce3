"""A value is worked out once for all configurations; it is what it is in a session of its own, and what was wrong with it is told again."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from launchlint.evaluate.ros1.kept_values import MOST_KEPT
from launchlint.evaluate.ros1.launch import evaluate
from launchlint.evaluate.session import Session
from launchlint.model import Launch
from launchlint.report.model import as_object
from tests.evaluate.comparison import MAIN, case, session_in, write

PACKAGE = "<package><name>here</name></package>"
LAUNCH = """
<arg name="mode" default="sim"/>
<arg name="count" default="2"/>
<arg name="site"/>
<arg name="shown" value="$(eval mode + '_' + str(count * 2))"/>
<param name="both" value="$(arg mode) and $(arg count)"/>
<param name="later" value="$(arg mode)_$(arg later)"/>
<param name="home" value="$(env HOME)/$(arg mode)"/>
<param name="unset" value="$(env NOBODY_SETS_THIS)/$(arg mode)"/>
<param name="site" value="at $(arg site)"/>
<group if="$(eval mode == 'sim')">[[$(anon talker)]] [[of_$(arg shown)]]</group>
<group unless="$(eval mode == 'sim')">
  [[real | <param name="p" value="$(find here)/$(arg mode)"/>]]
  <include file="$(find nowhere)/$(arg mode).launch"/>
</group>
<group if="$(arg site)"><include file="$(find nowhere)/$(arg mode).launch"/></group>
<include file="$(dirname)/part.launch"><arg name="shown" value="$(arg shown)"/></include>
<include file="$(dirname)/lacking.launch"/>
<include file="$(dirname)/lacking.launch"><arg name="mode" value="$(arg mode)"/></include>
"""
LACKING = """
<arg name="mode" default="none"/>
<arg name="address"/>
<arg name="port"/>
<arg name="user"/>
<param name="a" value="to $(arg address)" unless="$(eval mode == 'real')"/>
<param name="b" value="to $(arg address)"/>
<param name="c" value="$(eval 'at ' + port)" unless="$(eval mode == 'real')"/>
<param name="d" value="$(eval 'at ' + port)"/>
<param name="e" value="$(eval arg('us' + 'er'))"/>
"""
PART = '<arg name="shown"/><param name="$(arg shown)" value="$(eval shown.upper())$(arg"/><remap from="a" to="b$(arg shown)"/>[[x]]'
CONFIGURATIONS: tuple[tuple[tuple[str, str], ...], ...] = (
    (),
    (("mode", "real"),),
    (("mode", "real"), ("site", "true")),
    (("count", "3"),),
    (("mode", "$(find nowhere)"),),
    (("count", "many"), ("site", "false")),
)


def told(launch: Launch) -> list[tuple[Any, ...]]:
    return [
        (problem.kind, problem.refused, problem.assumed, problem.place.source.path, problem.place.span, len(problem.origin.chain))
        for problem in launch.problems
    ]


def model(session: Session, file: str, given: tuple[tuple[str, str], ...]) -> tuple[Any, list[tuple[Any, ...]]]:
    launch = evaluate(session, file, given).launch
    return as_object(launch, file, None), told(launch)


def test_every_configuration_is_as_in_a_session_of_its_own(tmp_path: Path) -> None:
    files = {"part.launch": PART, "lacking.launch": LACKING, "here/package.xml": PACKAGE}
    write(case(LAUNCH, files=files), tmp_path)
    file = str(tmp_path / MAIN)
    shared = session_in(tmp_path)
    for given in (*CONFIGURATIONS, *reversed(CONFIGURATIONS)):
        assert model(shared, file, given) == model(session_in(tmp_path), file, given)
    values = {
        attribute.value: sorted(map(str, (kept.value for kept in known.values.values()))) for attribute, known in shared.values.items()
    }
    assert values["$(arg mode) and $(arg count)"] == [
        "Unknown('$(arg mode) and $(arg count)', 'the package nowhere is not here')",
        "real and 2",
        "sim and 2",
        "sim and 3",
        "sim and many",
    ]
    assert values["$(find here)/$(arg mode)"] == [
        f"{tmp_path}/here/real",
        "Unknown('$(find here)/$(arg mode)', 'the package nowhere is not here')",
    ]
    assert values["$(arg mode)_$(arg later)"] == values["$(env HOME)/$(arg mode)"] == values["$(anon talker)"] == []


def test_what_is_kept_of_one_attribute_is_bounded(tmp_path: Path) -> None:
    write(case('<arg name="a" default="1"/><param name="p" value="is $(arg a)"/>'), tmp_path)
    session = session_in(tmp_path)
    for number in range(2 * MOST_KEPT + 5):
        evaluate(session, str(tmp_path / MAIN), (("a", str(number)),))
    assert [len(known.values) for known in session.values.values()] == [5]
