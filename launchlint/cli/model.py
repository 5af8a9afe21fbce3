"""``launchlint model``."""

from __future__ import annotations

import sys

import click

from launchlint.cli.entries import tell
from launchlint.cli.options import entry_options
from launchlint.project.asked import EntryOptions, leave_others_out


@click.command("model")
@entry_options
@click.option(
    "--format", "format_", type=click.Choice(["text", "json", "jsonl"]), default="text", show_default=True, help="How to print it."
)
def command(entry: EntryOptions, format_: str) -> int:
    """Print what its launcher would start for FILE: nodes with their remaps and parameters, under their resolved names.

    Nothing is started and no command= is run. The exit status is 1 where it would refuse a file, be it for
    want of something that this machine has not.
    """
    import json

    from launchlint.check.entry import EntryChecker
    from launchlint.report.escape import visible
    from launchlint.report.formats import emit
    from launchlint.report.model import as_object, table

    requests, overlay = entry.requests()
    checker = EntryChecker(entry.options(everything=True), overlay)
    requests, notices = leave_others_out(entry, requests, checker.session)
    for notice in notices:
        tell(notice)
    refused = False
    collected: list[object] = []
    for request in requests:
        evaluations = list(checker.evaluations(request))
        evaluation, verdict = evaluations[0], checker.verdict(request, evaluations)
        error = checker.refusal(request, evaluation)
        refused |= error is not None
        if format_ == "text":
            title = f"{visible(evaluation.launch.entry.path)}:\n" if len(requests) > 1 else ""
            emit(title + table(evaluation.launch, verdict), sys.stdout)
            continue
        item = as_object(evaluation.launch, request.file, error, verdict)
        if format_ == "jsonl":
            emit(json.dumps(item, ensure_ascii=True, default=str) + "\n", sys.stdout)
        else:
            collected.append(item)
    if format_ == "json":
        emit(json.dumps(collected[0] if len(collected) == 1 else collected, indent=2, ensure_ascii=True, default=str) + "\n", sys.stdout)
    return int(refused)
