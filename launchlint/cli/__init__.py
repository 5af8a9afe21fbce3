"""The command line: one file per command, imported when the command is called."""

from __future__ import annotations

import sys
from importlib import import_module

import click

from launchlint import __version__
from launchlint.errors import LaunchlintError

COMMANDS = {
    "check": ("launchlint.cli.check", "Find the mistakes in launch files."),
    "model": ("launchlint.cli.model", "Print what roslaunch would start."),
    "rules": ("launchlint.cli.rules", "List all rules."),
    "explain": ("launchlint.cli.explain", "Explain a rule."),
    "schema": ("launchlint.cli.schema", "Print a dialect as RelaxNG, for editors."),
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
            raise _OutputClosedError from error

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
    """launchlint finds the mistakes in ROS launch files before the robot does, without ROS and without running anything."""
    if context.invoked_subcommand is None:
        click.echo(context.get_help(), err=True)
        return USAGE
    return 0


USAGE = 2
STOPPED = 130
"""As a shell reports Ctrl-C: 128 and the number of the signal."""
NO_READER = 141
"""As a shell reports a closed pipe."""


class _OutputClosedError(Exception):
    """Whoever read standard output has gone, as `head` does."""


def main(args: list[str] | None = None, *, standalone_mode: bool = True) -> int:
    """Run launchlint with ``args`` (default: the process's own) and end the process with its exit status.

    Exit status: 0 nothing at or above ``--fail-on``, 1 findings at or above it, 2 usage, configuration or a crash in a rule. With
    ``standalone_mode=False`` the status is returned instead.
    """
    status = _run(args)
    if standalone_mode:
        sys.exit(status)
    return status


def _run(args: list[str] | None) -> int:
    try:
        result = main_group.main(args, prog_name="launchlint", standalone_mode=False)
        return result if isinstance(result, int) else 0
    except click.exceptions.Exit as exit_:
        return exit_.exit_code
    except click.ClickException as error:
        path = error.ctx.command_path if isinstance(error, click.UsageError) and error.ctx is not None else "launchlint"
        return _tell(f"{error.format_message().rstrip('.')}; `{path} --help` shows what can be said")
    except LaunchlintError as error:
        return _tell(str(error))
    except (KeyboardInterrupt, click.Abort):
        _tell("stopped")
        return STOPPED
    except _OutputClosedError:
        _forget_output()
        return NO_READER
    except OSError as error:
        _forget_output()
        return _tell(f"this cannot be done: {error.strerror or error}" + (f": {error.filename}" if error.filename else ""))
    except Exception as error:  # the last resort: one line for people, and where to look
        return _tell(_account(error))


def _account(error: Exception) -> str:
    import traceback

    frames = traceback.extract_tb(error.__traceback__)
    where = f"{frames[-1].filename}, line {frames[-1].lineno}" if frames else "unknown place"
    return f"launchlint itself failed: {type(error).__name__}: {str(error)[:500]} ({where}); please report this"


def _tell(message: str) -> int:
    from launchlint.report.escape import visible

    lines = "\n".join(visible(line) for line in message.splitlines())
    click.echo(f"launchlint: {lines}", err=True)
    return USAGE


def _forget_output() -> None:
    """Nothing can be written to standard output any more; Python must not try it again when it ends."""
    import os

    try:
        nowhere = os.open(os.devnull, os.O_WRONLY)
        os.dup2(nowhere, sys.stdout.fileno())
        os.close(nowhere)
    except (OSError, ValueError):
        return
