"""Files that one directory lacks: they lie in another one, or are not here at all. That is told once for the directory."""

from __future__ import annotations

import posixpath
from collections.abc import Sequence

from launchlint.finding import Finding
from launchlint.late import late
from launchlint.workspace.looking import exists

_NUMBER = late(r"[0-9]+")
_MOVED = "moved "
_LACKING = "lacking "
COPIES = "copies "
"""How the cause of what copies of a launch file each miss begins (see :mod:`launchlint.check.lost_files`)."""
_MISSING = "missing "
_MOST_NAMED = 3
_THE_OTHERS = "correct the other names, or add the files"
_OF_MANY = {
    "correct the path, or add the file": "correct the paths, or add the files",
    "correct the name, or create the file": "correct the names, or create the files",
}
"""What is said of one file, and of several."""


def moved(path: str, meant: str) -> str:
    """The cause of all that is looked for where ``path`` should be and lies elsewhere, as ``meant`` does; else empty.

    It is the directory, or all whose names differ in a number only; or, where a directory on the way there is left out (``nav/x.launch``
    for ``launch/nav/x.launch``), that one.
    """
    directory, name = posixpath.split(posixpath.normpath(path))
    right, other = posixpath.split(meant)
    if name != other or not right:
        return ""
    there, looked_for = right.split("/"), directory.split("/")
    same = next((at for at, (one, two) in enumerate(zip(reversed(there), reversed(looked_for), strict=False)) if one != two), 0)
    left_out = "/".join(there[1 : len(there) - same])
    where = f"{'/'.join(looked_for[: len(looked_for) - same])} {left_out}" if same and left_out else _without_number(directory)
    return f"{_MOVED}{where}"


def _without_number(directory: str) -> str:
    """``directory`` for all of its kind, as each of several robots has one: ``config/robot_#``."""
    outer, name = posixpath.split(directory)
    return posixpath.join(outer, _NUMBER.sub("#", name))


def lacking(path: str) -> str:
    """The cause of all files of one kind that the directory of ``path`` lacks; empty where that is not here itself, or holds something
    of that name that is no file.

    Then it is told of by :func:`launchlint.rules.judging.made_file.cause_of`.
    """
    directory, name = posixpath.split(posixpath.normpath(path))
    return f"{_LACKING}{directory} *{posixpath.splitext(name)[1]}" if exists(directory) and not exists(path) else ""


def told_as_moved(told: Finding, findings: Sequence[Finding], rule: str, what: str) -> Finding:
    """``told``, which speaks for all ``findings`` of one cause, with the files of those of ``rule``; ``what`` they are, in words."""
    named = list(dict.fromkeys(each.about[0] for each in findings if each.rule == rule and each.about))
    if not told.cause.startswith((_MOVED, _LACKING, COPIES)) or len(named) < 2:
        return told
    more = f" and {len(named) - _MOST_NAMED} more" if len(named) > _MOST_NAMED else ""
    advice = _OF_MANY.get(told.help, told.help)
    if told.help.endswith("?"):
        alike = all(each.help.endswith("?") for each in findings if each.rule == told.rule)
        advice = f"{told.help.removesuffix('?')}, and so for the others?" if alike else f"{told.help} {_THE_OTHERS}"
    return told._replace(
        message=f"{len(named)} {what} do not exist: {', '.join(named[:_MOST_NAMED])}{more}",
        help=advice,
    )


def same_directory(one: str, other: str) -> bool:
    """Whether the causes ``one`` and ``other`` are about one directory that is not here, of which some files lie elsewhere."""
    if not one.startswith(_MOVED):
        one, other = other, one
    directory, outermost = one.removeprefix(_MOVED), other.removeprefix(_MISSING)
    if not one.startswith(_MOVED) or not other.startswith(_MISSING):
        return False
    below = f"{directory}/".startswith(f"{outermost}/") or directory == _without_number(outermost)
    return below and not exists(outermost)
