"""What is commented out in a ``CMakeLists.txt``."""

from __future__ import annotations

import os
import re
from collections.abc import Container

from launchlint.late import late
from launchlint.workspace.looking import content

CMAKE_FILE = "CMakeLists.txt"

_LONGEST_LINE = 1_000
_BUILDS = late(r"[ \t]*#[ \t#]*(?:\w{1,30}_)?add_executable[ \t]*\([ \t]*(.*)")
_INSTALLS = late(r"[ \t]*install[ \t]*\(", re.IGNORECASE)
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


def left_out_of_install(directory: str, package: str, names: Container[str]) -> int | None:
    """The line of a comment within an ``install(…)`` that begins with one of ``names``, which somebody took out of that command; ``None``
    where there is none. A ``CMakeLists.txt`` of the package at ``directory`` is read.
    """
    depth = 0
    for number, line in enumerate((content(os.path.join(directory, CMAKE_FILE)) or b"").decode("utf-8", "replace").splitlines()):
        code, _, comment = line[:_LONGEST_LINE].partition("#")
        if depth > 0 or _INSTALLS.match(code) is not None:
            depth += code.count("(") - code.count(")")
            first = _FIRST_WORD.match(comment) if depth > 0 else None
            word = "" if first is None else first[1].strip('"').removeprefix("${CMAKE_CURRENT_SOURCE_DIR}/").rstrip("/")
            if word and word.replace("${PROJECT_NAME}", package) in names:
                return number + 1
    return None
