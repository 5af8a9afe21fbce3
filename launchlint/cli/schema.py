"""``launchlint schema``."""

from __future__ import annotations

import click


@click.command("schema")
@click.argument("dialect", type=click.Choice(["ros1"]))
def command(dialect: str) -> int:
    """Print the dialect as a RelaxNG schema, so that an XML editor can check and complete launch files."""
    from launchlint.syntax.ros1.relaxng import relaxng

    click.echo(relaxng(), nl=False)
    return 0
