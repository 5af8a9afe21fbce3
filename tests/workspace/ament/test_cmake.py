"""What a package built with ament_cmake installs: under which share path, and as which program."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from pathlib import Path

import pytest

from launchlint.workspace.ament.installed import Installed
from launchlint.workspace.ament.reading import InstalledIndex
from launchlint.workspace.packages import Packages

MANIFEST = '<package format="3"><name>rover</name><export><build_type>{}</build_type></export></package>'
Make = Callable[[Mapping[str, str | None]], Installed]
FILES = {
    "launch/a.launch.xml": "",
    "launch/deep/b.launch.py": "",
    "config/c.yaml": "",
    "src/d.cpp": "",
    "scripts/e.py": "+x #!/usr/bin/env python3",
}


def _made(install: Make, text: str, files: Mapping[str, str | None] | None = None) -> Installed:
    return install({"CMakeLists.txt": f"project(rover)\n{text}\nament_package()\n", **(FILES if files is None else files)})


SHARES: dict[str, tuple[str, dict[str, str]]] = {
    "a directory": (
        "install(DIRECTORY launch DESTINATION share/${PROJECT_NAME})",
        {"launch/a.launch.xml": "launch/a.launch.xml", "launch/deep/b.launch.py": "launch/deep/b.launch.py"},
    ),
    "what is in a directory": (
        "install(DIRECTORY launch/ DESTINATION share/${PROJECT_NAME})",
        {"a.launch.xml": "launch/a.launch.xml", "deep/b.launch.py": "launch/deep/b.launch.py"},
    ),
    "a file": ("install(FILES launch/a.launch.xml DESTINATION share/rover/x)", {"x/a.launch.xml": "launch/a.launch.xml"}),
    "a file with another name": (
        "install(FILES launch/a.launch.xml DESTINATION share/rover RENAME z.launch.xml)",
        {"z.launch.xml": "launch/a.launch.xml"},
    ),
    "a pattern": (
        'install(DIRECTORY launch DESTINATION share/rover FILES_MATCHING PATTERN "*.xml")',
        {"launch/a.launch.xml": "launch/a.launch.xml"},
    ),
    "what is left out": (
        "install(DIRECTORY launch DESTINATION share/rover PATTERN a.launch.xml EXCLUDE)",
        {"launch/deep/b.launch.py": "launch/deep/b.launch.py"},
    ),
    "variables, a loop and the prefix": (
        (
            "set(to ${CMAKE_INSTALL_PREFIX}/share/${PROJECT_NAME})\nforeach(each launch config)\n"
            "install(DIRECTORY ${each}/ DESTINATION ${to}/${each})\nendforeach()"
        ),
        {
            "launch/a.launch.xml": "launch/a.launch.xml",
            "launch/deep/b.launch.py": "launch/deep/b.launch.py",
            "config/c.yaml": "config/c.yaml",
        },
    ),
    "globs": (
        "file(GLOB found RELATIVE ${CMAKE_CURRENT_SOURCE_DIR} config/*.yaml)\ninstall(FILES ${found} DESTINATION share/rover/config)",
        {"config/c.yaml": "config/c.yaml"},
    ),
    "ament_auto_package": ("ament_auto_package(INSTALL_TO_SHARE config)", {"config/c.yaml": "config/c.yaml"}),
    "a function of its own": (
        "function(to_share what)\ninstall(DIRECTORY ${what} DESTINATION share/${PROJECT_NAME})\nendfunction()\nto_share(config)",
        {"config/c.yaml": "config/c.yaml"},
    ),
    "plugin descriptions": (
        "pluginlib_export_plugin_description_file(nav2_core config/c.yaml)",
        {"config/c.yaml": "config/c.yaml"},
    ),
}


@pytest.mark.parametrize("case", SHARES)
def test_share_paths(case: str, install: Make, tmp_path: Path) -> None:
    text, expected = SHARES[case]
    found = _made(install, text)
    assert found.reasons == ()
    shares = {share: file for file in FILES for share in found.share_paths(str(tmp_path / file))}
    assert shares == expected
    assert {share: found.source_of(share) for share in expected} == {share: str(tmp_path / file) for share, file in expected.items()}
    assert [file for file in FILES if not found.lacks(file)] == [file for file in FILES if file in expected]
    assert not found.lacks("package.xml")


def test_a_directory_above_one_that_is_installed_to_is_there(install: Make) -> None:
    found = _made(install, "install(FILES config/c.yaml DESTINATION share/rover/config/deep)")
    assert not found.lacks("config")
    assert found.lacks("launch")


@pytest.mark.parametrize(
    "text",
    [
        "some_command()",
        "include(${somewhere}/install.cmake)",
        "install(CODE message())",
        "install(DIRECTORY ${unknown} DESTINATION share/rover)",
        "install(DIRECTORY ${unknown} DESTINATION share)",
        "install(DIRECTORY launch DESTINATION ${unknown})",
        "install(FILES config/c.yaml DESTINATION share/rover RENAME ${unknown})",
        "ament_auto_package(INSTALL_TO_SHARE ${unknown})",
        "install(DIRECTORY launch DESTINATION share/rover REGEX b.*)",
    ],
)
def test_what_is_not_understood_is_never_said_to_be_missing(text: str, install: Make) -> None:
    assert not _made(install, text).lacks("config/c.yaml")


def test_what_is_not_known_of_another_directory_does_not_matter(install: Make) -> None:
    found = _made(install, "install(DIRECTORY ${unknown}/ DESTINATION include)\ninstall(FILES ${all} DESTINATION share/cmake)")
    assert found.lacks("config/c.yaml")
    assert found.lacks_program("driver")


PROGRAMS: dict[str, tuple[str, dict[str, tuple[str | None, str]]]] = {
    "a target": (
        "add_executable(driver src/d.cpp)\ninstall(TARGETS driver DESTINATION lib/${PROJECT_NAME})",
        {"driver": ("lib/rover", "src/d.cpp")},
    ),
    "by kind": (
        (
            "add_executable(driver src/d.cpp)\n"
            "install(TARGETS driver EXPORT x ARCHIVE DESTINATION lib LIBRARY DESTINATION lib RUNTIME DESTINATION lib/${PROJECT_NAME})"
        ),
        {"driver": ("lib/rover", "src/d.cpp")},
    ),
    "the key word twice": (
        "add_executable(driver src/d.cpp)\ninstall(TARGETS driver DESTINATION DESTINATION lib/${PROJECT_NAME})",
        {"driver": ("lib/rover", "src/d.cpp")},
    ),
    "without a destination": ("add_executable(driver src/d.cpp)\ninstall(TARGETS driver)", {"driver": ("bin", "src/d.cpp")}),
    "for libraries only": (
        "add_executable(driver src/d.cpp)\ninstall(TARGETS driver LIBRARY DESTINATION lib/${PROJECT_NAME})",
        {"driver": ("bin", "src/d.cpp")},
    ),
    "not installed": ("add_executable(driver src/d.cpp)", {"driver": ("", "src/d.cpp")}),
    "under another name": (
        (
            "add_executable(driver src/d.cpp)\nset_target_properties(driver PROPERTIES OUTPUT_NAME drive)\n"
            "install(TARGETS driver DESTINATION lib/rover)"
        ),
        {"drive": ("lib/rover", "src/d.cpp")},
    ),
    "ament_auto": ("ament_auto_add_executable(driver src/d.cpp)\nament_auto_package()", {"driver": ("lib/rover", "src/d.cpp")}),
    "ament_auto to bin": (
        "ament_auto_add_executable(driver src/d.cpp)\nament_auto_package(INSTALL_TO_PATH)",
        {"driver": ("bin", "src/d.cpp")},
    ),
    "a component": (
        'add_library(parts src/d.cpp)\nrclcpp_components_register_node(parts PLUGIN "rover::Driver" EXECUTABLE driver)',
        {"driver": ("lib/rover", "")},
    ),
    "a script": ("install(PROGRAMS scripts/e.py DESTINATION lib/${PROJECT_NAME})", {"e.py": ("lib/rover", "scripts/e.py")}),
    "a script with another name": (
        "install(PROGRAMS scripts/e.py DESTINATION lib/${PROJECT_NAME} RENAME e)",
        {"e": ("lib/rover", "scripts/e.py")},
    ),
    "what is in a directory": ("install(DIRECTORY scripts/ DESTINATION lib/${PROJECT_NAME})", {"e.py": ("lib/rover", "scripts/e.py")}),
    "entry points": (
        "ament_python_install_package(${PROJECT_NAME} SCRIPTS_DESTINATION lib/${PROJECT_NAME})",
        {"steer": ("lib/rover", "rover/steer.py")},
    ),
}


@pytest.mark.parametrize("case", PROGRAMS)
def test_programs(case: str, install: Make, tmp_path: Path) -> None:
    text, expected = PROGRAMS[case]
    points = {"setup.cfg": "[options.entry_points]\nconsole_scripts =\n  steer = rover.steer:main\n", "rover/steer.py": ""}
    found = _made(install, text, {**FILES, **points})
    assert found.program_reasons == ()
    programs = {each.name: (each.destination, "".join(each.sources)) for each in found.programs if each.how != "install"}
    assert programs == {name: (to, str(tmp_path / file) if file else "") for name, (to, file) in expected.items()}
    for name, (to, _) in expected.items():
        assert found.lacks_program(name) is (to != "lib/rover")
        assert (name in found.libexec) is (to == "lib/rover")
        elsewhere = found.elsewhere(name)
        assert (None if elsewhere is None else elsewhere.destination) == (None if to == "lib/rover" else to)
    assert found.lacks_program("other")


@pytest.mark.parametrize(
    "text",
    [
        "some_command()",
        "install(TARGETS ${unknown} DESTINATION lib/rover)",
        "add_executable(driver src/d.cpp)\ninstall(TARGETS driver DESTINATION ${unknown})",
        "add_executable(driver src/d.cpp)\nset_target_properties(driver PROPERTIES OUTPUT_NAME ${unknown})",
        "install(PROGRAMS ${unknown} DESTINATION lib/${PROJECT_NAME})",
        "install(PROGRAMS scripts/e.py DESTINATION ${unknown})",
        "rclcpp_components_register_node(parts PLUGIN x EXECUTABLE ${unknown})",
        "install(DIRECTORY ../scripts/ DESTINATION lib/${PROJECT_NAME})",
        "get_filename_component(UP ${CMAKE_CURRENT_SOURCE_DIR}/../.. ABSOLUTE)\ninstall(DIRECTORY ${UP}/lib/rover DESTINATION lib)",
    ],
)
def test_programs_that_are_not_known_may_be_any(text: str, install: Make) -> None:
    assert not _made(install, text).lacks_program("other")


TOOLS = {
    "tools/package.xml": "package tools",
    "tools/CMakeLists.txt": "project(tools)\nament_package(CONFIG_EXTRAS tools-extras.cmake)\n",
    "tools/tools-extras.cmake": 'include("${tools_DIR}/tools_package.cmake")\n',
    "tools/cmake/tools_package.cmake": "macro(tools_package)\ninstall(DIRECTORY ${ARGN} DESTINATION share/${PROJECT_NAME})\nendmacro()\n",
}


@pytest.mark.parametrize("found_by", ["find_package(tools)", "ament_auto_find_build_dependencies()"])
@pytest.mark.parametrize("here", [True, False])
def test_commands_that_another_package_exports(here: bool, found_by: str, grow: Callable[[Mapping[str, str | None]], Path]) -> None:
    depends = "" if "tools" in found_by else "<depend>tools</depend>"
    rover = {
        "rover/package.xml": MANIFEST.format("ament_cmake").replace("<export>", f"{depends}<export>"),
        "rover/CMakeLists.txt": f"project(rover)\n{found_by}\ntools_package(config)\n",
        "rover/config/c.yaml": "",
        "rover/launch/a.launch.xml": "",
    }
    root = grow({**rover, **(TOOLS if here else {})})
    packages = Packages([str(root)], {}, explicit=True).colcon
    package = packages.get("rover", str(root))
    assert package is not None
    found = packages.once(InstalledIndex).of(package)
    assert found.reasons == (() if here else ("the command tools_package (line 3) is not known",))
    assert not found.lacks("config/c.yaml")
    assert found.lacks("launch/a.launch.xml") is here
