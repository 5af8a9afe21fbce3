"""``launchlint rules``."""

from __future__ import annotations

import json
import sys

import click


@click.command("rules")
@click.option("--format", "format_", type=click.Choice(["text", "json"]), default="text", show_default=True, help="How to print it.")
def command(format_: str) -> int:
    """List all rules with their severity; `launchlint explain RULE` prints the page of one."""
    from launchlint.report.formats import emit
    from launchlint.rules.page import page
    from launchlint.rules.registry import RULES

    rows = [(rule.id, rule.name, rule.severity.word, rule.default, page(rule).summary) for rule in RULES]
    if format_ == "json":
        keys = ("id", "name", "severity", "default", "summary")
        emit(json.dumps([dict(zip(keys, row, strict=True)) for row in rows], indent=2) + "\n", sys.stdout)
        return 0
    width = max(len(row[1]) for row in rows)
    lines = [
        f"{identifier}  {name:{width}}  {severity:7}  {'   ' if default else 'off'}  {summary}\n"
        for identifier, name, severity, default, summary in rows
    ]
    emit("".join(lines), sys.stdout)
    return 0
