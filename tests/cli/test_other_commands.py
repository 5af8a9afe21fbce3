"""``model``, ``rules``, ``explain``, ``schema`` and the options of launchlint itself."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from launchlint import __version__
from launchlint.rules.registry import RULES
from tests.cli.running import DOUBLE, run, write

ROBOT = """\
<launch>
  <arg name="rate" default="5"/>
  <group ns="robot">
    <remap from="chatter" to="talk"/>
    <node name="talker" pkg="demo" type="talk.py" args="--loud" required="true">
      <param name="rate" value="$(arg rate)"/>
    </node>
  </group>
  <param name="color" value="red"/>
  <param name="description" command="xacro $(dirname)/robot.xacro"/>
</launch>
"""


def test_model_for_people(repository: Path) -> None:
    write(repository, {"robot.launch": ROBOT})
    expected = (
        "NODES\n"
        "  /robot/talker  demo/talk.py  [required]\n"
        "      args   --loud\n"
        "      remap  chatter -> talk\n"
        "      param  ~rate = 5\n"
        "\n"
        "PARAMETERS\n"
        "  /color = red\n"
        f"  /description = output of: xacro {repository}/robot.xacro\n"
    )
    assert run(repository, "model", "robot.launch") == (0, expected, "")


def test_model_with_args(repository: Path) -> None:
    write(repository, {"robot.launch": ROBOT})
    assert "      param  ~rate = 50\n" in run(repository, "model", "robot.launch", "--arg", "rate:=50").output


def test_model_of_a_refused_file(repository: Path) -> None:
    ran = run(repository, "model", "demo/launch/double.launch")
    assert (ran.status, ran.errors) == (1, "")
    assert ran.output == (
        "roslaunch refuses this file: two nodes are named /talker (LL301); what can be known of it:\n"
        "\n"
        "NODES\n"
        "  /talker  demo/talk.py\n"
        "  /talker  demo/talk.py\n"
    )


def test_model_of_standard_input(repository: Path) -> None:
    ran = run(repository, "model", "-", "--stdin-filename", "demo/launch/new.launch", "--format", "json", stdin=DOUBLE)
    model = json.loads(ran.output)
    assert (ran.status, model["file"], model["verdict"], model["error"]["rule"]) == (1, "demo/launch/new.launch", "error", "LL301")


def test_model_as_json(repository: Path) -> None:
    write(repository, {"robot.launch": ROBOT})
    model = json.loads(run(repository, "model", "--format", "json", "robot.launch").output)
    assert [(node["fqn"], node["pkg"], node["type"], node["remaps"], node["required"]) for node in model["nodes"]] == [
        ("/robot/talker", "demo", "talk.py", [["chatter", "talk"]], True)
    ]
    assert model["params"] == {
        "/color": {"type": "str", "value": "red"},
        "/description": {"type": "command", "value": f"xacro {repository}/robot.xacro"},
        "/robot/talker/rate": {"type": "int", "value": 5},
    }
    several = json.loads(run(repository, "model", "--format", "json", "demo").output)
    assert [each["file"] for each in several] == ["demo/launch/clean.launch", "demo/launch/double.launch", "demo/launch/unused.launch"]


def test_model_of_entries_as_json_lines(repository: Path) -> None:
    write(repository, {"robot.launch": ROBOT, "entries.yaml": "- {file: robot.launch, args: {rate: 1.50}}\n- nowhere.launch\n"})
    ran = run(repository, "model", "--entries", "entries.yaml", "--format", "jsonl")
    first, second = map(json.loads, ran.output.splitlines())
    assert (ran.status, ran.errors) == (1, "")
    assert (first["verdict"], first["params"]["/robot/talker/rate"]) == ("ok", {"type": "double", "value": 1.5})
    assert (second["verdict"], second["error"]["rule"], second["nodes"]) == ("error", "LL100", [])


def test_model_of_a_missing_file(repository: Path) -> None:
    assert run(repository, "model", "nowhere.launch") == (
        2, "", "launchlint: nowhere.launch: No such file or directory; give launch files, or directories to search for them\n",
    )  # fmt: skip


def test_model_of_both_dialects(repository: Path) -> None:
    write(repository, {"two.launch.xml": '<launch><let name="a" value="b"/><node pkg="demo" exec="$(var a)" name="n"/></launch>'})
    ran = run(repository, "model", "--format", "jsonl", ".")
    told = {each["file"]: each for each in map(json.loads, ran.output.splitlines())}
    assert len(told) == 4
    assert told["two.launch.xml"]["distro"] == "jazzy"
    assert [each["executable"] for each in told["two.launch.xml"]["nodes"]] == ["b"]
    part = '<composable_node pkg="demo" plugin="demo::Part" name="p"><param name="rate" value="5"/></composable_node>'
    box = f'<launch><node_container pkg="demo" exec="box" name="box" namespace="/a">{part}</node_container></launch>'
    write(repository, {"three.launch.xml": box})
    assert run(repository, "model", "three.launch.xml").output == (
        "NODES\n  /a/box  demo/box\n  /p  demo::Part  [in /a/box]\n      param  rate = 5\n"
    )
    assert run(repository, "model", "--distro", "humble", "--format", "jsonl", "two.launch.xml").output.count('"distro": "humble"') == 1


def test_a_launch_file_in_python_of_which_nothing_is_known(repository: Path) -> None:
    write(repository, {"two.launch.py": "import something\n\n\ndef generate_launch_description():\n    return something.else_()\n"})
    ran = run(repository, "model", "--format", "jsonl", "two.launch.py")
    told = json.loads(ran.output)
    assert (ran.errors, told["verdict"], told["complete"], told["nodes"]) == ("", "unknown", False, [])


def test_model_of_a_launch_file_in_python(repository: Path) -> None:
    text = (
        "from launch import LaunchDescription\nfrom launch_ros.actions import Node\n\n\n"
        "def generate_launch_description():\n    return LaunchDescription([Node(package='demo', executable='b', name='n')])\n"
    )
    write(repository, {"two.launch.py": text})
    ran = run(repository, "model", "--format", "jsonl", "two.launch.py")
    assert ran.errors == ""
    told = json.loads(ran.output)
    assert (told["verdict"], told["complete"], [each["name"] for each in told["nodes"]]) == ("ok", True, ["n"])
    assert run(repository, "check", "two.launch.py").errors == ""


def test_rules_lists_all_of_them(repository: Path) -> None:
    ran = run(repository, "rules")
    assert (ran.status, ran.errors) == (0, "")
    assert [line.split()[:3] for line in ran.output.splitlines()] == [[rule.id, rule.name, rule.severity.word] for rule in RULES]
    off = {line.split()[0] for line in ran.output.splitlines() if line.split()[3] == "off"}
    assert off == {rule.id for rule in RULES if not rule.default}


def test_rules_as_json(repository: Path) -> None:
    rows = json.loads(run(repository, "rules", "--format", "json").output)
    assert [row["id"] for row in rows] == [rule.id for rule in RULES]
    assert all(set(row) == {"id", "name", "severity", "default", "summary"} and row["summary"] for row in rows)


@pytest.mark.parametrize("word", ["LL301", "ll301", "duplicate-node-name"])
def test_explain(repository: Path, word: str) -> None:
    ran = run(repository, "explain", word)
    assert (ran.status, ran.errors) == (0, "")
    assert ran.output.startswith("LL301 duplicate-node-name\nerror · ")


@pytest.mark.parametrize(
    ("word", "message"),
    [
        ("LL310x", "there is no rule LL310x: did you mean LL310?"),
        ("duplicate-node", "there is no rule duplicate-node: launchlint rules lists them all"),
        ("unused-args", "there is no rule unused-args: did you mean unused-arg?"),
    ],
)
def test_explain_of_no_rule(repository: Path, word: str, message: str) -> None:
    assert run(repository, "explain", word) == (2, "", f"launchlint: {message}\n")


def test_schema(repository: Path) -> None:
    ran = run(repository, "schema", "ros1")
    assert (ran.status, ran.errors) == (0, "")
    assert ran.output.startswith('<?xml version="1.0" encoding="UTF-8"?>\n')
    assert ran.output.rstrip().endswith("</grammar>")
    wrong = run(repository, "schema", "ros3")
    assert (wrong.status, wrong.output) == (2, "")
    assert wrong.errors.startswith("launchlint: Invalid value for ")


def test_version_and_help(repository: Path) -> None:
    assert run(repository, "--version") == (0, f"launchlint, version {__version__}\n", "")
    for words in (
        ["--help"],
        ["-h"],
        ["check", "--help"],
        ["model", "--help"],
        ["rules", "--help"],
        ["explain", "--help"],
        ["schema", "-h"],
    ):
        ran = run(repository, *words)
        assert (ran.status, ran.errors) == (0, ""), words
        assert ran.output.startswith("Usage: launchlint"), words


def test_a_terminal_that_knows_no_unicode(repository: Path) -> None:
    """What its encoding lacks is escaped, and nothing fails."""
    write(repository, {"ümlaut.launch": DOUBLE})
    ran = run(repository, "check", "--format", "concise", "ümlaut.launch", environment={"PYTHONIOENCODING": "ascii", "LC_ALL": "C.UTF-8"})
    assert ran.output == "\\xfcmlaut.launch:3:15: error LL301 duplicate-node-name: two nodes are named /talker\n"
    assert run(repository, "explain", "LL301", environment={"PYTHONIOENCODING": "ascii"}).status == 0
    assert run(repository, "rules", environment={"PYTHONIOENCODING": "ascii"}).status == 0
