"""Our way of probing against the paper's, node by node in one run: ``python -m tests.bench.probe [PACKAGE…]``.

The paper starts one roscore; of each node in turn it waits two seconds, asks the master who publishes and subscribes what, and
stops the node. Ours starts each node against a recording master of its own and stops it when nothing new comes. Both run the same
programs of this machine's ROS (those that are nodes at all; the paper starts the others too), alternately, so that the load of
the machine hits both alike. The figures are ratios within this run.

``--identical`` probes everything three more times, the last time with three jobs, and says whether the results are the same.
"""

from __future__ import annotations

import argparse
import json
import os
import signal
import subprocess
import sys
import time
import xmlrpc.client
from pathlib import Path
from typing import Any, NamedTuple

PROBE = Path(__file__).resolve().parent.parent.parent / "probe"
sys.path.insert(0, str(PROBE))

from launchlint_probe import discover, processes, session  # noqa: E402 (stands outside of the package)

PORT = 11399
WAIT = 2.0
"""Seconds that the paper waits for a node."""
PATIENCE = 15.0
"""Seconds that it waits for one to end, as roslaunch does."""


class Seen(NamedTuple):
    """What one way found of one node: publishers and subscribers of its own, those of others that were still listed, and seconds."""

    own: frozenset[str]
    foreign: frozenset[str]
    seconds: float


class Paper:
    """One master for all nodes, asked two seconds after each has been started."""

    def __init__(self) -> None:
        self.uri = f"http://127.0.0.1:{PORT}/"
        self._environment = {**os.environ, "ROS_MASTER_URI": self.uri, "ROS_IP": "127.0.0.1", "PATH": f"/usr/bin:{os.environ['PATH']}"}
        self._core = subprocess.Popen(
            ["roscore", "-p", str(PORT)],
            env=self._environment,
            stdout=subprocess.DEVNULL,
            stderr=subprocess.DEVNULL,
            start_new_session=True,
        )
        self._master = xmlrpc.client.ServerProxy(self.uri)
        end = time.monotonic() + 30
        while time.monotonic() < end:
            try:
                if any("/rosout" in nodes for _, nodes in self._state()[1]):
                    return
            except OSError:
                pass
            time.sleep(0.1)
        raise SystemExit("roscore does not start")

    def _state(self) -> Any:
        return self._master.getSystemState("/bench")[2]

    def probe(self, command: list[str]) -> Seen:
        began = time.monotonic()
        before = self._listed()
        mark = f"paper-{began}"
        environment = {**self._environment, processes.MARK: mark, "QT_QPA_PLATFORM": "offscreen", "HOME": "/tmp"}
        process = subprocess.Popen(
            command,
            env=environment,
            stdin=subprocess.DEVNULL,
            stdout=subprocess.DEVNULL,
            stderr=subprocess.DEVNULL,
            start_new_session=True,
            cwd="/tmp",
        )
        time.sleep(WAIT)
        after = self._listed()
        processes.stop(mark, process.pid, PATIENCE)
        process.wait()
        return Seen(frozenset(after - before), frozenset(after & before), time.monotonic() - began)

    def _listed(self) -> set[str]:
        """Everything that anybody is listed to publish or subscribe, as `rosnode info` shows it."""
        publishers, subscribers, _ = self._state()
        return {
            f"{way} {topic} {node}"
            for way, table in (("publishes", publishers), ("subscribes", subscribers))
            for topic, nodes in table
            for node in nodes
            if node != "/rosout" and not topic.startswith("/rosout")
        }

    def close(self) -> None:
        os.killpg(self._core.pid, signal.SIGINT)
        self._core.wait(30)


def ours(program: discover.Found) -> Seen:
    record = session.run(session.Plan(program.label, program.command))
    names = set()
    for category, ways in (("publishers", "publishes"), ("subscribers", "subscribes")):
        names |= {f"{ways} {entry['name']}" for entry in record["interface"].get(category, [])}
    for action in record["interface"].get("actions", []):
        topics = {"publishes": ("status", "feedback", "result"), "subscribes": ("goal", "cancel")}
        names |= {f"{way} {action['name']}/{topic}" for way, each in topics.items() for topic in each}
    return Seen(frozenset(names), frozenset(), record["seconds"])


def run_program(**job: Any) -> tuple[dict[str, Any], float]:
    """All records of the program for a job, without what is different each time; and the seconds it took."""
    began = time.monotonic()
    command = [sys.executable, "-I", str(PROBE / "launchlint_probe" / "__main__.py")]
    done = subprocess.run(command, input=json.dumps(job).encode(), capture_output=True, check=True)
    records = [json.loads(line) for line in done.stdout.splitlines()]
    kept = {f"{record['label']} {record['program']}": record for record in records if record["kind"] == "node"}
    for record in kept.values():
        del record["seconds"]
    return kept, time.monotonic() - began


def marked() -> list[int]:
    """Processes of nodes that are still there: those that carry any mark."""
    found = []
    for entry in Path("/proc").iterdir():
        try:
            if entry.name.isdigit() and processes.MARK.encode() in (entry / "environ").read_bytes() and int(entry.name) != os.getpid():
                found.append(int(entry.name))
        except OSError:  # noqa: PERF203 (processes end)
            continue
    return found


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("packages", nargs="*", help="default: all that are installed")
    parser.add_argument("--identical", action="store_true")
    options = parser.parse_args()
    seen = discover.see(discover.default_prefixes(), [])
    packages = options.packages or sorted(seen.programs)
    programs = [program for package in packages for program in discover.executables(package, seen.programs[package])]
    nodes = [program for program in programs if program.kind != "none"]
    print(f"{len(programs)} programs in {len(packages)} packages: {len(nodes)} nodes, {len(programs) - len(nodes)} that are none")
    paper = Paper()
    totals = {"ours": [0.0, 0, 0], "paper": [0.0, 0, 0]}
    polluted = 0
    try:
        for number, program in enumerate(nodes, 1):
            for way, found in (("ours", ours(program)), ("paper", paper.probe(program.command))):
                totals[way][0] += found.seconds
                totals[way][1] += len(found.own)
                totals[way][2] += len(found.foreign)
                polluted += way == "paper" and bool(found.foreign)
            sys.stderr.write(f"\r{number}/{len(nodes)} {program.label:60}")
        for program in programs:  # the paper does not know which programs are nodes
            if program.kind == "none":
                found = paper.probe(program.command)
                totals["paper"][0] += found.seconds
    finally:
        paper.close()
    sys.stderr.write("\n")
    for way, (seconds, own, foreign) in totals.items():
        per_program = f"{seconds / len(programs):5.2f} s a program"
        print(f"{way:6} {seconds:7.1f} s  {per_program}  {own:4} publishers and subscribers, {foreign:4} that belong to others")
    ratio = totals["ours"][0] / totals["paper"][0]
    print(f"ratio  {ratio:.2f} (aim: at most 0.5); polluted captures of the paper's way: {polluted} of {len(nodes)}")
    left = marked()
    print(f"processes left over: {left or 'none'}")
    if options.identical:
        job = {"packages": packages, "limits": {"jobs": 1}}
        first, one = run_program(**job)
        second, again = run_program(**job)
        third, three = run_program(packages=packages, limits={"jobs": 3})
        for what, other, seconds in (("second run", second, again), ("three jobs", third, three)):
            # the limits are part of a fingerprint
            different = sorted(label for label in first if {**first[label], "hash": ""} != {**other.get(label, {}), "hash": ""})
            print(f"{what}: {seconds:.0f} s (first: {one:.0f} s); different: {different or 'none'}")
        print(f"processes left over: {marked() or 'none'}")
    return 0


if __name__ == "__main__":
    sys.exit(main())
