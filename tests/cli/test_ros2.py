"""All commands and options on launch files of ROS 2, in XML and YAML: as on those of ROS 1."""

from __future__ import annotations

import json
import shutil
from pathlib import Path
from xml.etree import ElementTree

import pytest

from tests.cli.ferry import BROKEN, GOOD, HELM, LAUNCH, SEA, SEA_BROKEN, TOLD, Ferry
from tests.cli.running import ROOT

RULES = ["LL901", "LL947", "LL214", "LL112"]
SHOWN = f"show it: ros2 launch {BROKEN}"
DYING = f"{HELM}:22:11: error LL947 remap-kills-node"


@pytest.fixture
def ferry(tmp_path: Path) -> Ferry:
    return Ferry(tmp_path / "ferry")


def test_what_is_told(ferry: Ferry) -> None:
    ran = ferry.run("check")
    assert ran.status == 1
    assert SHOWN in ran.output
    assert "3 errors, 1 warning in 3 launch files; of 3 entry files 2 load, 1 is refused by ros2 launch" in ran.output
    assert "roslaunch" not in ran.output + ran.errors
    assert ferry.told() == TOLD


@pytest.mark.parametrize("form", ["json", "jsonl", "sarif", "github", "gitlab", "junit", "markdown"])
def test_every_format_tells_all_of_it(ferry: Ferry, form: str) -> None:
    ran = ferry.run("check", "--format", form)
    assert ran.status == 1
    assert all(rule in ran.output for rule in RULES)
    assert "roslaunch" not in ran.output if form != "sarif" else "ros2 launch" in ran.output


def test_json_and_jsonl_hold_the_same(ferry: Ferry) -> None:
    whole = json.loads(ferry.run("check", "--format", "json").output)
    lines = [json.loads(line) for line in ferry.run("check", "--format", "jsonl").output.splitlines()]
    assert [line for line in lines if "fingerprint" in line] == whole["findings"]
    assert [(each["path"], each["line"], each["rule"], each["severity"]) for each in whole["findings"]] == [
        (SEA_BROKEN, 1, "LL901", "warning"),
        (BROKEN, 9, "LL947", "error"),
        (BROKEN, 11, "LL214", "error"),
        (BROKEN, 14, "LL112", "error"),
    ]


def test_sarif_names_places_and_rules(ferry: Ferry) -> None:
    (only,) = json.loads(ferry.run("check", "--format", "sarif").output)["runs"]
    rules = [rule["id"] for rule in only["tool"]["driver"]["rules"]]
    found = {}
    for result in only["results"]:
        place = result["locations"][0]["physicalLocation"]
        assert rules[result["ruleIndex"]] == result["ruleId"]
        found[result["ruleId"]] = (place["artifactLocation"]["uri"], place["region"]["startLine"])
    assert found == {"LL901": (SEA_BROKEN, 1), "LL947": (BROKEN, 9), "LL214": (BROKEN, 11), "LL112": (BROKEN, 14)}
    (fix,) = [fix for result in only["results"] for fix in result.get("fixes", ())]
    assert fix["artifactChanges"][0]["replacements"][0]["insertedContent"] == {"text": "exec"}


def test_junit_has_a_case_for_each_file(ferry: Ferry) -> None:
    root = ElementTree.fromstring(ferry.run("check", "--format", "junit").output)
    cases = {case.get("name"): case for case in root.iter("testcase")}
    assert set(cases) == {SEA_BROKEN, BROKEN}
    failure = cases[BROKEN].find("failure")
    assert failure is not None
    assert failure.get("type") == "LL112 LL214 LL947"


def test_standard_input(ferry: Ferry) -> None:
    yaml = ferry.text(HELM).replace("turtle1/cmd_vel", "turtle1/cmd_vel/")
    assert ferry.told("-", "--stdin-filename", HELM, stdin=yaml) == [DYING]
    xml = ferry.text(BROKEN)
    assert ferry.told("-", "--stdin-filename", f"{LAUNCH}/new.launch.xml", stdin=xml) == [
        each.replace("ferry_broken", "new") if each.startswith(BROKEN) else each for each in TOLD
    ]


def test_standard_input_without_a_name_is_called_by_what_it_holds(ferry: Ferry) -> None:
    yaml, python = "launch:\n    - log:\n        message: 1\n", "def generate_launch_description():\n    return 1\n"
    assert ferry.told("-", stdin=yaml)[0].startswith("stdin.launch.yaml:3:")
    assert ferry.told("-", stdin=python)[0].startswith("stdin.launch.py:1:")
    assert tuple(ferry.run("format", "-", stdin=yaml)) == (0, "launch:\n- log:\n    message: 1\n", "")
    ran = ferry.run("format", "-", stdin=python)
    assert (ran.status, ran.output) == (2, "")
    assert "standard input is a launch file in Python: format writes XML and YAML" in ran.errors


def test_what_is_staged_counts(ferry: Ferry) -> None:
    before = ferry.text(HELM)
    ferry.change(HELM, "turtle1/cmd_vel", "turtle1/cmd_vel/")
    ferry.git("add", "-A")
    ferry.write(**{HELM: before})
    assert ferry.told() == TOLD
    assert ferry.told("--staged") == [*TOLD, DYING]
    ferry.git("rm", "-q", "-f", HELM)
    assert f"{GOOD}:10:20: error LL401 include-not-found" in ferry.told("--staged")


@pytest.mark.parametrize(("changed", "expected"), [(SEA_BROKEN, TOLD[:1]), (SEA, []), (BROKEN, TOLD), (GOOD, []), (HELM, [])])
def test_what_concerns_a_changed_file(ferry: Ferry, changed: str, expected: list[str]) -> None:
    assert ferry.told("--changed", changed) == expected


def test_what_was_lost_since_a_revision(ferry: Ferry) -> None:
    assert "LL620" not in ferry.run("check", "--base", "HEAD", GOOD).output
    ferry.change(HELM, "turtle1/cmd_vel", "turtle9/cmd_vel")
    ran = ferry.run("check", "--base", "HEAD", GOOD)
    assert f"{HELM}:22:11: warning LL620 lost-connection: /ferry/helm has lost its subscriber /ferry/sea" in ran.output
    assert f"show it: ros2 launch {GOOD}" in ran.output


def test_fix_and_diff(ferry: Ferry) -> None:
    before = ferry.text(BROKEN)
    ran = ferry.run("check", "--diff")
    assert (
        '-    <node pkg="turtlesim" type="mimic" name="dinghy"/>\n+    <node pkg="turtlesim" exec="mimic" name="dinghy"/>\n' in ran.output
    )
    assert ferry.text(BROKEN) == before
    assert ferry.run("check", "--fix").status == 1
    assert ferry.text(BROKEN) == before.replace('type="mimic"', 'exec="mimic"')
    assert ferry.told() == TOLD[:3]


def test_fix_in_yaml(ferry: Ferry) -> None:
    ferry.change(HELM, "exec: joy_node", "exce: joy_node")
    assert any("LL104" in each for each in ferry.told(HELM))
    ferry.run("check", "--fix", HELM)
    assert "exec: joy_node" in ferry.text(HELM)
    assert ferry.told(HELM) == []


def test_suppressions(ferry: Ferry) -> None:
    ferry.change(BROKEN, '      <remap from="turtle1', '      <!-- launchlint: ignore[LL947] meant -->\n      <remap from="turtle1')
    ferry.change(HELM, "pkg: joy\n", "pkg: joy\n      nmae: x  # launchlint: ignore[LL104] to see what happens\n")
    told = ferry.told()
    assert [each.partition(": ")[2] for each in told] == [each.partition(": ")[2] for each in (TOLD[0], *TOLD[2:])]
    ferry.change(HELM, "nmae: x", "respawn: true")
    assert f"{HELM}:9:" in ferry.told()[-1]
    assert "LL802 unused-suppression" in ferry.told()[-1]


def test_suppressions_in_a_parameter_file(ferry: Ferry) -> None:
    """A finding in a parameter file is silenced there; what a comment does not need is told, from the cache as well."""
    place = next(each for each in TOLD if " LL901 " in each).partition(":")[0]
    text, others = ferry.text(place), [each for each in TOLD if " LL901 " not in each]
    for _ in range(2):
        ferry.write(**{place: f"# launchlint: ignore-file[LL901] for another robot\n{text}"})
        assert ferry.told() == others
        assert ferry.told() == others
        assert "in 3 launch files" in ferry.run("check").output
        ferry.write(**{place: f"# launchlint: ignore-file[LL901, LL904] for another robot\n{text}"})
        assert any(each.startswith(f"{place}:1:1: warning LL802 ") for each in ferry.told())
        ferry.write(**{place: text})
        assert ferry.told() == TOLD


def test_a_file_that_is_left_in_peace(ferry: Ferry) -> None:
    ferry.write(**{BROKEN: f"<!-- launchlint: ignore-file -->\n{ferry.text(BROKEN)}"})
    assert [each for each in ferry.told() if BROKEN in each] == []


def test_a_baseline_leaves_out_what_was_there(ferry: Ferry) -> None:
    assert ferry.run("check", "--write-baseline", "known.json").status == 0
    assert ferry.told("--baseline", "known.json") == []
    ferry.write(**{BROKEN: ferry.text(BROKEN).replace("<launch>", "<launch>\n")})
    ferry.change(HELM, "turtle1/cmd_vel", "turtle1/cmd_vel/")
    assert ferry.told("--baseline", "known.json") == [DYING]


def test_configuration(ferry: Ferry) -> None:
    ignored = f'per-file-ignores:\n  "{SEA_BROKEN}": [LL901]\n  "**/*_broken.launch.xml": [LL947, LL112]\n'
    ferry.write(**{".launchlint.yaml": ignored + "severity:\n  LL214: info\n"})
    ran = ferry.run("check", "-v", "--format", "concise")
    assert [line.partition(" condition")[0] for line in ran.output.splitlines() if " LL214 " in line] == [f"{BROKEN}:11:81: info LL214"]
    assert ferry.told() == []


CONTAINER = """\
<launch>
  <arg name="camera" default="false"/>
  <node_container pkg="joy" exec="container" name="c" namespace=""/>
  <load_composable_node target="c">
    <composable_node pkg="joy" plugin="joy::Joy" name="joy" if="$(var camera)"/>
  </load_composable_node>
</launch>
"""


@pytest.mark.parametrize(("distro", "told"), [("humble", True), ("jazzy", False), ("rolling", False)])
def test_the_distribution_counts(ferry: Ferry, distro: str, told: bool) -> None:
    ferry.write(**{f"{LAUNCH}/container.launch.xml": CONTAINER})
    file = f"{LAUNCH}/container.launch.xml"
    assert ("LL939" in ferry.run("check", "-v", "--distro", distro, file).output) is told
    assert ("LL939" in ferry.run("check", "-v", file, ROS_DISTRO=distro).output) is told
    ferry.write(**{".launchlint.yaml": f"distro: {distro}\n"})
    assert ("LL939" in ferry.run("check", "-v", file).output) is told


def test_jobs_and_hash_seeds_change_nothing(ferry: Ferry) -> None:
    for number in range(12):
        ferry.write(**{f"{LAUNCH}/copy{number}.launch.xml": ferry.text(BROKEN)})
    shown = {
        ferry.run("check", "--no-cache", "--format", "json", "--jobs", jobs, PYTHONHASHSEED=seed).output
        for jobs, seed in (("1", "0"), ("2", "1"), ("4", "2"))
    }
    assert len(shown) == 1
    findings = json.loads(shown.pop())["findings"]  # what copies have in common is told once, with the places
    assert sum(1 + len(finding["related"]) for finding in findings) > 12


def test_model(ferry: Ferry) -> None:
    ran = ferry.run("model", GOOD)
    assert ran.status == 0
    assert "  /ferry/helm  teleop_twist_joy/teleop_node\n      remap  cmd_vel -> turtle1/cmd_vel\n" in ran.output
    lines = ferry.run("model", "--format", "jsonl", GOOD, HELM).output.splitlines()
    alone = json.loads(lines[1])
    assert [node["name"] for node in json.loads(lines[0])["nodes"]] == ["sea", "wheel", "helm"]
    assert [node.get("namespace") for node in alone["nodes"]] == [None, None]
    refused = ferry.run("model", "--format", "json", BROKEN)
    assert (refused.status, json.loads(refused.output)["outcome"]["word"]) == (1, "refused")


@pytest.mark.parametrize(
    ("form", "edge"),
    [
        ("text", "publishes   /ferry/turtle1/cmd_vel  → /ferry/sea"),
        ("dot", '[label="/ferry/turtle1/cmd_vel"]'),
        ("mermaid", '-->|"/ferry/turtle1/cmd_vel"|'),
        ("graphml", "/ferry/turtle1/cmd_vel"),
        ("json", '"/ferry/turtle1/cmd_vel"'),
    ],
)
def test_graph(ferry: Ferry, form: str, edge: str) -> None:
    ran = ferry.run("graph", "--format", form, GOOD)
    assert ran.status == 0, ran.errors
    assert edge in ran.output
    assert "roslaunch" not in ran.output
    if form == "graphml":
        assert ElementTree.fromstring(ran.output).tag.endswith("graphml")
    if form == "json":
        assert json.loads(ran.output)["entry"] == GOOD


def test_graph_of_what_is_refused_names_the_launcher(ferry: Ferry) -> None:
    ran = ferry.run("graph", BROKEN)
    assert "refused by ros2 launch" in ran.output


def test_graph_diff(ferry: Ferry) -> None:
    ferry.change(HELM, "turtle1/cmd_vel", "turtle9/cmd_vel")
    ran = ferry.run("graph", "diff", "HEAD", GOOD)
    assert "lost: /ferry/helm → /ferry/sea on topic /ferry/turtle1/cmd_vel" in ran.output


def test_report(ferry: Ferry) -> None:
    ran = ferry.run("report", "-o", "report.html")
    assert ran.status == 0, ran.errors
    assert "refused by ros2 launch" in ran.errors + ran.output
    page = ferry.text("report.html")
    assert "/ferry/turtle1/cmd_vel" in page
    assert "LL947" in page


def test_format(ferry: Ferry) -> None:
    ferry.write(**{f"{LAUNCH}/x.launch.yaml": "launch:\n    -   node:\n         pkg:  joy  # why\n         exec: joy_node\n\n\n"})
    assert ferry.run("format", "--check").status == 1
    shown = ferry.run("format", "--diff").output
    assert "-         pkg:  joy  # why\n" in shown
    assert '+    <node name="dinghy" pkg="turtlesim" type="mimic"/>\n' in shown
    before = {name: ferry.run("model", "--format", "json", name).output for name in (GOOD, HELM)}
    assert ferry.run("format").status == 0
    assert ferry.run("format", "--check").status == 0
    assert ferry.text(f"{LAUNCH}/x.launch.yaml") == "launch:\n- node:\n    pkg:  joy  # why\n    exec: joy_node\n"
    assert {name: ferry.run("model", "--format", "json", name).output for name in before} == before


def test_export(ferry: Ferry) -> None:
    ran = ferry.run("export", "--to", "yaml", GOOD)
    assert ran.status == 0, ran.errors
    ferry.write(**{f"{LAUNCH}/exported.launch.yaml": ran.output})
    one, other = (ferry.loaded("model", "--format", "json", name) for name in (GOOD, f"{LAUNCH}/exported.launch.yaml"))
    assert [node["parameters"] for node in one["nodes"]] == [node["parameters"] for node in other["nodes"]]
    assert [node["namespace"] for node in other["nodes"]] == ["/ferry"] * 3


def test_both_dialects_are_one_run(ferry: Ferry) -> None:
    shutil.copytree(ROOT / "examples/turtles/turtle_parade", ferry.directory / "turtle_parade")
    ran = ferry.run("check")
    assert SHOWN in ran.output
    assert "show it: roslaunch turtle_parade/launch/" in ran.output
    findings = json.loads(ferry.run("check", "--format", "json", "--jobs", "2").output)["findings"]
    assert {each["path"].partition("/")[0] for each in findings} == {"ferry_bringup", "turtle_parade"}
    alone = json.loads(ferry.run("check", "--format", "json", "ferry_bringup").output)["findings"]
    assert [each for each in findings if each["path"].startswith("ferry")] == alone
