"""The commands as a lazy click group."""

from __future__ import annotations

from importlib import import_module

import click

from launchlint import __version__
from launchlint.errors import OutputClosed

COMMANDS = {
    "check": ("launchlint.cli.check", "Find the mistakes in launch files."),
    "format": ("launchlint.cli.format", "Write launch files in normal form, with the same meaning."),
    "export": ("launchlint.cli.export", "Write a launch file again, or all that it includes as one file."),
    "model": ("launchlint.cli.model", "Print what a launch file would start."),
    "graph": ("launchlint.cli.graph", "Show who talks to whom, and what changed."),
    "report": ("launchlint.cli.report", "Write a page that shows what connects, what is wrong, and where that is written."),
    "server": ("launchlint.cli.server", "Serve an editor: findings while you type, and answers."),
    "rules": ("launchlint.cli.rules", "List all rules."),
    "explain": ("launchlint.cli.explain", "Explain a rule."),
    "library": ("launchlint.cli.library", "Look at, join, compare and check libraries of node interfaces."),
    "probe": ("launchlint.cli.probe", "Run nodes and record what they publish, subscribe, serve, call and read."),
    "extract": ("launchlint.cli.extract", "Make a library of node interfaces from source code."),
    "init": ("launchlint.cli.init", "Write a configuration, and show how to run launchlint in CI."),
    "completion": ("launchlint.cli.completion", "Print what completes launchlint's words in a shell."),
    "schema": ("launchlint.cli.schema", "Print the schema of launch files or of the configuration, for editors."),
}


class LazyGroup(click.Group):
    """A group whose commands are imported only when they are called: ``--help`` and a single command stay fast."""

    def list_commands(self, ctx: click.Context) -> list[str]:
        """The names of all commands, in the order people meet them."""
        return list(COMMANDS)

    def get_command(self, ctx: click.Context, cmd_name: str) -> click.Command | None:
        """Import and return the command."""
        if cmd_name not in COMMANDS:
            return None
        command: click.Command = import_module(COMMANDS[cmd_name][0]).command
        return command

    def format_commands(self, ctx: click.Context, formatter: click.HelpFormatter) -> None:
        """The list in ``--help``, without importing anything."""
        with formatter.section("Commands"):
            formatter.write_dl([(name, summary) for name, (_, summary) in COMMANDS.items()])

    def invoke(self, ctx: click.Context) -> object:
        """Call the command; click itself would make exit status 1, which means findings, of a closed output."""
        try:
            return super().invoke(ctx)
        except BrokenPipeError as error:
            raise OutputClosed from error

    def resolve_command(self, ctx: click.Context, args: list[str]) -> tuple[str | None, click.Command | None, list[str]]:
        """Name the nearest command for one that does not exist."""
        if args and args[0] not in COMMANDS and not args[0].startswith("-"):
            from launchlint.report.escape import visible
            from launchlint.spelling import did_you_mean

            hint = did_you_mean(args[0], COMMANDS) or f"the commands are {', '.join(COMMANDS)}"
            ctx.fail(f"there is no command '{visible(args[0])}': {hint}")
        return super().resolve_command(ctx, args)


@click.group(cls=LazyGroup, invoke_without_command=True, context_settings={"help_option_names": ["-h", "--help"], "max_content_width": 110})
@click.version_option(__version__, "-V", "--version", prog_name="launchlint")
@click.pass_context
def main_group(context: click.Context) -> int:
    """Find the mistakes in ROS launch files before the robot does, without ROS and without running anything."""
    if context.invoked_subcommand is None:
        click.echo(context.get_help(), err=True)
        return 2
    return 0


def run(words: list[str]) -> int:
    """Run the command that ``words`` say. Returns its exit status; raises what the command raises."""
    from launchlint.errors import UsageError

    try:
        result = main_group.main(words, prog_name="launchlint", standalone_mode=False)
        return result if isinstance(result, int) else 0
    except click.exceptions.Exit as exit_:
        return exit_.exit_code
    except click.Abort:
        raise KeyboardInterrupt from None
    except click.ClickException as error:
        path = f"launchlint {words[0]}" if words and words[0] in COMMANDS else "launchlint"
        words_of_click = " ".join(error.format_message().split()).rstrip(".")
        raise UsageError(f"{words_of_click}; `{path} --help` shows what can be said") from error
