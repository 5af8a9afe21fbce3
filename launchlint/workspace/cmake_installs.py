"""What ``install()``, and commands like it, install."""

from __future__ import annotations

import os
from collections.abc import Sequence

from launchlint.workspace.cmake_blocks import section
from launchlint.workspace.cmake_scope import Scope, Value
from launchlint.workspace.cmake_targets import CMakeFacts, Install, TargetInstall
from launchlint.workspace.cmake_words import INSTALL_WORDS

_ARTIFACTS = frozenset(
    """ARCHIVE LIBRARY RUNTIME OBJECTS FRAMEWORK BUNDLE PRIVATE_HEADER PUBLIC_HEADER RESOURCE FILE_SET CXX_MODULES_BMI INCLUDES""".split()
)
_TARGET_WORDS = INSTALL_WORDS | _ARTIFACTS | {"EXPORT", "RUNTIME_DEPENDENCIES", "RUNTIME_DEPENDENCY_SET", "NAMELINK_ONLY", "NAMELINK_SKIP"}


def install(facts: CMakeFacts, scope: Scope, arguments: Sequence[Value]) -> None:
    """``install(…)``: note what it installs, and why there may be more."""
    kind = arguments[0] if arguments else None
    facts.installs_by_name = True
    facts.installs_targets = facts.installs_targets or kind in ("TARGETS", "EXPORT", None)
    if kind == "TARGETS":
        _targets(facts, arguments)
    elif kind == "PROGRAMS":
        install_programs(facts, scope, "install", arguments)
    elif kind in ("FILES", "DIRECTORY"):
        _files(facts, scope, arguments, kind == "DIRECTORY")
    elif kind in ("CODE", "SCRIPT") or kind is None:
        facts.installs_reasons.append(f"install({kind or ''}) runs code")
        facts.executables_reasons.append(f"install({kind or ''}) runs code")


def install_programs(facts: CMakeFacts, scope: Scope, how: str, arguments: Sequence[Value]) -> None:
    """The files behind PROGRAMS of ``install`` or of a command like it: they are installed to be run."""
    renamed = section(arguments, "RENAME")
    programs = section(arguments, "PROGRAMS")
    known = _known(programs)
    if len(known) < len(programs):
        facts.executables_reasons.append(f"{how} with a file that is not known")
        facts.installs_reasons.append(f"{how} with a file that is not known")
        _gap(facts, f"{how} with a file that is not known", arguments)
    known = [each for each in known if each]
    for program in known:
        name = os.path.basename(renamed[0] or "" if renamed else program)
        facts.executables.setdefault(name, f"{how}(PROGRAMS)")
        facts.programs.setdefault(name, scope.path(program))
    _installed(facts, scope, known, False, arguments)


def programs_first(arguments: Sequence[Value]) -> list[Value]:
    """The arguments of ``catkin_install_python`` as ``install`` wants them: it takes every word for a file but DESTINATION, the word behind
    that, and OPTIONAL, in whatever order they stand (catkin_install_python.cmake).
    """
    files: list[Value] = []
    behind: list[Value] = []
    words = iter(arguments[1:])
    for word in words:
        if word == "DESTINATION":
            behind = [word, next(words, None)]
        elif word != "OPTIONAL":
            files.append(word)
    return [*arguments[:1], *files, *behind]


def _targets(facts: CMakeFacts, arguments: Sequence[Value]) -> None:
    """``install(TARGETS …)``: executables go where RUNTIME says, else where the destination of all is, else to ``bin``."""
    names = section(arguments, "TARGETS", _TARGET_WORDS)
    destination: Value = ""
    kind = ""
    for position, word in enumerate(arguments):
        if word in _ARTIFACTS:
            kind = str(word)
        elif arguments[position : position + 2] == ["DESTINATION", "DESTINATION"]:
            continue  # CMake takes the second for the key word
        elif word == "DESTINATION" and (kind == "RUNTIME" or (kind == "" and destination == "")):
            destination = arguments[position + 1] if position + 1 < len(arguments) else None
    for name in names:
        if name is None or "$<" in name:
            facts.targets_reasons.append("install(TARGETS) with a target that is not known")
        else:
            facts.target_installs.append(TargetInstall(name, "bin" if destination == "" else destination))


def _gap(facts: CMakeFacts, reason: str, arguments: Sequence[Value]) -> None:
    where = section(arguments, "DESTINATION")
    facts.gaps.append((reason, where[0] if where else None))


def _files(facts: CMakeFacts, scope: Scope, arguments: Sequence[Value], is_directory: bool) -> None:
    paths = section(arguments, "DIRECTORY" if is_directory else "FILES")
    known = _known(paths)
    if len(known) < len(paths):
        facts.installs_reasons.append("install with a path that is not known")
        _gap(facts, "install with a path that is not known", arguments)
    _installed(facts, scope, known, is_directory, arguments)
    if is_directory and "FILE_PERMISSIONS" in arguments:
        facts.executables_reasons.append("install(DIRECTORY) gives permissions")


def _known(paths: Sequence[Value]) -> list[str]:
    return [each for each in paths if each is not None and "$<" not in each]


def _installed(facts: CMakeFacts, scope: Scope, paths: Sequence[str], is_directory: bool, arguments: Sequence[Value]) -> None:
    """``paths`` are installed, all in the way that the ``arguments`` of one command say."""
    if not paths:
        return
    only: list[str] = []
    without: list[str] = []
    matching = False
    for position, word in enumerate(arguments):
        if word == "FILES_MATCHING":
            matching = True
        elif word in ("PATTERN", "REGEX") and position + 1 < len(arguments):
            pattern = arguments[position + 1]
            if word == "REGEX" or pattern is None:
                facts.installs_reasons.append("install(DIRECTORY) chooses files by a pattern that is not known")
            elif arguments[position + 2 : position + 3] == ["EXCLUDE"]:
                without.append(pattern)
            elif matching:
                only.append(pattern)
    where = section(arguments, "DESTINATION")
    destination = where[0] if where else None
    optional = "OPTIONAL" in arguments
    renamed = section(arguments, "RENAME")
    runnable = _runnable(arguments)
    facts.installs += [
        Install(
            scope.path(path),
            is_directory,
            destination,
            tuple(only),
            tuple(without),
            runnable,
            optional,
            contents=is_directory and path.endswith("/"),
            renamed=renamed[0] if renamed and not is_directory else "",
        )
        for path in paths
    ]


def _runnable(arguments: Sequence[Value]) -> tuple[str, ...]:
    """The patterns of the files that are given the right to be run (cmake install(FILES), install(DIRECTORY))."""
    found: list[str] = []
    permissions = False
    pattern = "*"
    for position, word in enumerate(arguments):
        if word in ("PATTERN", "REGEX"):
            pattern = (arguments[position + 1 : position + 2] or [None])[0] or "*" if word == "PATTERN" else "*"
        elif word in ("PERMISSIONS", "FILE_PERMISSIONS"):
            permissions = True
        elif word == "OWNER_EXECUTE" and permissions:
            found.append(pattern)
        elif word in INSTALL_WORDS:
            permissions = False
    programs = "PROGRAMS" in arguments and "PERMISSIONS" not in arguments
    return ("*",) if programs else tuple(dict.fromkeys(found))
