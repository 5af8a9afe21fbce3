"""ROS's own fixtures: what roslaunch's unit tests call invalid is refused for the reason they mean, and everything else loads."""

from __future__ import annotations

import os
import subprocess
from pathlib import Path

import pytest

from launchlint.evaluate.ros1.launch import evaluate
from launchlint.evaluate.session import Session
from launchlint.rules.registry import rule_of
from launchlint.workspace.packages import Packages
from tests.evaluate.comparison import ENVIRONMENT, inside

XML = Path("ros+ros_comm", "tools", "roslaunch", "test", "xml")

INVALID: dict[str, tuple[str, ...]] = {
    "arg-invalid-include": ("LL212",),
    "arg-invalid-redecl": ("LL203",),
    "arg-invalid-sub": ("LL201",),
    "clear-params-invalid-1": ("LL105", "LL110"),
    "clear-params-invalid-2": ("LL110",),
    "clear-params-invalid-3": ("LL110",),
    "clear-params-invalid-4": ("LL109",),
    "if-unless-invalid-both": ("LL108",),
    "machine-invalid": ("LL109",),
    "machine-invalid-4": ("LL105",),
    "machine-invalid-5": ("LL105",),
    "machine-invalid-6": ("LL109",),
    "machine-invalid-7": ("LL109",),
    "machine-invalid-8": ("LL109",),
    "machine-invalid-9": ("LL111", "LL111"),
    "machine-invalid-10": ("LL111",),
    "machine-invalid-11": ("LL111", "LL111", "LL111"),
    "machine-invalid-12": ("LL111",),
    "node-invalid-cwd": ("LL109",),
    "node-invalid-env-name": ("LL105",),
    "node-invalid-env-name-2": ("LL109",),
    "node-invalid-env-value": ("LL105",),
    "node-invalid-exception": ("LL109",),
    "node-invalid-name-1": ("LL105",),
    "node-invalid-name-2": ("LL302",),
    "node-invalid-name-3": ("LL302",),
    # These also lack a name, which is all that roslaunch itself gets to see.
    "node-invalid-ns": ("LL105", "LL110"),
    "node-invalid-ns-2": ("LL105", "LL110"),
    "node-invalid-ns-3": ("LL105",),
    "node-invalid-output": ("LL105", "LL109"),
    "node-invalid-pkg": ("LL105", "LL105"),
    "node-invalid-pkg-2": ("LL105", "LL109"),
    "node-invalid-required-1": ("LL109",),
    "node-invalid-required-2": ("LL109",),
    "node-invalid-respawn": ("LL109",),
    "node-invalid-respawn-required": ("LL110",),
    "node-invalid-type": ("LL105",),
    "node-invalid-type-2": ("LL109",),
    "node-rosparam-invalid-name": ("LL105",),
    "params-invalid-1": ("LL110",),
    "params-invalid-2": ("LL105",),
    "params-invalid-3": ("LL110",),
    "params-invalid-4": ("LL110",),
    "remap-invalid-1": ("LL105",),
    "remap-invalid-2": ("LL105",),
    "remap-invalid-3": ("LL607",),
    "remap-invalid-4": ("LL607",),
    "remap-invalid-name-from": ("LL607",),
    "remap-invalid-name-to": ("LL607",),
    "rosparam-invalid-1": ("LL109",),
    "rosparam-invalid-2": ("LL502",),
    "rosparam-invalid-3": ("LL502",),
    "rosparam-invalid-4": ("LL109",),
    "rosparam-invalid-5": ("LL503",),
    "substitution-duplicate-anon-names": ("LL301",),
    "test-invalid-output": ("LL110", "LL110"),
    "test-invalid-reqd-1": ("LL105",),
    "test-invalid-reqd-2": ("LL105",),
    "test-invalid-respawn": ("LL110",),
    "test-invalid-retry": ("LL109",),
    "test-invalid-time-limit-1": ("LL109",),
    "test-invalid-time-limit-2": ("LL109",),
}
"""File (without ``test-`` and ``.xml``) → the rules of all reasons to refuse it, in order."""

LOADED_ONLY = {"node-valid": ("LL306",), "test-valid": ("LL306",)}
"""Files that roslaunch's tests load but could not launch: they name a machine that they do not define."""

UNKNOWABLE = ("params-invalid-5",)
"""Invalid only because the command of a param is not installed: that is not known without running it."""

PARTS = ("arg-invalid-included", "arg-invalid-include2")
"""Called invalid, but roslaunch loads them: one is wrong only for the file that includes it, the other includes it with
``pass_all_args``.
"""

GIVEN: dict[str, tuple[tuple[str, str], ...]] = {
    "test-arg.xml": (("required", "test_arg"), ("if_test", "0")),
    "test-arg-all.xml": (("required", "test_arg"),),
    "test-arg-include.xml": (("required", "test_arg"), ("include_arg", "included"), ("if_test", "0")),
    "test-ignore-unset-args.launch": (("foo", "1"),),
    "manual-test-remote-timeouts.launch": (("address", "host"), ("env_loader", "/env.sh"), ("user", "user")),
}
"""What has to be given to the files that need it."""

VARIABLES = {
    **ENVIRONMENT,
    "ADDRESS": "address",
    "NAME": "name",
    "OUTPUT": "screen",
    "PACKAGE": "package",
    "RESPAWN": "true",
    "TYPE": "type",
    "VALUE": "value",
}


def refusals(file: Path, workspaces: list[Path]) -> tuple[str, ...]:
    """The rules of all reasons to refuse ``file``, in order."""
    session = Session(Packages([str(each) for each in workspaces], VARIABLES, explicit=True), VARIABLES, str(file.parent))
    with inside(file.parent):
        launch = evaluate(session, str(file), GIVEN.get(file.name, ())).launch
    return tuple(rule_of(type(problem)) for problem in launch.problems if problem.refused)


@pytest.mark.corpus
def test_roslaunch_own_test_files(corpus: Path) -> None:
    directory = corpus / "ros1" / XML
    workspaces = [corpus / "ros1" / "ros+ros_comm", corpus / "ros1" / "ros+ros"]
    files = sorted(each for each in directory.iterdir() if each.suffix in (".xml", ".launch"))
    found = {each.stem.removeprefix("test-"): refusals(each, workspaces) for each in files}
    assert {name: rules for name, rules in found.items() if rules} == {**INVALID, **LOADED_ONLY}
    # Nothing that is called invalid is missing from the table above.
    assert {name for name in found if "invalid" in name} <= {*INVALID, *UNKNOWABLE, *PARTS}


@pytest.mark.ros
def test_installed_resources(ros_python: str) -> None:
    command = [ros_python, "-c", "import rospkg; print(rospkg.RosPack().get_path('roslaunch'))"]
    package = Path(subprocess.run(command, capture_output=True, text=True, check=True, env={**os.environ, **ENVIRONMENT}).stdout.strip())
    files = sorted((package / "resources").iterdir())
    found = {each.name: refusals(each, [package.parent]) for each in files if each.suffix in (".xml", ".launch")}
    # roscore.xml is what roslaunch loads before anything else: loaded once more, its node is there twice. And Debian's rosparam comes
    # without
    # the example.yaml that one example loads; roslaunch refuses both, too.
    missing = {} if (package.parent / "rosparam" / "example.yaml").is_file() else {"example-params.launch": ("LL502",)}
    assert {name: rules for name, rules in found.items() if rules} == {"roscore.xml": ("LL301",), **missing}
    assert len(found) >= 9
