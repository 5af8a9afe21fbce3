"""What the steps of ``action.yml`` do: ``python -I -m launchlint.action``, with the action's inputs in the environment.

Inputs never reach a shell. They become words of launchlint's own command line, behind ``--`` where they are paths; what GitHub reads of the
output (annotations, outputs, the summary) is written by launchlint's own reports, which make every name harmless.
"""

from __future__ import annotations

import json
import os
import secrets
import subprocess
import sys
from collections.abc import Iterator, Mapping, Sequence

from launchlint.errors import UsageError
from launchlint.named_tuple import NamedTuple
from launchlint.report.escape import github_message

LONGEST_SUMMARY = 1_000_000
"""Bytes; GitHub refuses a summary of more than a mebibyte."""
PICTURE_LIMIT = 50_000
"""Characters of a Mermaid picture that GitHub draws."""
TRUE, FALSE = ("true", "yes", "on", "1"), ("false", "no", "off", "0", "")


class Inputs(NamedTuple):
    """The inputs of the action. Files and ``paths`` are relative to ``root``, the directory that findings are relative to."""

    root: str
    paths: tuple[str, ...]
    options: tuple[str, ...]
    fail_on: str
    annotations: bool
    summary: bool
    sarif: str
    report: str
    picture: str
    base: str


def main() -> int:
    """Check, and tell GitHub; the exit status of the check becomes an output, and the step itself fails only where nothing was checked."""
    try:
        inputs = read_inputs(os.environ)
    except UsageError as error:
        _tell(str(error))
        _write_outputs({"exit-code": "2"})
        return 0
    status = _check(inputs)
    pictured = inputs.picture and status != 2 and _changes(inputs)
    if (inputs.report or pictured) and status != 2:
        status = max(status, _report(inputs, inputs.picture if pictured else ""))
    written = {"sarif-file": inputs.sarif, "report": inputs.report, "picture": inputs.picture if pictured else ""}
    outputs = {name: file if file and os.path.isfile(file) else "" for name, file in written.items()}
    _write_outputs({**outputs, "findings": str(_count(inputs.sarif)), "exit-code": str(status), "root": inputs.root})
    return 0


def read_inputs(variables: Mapping[str, str]) -> Inputs:
    """The inputs as ``action.yml`` hands them over (``LAUNCHLINT_PATHS`` and so on). Raises UsageError, naming the input."""
    workspace = os.path.realpath(variables.get("GITHUB_WORKSPACE") or os.curdir)
    directory = os.path.realpath(os.path.join(workspace, _line(variables, "working-directory")))
    if not os.path.isdir(directory) or not (directory + os.sep).startswith(workspace.rstrip(os.sep) + os.sep):
        raise UsageError(f"working-directory: {_line(variables, 'working-directory')} is no directory of this job's workspace")
    root = _repository(directory, workspace)

    def relative(path: str) -> str:
        return os.path.relpath(os.path.join(directory, path), root)

    options: list[str] = []
    for name in _lines(variables, "args"):
        options += ["--arg", name]
    if _line(variables, "config"):
        options += ["--config", relative(_line(variables, "config"))]
    for file in _lines(variables, "library"):
        options += ["--library", relative(file)]
    if not _flag(variables, "extract"):
        options.append("--no-extract")
    sarif = _line(variables, "sarif-file")
    temporary = variables.get("RUNNER_TEMP") or directory
    report, picture, base = _line(variables, "report"), _line(variables, "picture"), _base(variables, root)
    if picture not in ("", "none") and not picture.endswith((".svg", ".png")):
        raise UsageError(f"picture: {picture} is neither an .svg nor a .png file, nor none")
    pictured = os.path.join(directory, picture) if picture else os.path.join(temporary, "launchlint-topology.svg")
    return Inputs(
        root=root,
        paths=tuple(relative(path) for path in _lines(variables, "paths") or ["."]),
        options=tuple(options),
        fail_on=_line(variables, "fail-on") or "error",
        annotations=_flag(variables, "annotations"),
        summary=_flag(variables, "summary"),
        sarif=os.path.join(directory, sarif) if sarif else os.path.join(temporary, "launchlint.sarif"),
        report=os.path.join(directory, report) if report else "",
        picture=pictured if base and picture != "none" else "",
        base=base,
    )


def _value(variables: Mapping[str, str], name: str) -> str:
    return variables.get("LAUNCHLINT_" + name.upper().replace("-", "_"), "")


def _line(variables: Mapping[str, str], name: str) -> str:
    text = _value(variables, name).strip()
    if "\n" in text or "\r" in text or "\0" in text:
        raise UsageError(f"{name}: this is one value, on one line")
    return text


def _lines(variables: Mapping[str, str], name: str) -> list[str]:
    return [line.strip() for line in _value(variables, name).splitlines() if line.strip()]


def _flag(variables: Mapping[str, str], name: str) -> bool:
    word = _line(variables, name).lower()
    if word not in (*TRUE, *FALSE):
        raise UsageError(f"{name}: it is true or false, not {word}")
    return word in TRUE


def _repository(directory: str, workspace: str) -> str:
    """The top of the repository around ``directory``, not above ``workspace``: what GitHub takes the paths of findings to start from."""
    at = directory
    while True:
        if os.path.exists(os.path.join(at, ".git")):
            return at
        if at == workspace:
            return directory
        at = os.path.dirname(at)


def _base(variables: Mapping[str, str], root: str) -> str:
    """The revision to compare with: the one that is given, else the base of the pull request where the clone has it."""
    given = _line(variables, "base")
    if given:
        return "" if given == "none" else given
    try:
        with open(variables.get("GITHUB_EVENT_PATH", ""), encoding="utf-8") as file:
            event = json.load(file)
        commit = event["pull_request"]["base"]["sha"]
    except (OSError, ValueError, LookupError, TypeError):
        return ""
    from launchlint.workspace.revision import is_revision

    if isinstance(commit, str) and commit.isalnum() and is_revision(root, commit):
        return commit
    print(
        "::notice title=launchlint::what this pull request changes in the topology is not told: its base is not in this clone;"
        " give actions/checkout fetch-depth: 0"
    )
    return ""


def _check(inputs: Inputs) -> int:
    """Run the check; annotations and the summary come after the SARIF file. Returns its exit status."""
    words = ["check", *inputs.options, "--color", "always", "--format", f"sarif:{inputs.sarif}", "--format", "text"]
    if inputs.annotations:
        words += ["--format", "github"]
    told = f"{inputs.sarif}.md"
    if inputs.summary:
        words += ["--format", f"markdown:{told}"]
    if inputs.base:
        words += ["--base", inputs.base]
    words += ["--exit-zero"] if inputs.fail_on == "never" else ["--fail-on", inputs.fail_on]
    status, _ = _run(inputs.root, [*words, "--", *inputs.paths], told=True)
    if inputs.summary:
        _write_summary(inputs, told)
    return status


def _report(inputs: Inputs, picture: str) -> int:
    """Write the HTML report and the picture, also into directories that are not there yet. Returns the exit status."""
    try:
        for file in filter(None, (inputs.report, picture)):
            os.makedirs(os.path.dirname(file), exist_ok=True)
    except OSError as error:
        _tell(f"report: the directory of {error.filename} cannot be made: {error.strerror}")
        return 2
    base = ["--base", inputs.base] if inputs.base else []
    drawn = ["--picture", picture] if picture else []
    page = inputs.report or os.devnull
    return _run(inputs.root, ["report", *inputs.options, *base, *drawn, "-o", page, "--", *inputs.paths], told=True)[0]


def _changes(inputs: Inputs) -> bool:
    """Whether the topology is another one than at the base."""
    return bool(inputs.base) and _difference(inputs)[0] == 1


def _difference(inputs: Inputs) -> tuple[int, str]:
    """The exit status (1: something changed) and the Mermaid picture of ``graph diff``."""
    paths = [os.path.join(os.curdir, path) for path in inputs.paths]  # so that none of them can be a revision
    return _run(inputs.root, ["graph", "diff", *inputs.options, "--exit-code", "--format", "mermaid", "--", inputs.base, *paths])


def _write_summary(inputs: Inputs, told: str) -> None:
    parts: list[str] = []
    try:
        with open(told, encoding="utf-8") as file:
            parts.append(file.read())
        os.unlink(told)
    except OSError:
        return
    if inputs.base:
        status, picture = _difference(inputs)
        if status == 0:
            parts.append("\nNo connection changes.\n")
        elif status == 1 and len(picture) <= PICTURE_LIMIT:
            parts.append(f"\n#### What changes in the topology\n\n```mermaid\n{picture}```\n")
    summary = os.environ.get("GITHUB_STEP_SUMMARY")
    text = "".join(parts)
    if summary and len(text.encode()) <= LONGEST_SUMMARY:
        with open(summary, "a", encoding="utf-8") as file:
            file.write(text)


def _run(root: str, words: Sequence[str], *, told: bool = False) -> tuple[int, str]:
    """Run launchlint in ``root``: exit status and, where it is not ``told``, what it prints. What it cannot do becomes an annotation."""
    sys.stdout.flush()
    done = subprocess.run(
        [sys.executable, "-I", "-m", "launchlint", *words],
        cwd=root,
        stdin=subprocess.DEVNULL,
        stdout=None if told else subprocess.PIPE,
        stderr=subprocess.PIPE,
        check=False,
    )
    errors = done.stderr.decode("utf-8", "replace").strip()
    if done.returncode not in (0, 1):
        _tell(errors.removeprefix("launchlint: ") or f"launchlint ended with {done.returncode}")
    elif errors:
        print("\n".join(_harmless(errors)))
    output = "" if told else done.stdout.decode("utf-8", "replace")
    return done.returncode if done.returncode in (0, 1) else 2, output


def _harmless(text: str) -> Iterator[str]:
    for line in text.splitlines():
        yield f"launchlint: {line.removeprefix('launchlint: ')}"


def _tell(message: str) -> None:
    print(f"::error title=launchlint::{github_message(message)}")


def _count(sarif: str) -> int:
    try:
        with open(sarif, encoding="utf-8") as file:
            return len(json.load(file)["runs"][0]["results"])
    except (OSError, ValueError, LookupError):
        return 0


def _write_outputs(outputs: dict[str, str]) -> None:
    file = os.environ.get("GITHUB_OUTPUT")
    if file:
        with open(file, "a", encoding="utf-8") as stream:
            for name, value in outputs.items():
                end = f"end-{secrets.token_hex(16)}"
                stream.write(f"{name}<<{end}\n{value}\n{end}\n")


if __name__ == "__main__":
    sys.exit(main())
