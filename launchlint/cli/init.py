"""``launchlint init``."""

from __future__ import annotations

import os
import sys

import click

from launchlint.cli.entries import tell
from launchlint.errors import UsageError
from launchlint.plural import counted
from launchlint.project.asked import EntryOptions

TYPE_CHECKING = False
if TYPE_CHECKING:
    from launchlint.cli.starting import Found

HOOKS = ".pre-commit-config.yaml"
WORKFLOW = os.path.join(".github", "workflows", "launchlint.yml")


@click.command("init")
@click.argument("directory", required=False, default=os.curdir)
@click.option("--pre-commit", is_flag=True, help=f"Write {HOOKS}, too, with the hook.")
@click.option("--github", is_flag=True, help=f"Write {WORKFLOW}, too, which checks every pull request.")
@click.option("--force", is_flag=True, help="Replace files that are there already.")
def command(directory: str, pre_commit: bool, github: bool, force: bool) -> int:
    """Write a commented .launchlint.yaml for the repository at DIRECTORY, and show how to run launchlint in CI.

    Nothing that is there is changed without --force.
    """
    from launchlint.atomic import write_text
    from launchlint.cli import starting
    from launchlint.report.escape import visible
    from launchlint.report.formats import emit
    from launchlint.workspace.configuration import FILE_NAME

    if not os.path.isdir(directory):
        raise UsageError(f"{directory}: there is no such directory; give the one of a repository")
    found = look(directory)
    files = {FILE_NAME: starting.configuration(found)}
    if pre_commit:
        files[HOOKS] = starting.HOOK
    if github:
        files[WORKFLOW] = starting.WORKFLOW
    for name in files:
        if os.path.lexists(os.path.join(directory, name)) and not force:
            hint = "add the lines that `launchlint init` shows, or" if name == HOOKS else "look at it, or"
            raise UsageError(f"{os.path.join(directory, name)} is there already: {hint} replace it with --force; nothing was written")
    for name, text in files.items():
        path = os.path.join(directory, name)
        os.makedirs(os.path.dirname(path) or os.curdir, exist_ok=True)
        write_text(path, text, what=name)
        tell(f"wrote {visible(os.path.normpath(path))}")
    emit("\n".join(_told(found, pre_commit=pre_commit, github=github)) + "\n", sys.stdout)
    return 0


def look(directory: str) -> Found:
    """What is in the repository at ``directory``; a configuration that is there counts."""
    from launchlint.check.causes import told_once
    from launchlint.check.dialects import sort_out
    from launchlint.check.entry import EntryChecker
    from launchlint.check.merge import merge
    from launchlint.check.run import check_entries
    from launchlint.cli.starting import Found
    from launchlint.finding import Severity
    from launchlint.project.selection import per_file_ignores

    entry = EntryOptions((directory,))
    options = entry.options()
    requests, overlay = entry.requests()
    checker = EntryChecker(options, overlay)
    kept, _ = sort_out(requests, (), checker.session)
    results = check_entries(kept, checker)
    outcome = merge(results, options, checker.packages, per_file_ignores(entry.configuration, options.root), asked=entry.paths)
    findings = told_once(outcome.findings)
    included = {path for result in results for path in result.summary.included}
    packages = sorted({package.name for place in checker.packages.places[: len(options.workspaces)] for package in place.everything})
    here = {name: os.path.exists(os.path.join(directory, name)) for name in (".github", ".gitlab-ci.yml", HOOKS)}
    shown = [checker.session.shown(request.at) for request in kept]
    return Found(
        packages,
        shown,
        [os.path.relpath(path, directory) for path in dict.fromkeys(shown) if path not in included],
        sum(finding.severity is Severity.ERROR for finding in findings),
        sum(finding.severity is Severity.WARNING for finding in findings),
        here[".github"],
        here[".gitlab-ci.yml"],
        here[HOOKS],
    )


def _told(found: Found, *, pre_commit: bool, github: bool) -> list[str]:
    from launchlint.cli import starting

    lines = [f"{counted(len(found.packages), 'package')}, {counted(len(found.read), 'launch file')}."]
    if found.errors or found.warnings:
        lines += [
            f"A check finds {counted(found.errors, 'error')} and {counted(found.warnings, 'warning')}: `launchlint check` shows them.",
            "To hear of new ones only, run",
            "",
            "    launchlint check --write-baseline .launchlint-baseline.json",
            "",
            "and name the file under `baseline` in .launchlint.yaml.",
        ]
    else:
        lines.append("A check finds nothing wrong.")
    if not pre_commit:
        lines += ["", f"To check every commit, {'add this to' if found.hooks else 'write this to'} {HOOKS} (--pre-commit does):", ""]
        lines += _indented(starting.HOOK)
    if not github and (found.github or not found.gitlab):
        lines += ["", f"To check every pull request on GitHub, write this to {WORKFLOW} (--github does):", ""]
        lines += _indented(starting.WORKFLOW)
    if found.gitlab:
        lines += ["", "To check every merge request on GitLab, add this to .gitlab-ci.yml:", ""]
        lines += _indented(starting.GITLAB)
    return lines


def _indented(text: str) -> list[str]:
    return [f"    {line}".rstrip() for line in text.splitlines()]
