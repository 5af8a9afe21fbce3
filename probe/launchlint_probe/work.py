"""All nodes and launch files of a job: which, in what order, how many at once; one record for each, as soon as it is there."""

import hashlib
import json
import os
import shutil
import sys
import tempfile
import threading
from concurrent.futures import ThreadPoolExecutor, as_completed
from functools import partial
from typing import Any, Callable, Dict, Iterator, List, Optional, Tuple

from launchlint_probe import changing, discover, processes, session
from launchlint_probe.bounds import Bounds
from launchlint_probe.installation import Installation, about, here
from launchlint_probe.plan import Plan

Job = Dict[str, Any]
Record = Dict[str, Any]

LONGEST_LINE = 4 * 1024 * 1024
"""Characters of one record; the interface of a node that has more is left out."""
REPORTS = ("build.json", "dependencies.json")
"""What building the image has left for whoever reads the records: lists of records."""

_saying = threading.Lock()


class Task:
    """One run: what ``call`` makes of it is put into ``frame``, which names it."""

    def __init__(self, frame: Record, call: Callable[[], Record]) -> None:
        self.frame = frame
        self.call = call


def say(record: Record) -> None:
    """Write one line of JSON to standard output, whole."""
    line = json.dumps(record, sort_keys=True, default=str)
    if len(line) > LONGEST_LINE:
        record = dict(
            record, interface={}, messages={}, status="failed", problems=[{"code": "too-large", "detail": "its interface is too large"}]
        )
        line = json.dumps(record, sort_keys=True, default=str)
    with _saying:
        try:
            sys.stdout.write(line + "\n")
            sys.stdout.flush()
        except BrokenPipeError:  # whoever wanted to know has gone: nothing of this must go on
            leave(141)


def leave(code: int) -> None:
    """End at once, with everything that was started, and leave no files behind."""
    processes.end_all()
    if tempfile.tempdir is not None:
        shutil.rmtree(tempfile.tempdir, ignore_errors=True)
    os._exit(code)


def run_all(job: Job) -> int:
    """Do a job. Returns the number of processes that could not be ended: 0, if all is well.

    Keys of the job, all optional: ``packages`` (names), ``everything`` (all packages that can be seen, not only those of source spaces),
    ``programs`` (labels; all others are left out), ``skip`` (packages and labels), ``nodes`` (label → settings), ``launch``, ``limits``
    (``quiet``, ``limit``, ``jobs``; of each node ``memory`` and ``disk`` in bytes, ``processes``), ``shard`` (number from 1, count),
    ``done`` (fingerprints of what need not be run), ``only`` (those of what shall), ``prefixes``, ``sources`` (source spaces), ``reports``
    (a directory), ``image``.
    """
    processes.adopt()
    installation = here(job)
    for name in REPORTS if job.get("reports") else ():
        _report(os.path.join(job["reports"], name))
    tasks = list(_node_tasks(job, _programs(job, installation), installation)) + list(_launch_tasks(job, installation))
    done = set(job.get("done", []))
    only = set(job.get("only", []))
    todo = [task for task in tasks if task.frame["hash"] not in done and (not only or task.frame["hash"] in only)]
    say({"kind": "plan", "count": len(todo), "all": len(tasks)})
    left = 0
    with ThreadPoolExecutor(max_workers=max(1, int(job.get("limits", {}).get("jobs", 2)))) as pool:
        waiting = {pool.submit(_do, task): task for task in todo}
        for future in as_completed(waiting):
            record = dict(future.result(), **waiting[future].frame)
            if record["kind"] == "node":
                record["messages"] = installation.messages(record)
            left += len(record["left"])
            say(record)
    return max(left, len(processes.end_all()))


def _do(task: Task) -> Record:
    say({"kind": "start", "label": task.frame["label"], "hash": task.frame["hash"], "frame": task.frame})
    return task.call()


def _programs(job: Job, installation: Installation) -> List[discover.Found]:
    """The programs of the packages that the job names, sorted."""
    seen = installation.packages
    wanted = job.get("packages") or sorted(seen.programs if job.get("everything") or not seen.sources else seen.sources)
    programs: List[discover.Found] = []
    skip = set(job.get("skip", []))
    for package in wanted:
        if package in skip:
            continue
        known = package in seen.programs
        say({"kind": "package", "package": package, "status": "found" if known else "missing", "version": _version(seen, package)})
        if known:
            programs.extend(installation.programs(package))
    labels = {program.label for program in programs}
    chosen = set(job.get("programs", []))
    for label in sorted((set(job.get("nodes", {})) | chosen) - labels):
        say({"kind": "unknown", "label": label})
    programs = [program for program in programs if not chosen or program.label in chosen]
    programs = [program for program in programs if program.label not in skip and is_mine(program.label, job.get("shard"))]
    return sorted(programs, key=lambda each: (each.package, each.kind in ("nodelet", "component"), each.name))


def _version(seen: discover.Packages, package: str) -> str:
    for directory in seen.shares.get(package, []):
        found = discover.manifest_text(os.path.join(directory, "package.xml"), "version")
        if found:
            return found
    return ""


def is_mine(label: str, shard: Optional[List[int]]) -> bool:
    """Whether a program belongs to shard ``[number, count]`` (numbers begin at 1)."""
    if not shard:
        return True
    return int(hashlib.sha256(label.encode("utf-8", "replace")).hexdigest(), 16) % shard[1] == shard[0] - 1


def _node_tasks(job: Job, programs: List[discover.Found], installation: Installation) -> Iterator[Task]:
    for program in programs:
        for variant, settings, plan in plans(job, program):
            mark = discover.fingerprint(program, [variant, settings, _times(job), job.get("image")])
            frame = {
                "kind": "node",
                "label": program.label,
                "package": program.package,
                "name": program.name,
                "program": program.kind,
                "variant": variant,
                "hash": mark,
                "digest": discover.digest(program),
            }
            if program.kind == "none":
                if variant == "default":
                    yield Task(frame, partial(_not_run, "not-a-node"))
            else:
                yield Task(frame, partial(_twice, plan, installation))


def _times(job: Job) -> List[Any]:
    """Of the limits of a job those that what a run shows hangs on: how many nodes run at once is not among them."""
    limits = job.get("limits", {})
    return [limits.get("quiet"), limits.get("limit")]


def plans(job: Job, program: discover.Found) -> Iterator[Tuple[str, Dict[str, Any], Plan]]:
    """The ways in which a program is run: the default one, and the variants that the job asks for."""
    override = job.get("nodes", {}).get(program.label, {})
    variants = dict(override.get("variants", {}))
    variants.setdefault("default", {})
    for name in sorted(variants, key=lambda each: (each != "default", each)):
        settings = {key: value for key, value in override.items() if key != "variants"}
        for key, value in variants[name].items():
            settings[key] = dict(settings[key], **value) if isinstance(value, dict) and isinstance(settings.get(key), dict) else value
        limits = job.get("limits", {})
        yield (
            name,
            settings,
            Plan(
                program.label,
                program.command,
                settings.get("params"),
                settings.get("remap"),
                settings.get("env"),
                settings.get("files"),
                settings.get("quiet", limits.get("quiet", 1.0)),
                settings.get("limit", limits.get("limit", 15.0)),
                arguments=settings.get("args", ""),
                component=(program.package, program.name) if program.kind == "component" else None,
                bounds=_bounds(limits),
            ),
        )


def _bounds(limits: Dict[str, Any]) -> Bounds:
    """What one node may take: of what the container has, so that another one has its share."""
    known = Bounds()
    return Bounds(int(limits.get("memory", known.memory)), int(limits.get("disk", known.disk)), int(limits.get("processes", known.count)))


def _twice(plan: Plan, installation: Installation) -> Record:
    """Run a node; without a name where it refuses that; then once more, to see which of its names are made up on the spot.

    The second run is in a hurry and ends as soon as all names have come again. Where they do not, a third one is made like the first.
    """
    opposite = installation.opposite
    first = session.run(plan, opposite)
    record = first.record
    if record["status"] == "failed" and _refuses_name(record):
        plan.with_name = False
        again = session.run(plan, opposite)
        if again.record["status"] != "failed" or _quotes_name(record):
            first, record = again, again.record
        else:
            plan.with_name = True
    if record["status"] != "ok":
        return record
    problems = list(record["problems"])
    second = session.run(installation.second(plan), opposite, first.every)
    others = [second.record]
    final = installation.final(plan, second)
    if final is not None:
        other = session.run(final, opposite)
        others.append(other.record)
        if other.record["status"] == "ok":
            record = dict(other.record)
            problems = list(record["problems"])
    elif not second.reached:
        other = session.run(plan, opposite)
        others.append(other.record)
        if other.record["status"] != "ok":
            problems.append({"code": "unsteady", "detail": "it ran once and not a second time"})
        else:
            record["interface"], left_out = changing.common(record["interface"], other.record["interface"])
            if left_out:
                detail = "a second run had other names: {}".format(", ".join(left_out[:5]))
                problems.append({"code": "unsteady", "detail": detail[:300]})
    runs = [first.record] + others
    return dict(
        installation.joined(record, second.record),
        interface=changing.today(record["interface"]),
        problems=problems,
        left=[process for run in runs for process in run["left"]],
        seconds=round(sum(run["seconds"] for run in runs), 3),
    )


def _refuses_name(record: Record) -> bool:
    """Whether a node may have ended because of the arguments that roslaunch gives to every node."""
    return _quotes_name(record) or any(problem["code"] == "arguments-required" for problem in record["problems"])


def _quotes_name(record: Record) -> bool:
    texts = " ".join(problem["detail"] for problem in record["problems"])
    return any(word in texts for word in ("__name", "__log", "--ros-args", "__node"))


def _launched(plan: Plan, installation: Installation) -> Record:
    return session.run(plan, installation.opposite).record


def _launch_tasks(job: Job, installation: Installation) -> Iterator[Task]:
    """The launch files, each a run of roslaunch."""
    shares = installation.packages.shares
    limits = job.get("limits", {})
    for entry in job.get("launch", []):
        package, _, file = entry["file"].partition("/")
        label = entry["file"]
        if not is_mine(label, job.get("shard")):
            continue
        path = next((path for path in (os.path.join(each, file) for each in shares.get(package, [])) if os.path.isfile(path)), "")
        words = ["{}:={}".format(name, value) for name, value in sorted(entry.get("args", {}).items())]
        program = discover.Found(package, label, "launch", ["roslaunch", path] + words, path)
        frame = {
            "kind": "launch",
            "label": label,
            "package": package,
            "file": file,
            "args": entry.get("args", {}),
            "hash": discover.fingerprint(program, [_times(job), job.get("image")]),
        }
        plan = Plan(label, program.command, quiet=limits.get("quiet", 1.0), limit=2 * limits.get("limit", 15.0), with_name=False, many=True)
        if path and not installation.runs_launch_files:
            why = "launch files of ROS 2 are not run"
            yield Task(frame, partial(_not_run, "failed", {"code": "launch-not-run", "detail": why}))
        elif path:
            yield Task(frame, partial(_launched, plan, installation))
        else:
            why = "there is no such file in the package" if package in shares else "there is no such package"
            yield Task(frame, partial(_not_run, "failed", {"code": "launch-missing", "detail": why}))


def _not_run(status: str, *problems: Dict[str, str]) -> Record:
    """The record of what need not be started."""
    return {"status": status, "interface": {}, "problems": list(problems), "seconds": 0.0, "left": []}


def _report(path: str) -> None:
    """Pass on what was found when the image was built."""
    try:
        with open(path, encoding="utf-8") as file:
            for record in json.load(file):
                say(record)
    except (OSError, ValueError):
        return


def environment() -> Record:
    """What this machine or container is."""
    return {"kind": "environment", "base": _os_name(), **about()}


def _os_name() -> str:
    try:
        with open("/etc/os-release", encoding="utf-8") as file:
            for line in file:
                if line.startswith("PRETTY_NAME="):
                    return line.partition("=")[2].strip().strip('"')
    except OSError:
        pass
    return ""
