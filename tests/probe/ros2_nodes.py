"""The programs of ``nodes_ros2/`` as an installed package, probed by the real program: with the ROS 2 of this machine where there is
one, else with what its observer said when it was recorded.

``python -m tests.probe.ros2_nodes`` records anew; it needs a ROS 2 (see :func:`installation`).
"""

from __future__ import annotations

import json
import os
import shutil
import subprocess
import sys
from pathlib import Path
from typing import Any

HERE = Path(__file__).resolve().parent
PROBE = HERE.parent.parent / "probe"
RECORDINGS = HERE / "recordings"
PACKAGE = "odd_ros2"
VARIABLE = "LAUNCHLINT_ROS2"
"""Names the directory of an installation of ROS 2 with rclpy, std_msgs, std_srvs and example_interfaces; else one in /opt/ros counts."""

RECORDED = (
    "acts.py",
    "own_namespace.py",
    "random_names.py",
    "refuses_to_configure.py",
    "several.py",
    "stateful.py",
    "takes_any.py",
    "talks.py",
    "waits_for_message.py",
    "wants_args.py",
)
"""Programs that are as they are wherever they run: what was said of them is replayed."""
SETTINGS = {f"{PACKAGE}/wants_args.py": {"args": "{}", "params": {"~topic": "a/{}"}}}
STAND_IN = "#!/usr/bin/env python3\n# stands for a node of rclpy\nimport time\ntime.sleep(120)\n"


def installation() -> Path | None:
    """The ROS 2 of this machine."""
    named = os.environ.get(VARIABLE)
    places = [Path(named)] if named else sorted(Path("/opt/ros").glob("*"))
    return next((place for place in places if (place / "share" / "rclpy").is_dir()), None)


def environment(place: Path) -> dict[str, str]:
    """The variables of this process after the setup file of an installation."""
    known = {key: value for key, value in os.environ.items() if key not in ("PYTHONPATH", "AMENT_PREFIX_PATH")}
    known.update(COLCON_CURRENT_PREFIX=str(place), AMENT_CURRENT_PREFIX=str(place))
    script = f". {place}/local_setup.sh >/dev/null 2>&1; env -0"
    told = subprocess.run(["sh", "-c", script], env=known, capture_output=True, timeout=60, check=True).stdout
    found = dict(each.split("=", 1) for each in told.decode().split("\0") if "=" in each)
    return {key: value for key, value in found.items() if not key.endswith("_CURRENT_PREFIX")}


def install(prefix: Path, names: list[str], *, stand_in: bool = False) -> Path:
    """Make ``prefix`` an install space with the package ``odd_ros2``."""
    programs, share = prefix / "lib" / PACKAGE, prefix / "share" / PACKAGE
    programs.mkdir(parents=True)
    share.mkdir(parents=True)
    (share / "package.xml").write_text(f"<package format='3'><name>{PACKAGE}</name><version>1.2.3</version></package>\n")
    for name in names:
        target = programs / name
        if stand_in:
            target.write_text(STAND_IN)
        else:
            shutil.copyfile(HERE / "nodes_ros2" / name, target)
        target.chmod(0o755)
    return prefix


def run(job: dict[str, Any], variables: dict[str, str], observer: Path | None = None, timeout: float = 300) -> list[dict[str, Any]]:
    """The records that the program makes of a job. ``observer`` stands for the Python that runs the observer."""
    command = [sys.executable, "-I", str(PROBE / "launchlint_probe" / "__main__.py")]
    if observer is not None:
        patch = (
            f"import sys; sys.path.insert(0, {str(PROBE)!r}); from launchlint_probe import ros2, __main__; "
            f"ros2.python_with_rclpy = lambda: {str(observer)!r}; sys.exit(__main__.main())"
        )
        command = [sys.executable, "-I", "-c", patch]
    done = subprocess.run(command, input=json.dumps(job).encode(), env=variables, capture_output=True, timeout=timeout, check=False)
    assert done.stderr == b"", done.stderr.decode()
    return [json.loads(line) for line in done.stdout.splitlines()]


def job(prefix: Path, name: str = "", **limits: Any) -> dict[str, Any]:
    """A job for all programs of the package, or one."""
    found: dict[str, Any] = {"prefixes": [str(prefix)], "packages": [PACKAGE], "nodes": SETTINGS}
    if name:
        found["programs"] = [f"{PACKAGE}/{name}"]
        found["nodes"] = {label: known for label, known in SETTINGS.items() if label == f"{PACKAGE}/{name}"}
    else:
        found["nodes"] = {label: known for label, known in SETTINGS.items() if (prefix / "lib" / label).exists()}
    return {**found, "limits": {"quiet": 1.0, "limit": 12, "jobs": 1, **limits}}


def stand_in(directory: Path, recording: Path, mode: str) -> Path:
    """A program to be called as the Python that has rclpy: it replays a recording, or runs the observer and records."""
    program = directory / "python"
    program.write_text(
        f'#!/bin/sh\nexec {sys.executable} {HERE / "ros2_observer.py"} {mode} {recording} {directory / "count"} "$@"\n', encoding="utf-8"
    )
    program.chmod(0o755)
    return program


def replayed(directory: Path, name: str) -> dict[str, Any]:
    """The record of a program whose observer is a recording."""
    prefix = install(directory / "prefix", [name], stand_in=True)
    observer = stand_in(directory, RECORDINGS / f"{name}.jsonl", "replay")
    variables = {**os.environ, "AMENT_PREFIX_PATH": str(prefix), "ROS_DISTRO": "jazzy"}
    (record,) = [each for each in run(job(prefix, name), variables, observer) if each["kind"] == "node"]
    return record


def main() -> int:
    """Record."""
    import tempfile

    place = installation()
    if place is None:
        sys.exit(f"there is no ROS 2 here; name one by {VARIABLE}")
    variables = environment(place)
    for name in RECORDED:
        recording = RECORDINGS / f"{name}.jsonl"
        recording.unlink(missing_ok=True)
        with tempfile.TemporaryDirectory() as directory:
            prefix = install(Path(directory) / "prefix", [name])
            run(job(prefix, name), variables, stand_in(Path(directory), recording, "record"))
    return 0


if __name__ == "__main__":
    sys.exit(main())
