"""Many launch files: launchlint's evaluation against the real roslaunch's loader, on the same files.

``python -m tests.bench.corpus DIRECTORY [--limit N] [--sample N]``. Both get ``DIRECTORY`` as the place of packages, and each file as it
stands, without args.
"""

from __future__ import annotations

import argparse
import json
import os
import sys
import tempfile
from pathlib import Path
from statistics import median

from tests.bench.timing import Timed, by_turns, launchlint, milliseconds, ros_environment, ros_python, table, timed

PEER = Path(__file__).with_name("roslaunch_peer.py")
LAUNCH_FILES = (".launch", ".test", ".launch.xml")


def launch_files(directory: Path) -> list[str]:
    """All launch files below ``directory`` by name, sorted."""
    found = []
    for parent, folders, names in os.walk(directory):
        folders.sort()
        found += [os.path.join(parent, name) for name in sorted(names) if name.endswith(LAUNCH_FILES)]
    return found


def own_run(files: list[str], directory: Path, environment: dict[str, str], scratch: Path) -> tuple[Timed, int]:
    """Evaluate all ``files`` in one launchlint; return what it took, and for how many its verdict is ok."""
    entries = scratch / "entries.json"
    entries.write_text(json.dumps([{"file": file} for file in files]), encoding="utf-8")
    run = timed(launchlint("model", "--workspace", str(directory), "--format", "jsonl", "--entries", str(entries)), environment)
    lines = run.output.splitlines()
    if len(lines) != len(files):
        raise SystemExit(f"launchlint model ended with status {run.status} after {len(lines)} of {len(files)} files")
    return run, sum(json.loads(line)["verdict"] == "ok" for line in lines)


def peer_run(interpreter: str, files: list[str], environment: dict[str, str], scratch: Path) -> tuple[Timed, dict[str, float]]:
    """Load all ``files`` in one roslaunch; return what it took, and its own account."""
    result = scratch / "peer.json"
    run = timed([interpreter, str(PEER), str(result)], environment, stdin="\n".join(files).encode())
    if run.status:
        raise SystemExit(f"roslaunch ended with status {run.status}")
    account: dict[str, float] = json.loads(result.read_text(encoding="utf-8"))
    return run, account


def each_alone(interpreter: str, files: list[str], directory: Path, environment: dict[str, str]) -> tuple[float, float]:
    """Median seconds per file of launchlint and of roslaunch, a fresh process for each file, by turns."""
    own, peer = [], []
    for file in files:
        commands = {
            "launchlint": launchlint("check", "--no-cache", "--workspace", str(directory), file),
            "roslaunch": [interpreter, "-c", "import sys, roslaunch; sys.argv[0] = 'roslaunch'; roslaunch.main()", "--nodes", file],
        }
        results = by_turns(commands, 1, environment)
        own.append(results["launchlint"].median)
        peer.append(results["roslaunch"].median)
    return median(own), median(peer)


def main() -> int:
    """Measure, print, and return the exit status."""
    parser = argparse.ArgumentParser(description="Time the evaluation of many launch files against roslaunch's loader.")
    parser.add_argument("directory", type=Path, help="where the launch files and their packages are")
    parser.add_argument("--limit", type=int, default=0, help="take only so many files, evenly spread (default: all)")
    parser.add_argument("--runs", type=int, default=3, help="runs of each, by turns (default: 3)")
    parser.add_argument("--sample", type=int, default=20, help="files that get a process each (default: 20)")
    arguments = parser.parse_args()
    directory: Path = arguments.directory.resolve()
    files = launch_files(directory)
    if arguments.limit:
        files = files[:: max(1, len(files) // arguments.limit)][: arguments.limit]
    if not files:
        raise SystemExit(f"no launch file below {directory}")
    interpreter = ros_python()
    if interpreter is None:
        raise SystemExit("no Python here can import roslaunch (Debian: apt-get install python3-roslaunch)")
    environment = ros_environment(directory)
    own, peer, inside = [], [], []
    own_ok, peer_ok = 0, 0
    with tempfile.TemporaryDirectory() as scratch:
        for _ in range(arguments.runs):
            run, own_ok = own_run(files, directory, environment, Path(scratch))
            own.append(run.seconds)
            other, account = peer_run(interpreter, files, environment, Path(scratch))
            peer.append(other.seconds)
            inside.append(account["load"])
            peer_ok = int(account["loaded"])
    count = len(files)
    rows = [
        ["launchlint model", f"{median(own):.2f}", milliseconds(median(own) / count), str(own_ok), "1.0"],
        [
            "roslaunch, whole process",
            f"{median(peer):.2f}",
            milliseconds(median(peer) / count),
            str(peer_ok),
            f"{median(peer) / median(own):.1f}",
        ],
        [
            "roslaunch, loading alone",
            f"{median(inside):.2f}",
            milliseconds(median(inside) / count),
            str(peer_ok),
            f"{median(inside) / median(own):.1f}",
        ],
    ]
    print(f"{count} files, one process for all of them, {arguments.runs} runs by turns\n")
    print(table(["in one process", "seconds", "ms per file", "files that load", "times launchlint"], rows))
    if arguments.sample:
        sample = files[:: max(1, count // arguments.sample)][: arguments.sample]
        own_alone, peer_alone = each_alone(interpreter, sample, directory, environment)
        check = launchlint("check", "-q", "--no-cache", "--jobs", "1", "--workspace", str(directory), *files)
        whole = timed(check, environment).seconds / count
        rows = [
            [f"launchlint check, all {count} files in one run", milliseconds(whole), "1.0"],
            ["launchlint check, a process for each file", milliseconds(own_alone), f"{own_alone / whole:.1f}"],
            ["roslaunch --nodes, a process for each file", milliseconds(peer_alone), f"{peer_alone / whole:.1f}"],
        ]
        print(f"\nroslaunch takes one file at a time; processes for one file each: median of {len(sample)} of these files\n")
        print(table(["as people run them", "ms per file", "times launchlint"], rows))
    print("\nHow to read it: 'times launchlint' is how much longer the peer takes for the same files; larger is better for launchlint.")
    print("launchlint's figures include the JSON it prints for each file; roslaunch's loader prints nothing, and its commands are not run.")
    return 0


if __name__ == "__main__":
    sys.exit(main())
