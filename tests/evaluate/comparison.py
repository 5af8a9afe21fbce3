"""Hold the evaluator against the real roslaunch on launch files that a test writes down."""

from __future__ import annotations

import contextlib
import json
import os
import re
import subprocess
from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path
from typing import Any, NamedTuple

from launchlint.evaluate.ros1.launch import evaluate
from launchlint.evaluate.session import Session
from launchlint.model import Launch
from launchlint.report.model import as_object
from launchlint.workspace.packages import Packages

PEER = Path(__file__).with_name("roslaunch_peer.py")
ENVIRONMENT = {"HOME": "/home/user", "LANG": "C.UTF-8", "PATH": "/usr/bin:/bin", "ROS_DISTRO": "noetic", "ROS_HOSTNAME": "localhost"}
PARTS = ("verdict", "nodes", "tests", "params", "clear_params", "machines", "executables", "files", "includes")
MAIN = "main.launch"

_NODE = re.compile(r"\[\[((?:\$\([^)]*\)|[^\s\]|$])*)(?: ((?:(?!\]\]| ?\| ).)*))?(?: ?\| (.*?))?\]\]", re.DOTALL)


class Case(NamedTuple):
    """Launch files, how the first one is launched, and the kinds of the problems for which roslaunch refuses it (none: it loads).

    ``files`` maps names to content. In text, ``[[a x="1" | children]]`` stands for the node ``a`` with these attributes and children, and a
    ``.launch`` file without ``<launch`` in it is put between ``<launch>`` and ``</launch>``.
    """

    files: Mapping[str, str | bytes]
    refused: tuple[str, ...]
    arguments: Mapping[str, str]
    environment: Mapping[str, str]


def case(
    main: str | bytes,
    *refused: str,
    files: Mapping[str, str | bytes] | None = None,
    args: Mapping[str, str] | None = None,
    environment: Mapping[str, str] | None = None,
) -> Case:
    """A case whose entry file has the content ``main``."""
    return Case({MAIN: main, **(files or {})}, refused, args or {}, environment or {})


def _with_node(match: re.Match[str]) -> str:
    name, attributes, children = match[1], match[2] or "", match[3]
    start = f'<node pkg="p" type="t" name="{name}" {attributes}'.rstrip()
    return f"{start}/>" if children is None else f"{start}>{children}</node>"


def content(name: str, text: str | bytes) -> bytes:
    """The bytes of the file ``name`` that a case describes as ``text``."""
    if isinstance(text, bytes):
        return text
    if name.endswith(".launch"):
        text = _NODE.sub(_with_node, text)
        if "<launch" not in text:
            text = f"<launch>{text}</launch>"
    return text.encode("utf-8")


def write(case: Case, directory: Path) -> None:
    """Write the files of ``case`` into ``directory``."""
    for name, text in case.files.items():
        file = directory / name
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_bytes(content(name, text))


@contextlib.contextmanager
def inside(directory: Path) -> Iterator[None]:
    """Work in ``directory``: relative names of included files are looked for there."""
    before = os.getcwd()
    os.chdir(directory)
    try:
        yield
    finally:
        os.chdir(before)


def session_in(directory: Path, environment: Mapping[str, str] | None = None) -> Session:
    """A session that sees the packages in ``directory`` and nothing of this machine."""
    variables = {**ENVIRONMENT, **(environment or {})}
    return Session(Packages([str(directory)], variables, explicit=True), variables, str(directory))


def launch_of(case: Case, directory: Path) -> Launch:
    """What the evaluator makes of ``case``, whose files are in ``directory``."""
    with inside(directory):
        return evaluate(session_in(directory, case.environment), str(directory / MAIN), tuple(case.arguments.items())).launch


def ours(case: Case, directory: Path) -> dict[str, Any]:
    """The model of ``case`` as JSON holds it, the parts that are compared."""
    with inside(directory):
        evaluation = evaluate(session_in(directory, case.environment), str(directory / MAIN), tuple(case.arguments.items()))
    refused = evaluation.launch.refused
    model = as_object(evaluation.launch, MAIN, None if refused is None else (refused.kind, ""))
    for include in model["includes"]:
        del include["from"]
    if refused is not None:
        return {"verdict": "error", "reason": refused.kind}
    compared: dict[str, Any] = json.loads(json.dumps({part: model[part] for part in PARTS}))
    return compared


def theirs(ros_python: str, cases: Sequence[tuple[Case, Path]]) -> list[dict[str, Any]]:
    """What the real roslaunch makes of each case in its directory."""
    jobs = [
        {
            "file": str(directory / MAIN),
            "args": dict(case.arguments),
            "environment": {**ENVIRONMENT, **case.environment},
            "packages": str(directory),
            "directory": str(directory),
        }
        for case, directory in cases
    ]
    command = [ros_python, "-W", "ignore", str(PEER)]
    run = subprocess.run(command, input=json.dumps(jobs), capture_output=True, text=True, timeout=600, check=True)
    return [json.loads(line) for line in run.stdout.splitlines()]


def difference(real: Any, own: Any) -> str:
    """The first thing in which two answers differ, in words; empty where they are equal (the reason of a refusal is not compared)."""
    if real["verdict"] != "ok" or own["verdict"] != "ok":
        return "" if real["verdict"] == own["verdict"] else f"roslaunch: {told(real)}; launchlint: {told(own)}"
    return first_difference(real, own, ("roslaunch", "launchlint"))


def first_difference(one: Any, other: Any, sides: tuple[str, str], where: str = "") -> str:
    """The first thing in which two values differ, in words that call them as ``sides`` says; empty where they are equal."""
    if isinstance(one, dict) and isinstance(other, dict):
        for key in sorted({*one, *other}):
            if key not in one or key not in other:
                return f"{where}.{key}: only {sides[key not in one]} has it"
            found = first_difference(one[key], other[key], sides, f"{where}.{key}")
            if found:
                return found
        return ""
    if isinstance(one, list) and isinstance(other, list):
        for index, (left, right) in enumerate(zip(one, other, strict=False)):
            found = first_difference(left, right, sides, f"{where}[{index}]")
            if found:
                return found
        return "" if len(one) == len(other) else f"{where}: {len(one)} items for {sides[0]}, {len(other)} for {sides[1]}"
    return "" if one == other and type(one) is type(other) else f"{where}: {sides[0]} {one!r}, {sides[1]} {other!r}"


def told(answer: Mapping[str, Any]) -> str:
    """The verdict with its reason."""
    return answer["verdict"] + (f" ({answer['reason']})" if "reason" in answer else "")
