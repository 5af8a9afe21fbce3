"""What launchlint itself is: whatever it keeps hangs on that, and a checkout changes without a new version."""

from __future__ import annotations

import hashlib
import os
import sys
from collections.abc import Iterator

from launchlint import __version__
from launchlint.workspace.contents import Contents


def own_code(held: Contents) -> str:
    """Another one where launchlint's files, Python, PyYAML or the readers of C++ are others."""
    found = hashlib.sha256(f"{__version__}\0{sys.version}".encode())
    for part in _parts(held):
        found.update(f"\0{part}".encode("utf-8", "surrogateescape"))
    return found.hexdigest()


def _parts(held: Contents) -> Iterator[str]:
    import launchlint
    from launchlint.knowledge.code import readers

    yield readers()
    for directory, directories, files in os.walk(os.path.dirname(launchlint.__file__)):
        directories[:] = sorted(name for name in directories if name != "__pycache__")
        for name in sorted(files):
            yield name
            yield held.sha1(os.path.join(directory, name)) or ""
    for directory in sys.path:
        yaml = held.sha1(os.path.join(os.path.abspath(directory), "yaml", "__init__.py"))
        if yaml is not None:  # it names its version
            yield yaml
            return
