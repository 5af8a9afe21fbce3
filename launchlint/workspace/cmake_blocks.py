"""Parts of CMake commands: sections between key words, and where blocks end."""

from __future__ import annotations

from collections.abc import Container, Sequence

from launchlint.late import late
from launchlint.workspace.cmake import Command
from launchlint.workspace.cmake_scope import Value
from launchlint.workspace.cmake_words import INSTALL_WORDS


def section(arguments: Sequence[Value], word: str, words: Container[Value] = INSTALL_WORDS) -> list[Value]:
    """The arguments behind the key word ``word`` up to the next one of the key words, by default those of install()."""
    if word not in arguments:
        return []
    section: list[Value] = []
    for each in arguments[arguments.index(word) + 1 :]:
        if each in words:
            break
        section.append(each)
    return section


_SOURCE_WORDS = frozenset(("SRC", "SRCS", "SOURCE", "SOURCES", "FILES"))
_KEY_WORD = late(r"[A-Z][A-Z_]+")
_HEADER = late(r"\.(?:h|hpp|hh|hxx)\Z")
_SOURCE = late(r"\.(?:cpp|cc|cxx|c\+\+|C|cu)\Z")


def sources_and_rest(words: Sequence[Value]) -> tuple[list[str], list[str]]:
    """Of the words that a command which is not known gets behind a name: C++ files, and all that is no header or key word either.

    Where a key word such as SRCS says which the sources are, only what is behind it counts.
    """
    has_word = any(each in _SOURCE_WORDS for each in words)
    takes = not has_word
    sources: list[str] = []
    rest: list[str] = []
    for each in words:
        if each is None:
            continue
        if _KEY_WORD.fullmatch(each):
            takes = each in _SOURCE_WORDS or (takes and not has_word)
        elif takes and _SOURCE.search(each):
            sources.append(each)
        elif not _HEADER.search(each):
            rest.append(each)
    return sources, rest


def parsed(arguments: Sequence[Value]) -> dict[str, list[Value]]:
    """What ``cmake_parse_arguments(prefix options one_value_words multi_value_words …)`` sets; nothing where the words are not known.

    Words that are not given have no entry.
    """
    if len(arguments) < 4 or None in arguments[:4]:
        return {}
    prefix, options, single, multiple = (str(each) for each in arguments[:4])
    found: dict[str, list[Value]] = {}
    current = ""
    for value in arguments[4:]:
        if value is not None and value in options.split(";"):
            found[f"{prefix}_{value}"] = ["TRUE"]
            current = ""
        elif value is not None and value in single.split(";") + multiple.split(";"):
            current = value
            found.setdefault(f"{prefix}_{value}", [])
        elif current and current in single.split(";"):
            found[f"{prefix}_{current}"] = [value]
            current = ""
        else:
            found.setdefault(f"{prefix}_{current or 'UNPARSED_ARGUMENTS'}", []).append(value)
    return found


def block_end(listed: Sequence[Command], start: int) -> int:
    """Position of the command that closes the block opened at ``start``; the end of the list where nothing does."""
    name = listed[start].name
    level = 0
    for position in range(start, len(listed)):
        if listed[position].name == name:
            level += 1
        elif listed[position].name == "end" + name:
            level -= 1
            if level == 0:
                return position
    return len(listed)
