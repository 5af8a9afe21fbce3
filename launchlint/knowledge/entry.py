"""What the sources of one program say, and all that this hangs on: content of files, names in directories, what is not there."""

from __future__ import annotations

import hashlib
import os
from collections.abc import Iterable, Mapping

from launchlint.named_tuple import NamedTuple
from launchlint.workspace.looking import QUESTION
from launchlint.workspace.states import Look, States

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

Key = tuple[str, str, str]
"""Package, table (``executables`` or ``nodelets``) and name of a program."""


class Known(NamedTuple):
    """What was read of one program: as a library has it, None where nothing can be known; ``reason`` says why it is not, or not all.

    ``looks`` are the paths that this hangs on, relative to the root of the package's workspace, with their states
    (:func:`launchlint.workspace.looking.state`); evidence has paths relative to that root, too.
    """

    program: Mapping[str, Any] | None
    reason: str
    looks: tuple[Look, ...]

    @property
    def digest(self) -> str:
        """Another one where the sources are others."""
        return hashlib.sha1(repr(self.looks).encode("utf-8", "surrogateescape"), usedforsecurity=False).hexdigest()


def hold(looks: Iterable[Look], root: str, states: States) -> bool:
    """Whether all is as it was; ``looks`` are relative to ``root``."""
    return all(states.of(absolute(path, root)) == known for path, known in looks)


def absolute(path: str, root: str) -> str:
    """The path that is ``path`` relative to ``root``, both in normal form."""
    joined = os.path.join(root, path)
    return os.path.normpath(joined) if path[:1] in (".", os.sep) or os.altsep else joined


def looks_at(paths: Iterable[str], root: str, states: States) -> tuple[Look, ...]:
    """The looks that stand for ``paths``: for what is not there, the names in the directory that it would be in.

    Which packages there are is in the name under which it is kept.
    """
    found: set[str] = set()
    for path in paths:
        if path.startswith(QUESTION):
            continue
        while not path.endswith("**") and not os.path.lexists(path) and path != os.path.dirname(path):
            path = os.path.dirname(path)
        found.add(path)
    return tuple(sorted((os.path.relpath(path, root), states.of(path)) for path in found))
