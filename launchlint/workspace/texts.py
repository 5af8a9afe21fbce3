"""Texts of a workspace that are looked through for a word: bounded in number and size, and noted for the cache."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence

from launchlint.workspace.looking import PART, content, note, walk
from launchlint.workspace.text_parts import LARGEST, PARTS, part_of

_MOST_DIRECTORIES = 2_000
_MOST_FILES = 4_000

TYPE_CHECKING = False
if TYPE_CHECKING:
    from launchlint.workspace.contents import Contents


def texts(places: Iterable[tuple[str, Sequence[str]]], most: int, looked: set[str]) -> Iterator[tuple[str, str]]:
    """File (absolute) and text of the first ``most`` files of ``places``, which are directories with the names that are wanted of each.

    ``looked`` gets all directories, and the files that were read: what is found hangs on them. Never raises.
    """
    for file in _files(places, most, looked):
        looked.add(file)
        yield file, (content(file) or b"")[:LARGEST].decode("utf-8", "replace")


def parts(
    places: Iterable[tuple[str, Sequence[str]]], most: int, looked: set[str], part: str | Callable[[str], str], held: Contents | None = None
) -> Iterator[tuple[str, Sequence[str]]]:
    """As :func:`texts`, with the ``part`` of each text (see :mod:`launchlint.workspace.text_parts`): what is found hangs on that alone.

    It may be another one for each file. ``held`` may know what the files hold.
    """
    for file in _files(places, most, looked):
        name = part if isinstance(part, str) else part(file)
        looked.add(f"{file}{PART}{name}")
        yield file, part_of(file, name, held)


def files_by_word(
    workspaces: Iterable[str], ends: tuple[str, ...], part: str, most: int = _MOST_FILES, held: Contents | None = None
) -> Mapping[str, tuple[str, ...]]:
    """For each word of the ``part`` of the files below ``workspaces`` whose names have one of these ``ends``, the first ``most`` files
    (absolute) that hold it. ``held`` may know what the files hold. Never raises.
    """
    looked: set[str] = set()
    found: dict[str, list[str]] = {}
    for file, words in parts(_named(workspaces, ends), _MOST_FILES, looked, part, held):
        for word in words:
            files = found.setdefault(word, [])
            if len(files) < most:
                files.append(file)
    note(looked)
    return {word: tuple(files) for word, files in found.items()}


def _named(workspaces: Iterable[str], ends: tuple[str, ...]) -> Iterator[tuple[str, Sequence[str]]]:
    for workspace in workspaces:
        for parent, names in walk(workspace, _MOST_DIRECTORIES):
            yield parent, [name for name in sorted(names) if name.endswith(ends)]


def _files(places: Iterable[tuple[str, Sequence[str]]], most: int, looked: set[str]) -> Iterator[str]:
    """The first ``most`` files of ``places``; ``looked`` gets all directories."""
    for directory, wanted in places:
        looked.add(directory)
        for name in wanted:
            if most <= 0:
                break
            most -= 1
            yield os.path.join(directory, name)


def parts_of(file: str) -> tuple[str, ...]:
    """The parts of a file (absolute) as they are noted where something hangs on them alone."""
    return tuple(f"{file}{PART}{part}" for part in PARTS)
