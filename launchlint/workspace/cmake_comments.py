"""What is commented out in a ``CMakeLists.txt``."""

from __future__ import annotations

import os

from launchlint.late import late
from launchlint.workspace.looking import content

CMAKE_FILE = "CMakeLists.txt"

_LONGEST_LINE = 1_000
_BUILDS = late(r"[ \t]*#[ \t#]*(?:\w{1,30}_)?add_executable[ \t]*\([ \t]*(.*)")
_FIRST_WORD = late(r"[\s#]*([^\s()#]+)")


def commented_out(directory: str, package: str, program: str) -> int | None:
    """The line of the commented-out command that would build ``program`` of the package at ``directory``; ``None`` where there is none."""
    lines = (content(os.path.join(directory, CMAKE_FILE)) or b"").decode("utf-8", "replace").splitlines()
    for number, line in enumerate(lines):
        match = _BUILDS.match(line[:_LONGEST_LINE])
        if match is None:
            continue
        following = lines[number + 1][:_LONGEST_LINE] if number + 1 < len(lines) else ""
        first = _FIRST_WORD.match(match[1] or following)
        if first is not None and first[1].strip('"').replace("${PROJECT_NAME}", package) == program:
            return number + 1
    return None
