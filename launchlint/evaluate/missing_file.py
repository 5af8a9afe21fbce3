"""What there is to say of a file that cannot be read: how people see it, and which one was meant."""

from __future__ import annotations

import os

from launchlint.evaluate.problems import ParamFileMissing
from launchlint.evaluate.session import Session
from launchlint.source import Origin
from launchlint.workspace.nearby import nearby_file

NO_SUCH_FILE = "there is no such file"


def missing_file(
    session: Session, origin: Origin, attribute: str, name: str, reason: str, *, environment: bool, refused: bool = True
) -> ParamFileMissing:
    """The problem that ``attribute`` names a file, ``name``, that cannot be read because of ``reason``.

    ``environment`` says that the name is made from an environment variable, ``refused`` that the launcher stops there.
    """
    relative = not os.path.isabs(name)
    shown = "" if not name else os.path.normpath(name).replace(os.sep, "/") if relative else session.shown(name)
    directory = os.path.dirname(name)
    return ParamFileMissing(
        origin=origin,
        refused=refused,
        attribute=attribute,
        file=name,
        reason=reason,
        shown=shown,
        missing=reason == NO_SUCH_FILE,
        relative=relative,
        elsewhere=not relative and os.path.isabs(shown) and session.packages.package_of(name) is None,
        environment=environment,
        near=nearby_file(name),
        no_directory="" if relative or os.path.isdir(directory) else session.shown(directory),
    )
