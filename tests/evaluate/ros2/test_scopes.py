"""What a launch file in Python keeps and puts back by itself, as groups do; and what is known where it may not have done so."""

from __future__ import annotations

from itertools import product
from pathlib import Path
from typing import Any

import pytest

from launchlint.evaluate.ros2.launch import evaluate
from launchlint.evaluate.ros2.repeating import Repeats
from launchlint.evaluate.session import Session
from launchlint.report.launched import as_object
from launchlint.workspace.packages import Packages
from tests.conformance.ros2.random_program import HEAD, RandomProgram
from tests.evaluate.ros2.launching import ENVIRONMENT, PACKAGE

DOUBTFUL = "Command('decide')"


def stated(file: Path, given: tuple[tuple[str, str], ...] = (), repeats: Repeats | None = None) -> dict[str, Any]:
    """The model of a launch file in a package below the directory three above it."""
    root = str(file.parents[2])
    session = Session(Packages([root], ENVIRONMENT, explicit=True), ENVIRONMENT, root, distro="jazzy")
    launch = evaluate(session, str(file), given, repeats=repeats).launch
    return dict(as_object(launch, str(file), None if launch.refused is None else ("", launch.refused.kind)))


def written(directory: Path, *actions: str) -> Path:
    """A launch file of these actions."""
    (directory / "pk/launch").mkdir(parents=True)
    (directory / "pk/package.xml").write_text(PACKAGE)
    file = directory / "pk/launch/main.launch.py"
    file.write_text(f"{HEAD}def generate_launch_description():\n    return LaunchDescription([{', '.join(actions)}])\n")
    return file


def seen(file: Path) -> list[list[Any]]:
    """What each node sees: a, Ea, b, Eb, c, Ec."""
    model = stated(file)
    assert model["verdict"] != "error", model
    return [[node["env"][f"{which}_{key}"] for key in "abc" for which in ("IS", "WAS")] for node in model["nodes"]]


SET = "SetLaunchConfiguration('a', '1'), SetEnvironmentVariable('Ea', '1')"
AGAIN = "SetLaunchConfiguration('a', '2'), SetEnvironmentVariable('Ea', '2')"


@pytest.mark.parametrize(
    ("pushes", "pops", "a", "variable"),
    [
        ("PushLaunchConfigurations()", "PopLaunchConfigurations()", "1", "2"),
        ("PushEnvironment()", "PopEnvironment()", "2", "1"),
        ("PushLaunchConfigurations(), PushEnvironment()", "PopLaunchConfigurations(), PopEnvironment()", "1", "1"),
        ("PushLaunchConfigurations()", "GroupAction([PopLaunchConfigurations()])", "1", "2"),
        ("GroupAction([PushLaunchConfigurations()])", "PopLaunchConfigurations()", "1", "2"),
        ("PushLaunchConfigurations()", "OpaqueFunction(function=lambda context: [PopLaunchConfigurations()])", "1", "2"),
        ("PushLaunchConfigurations()", "PopLaunchConfigurations(condition=IfCondition('false'))", "2", "2"),
        ("PushLaunchConfigurations(), ResetLaunchConfigurations()", "PopLaunchConfigurations()", "1", "2"),
        ("PushEnvironment(), ResetEnvironment()", "PopEnvironment()", "2", "1"),
    ],
)
def test_what_was_kept_is_put_back(pushes: str, pops: str, a: str, variable: str, tmp_path: Path) -> None:
    (found,) = seen(written(tmp_path, SET, pushes, AGAIN, pops, "shown('n')"))
    assert found[:2] == [a, variable]


@pytest.mark.parametrize(
    "actions",
    [
        "PopLaunchConfigurations()",
        "PopEnvironment()",
        "PushEnvironment(), PopLaunchConfigurations()",
        "GroupAction([PopLaunchConfigurations()])",
        "GroupAction([PopEnvironment()])",
        "PushLaunchConfigurations(), PopLaunchConfigurations(), PopLaunchConfigurations()",
    ],
)
def test_launch_stops_where_nothing_was_kept(actions: str, tmp_path: Path) -> None:
    model = stated(written(tmp_path, actions))
    assert (model["verdict"], model["error"]) == ("error", {"rule": "", "message": "nothing-to-pop"})


@pytest.mark.parametrize("actions", ["PopEnvironment(condition=IfCondition(Command('x')))", "unknown(), PopEnvironment()"])
def test_what_may_have_been_kept_is_no_error(actions: str, tmp_path: Path) -> None:
    file = written(tmp_path, actions)
    file.write_text(f"from somewhere import unknown\n{file.read_text()}")
    assert stated(file)["verdict"] != "error"


def test_the_environment_is_replaced(tmp_path: Path) -> None:
    replaced = "ReplaceEnvironmentVariables(environment={'Eb': LaunchConfiguration('a')})"
    actions = (SET, "PushEnvironment()", replaced, "shown('n')", "PopEnvironment()", "shown('m')")
    first, second = seen(written(tmp_path, *actions))
    assert (first, second) == (["1", "-", "-", "1", "-", "-"], ["1", "1", "-", "-", "-", "-"])
    home = "Node(package='pk', executable='e', arguments=[EnvironmentVariable('HOME', default_value='none')])"
    (node,) = stated(written(tmp_path / "other", replaced.replace("LaunchConfiguration('a')", "'x'"), home))["nodes"]
    assert node["arguments"] == ["none"]


def test_what_may_be_set_or_forgotten_is_not_known_behind_it(tmp_path: Path) -> None:
    doubt = f"condition=IfCondition({DOUBTFUL})"
    actions = (
        SET,
        "SetLaunchConfiguration('b', '1')",
        f"ResetLaunchConfigurations({{'b': '1'}}, {doubt})",
        f"ResetEnvironment({doubt})",
        f"SetRemap('x', 'y', {doubt})",
        f"SetParameter('p', 1, {doubt})",
        "shown('n')",
    )
    file = written(tmp_path, *actions)
    (found,) = seen(file)
    assert [isinstance(each, dict) for each in found] == [True, True, False, False, False, False]
    (node,) = stated(file)["nodes"]
    assert "unknown" in node["remaps"]
    assert "unknown" in str(node["params"])


def is_covered(doubtful: Any, known: Any) -> bool:
    """Whether what is stated of a launch that is not wholly known holds in one that is."""
    if isinstance(doubtful, dict) and "unknown" in doubtful:
        return True
    if isinstance(doubtful, dict) and isinstance(known or {}, dict):
        known = known or {}
        return all(is_covered(doubtful.get(key), known.get(key)) for key in doubtful.keys() | known.keys())
    if isinstance(doubtful, list) and any("unknown" in str(each) for each in doubtful):  # these may be there, and may not
        return all("unknown" in str(each) or each in (known or []) for each in doubtful)
    if isinstance(doubtful, list) and isinstance(known, list):
        return len(doubtful) == len(known) and all(map(is_covered, doubtful, known))
    return bool(doubtful == known)


SHOWN = ("env", "namespace", "remaps", "params", "deferred")


@pytest.mark.parametrize("seed", range(30))
def test_what_is_stated_in_doubt_holds_however_it_turns_out(seed: int, tmp_path: Path) -> None:
    program = RandomProgram(seed, doubts=3)
    doubtful = stated(program.write(tmp_path / "doubt", (DOUBTFUL,) * program.conditions))
    nodes = {node["name"]: node for node in doubtful["nodes"]}
    many = len(nodes) < len(doubtful["nodes"])
    for number, way in enumerate(product(("'true'", "'false'"), repeat=program.conditions)):
        known = stated(program.write(tmp_path / str(number), way))
        if known["verdict"] == "error":
            continue
        assert doubtful["verdict"] != "error" or not program.conditions
        started = {node["name"] for node in known["nodes"]}
        assert all(name in started or node.get("maybe") or node.get("conditions") for name, node in nodes.items())
        for node in [] if many else known["nodes"]:
            mine = nodes[node["name"]]
            assert {key: (mine.get(key), node.get(key)) for key in SHOWN if not is_covered(mine.get(key), node.get(key))} == {}


@pytest.mark.parametrize("seed", range(200, 215))
def test_what_is_taken_over_is_what_a_fresh_evaluation_gives(seed: int, tmp_path: Path) -> None:
    file = RandomProgram(seed).write(tmp_path)
    repeats = Repeats()
    for given in ((), (("c", "true"),), (("c", "false"),), (("a", "7"), ("c", "true")), (("c", "true"),)):
        assert stated(file, given, repeats) == stated(file, given)
