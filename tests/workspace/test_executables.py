"""What a package can run and what it installs."""

from __future__ import annotations

import os
from collections.abc import Callable, Mapping
from pathlib import Path

import pytest

from launchlint.workspace.cmake_facts import read_cmake
from launchlint.workspace.executables import Executable, ExecutableIndex, Executables, Flaw, executables, launch_install_directories
from launchlint.workspace.nodelets import NodeletClass
from launchlint.workspace.package import Package
from launchlint.workspace.packages import Packages

Grow = Callable[[Mapping[str, str | None]], Path]


def _package(root: Path, name: str = "p") -> Package:
    package = Packages([str(root)], {}, explicit=True).get(name, str(root))
    assert package is not None
    return package


def _executables(root: Path) -> Executables:
    return executables(_package(root))


def test_targets_and_executable_files(grow: Grow) -> None:
    root = grow(
        {
            "p/package.xml": "package p",
            "p/CMakeLists.txt": "add_executable(driver a.cpp)\ncatkin_install_python(PROGRAMS scripts/listen.py DESTINATION x)",
            "p/scripts/listen.py": "#!/usr/bin/env python3",
            "p/scripts/deep/talk.py": "+x #!/usr/bin/env python3",
            "p/.hidden/no.py": "+x #!/usr/bin/env python3",
            "p/README": "",
        }
    )
    found = _executables(root)
    assert found.by_name == {
        "driver": Executable("driver", "add_executable", None),
        "listen.py": Executable("listen.py", "catkin_install_python(PROGRAMS)", None),
        "talk.py": Executable("talk.py", "file", f"{root}/p/scripts/deep/talk.py"),
    }
    assert (found.names, found.exhaustive, found.installed) == (["driver", "listen.py", "talk.py"], True, False)


def test_no_cmake_file_means_that_nothing_is_certain(grow: Grow) -> None:
    found = _executables(grow({"p/package.xml": "package p"}))
    assert (found.names, found.exhaustive) == ([], False)
    assert found.reasons == ("CMakeLists.txt cannot be read: No such file or directory",)


def test_an_installed_package(grow: Grow) -> None:
    root = grow(
        {
            "opt/share/p/package.xml": "package p",
            "opt/share/p/scripts/tool.sh": "+x #!/bin/sh",
            "opt/lib/p/node": "+x \x7fELF",
            "opt/lib/p/data": "",
        }
    )
    found = _executables(root / "opt")
    assert (found.names, found.exhaustive, found.installed) == (["node", "tool.sh"], True, True)
    assert found.by_name["node"].path == f"{root}/opt/lib/p/node"


def test_devel_space_of_a_package(grow: Grow) -> None:
    root = grow(
        {
            "src/p/package.xml": "package p",
            "src/p/CMakeLists.txt": "add_executable(a x)",
            "devel/.catkin": "",
            "devel/lib/p/generated": "+x #!/bin/sh",
        }
    )
    packages = Packages([f"{root}/src"], {"CMAKE_PREFIX_PATH": f"{root}/devel"}, explicit=True)
    package = packages.get("p", str(root))
    assert package is not None
    index = ExecutableIndex(packages)
    assert index.executables(package).names == ["a", "generated"]
    assert index.executables(package) is index.executables(package)
    assert index.installs(package) is index.installs(package)


@pytest.mark.parametrize(
    ("name", "expected"),
    [
        ("fine.py", None),
        ("no_bit.py", Flaw("scripts/no_bit.py", True, False)),
        ("no_bit", Flaw("scripts/no_bit", True, False)),
        ("neither.py", Flaw("scripts/neither.py", True, True)),
        ("no_shebang.py", Flaw("scripts/no_shebang.py", False, True)),
        ("installed.py", Flaw("scripts/installed.py", True, False)),
        ("text", None),
        ("binary", None),
        ("target", None),
        ("nowhere", None),
    ],
)
def test_scripts_that_cannot_be_started(name: str, expected: Flaw | None, grow: Grow) -> None:
    root = grow(
        {
            "p/package.xml": "package p",
            "p/CMakeLists.txt": "add_executable(target x)\ninstall(PROGRAMS scripts/installed.py DESTINATION x)",
            "p/scripts/fine.py": "+x #!/usr/bin/env python3",
            "p/scripts/no_bit.py": "#!/usr/bin/env python3",
            "p/scripts/no_bit": "#!/usr/bin/env python3",
            "p/scripts/neither.py": "import rospy",
            "p/scripts/no_shebang.py": "+x import rospy",
            "p/scripts/installed.py": "#!/usr/bin/env python3",
            "p/text": "words",
            "p/binary": "+x \x7fELF",
        }
    )
    flaw = _executables(root).flaw(name)
    assert (flaw and flaw._replace(path=os.path.relpath(flaw.path, root / "p"))) == expected


def test_nodelet_classes(grow: Grow) -> None:
    root = grow(
        {
            "p/package.xml": """<package><name>p</name>
                <export><nodelet plugin='${prefix}/a.xml'/><nodelet plugin='b.xml'/></export></package>""",
            "p/a.xml": """<?xml version='1.0'?>
                <library path='l'><class name='p/One' type='p::One' base_class_type='nodelet::Nodelet'/></library>
                <library path='m'><class type='p::Two' base_class_type='nodelet::Nodelet'/></library>""",
            "p/b.xml": "<class_libraries><library><class name='p/Three' type='p::Three'/></library></class_libraries>",
        }
    )
    found = _executables(root)
    assert found.nodelet_classes == {
        "p/One": NodeletClass("p/One", "p::One", "nodelet::Nodelet", f"{root}/p/a.xml", "l"),
        "p/Three": NodeletClass("p/Three", "p::Three", "", f"{root}/p/b.xml"),
        "p::Two": NodeletClass("p::Two", "p::Two", "nodelet::Nodelet", f"{root}/p/a.xml", "m"),
    }
    assert found.nodelet_reasons == ()


@pytest.mark.parametrize(
    ("content", "reason"),
    [
        (None, "a.xml cannot be read: it is not a plain file"),
        ("<library>", "a.xml is not well-formed XML: mismatched tag: line 1, column 28"),
        ("<!DOCTYPE x [<!ENTITY a 'b'>]><library/>", "a.xml is not well-formed XML: not well-formed (invalid token): line 1, column 19"),
    ],
)
def test_broken_nodelet_descriptions(content: str | None, reason: str, grow: Grow) -> None:
    package = "<package><name>p</name><export><nodelet plugin='${prefix}/a.xml'/></export></package>"
    found = _executables(grow({"p/package.xml": package, "p/a.xml": content}))
    assert (dict(found.nodelet_classes), found.nodelet_reasons) == ({}, (reason,))


@pytest.mark.parametrize(
    ("text", "covered", "exhaustive"),
    [
        ("", [], True),
        ("install(DIRECTORY launch DESTINATION ${CATKIN_PACKAGE_SHARE_DESTINATION})", ["launch/a.launch", "launch/sub/b.launch"], True),
        ("install(DIRECTORY launch/ config DESTINATION share/p/launch)", ["config/c.yaml", "launch/a.launch", "launch/sub/b.launch"], True),
        ("install(DIRECTORY . DESTINATION x)", ["config/c.yaml", "launch/a.launch", "launch/sub/b.launch", "top.launch"], True),
        ('install(DIRECTORY launch DESTINATION x FILES_MATCHING PATTERN "a*")', ["launch/a.launch"], True),
        ('install(DIRECTORY launch DESTINATION x PATTERN "sub" EXCLUDE)', ["launch/a.launch"], True),
        ('install(DIRECTORY launch DESTINATION x PATTERN "launch/sub" EXCLUDE)', ["launch/a.launch", "launch/sub/b.launch"], True),
        ("install(FILES top.launch launch/a.launch DESTINATION x)", ["launch/a.launch", "top.launch"], True),
        ("file(GLOB L launch/*.launch)\ninstall(FILES ${L} DESTINATION x)", ["launch/a.launch"], True),
        (
            "foreach(d launch config)\ninstall(DIRECTORY ${d}/ DESTINATION x/${d})\nendforeach()",
            ["config/c.yaml", "launch/a.launch", "launch/sub/b.launch"],
            True,
        ),
        ("install(TARGETS a RUNTIME DESTINATION bin)", [], True),
        ("install(DIRECTORY ${D} DESTINATION x)", [], False),
        ('install(DIRECTORY launch DESTINATION x REGEX "a" EXCLUDE)', ["launch/a.launch", "launch/sub/b.launch"], False),
        ("some_install_macro()", [], False),
    ],
)
def test_installed_files(text: str, covered: list[str], exhaustive: bool, grow: Grow) -> None:
    files = ["config/c.yaml", "launch/a.launch", "launch/sub/b.launch", "top.launch"]
    root = grow({"p/package.xml": "package p", "p/CMakeLists.txt": f"project(p)\n{text}", **{f"p/{each}": "" for each in files}})
    installed = launch_install_directories(_package(root))
    assert ([each for each in files if installed.covers(f"{root}/p/{each}")], installed.exhaustive) == (covered, exhaustive)


def test_directories_that_are_installed(grow: Grow) -> None:
    root = grow(
        {
            "p/package.xml": "package p",
            "p/CMakeLists.txt": "install(DIRECTORY launch config/ DESTINATION x)\ninstall(FILES a DESTINATION y)",
        }
    )
    installed = launch_install_directories(_package(root))
    assert installed.directories == (f"{root}/p/config", f"{root}/p/launch")
    assert [(os.path.relpath(each.path, root), each.destination) for each in installed.installs] == [
        ("p/launch", "x"),
        ("p/config", "x"),
        ("p/a", "y"),
    ]


def test_links_that_lead_back_in_a_package(grow: Grow) -> None:
    root = grow(
        {
            "p/package.xml": "package p",
            "p/CMakeLists.txt": "",
            "p/loop": "-> ..",
            "p/s/up": "-> ../s",
            "p/s/run": "+x #!/bin/sh",
            "p/gone": "-> no",
        }
    )
    assert _executables(root).by_name == {"run": Executable("run", "file", f"{root}/p/s/run")}


def test_what_targets_are_made_of(grow: Grow) -> None:
    root = grow(
        {
            "p/package.xml": "<package><name>p</name></package>",
            "p/CMakeLists.txt": """
                project(p)
                set(sources src/a.cpp)
                if(WITH_B)
                  list(APPEND sources src/b.cpp)
                endif()
                macro(add_more name file)
                  add_executable(${name}_exe ${file})
                  set_target_properties(${name}_exe PROPERTIES OUTPUT_NAME ${name})
                  target_link_libraries(${name}_exe ${PROJECT_NAME}_lib)
                  list(APPEND more ${file})
                endmacro()
                add_more(one src/one.cpp)
                add_more(two src/two.cpp)
                add_library(${PROJECT_NAME}_lib SHARED ${sources})
                add_library(all ${more})
                add_executable(main src/main.cpp ${NOT_KNOWN})
                target_link_libraries(main PRIVATE ${PROJECT_NAME}_lib ${catkin_LIBRARIES})
                target_sources(main PRIVATE src/main2.cpp)
            """,
        }
    )
    targets = read_cmake(str(root / "p"), list).targets
    shown = {
        name: ([os.path.relpath(path, root / "p") for path in each.sources], each.libraries, each.is_library, each.complete)
        for name, each in targets.items()
    }
    assert shown == {
        "one_exe": (["src/one.cpp"], ["p_lib"], False, True),
        "two_exe": (["src/two.cpp"], ["p_lib"], False, True),
        "p_lib": (["src/a.cpp", "src/b.cpp"], [], True, True),
        "all": (["src/one.cpp", "src/two.cpp"], [], True, True),
        "main": (["src/main.cpp", "src/main2.cpp"], ["p_lib"], False, False),
    }
