"""A file that is not here since something makes it: the build, a template that somebody fills in, or the robot."""

from __future__ import annotations

from typing import NamedTuple

from launchlint.rules.other_file import shown
from launchlint.rules.package_contents import contents
from launchlint.workspace.packages import Packages


class Made(NamedTuple):
    """``why`` it can be told that the file is made (one line), and the ``help``."""

    why: str
    help: str


def made(path: str, packages: Packages, root: str) -> Made | None:
    """What makes the file at ``path`` (absolute), which is not here; ``None`` where nothing is known to.

    That is a command of the package's CMake files, else a template beside it, else whatever makes what ``.gitignore`` names.
    """
    from launchlint.workspace.ignored import ignored_by
    from launchlint.workspace.templates import template_of

    package = packages.package_of(path)
    how = None if package is None else contents(packages).made(package).by(path)
    if how is not None:
        return Made(f"the build makes it: {how}", "build the package before this is started")
    template = template_of(path)
    if template is not None:
        name = shown(template, root)
        return Made(f"{name} lies beside it: a template from which it may be made", f"make it from {name} before this is started")
    ignore = ignored_by(path)
    if ignore is None:
        return None
    why = f"git ignores it ({ignore.pattern} in {shown(ignore.file, root)}), so that it is made, or put there, on each machine"
    return Made(why, "see that it is there before this is started")
