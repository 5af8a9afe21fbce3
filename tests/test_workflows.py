"""The workflows of this repository: valid, safe, and together they run every test once."""

from __future__ import annotations

import ast
import re
import subprocess
import sys
from collections.abc import Mapping
from itertools import product
from pathlib import Path

import pytest

from tests.conftest import NEEDS, PROGRAMS_FOR_OUTPUT, SLOW

ROOT = Path(__file__).resolve().parent.parent
WORKFLOWS = sorted(path.relative_to(ROOT).as_posix() for path in (ROOT / ".github/workflows").glob("*.yml"))


@pytest.mark.parametrize("workflow", WORKFLOWS)
@pytest.mark.parametrize(
    "command",
    [("check-jsonschema", "--builtin-schema", "vendor.github-workflows"), ("zizmor", "--offline", "--quiet")],
    ids=lambda command: command[0],
)
def test_workflow_is_valid_and_safe(workflow: str, command: tuple[str, ...]) -> None:
    tool = Path(sys.executable).parent / command[0]
    if not tool.is_file():
        pytest.skip(f"{tool.name} is not installed (it is part of the dev extra)")
    done = subprocess.run([tool, *command[1:], workflow], cwd=ROOT, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stdout + done.stderr


def holds(expression: ast.expr, marked: Mapping[str, bool]) -> bool:
    """Whether a marker expression of pytest chooses a test with these markers."""
    if isinstance(expression, ast.BoolOp):
        both = [holds(each, marked) for each in expression.values]
        return all(both) if isinstance(expression.op, ast.And) else any(both)
    if isinstance(expression, ast.UnaryOp):
        return not holds(expression.operand, marked)
    assert isinstance(expression, ast.Name)
    return marked[expression.id]


def test_the_lanes_run_every_test_once() -> None:
    text = (ROOT / ".github/workflows/test.yml").read_text(encoding="utf-8")
    lanes = re.findall(r"-m pytest .*?-m (?:\"([^\"]+)\"|(\w+))", text)
    expressions = [quoted or word for quoted, word in lanes]
    assert len(expressions) == 5
    for ros, docker, browser, slow in product((False, True), repeat=4):
        marked = {"ros": ros, "docker": docker, "browser": browser, "slow": slow, "fast": not (ros or docker or browser or slow)}
        running = [each for each in expressions if holds(ast.parse(each, mode="eval").body, marked)]
        assert len(running) == 1, (marked, running)


def test_what_is_fast_needs_nothing(pytestconfig: pytest.Config) -> None:
    told = {line.partition(":")[0] for line in pytestconfig.getini("markers")}
    assert {*NEEDS, "fast", "slow", "browser"} <= told
    assert set(PROGRAMS_FOR_OUTPUT) < set(NEEDS)
    assert [each for each in SLOW if not (ROOT / each).exists()] == []


@pytest.mark.parametrize("room", ["fix", "graph", "suppression"])
def test_what_mutants_are_made_of_exists(room: str) -> None:
    text = (ROOT / f"tests/mutants/{room}.toml").read_text(encoding="utf-8")
    named = re.findall(r"(?:launchlint|tests)/[\w/]+(?:\.py)?", text)
    assert len(named) >= 2
    assert [each for each in named if not (ROOT / each).exists()] == []
