"""Names that the sources of a node hold in comments: calls that were switched off."""

from __future__ import annotations

import posixpath
import re
from collections.abc import Iterator

from launchlint.graph.connections import Instance
from launchlint.late import late
from launchlint.workspace.looking import read_bytes

_COMMENTS = {".py": late(r"#[^\n]*"), "": late(r"//[^\n]*|/\*.*?(?:\*/|\Z)", re.DOTALL)}
_MOST_FILES = 10


def commented_out(name: str, instance: Instance, root: str) -> str:
    """Where a comment in the sources of ``instance`` has ``name`` in quotes (``path:line``); empty where none has.

    Only sources in which other names of the node were read are looked at; ``root`` is what their paths are relative to.
    """
    bare = name.lstrip("~/")
    quoted = re.compile(rf"[\"'][~/]*{re.escape(bare)}[\"']")
    for path in dict.fromkeys(_sources(instance)) if bare and root else ():
        try:
            text = read_bytes(posixpath.join(root, path)).decode("utf-8", "replace")
        except OSError:
            continue
        for comment in _COMMENTS[".py" if path.endswith(".py") else ""].finditer(text):
            found = quoted.search(text, comment.start(), comment.end())
            if found is not None:
                return f"{path}:{text.count(chr(10), 0, found.start()) + 1}"
    return ""


def _sources(instance: Instance) -> Iterator[str]:
    paths: dict[str, None] = {}
    for endpoint in instance.endpoints:
        for evidence in endpoint.declaration.evidence:
            if "here" in evidence and len(paths) < _MOST_FILES:
                paths[evidence.get("at", "").rpartition(":")[0]] = None
    yield from (path for path in paths if path)
