"""CMake variables, as far as their values can be known without running CMake."""

from __future__ import annotations

import os
import re
from collections.abc import Callable, Mapping, Sequence
from fnmatch import fnmatchcase
from types import MappingProxyType

from launchlint.late import late
from launchlint.workspace.cmake import Argument
from launchlint.workspace.cmake_conditions import constant
from launchlint.workspace.looking import is_file

Value = str | None
"""Text of an argument or variable (lists with semicolons, as in CMake); ``None`` where it cannot be known here."""

# Bounds against hostile files. What grows beyond them counts as not known.
_LONGEST_VALUE = 1 << 14
_MOST_VARIABLES = 1_000
_MOST_GLOBS = 50
_SOURCES = (".c", ".C", ".cc", ".cpp", ".cxx", ".c++", ".cu")
_DEEPEST_REFERENCE = 8
_MOST_WAYS = 8

_REFERENCE = late(r"\$\{([^${}]*)\}")
_ESCAPE = late(r"\\(.)", re.DOTALL)
_NAME = late(r"[A-Za-z_]\w{0,99}")

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
_BUILD_DIRECTORIES = ("CMAKE_BINARY_DIR", "PROJECT_BINARY_DIR", "CMAKE_CURRENT_BINARY_DIR")
_PACKAGE_DESTINATIONS = {"BIN": "lib", "ETC": "etc", "INCLUDE": "include", "SHARE": "share"}


class Scope:
    """The variables of one package's CMake files; ``files`` gives its files relative to ``root``, with ``/``; ``more`` are set beforehand.

    ``unions`` has, for lists that are not known since ways through an ``if`` differ, what any of the ways puts into them; ``ways`` has,
    for variables of which some ways are known, the values on those; ``constants``, for those that the file itself sets to a constant of
    CMake, whatever it is configured with, whether it is a true one.
    """

    __slots__ = ("_files", "_globs", "constants", "gaps", "root", "unions", "variables", "ways")

    def __init__(self, root: str, files: Callable[[], Sequence[str]], more: Mapping[str, Value] = MappingProxyType({})) -> None:
        self.root = root
        self._files = files
        self._globs = 0
        self.variables: dict[str, Value] = {**_DESTINATIONS, **more}
        self.unions: dict[str, str] = {}
        self.gaps: dict[str, str] = {}
        self.ways: dict[str, tuple[str, ...]] = {}
        self.constants: dict[str, bool] = {}
        for name in ("CMAKE_SOURCE_DIR", "CMAKE_CURRENT_SOURCE_DIR", "CMAKE_CURRENT_LIST_DIR", "PROJECT_SOURCE_DIR"):
            self.variables[name] = root

    @property
    def here(self) -> str:
        """The directory whose CMake file is being read."""
        return self.variables.get("CMAKE_CURRENT_SOURCE_DIR") or self.root

    def path(self, relative: str) -> str:
        """An absolute path for one relative to the directory whose CMake file is being read."""
        return os.path.normpath(os.path.join(self.here, relative))

    def built(self, path: str) -> str:
        """The place in the build directory that is for ``path`` in the package; there is no such directory on the disk."""
        return os.path.join(self.root, "<build>", os.path.relpath(path, self.root)).removesuffix("/.")

    def template(self, argument: Argument) -> str | None:
        """The file in the package that an argument means; where a variable in it depends on an ``if``, the one that there is."""
        known = self._value(argument.text)
        tried = {known}
        if known is None:
            for name in _REFERENCE.findall(argument.text):
                tried |= {self._value(argument.text.replace(f"${{{name}}}", way)) for way in self.ways.get(name, ())}
        found = {path for each in tried if each and "\0" not in each and is_file(path := self.path(each))}
        return found.pop() if len(found) == 1 else None

    def expand(self, arguments: Sequence[Argument], *, any_way: bool = False) -> list[Value]:
        """Arguments with variables put in; unquoted ones are split at semicolons.

        With ``any_way`` a list that is not known stands for all that may be in it, where that is known; and what is said to be in the build
        directory is known by the place that ``built`` gives it.
        """
        expanded: list[Value] = []
        for argument in arguments:
            if argument.literal:
                expanded.append(argument.text)
                continue
            value = self._value(argument.text, any_way=any_way)
            if value is None and any_way and (whole := _REFERENCE.fullmatch(argument.text)) is not None:
                value = self.unions.get(whole[1])
            if value is None or argument.quoted:
                expanded.append(value)
            else:
                expanded += [each for each in value.split(";") if each]
        return expanded

    def with_gaps(self, arguments: Sequence[Argument]) -> list[str]:
        """As :meth:`expand` ``any_way``, with ``*`` for each variable that is not known."""
        expanded: list[str] = []
        for argument in arguments:
            known = self.expand([argument], any_way=True)
            if None in known:
                text = argument.text
                for _ in range(_DEEPEST_REFERENCE):
                    text, count = _REFERENCE.subn(lambda match: self.variables.get(match[1]) or self.gaps.get(match[1], "*"), text)
                    if not count or len(text) > _LONGEST_VALUE:
                        break
                known = [text[:_LONGEST_VALUE]]
            expanded += [each for each in known if each]
        return expanded

    def project(self, name: Value) -> None:
        """``project(name)``: the variables that depend on it."""
        self._put("PROJECT_NAME", name)
        self._put("CMAKE_PROJECT_NAME", name)
        for word, directory in _PACKAGE_DESTINATIONS.items():
            self._put(f"CATKIN_PACKAGE_{word}_DESTINATION", None if name is None else f"{directory}/{name}")
        if name:
            self._put(f"{name}_SOURCE_DIR", self.variables.get("PROJECT_SOURCE_DIR"))

    def assign(self, name: str, values: Sequence[Value], *, settled: bool = False) -> None:
        """``set(name values…)``; ``settled``: it is come to in any case. What ``find_package`` sets is no constant."""
        kept: list[Value] = []
        for value in values:
            if value in ("CACHE", "PARENT_SCOPE"):
                break
            kept.append(value)
        self._put(name, _joined(kept))
        holds = constant(str(values[0])) if settled and len(values) == 1 and not name.upper().endswith("_FOUND") else None
        if holds is not None:
            self.constants[name] = holds

    def assign_any(self, name: str, values: Sequence[Value]) -> None:
        """What a variable that is not known has in it, expanded with ``any_way``."""
        value = _joined(values)
        if value is None:
            self.unions.pop(name, None)
        elif len(self.unions) < _MOST_VARIABLES:
            self.unions[name] = value

    def assign_gaps(self, name: str, arguments: Sequence[Argument]) -> None:
        """What is known of a variable that is not known as a whole, with ``*`` for the rest: the name of a file below some directory."""
        if len(self.gaps) < _MOST_VARIABLES:
            self.gaps[name] = ";".join(self.with_gaps(arguments))[:_LONGEST_VALUE]

    def branch(self, before: dict[str, Value], outcomes: Sequence[dict[str, Value]], *, exhaustive: bool) -> None:
        """After an ``if``: what the variables are, and what is known of the ways through it (see ``merged``)."""
        for name, values in differing(before, outcomes).items():
            if len(values) > 1 and len("".join(values)) <= _LONGEST_VALUE:
                self.unions[name] = together(values)
            if values:
                self.ways[name] = tuple(dict.fromkeys(values))[:_MOST_WAYS]
        self.variables = merged(before, outcomes, exhaustive=exhaustive)

    def forget(self, names: Sequence[Value]) -> None:
        """Commands that compute what cannot be known here: the variables they may set are unknown from now on."""
        for name in names:
            if name and _NAME.fullmatch(name):
                self._put(name, None)

    def list_command(self, arguments: Sequence[Value]) -> None:
        """``list(…)``: what adds or removes items is followed, other changes make the list unknown."""
        action = arguments[0] if arguments else None
        if len(arguments) < 2 or action in ("SORT", "REVERSE", "REMOVE_DUPLICATES"):
            return
        if action == "APPEND" and arguments[1] is not None:
            before = self.variables.get(arguments[1], "")
            if before is None and arguments[1] in self.unions:
                more = [each for each in arguments[2:] if each is not None]
                self.unions[arguments[1]] = together([self.unions[arguments[1]], *more])
            self._put(arguments[1], _joined([*([before] if before != "" else []), *arguments[2:]]))
        elif action in ("PREPEND", "REMOVE_ITEM") and (name := arguments[1]) is not None:
            listed, items = self.variables.get(name), arguments[2:]
            if listed is None or None in items:
                self.forget([name])
            elif action == "PREPEND":
                self._put(name, _joined([*items, *([listed] if listed else [])]))
            else:
                removed = set(items)
                self._put(name, ";".join(each for each in listed.split(";") if each not in removed))
        elif action in ("LENGTH", "GET", "FIND", "JOIN", "SUBLIST"):
            self.forget(arguments[-1:])
        else:
            self.forget(arguments[1:])

    def filename_command(self, arguments: Sequence[Value]) -> None:
        """``get_filename_component(variable file mode)``: parts of a name are followed."""
        name = arguments[0] if arguments else None
        path, mode = arguments[1:] if len(arguments) == 3 else (None, None)
        value: Value = None
        if path and ";" not in path:
            if mode == "NAME":
                value = os.path.basename(path)
            elif mode == "NAME_WE":
                value = os.path.basename(path).split(".")[0] or None
            elif mode in ("DIRECTORY", "PATH"):
                value = os.path.dirname(path)
            elif mode == "ABSOLUTE":
                value = self.path(path)
        if name:
            self._put(name, value)

    def given_arguments(self, arguments: Sequence[Value]) -> Sequence[Value]:
        """``cmake_parse_arguments(PARSE_ARGV n prefix …)`` with what it stands for: the arguments of the function from ``n`` on."""
        if arguments[:1] != ["PARSE_ARGV"]:
            return arguments
        first, given = arguments[1] if len(arguments) > 1 else None, self.variables.get("ARGV")
        if first is None or not re.fullmatch(r"[0-9]{1,3}", first) or given is None:
            return []
        return [*arguments[2:6], *(each for each in given.split(";")[int(first) :] if each)]

    def string_command(self, arguments: Sequence[Value]) -> None:
        """``string(…)``: replacing text is followed, everything else makes the variable unknown."""
        if arguments[:1] == ["REPLACE"] and len(arguments) >= 5 and arguments[1] and arguments[3] and None not in arguments:
            old, new, name, *parts = (str(each) for each in arguments[1:])
            text = "".join(parts)
            if len(text) + text.count(old) * len(new) <= _LONGEST_VALUE:
                self._put(name, text.replace(old, new))
                return
        self.forget(arguments)

    def glob(self, arguments: Sequence[Value], recurse: bool) -> None:
        """``file(GLOB variable …)`` over the package's own files."""
        if arguments and arguments[0] is not None:
            self._put(arguments[0], self._matching(list(arguments[1:]), recurse))

    def sources_command(self, arguments: Sequence[Value]) -> None:
        """``aux_source_directory(directory variable)``: the sources right in a directory, each with its name as it is given here."""
        directory, variable = arguments if len(arguments) == 2 else (None, None)
        if variable is not None:
            found = None if directory is None else self._matching([f"{directory}/*{ending}" for ending in _SOURCES], recurse=False)
            paths = [f"{directory}/{os.path.basename(each)}" for each in (found or "").split(";") if each]
            self._put(variable, None if found is None else _joined(paths))

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
        self.constants.pop(name, None)
        if name in self.variables or len(self.variables) < _MOST_VARIABLES:
            self.variables[name] = value

    def _value(self, text: str, *, any_way: bool = False) -> Value:
        """``text`` with its variables put in, the innermost first; ``None`` where one of them is not known."""
        unknown = False

        def put_in(match: re.Match[str]) -> str:
            nonlocal unknown
            value = self.variables.get(match[1])
            if value is None and any_way and match[1] in _BUILD_DIRECTORIES:
                value = self.built(self.here if match[1] == "CMAKE_CURRENT_BINARY_DIR" else self.root)
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


def differing(before: dict[str, Value], outcomes: Sequence[dict[str, Value]]) -> dict[str, list[str]]:
    """For the variables in which the ways through an ``if`` differ, what is known of the ways."""
    names = {name for outcome in outcomes for name, value in outcome.items() if name not in before or before[name] != value}
    return {name: [value for each in (before, *outcomes) if (value := each.get(name)) is not None] for name in sorted(names)}


def together(values: Sequence[str]) -> str:
    """One list of all that is in several, each thing once; empty where that is too long."""
    text = ";".join(dict.fromkeys(each for value in values for each in value.split(";") if each))
    return text if len(text) <= _LONGEST_VALUE else ""


def _joined(values: Sequence[Value]) -> Value:
    known = [each for each in values if each is not None]
    text = ";".join(known)
    return None if len(known) < len(values) or len(text) > _LONGEST_VALUE else text


OF_VARIABLES = {
    "list": Scope.list_command,
    "aux_source_directory": Scope.sources_command,
    "get_filename_component": Scope.filename_command,
    "string": Scope.string_command,
}
"""What the commands do that work out the values of variables."""
