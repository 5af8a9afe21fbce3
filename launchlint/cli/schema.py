"""``launchlint schema``."""

from __future__ import annotations

import sys

import click


@click.command("schema")
@click.argument("dialect", type=click.Choice(["ros1"]))
def command(dialect: str) -> int:
    """Print the dialect as a RelaxNG schema, so that an XML editor can check and complete launch files."""
    from launchlint.report.formats import emit
    from launchlint.syntax.ros1.relaxng import relaxng

    emit(relaxng(), sys.stdout)
    return 0
