"""Sources that somebody wrote to break what reads them: nothing crashes, hangs, or reads what is not of the workspace."""

from __future__ import annotations

import os
from pathlib import Path

import pytest

from launchlint.knowledge.checked import checked
from launchlint.knowledge.own import OwnSources
from launchlint.workspace.packages import Packages
from tests.cli.running import write
from tests.knowledge.conftest import CMAKE, TALKER

SCRIPT = ("demo", "executables", "talker.py")
PROGRAM = ("other", "executables", "other_node")


def own(workspace: Path) -> OwnSources:
    return OwnSources(Packages([str(workspace)], {}, explicit=True), str(workspace))


@pytest.mark.parametrize(
    "text",
    [
        "(" * 50_000,
        "x = " + "-" * 50_000 + "1",
        "import rospy\n\0\n",
        "#!/usr/bin/env python3\n" + "def f():\n" * 3,
        "#!/usr/bin/env python3\nimport rospy\ndef f(n):\n  return f(n + 1)\nf(0)\nwhile True:\n  rospy.Publisher(f(1))\n",
        "#" * (2 << 20),
    ],
)
def test_a_script_that_cannot_be_read_is_not_known_or_open(workspace: Path, text: str) -> None:
    write(workspace, {"demo/scripts/talker.py": text})
    sources = own(workspace)
    program = sources.program(*SCRIPT)
    assert (program is None and sources.reason(*SCRIPT)) or program["class"] == "none" or program["variants"]["default"]["open"]


@pytest.mark.parametrize("text", ["{" * 20_000, "int main() {" + "f(" * 20_000, "\0" * 1000, '#include "other.cpp"\n' * 1000])
def test_a_program_that_cannot_be_read_is_not_known_or_open(workspace: Path, text: str) -> None:
    write(workspace, {"other/src/other.cpp": text})
    sources = own(workspace)
    program = sources.program(*PROGRAM)
    assert (program is None and sources.reason(*PROGRAM)) or program["class"] == "none" or program["variants"]["default"]["open"]


def test_what_lies_outside_of_the_workspace_is_not_read(workspace: Path, tmp_path: Path) -> None:
    write(tmp_path, {"secret/talker.py": TALKER, "secret/other.cpp": "int main() {}\n"})
    (workspace / "demo/scripts/talker.py").unlink()
    (workspace / "demo/scripts/talker.py").symlink_to(tmp_path / "secret/talker.py")
    write(workspace, {"other/CMakeLists.txt": CMAKE.replace("src/other.cpp", str(tmp_path / "secret/other.cpp"))})
    sources = own(workspace)
    assert sources.program(*SCRIPT) is None
    assert sources.program(*PROGRAM) is None
    assert sources.reason(*PROGRAM) == "its source files are not here"


def test_links_that_lead_in_circles_and_pipes(workspace: Path) -> None:
    (workspace / "demo/scripts/up").symlink_to(workspace)
    (workspace / "other/src/loop.h").symlink_to(workspace / "other/src/loop.h")
    write(workspace, {"other/src/other.cpp": '#include "loop.h"\n#include "pipe.h"\nint main() { return 0; }\n'})
    os.mkfifo(workspace / "other/src/pipe.h")
    sources = own(workspace)
    assert sources.program(*SCRIPT) is not None
    assert sources.program(*PROGRAM) is not None


def test_a_mistake_of_launchlint_itself_is_a_reason(workspace: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    def fails(*_: object) -> None:
        raise KeyError("oops")

    monkeypatch.setattr("launchlint.knowledge.reading.ProgramReader.read", fails)
    sources = own(workspace)
    assert sources.program(*SCRIPT) is None
    assert sources.reason(*SCRIPT) == "launchlint failed to read it: KeyError: 'oops'"


def test_what_is_no_name_is_left_out_and_open() -> None:
    good, bad = {"name": "a", "evidence": [{"by": "static", "at": ":x.py:1"}]}, {"name": "{param:{any}/x|y}"}
    program, reason = checked({"class": "roscpp", "variants": {"default": {"publishers": [bad, good, bad]}}}, "executables")
    assert reason == ""
    assert program is not None
    assert program["variants"]["default"] == {"publishers": [good], "open": {"publishers": "a name that is not known"}}
    assert checked({"class": "nonsense"}, "executables")[0] is None
