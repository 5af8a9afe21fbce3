"""A file that is not here since a node makes it: one of the same launch files, in this or another configuration."""

from __future__ import annotations

import posixpath
import re
from collections.abc import Iterator
from functools import lru_cache, partial
from itertools import islice

from launchlint.late import late
from launchlint.named_tuple import NamedTuple
from launchlint.rules.view import LaunchView
from launchlint.syntax.parts import Literal, Malformed, Substitution
from launchlint.syntax.ros1.substitutions import opens, parse
from launchlint.workspace.looking import Looked, is_file, remembered
from launchlint.workspace.packages import Packages
from launchlint.workspace.text_parts import WRITES

_MOST_WORDS = 2_000
_COMMENT = late(r"<!--.*?(?:-->|\Z)", re.DOTALL)
_ELEMENT = late(r"<(node|param|arg)\b[^<>]*")
_ATTRIBUTE = late(r"""\b(type|name|args|value|default)\s*=\s*("[^"]*"|'[^']*')""")
_WORD = late(r"\S+")


class Maker(NamedTuple):
    """The ``program`` that is given the path ``given``, in line ``line`` of ``file`` (absolute)."""

    program: str
    file: str
    line: int
    given: str


def maker_of(path: str, view: LaunchView) -> Maker | None:
    """The node that probably makes the file at ``path`` (absolute), which is not here; ``None`` where there is none.

    That is one that writes, by its name or the option in front, and is given the path (the ending may be left out). And it is one that
    this configuration does not start, where it is given the file beside it whose name the missing one extends: it makes
    robot_spawner.launch from robot.launch.
    """
    directory, name = posixpath.split(path)
    stem, ending = posixpath.splitext(name)
    absolutes = view.packages.once(_absolutes)
    for document in view.documents.values():
        file = posixpath.abspath(document.source.file)
        for word in _words(document.source.text):
            if not (word.writes or (word.is_node and _may_extend(stem, word.value))):
                continue
            key = word.value, file
            one = remembered(absolutes, key, partial(absolute, word.value, file, view.packages))
            if word.is_node and _extends(directory, stem, ending, one):
                made = not _starts(view, word.program, one)
            else:
                made = word.writes and _is(path, one, stem, ending)
            if made:
                line = document.source.text.count("\n", 0, word.start) + 1
                return Maker(word.program, file, line, posixpath.basename(one))
    return None


class Word(NamedTuple):
    """What the element at ``start`` hands over: to the ``program``, or as the param or arg of that name; ``writes``: that, or an option
    in front, says that it is written.
    """

    is_node: bool
    program: str
    value: str
    writes: bool
    start: int


@lru_cache(maxsize=256)  # each file that is not here is asked for in every configuration
def _words(text: str) -> tuple[Word, ...]:
    """The words with a path in them that the elements of a launch file hand over; those in comments are none."""
    return tuple(word for word in handed_over(text) if "/" in word.value or opens(word.value))


def handed_over(text: str) -> Iterator[Word]:
    """The words that the elements of a launch file hand over; those in comments are none."""
    text = _blanked(text)
    for element in _ELEMENT.finditer(text):
        for program, before, word in _given(element[0], element[1] == "node"):
            option, _, value = word.rpartition("=")
            writes = any(map(WRITES.search, (program, option or before)))
            yield Word(element[1] == "node", program, value, writes, element.start())


def _given(element: str, is_node: bool) -> Iterator[tuple[str, str, str]]:
    """Each word that an element hands over, with the program (or the name of the param or arg) and the word in front of it."""
    attributes = {match[1]: match[2][1:-1] for match in _ATTRIBUTE.finditer(element)}
    if not is_node:
        yield attributes.get("name", ""), "", attributes.get("value", attributes.get("default", ""))
        return
    given = parse(attributes.get("args", ""))
    words = [given.text[slice(*match.span())] for match in islice(_WORD.finditer(given.filled()), _MOST_WORDS)]
    program = attributes.get("type", "")
    for before, word in zip(("", *words), words, strict=False):
        yield program, before, word


def _blanked(text: str) -> str:
    return _COMMENT.sub(lambda match: re.sub(r"[^\n]", " ", match[0]), text)


def _absolutes(packages: Packages) -> dict[tuple[str, str], tuple[str, Looked]]:
    """The paths that words of files name, see :func:`absolute`."""
    return {}


def absolute(word: str, file: str, packages: Packages) -> str:
    """The path a word names, as far as ``$(find …)`` and ``$(dirname)`` tell; with other substitutions, what is behind the last of them."""
    path, whole = "", True
    for part in parse(word).parts:
        if isinstance(part, (Literal, Malformed)):
            path += part.text
        elif isinstance(part, Substitution) and part.command == "dirname":
            path += posixpath.dirname(file)
        elif isinstance(part, Substitution) and part.command == "find" and part.start == 0:
            path = packages.find(part.only, file) or ""
        else:
            path, whole = "", False
    return posixpath.normpath(path) if whole else path


def _is(path: str, given: str, stem: str, ending: str) -> bool:
    """Whether ``given`` is the path, or with a directory the end of it; its ending may be left out."""
    if given.startswith("/") and given.count("/") > 1 and given.endswith((stem, stem + ending)):
        return path in (given, given + ending) or path.endswith((given, given + ending))
    return False


def _may_extend(stem: str, word: str) -> bool:
    """What :func:`_extends` asks of the name of a file, before it is known where that lies."""
    name = word.rpartition("/")[2]
    return "$" in name or ")" in name or name in ("", ".", "..") or stem.startswith(posixpath.splitext(name)[0])


def _extends(directory: str, stem: str, ending: str, given: str) -> bool:
    """Whether the file ``given`` lies in ``directory`` and the missing name is its name and a word more."""
    parent, name = posixpath.split(given)
    start, other = posixpath.splitext(name)
    longer = bool(start) and stem.startswith((f"{start}_", f"{start}-", f"{start}."))
    return longer and parent == directory and other == ending and is_file(given)


def _starts(view: LaunchView, program: str, given: str) -> bool:
    return any(node.executable == program and given in node.arguments for node in view.launch.nodes)
