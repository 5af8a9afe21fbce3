"""``launchlint check`` as a user runs it: options, outputs, exit statuses."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from tests.cli.running import CLEAN, DOUBLE, PACKAGE, UNUSED, run, write

FOUND_DOUBLE = "demo/launch/double.launch:3:15: error LL301 duplicate-node-name: two nodes are named /talker\n"
FOUND_UNUSED = "demo/launch/unused.launch:2:14: warning LL206 unused-arg: the arg speed is never read\n"
BOTH = FOUND_DOUBLE + FOUND_UNUSED


def concise(repository: Path, *words: str, **options: str) -> tuple[int, str, str]:
    return tuple(run(repository, "check", "--format", "concise", *words, **options))  # type: ignore[arg-type]  # stdin is text here


def test_whole_directory(repository: Path) -> None:
    assert concise(repository) == (1, BOTH, "")
    assert concise(repository, ".") == (1, BOTH, "")
    assert concise(repository, "demo") == (1, BOTH, "")


def test_full_text(repository: Path) -> None:
    assert run(repository, "check").output == (
        "demo/launch/double.launch:3:15: error LL301 duplicate-node-name: two nodes are named /talker\n"
        '    3 |   <node name="talker" pkg="demo" type="talk.py"/>\n'
        "      |               ^^^^^^ the second one\n"
        '    2 |   <node name="talker" pkg="demo" type="talk.py"/>\n'
        "      | the first one ^^^^^^\n"
        "   = roslaunch stops with: roslaunch file contains multiple nodes named [/talker]\n"
        "   = show it: roslaunch demo/launch/double.launch\n"
        "   = fix: remove the second one (--unsafe-fixes)\n"
        "   = help: remove the second one, which starts the same once more      [explain LL301]\n"
        "\n"
        "demo/launch/unused.launch:2:14: warning LL206 unused-arg: the arg speed is never read\n"
        '    2 |   <arg name="speed" default="1"/>\n'
        "      |       unused ^^^^^\n"
        "   = a value that is given for it has no effect\n"
        "   = fix: remove the arg (--unsafe-fixes)\n"
        "   = help: remove it here and in the includes that pass it, or use it as $(arg speed)      [explain LL206]\n"
        "\n"
        "1 error, 1 warning in 3 launch files; of 3 entry files 2 load, 1 is refused by roslaunch\n"
    )


@pytest.mark.parametrize(
    ("paths", "status", "output"),
    [
        (["demo/launch/clean.launch"], 0, ""),
        (["demo/launch/double.launch"], 1, FOUND_DOUBLE),
        (["demo/launch/unused.launch"], 0, FOUND_UNUSED),
        (["demo/launch/unused.launch", "demo/launch/double.launch", "demo"], 1, BOTH),
    ],
)
def test_paths(repository: Path, paths: list[str], status: int, output: str) -> None:
    assert concise(repository, *paths) == (status, output, "")


def test_paths_are_shown_relative_to_the_current_directory(repository: Path) -> None:
    assert run(repository / "demo", "check", "--format", "concise", "launch").output == BOTH.replace("demo/launch/", "launch/")
    assert run(repository / "demo" / "scripts", "check", "--format", "concise", "..").output == BOTH.replace(
        "demo/launch/", f"{repository}/demo/launch/"
    )


def test_a_fast_way_without_options_and_the_one_through_the_parser_say_the_same(repository: Path) -> None:
    plain = run(repository, "check", "-v", "--no-cache", "demo")
    assert plain == run(repository, "check", "-v", "--no-cache", "--jobs", "1", "demo")
    assert plain.status == 1


@pytest.mark.parametrize("words", [[], ["--stdin-filename", "demo/launch/there.launch"]])
def test_standard_input(repository: Path, words: list[str]) -> None:
    name = words[1] if words else "stdin.launch"
    expected = FOUND_DOUBLE.replace("demo/launch/double.launch", name)
    assert concise(repository, "-", *words, stdin=DOUBLE) == (1, expected, "")
    assert concise(repository, "-", *words, stdin=CLEAN) == (0, "", "")


def test_standard_input_is_judged_where_it_is_said_to_stand(repository: Path) -> None:
    """Its own includes are found, and the file on disk is not read."""
    write(repository, {"demo/launch/part.launch": '<launch><include file="$(dirname)/clean.launch"/></launch>'})
    status, output, _ = concise(
        repository,
        "-",
        "--stdin-filename",
        "demo/launch/part.launch",
        stdin='<launch><include file="$(dirname)/clean.launch"/><include file="$(dirname)/clan.launch"/></launch>',
    )
    assert (status, output) == (
        1,
        "demo/launch/part.launch:1:65: error LL401 include-not-found: the included file demo/launch/clan.launch does not exist\n",
    )


def test_args_reach_the_launch_file(repository: Path) -> None:
    write(
        repository,
        {"two.launch": '<launch><arg name="robot"/><node name="$(arg robot)" pkg="demo" type="talk.py"/>'
                       '<node name="two" pkg="demo" type="talk.py"/></launch>'},
    )  # fmt: skip
    assert concise(repository, "two.launch", "--arg", "robot:=one") == (0, "", "")
    status, output, _ = concise(repository, "two.launch", "--arg", "robot:=two")
    assert (status, output) == (1, "two.launch:1:93: error LL301 duplicate-node-name: two nodes are named /two\n")
    assert "   = show it: roslaunch two.launch robot:=two\n" in run(repository, "check", "two.launch", "--arg", "robot:=two").output


@pytest.mark.parametrize(
    ("words", "output"),
    [
        (["--select", "LL301"], FOUND_DOUBLE),
        (["--select", "duplicate-node-name"], FOUND_DOUBLE),
        (["--select", "ll3"], FOUND_DOUBLE),
        (["--select", "LL2"], FOUND_UNUSED),
        (["--select", "LL2,LL3"], BOTH),
        (["--select", "LL2", "--select", "LL301"], BOTH),
        (["--select", "LL4"], ""),
        (["--ignore", "LL301"], FOUND_UNUSED),
        (["--ignore", "unused-arg"], FOUND_DOUBLE),
        (["--ignore", "all"], ""),
        (["--select", "all", "--ignore", "LL3,LL2,LL8,LL409,LL7"], ""),
    ],
)
def test_select_and_ignore(repository: Path, words: list[str], output: str) -> None:
    assert concise(repository, *words)[1:] == (output, "")


@pytest.mark.parametrize(
    ("words", "status", "output"),
    [
        (["--severity", "LL301=warning"], 0, BOTH.replace("error LL301", "warning LL301")),
        (["--severity", "LL301=info"], 0, BOTH.replace("error LL301", "info LL301")),
        (["--severity", "unused-arg=error", "--ignore", "LL301"], 1, FOUND_UNUSED.replace("warning", "error")),
        (["--fail-on", "warning", "--ignore", "LL301"], 1, FOUND_UNUSED),
        (["--fail-on", "warning", "--ignore", "LL301,LL206"], 0, ""),
        (["--fail-on", "info", "--severity", "LL206=info", "--ignore", "LL301"], 1, FOUND_UNUSED.replace("warning", "info")),
        (["--exit-zero"], 0, BOTH),
    ],
)
def test_severity_fail_on_and_exit_zero(repository: Path, words: list[str], status: int, output: str) -> None:
    shown = run(repository, "check", "--format", "concise", "-v", *words)
    assert (shown.status, shown.output) == (status, output)


def test_infos_are_shown_with_v_only(repository: Path) -> None:
    words = ["check", "--severity", "LL206=info", "--ignore", "LL301"]
    loading = "; of 3 entry files 2 load, 1 is refused by roslaunch\n"
    assert run(repository, *words).output == f"no problems in 3 launch files (1 info hidden, -v shows it){loading}"
    assert run(repository, *words, "-v").output.endswith(f"1 info in 3 launch files{loading[:-1]}; 4 of 4 nodes known\n")


def test_quiet_prints_nothing_and_keeps_the_status(repository: Path) -> None:
    assert run(repository, "check", "-q") == (1, "", "")
    assert run(repository, "check", "--quiet", "demo/launch/clean.launch") == (0, "", "")


def test_statistics(repository: Path) -> None:
    assert run(repository, "check", "--format", "concise", "--statistics").output == (
        BOTH + "1  LL206  unused-arg           warning\n1  LL301  duplicate-node-name  error\n"
    )


def test_several_formats_at_once(repository: Path) -> None:
    words = ["check", "--format", "sarif:out.sarif", "--format", "concise", "--format", "json:out.json", "--format", "junit:out.xml"]
    assert run(repository, *words) == (1, BOTH, "")
    assert [finding["rule"] for finding in json.loads((repository / "out.json").read_text())["findings"]] == ["LL301", "LL206"]
    sarif = json.loads((repository / "out.sarif").read_text())
    assert [result["ruleId"] for result in sarif["runs"][0]["results"]] == ["LL301", "LL206"]
    assert (repository / "out.xml").read_text().startswith('<?xml version="1.0" encoding="utf-8"?>\n<testsuites name="launchlint"')


def test_files_are_written_even_when_quiet(repository: Path) -> None:
    assert run(repository, "check", "-q", "--format", "json:out.json") == (1, "", "")
    assert (repository / "out.json").is_file()


@pytest.mark.parametrize(
    ("words", "environment", "colored"),
    [
        ([], {}, False),  # no terminal
        (["--color", "always"], {}, True),
        (["--color", "always"], {"NO_COLOR": "1"}, True),
        (["--color", "never"], {"FORCE_COLOR": "1"}, False),
        ([], {"FORCE_COLOR": "1"}, True),
        ([], {"FORCE_COLOR": "1", "NO_COLOR": "1"}, False),
        (["--color", "auto"], {"NO_COLOR": ""}, False),
    ],
)
def test_color(repository: Path, words: list[str], environment: dict[str, str], colored: bool) -> None:
    assert ("\x1b[" in run(repository, "check", *words, environment=environment).output) is colored


def test_colors_go_to_the_terminal_only(repository: Path) -> None:
    run(repository, "check", "--color", "always", "--format", "text:out.txt")
    assert "\x1b" not in (repository / "out.txt").read_text()


def test_baseline(repository: Path) -> None:
    recorded = run(repository, "check", "--write-baseline", "known.json")
    assert recorded == (0, "", "launchlint: wrote 2 findings to known.json; --baseline known.json leaves them out from now on\n")
    assert concise(repository, "--baseline", "known.json") == (0, "", "")
    write(repository, {"demo/launch/new.launch": UNUSED})
    new = FOUND_UNUSED.replace("unused.launch", "new.launch")
    assert concise(repository, "--baseline", "known.json", "--fail-on", "warning") == (1, new, "")
    both = run(repository, "check", "--baseline", "known.json", "--write-baseline", "known.json")
    assert both.errors.startswith("launchlint: wrote 3 findings"), "the known ones stay in it"


def test_the_configuration_names_the_baseline(repository: Path) -> None:
    write(repository, {".launchlint.yaml": "baseline: known.json\n"})
    missing = "launchlint: known.json: there is no such baseline file; --write-baseline makes one\n"
    assert run(repository, "check") == (2, "", missing)
    assert run(repository, "check", "--write-baseline", "known.json").status == 0
    assert concise(repository) == (0, "", "")


def test_workspace_says_where_packages_are(repository: Path, tmp_path: Path) -> None:
    write(tmp_path, {"other/arm/package.xml": PACKAGE.format(name="arm"), "other/arm/part.launch": "<launch/>\n"})
    write(repository, {"arm.launch": '<launch><include file="$(find arm)/part.launch"/></launch>'})
    alone = run(repository, "check", "-v", "--format", "concise", "arm.launch")
    assert alone.output.startswith("arm.launch:1:24: ")
    assert "LL210" in alone.output
    assert concise(repository, "-v", "arm.launch", "--workspace", ".", "--workspace", "../other") == (0, "", "")


def test_entries_are_judged_one_by_one(repository: Path) -> None:
    write(
        repository,
        {
            "entries.json": json.dumps(
                [
                    {"file": "demo/launch/double.launch"},
                    {"file": "demo/launch/clean.launch", "args": {"unused": 1}},
                    {"file": "demo/launch/double.launch", "as": "demo/launch/clean.launch"},
                ]
            )
        },
    )
    ran = run(repository, "check", "--entries", "entries.json", "--format", "jsonl")
    lines = [json.loads(line) for line in ran.output.splitlines()]
    found = [(line["file"], line["as"], line["verdict"], [(each["rule"], each["path"]) for each in line["findings"]]) for line in lines]
    assert (ran.status, ran.errors) == (1, "")
    assert found == [
        ("demo/launch/double.launch", "demo/launch/double.launch", "error", [("LL301", "demo/launch/double.launch")]),
        ("demo/launch/clean.launch", "demo/launch/clean.launch", "ok", []),
        ("demo/launch/double.launch", "demo/launch/clean.launch", "error", [("LL301", "demo/launch/clean.launch")]),
    ]
    assert run(repository, "check", "--entries", "entries.json", "--exit-zero").output == ran.output
    to_file = run(repository, "check", "--entries", "entries.json", "--format", "jsonl:lines.jsonl")
    assert (to_file.output, (repository / "lines.jsonl").read_text()) == ("", ran.output)


def test_an_entry_of_which_nobody_can_tell_is_neither_loaded_nor_refused(tmp_path: Path) -> None:
    program = "from launch import LaunchDescription\nfrom elsewhere import actions\n"
    program += "def generate_launch_description():\n    return LaunchDescription([actions()])\n"
    write(tmp_path, {"a.launch.py": program, "entries.json": '[{"file": "a.launch.py"}]'})
    line = json.loads(run(tmp_path, "check", "--entries", "entries.json", "--format", "jsonl").output)
    assert (line["verdict"], line["outcome"]["word"]) == ("unknown", "cannot be told")


def test_what_stands_in_a_module_of_another_package_is_told_where_it_stands(tmp_path: Path) -> None:
    manifest = '<package format="3"><name>{}</name><version>1</version><export><build_type>ament_python</build_type></export></package>'
    module = "from launch_ros.actions import Node\n\n\ndef node():\n    return Node(package='lamp', node_executable='on')\n"
    program = "from launch import LaunchDescription\nfrom lamp.launching import node\n\n\n"
    program += "def generate_launch_description():\n    return LaunchDescription([node()])\n"
    files = {"a/package.xml": manifest.format("house"), "a/launch/house.launch.py": program, "b/package.xml": manifest.format("lamp")}
    write(tmp_path, {**files, "b/lamp/__init__.py": "", "b/lamp/launching.py": module})
    found = json.loads(run(tmp_path, "check", "--format", "json", "--select", "LL924", ".").output)["findings"]
    assert [(each["path"], each["line"]) for each in found] == [("b/lamp/launching.py", 5)]


def test_nothing_to_check(tmp_path: Path) -> None:
    (tmp_path / "empty").mkdir()
    assert run(tmp_path / "empty", "check") == (0, "no launch files to check\n", "")


ROS2 = '<launch>\n  <let name="robot" value="one"/>\n  <node pkg="demo" exec="talk" namespace="$(var robot)"/>\n</launch>\n'


def test_both_dialects_in_one_run(repository: Path) -> None:
    write(repository, {"demo/launch/two.launch.xml": ROS2})
    assert concise(repository) == (1, BOTH, "")
    broken = "launch:\n- node:\n    pkg: demo\n    exce: talk\n"
    write(repository, {"demo/launch/three.launch.yaml": broken})
    ran = run(repository, "check", "--format", "concise")
    assert (ran.status, ran.errors) == (1, "")
    told = [line for line in ran.output.splitlines() if line.startswith("demo/launch/three.launch.yaml:")]
    assert [line.partition(" ")[2].split()[:2] for line in told] == [["error", "LL105"], ["error", "LL104"]]
    whole = run(repository, "check", "demo/launch/three.launch.yaml")
    assert "roslaunch" not in whole.output
    assert "refused by ros2 launch" in whole.output


def test_a_comment_in_yaml_silences_a_rule(repository: Path) -> None:
    text = "launch:\n# launchlint: ignore[LL104] read by our own tools\n- node:\n    pkg: demo\n    exec: talk\n    color: red\n"
    write(repository, {"demo/launch/three.launch.yaml": text})
    told = run(repository, "check", "--format", "concise", "demo/launch/three.launch.yaml")
    assert (told.status, told.output.count("LL104")) == (0, 0)
    write(repository, {"demo/launch/three.launch.yaml": text.replace("launchlint:", "")})
    assert "LL104" in run(repository, "check", "--format", "concise", "demo/launch/three.launch.yaml").output


def test_launch_files_in_python_are_read_and_what_only_looks_like_one_is_not(repository: Path) -> None:
    test = "def generate_test_description():\n    pass\n"
    write(
        repository, {"demo/launch/two.launch.py": "import launch\n", "demo/launch/three_launch.py": "", "demo/launch/four.launch.py": test}
    )
    status, output, errors = concise(repository)
    assert (status, errors) == (1, "")
    assert "demo/launch/two.launch.py:1:1: error LL932 no-description" in output
    assert "three_launch.py" not in output
    assert "four.launch.py" not in output


def test_a_launch_file_in_python(repository: Path) -> None:
    text = (
        "from launch import LaunchDescription\nfrom launch_ros.actions import Node\n\n\ndef generate_launch_description():\n"
        "    return LaunchDescription([Node(package='demo', executable='talk.py', name='a b')])\n"
    )
    write(repository, {"demo/launch/two.launch.py": text})
    found = run(repository, "check", "--format", "concise", "demo/launch/two.launch.py")
    assert found.output.startswith("demo/launch/two.launch.py:6:80: error LL302 ")
    meant = text.replace("    return", "    # launchlint: ignore[LL302] a test\n    return")
    write(repository, {"demo/launch/two.launch.py": meant})
    assert run(repository, "check", "--format", "concise", "demo/launch/two.launch.py").output == ""


def test_files_of_other_programs_are_left_out_with_one_notice(repository: Path) -> None:
    text = '<concert>\n  <launch package="demo" name="solution.launch"/>\n</concert>\n'
    write(repository, {"demo/launch/solution.launch": text})
    notice = (
        "launchlint: left out demo/launch/solution.launch: its root is <concert>, so that it is no launch file; "
        "name a file to check it all the same\n"
    )
    assert concise(repository) == (1, BOTH, notice)
    named = run(repository, "check", "-v", "--format", "concise", "--select", "LL102", "demo/launch/solution.launch")
    assert "info LL102" in named.output


def test_what_a_package_is_built_for_decides_where_the_file_does_not(repository: Path) -> None:
    package = PACKAGE.format(name="two").replace("</license>", "</license><export><build_type>ament_cmake</build_type></export>")
    write(repository, {"two/package.xml": package, "two/launch/plain.launch.xml": "<launch/>\n"})
    told = run(repository, "model", "--format", "jsonl", "two/launch/plain.launch.xml", "demo/launch")
    assert ["distro" in json.loads(line) for line in told.output.splitlines()][-1:] == [True]
