"""The programs of ``nodes/`` as an installed package, probed by the real program in a process of its own."""

from __future__ import annotations

import json
import shutil
import subprocess
import sys
from pathlib import Path
from typing import Any

HERE = Path(__file__).resolve().parent
PROGRAM = HERE.parent.parent / "probe" / "launchlint_probe" / "__main__.py"
PACKAGE = "odd_nodes"


MESSAGES = {
    "std_msgs/msg/String.msg": "string data\n",
    "std_msgs/msg/Header.msg": "uint32 seq\ntime stamp\nstring frame_id\n",
    "rosgraph_msgs/msg/Clock.msg": "time clock\n",
    "actionlib_msgs/msg/GoalID.msg": "time stamp\nstring id\n",
    "actionlib_msgs/msg/GoalStatus.msg": "GoalID goal_id\nuint8 status\nuint8 SUCCEEDED=3\nstring text\n",
    "actionlib_msgs/msg/GoalStatusArray.msg": "Header header\nGoalStatus[] status_list\n",
    "odd_msgs/msg/MoveResult.msg": "float64[2] place\n",
    "odd_msgs/msg/MoveFeedback.msg": "",
    "odd_msgs/msg/MoveActionResult.msg": "Header header\nactionlib_msgs/GoalStatus status\nMoveResult result\n",
    "odd_msgs/msg/MoveActionFeedback.msg": "Header header\nactionlib_msgs/GoalStatus status\nMoveFeedback feedback\n",
    "odd_msgs/srv/Load.srv": "string file\n---\nbool good\nint32[] cells\nstring why\n",
}
"""What the install space has of messages and services."""


def install(prefix: Path, names: list[str] | None = None) -> Path:
    """Make ``prefix`` an install space with the package ``odd_nodes``; each program says that it is a rospy node."""
    programs = prefix / "lib" / PACKAGE
    share = prefix / "share" / PACKAGE
    programs.mkdir(parents=True)
    share.mkdir(parents=True)
    (share / "package.xml").write_text(f"<package format='2'><name>{PACKAGE}</name><version>4.5.6</version></package>\n")
    for path, text in MESSAGES.items():
        file = prefix / "share" / path
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(text)
        (prefix / "share" / path.split("/")[0] / "package.xml").write_text(f"<package><name>{path.split('/')[0]}</name></package>\n")
    for script in sorted((HERE / "nodes").glob("*.py")):
        target = programs / script.name
        if script.name == "wire.py":
            shutil.copyfile(script, target)
        elif names is None or script.name in names:
            target.write_text(script.read_text() + "\n# stands for a rospy node\n")
            target.chmod(0o755)
    return prefix


def run(job: dict[str, Any], timeout: float = 120) -> list[dict[str, Any]]:
    """The records that the program makes of a job."""
    done = subprocess.run(
        [sys.executable, "-I", str(PROGRAM)], input=json.dumps(job).encode(), capture_output=True, timeout=timeout, check=False
    )
    assert done.stderr == b"", done.stderr.decode()
    return [json.loads(line) for line in done.stdout.splitlines()]


def processes_with(text: str) -> list[str]:
    """The command lines of all processes that hold ``text``."""
    found = []
    for entry in Path("/proc").iterdir():
        if entry.name.isdigit():
            try:
                line = (entry / "cmdline").read_bytes().replace(b"\0", b" ").decode("utf-8", "replace")
            except OSError:
                continue
            if text in line:
                found.append(line)
    return found
