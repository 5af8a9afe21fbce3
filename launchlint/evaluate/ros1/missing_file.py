"""What there is to say of a file that cannot be read: how people see it, and which one was meant."""

from __future__ import annotations

import os

from launchlint.evaluate.session import Session
from launchlint.workspace.nearby import nearby_file

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

NO_SUCH_FILE = "there is no such file"


def missing_file(session: Session, name: str, reason: str) -> dict[str, Any]:
    """Facts about ``name``, which cannot be read because of ``reason``.

    ``shown`` is its path as people see it; ``missing`` says that there is no such file (else it is no readable text), ``relative``
    that the name is looked up where roslaunch is started, ``elsewhere`` that it lies in nothing that is here. ``near`` is the file
    that was probably meant (may be None), ``no_directory`` the directory that does not exist either (empty if it does).
    """
    shown = session.shown(name) if name else ""
    relative = not os.path.isabs(name)
    directory = os.path.dirname(name)
    return {
        "file": name,
        "reason": reason,
        "shown": shown,
        "missing": reason == NO_SUCH_FILE,
        "relative": relative,
        "elsewhere": not relative and os.path.isabs(shown) and session.packages.package_of(name) is None,
        "near": nearby_file(name),
        "no_directory": "" if relative or os.path.isdir(directory) else session.shown(directory),
    }
