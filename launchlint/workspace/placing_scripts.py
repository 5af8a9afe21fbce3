"""Programs that a shell script or Makefile of the workspace puts into the install or devel space itself, beside what the build puts there.

Nothing is run.
"""

from __future__ import annotations

import os
import re
from collections.abc import Iterable, Mapping

from launchlint.late import late
from launchlint.named_tuple import NamedTuple
from launchlint.workspace.looking import walk
from launchlint.workspace.texts import texts

_MOST_DIRECTORIES = 2_000
_MOST_FILES = 600
_ENDS = ("", ".sh", ".bash", ".mk")
_MAKEFILES = ("Makefile", "makefile", "GNUmakefile")
_FIRST_LINE = late(r"#![^\n]{0,200}sh\b")
# No grammar, a look through whole scripts: that a program is put there by a script is a reason for less, never for more.
# lib/PKG in the install space of colcon (install/PKG/lib/PKG, or install/lib/PKG) and in the spaces of catkin (devel/lib/PKG and the like).
_LIBEXEC = late(r"\b(?:install|devel)(?:_isolated)?/(?:[^\s\"']{1,200}/)?lib/")
_COPIES = late(r"(?:^|&&|;)[ \t]{0,80}[@-]?(?:sudo[ \t]{1,8})?(?:cp|ln|mv|install|rsync)[ \t]", re.MULTILINE)
_WORD = late(r"[\w.-]+")


class Placed(NamedTuple):
    """Each word of the scripts that copy programs to ``lib/PKG`` of the install or devel space, with these (absolute), and what was
    looked at.
    """

    known: Mapping[str, tuple[str, ...]]
    looked: frozenset[str]


def read_placing_scripts(directories: Iterable[str]) -> Placed:
    """The words of such scripts below ``directories``. Bounded; never raises."""
    found: dict[str, list[str]] = {}
    looked: set[str] = set()
    places = (
        (directory, [name for name in listed if os.path.splitext(name)[1] in _ENDS])
        for top in directories
        for directory, listed in walk(top, _MOST_DIRECTORIES)
    )
    for file, text in texts(places, _MOST_FILES, looked):
        if (_is_makefile(file) or _FIRST_LINE.match(text)) and _LIBEXEC.search(text) and _COPIES.search(text):
            for word in dict.fromkeys(_WORD.findall(text)):
                found.setdefault(word, []).append(file)
    return Placed({word: tuple(files) for word, files in found.items()}, frozenset(looked))


def _is_makefile(file: str) -> bool:
    return file.endswith(".mk") or os.path.basename(file) in _MAKEFILES
