"""Where texts of a workspace name a package: its documents, and its launch files. Nothing is understood but the name."""

from __future__ import annotations

import os
import re
from collections.abc import Iterable, Mapping
from typing import NamedTuple

from launchlint.workspace.looking import content, walk

_MOST_DIRECTORIES = 2_000
_MOST_FILES = 1_000
_LARGEST = 200_000
_DOCUMENT_ENDS = ("", ".md", ".rst", ".txt", ".adoc", ".rdoc")
_LAUNCH_ENDS = (".launch", ".launch.xml", ".test")
_SHORTEST = 6
# A word with an underscore, or one behind a slash (an address) or within back quotes: other words stand in documents for other reasons.
_WORD = re.compile(r"(?<![\w-])([A-Za-z]\w*_\w*)(?![\w-])")
_QUOTED = re.compile(r"(?:(?<=`)|(?<=\w/))([A-Za-z][\w-]{0,200})(?=`|[\s)>.\"']|$)")
# A name alone in its line is a heading: what is documented here, perhaps under a former name.
_HEADING = re.compile(r"^[# \t]*[\w-]+[ \t\r:]*$", re.MULTILINE)
_USED = re.compile(r"\$\(\s*find\s+([A-Za-z][\w-]*)|\bpkg\s*=\s*[\"']([A-Za-z][\w-]*)")


class Mentions(NamedTuple):
    """Each name, with the first file (absolute) that has it, and the places that were looked at."""

    known: Mapping[str, str]
    looked: frozenset[str]


def read_documents(directories: Iterable[str]) -> Mentions:
    """The names of six letters or more in the ``README*`` below ``directories``, and in documents below a ``doc`` or ``docs``.

    Bounded; never raises.
    """
    found: dict[str, str] = {}
    looked: set[str] = set()
    left = _MOST_FILES
    for top in directories:
        for directory, listed in walk(top, _MOST_DIRECTORIES):
            looked.add(directory)
            inside = {"doc", "docs"} & set(os.path.relpath(directory, top).lower().split(os.sep))
            for name in listed:
                start, end = os.path.splitext(name.lower())
                if left <= 0 or end not in _DOCUMENT_ENDS or not (start == "readme" or (inside and end)) or name == "CMakeLists.txt":
                    continue
                left -= 1
                file = os.path.join(directory, name)
                looked.add(file)
                text = _HEADING.sub("", (content(file) or b"")[:_LARGEST].decode("utf-8", "replace"))
                for match in (*_WORD.finditer(text), *_QUOTED.finditer(text)):
                    if len(match[1]) >= _SHORTEST:
                        found.setdefault(match[1].removesuffix(".git"), file)
    return Mentions(found, frozenset(looked))


def used_by_launch_files(directory: str) -> Mentions:
    """The packages that launch files of the package at ``directory`` name, whether or not they use them. Bounded; never raises."""
    found: dict[str, str] = {}
    looked: set[str] = set()
    left = _MOST_FILES
    for below, listed in walk(directory, _MOST_DIRECTORIES):
        looked.add(below)
        if below != directory and "package.xml" in listed:
            continue
        for name in listed:
            if left > 0 and name.endswith(_LAUNCH_ENDS):
                left -= 1
                file = os.path.join(below, name)
                looked.add(file)
                text = (content(file) or b"")[:_LARGEST].decode("utf-8", "replace")
                for match in _USED.finditer(text):
                    found.setdefault(match[1] or match[2], file)
    return Mentions(found, frozenset(looked))
