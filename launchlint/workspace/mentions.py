"""Where the documents of a workspace name a package. Nothing is understood but the name."""

from __future__ import annotations

import os
import re
from collections.abc import Iterable, Iterator, Mapping
from types import MappingProxyType

from launchlint.late import late
from launchlint.named_tuple import NamedTuple
from launchlint.workspace.looking import walk
from launchlint.workspace.texts import texts

_MOST_DIRECTORIES = 2_000
_MOST_FILES = 1_000
_OF_DOCUMENTS = frozenset(("doc", "docs", "documentation", "manual", "manuals", "wiki"))
_DOCUMENT_ENDS = ("", ".md", ".rst", ".txt", ".adoc", ".rdoc")
_SHORTEST = 6
# A word with an underscore, or one behind a slash (an address) or within back quotes: other words stand in documents for other reasons.
_WORD = late(r"(?<![\w-])([A-Za-z]\w*_\w*)(?![\w-])")
_QUOTED = late(r"(?:(?<=`)|(?<=\w/))([A-Za-z][\w-]{0,200})(?=`|[\s)>.\"']|$)")
# A variable that people are told to set.
_EXPORTED = late(r"\bexport[ \t]+([A-Za-z_]\w{0,200})=")
# What people are told to call a map that they make themselves (map_server's map_saver).
_SAVED = late(r"\bmap_saver(?:_cli)?\b[^\n]{0,200}?[ \t]-f[ \t=]+[\"'`]?([^\s\"'`]{1,200})")
_INSTALL = late(r"\binstall", re.IGNORECASE)
# A name alone in its line is a heading: what is documented here, perhaps under a former name.
_HEADING = late(r"^[# \t]*[\w-]+[ \t\r:]*$", re.MULTILINE)


class Mentions(NamedTuple):
    """Each name, with the first file (absolute) that has it, and the places that were looked at.

    ``installing`` are the lines in which people are told to install something, ``saved`` the names, without the path and the end, of maps
    that they are told to save, each with the file that says so.
    """

    known: Mapping[str, str]
    looked: frozenset[str]
    installing: tuple[str, ...] = ()
    saved: Mapping[str, str] = MappingProxyType({})


def read_documents(directories: Iterable[str]) -> Mentions:
    """The names of six letters or more in the ``README*`` below ``directories``, and in documents below a ``doc``, ``docs`` and the like.

    Bounded; never raises.
    """
    found: dict[str, str] = {}
    looked: set[str] = set()
    installing: dict[str, None] = {}
    saved: dict[str, str] = {}
    for file, text in texts(_places(directories), _MOST_FILES, looked):
        installing.update(dict.fromkeys(install_lines(text)))
        for match in _SAVED.finditer(text):
            saved.setdefault(os.path.basename(match[1]), file)
        text = _HEADING.sub("", text)
        for match in (*_WORD.finditer(text), *_QUOTED.finditer(text), *_EXPORTED.finditer(text)):
            if len(match[1]) >= _SHORTEST:
                found.setdefault(match[1].removesuffix(".git"), file)
    return Mentions(found, frozenset(looked), tuple(installing), saved)


def install_lines(text: str) -> list[str]:
    """The lines of ``text`` in which the word install stands; one that ends in a backslash goes on in the next."""
    return [line for line in text.replace("\\\n", " ").splitlines() if _INSTALL.search(line)]


def says_install(name: str, lines: Iterable[str]) -> bool:
    """Whether one of such ``lines`` names the package, or the Debian package that it is in (``ros-noetic-rgbd-launch``)."""
    named = re.compile(rf"(?<![\w-]){re.escape(name)}(?![\w-])|\bros-[\w${{}}()-]{{1,20}}?-{re.escape(name.replace('_', '-'))}(?![\w-])")
    return any(named.search(line) is not None for line in lines)


def _places(directories: Iterable[str]) -> Iterator[tuple[str, list[str]]]:
    for top in directories:
        for directory, listed in walk(top, _MOST_DIRECTORIES):
            inside = not _OF_DOCUMENTS.isdisjoint(os.path.relpath(directory, top).lower().split(os.sep))
            yield directory, [name for name in listed if _is_document(name, inside=inside)]


def _is_document(name: str, *, inside: bool) -> bool:
    """Whether a file is a ``README``, or any text ``inside`` a directory of documents."""
    start, end = os.path.splitext(name.lower())
    return end in _DOCUMENT_ENDS and (start.startswith("readme") or (inside and bool(end))) and name != "CMakeLists.txt"
