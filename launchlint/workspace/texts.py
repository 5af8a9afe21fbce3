"""Texts of a workspace that are looked through for a word: bounded in number and size, and noted for the cache."""

from __future__ import annotations

import os
from collections.abc import Iterable, Iterator, Mapping, Sequence

from launchlint.workspace.looking import PART, content, note, walk
from launchlint.workspace.text_parts import LARGEST, PARTS, part_of

_MOST_DIRECTORIES = 2_000
_MOST_FILES = 4_000


def texts(places: Iterable[tuple[str, Sequence[str]]], most: int, looked: set[str]) -> Iterator[tuple[str, str]]:
    """File (absolute) and text of the first ``most`` files of ``places``, which are directories with the names that are wanted of each.

    ``looked`` gets all directories, and the files that were read: what is found hangs on them. Never raises.
    """
    for file in files(places, most, looked):
        yield file, decoded(content(file) or b"")


def decoded(data: bytes) -> str:
    """What is looked through of the content of a file."""
    return data[:LARGEST].decode("utf-8", "replace")


def files(places: Iterable[tuple[str, Sequence[str]]], most: int, looked: set[str]) -> Iterator[str]:
    """As :func:`texts`, the files alone, for who knows what is in them."""
    for file in _files(places, most, looked):
        looked.add(file)
        yield file


def parts(places: Iterable[tuple[str, Sequence[str]]], most: int, looked: set[str], part: str) -> Iterator[tuple[str, Sequence[str]]]:
    """As :func:`texts`, with the ``part`` of each text (see :mod:`launchlint.workspace.text_parts`): what is found hangs on that alone."""
    for file in _files(places, most, looked):
        looked.add(f"{file}{PART}{part}")
        yield file, part_of(file, part)


def files_by_word(workspaces: Iterable[str], ends: tuple[str, ...], part: str, most: int = _MOST_FILES) -> Mapping[str, tuple[str, ...]]:
    """For each word of the ``part`` of the files below ``workspaces`` whose names have one of these ``ends``, the first ``most`` files
    (absolute) that hold it. Never raises.
    """
    looked: set[str] = set()
    found: dict[str, list[str]] = {}
    for file, words in parts(_named(workspaces, ends), _MOST_FILES, looked, part):
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
