"""Which files a build makes."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from pathlib import Path

import pytest

from launchlint.workspace.executables import made_files
from launchlint.workspace.packages import Packages

Grow = Callable[[Mapping[str, str | None]], Path]

# Text of CMakeLists.txt → (files that it makes, files that it does not make), relative to the package.
TEXTS: dict[str, tuple[list[str], list[str]]] = {
    "configure_file(a.yaml.in ${CMAKE_CURRENT_BINARY_DIR}/config/a.yaml @ONLY)": (["a.yaml", "config/a.yaml"], ["a.yaml.in", "b.yaml"]),
    "configure_file(templates/a.yaml config)": (["config/a.yaml"], ["config/b.yaml"]),
    "configure_file(a.in ${CATKIN_DEVEL_PREFIX}/share/p/a.yaml)": (["a.yaml"], ["b.yaml"]),
    "configure_file(a.in config/${robot}.yaml)": ([], ["config/a.yaml"]),
    "configure_file(a.in config/arm_${robot}.yaml)": (["config/arm_x.yaml"], ["config/x.yaml"]),
    "foreach(r a b)\nconfigure_file(r.in ${r}.launch)\nendforeach()": (["a.launch", "b.launch"], ["c.launch"]),
    "function(make r)\nconfigure_file(r.in ${r}.launch)\nendfunction()\nmake(a)\nmake(b)": (["a.launch", "b.launch"], ["r.in", "c.launch"]),
    "foreach(f to IN ZIP_LISTS from into)\nconfigure_file(${f} ${to})\nendforeach()": ([], ["a.sdf"]),
    "set(from x.erb y.erb)\nset(into a.sdf m/b.sdf)\nforeach(f to IN ZIP_LISTS from into)\nconfigure_file(${f} ${to})\nendforeach()": (
        ["a.sdf", "m/b.sdf"],
        ["x.erb", "c.sdf"],
    ),
    "set(from x.erb)\nset(into a.sdf)\nforeach(each IN ZIP_LISTS from into)\nconfigure_file(${each_0} ${each_1})\nendforeach()": (
        ["a.sdf"],
        ["x.erb"],
    ),
    "set(to ${CMAKE_INSTALL_PREFIX}/m/a.sdf)\nadd_custom_command(OUTPUT ${to} COMMAND erb x.erb > ${to} DEPENDS x.erb)": (
        ["m/a.sdf"],
        ["b.sdf"],
    ),
    "add_custom_command(OUTPUT a.urdf COMMAND xacro a.xacro -o a.urdf DEPENDS a.xacro b.yaml)": (["urdf/a.urdf"], ["b.yaml"]),
    'add_custom_target(maps ALL COMMAND sh -c "wget -O maps/a.pgm http://x/b.pgm" VERBATIM)': (["maps/a.pgm"], ["maps/b.pgm"]),
    "file(WRITE a.yaml text)": (["a.yaml"], []),
    "file(APPEND a.yaml text)": (["a.yaml"], []),
    "file(GENERATE OUTPUT a_$<CONFIG>.yaml CONTENT x)\nfile(GENERATE OUTPUT b.yaml INPUT c)": (["b.yaml"], ["a_x.yaml"]),
    "file(DOWNLOAD http://example.org/z.yaml ${PROJECT_SOURCE_DIR}/config/a.yaml)": (["config/a.yaml"], ["z.yaml"]),
    "file(COPY ../other/a.yaml DESTINATION config)": (["config/a.yaml"], []),
    "file(READ a.yaml text)\nfile(STRINGS b.yaml text)": ([], ["a.yaml", "b.yaml"]),
    "install(FILES a.yaml DESTINATION share/p RENAME b.yaml)": (["b.yaml"], ["a.yaml"]),
    "catkin_add_env_hooks(50.robot SHELLS sh bash DIRECTORY hooks)": (["50.robot.sh"], ["51.robot.sh"]),
    "catkin_download_test_data(t http://x/y.bag DESTINATION test FILENAME a.bag MD5 0)": (["test/a.bag"], ["test/y.bag"]),
    "catkin_download_test_data(t http://x/y.bag DESTINATION test MD5 0)": (["test/y.bag"], ["test/t"]),
    "xacro_add_files(a.urdf.xacro INORDER INSTALL DESTINATION xml)": (["a.urdf"], ["b.urdf"]),
    "ExternalProject_Add(data URL http://x/d.zip SOURCE_DIR ${CMAKE_CURRENT_SOURCE_DIR}/data)": (
        ["data/x/a.yaml"],
        ["database/a.yaml", "d.zip"],
    ),
    "em_expand(context.in context.out a.launch.em a.launch)": (["a.launch"], ["b.launch"]),
    "robot_urdf(a.urdf)": (["a.urdf"], ["b.urdf"]),
    "roslaunch_add_file_check(a.launch)\nadd_rostest(b.test)\nfind_package(c.yaml)": ([], ["a.launch", "b.test", "c.yaml"]),
    "install(DIRECTORY launch DESTINATION share/p)\ninstall(FILES a.yaml DESTINATION x)": ([], ["launch/a.launch", "a.yaml"]),
    "if(NOT broken": ([], ["a.yaml"]),
}


@pytest.mark.parametrize("text", TEXTS)
def test_what_is_made(text: str, grow: Grow) -> None:
    root = grow({"package.xml": "package p", "CMakeLists.txt": f"project(p)\n{text}\n"})
    package = Packages([str(root)], {}, explicit=True).get("p", str(root))
    assert package is not None
    made = made_files(package)
    yes, no = TEXTS[text]
    assert [path for path in (*yes, *no) if made.by(f"{root}/{path}") is not None] == yes


def test_where_it_is_made(grow: Grow) -> None:
    root = grow(
        {
            "package.xml": "package p",
            "CMakeLists.txt": "\nadd_subdirectory(config)\n",
            "config/CMakeLists.txt": "configure_file(a b.yaml)\n",
        }
    )
    package = Packages([str(root)], {}, explicit=True).get("p", str(root))
    assert package is not None
    assert made_files(package).by(f"{root}/b.yaml") == "configure_file (config/CMakeLists.txt, line 1)"
