"""``launchlint completion``."""

from __future__ import annotations

import sys

import click


@click.command("completion")
@click.argument("shell", type=click.Choice(["bash", "zsh", "fish"]))
def command(shell: str) -> int:
    """Print what completes launchlint's commands, options and files in a shell.

    Put eval "$(launchlint completion bash)" into ~/.bashrc, the same with zsh into ~/.zshrc, or for fish:
    launchlint completion fish > ~/.config/fish/completions/launchlint.fish
    """
    from click.shell_completion import get_completion_class

    from launchlint.cli.commands import main_group
    from launchlint.report.formats import emit

    made = get_completion_class(shell)
    assert made is not None
    source = made(main_group, {}, "launchlint", "_LAUNCHLINT_COMPLETE")
    emit(source.source_template % source.source_vars() + "\n", sys.stdout)
    return 0
