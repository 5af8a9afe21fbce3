"""Files that a build makes: what CMake commands write, as far as their names can be read."""

from __future__ import annotations

import os
import posixpath
import re
from collections.abc import Sequence
from fnmatch import fnmatchcase
from itertools import pairwise

from launchlint.late import late
from launchlint.workspace.cmake import Command
from launchlint.workspace.cmake_scope import Scope
from launchlint.workspace.looking import exists

MAKING = frozenset(
    """
    configure_file add_custom_command add_custom_target execute_process file install catkin_add_env_hooks em_expand
    catkin_download catkin_download_test_data xacro_add_files xacro_add_xacro_file xacro_install
    ExternalProject_Add FetchContent_Declare generate_export_header write_basic_package_version_file configure_package_config_file
    """.lower().split()
)
"""Commands that write files, into the build or the source directory."""

RUNNING = frozenset(("add_custom_command", "execute_process"))
"""Commands that run programs, and say of what these write at most the names that others need."""
_BUILD_TOOLS = late(r"(?:.*/)?(?:\$\(MAKE\)|g?make|ninja|scons|bazel|cargo|ant|mvn|gradlew?|meson|waf)")

_FILE_ACTIONS = frozenset("WRITE APPEND TOUCH GENERATE CONFIGURE DOWNLOAD COPY COPY_FILE INSTALL RENAME CREATE_LINK MAKE_DIRECTORY".split())
_NEEDED = frozenset(("DEPENDS", "MAIN_DEPENDENCY", "WORKING_DIRECTORY", "COMMENT", "IMPLICIT_DEPENDS", "URL", "URL_HASH", "GIT_REPOSITORY"))
_KEY_WORD = late(r"[A-Z][A-Z_0-9]+")
_SHORTEST_STEM = 2
_MOST = 2_000
_LONGEST = 300


class Made:
    """What the build of a package makes. ``names``: name of a file → the command and where it stands; ``patterns`` are those of which a
    part is not known, with ``*`` for it; ``directories`` (absolute) are not here, and all that is in them is made.
    """

    __slots__ = ("directories", "names", "patterns")

    def __init__(self) -> None:
        self.names: dict[str, str] = {}
        self.patterns: dict[str, str] = {}
        self.directories: dict[str, str] = {}

    def by(self, path: str) -> str | None:
        """What makes the file at ``path`` (absolute): a command and where it stands; ``None`` where nothing is known to."""
        name = os.path.basename(path)
        if name in self.names:
            return self.names[name]
        for pattern, how in self.patterns.items():
            if fnmatchcase(name, pattern):
                return how
        return next((how for directory, how in self.directories.items() if path.startswith(f"{directory}/")), None)

    def note(self, scope: Scope, command: Command, place: str) -> None:
        """Note what ``command`` makes; ``place`` says where it stands."""
        how = f"{command.name} ({place}, line {command.line})"
        for text in _written(scope, command):
            for word in text.split():
                self._word(scope, word.strip("\"'"), how)

    def _word(self, scope: Scope, word: str, how: str) -> None:
        name = os.path.basename(word)
        if not name or len(word) > _LONGEST or "$<" in word or "://" in word or "\0" in word:
            return
        if "*" in name:
            stem = name.rpartition(".")[0]
            if sum(map(str.isalnum, stem)) >= _SHORTEST_STEM and len(self.patterns) < _MOST:
                self.patterns.setdefault(re.sub(r"\*+", "*", name), how)
            return
        if "." in name.strip(".") and len(self.names) < _MOST:
            self.names.setdefault(name, how)
        path = scope.path(word)
        if "/" in word and "*" not in word and len(self.directories) < _MOST and path.startswith(f"{scope.root}/") and not exists(path):
            self.directories.setdefault(path, how)


def runs_another_build(words: Sequence[str]) -> bool:
    """Whether a command runs a build with files of its own (``make -C test``), which may make anything."""
    return any(word == "COMMAND" and _BUILD_TOOLS.fullmatch(program) is not None for word, program in pairwise(words))


def _written(scope: Scope, command: Command) -> list[str]:
    """The arguments that may name what ``command`` writes, with ``*`` for what is not known of them."""
    words = scope.with_gaps(command.arguments)
    first = words[0] if words else ""
    if command.name == "configure_file":
        output = words[1] if len(words) > 1 else ""
        return [output if "." in os.path.basename(output) else f"{output}/{os.path.basename(first)}"]
    if command.name == "file":
        return words[1:] if first in _FILE_ACTIONS else []
    if command.name == "install":
        return words[words.index("RENAME") + 1 :][:1] if "RENAME" in words else []
    if command.name == "catkin_add_env_hooks":
        return [f"{first}.{shell}" for shell in words[1:]]
    if command.name.startswith("catkin_download") and "FILENAME" not in words:  # the file has the name that it has there
        return [posixpath.basename(word) for word in words[1:2]]
    kept = _not_needed(words)
    if command.name.startswith("xacro_"):
        kept += [each.removesuffix(".xacro") for each in kept if each.endswith(".xacro")]
    return kept


def _not_needed(words: Sequence[str]) -> list[str]:
    kept: list[str] = []
    needed = False
    for word in words:
        if _KEY_WORD.fullmatch(word):
            needed = word in _NEEDED
        elif not needed:
            kept.append(word)
    return kept
