"""The command line: one file per command, imported when the command is called."""

from __future__ import annotations

import sys

from launchlint.errors import LaunchlintError, LibraryError, OutputClosed
from launchlint.garbage import left_to_the_system, seldom_looked_for

USAGE = 2
STOPPED = 130
"""As a shell reports Ctrl-C: 128 and the number of the signal."""
NO_READER = 141
"""As a shell reports a closed pipe."""


def main(args: list[str] | None = None, *, standalone_mode: bool = True) -> int:
    """Run launchlint with ``args`` (default: the process's own) and end the process with its exit status.

    Exit status: 0 nothing at or above ``--fail-on``, 1 findings at or above it, 2 usage, configuration or a crash in a rule. With
    ``standalone_mode=False`` the status is returned instead.
    """
    with seldom_looked_for():
        status = _run(sys.argv[1:] if args is None else args)
    if standalone_mode:
        left_to_the_system()
        sys.exit(status)
    return status


def _run(words: list[str]) -> int:
    try:
        return _command(words)
    except LibraryError as error:
        return _fail(*str(error).split("\n"))  # each of its lines has a place of its own
    except LaunchlintError as error:
        return _fail(str(error))
    except KeyboardInterrupt:
        _fail("stopped")
        return STOPPED
    except (BrokenPipeError, OutputClosed):
        _forget_output()
        return NO_READER
    except OSError as error:
        _forget_output()
        return _fail(f"this cannot be done: {error.strerror or error}" + (f": {error.filename}" if error.filename else ""))
    except Exception as error:  # the last resort: one line for people, and where to look
        return _fail(_account(error))


def _command(words: list[str]) -> int:
    """Run the command. The commonest ones go without click where they can: that would take longer than checking a file."""
    if words and words[0] == "check":
        from launchlint.cli.plain import plain_check

        plain = plain_check(words[1:])
        if plain is not None:
            from launchlint.cli.checking import run_check

            return run_check(*plain)
    if words and words[0] == "report":
        from launchlint.cli.plain import plain_report

        plain_page = plain_report(words[1:])
        if plain_page is not None:
            from launchlint.cli.reporting import run_report

            return run_report(*plain_page)
    if words and words[0] == "format":  # on every save
        from launchlint.cli.formatting import plain_options, run_format

        given = plain_options(words[1:])
        if given is not None:
            return run_format(given)
    from launchlint.cli.commands import run

    return run(words)


def _account(error: Exception) -> str:
    import traceback

    frames = traceback.extract_tb(error.__traceback__)
    where = f"{frames[-1].filename}, line {frames[-1].lineno}" if frames else "unknown place"
    return f"launchlint itself failed: {type(error).__name__}: {str(error)[:500]} ({where}); please report this"


def _fail(*messages: str) -> int:
    from launchlint.cli.entries import tell

    for message in messages:
        tell(message)
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
