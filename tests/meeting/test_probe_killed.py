"""A probe that is killed at any moment: the library is as it was or as it was to become, and ``--resume`` leads to the same one."""

from __future__ import annotations

import json
import os
import signal
import subprocess
import time
from pathlib import Path

import pytest

from tests.cli.running import Ran
from tests.meeting.system_calls import moments, traced
from tests.probe.odd_nodes import PACKAGE, install, processes_with

pytestmark = [pytest.mark.strace, pytest.mark.slow]

NODES = ["own_name.py", "wants_args.py"]
LIBRARY = "library.json"
FORMER = "# a library that was there before\nformat: 2\n"
WORDS = ("probe", "probe.yaml", "--local", "-o", LIBRARY, "--jobs", "1")
MOST_MOMENTS = 8
"""Each costs two probes, of a second or so a node."""


@pytest.fixture
def place(tmp_path: Path) -> Path:
    """Where the install space with the nodes is."""
    install(tmp_path / "prefix", NODES)
    return tmp_path


def made(directory: Path) -> Path:
    """A directory with the configuration of a probe, and the library of an earlier one."""
    directory.mkdir(parents=True)
    (directory / "probe.yaml").write_text(f"packages: [{PACKAGE}]\nlimits: {{quiet: 0.2, limit: 4}}\n")
    (directory / LIBRARY).write_text(FORMER)
    return directory


def probe(place: Path, directory: Path, *words: str, killed: str = "") -> Ran:
    """Probe in ``directory``, up to the system call ``killed`` (as ``name:count``), where there is one."""
    name, _, count = killed.partition(":")
    inject = [f"{name}:signal=SIGKILL:when={count}"] if killed else []
    log = place / "calls.log"
    done = traced(directory, place / "cache", (*WORDS, *words), *inject, log=log, CMAKE_PREFIX_PATH=str(place / "prefix"), ROS_DISTRO="odd")
    ended(place)
    return done


def ended(place: Path) -> None:
    """Wait until nothing that was started from the install space is left; end it where it does not end by itself."""
    last = time.monotonic() + 20
    while processes_with(str(place / "prefix")):
        if time.monotonic() > last:
            subprocess.run(["pkill", "-KILL", "-f", str(place / "prefix")], check=False)
        time.sleep(0.05)


def test_nothing_is_lost_or_half_written(place: Path) -> None:
    undisturbed = made(place / "undisturbed")
    done = probe(place, undisturbed)
    assert done.status == 0, done
    whole = (undisturbed / LIBRARY).read_text()
    assert set(json.loads(whole)["packages"][PACKAGE]["executables"]) == set(NODES)
    where = list(moments(place / "calls.log"))
    assert any(name == "rename" for name, _ in where)
    every = max(1, len(where) // MOST_MOMENTS)
    for name, count in dict.fromkeys([*where[::every], *where[-4:]]):
        directory = made(place / f"{name}-{count}")
        killed = probe(place, directory, killed=f"{name}:{count}")
        if killed.status == 0:
            continue  # what the nodes say comes in other pieces each time: this run had fewer
        assert killed.status == -signal.SIGKILL, (name, count, killed)
        assert (directory / LIBRARY).read_text() in (FORMER, whole), (name, count)
        again = probe(place, directory, "--resume")
        assert again.status == 0, (name, count, again)
        assert (directory / LIBRARY).read_text() == whole, (name, count)
        left = [each for each in sorted(os.listdir(directory)) if not each.startswith(f".{LIBRARY}.")]  # what was being written
        assert left == [LIBRARY, "probe.yaml"], (name, count)
