"""The programs of a package of ROS 2 that ament builds."""

from __future__ import annotations

import os
import re
from collections.abc import Mapping

from launchlint.extract.assembly import Workspace, cpp_sources, has_main
from launchlint.extract.origin import Origin
from launchlint.extract.package_reader import PackageReader
from launchlint.extract.python.ros2.modules import AmentModules
from launchlint.extract.task import Skipped
from launchlint.workspace import looking
from launchlint.workspace.ament.installed import Installed, Program
from launchlint.workspace.ament.reading import installed_by_cmake, installed_by_python
from launchlint.workspace.cmake_targets import Component, Target
from launchlint.workspace.package import Package

_REGISTERED = re.compile(r"^[ \t]*RCLCPP_COMPONENTS_REGISTER_NODE\s*\(\s*(?:::)?([\w:]{1,300})\s*\)", re.MULTILINE)
_OF_TESTS = ("gtest", "gmock")
_OF_PYTHON = ("setup.py", "console_scripts", "file")
_NO_PROGRAMS = (".launch.py", ".yaml", ".xml", ".md", ".txt")
_LAUNCH = re.compile(r"^def generate_launch_description\b", re.MULTILINE)


class AmentPackage(PackageReader):
    """Executables and components."""

    python = "rclpy"

    def __init__(self, package: Package, origin: Origin, workspace: Workspace) -> None:
        super().__init__(package, origin, workspace)
        self._read_installed: tuple[Installed, looking.Looked] | None = None

    @property
    def complete(self) -> bool:
        """Whether all components are known, and there are some."""
        return bool(self._components) and not self.cmake.targets_reasons and not self.cmake.executables_reasons

    def read(self) -> None:
        """Fill ``tasks`` and ``skipped``."""
        for target_name, target in sorted(self.cmake.targets.items()):
            if self._is_program(target):
                self._executable(target_name, target)
        for name, program in self._python.items():
            self._python_program(name, program)
        for reason in self._more_of_python:
            shown = self._shown(self.package.directory)
            self.skipped.append(Skipped(self.package.name, "", shown, f"it may have more programs: {reason}"))
        for each in self._components.values():
            self._component(each)
            if each.executable:
                self._runner(each)

    def find(self, table: str, name: str) -> None:
        """As said there."""
        if table == "components":
            found = self._components.get(name)
            if found is not None:
                self._component(found)
            return
        for target_name, target in sorted(self.cmake.targets.items()):
            if target.output == name and self._is_program(target):
                self._executable(target_name, target)
                return
        for each in self._components.values():
            if each.executable == name:
                self._runner(each)
                return
        program = self._python.get(name)
        if program is not None:
            self._python_program(name, program)

    @property
    def _python(self) -> Mapping[str, Program]:
        """The programs that no compiler makes, by name: entry points, and files that are installed to be run."""
        there = f"lib/{self.package.name}"
        found: dict[str, Program] = {}
        for each in self._installed.programs:
            before = found.get(each.name)
            if each.how in _OF_PYTHON and (before is None or (each.destination == there and before.destination != there)):
                found[each.name] = each
        return dict(sorted(found.items()))

    @property
    def _more_of_python(self) -> tuple[str, ...]:
        """Why ``setup.py`` may install programs that are not found; that of other files counts only where there are none."""
        found = self._installed
        return tuple(each for each in found.program_reasons if self._is_of_python and (each not in found.reasons or not found.programs))

    @property
    def _is_of_python(self) -> bool:
        return self.package.manifest is not None and self.package.manifest.build_types == ("ament_python",)

    @property
    def _installed(self) -> Installed:
        if self._read_installed is None:
            self._read_installed = looking.watched(
                lambda: installed_by_python(self.package) if self._is_of_python else installed_by_cmake(self.package, self.cmake)
            )
        found, looked = self._read_installed
        looking.note(looked)
        return found

    def _python_program(self, name: str, program: Program) -> None:
        path = next((each for each in program.sources if os.path.isfile(each)), None) or self._module(program.entry)
        if path is None or not self.workspace.may_read(path, self.origin.root):
            what = program.entry.partition(":")[0]
            reason = f"the module {what} was not found" if what else "its source file is not here"
            self.skipped.append(Skipped(self.package.name, name, self._shown(self.package.directory), reason))
        elif program.entry:
            self.tasks.append(self._task("executables", name, self.python, (path,))._replace(entry=program.entry))
        elif not path.endswith(_NO_PROGRAMS) and not _LAUNCH.search(self.workspace.files.text(path)):
            self._script(name, path)

    def _module(self, entry: str) -> str | None:
        """The module of an entry point that does not lie as its name says."""
        module, directory = entry.partition(":")[0], self.package.directory
        return AmentModules({directory: self.package.name}).find(module, directory, directory) if module else None

    @property
    def _components(self) -> Mapping[str, Component]:
        """The components by class: those that are registered in CMake, and those that only their source registers."""
        found: dict[str, Component] = {}
        for each in self.cmake.components:
            before = found.get(each.plugin)
            if before is None or (each.executable and not before.executable):
                found[each.plugin] = each
        for name, target in sorted(self.cmake.targets.items()):
            for path in cpp_sources(target) if target.is_library else ():
                for plugin in _REGISTERED.findall(self.workspace.files.text(path)):
                    found.setdefault(plugin, Component(name, plugin, ""))
        return dict(sorted(found.items()))

    def _is_program(self, target: Target) -> bool:
        if target.assumed:
            return has_main(target)
        how = self.cmake.executables.get(target.output, "")
        return not target.is_library and not any(each in how for each in _OF_TESTS)

    def _executable(self, name: str, target: Target) -> None:
        self._cpp("executables", target.output, "rclcpp", target, "", target.output)

    def _component(self, component: Component) -> None:
        self._of_library("components", component.plugin, "component", component)

    def _runner(self, component: Component) -> None:
        """The program that runs a component alone."""
        self._of_library("executables", component.executable, "rclcpp", component)

    def _of_library(self, kind: str, name: str, client: str, component: Component) -> None:
        target = self.cmake.targets.get(component.library)
        if target is None:
            reason = f"no target of its CMakeLists.txt makes the library {component.library[:200]}"
            self.skipped.append(Skipped(self.package.name, name, self._shown(self.package.directory), reason))
            return
        self._cpp(kind, name, client, target, component.plugin, name)
