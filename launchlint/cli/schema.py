"""``launchlint schema``."""

from __future__ import annotations

import sys

import click


@click.command("schema")
@click.argument("dialect", type=click.Choice(["ros1", "configuration"]))
def command(dialect: str) -> int:
    """Print a schema, so that an editor can check and complete: ros1 is that of launch files (RelaxNG), configuration that of
    .launchlint.yaml (JSON Schema).
    """
    from launchlint.report.formats import emit

    if dialect == "ros1":
        from launchlint.syntax.ros1.relaxng import relaxng

        emit(relaxng(), sys.stdout)
    else:
        from launchlint.workspace.configuration import schema_text

        emit(schema_text(), sys.stdout)
    return 0
