"""Programs whose source the build makes of a template."""

from __future__ import annotations

from pathlib import Path

import pytest

from launchlint.extract.package import extract
from tests.extract.test_package import MANIFEST, at, grow, program

ONE_NODELET = """#include <nodelet/loader.h>
int main(int argc, char** argv) {
  ros::init(argc, argv, "@NAME@");
  nodelet::Loader loader(false);
  loader.load(ros::this_node::getName(), "@NODELET@", nodelet::M_string(), nodelet::V_string());
}
"""
MACRO = """project(demo)
macro(add_nodelet name class file)
  set(NAME ${name})
  set(NODELET ${class})
  configure_file(cmake/one_nodelet.cpp.in ${NAME}.cpp @ONLY)
  add_executable(${NAME}_exe ${NAME}.cpp)
  set_target_properties(${NAME}_exe PROPERTIES OUTPUT_NAME ${NAME})
  list(APPEND files ${file})
endmacro()
add_nodelet(edges demo/Edges src/edges.cpp)
add_nodelet(lines demo/Lines src/lines.cpp)
add_library(demo ${files})
"""
CLASS = 'class {0} : public nodelet::Nodelet {{ void onInit() {{ getPrivateNodeHandle().advertise<std_msgs::Bool>("{1}", 1); }} }};\n'


def test_executables_that_load_one_nodelet(tmp_path: Path) -> None:
    root = grow(
        tmp_path / "ws",
        {
            "demo/package.xml": MANIFEST.format(name="demo", more="<export><nodelet plugin='${prefix}/plugins.xml'/></export>"),
            "demo/plugins.xml": "<library path='lib/libdemo'><class name='demo/Edges' type='Edges' base_class_type='nodelet::Nodelet'/>"
            "<class name='demo/Lines' type='Lines' base_class_type='nodelet::Nodelet'/></library>",
            "demo/CMakeLists.txt": MACRO,
            "demo/cmake/one_nodelet.cpp.in": ONE_NODELET,
            "demo/src/edges.cpp": CLASS.format("Edges", "edges"),
            "demo/src/lines.cpp": CLASS.format("Lines", "lines"),
        },
    )
    found = extract([str(root)])
    assert found.skipped == ()
    assert {name: each["variants"]["default"] for name, each in found.document["packages"]["demo"]["executables"].items()} == {
        name: {"publishers": [{"name": f"~{name}", "type": "std_msgs/Bool", "queue": 1, "evidence": at(f"demo/src/{name}.cpp:1")}]}
        for name in ("edges", "lines")
    }


TOPIC = 'int main() {{ ros::NodeHandle nh;\n  nh.advertise<std_msgs::Bool>("{0}", 1); }}\n'


def test_a_command_that_another_package_exports(tmp_path: Path) -> None:
    exporting, using = MACRO.removeprefix("project(demo)\n").split("add_nodelet(edges", 1)
    root = grow(
        tmp_path / "ws",
        {
            "macros/package.xml": MANIFEST.format(name="macros", more=""),
            "macros/CMakeLists.txt": "project(macros)\ncatkin_package(LIBRARIES macros CFG_EXTRAS nodelets.cmake DEPENDS x)\n",
            "macros/cmake/nodelets.cmake.em": "@[if DEVELSPACE]@\n"
            + exporting.replace("cmake/one", "${macros_SOURCE_PREFIX}/cmake/one")
            + "@[end if]@\n",
            "macros/cmake/one_nodelet.cpp.in": ONE_NODELET,
            "demo/package.xml": MANIFEST.format(name="demo", more="<export><nodelet plugin='${prefix}/plugins.xml'/></export>"),
            "demo/plugins.xml": "<library path='lib/libdemo'>"
            "<class name='demo/Edges' type='Edges' base_class_type='nodelet::Nodelet'/></library>",
            "demo/CMakeLists.txt": "project(demo)\nfind_package(catkin REQUIRED COMPONENTS macros)\n"
            "add_nodelet(edges demo/Edges src/edges.cpp)\nadd_library(demo ${files})\n",
            "demo/src/edges.cpp": CLASS.format("Edges", "edges"),
        },
    )
    assert using  # the macro ends before its first use
    assert program(root, "demo", "edges")["variants"]["default"] == {
        "publishers": [{"name": "~edges", "type": "std_msgs/Bool", "queue": 1, "evidence": at("demo/src/edges.cpp:1")}]
    }
    grow(root, {"demo/CMakeLists.txt": "project(demo)\nadd_nodelet(edges demo/Edges src/edges.cpp)\nadd_library(demo ${files})\n"})
    assert extract([str(root)]).document["packages"] == {}, "a package that is not found gives no commands"


@pytest.mark.parametrize(
    ("command", "template", "name"),
    [
        ("set(T a)\nconfigure_file(x.in x.cpp)", TOPIC.format("@T@/${T}"), "a/a"),
        ("set(T a)\nconfigure_file(x.in x.cpp @ONLY)", TOPIC.format("@T@"), "a"),
        ("configure_file(x.in x.cpp COPYONLY)", TOPIC.format("plain"), "plain"),
        ("set(T a)\nconfigure_file(x.in ${CMAKE_CURRENT_BINARY_DIR}/x.cpp)\nset(T b)", TOPIC.format("@T@"), "a"),
        ("configure_file(x.in x.cpp)", TOPIC.format("${PROJECT_NAME}"), "demo"),
    ],
)
def test_what_is_put_into_a_template(tmp_path: Path, command: str, template: str, name: str) -> None:
    root = grow(
        tmp_path / "ws",
        {
            "demo/package.xml": MANIFEST.format(name="demo", more=""),
            "demo/CMakeLists.txt": f"project(demo)\n{command}\nadd_executable(node x.cpp)\n",
            "demo/x.in": template,
        },
    )
    assert program(root, "demo", "node")["variants"]["default"] == {
        "publishers": [{"name": name, "type": "std_msgs/Bool", "queue": 1, "evidence": at("demo/x.in:2")}]
    }


@pytest.mark.parametrize(
    ("command", "template"),
    [
        ("configure_file(x.in x.cpp)", TOPIC.format("@T@")),
        ("configure_file(x.in x.cpp)", TOPIC.format("${T}")),
        ("set(T a@b@)\nset(b c)\nconfigure_file(x.in x.cpp)", TOPIC.format("@T@")),
        ('set(T "a\nb")\nconfigure_file(x.in x.cpp)', TOPIC.format("@T@")),
        ("configure_file(x.in x.cpp)", "#cmakedefine T\n" + TOPIC.format("a")),
        ("configure_file(../x.in x.cpp)", TOPIC.format("a")),
        ("set(T " + "a" * 10_000 + ")\nconfigure_file(x.in x.cpp)", TOPIC.format("@T@" * 100)),
    ],
)
def test_nothing_is_invented_where_a_template_is_not_known(tmp_path: Path, command: str, template: str) -> None:
    root = grow(
        tmp_path / "ws",
        {
            "demo/package.xml": MANIFEST.format(name="demo", more=""),
            "demo/CMakeLists.txt": f"project(demo)\n{command}\nadd_executable(node x.cpp)\n",
            "demo/x.in": template,
            "x.in": TOPIC.format("outside"),
        },
    )
    result = extract([str(root)])
    assert result.document["packages"] == {}
    assert [(each.name, each.reason) for each in result.skipped] == [("node", "its source files are not here")]


def test_one_template_twice_in_one_program(tmp_path: Path) -> None:
    root = grow(
        tmp_path / "ws",
        {
            "demo/package.xml": MANIFEST.format(name="demo", more=""),
            "demo/CMakeLists.txt": "project(demo)\nset(T a)\nconfigure_file(x.in x.cpp)\nset(T b)\nconfigure_file(x.in y.cpp)\n"
            "add_executable(node x.cpp y.cpp)\n",
            "demo/x.in": TOPIC.format("@T@"),
        },
    )
    found = program(root, "demo", "node")["variants"]["default"]
    assert [each["name"] for each in found["publishers"]] == ["a"]
    assert found["open"]["publishers"] == "not all sources of node are known"


def test_a_command_of_another_package_makes_an_executable_of_what_has_a_main(tmp_path: Path) -> None:
    root = grow(
        tmp_path / "ws",
        {
            "demo/package.xml": MANIFEST.format(name="demo", more=""),
            "demo/CMakeLists.txt": "project(demo)\nfar_binary(node SRCS src/main.cc)\nfar_binary(no_node SRCS src/part.cc)\n"
            "far_binary(nowhere SRCS src/none.cc)\nadd_library(demo src/part.cc)\n",
            "demo/src/main.cc": '#include "part.h"\nint main() { ros::NodeHandle nh; part(nh); }\n',
            "demo/src/part.h": "void part(ros::NodeHandle& nh);\n",
            "demo/src/part.cc": '#include "part.h"\nvoid part(ros::NodeHandle& nh) { nh.advertise<std_msgs::Bool>("done", 1); }\n',
        },
    )
    result = extract([str(root)])
    assert result.skipped == ()
    assert list(result.document["packages"]["demo"]["executables"]) == ["node"]
    found = program(root, "demo", "node")["variants"]["default"]
    assert found.pop("open") == dict.fromkeys(
        ("publishers", "subscribers", "services", "clients", "actions", "params"), "not all sources of node are known"
    )
    assert found.pop("literals") == ["done"]
    assert found == {"publishers": [{"name": "done", "type": "std_msgs/Bool", "queue": 1, "evidence": at("demo/src/part.cc:2")}]}
