"""What a check is asked to do, in plain values that can be sent to a worker and hashed for the cache."""

from __future__ import annotations

from collections.abc import Mapping

from launchlint.finding import Severity
from launchlint.fix.format.style import Style
from launchlint.named_tuple import NamedTuple

Arguments = tuple[tuple[str, str], ...]


class EntryRequest(NamedTuple):
    """One entry file to check: ``file`` is read, and judged as if it stood at ``at`` (usually the same path).

    ``arguments`` are what people give on the command line; ``declared`` says that the configuration names this file as one people start.
    """

    file: str
    at: str
    arguments: Arguments = ()
    declared: bool = False


class Options(NamedTuple):
    """All that changes findings, apart from the files themselves.

    ``rules`` are the IDs that are on; ``severities`` replace a rule's own; ``complete`` says whether every package is here (None: find
    out); ``variables`` is the environment launch files see; ``library`` are library files over the one that is shipped, and
    ``library_cache`` a directory for their indices; ``style`` is the normal form. ``extract``: the sources of the workspaces' packages are
    read, and what is read is kept in ``sources_cache``; ``staged``, if any, is the directory that holds those that git would commit, and
    the top of the repository that they are of. ``distro`` is the distribution of ROS 2 that somebody asks for, else empty.
    """

    rules: frozenset[str]
    workspaces: tuple[str, ...]
    explicit: bool
    variables: Mapping[str, str]
    root: str
    severities: Mapping[str, Severity] = {}
    complete: bool | None = None
    default_only: bool = False
    library: tuple[str, ...] = ()
    library_cache: str | None = None
    style: Style = Style()
    extract: bool = False
    sources_cache: str | None = None
    staged: tuple[str, str] | None = None
    distro: str = ""
