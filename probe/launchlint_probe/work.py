"""All nodes of a job: which, in what order, how many at once; one record for each, as soon as it is there."""

import hashlib
import json
import os
import shutil
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor, as_completed
from typing import Any, Dict, Iterator, List, Optional, Tuple

from launchlint_probe import discover, session

Job = Dict[str, Any]
Record = Dict[str, Any]

LONGEST_LINE = 8 * 1024 * 1024
"""Bytes of one record; the interface of a node that has more is left out."""


def say(record: Record) -> None:
    """Write one line of JSON to standard output, whole."""
    line = json.dumps(record, sort_keys=True, default=str)
    if len(line) > LONGEST_LINE:
        record = dict(record, interface={}, status="failed", problems=[{"code": "too-large", "detail": "its interface is too large"}])
        line = json.dumps(record, sort_keys=True, default=str)
    sys.stdout.write(line + "\n")
    sys.stdout.flush()


def found_programs(job: Job) -> List[discover.Found]:
    """The programs of the packages that the job names, sorted."""
    prefixes = job.get("prefixes") or discover.default_prefixes()
    known = discover.packages(prefixes)
    wanted = job.get("packages") or sorted(known)
    loader = _loader(known)
    programs = []  # type: List[discover.Found]
    for package in wanted:
        if package not in known:
            say({"kind": "package", "package": package, "status": "missing"})
            continue
        programs.extend(discover.executables(package, known[package]))
        programs.extend(discover.nodelets(prefixes, package, loader))
    return sorted(programs, key=lambda each: (each.package, each.kind == "nodelet", each.name))


def _loader(known: Dict[str, List[str]]) -> Optional[str]:
    paths = [os.path.join(directory, "nodelet") for directory in known.get("nodelet", [])]
    return next((path for path in paths if os.access(path, os.X_OK)), None)


def is_mine(label: str, shard: Optional[List[int]]) -> bool:
    """Whether a program belongs to shard ``[number, count]`` (numbers begin at 1)."""
    if not shard:
        return True
    return int(hashlib.sha256(label.encode("utf-8", "replace")).hexdigest(), 16) % shard[1] == shard[0] - 1


def plans(job: Job, program: discover.Found) -> Iterator[Tuple[str, Dict[str, Any], session.Plan]]:
    """The ways in which a program is run: the default one, and the variants that the job asks for."""
    override = job.get("nodes", {}).get(program.label, {})
    variants = dict(override.get("variants", {}))
    variants.setdefault("default", {})
    for name in sorted(variants, key=lambda each: (each != "default", each)):
        settings = {key: value for key, value in override.items() if key != "variants"}
        for key, value in variants[name].items():
            settings[key] = dict(settings[key], **value) if isinstance(value, dict) and isinstance(settings.get(key), dict) else value
        limits = job.get("limits", {})
        yield name, settings, session.Plan(
            program.label,
            program.command + session.split(settings.get("args", "")),
            settings.get("params"),
            settings.get("remap"),
            settings.get("env"),
            settings.get("files"),
            settings.get("quiet", limits.get("quiet", 1.0)),
            settings.get("limit", limits.get("limit", 15.0)),
        )


def run_all(job: Job) -> int:
    """Probe all nodes of a job. Returns the number of processes that could not be ended: 0, if all is well."""
    done = set(job.get("done", []))
    skip = set(job.get("skip", []))
    todo = []  # type: List[Tuple[discover.Found, str, Dict[str, Any], session.Plan, str]]
    for program in found_programs(job):
        if program.label in skip or program.package in skip or not is_mine(program.label, job.get("shard")):
            continue
        if program.kind == "none":
            say(_record(program, "default", {}, "", {"status": "not-a-node", "interface": {}, "problems": [], "seconds": 0.0, "left": []}))
            continue
        for variant, settings, plan in plans(job, program):
            mark = discover.fingerprint(program, [variant, settings, job.get("limits"), job.get("environment")])
            if mark not in done:
                todo.append((program, variant, settings, plan, mark))
    say({"kind": "plan", "count": len(todo)})
    left = 0
    with ThreadPoolExecutor(max_workers=max(1, int(job.get("limits", {}).get("jobs", 2)))) as pool:
        waiting = {pool.submit(_once, each[3]): each for each in todo}
        for future in as_completed(waiting):
            program, variant, settings, _, mark = waiting[future]
            record = _record(program, variant, settings, mark, future.result())
            left += len(record["left"])
            say(record)
    return left


def _once(plan: session.Plan) -> Record:
    """Run a node; once more without a name where it choked on that."""
    record = session.run(plan)
    texts = " ".join(problem["detail"] for problem in record["problems"])
    if record["status"] == "failed" and ("__name" in texts or "__log" in texts):
        plan.with_name = False
        record = session.run(plan)
    return record


def _record(program: discover.Found, variant: str, settings: Dict[str, Any], mark: str, record: Record) -> Record:
    return dict(record, kind="node", label=program.label, package=program.package, name=program.name, program=program.kind, variant=variant, settings=settings, hash=mark)


def environment() -> Record:
    """What this machine or container is."""
    distro = os.environ.get("ROS_DISTRO") or _ros_version()
    return {"kind": "environment", "distro": distro, "base": _os_name(), "rospack": shutil.which("rospack") or ""}


def _ros_version() -> str:
    try:
        done = subprocess.run(["dpkg-query", "-W", "-f", "${Version}", "libroscpp-dev"], stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, timeout=10)
        return "debian " + done.stdout.decode("ascii", "replace").strip() if done.returncode == 0 else ""
    except (OSError, subprocess.TimeoutExpired):
        return ""


def _os_name() -> str:
    try:
        with open("/etc/os-release", encoding="utf-8") as file:
            for line in file:
                if line.startswith("PRETTY_NAME="):
                    return line.partition("=")[2].strip().strip('"')
    except OSError:
        pass
    return ""
