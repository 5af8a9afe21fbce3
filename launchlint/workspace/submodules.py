"""Submodules of git that are not checked out: what lies in them is not here, and is no mistake."""

from __future__ import annotations

import os
import re

from launchlint.workspace.looking import content, exists, names

GITMODULES = ".gitmodules"
_PATH = re.compile(r"^[ \t]*path[ \t]*=[ \t]*(\S.*?)[ \t\r]*$", re.MULTILINE)
_DEEPEST = 40
_MOST = 1_000


def missing_submodule(path: str) -> str | None:
    """The directory (absolute) of the submodule that ``path`` (absolute) lies in, where it is empty or absent; else ``None``.

    The nearest ``.gitmodules`` upward counts, up to the top of the repository (gitmodules(5)). Never raises.
    """
    directory = os.path.dirname(path)
    for _ in range(_DEEPEST):
        text = content(os.path.join(directory, GITMODULES))
        if text is not None:
            return _absent(directory, path, text.decode("utf-8", "replace"))
        parent = os.path.dirname(directory)
        if exists(os.path.join(directory, ".git")) or parent == directory:
            return None
        directory = parent
    return None


def _absent(directory: str, path: str, text: str) -> str | None:
    for match in list(_PATH.finditer(text))[:_MOST]:
        module = os.path.normpath(os.path.join(directory, match[1].strip('"')))
        if path.startswith(module + os.sep) and module.startswith(directory + os.sep) and not set(names(module)) - {".git"}:
            return module
    return None
