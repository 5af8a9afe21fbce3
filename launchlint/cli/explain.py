"""``launchlint explain``."""

from __future__ import annotations

import sys

import click

from launchlint.errors import UsageError


@click.command("explain")
@click.argument("rule", metavar="RULE")
def command(rule: str) -> int:
    """Explain RULE, given by ID (LL301) or name (duplicate-node-name): what it finds, why it matters, an example, what to do."""
    from launchlint.report.formats import emit
    from launchlint.rules.page import page
    from launchlint.rules.registry import RULES, find
    from launchlint.spelling import did_you_mean

    entry = find(rule)
    if entry is None:
        hint = did_you_mean(rule.lower(), [known.name for known in RULES]) or did_you_mean(rule.upper(), [known.id for known in RULES])
        raise UsageError(f"there is no rule {rule}: {hint or 'launchlint rules lists them all'}")
    emit(page(entry).text, sys.stdout)
    return 0
