"""The options that several commands share."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, TypeVar

import click

from launchlint.project.asked import EntryOptions
from launchlint.workspace.ros2_distributions import DISTRIBUTIONS

F = TypeVar("F", bound=Callable[..., Any])

FILE, DIRECTORY = click.Path(), click.Path(file_okay=False)
"""What a shell completes; whether it is there is looked at by the command, which says more about it."""


def entry_options(function: F) -> F:
    """Add the options of :class:`EntryOptions` to a command, which gets one as ``entry``."""

    def call(
        paths: tuple[str, ...],
        args: tuple[str, ...],
        entries: str | None,
        workspace: tuple[str, ...],
        config: str | None,
        stdin_filename: str | None,
        library: tuple[str, ...],
        no_extract: bool,
        distro: str | None,
        **others: Any,
    ) -> Any:
        return function(
            entry=EntryOptions(paths, args, entries, workspace, config, stdin_filename, library, not no_extract, distro), **others
        )

    call.__doc__ = function.__doc__
    call.__name__ = function.__name__
    if hasattr(function, "__click_params__"):
        call.__click_params__ = function.__click_params__  # type: ignore[attr-defined]  # click keeps the options given so far there
    for decorate in (
        click.option("--config", type=FILE, metavar="FILE", help="Configuration file; default: the nearest .launchlint.yaml."),
        click.option(
            "--library", multiple=True, type=FILE, metavar="FILE", help="What nodes do, over what launchlint knows itself; repeatable."
        ),
        click.option("--no-extract", is_flag=True, help="Do not read the sources of the workspaces' own nodes."),
        click.option(
            "--distro", type=click.Choice(DISTRIBUTIONS), help="The ROS 2 that launch files of it are for; default: $ROS_DISTRO, jazzy."
        ),
        click.option(
            "--workspace",
            multiple=True,
            type=DIRECTORY,
            metavar="DIR",
            help="Where packages are; repeatable, the first that has a package wins.",
        ),
        click.option("--entries", type=FILE, metavar="FILE", help="Evaluate the files, with the args, that a YAML or JSON list names."),
        click.option("--stdin-filename", type=FILE, metavar="PATH", help="With - as path: judge standard input as if it stood at PATH."),
        click.option("--arg", "args", multiple=True, metavar="NAME:=VALUE", help="An arg, as on the launcher's command line; repeatable."),
        click.argument("paths", nargs=-1, type=FILE, metavar="[PATHS]..."),
    ):
        call = decorate(call)
    return call  # type: ignore[return-value]  # the decorated function stands for the one given
