"""A small runner for composite actions: the steps of ``action.yml`` run in bash as GitHub's runner runs them."""

from __future__ import annotations

import os
import re
import subprocess
from collections.abc import Mapping
from pathlib import Path
from typing import Any, NamedTuple

import yaml

_EXPRESSION = re.compile(r"\$\{\{\s*(.*?)\s*\}\}")
_COMPARISON = re.compile(r"(\S+)\s*(==|!=)\s*'([^']*)'")


class Ran(NamedTuple):
    """How the action ended.

    ``log`` is what its steps printed, ``used`` the other actions it would have called, with their inputs.
    """

    status: int
    log: str
    outputs: Mapping[str, str]
    summary: str
    used: Mapping[str, Mapping[str, str]]


class Runner:
    """Runs the action at ``action`` (a directory) for a repository checked out at ``workspace``."""

    def __init__(self, action: Path, workspace: Path, temporary: Path, event: Path | None = None) -> None:
        self.definition: dict[str, Any] = yaml.safe_load((action / "action.yml").read_text(encoding="utf-8"))
        self.workspace = workspace
        self.temporary = temporary
        self.files = temporary / "github"
        self.files.mkdir(parents=True)
        kept = {
            name: value for name, value in os.environ.items() if not name.startswith(("GITHUB_", "LAUNCHLINT", "PYTHON", "ROS_", "XDG_"))
        }
        self.variables = {
            **kept,
            "GITHUB_ACTIONS": "true",
            "GITHUB_ACTION_PATH": str(action),
            "GITHUB_WORKSPACE": str(workspace),
            "RUNNER_TEMP": str(temporary),
            "XDG_CACHE_HOME": str(temporary / "cache"),
            "GITHUB_EVENT_PATH": str(event or self.files / "event.json"),
            "GITHUB_STEP_SUMMARY": str(self.files / "summary.md"),
        }
        if event is None:
            (self.files / "event.json").write_text("{}", encoding="utf-8")

    def run(self, **inputs: str) -> Ran:
        """Run all steps; ``inputs`` by name, with ``_`` for ``-``."""
        given = {name.replace("_", "-"): value for name, value in inputs.items()}
        assert given.keys() <= self.definition["inputs"].keys()
        context = {f"inputs.{name}": given.get(name, declared.get("default", "")) for name, declared in self.definition["inputs"].items()}
        log, status, used = "", 0, {}
        for number, step in enumerate(self.definition["runs"]["steps"]):
            if not self._is_wanted(step.get("if"), context):
                continue
            if "uses" in step:
                used[step["uses"]] = {name: self._filled(value, context) for name, value in step["with"].items()}
                continue
            output = self.files / f"output-{number}"
            output.touch()
            script = self.files / f"step-{number}.sh"
            assert "${{" not in step["run"]
            script.write_text(step["run"], encoding="utf-8")
            variables = {name: self._filled(value, context) for name, value in step.get("env", {}).items()}
            done = subprocess.run(
                ["bash", "--noprofile", "--norc", "-eo", "pipefail", str(script)],
                cwd=self.workspace,
                env={**self.variables, **variables, "GITHUB_OUTPUT": str(output)},
                stdin=subprocess.DEVNULL,
                stdout=subprocess.PIPE,
                stderr=subprocess.STDOUT,
                timeout=300,
                check=False,
            )
            log += done.stdout.decode("utf-8", "replace")
            if "id" in step:
                context.update({f"steps.{step['id']}.outputs.{name}": value for name, value in _outputs(output).items()})
            if done.returncode:
                status = done.returncode
                break
        summary = self.files / "summary.md"
        outputs = {name: self._filled(declared["value"], context) for name, declared in self.definition["outputs"].items()}
        return Ran(status, log, outputs, summary.read_text(encoding="utf-8") if summary.exists() else "", used)

    def _filled(self, text: str, context: Mapping[str, str]) -> str:
        return _EXPRESSION.sub(lambda match: context.get(match[1], ""), text)

    def _is_wanted(self, condition: str | None, context: Mapping[str, str]) -> bool:
        if condition is None:
            return True
        expression = _EXPRESSION.fullmatch(condition)
        assert expression
        parts = [_COMPARISON.fullmatch(part) for part in expression[1].split(" && ")]
        return all(part is not None and (context.get(part[1], "") == part[3]) == (part[2] == "==") for part in parts)


def _outputs(file: Path) -> dict[str, str]:
    """What a step wrote to GITHUB_OUTPUT, read as GitHub does: ``name=value`` or ``name<<END``, lines, ``END``."""
    found: dict[str, str] = {}
    lines = iter(file.read_text(encoding="utf-8").splitlines())
    for line in lines:
        name, separator, rest = line.partition("<<") if "<<" in line.split("=")[0] else line.partition("=")
        assert separator, line
        if separator == "=":
            found[name] = rest
            continue
        value = []
        for each in lines:
            if each == rest:
                break
            value.append(each)
        found[name] = "\n".join(value)
    return found
