"""Where the documents of a workspace name a package. Nothing is understood but the name."""

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
_SHORTEST = 6
# A word with an underscore, or one behind a slash (an address) or within back quotes: other words stand in documents for other reasons.
_WORD = re.compile(r"(?<![\w-])([A-Za-z]\w*_\w*)(?![\w-])")
_QUOTED = re.compile(r"(?:(?<=`)|(?<=\w/))([A-Za-z][\w-]{0,200})(?=`|[\s)>.\"']|$)")
# A name alone in its line is a heading: what is documented here, perhaps under a former name.
_HEADING = re.compile(r"^[# \t]*[\w-]+[ \t\r:]*$", re.MULTILINE)


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
