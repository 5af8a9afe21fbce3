"""The commands of ament_cmake and of the packages that belong to it: what they build, and what they install where."""

from __future__ import annotations

import os
from collections.abc import Callable, Mapping, Sequence
from itertools import takewhile

from launchlint.late import late
from launchlint.workspace import looking
from launchlint.workspace.cmake import Command
from launchlint.workspace.cmake_blocks import section
from launchlint.workspace.cmake_targets import Component, Install, ScriptsInstall, TargetInstall

TYPE_CHECKING = False
if TYPE_CHECKING:
    from launchlint.workspace.cmake_scope import Scope, Value
    from launchlint.workspace.cmake_targets import CMakeFacts

PREFIX = "/<prefix>"
"""Stands for the directory that a package is installed to."""

PREFIX_VARIABLES: Mapping[str, str] = {
    "CMAKE_INSTALL_PREFIX": PREFIX,
    "CMAKE_INSTALL_DATAROOTDIR": "share",
    "CMAKE_INSTALL_LIBEXECDIR": "libexec",
    "CMAKE_INSTALL_INCLUDEDIR": "include",
}
"""What is set before anything is read (GNUInstallDirs)."""

_HARMLESS = frozenset(
    """
    rosidl_generate_interfaces rosidl_get_typesupport_target rosidl_target_interfaces generate_parameter_module add_launch_test
    add_ros_test add_ros_isolated_launch_test
    qt_wrap_ui qt_wrap_cpp qt_add_resources pybind11_add_module python3_add_library generate_export_header
    configure_build_install_location
    """.split()
)
"""Commands of ROS 2's own packages that make no program and install nothing that a launch file would name."""
_MAKES = late(r"add_(?:\w{1,100}_)?(?:executable|library|gtest|gmock)")
_AUTO_PACKAGE = late(r"(?:\w+_)?ament_auto_package")
_AUTO_WORDS = frozenset(("INSTALL_TO_SHARE", "INSTALL_TO_PATH", "USE_SCOPED_HEADER_INSTALL_DIR"))
_AUTO_TARGET_WORDS = frozenset(("NO_TARGET_LINK_LIBRARIES",))
_SOURCES = (".c", ".cc", ".cpp", ".cxx")
_MOST_FOUND = 500
_MOST_COMPONENTS = 1_000
_REGISTER_WORDS = frozenset(("PLUGIN", "EXECUTABLE", "EXECUTOR", "RESOURCE_INDEX", "NO_UNDEFINED_SYMBOLS"))
_PYTHON_WORDS = frozenset(("VERSION", "PACKAGE_DIR", "SETUP_CFG", "DESTINATION", "SCRIPTS_DESTINATION", "SKIP_COMPILE"))


def ament_command(facts: CMakeFacts, scope: Scope, name: str, arguments: Sequence[Value]) -> bool:
    """Note what the command ``name`` makes and installs; whether that is all there is to it.

    Sources: the macros of ament_cmake_core, ament_cmake_auto, ament_cmake_python, rclcpp_components and pluginlib.
    """
    if name == "ament_auto_add_executable" or name.endswith("_ament_auto_add_executable"):
        facts.automatic += [each for each in arguments[:1] if each]
        return False
    if name == "ament_auto_add_library" or name.endswith("_ament_auto_add_library"):
        facts.automatic_libraries += [each for each in arguments[:1] if each]
        return False
    if _AUTO_PACKAGE.fullmatch(name):
        _auto_package(facts, scope, arguments)
        return True
    if name == "find_package":
        _found(facts, scope, arguments)
        return False
    does = _COMMANDS.get(name)
    if does is not None:
        does(facts, scope, arguments)
        return True
    return name in _HARMLESS or (name.startswith("ament_") and not _MAKES.search(name))


def _found(facts: CMakeFacts, scope: Scope, arguments: Sequence[Value]) -> None:
    """``find_package(package)``: what is linked to use it, under one name."""
    package = arguments[0] if arguments else None
    if package and len(facts.found) < _MOST_FOUND:
        facts.found[package] = None
    for end in ("TARGETS", "LIBRARIES") if package else ():
        if f"{package}_{end}" not in scope.variables:
            scope.assign(f"{package}_{end}", [f"{package}::{package}"])


def _auto_package(facts: CMakeFacts, scope: Scope, arguments: Sequence[Value]) -> None:
    """``ament_auto_package(INSTALL_TO_SHARE directory …)``: the directories, and the programs of ``ament_auto_add_executable``."""
    project = scope.variables.get("PROJECT_NAME")
    for path in section(arguments, "INSTALL_TO_SHARE", _AUTO_WORDS):
        if path is None or project is None:
            facts.installs_reasons.append("ament_auto_package with a directory that is not known")
        else:
            facts.installs.append(Install(scope.path(path), True, f"share/{project}", contents=path.endswith("/")))
    to = "bin" if "INSTALL_TO_PATH" in arguments else f"lib/{project}" if project else None
    facts.target_installs += [TargetInstall(each, to) for each in facts.automatic]
    for each in facts.automatic:
        if each in facts.targets:  # they are linked to all libraries that are made so
            facts.targets[each].libraries += facts.automatic_libraries
    _package(facts, scope, arguments)


def _package(facts: CMakeFacts, scope: Scope, arguments: Sequence[Value]) -> None:
    """``ament_package()``: the manifest is installed."""
    _to_share(facts, scope, "package.xml")


_UNKNOWN_CLASS = "rclcpp_components_register_node(s) with a class that is not known"


def _register_node(facts: CMakeFacts, scope: Scope, arguments: Sequence[Value]) -> None:
    """``rclcpp_components_register_node(library PLUGIN class EXECUTABLE name)``: a program that loads the component."""
    project = scope.variables.get("PROJECT_NAME")
    names = section(arguments, "EXECUTABLE", _REGISTER_WORDS)[:1]
    for plugin in section(arguments, "PLUGIN", _REGISTER_WORDS)[:1]:
        if arguments[0] and plugin and len(facts.components) < _MOST_COMPONENTS:
            facts.components.append(Component(arguments[0], plugin, (names[0] if names else "") or ""))
        else:
            facts.targets_reasons.append(_UNKNOWN_CLASS)
    for name in names:
        if name is None:
            facts.targets_reasons.append("rclcpp_components_register_node with a name that is not known")
        else:
            facts.executables.setdefault(name, "rclcpp_components_register_node")
            facts.target_installs.append(TargetInstall(name, f"lib/{project}" if project else None))


def _register_nodes(facts: CMakeFacts, scope: Scope, arguments: Sequence[Value]) -> None:
    """``rclcpp_components_register_nodes(library class …)``: components without programs of their own."""
    for plugin in takewhile(lambda word: word not in _REGISTER_WORDS, arguments[1:]):
        if arguments[0] and plugin and len(facts.components) < _MOST_COMPONENTS:
            facts.components.append(Component(arguments[0], plugin, ""))
        else:
            facts.targets_reasons.append(_UNKNOWN_CLASS)


def _parameter_library(facts: CMakeFacts, scope: Scope, arguments: Sequence[Value]) -> None:
    """``generate_parameter_library(name file.yaml …)``: a header with the params that the file describes."""
    if len(arguments) > 1 and arguments[0] and arguments[1]:
        facts.parameter_libraries.setdefault(arguments[0], scope.path(arguments[1]))


def auto_sources(scope: Scope, name: str, command: Command) -> Sequence[Value]:
    """What the command ``name`` makes a target of: ``ament_auto_add_executable`` and its like of the files in directories, too."""
    words = scope.expand(command.arguments, any_way=True)[1:]
    if "ament_auto_add_" not in name:
        return words
    found: list[Value] = []
    for at, word in enumerate(words):
        if "DIRECTORY" not in words[:at]:
            found += [] if word == "DIRECTORY" or word in _AUTO_TARGET_WORDS else [word]
        elif word is None:
            found.append(None)
        else:
            directory = scope.path(word)
            found += [os.path.join(directory, name) for name in looking.names(directory) if name.lower().endswith(_SOURCES)]
    return found


def _python_package(facts: CMakeFacts, scope: Scope, arguments: Sequence[Value]) -> None:
    """``ament_python_install_package(package SCRIPTS_DESTINATION directory)``: the programs that ``setup.cfg`` names."""
    destination = section(arguments, "SCRIPTS_DESTINATION", _PYTHON_WORDS)[:1]
    if destination:
        given = section(arguments, "SETUP_CFG", _PYTHON_WORDS)[:1]
        directory = section(arguments, "PACKAGE_DIR", _PYTHON_WORDS)[:1] or arguments[:1]
        file = given[0] if given else f"{directory[0]}/../setup.cfg" if directory and directory[0] else None
        if file is None:
            facts.targets_reasons.append("ament_python_install_package with a package that is not known")
        else:
            facts.script_installs.append(ScriptsInstall(scope.path(file), destination[0]))


def _plugins(facts: CMakeFacts, scope: Scope, arguments: Sequence[Value]) -> None:
    """``pluginlib_export_plugin_description_file(category file)``: the file goes to the same path below ``share``."""
    if len(arguments) > 1 and arguments[1]:
        _to_share(facts, scope, arguments[1])


def _to_share(facts: CMakeFacts, scope: Scope, file: str) -> None:
    project = scope.variables.get("PROJECT_NAME")
    facts.installs.append(
        Install(scope.path(file), False, None if project is None else os.path.join(f"share/{project}", os.path.dirname(file)))
    )


_COMMANDS: Mapping[str, Callable[[CMakeFacts, Scope, Sequence[Value]], None]] = {
    "ament_package": _package,
    "ament_python_install_package": _python_package,
    "pluginlib_export_plugin_description_file": _plugins,
    "rclcpp_components_register_node": _register_node,
    "rclcpp_components_register_nodes": _register_nodes,
    "generate_parameter_library": _parameter_library,
}
