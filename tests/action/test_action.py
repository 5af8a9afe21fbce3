"""``action.yml``, its steps run as GitHub runs them."""

from __future__ import annotations

import json
import os
import subprocess
import sys
from pathlib import Path

import pytest

from tests.action.runner import Ran, Runner
from tests.cli.ferry import BROKEN, Ferry
from tests.cli.running import CLEAN, DOUBLE, PACKAGE, ROOT, UNUSED
from tests.workspace.repositories import Repository

TALKER = '#!/usr/bin/env python3\nimport rospy\nrospy.init_node("t")\n'
INPUTS = (
    *("paths", "args", "config", "library", "extract", "working_directory", "fail_on"),
    *("annotations", "summary", "sarif_file", "report", "picture", "base"),
)


pytestmark = pytest.mark.pypi  # the action installs launchlint


@pytest.fixture(scope="session")
def installed(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """RUNNER_TEMP of a job in which the action was used already."""
    temporary = tmp_path_factory.mktemp("runner")
    workspace = temporary / "workspace"
    workspace.mkdir()
    ran = Runner(ROOT, workspace, temporary / "temporary").run(python=sys.executable)
    assert ran.status == 0, ran.log
    return temporary / "temporary" / "launchlint"


@pytest.fixture
def repository(tmp_path: Path) -> Repository:
    made = Repository(tmp_path / "robot")
    made.write(**{"package.xml": PACKAGE.format(name="demo"), "launch/good.launch": CLEAN})
    made.write_bytes("scripts/talk.py", TALKER.encode())
    os.chmod(made.directory / "scripts/talk.py", 0o755)
    made.commit()
    return made


def run(repository: Repository, installed: Path, event: Path | None = None, /, **inputs: str) -> Ran:
    number = len(list(repository.directory.parent.glob("temporary*")))
    temporary = repository.directory.parent / f"temporary{number}"
    temporary.mkdir()
    (temporary / "launchlint").symlink_to(installed)
    return Runner(ROOT, repository.directory, temporary, event).run(**inputs)


def test_all_is_well(repository: Repository, installed: Path) -> None:
    ran = run(repository, installed)
    assert ran.status == 0, ran.log
    assert ran.log == "no problems in 1 launch file\n"
    assert ran.summary == "### launchlint: no problems in 1 launch file\n"
    assert {**ran.outputs, "sarif-file": ""} == {"sarif-file": "", "report": "", "picture": "", "findings": "0", "exit-code": "0"}
    assert json.loads(Path(ran.outputs["sarif-file"]).read_text())["version"] == "2.1.0"
    assert ran.used == {}


def test_an_error_is_annotated_and_fails_at_the_end(repository: Repository, installed: Path) -> None:
    repository.write(**{"launch/bad.launch": DOUBLE, "launch/unused.launch": UNUSED})
    ran = run(repository, installed, upload_sarif="true", category="nightly")
    assert ran.status == 1
    assert [line for line in ran.log.splitlines() if line.startswith("::")] == [
        (
            "::error file=launch/bad.launch,line=3,col=15,endLine=3,endColumn=21,title=LL301 duplicate-node-name::"
            "two nodes are named /talker%0Athe first one: launch/bad.launch:2:15"
            "%0Aroslaunch stops with: roslaunch file contains multiple nodes named [/talker]%0Ashow it: roslaunch launch/bad.launch"
            "%0Ahelp: remove the second one, which starts the same once more"
        ),
        "::warning file=launch/unused.launch,line=2,col=14,endLine=2,endColumn=19,title=LL206 unused-arg::the arg speed is never read"
        + next(line for line in ran.log.splitlines() if line.startswith("::warning")).partition("is never read")[2],
    ]
    assert ran.summary.splitlines()[:5] == [
        "### launchlint: 1 error, 1 warning in 3 launch files; of 3 entry files 2 load, 1 is refused by roslaunch",
        "",
        "| | rule | where | what |",
        "|---|---|---|---|",
        (
            "| 🛑 error | LL301 duplicate-node-name | launch/bad.launch&#58;3 | two nodes are named /talker"
            "<br>remove the second one, which starts the same once more |"
        ),
    ]
    assert (ran.outputs["findings"], ran.outputs["exit-code"]) == ("2", "1")
    (upload,) = ran.used.values()
    assert upload == {"sarif_file": ran.outputs["sarif-file"], "checkout_path": str(repository.directory), "category": "nightly"}


@pytest.mark.parametrize(("fail_on", "status"), [("warning", 1), ("error", 0), ("never", 0)])
def test_fail_on(repository: Repository, installed: Path, fail_on: str, status: int) -> None:
    repository.write(**{"launch/unused.launch": UNUSED})
    ran = run(repository, installed, fail_on=fail_on, annotations="false", summary="false")
    assert (ran.status, ran.outputs["exit-code"], ran.summary) == (status, str(status), "")
    assert "::" not in ran.log.replace("LL206", "")


def test_paths_files_and_args(repository: Repository, installed: Path) -> None:
    repository.write(
        **{
            "a b/one.launch": '<launch>\n  <arg name="n"/>\n  <node name="$(arg n)" pkg="demo" type="talk.py"/>\n</launch>\n',
            "a b/two.launch": DOUBLE,
            "other/bad.launch": DOUBLE,
            "a b/.launchlint.yaml": "severity: {LL301: warning}\n",
        }
    )
    ran = run(repository, installed, working_directory="a b", paths="one.launch\ntwo.launch\n", args="n:=x", sarif_file="out.sarif")
    assert ran.status == 0, ran.log
    assert "::warning file=a b/two.launch,line=3" in ran.log
    assert "other/bad" not in ran.log
    assert ran.outputs["sarif-file"] == str(repository.directory / "a b/out.sarif")


def test_a_pull_request_shows_what_it_changes(repository: Repository, installed: Path, tmp_path: Path) -> None:
    nodes = "".join(f'  <node name="{each}" pkg="turtlesim" type="{each}"/>\n' for each in ("turtlesim_node", "draw_square"))
    turtles = f"<launch>\n{nodes}</launch>\n"
    manifest = PACKAGE.format(name="demo").replace("</package>", "<exec_depend>turtlesim</exec_depend></package>")
    repository.write(**{"launch/good.launch": turtles, "package.xml": manifest})
    base = repository.commit()
    event = tmp_path / "event.json"
    event.write_text(json.dumps({"pull_request": {"base": {"sha": base}}}))
    ran = run(repository, installed, event)
    assert ran.summary == "### launchlint: no problems in 1 launch file\n\nNo connection changes.\n"
    remapped = turtles.replace('"draw_square"/>', '"draw_square">\n    <remap from="turtle1/pose" to="pose"/>\n  </node>')
    repository.write(**{"launch/good.launch": remapped})
    repository.commit()
    ran = run(repository, installed, event)
    assert "LL620 lost-connection" in ran.summary
    assert "\n#### What changes in the topology\n\n```mermaid\nflowchart" in ran.summary
    drawn = Path(ran.outputs["picture"]).read_text(encoding="utf-8")
    assert "launch/good.launch" in drawn
    assert 'class="line removed"' in drawn
    (kept,) = (given for action, given in ran.used.items() if action.startswith("actions/upload-artifact@"))
    assert (kept["name"], kept["path"]) == ("topology-launchlint", ran.outputs["picture"])
    ran = run(repository, installed, event, picture="none")
    assert ran.outputs["picture"] == ""
    ran = run(repository, installed, event, base="none")
    assert ("mermaid" in ran.summary, ran.outputs["picture"]) == (False, "")
    event.write_text(json.dumps({"pull_request": {"base": {"sha": "0" * 40}}}))
    ran = run(repository, installed, event)
    assert "::notice title=launchlint::what this pull request changes in the topology is not told" in ran.log


def test_the_report(repository: Repository, installed: Path) -> None:
    """A page for Pages or an artifact, in a directory that need not be there yet; what is found does not keep it from being made."""
    repository.write(**{"launch/bad.launch": DOUBLE})
    ran = run(repository, installed, report="site/index.html", fail_on="never")
    assert ran.status == 0, ran.log
    assert ran.outputs["report"] == str(repository.directory / "site/index.html")
    assert "two nodes are named /talker" in (repository.directory / "site/index.html").read_text(encoding="utf-8")


def test_what_cannot_be_done_is_an_annotation_and_fails(repository: Repository, installed: Path) -> None:
    ran = run(repository, installed, paths="gone.launch")
    assert ran.status == 2
    assert ran.log == (
        "::error title=launchlint::gone.launch: No such file or directory; give launch files, or directories to search for them\n"
    )
    assert ran.outputs == {"sarif-file": "", "report": "", "picture": "", "findings": "0", "exit-code": "2"}
    assert (
        run(repository, installed, annotations="perhaps").log == "::error title=launchlint::annotations: it is true or false, not perhaps\n"
    )
    assert run(repository, installed, working_directory="..").log == (
        "::error title=launchlint::working-directory: .. is no directory of this job's workspace\n"
    )


@pytest.mark.parametrize("name", INPUTS)
@pytest.mark.parametrize(
    "attempt",
    [
        "\"; touch pwned; ' || touch pwned; $(touch pwned) `touch pwned` #",
        "x\n::set-env name=PWNED::1\n%0A::error::pwned\n$(touch pwned)",
        "--write-baseline=pwned",
    ],
)
def test_no_input_is_taken_for_a_command(repository: Repository, installed: Path, name: str, attempt: str) -> None:
    ran = run(repository, installed, **{name: attempt})
    assert not [each for each in repository.directory.rglob("*pwned*") if each.name == "pwned"]
    for line in ran.log.splitlines():
        assert not line.startswith("::") or line.startswith(("::error title=launchlint::", "::notice title=launchlint::"))
    assert "PWNED" not in ran.outputs


def test_hostile_files(repository: Repository, installed: Path) -> None:
    """Names and values of a checked repository are no commands, no Markdown, and none of its modules is imported."""
    name = "x\n::error::pwned %0A|<img src=x>@all"
    repository.write(
        **{
            "launch/[x](y) ::error::|.launch": DOUBLE.replace("talker", "ta`|l<b>ker@all"),
            f"launch/{name}.launch": DOUBLE,
            "yaml.py": "open('pwned', 'w')",
            "click.py": "open('pwned', 'w')",
        }
    )
    ran = run(repository, installed)
    assert ran.status == 1
    assert not (repository.directory / "pwned").exists()
    for line in ran.log.splitlines():
        assert not line.startswith("::") or line.startswith(("::error file=launch/", "::warning file=launch/"))
    for line in ran.summary.splitlines():
        assert not any(word in line.replace("<br>", "") for word in ("<", "@all", "](", "`"))


def test_it_is_a_valid_action() -> None:
    tools = Path(sys.executable).parent
    for command in (
        [tools / "check-jsonschema", "--builtin-schema", "vendor.github-actions", "action.yml"],
        [tools / "zizmor", "--offline", "--quiet", "action.yml"],
    ):
        if not command[0].is_file():
            pytest.skip(f"{command[0].name} is not installed (it is part of the dev extra)")
        done = subprocess.run(command, cwd=ROOT, capture_output=True, text=True, check=False)
        assert done.returncode == 0, done.stdout + done.stderr


def test_launch_files_of_ros2(tmp_path: Path, installed: Path) -> None:
    ran = run(Ferry(tmp_path / "ferry"), installed, args="manual:=true")
    assert ran.status == 1
    assert f"::error file={BROKEN},line=9,col=7," in ran.log
    assert f"show it: ros2 launch {BROKEN} manual:=true" in ran.log
    assert "roslaunch" not in ran.log
    assert "refused by ros2 launch" in ran.summary.splitlines()[0]
    (only,) = json.loads(Path(ran.outputs["sarif-file"]).read_text())["runs"]
    assert {result["ruleId"] for result in only["results"]} == {"LL112", "LL901", "LL947"}
