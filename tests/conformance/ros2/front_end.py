"""The real front ends of ROS 2 launch, asked what they make of files; and their answers held against launchlint's.

``LAUNCHLINT_ORACLE`` names the directory with the program that asks them (``ros2/oracle_ros2.py``) and the one that compares
(``ros2/agree_ros2.py``), ``LAUNCHLINT_ROS2_SOURCES`` the directory with their checkouts: ``DISTRO/launch``, ``DISTRO/launch_ros`` and
``DISTRO/rclpy``, and ``venv/bin/python`` with the packages that they import, where the Python that runs this has not got them.
"""

from __future__ import annotations

import importlib.util
import json
import os
import subprocess
import sys
import tempfile
from collections.abc import Mapping, Sequence
from functools import cached_property
from pathlib import Path
from types import ModuleType
from typing import Any, NamedTuple

Answer = dict[str, Any]
WHY_NOT = "LAUNCHLINT_ORACLE and LAUNCHLINT_ROS2_SOURCES do not name the program that asks ROS 2 launch and checkouts of it"


class Question(NamedTuple):
    """A launch file, relative to the corpus, and its arguments."""

    file: str
    arguments: Mapping[str, str] = {}


class FrontEnd:
    """The real front ends of one distribution."""

    def __init__(self, oracle: Path, sources: Path, distro: str, seconds: int = 20) -> None:
        self.oracle = oracle
        self.sources = sources
        self.distro = distro
        self.seconds = seconds

    def answers(self, corpus: Path, questions: Sequence[Question], *, guess: bool = False) -> list[Answer]:
        """What they make of each file below ``corpus``, in order. ``guess``: required args get a value, named in the answer."""
        own = self.sources / "venv/bin/python"
        command = [str(own) if own.is_file() else sys.executable, str(self.oracle / "oracle_ros2.py"), "--src", str(self.sources)]
        command += ["--distro", self.distro, "--corpus", str(corpus), "--timeout", str(self.seconds), *(["--guess"] if guess else [])]
        with tempfile.TemporaryDirectory() as directory:
            files = Path(directory, "files")
            pairs = (" ".join(f"{name}:={value}" for name, value in each.arguments.items()) for each in questions)
            lines = (f"{question.file}\t{given}" for question, given in zip(questions, pairs, strict=True))
            files.write_text("".join(f"{line}\n" for line in lines), encoding="utf-8")
            # What lies in the directory for temporary files counts as written by launch: the corpus must not lie there.
            environment = {**os.environ, "TMPDIR": directory}
            run = subprocess.run([*command, "--files-from", str(files)], capture_output=True, text=True, check=True, env=environment)
        return [json.loads(line) for line in run.stdout.splitlines()]

    @cached_property
    def comparison(self) -> ModuleType:
        """The module that compares."""
        spec = importlib.util.spec_from_file_location("agree_ros2", self.oracle / "agree_ros2.py")
        assert spec is not None
        assert spec.loader is not None
        module = importlib.util.module_from_spec(spec)
        spec.loader.exec_module(module)
        return module

    def environment(self) -> dict[str, str]:
        """The variables that they see."""
        return {**self.comparison.ENV, "ROS_DISTRO": self.distro}

    def difference(self, corpus: Path, real: Answer, own: Answer) -> str:
        """The first thing in which two answers differ, in words; empty where they are equal. Why a file is refused does not count.

        Where something deferred fails, launch ends: what is deferred is not compared then, nor what is declared in it.
        """
        if real["verdict"] != own["verdict"] or real["verdict"] != "ok":
            told = [(each.get("error") or {}).get("message", "") for each in (real, own)]
            return (
                "" if real["verdict"] == own["verdict"] else f"launch: {real['verdict']} {told[0]}; launchlint: {own['verdict']} {told[1]}"
            )
        compared, root = self.comparison, str(corpus)
        late = [side.get("deferred_errors") or [] for side in (real, own)]
        if len(late[0]) != len(late[1]):
            return f"deferred errors: launch {late[0]}, launchlint {late[1]}"
        parts = {"nodes": sum(compared.GROUPS.values(), ()), **compared.LISTS}
        if late[0]:
            del parts["args"]
        for part, keys in parts.items():
            items = ([each for each in side.get(part) or [] if not (late[0] and each.get("deferred"))] for side in (real, own))
            sides = [[compared.item(_judged(each), keys, root, self.distro) for each in listed] for listed in items]
            if compared.compare(*sides) != "equal":
                return str(compared.first_difference(*sides, part))
        declared = [None if late[0] else compared.canonical(side.get("declared"), root, self.distro) for side in (real, own)]
        return "" if compared.compare(*declared) == "equal" else str(compared.first_difference(*declared, "declared"))


def _judged(item: Answer) -> Answer:
    """``item`` without what only rcl itself can tell: what parameters a process ends up with. A component's are launch's own."""
    return item if item.get("kind", "composable") == "composable" else {**item, "parameters": None, "rcl_error": None}


def front_end(distro: str = "jazzy") -> FrontEnd | None:
    """The front end that the environment names, if it does."""
    oracle = Path(os.environ.get("LAUNCHLINT_ORACLE", ""), "ros2")
    sources = Path(os.environ.get("LAUNCHLINT_ROS2_SOURCES", ""))
    there = (oracle / "oracle_ros2.py").is_file() and (sources / distro / "launch").is_dir()
    return FrontEnd(oracle, sources, distro) if there else None
