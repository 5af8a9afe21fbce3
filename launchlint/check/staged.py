"""``check --staged``: the sources of nodes as git would commit them, like the launch files."""

from __future__ import annotations

import os
from collections.abc import Iterator
from contextlib import contextmanager

from launchlint.check.options import Options
from launchlint.workspace.index import has_other_sources
from launchlint.workspace.repository import repository_root


@contextmanager
def with_staged_sources(options: Options, start: str = os.curdir) -> Iterator[Options]:
    """The options for as long as the block lasts. Where the working tree holds what is staged, as it does in hooks, it is read itself.

    Raises:
        UsageError: git fails.
    """
    repository = repository_root(os.path.realpath(start))
    if not os.path.exists(os.path.join(repository, ".git")) or not has_other_sources(repository):
        yield options
        return
    import tempfile

    from launchlint.workspace.revision import unpack_index

    with tempfile.TemporaryDirectory(prefix="launchlint-") as directory:
        directory = os.path.realpath(directory)
        unpack_index(repository, directory)
        yield options._replace(staged=(directory, repository))
