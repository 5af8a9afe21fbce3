"""The programs of a package of ROS 2 that ament builds."""

from __future__ import annotations

import re
from collections.abc import Mapping

from launchlint.extract.assembly import cpp_sources, has_main
from launchlint.extract.package_reader import PackageReader
from launchlint.extract.task import Skipped
from launchlint.workspace.cmake_targets import Component, Target

_REGISTERED = re.compile(r"^[ \t]*RCLCPP_COMPONENTS_REGISTER_NODE\s*\(\s*(?:::)?([\w:]{1,300})\s*\)", re.MULTILINE)
_OF_TESTS = ("gtest", "gmock")


class AmentPackage(PackageReader):
    """Executables and components."""

    python = "rclpy"

    @property
    def complete(self) -> bool:
        """Whether all components are known, and there are some."""
        return bool(self._components) and not self.cmake.targets_reasons and not self.cmake.executables_reasons

    def read(self) -> None:
        """Fill ``tasks`` and ``skipped``."""
        for target_name, target in sorted(self.cmake.targets.items()):
            if self._is_program(target):
                self._executable(target_name, target)
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
