"""What a CMakeLists.txt builds and installs, read without running CMake.

Each branch of an ``if`` is taken that some configuration takes: the names found are those of all together. What cannot be known here (a
variable set elsewhere, a macro of another package, a generator expression) is never guessed: it is noted as a reason why the list of
executables, or that of installed files, may lack something.
"""

from __future__ import annotations

import os
from collections.abc import Callable, Sequence

from launchlint.late import late
from launchlint.workspace.ament.cmake import PREFIX_VARIABLES, ament_command, auto_sources
from launchlint.workspace.cmake import CMakeError, Command, commands
from launchlint.workspace.cmake_blocks import block_end, parsed, section, sources_and_rest
from launchlint.workspace.cmake_conditions import truth
from launchlint.workspace.cmake_exports import Exported, within
from launchlint.workspace.cmake_installs import install, install_programs, programs_first
from launchlint.workspace.cmake_loops import items, zipped
from launchlint.workspace.cmake_made import MAKING, RUNNING, runs_another_build
from launchlint.workspace.cmake_scope import OF_VARIABLES, Scope, Value, together
from launchlint.workspace.cmake_targets import CMakeFacts, Generated, Target
from launchlint.workspace.cmake_words import ASSIGNING, CATKIN_WORDS, COMPUTING, COMPUTING_FIRST, HARMLESS, HARMLESS_PREFIXES
from launchlint.workspace.looking import is_file, read_bytes

CMAKE_FILE = "CMakeLists.txt"

# Bounds against hostile files.
_MOST_STEPS = 5_000
_DEEPEST_FILE = 8
_DEEPEST_BLOCK = 40
_LONGEST_NAME = 100
_MOST_TARGETS = 2_000
_MOST_SOURCES = 2_000
_MOST_GENERATED = 300
_MOST_ARGUMENTS = 20

_TARGET = late(r"(?:\w{1,100}_)?add_(?:\w{1,100}_)?executable(?:_with_gtest)?")
_TEST_TARGET = late(r"(?:\w{1,100}_)?add_(?:\w{1,100}_)?(?:gtest|gmock)(?:_test)?|catch_add_(?:rostest_node|test)")
_LIBRARY = late(r"(?:\w{1,100}_)?add_(?:\w{1,100}_)?library")
_MAKES_TARGETS = late(r"add_(?:\w{1,100}_)?(?:executable|library)|target_(?:link|sources)")
_WRAPPER = late(r"(?:\w{1,100}_)?(?:binary|executable|exe|node|program)(?:_\w{1,100})?")
_NO_WRAPPER = late(r"test|library|plugin|nodelet|install")
_TARGET_WORDS = frozenset(
    """SHARED STATIC MODULE OBJECT INTERFACE PUBLIC PRIVATE EXCLUDE_FROM_ALL WIN32 MACOSX_BUNDLE LINK_PUBLIC LINK_PRIVATE
    LINK_INTERFACE_LIBRARIES
    debug optimized general BEFORE AFTER SYSTEM UNKNOWN OPTIONS CUDA_ARCHITECTURES""".split()
)
_TOOLING = late(r"coverage|clang|cppcheck|doxygen|sphinx")


def read_cmake(
    directory: str,
    files: Callable[[], Sequence[str]],
    exported: Callable[[str], Exported | None] = lambda name: None,
    *,
    ament: bool = False,
    depended: Sequence[str] = (),
) -> CMakeFacts:
    """Read ``CMakeLists.txt`` of the package at ``directory`` and the files it includes from the package. Never raises.

    ``files`` gives the package's files as paths relative to it with ``/``, for ``file(GLOB)``; ``exported`` the commands that a package
    exports to this one, which finds it. With ``ament`` the commands of ament_cmake are known, and macros and functions of the package are
    gone through for what they install; commands of the packages in ``depended`` need no ``find_package``, since ament_cmake_auto finds all
    of those.
    """
    reader = _Reader(os.path.abspath(directory), files, exported, ament)
    reader.depended = depended
    reader.read(os.path.join(reader.scope.root, CMAKE_FILE), 0)
    reader.find_generated()
    for target, name in reader.renamed.items():
        if target in reader.facts.targets:
            reader.facts.targets[target].output = name
        if target in reader.facts.executables:
            how = reader.facts.executables.pop(target)
            reader.facts.executables.setdefault(name, how)
    return reader.facts


class _Reader:
    """One run over the CMake files of a package."""

    def __init__(self, root: str, files: Callable[[], Sequence[str]], exported: Callable[[str], Exported | None], ament: bool) -> None:
        self.scope = Scope(root, files, PREFIX_VARIABLES if ament else {})
        self._ament = ament
        self.facts = CMakeFacts()
        self.macros: dict[str, Sequence[Command]] = {}
        self.parameters: dict[str, tuple[str, ...]] = {}
        self.renamed: dict[str, str] = {}
        self.generated: dict[str, Generated] = {}
        self.steps = 0
        self._blocks = 0
        self._file_shown = CMAKE_FILE
        self._exported = exported
        self.depended: Sequence[str] = ()
        self._outside: list[str] = []

    # -- reading ------------------------------------------------------------------------------------------------------

    def read(self, path: str, depth: int) -> None:
        """Evaluate one file."""
        if not self._inside(path):
            self._unknown("a file outside the package is not read")
            return
        shown = os.path.relpath(path, self.scope.root)
        if depth > _DEEPEST_FILE:
            self._unknown(f"{shown} is not read")
            return
        try:
            listed = commands(read_bytes(path).decode("utf-8", "replace").removeprefix("\ufeff"))
        except OSError as error:
            self._unknown(f"{shown} cannot be read: {error.strerror or error}")
            return
        except CMakeError as error:
            self._unknown(f"{shown}, {error}")
            return
        outer, self._file_shown = self._file_shown, shown
        self.run(listed, depth)
        self._file_shown = outer

    def run(self, listed: Sequence[Command], depth: int) -> None:
        """Evaluate commands in order."""
        position = 0
        while position < len(listed):
            command = listed[position]
            self.steps += 1
            if self.steps > _MOST_STEPS:
                self._unknown("too much to evaluate")
                return
            if command.name in ("foreach", "while", "function", "macro", "if"):
                end = block_end(listed, position)
                self._block(command, listed[position + 1 : end], depth)
                position = end + 1
                continue
            self._command(command, depth)
            position += 1

    def _block(self, opening: Command, body: Sequence[Command], depth: int) -> None:
        if opening.name in ("function", "macro"):
            if opening.arguments:
                name = opening.arguments[0].text.lower()
                self.macros[name] = body
                self.parameters[name] = tuple(each.text for each in opening.arguments[1:])
            return
        if self._blocks >= _DEEPEST_BLOCK:
            self._unknown("blocks are nested too deeply")
            return
        self._blocks += 1
        if opening.name == "if":
            self._branches(opening, body, depth)
        elif opening.name == "foreach":
            self._foreach(opening, body, depth)
        else:
            self._forget_assigned(body)
            self.run(body, depth)
        self._blocks -= 1

    def _branches(self, opening: Command, body: Sequence[Command], depth: int) -> None:
        before, outcomes, holds = self.scope.variables, list[dict[str, Value]](), truth(opening, self.scope.constants)
        start, level, skip, decided = 0, 0, holds is False, holds is True
        for position, command in enumerate([*body, Command("endif", (), 0)]):
            if command.name == "if":
                level += 1
            elif command.name == "endif" and level:
                level -= 1
            elif level == 0 and command.name in ("elseif", "else", "endif"):
                if not skip:
                    self.scope.variables = dict(before)
                    self.run(body[start:position], depth)
                    outcomes.append(self.scope.variables)
                holds = truth(command, self.scope.constants)
                start, skip, decided = position + 1, decided or holds is False, decided or holds is True
        self.scope.branch(before, outcomes, exhaustive=decided)

    def _foreach(self, opening: Command, body: Sequence[Command], depth: int) -> None:
        arguments = self.scope.expand(opening.arguments)
        if not arguments or arguments[0] is None:
            self._unknown("foreach with a variable that is not known")
            return
        turns = zipped(self.scope, arguments)
        if turns is None:
            words = self.scope.expand(opening.arguments, any_way=True)[1:] if None in arguments else arguments[1:]
            found = dict.fromkeys([*items(self.scope, words), *items(self.scope, arguments[1:])])
            turns = [{arguments[0]: item} for item in found]
        outer = {name: self.scope.variables.get(name) for name in (turns[0] if turns else arguments[:1]) if name is not None}
        for turn in turns:
            self.steps += 1
            if self.steps > _MOST_STEPS:
                break
            for name, value in turn.items():
                self.scope.assign(name, [value])
            self.run(body, depth)
        for name, value in outer.items():
            self.scope.assign(name, [value])

    # -- commands -----------------------------------------------------------------------------------------------------

    def _command(self, command: Command, depth: int) -> None:
        name = command.name
        arguments = self.scope.expand(command.arguments)
        first = arguments[0] if arguments else None
        if len(name) > _LONGEST_NAME:
            self._unknown("a command with a very long name")
            return
        if name in MAKING:
            self.facts.made.note(self.scope, command, self._file_shown)
        if name in RUNNING and runs_another_build(self.scope.with_gaps(command.arguments)):
            self._generated(name, [None])
        if self._ament and ament_command(self.facts, self.scope, name, arguments):
            return
        if name in self.macros and (self._ament or not (_TARGET.fullmatch(name) or _LIBRARY.fullmatch(name))):
            self._call(name, command, depth)  # also an add_…_executable of its own, which says what else it does
        elif _TARGET.fullmatch(name) or _TEST_TARGET.fullmatch(name):
            if arguments[1:2] not in (["IMPORTED"], ["ALIAS"]):
                self._executable(first, name)
                self._target(first, auto_sources(self.scope, name, command), is_library=False)
        elif _LIBRARY.fullmatch(name):
            if arguments[1:2] not in (["IMPORTED"], ["ALIAS"]) and "IMPORTED" not in arguments[1:3]:
                self._target(first, auto_sources(self.scope, name, command), is_library=True)
        elif name in ("target_link_libraries", "target_sources", "rosbuild_link_libraries"):
            words = self.scope.expand(command.arguments, any_way=True)[1:]
            self._target_parts(first, words, sources=name == "target_sources")
        elif name in ("include_directories", "target_include_directories"):
            self._include_directories(arguments if name == "include_directories" else arguments[1:])
        elif name == "catkin_package":
            self._include_directories(section(arguments, "INCLUDE_DIRS", CATKIN_WORDS))
        elif name == "find_package":
            self._find(arguments)
        elif name == "project":
            self.scope.project(first)
            self.facts.project = self.facts.project or first or ""
        elif name == "set" and first is not None:
            self.scope.assign(first, arguments[1:], settled=not (depth or self._blocks))
            if None in arguments:
                self.scope.assign_any(first, self.scope.expand(command.arguments, any_way=True)[1:])
                self.scope.assign_gaps(first, command.arguments[1:])
        elif name == "unset" and first is not None:
            self.scope.assign(first, [])
        elif name in OF_VARIABLES:
            OF_VARIABLES[name](self.scope, arguments)
        elif name == "file":
            self._file(arguments)
        elif name == "cmake_parse_arguments":
            for variable, values in parsed(self.scope.given_arguments(arguments)).items():
                self.scope.assign(variable, values)
        elif name in COMPUTING or name in COMPUTING_FIRST:
            self.scope.forget(arguments if name in COMPUTING else arguments[:1])
        elif name == "set_target_properties":
            self._properties(arguments)
        elif name == "install":
            install(self.facts, self.scope, arguments)
        elif name == "catkin_install_python":
            install_programs(self.facts, self.scope, name, programs_first(arguments))
        elif name == "cs_install_scripts":
            install_programs(self.facts, self.scope, name, ["PROGRAMS", *arguments])
        elif name == "configure_file":
            self._generated(name, arguments[1:2])
            self._configured(command)
        elif name == "add_custom_command":
            self._generated(name, section(arguments, "OUTPUT") or [None])
        elif name == "add_custom_target":
            self._generated(name, [None] if "COMMAND" in arguments else [])
        elif name == "add_subdirectory":
            self._subdirectory(first, depth)
        elif name == "include":
            self._include(first, depth)
        elif name in HARMLESS or name.startswith(HARMLESS_PREFIXES) or _TOOLING.search(name):
            return
        elif self.depended:
            depended, self.depended = self.depended, ()
            self._find(depended)
            self._command(command, depth)
        else:
            self._unknown(f"the command {name} (line {command.line}) is not known")
            self.facts.made.note(self.scope, command, self._file_shown)
            if _WRAPPER.fullmatch(name) and not _NO_WRAPPER.search(name):
                self._wrapped(self.scope.expand(command.arguments, any_way=True))

    def _executable(self, name: Value, how: str) -> None:
        if name is None or "$<" in name:
            self.facts.executables_reasons.append(f"{how} with a name that is not known")
        elif name:
            self.facts.executables.setdefault(name, how)

    def _target(self, name: Value, words: Sequence[Value], *, is_library: bool) -> None:
        """``add_executable`` and ``add_library``: what it is made of; where both branches of an ``if`` say it, all of that."""
        if name is None or "$<" in name or len(self.facts.targets) >= _MOST_TARGETS:
            return
        target = self.facts.targets.setdefault(name, Target(name, is_library))
        for word in words:
            if word is None or "$<" in word:
                target.complete = False
                continue
            for each in word.split(";"):  # "${SOURCES}" in quotes is one argument, and a list all the same
                if each and each not in _TARGET_WORDS and len(target.sources) < _MOST_SOURCES:
                    path = self.scope.path(each)
                    if path not in target.sources:
                        target.sources.append(path)

    def _wrapped(self, words: Sequence[Value]) -> None:
        """A command that is not known, but called like one that makes an executable: ``x_binary(name SRCS a.cc)``."""
        name = words[0] if words else None
        sources, rest = sources_and_rest(words[1:])
        if name and sources and name not in self.facts.targets and len(self.facts.targets) < _MOST_TARGETS:
            self._target(name, sources, is_library=False)
            target = self.facts.targets.get(name)
            if target is not None:
                target.assumed, target.complete = True, False
                target.libraries += rest[:_MOST_SOURCES]

    def _configured(self, command: Command) -> None:
        """``configure_file(template output …)``: remembered, since the output may be a source."""
        words = self.scope.expand(command.arguments, any_way=True)
        output = words[1] if len(words) > 1 else None
        if output is None or "$<" in output or len(self.generated) >= _MOST_GENERATED:
            return
        template = self.scope.template(command.arguments[0])
        if template is not None and (self._inside(template) or any(within(template, each) for each in self._outside)):
            path = os.path.normpath(os.path.join(self.scope.built(self.scope.here), output))
            self.generated[path] = Generated(template, dict(self.scope.variables), "@ONLY" in words, "COPYONLY" in words)

    def _find(self, words: Sequence[Value]) -> None:
        """``find_package(catkin COMPONENTS …)``: the commands that those packages export, with the variables that say where they are."""
        for word in words:
            given = self._exported(word) if word else None
            if given is not None and given.commands and given.directory not in self._outside and given.directory != self.scope.root:
                self._outside.append(given.directory)
                for name, (body, parameters) in given.commands.items():
                    self.macros.setdefault(name, body)
                    self.parameters.setdefault(name, parameters)
                for variable, path in (("SOURCE_DIR", ""), ("SOURCE_PREFIX", ""), ("DIR", "/cmake"), ("EXTRAS_DIR", "/cmake")):
                    self.scope.assign(f"{word}_{variable}", [given.directory + path])

    def find_generated(self) -> None:
        """Note at each target which of its sources are made of a template."""
        if self.generated:
            for target in self.facts.targets.values():
                for source in target.sources:
                    made = self.generated.get(source) or self.generated.get(self.scope.built(source))
                    if made is not None and not is_file(source):
                        target.generated[source] = made

    def _target_parts(self, name: Value, words: Sequence[Value], *, sources: bool) -> None:
        target = self.facts.targets.get(name or "")
        if target is None:
            return
        if sources:
            self._target(name, words, is_library=target.is_library)
            return
        for word in words:
            known = word is None or word in _TARGET_WORDS or word in target.libraries
            if word is not None and not known and len(target.libraries) < _MOST_SOURCES:
                target.libraries.append(word)

    def _include_directories(self, words: Sequence[Value]) -> None:
        for given in words:
            word = given.removeprefix("$<BUILD_INTERFACE:").removesuffix(">") if given else ""
            if word and word not in _TARGET_WORDS and "$<" not in word and len(self.facts.include_directories) < _MOST_SOURCES:
                path = self.scope.path(word)
                if path == self.scope.root or self._inside(path):
                    self.facts.include_directories[path] = None

    def _file(self, arguments: Sequence[Value]) -> None:
        action = arguments[0] if arguments else None
        if action in ("GLOB", "GLOB_RECURSE"):
            self.scope.glob(arguments[1:], action == "GLOB_RECURSE")
        elif action in ("WRITE", "APPEND"):
            self._generated(f"file({action})", arguments[1:2])
        elif action in ("GENERATE", "COPY", "CREATE_LINK", "DOWNLOAD", "INSTALL", "RENAME", None):
            self._generated(f"file({action or ''})", [None])
        else:
            self.scope.forget(arguments[1:])

    def _properties(self, arguments: Sequence[Value]) -> None:
        if "PROPERTIES" not in arguments:
            return
        at = arguments.index("PROPERTIES")
        pairs = dict(zip(arguments[at + 1 :: 2], arguments[at + 2 :: 2], strict=False))
        if "OUTPUT_NAME" in pairs:
            name = pairs["OUTPUT_NAME"]
            for target in arguments[:at]:
                if target is None or name is None or "$<" in name:
                    self.facts.executables_reasons.append("OUTPUT_NAME is not known")
                    self.facts.targets_reasons.append("OUTPUT_NAME is not known")
                else:
                    self.renamed[target] = name

    def _generated(self, how: str, outputs: Sequence[Value]) -> None:
        """Files made by the build: any of them may be a script."""
        for output in outputs:
            if output is None:
                self.facts.executables_reasons.append(f"{how} makes a file whose name is not known")
            elif output:
                self.facts.executables.setdefault(os.path.basename(output), how)

    # -- other files --------------------------------------------------------------------------------------------------

    def _subdirectory(self, name: Value, depth: int) -> None:
        if name is None:
            self._unknown("add_subdirectory with a directory that is not known")
            return
        outer = self.scope.variables
        directory = self.scope.path(name)
        self.scope.variables = {**outer, "CMAKE_CURRENT_SOURCE_DIR": directory, "CMAKE_CURRENT_LIST_DIR": directory}
        self.read(os.path.join(directory, CMAKE_FILE), depth + 1)
        self.scope.variables = outer

    def _include(self, name: Value, depth: int) -> None:
        if name is None:
            self._unknown("include of a file that is not known")
        elif "/" in name and not name.endswith((".cmake", CMAKE_FILE)):
            self._unknown(f"{name} is not read, since it is not called *.cmake")  # the result cache knows CMake files by their names
        elif "/" in name or name.endswith(".cmake"):
            self.read(self.scope.path(name), depth + 1)

    def _call(self, name: str, command: Command, depth: int) -> None:
        """A macro or function of this package: only targets and files are noted of what it does, and whether it makes something."""
        if self._ament:
            self._through(name, command, depth)
            self._forget_assigned(self.macros[name])
            return
        self._targets_of(name, command, depth)
        pending, seen = [name], {name}
        while pending:
            called = pending.pop()
            for inner in self.macros[called]:
                if inner.name in self.macros:
                    if inner.name not in seen:
                        seen.add(inner.name)
                        pending.append(inner.name)
                elif inner.name not in HARMLESS:
                    self._unknown(f"the command {name} (line {command.line}) uses {inner.name}")
                    return
            self._forget_assigned(self.macros[called])

    def _targets_of(self, name: str, command: Command, depth: int) -> None:
        """Go through a macro or function with its arguments, for the targets and the files it makes alone."""
        if not any(self._makes(inner.name) for inner in self.macros[name]):
            return
        facts = self.facts
        self.facts = CMakeFacts()
        self.facts.targets, self.facts.made = facts.targets, facts.made
        after = self._through(name, command, depth)
        self.facts = facts
        for each, value in after.items():
            if value and self.scope.variables.get(each) != value:
                self.scope.unions[each] = together([self.scope.unions.get(each, ""), value])

    def _through(self, name: str, command: Command, depth: int) -> dict[str, Value]:
        """Go through a macro or function with its arguments; the variables as they are at its end, its parameters left out."""
        if self._blocks >= _DEEPEST_BLOCK:
            self._unknown("calls are nested too deeply")
            return {}
        scope = self.scope.variables
        arguments = self.scope.expand(command.arguments, any_way=True)
        parameters = self.parameters.get(name, ())
        self.scope.variables = dict(scope)
        for parameter, value in zip(parameters, arguments, strict=False):
            self.scope.assign(parameter, [value])
        self.scope.assign("ARGN", arguments[len(parameters) :])
        self.scope.assign("ARGV", arguments)
        numbered = {f"ARGV{number}": value for number, value in enumerate(arguments[:_MOST_ARGUMENTS])}
        for variable, value in numbered.items():
            self.scope.assign(variable, [value])
        self._blocks += 1
        self.run(self.macros[name], depth)
        self._blocks -= 1
        after, self.scope.variables = self.scope.variables, scope
        known = {*parameters, "ARGN", "ARGV", *numbered}
        return {each: value for each, value in after.items() if each not in known}

    def _makes(self, name: str) -> bool:
        return name in MAKING or name in self.macros or _MAKES_TARGETS.search(name) is not None

    def _forget_assigned(self, listed: Sequence[Command]) -> None:
        """Variables that these commands may set, some number of times, are unknown afterwards."""
        for command in listed:
            if command.name in ASSIGNING:
                self.scope.forget([each.text for each in command.arguments])

    def _inside(self, path: str) -> bool:
        return within(path, self.scope.root)

    def _unknown(self, reason: str) -> None:
        self.facts.executables_reasons.append(reason)
        self.facts.installs_reasons.append(reason)
