"""Whether some CMake file of a package builds a program of a given name, reached by its ``CMakeLists.txt`` or not."""

from __future__ import annotations

import os
import re

from launchlint.workspace.cmake_comments import CMAKE_FILE
from launchlint.workspace.looking import content, files_of

_MOST_FILES = 300
_LARGEST = 200_000


def may_build(directory: str, program: str) -> bool:
    """Whether a ``CMakeLists.txt`` anywhere below ``directory`` has a command like ``add_executable(program``. Bounded; never raises."""
    builds = re.compile(rf"\w*executable\s*\(\s*\"?{re.escape(program)}[\s\")]".encode(), re.IGNORECASE)
    lists = [file for file in files_of(directory)[0] if os.path.basename(file) == CMAKE_FILE]
    return any(builds.search((content(os.path.join(directory, file)) or b"")[:_LARGEST]) is not None for file in lists[:_MOST_FILES])
