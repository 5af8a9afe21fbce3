"""A probe from its configuration to its library: prepare, run, collect, go on where a container was lost."""

from __future__ import annotations

import hashlib
import json
import os
import tempfile
import time
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import AbstractContextManager
from typing import Protocol

from launchlint.errors import UsageError
from launchlint.named_tuple import NamedTuple
from launchlint.probe.configuration import Limits, ProbeConfiguration
from launchlint.probe.journal import Done, Journal
from launchlint.probe.record import LaunchRecord, NodeRecord, Note, parse
from launchlint.probe.sources import Tree, fetch, local
from launchlint.probe.stream import Stream, TooMuch

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

MOST_LOSSES = 200
"""Containers that may be lost before the whole is given up."""


class Running(Protocol):
    """The program beside the nodes, in a container or on this machine."""

    timed_out: bool

    def output(self, seconds: float) -> Iterator[bytes]:
        """Start it; what it prints, until it ends or ``seconds`` are over."""

    def kill(self) -> None:
        """End it."""

    def died_of_memory(self) -> bool:
        """Whether it wanted more memory than it may have."""

    def last_words(self) -> str:
        """What it complained of last."""


class Watcher(Protocol):
    """Whoever follows a probe."""

    def says(self, line: str) -> None:
        """A line of progress: of git, of the build."""

    def moves(self, done: int, total: int, label: str) -> None:
        """``done`` of ``total`` runs are done; ``label`` was the last."""


class Shard(NamedTuple):
    """Which part of all programs: number ``number``, from 1, of ``parts``."""

    number: int
    parts: int


class Outcome(NamedTuple):
    """What a probe has found.

    Args:
        records: of all runs.
        notes: what else was said, once each.
        trees: the sources.
        origins: package → name of its tree.
        left: processes that could not be ended.
        refused: lines of output that were no records, and what was wrong with the first.
        lost: why runs are missing; empty where none is.
    """

    records: Sequence[Done]
    notes: Sequence[Note]
    trees: Sequence[Tree]
    origins: Mapping[str, str]
    left: int
    refused: tuple[int, str]
    lost: str


def probe_local(configuration: ProbeConfiguration, journal: Journal, shard: Shard | None, watcher: Watcher) -> Outcome:
    """Probe the ROS of this machine; local checkouts are looked through for scripts, nothing is fetched, installed or built.

    Raises:
        UsageError: this machine has no ROS.
    """
    from launchlint.probe.local import has_ros, program

    if not has_ros():
        raise UsageError(
            "this machine has no ROS that could be probed: source its setup.bash first, or leave --local out to probe in a container"
        )
    job = job_of(configuration, shard, sources=list(configuration.paths))
    return _Collector(program, job, configuration, journal, watcher).run((), {})


def probe_in_container(configuration: ProbeConfiguration, journal: Journal, shard: Shard | None, watcher: Watcher, cache: str) -> Outcome:
    """Probe in a container of the Docker engine.

    Raises:
        UsageError: there is no engine, or a source cannot be fetched.
        BuildError: the image cannot be built.
    """
    from launchlint.probe.context import write_context
    from launchlint.probe.engine import connect

    engine = connect(_run_id())
    try:
        trees: list[Tree] = []
        for repository in configuration.repositories:
            watcher.says(f"fetching {repository.url} at {repository.ref}")
            trees.append(fetch(repository, cache))
        for path in configuration.paths:
            trees.append(local(path, [tree.name for tree in trees]))
        with tempfile.TemporaryFile() as context:
            origins = write_context(context, configuration, trees)
            tag = _digest(context, configuration.base)
            image = engine.build(context, tag, configuration.base, configuration.network, configuration.limits, watcher.says)
        job = job_of(configuration, shard, sources=["/workspace/src"] if trees else [], reports="/workspace", image=image.id)

        def start(data: bytes) -> AbstractContextManager[Running]:
            return engine.container(image, data, configuration.limits)

        return _Collector(start, job, configuration, journal, watcher).run(trees, origins)
    finally:
        engine.close()


def _run_id() -> str:
    return hashlib.sha256(os.urandom(16)).hexdigest()[:16]


def _digest(file: Any, base: str) -> str:
    file.seek(0)
    digest = hashlib.sha256(base.encode())
    while block := file.read(1 << 20):
        digest.update(block)
    return digest.hexdigest()[:16]


def job_of(configuration: ProbeConfiguration, shard: Shard | None, **more: Any) -> dict[str, Any]:
    """What the program beside the nodes is told; see ``run_all`` in ``probe/launchlint_probe/work.py``."""
    limits = configuration.limits
    nodes = {label: _plain(settings) for label, settings in configuration.nodes.items()}
    return {
        "packages": list(configuration.packages),
        "everything": configuration.everything,
        "programs": list(configuration.programs),
        "skip": list(configuration.skip),
        "nodes": nodes,
        "launch": [{"file": each.file, "args": dict(each.args)} for each in configuration.launch],
        "limits": {"quiet": limits.quiet, "limit": limits.limit, "jobs": limits.jobs, "total": limits.total, **share(limits)},
        **({"shard": list(shard)} if shard else {}),
        **more,
    }


def share(limits: Limits) -> dict[str, int]:
    """What one node may take, in bytes: three quarters of the container's memory, and an eighth of it for files, among those that run at
    once. Files in a container take memory, too.
    """
    memory = limits.bytes
    return {
        "memory": memory * 3 // (4 * limits.jobs),
        "disk": memory // (8 * limits.jobs),
        "processes": max(8, limits.pids // (2 * limits.jobs)),
    }


def _plain(settings: Mapping[str, Any]) -> dict[str, Any]:
    """Settings of a node without ``match``, which is the library's business."""
    return {
        key: {name: {inner: each for inner, each in variant.items() if inner != "match"} for name, variant in value.items()}
        if key == "variants"
        else value
        for key, value in settings.items()
    }


class _Collector:
    """Runs the program until every node has a record, or time is up."""

    def __init__(
        self,
        start: Callable[[bytes], AbstractContextManager[Running]],
        job: dict[str, Any],
        configuration: ProbeConfiguration,
        journal: Journal,
        watcher: Watcher,
    ) -> None:
        self._start = start
        self._job = job
        self._journal = journal
        self._watcher = watcher
        self._seconds = configuration.limits.total
        self._began = time.monotonic()
        self._notes: dict[str, Note] = {}
        self._begun: dict[str, Note] = {}
        self._total = 0
        self._left = 0
        self._refused = (0, "")

    def run(self, trees: Sequence[Tree], origins: Mapping[str, str]) -> Outcome:
        lost = ""
        losses = 0
        while True:
            why = self._once({})
            if why is None:
                break
            suspects = list(self._begun.values())
            losses += 1
            if not suspects or self._is_late() or losses > MOST_LOSSES:
                lost = why
                break
            for suspect in suspects:  # one of those that were running is to blame: each alone, to see which
                if self._is_late():
                    lost = why
                    break
                self._begun.clear()
                alone = self._once({"only": [suspect.facts["hash"]]})
                if alone is not None and suspect.facts["hash"] not in self._journal.done:
                    self._blame(suspect, alone)
            self._begun.clear()
        return Outcome(self._journal.records, list(self._notes.values()), trees, origins, self._left, self._refused, lost)

    def _is_late(self) -> bool:
        return time.monotonic() - self._began >= self._seconds

    def _once(self, more: Mapping[str, Any]) -> str | None:
        """Start the program once. Returns why it ended early; None where it did all there was to do."""
        job = json.dumps({**self._job, **more, "done": self._journal.done}).encode()
        stream = Stream()
        ended = False
        why = ""
        with self._start(job) as running:
            try:
                for record in stream.records(running.output(max(1.0, self._seconds - (time.monotonic() - self._began)))):
                    ended = self._take(record) or ended
            except TooMuch as reason:
                why = str(reason)
                running.kill()
            if not ended and not why:
                why = self._why(running)
        if stream.refused:
            self._refused = (self._refused[0] + stream.refused, self._refused[1] or stream.first)
        return None if ended and not why else why

    def _why(self, running: Running) -> str:
        if running.timed_out:
            return f"time was up after {self._seconds:g} seconds (`total` in `limits`)"
        if running.died_of_memory():
            return "it wanted more memory than it may have (`memory` in `limits`)"
        return "the program that runs the nodes was ended" + (f": {words}" if (words := running.last_words()) else "")

    def _take(self, record: NodeRecord | LaunchRecord | Note) -> bool:
        """Keep a record; whether it is the last one."""
        if isinstance(record, Note):
            if record.kind == "start":
                self._begun[record.facts["hash"]] = record
            elif record.kind == "plan":
                self._total = max(self._total, record.facts["all"])
            elif record.kind == "end":
                self._left += record.facts["left"]
                return True
            else:
                self._notes.setdefault(json.dumps([record.kind, record.facts], sort_keys=True), record)
            return False
        self._begun.pop(record.hash, None)
        self._journal.add(record)
        self._watcher.moves(len(self._journal.done), max(self._total, len(self._journal.done)), record.label)
        return False

    def _blame(self, suspect: Note, why: str) -> None:
        """A record for a node that took the whole container down with it."""
        facts = suspect.facts
        data = {
            **facts["frame"],
            "status": "failed",
            "interface": {},
            "problems": [{"code": "broke-the-container", "detail": why}],
            "seconds": 0.0,
            "left": [],
        }
        record = parse(json.dumps(data))
        if isinstance(record, (NodeRecord, LaunchRecord)):
            self._journal.add(record)
