"""What each substitution of ROS 2 launch is replaced by, in each distribution."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.evaluate.ros2.launching import Workspace, only, refusal


def performed(directory: Path, text: str, distro: str = "jazzy") -> str:
    """The value of a text in a launch file, as an arg of a node."""
    return only(Workspace(directory, f"<node pkg='pk' exec='e' args=\"{text}\"/>").launch(distro=distro)).arguments


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("$(var no d)", "d"),
        ("[$(var no '')]", "[]"),
        ("$(env USER)", "somebody"),
        ("$(env NO d)", "d"),
        ("$(env NO $(env USER))", "somebody"),
        ("$(find-pkg-prefix pk)", "/opt/ros/jazzy"),
        ("$(exec-in-pkg e pk)", "/opt/ros/jazzy/lib/pk/e"),
        ("$(find-exec ls)", "/usr/bin/ls"),
        ("$(anon a.b)-$(anon a.b)-$(anon c)", "a_b_anon1-a_b_anon1-c_anon2"),
        ("$(not yes)", "false"),
        ("$(not 0)", "true"),
        ("$(and true on)", "true"),
        ("$(or off false)", "false"),
        ("$(equals 1.0 1)", "true"),
        ("$(equals true 1)", "true"),
        ("$(equals a A)", "false"),
        ("$(not-equals a b)", "true"),
        ("$(if true a b)", "a"),
        ("$(if false a)", ""),
        ("$(param p 5)", "5"),
        ("$(launch_log_dir)", "/home/somebody/.ros/log/launch"),
        ("$(eval '1 + 2')", "3"),
        ("$(eval '1 == 1')", "True"),
        ("$(eval 'cos(0)')", "1.0"),
        ("$(eval 'math.floor(2.5)')", "2"),
        ("$(eval 'floor(2.5)' '')", None),
        (r"$(eval 'os.path.join(\'a\', \'b\')' 'os')", "a/b"),
        (r"$(eval '__import__(\'os\').sep')", "/"),
        ("$(eval 'sum([i for i in range(4)])')", "6"),
        ("$(eval 'None')", "None"),
    ],
)
def test_values(tmp_path: Path, text: str, expected: str | None) -> None:
    if expected is None:
        launch = Workspace(tmp_path, f'<log message="{text}"/>').launch()
        assert refusal(launch) == "eval-error main.launch.xml:1"
    else:
        assert performed(tmp_path, text) == expected


def test_the_share_directory_is_that_of_the_sources(tmp_path: Path) -> None:
    assert performed(tmp_path, "$(find-pkg-share pk)") == str(tmp_path / "pk")


def test_content_of_a_file(tmp_path: Path) -> None:
    files = {"data.txt": "one\r\ntwo"}
    node = only(Workspace(tmp_path, "<node pkg='pk' exec='e' args='$(file-content $(dirname)/data.txt)'/>", files).launch())
    assert node.arguments == "one\ntwo"


@pytest.mark.parametrize("text", ["$(not 1)", "$(eval 'math.pi')"])
def test_humble_knows_less(tmp_path: Path, text: str) -> None:
    assert refusal(Workspace(tmp_path, f'<log message="{text}"/>').launch(distro="humble"))


@pytest.mark.parametrize(
    ("text", "reason"),
    [
        ("$(eval 'open(1)')", "eval-not-covered"),
        ("$(eval '9 ** 9 ** 9')", "eval-not-covered"),
        (r"$(eval '__import__(\'subprocess\').run(1)')", "eval-not-covered"),
        ("$(eval '[].__class__')", "eval-not-covered"),
        ("$(eval '1' 'subprocess')", "eval-not-covered"),
    ],
)
def test_what_is_not_computed_refuses_nothing(tmp_path: Path, text: str, reason: str) -> None:
    launch = Workspace(tmp_path, f'<log message="{text}"/>').launch()
    assert launch.refused is None
    assert [problem.kind for problem in launch.problems] == [reason]


@pytest.mark.parametrize("text", ["$(eval 'true')", "$(eval '1/0')", "$(eval '1 +')", "$(eval 'abc')"])
def test_expressions_that_fail(tmp_path: Path, text: str) -> None:
    assert refusal(Workspace(tmp_path, f'<log message="{text}"/>').launch()) == "eval-error main.launch.xml:1"


def test_param_sees_what_was_set(tmp_path: Path) -> None:
    body = "<set_parameter name='p' value='[1, 2]'/><let name='v' value='$(param p)'/><log message='$(var v)'/>"
    launch = Workspace(tmp_path, body + "<node pkg='pk' exec='e' args='$(var v)'/>").launch()
    assert only(launch).arguments == "(1, 2)"
