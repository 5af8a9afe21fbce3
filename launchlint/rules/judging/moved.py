"""Files that one directory lacks: they lie in another one, or are not here at all. That is told once for the directory."""

from __future__ import annotations

import posixpath
from collections.abc import Sequence

from launchlint.evaluate.problems import IncludeNotFound, ParamFileMissing
from launchlint.finding import Finding
from launchlint.rules.view import LaunchView
from launchlint.workspace.looking import exists

_MOVED = "moved "
_LACKING = "lacking "
_MOST_NAMED = 3
_LAUNCH_ENDS = (".launch", ".xml", ".test")
_OF_MANY = {
    "correct the path, or add the file": "correct the paths, or add the files",
    "correct the name, or create the file": "correct the names, or create the files",
}
"""What is said of one file, and of several."""


def moved(path: str, meant: str) -> str:
    """The cause of all that is looked for where ``path`` should be and lies elsewhere, as ``meant`` does; else empty.

    It is the directory; or, where a directory on the way there is left out (``nav/x.launch`` for ``launch/nav/x.launch``), that one.
    """
    directory, name = posixpath.split(posixpath.normpath(path))
    right, other = posixpath.split(meant)
    if name != other or not right:
        return ""
    there, looked_for = right.split("/"), directory.split("/")
    same = next((at for at, (one, two) in enumerate(zip(reversed(there), reversed(looked_for), strict=False)) if one != two), 0)
    left_out = "/".join(there[1 : len(there) - same])
    return f"{_MOVED}{'/'.join(looked_for[: len(looked_for) - same])} {left_out}" if same and left_out else f"{_MOVED}{directory}"


def lacking(path: str, source: str, view: LaunchView) -> str:
    """The cause of all files of one kind that the directory of ``path`` lacks; else empty.

    Of launch files only those count that the launch file ``source`` names. A directory that is not here itself is told of by
    :func:`launchlint.rules.judging.made_file.cause_of`.
    """
    directory, name = posixpath.split(posixpath.normpath(path))
    if not exists(directory):
        return ""
    ending = posixpath.splitext(name)[1]
    if ending and ending not in _LAUNCH_ENDS:
        return f"{_LACKING}{directory} *{ending}"
    return f"{_LACKING}{directory}" if len(view.once(_named).get((source, directory), ())) > 1 else ""


def _named(view: LaunchView) -> dict[tuple[str, str], set[str]]:
    """The missing files that each launch file names in each directory."""
    found: dict[tuple[str, str], set[str]] = {}
    for problem in view.launch.problems:
        if not isinstance(problem, (IncludeNotFound, ParamFileMissing)):
            continue
        if problem.file and posixpath.isabs(problem.file):
            directory, name = posixpath.split(posixpath.normpath(problem.file))
            found.setdefault((problem.place.source.path, directory), set()).add(name)
    return found


def told_as_moved(told: Finding, files: Sequence[str], what: str) -> Finding:
    """``told``, which speaks for all findings of one cause, with the ``files`` that these are about; ``what`` they are, in words."""
    named = list(dict.fromkeys(files))
    if not told.cause.startswith((_MOVED, _LACKING)) or len(named) < 2:
        return told
    more = f" and {len(named) - _MOST_NAMED} more" if len(named) > _MOST_NAMED else ""
    return told._replace(
        message=f"{len(named)} {what} do not exist: {', '.join(named[:_MOST_NAMED])}{more}",
        help=f"{told.help.removesuffix('?')}, and so for the others?" if told.help.endswith("?") else _OF_MANY.get(told.help, told.help),
    )
