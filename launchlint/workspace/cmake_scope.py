"""CMake variables, as far as their values can be known without running CMake."""

from __future__ import annotations

import os
import re
from collections.abc import Callable, Sequence
from fnmatch import fnmatchcase

from launchlint.workspace.cmake import Argument

Value = str | None
"""Text of an argument or variable (lists with semicolons, as in CMake); ``None`` where it cannot be known here."""

# Bounds against hostile files. What grows beyond them counts as not known.
_LONGEST_VALUE = 1 << 14
_MOST_VARIABLES = 1_000
_MOST_GLOBS = 50
_DEEPEST_REFERENCE = 8

_REFERENCE = re.compile(r"\$\{([^${}]*)\}")
_ESCAPE = re.compile(r"\\(.)", re.DOTALL)
_NAME = re.compile(r"[A-Za-z_]\w{0,99}")

# Where catkin installs (catkin_destinations, GNUInstallDirs).
_DESTINATIONS = {
    "CATKIN_GLOBAL_BIN_DESTINATION": "bin",
    "CATKIN_GLOBAL_ETC_DESTINATION": "etc",
    "CATKIN_GLOBAL_INCLUDE_DESTINATION": "include",
    "CATKIN_GLOBAL_LIB_DESTINATION": "lib",
    "CATKIN_GLOBAL_LIBEXEC_DESTINATION": "lib",
    "CATKIN_GLOBAL_SHARE_DESTINATION": "share",
    "CATKIN_PACKAGE_LIB_DESTINATION": "lib",
    "CMAKE_INSTALL_BINDIR": "bin",
    "CMAKE_INSTALL_DATADIR": "share",
    "CMAKE_INSTALL_LIBDIR": "lib",
}
_PACKAGE_DESTINATIONS = {"BIN": "lib", "ETC": "etc", "INCLUDE": "include", "SHARE": "share"}


class Scope:
    """The variables of one package's CMake files; ``files`` gives its files relative to ``root``, with ``/``.

    ``unions`` has, for lists that are not known since ways through an ``if`` differ, what any of the ways puts into them.
    """

    __slots__ = ("_files", "_globs", "root", "unions", "variables")

    def __init__(self, root: str, files: Callable[[], Sequence[str]]) -> None:
        self.root = root
        self._files = files
        self._globs = 0
        self.variables: dict[str, Value] = dict(_DESTINATIONS)
        self.unions: dict[str, str] = {}
        for name in ("CMAKE_SOURCE_DIR", "CMAKE_CURRENT_SOURCE_DIR", "CMAKE_CURRENT_LIST_DIR", "PROJECT_SOURCE_DIR"):
            self.variables[name] = root

    @property
    def here(self) -> str:
        """The directory whose CMake file is being read."""
        return self.variables.get("CMAKE_CURRENT_SOURCE_DIR") or self.root

    def path(self, relative: str) -> str:
        """An absolute path for one relative to the directory whose CMake file is being read."""
        return os.path.normpath(os.path.join(self.here, relative))

    def expand(self, arguments: Sequence[Argument], *, any_way: bool = False) -> list[Value]:
        """Arguments with variables put in; unquoted ones are split at semicolons.

        With ``any_way`` a list that is not known stands for all that may be in it, where that is known.
        """
        expanded: list[Value] = []
        for argument in arguments:
            if argument.literal:
                expanded.append(argument.text)
                continue
            value = self._value(argument.text)
            if value is None and any_way and (whole := _REFERENCE.fullmatch(argument.text)) is not None:
                value = self.unions.get(whole[1])
            if value is None or argument.quoted:
                expanded.append(value)
            else:
                expanded += [each for each in value.split(";") if each]
        return expanded

    def project(self, name: Value) -> None:
        """``project(name)``: the variables that depend on it."""
        self._put("PROJECT_NAME", name)
        self._put("CMAKE_PROJECT_NAME", name)
        for word, directory in _PACKAGE_DESTINATIONS.items():
            self._put(f"CATKIN_PACKAGE_{word}_DESTINATION", None if name is None else f"{directory}/{name}")
        if name:
            self._put(f"{name}_SOURCE_DIR", self.variables.get("PROJECT_SOURCE_DIR"))

    def assign(self, name: str, values: Sequence[Value]) -> None:
        """``set(name values…)``."""
        kept: list[Value] = []
        for value in values:
            if value in ("CACHE", "PARENT_SCOPE"):
                break
            kept.append(value)
        self._put(name, _joined(kept))

    def forget(self, names: Sequence[Value]) -> None:
        """Commands that compute what cannot be known here: the variables they may set are unknown from now on."""
        for name in names:
            if name and _NAME.fullmatch(name):
                self._put(name, None)

    def list_command(self, arguments: Sequence[Value]) -> None:
        """``list(…)``: appending is followed, other changes make the list unknown."""
        action = arguments[0] if arguments else None
        if len(arguments) < 2 or action in ("SORT", "REVERSE", "REMOVE_DUPLICATES"):
            return
        if action == "APPEND" and arguments[1] is not None:
            before = self.variables.get(arguments[1], "")
            if before is None and arguments[1] in self.unions:
                more = [each for each in arguments[2:] if each is not None]
                self.unions[arguments[1]] = together([self.unions[arguments[1]], *more])
            self._put(arguments[1], _joined([*([before] if before != "" else []), *arguments[2:]]))
        elif action in ("LENGTH", "GET", "FIND", "JOIN", "SUBLIST"):
            self.forget(arguments[-1:])
        else:
            self.forget(arguments[1:])

    def glob(self, arguments: Sequence[Value], recurse: bool) -> None:
        """``file(GLOB variable …)`` over the package's own files."""
        if arguments and arguments[0] is not None:
            self._put(arguments[0], self._matching(list(arguments[1:]), recurse))

    def _matching(self, patterns: list[Value], recurse: bool) -> Value:
        self._globs += 1
        relative: Value = None
        if "RELATIVE" in patterns[:-1]:
            at = patterns.index("RELATIVE")
            relative = patterns[at + 1]
            del patterns[at : at + 2]
            if relative is None:
                return None
        if self._globs > _MOST_GLOBS or len(patterns) > _MOST_GLOBS:
            return None
        found: set[str] = set()
        for pattern in patterns:
            if pattern in ("CONFIGURE_DEPENDS", "FOLLOW_SYMLINKS"):
                continue
            if pattern is None or pattern == "LIST_DIRECTORIES" or "$<" in pattern:
                return None
            place = os.path.relpath(self.path(pattern), self.root)
            if place.startswith(".."):
                return None
            parts = place.split("/")
            for file in self._files():
                names = file.split("/")
                compared = [*names[: len(parts) - 1], names[-1]] if recurse and len(names) >= len(parts) else names
                if len(compared) == len(parts) and all(map(fnmatchcase, compared, parts)):
                    found.add(os.path.join(self.root, file))
        base = None if relative is None else self.path(relative)
        return _joined([each if base is None else os.path.relpath(each, base) for each in sorted(found)])

    def _put(self, name: str, value: Value) -> None:
        if name in self.variables or len(self.variables) < _MOST_VARIABLES:
            self.variables[name] = value

    def _value(self, text: str) -> Value:
        """``text`` with its variables put in, the innermost first; ``None`` where one of them is not known."""
        unknown = False

        def put_in(match: re.Match[str]) -> str:
            nonlocal unknown
            value = self.variables.get(match[1])
            unknown = unknown or value is None
            return value or ""

        for _ in range(_DEEPEST_REFERENCE):
            if len(text) > _LONGEST_VALUE:
                return None
            text, count = _REFERENCE.subn(put_in, text)
            if unknown:
                return None
            if not count:
                break
        if "${" in text or "$ENV{" in text or "$CACHE{" in text or len(text) > _LONGEST_VALUE:
            return None
        return _ESCAPE.sub(r"\1", text) if "\\" in text else text


def merged(before: dict[str, Value], outcomes: Sequence[dict[str, Value]], *, exhaustive: bool) -> dict[str, Value]:
    """Variables after an ``if``: known where all ways through it that set them agree.

    ``outcomes`` are the variables after each branch; ``exhaustive`` says that one of the branches is always taken.
    """
    result = dict(before)
    changed = {name for outcome in outcomes for name, value in outcome.items() if name not in before or before[name] != value}
    for name in changed:
        values = {outcome[name] for outcome in outcomes if name in outcome}
        if not exhaustive and name in before:
            values.add(before[name])
        result[name] = values.pop() if len(values) == 1 else None
    return result


def united(before: dict[str, Value], outcomes: Sequence[dict[str, Value]]) -> dict[str, str]:
    """For the lists in which the ways through an ``if`` differ, what any of the ways puts into them."""
    names = {name for outcome in outcomes for name, value in outcome.items() if name not in before or before[name] != value}
    found: dict[str, str] = {}
    for name in sorted(names):
        values = [value for each in (before, *outcomes) if (value := each.get(name)) is not None]
        if len(values) > 1 and len("".join(values)) <= _LONGEST_VALUE:
            found[name] = together(values)
    return found


def together(values: Sequence[str]) -> str:
    """One list of all that is in several, each thing once; empty where that is too long."""
    text = ";".join(dict.fromkeys(each for value in values for each in value.split(";") if each))
    return text if len(text) <= _LONGEST_VALUE else ""


def _joined(values: Sequence[Value]) -> Value:
    known = [each for each in values if each is not None]
    text = ";".join(known)
    return None if len(known) < len(values) or len(text) > _LONGEST_VALUE else text
