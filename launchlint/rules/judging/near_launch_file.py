"""Which launch file of ROS 2 was meant by a name that is not there: one beside it, called nearly so or by the other custom."""

from __future__ import annotations

import posixpath
from collections.abc import Container

from launchlint.spelling import closest, same_digits
from launchlint.workspace.looking import names

_ENDS = (".launch", ".launch.py", ".launch.xml", ".launch.yaml", ".launch.yml", "_launch.py", "_launch.xml", "_launch.yaml", "_launch.yml")
_MOST_FILES = 5_000


def near_launch_file(file: str, taken: Container[str]) -> str | None:
    """The name of a launch file in the directory of ``file``; none of ``taken`` (absolute paths), which are meant by other includes.

    ``robot_launch.py`` is meant for ``robot.launch.py`` and for ``robot.launch.xml``, in this order; files that differ in a digit stand for
    different things.
    """
    directory, base = posixpath.split(posixpath.normpath(file))
    beside = sorted(
        (name for name in names(directory)[:_MOST_FILES] if name.endswith(_ENDS) and name != base and same_digits(name, base)),
        key=lambda name: (posixpath.splitext(name)[1] != posixpath.splitext(base)[1], name),
    )
    stems: dict[str, str] = {}
    for name in beside:
        if posixpath.join(directory, name) not in taken:
            stems.setdefault(_stem(name), name)
    wanted = _stem(base)
    return stems.get(wanted) or stems.get(closest(wanted, stems) or "")


def _stem(name: str) -> str:
    return name.partition(".")[0].removesuffix("_launch")
