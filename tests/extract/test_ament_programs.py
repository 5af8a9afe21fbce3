"""Which programs and components a package of ament has, and what each of them is made of."""

from __future__ import annotations

from pathlib import Path

from launchlint.extract.package import extract
from launchlint.extract.plan import plan
from launchlint.library.validate import faults
from tests.cli.running import write

NODE = """#include "rclcpp/rclcpp.hpp"
#include "std_msgs/msg/string.hpp"
namespace demo {{
class {name} : public rclcpp::Node {{
 public:
  explicit {name}(const rclcpp::NodeOptions & options) : Node("{topic}", options) {{
    create_publisher<std_msgs::msg::String>("{topic}", 1);
  }}
}};
}}
RCLCPP_COMPONENTS_REGISTER_NODE(demo::{name})
"""
MAIN = """#include "rclcpp/rclcpp.hpp"
int main() { rclcpp::Node node("plain"); node.declare_parameter("rate", 1.0); }
"""
CMAKE = """
cmake_minimum_required(VERSION 3.8)
project(demo)
find_package(ament_cmake_auto REQUIRED)
find_package(std_msgs REQUIRED)
function(demo_library plugin executable)
  cmake_parse_arguments(ARG "" "" "FILES;DEPENDENCIES" ${ARGN})
  add_library(${executable}_library SHARED ${ARG_FILES})
  target_link_libraries(${executable}_library ${ARG_DEPENDENCIES})
  rclcpp_components_register_node(${executable}_library PLUGIN "${plugin}" EXECUTABLE ${executable})
endfunction()
demo_library("demo::First" first FILES src/first.cpp DEPENDENCIES ${std_msgs_TARGETS})
ament_auto_add_library(both SHARED DIRECTORY src/both)
rclcpp_components_register_nodes(both "demo::Second")
add_executable(plain src/plain.cpp)
ament_target_dependencies(plain rclcpp)
install(TARGETS plain DESTINATION lib/${PROJECT_NAME})
ament_auto_package()
"""


def _package(root: Path) -> Path:
    (root / "src/both").mkdir(parents=True)
    (root / "package.xml").write_text(
        '<package format="3"><name>demo</name><version>1.0.0</version><description>d</description><maintainer email="a@b.c">a</maintainer>'
        "<license>MIT</license><export><build_type>ament_cmake</build_type></export></package>"
    )
    (root / "CMakeLists.txt").write_text(CMAKE)
    (root / "src/first.cpp").write_text(NODE.format(name="First", topic="first"))
    (root / "src/both/second.cpp").write_text(NODE.format(name="Second", topic="second"))
    (root / "src/both/third.cpp").write_text(NODE.format(name="Third", topic="third"))
    (root / "src/plain.cpp").write_text(MAIN)
    return root


def test_programs_and_components(tmp_path: Path) -> None:
    planned = plan([str(_package(tmp_path))])
    told = [(task.kind, task.name, task.client, task.entry, [Path(path).name for path in task.sources]) for task in planned.tasks]
    assert told == [
        ("executables", "plain", "rclcpp", "", ["plain.cpp"]),
        ("components", "demo::First", "component", "demo::First", ["first.cpp"]),
        ("executables", "first", "rclcpp", "demo::First", ["first.cpp"]),
        ("components", "demo::Second", "component", "demo::Second", ["second.cpp"]),
        ("components", "demo::Third", "component", "demo::Third", ["third.cpp"]),
    ]
    assert planned.skipped == ()
    assert planned.complete == frozenset(("demo",))


def test_the_library_of_a_package(tmp_path: Path) -> None:
    document = extract([str(_package(tmp_path))]).document
    assert faults(document) == []
    package = document["packages"]["demo"]
    assert (document["version"], package["middleware"], package["complete"]) == (2, "ros2", ["components"])
    first = package["components"]["demo::First"]["variants"]["default"]
    assert first["node"] == "first"
    assert [(each["name"], each["type"], each["qos"]["depth"]) for each in first["publishers"]] == [("first", "std_msgs/msg/String", 1)]
    assert package["executables"]["plain"]["variants"]["default"]["params"][0]["name"] == "~rate"


def test_a_package_of_both_is_read_as_it_is_built(tmp_path: Path) -> None:
    manifest = _package(tmp_path) / "package.xml"
    catkin = '<build_type condition="$ROS_VERSION == 1">catkin</build_type><build_type condition="$ROS_VERSION == 2">ament_cmake<'
    manifest.write_text(manifest.read_text().replace("<build_type>ament_cmake<", catkin))
    assert "middleware" not in extract([str(tmp_path)]).document["packages"]["demo"]
    package = extract([str(tmp_path)], context={"ROS_VERSION": "2"}).document["packages"]["demo"]
    assert (package["middleware"], sorted(package["components"])) == ("ros2", ["demo::First", "demo::Second", "demo::Third"])


MANIFEST = (
    '<package format="3"><name>{name}</name><version>1.0.0</version><description>d</description><maintainer email="a@b.c">a</maintainer>'
    "<license>MIT</license><depend>rclcpp</depend><export><build_type>ament_cmake</build_type></export></package>"
)
BASE = """#include "planner/ActionClient.hpp"
namespace skills {
class Skill : public planner::ActionClient {
 public:
  Skill() : planner::ActionClient("skill") { declare_parameter("robot", "r1"); }
};
}
"""
SKILL = """#include "skills/skill.hpp"
#include "settings/limits.hpp"
#include "std_msgs/msg/string.hpp"
class Pick : public skills::Skill {
 public:
  Pick() {
    auto robot = get_parameter("robot").as_string();
    create_publisher<std_msgs::msg::String>("/" + robot + "/pose", 1);
  }
};
int main() { rclcpp::Node node("limits"); limits::ParamListener listener(node.get_node_parameters_interface()); Pick pick; }
"""


def test_packages_beside_it_that_cmake_finds_and_package_xml_does_not_name(tmp_path: Path) -> None:
    files = {
        "skills/package.xml": MANIFEST.format(name="skills"),
        "skills/CMakeLists.txt": "project(skills)\nament_package()\n",
        "skills/include/skills/skill.hpp": BASE,
        "settings/package.xml": MANIFEST.format(name="settings"),
        "settings/CMakeLists.txt": "project(settings)\ngenerate_parameter_library(limits src/limits.yaml)\nament_package()\n",
        "settings/src/limits.yaml": "limits:\n  speed: {type: double, default_value: 1.0}\n",
        "demo/package.xml": MANIFEST.format(name="demo"),
        "demo/CMakeLists.txt": "project(demo)\nfind_package(skills REQUIRED)\nfind_package(settings REQUIRED)\n"
        "add_executable(pick pick.cpp)\ninstall(TARGETS pick DESTINATION lib/${PROJECT_NAME})\nament_package()\n",
        "demo/pick.cpp": SKILL,
    }
    write(tmp_path, files)
    variant = extract([str(tmp_path)], ["demo"]).document["packages"]["demo"]["executables"]["pick"]["variants"]["default"]
    assert [each["name"] for each in variant["publishers"]] == ["/{param:~robot|r1}/pose"]  # a base class that may be a node
    assert {each["name"] for each in variant["params"]} == {"~robot", "~speed"}
    assert "planner::ActionClient" in variant["open"]["publishers"]


def test_sources_are_read_and_not_what_colcon_installed_of_them(tmp_path: Path) -> None:
    files = {
        "build/COLCON_IGNORE": "",
        "install/COLCON_IGNORE": "",
        "install/demo/share/demo/package.xml": MANIFEST.format(name="demo"),
        "src/demo/package.xml": MANIFEST.format(name="demo"),
        "src/demo/CMakeLists.txt": "project(demo)\nadd_executable(plain plain.cpp)\n"
        "install(TARGETS plain DESTINATION lib/${PROJECT_NAME})\nament_package()\n",
        "src/demo/plain.cpp": MAIN,
    }
    write(tmp_path, files)
    (tmp_path / "build/demo").mkdir()
    (tmp_path / "build/demo/package.xml").symlink_to(tmp_path / "elsewhere/package.xml")
    result = extract([str(tmp_path)])
    assert list(result.document["packages"]["demo"]["executables"]) == ["plain"]
    assert result.skipped == ()


def test_a_manifest_that_forgets_the_build_type(tmp_path: Path) -> None:
    manifest = MANIFEST.format(name="demo").replace("<build_type>ament_cmake</build_type>", "")
    assert "ament_cmake" not in manifest or "build_type" not in manifest
    (tmp_path / "package.xml").write_text(manifest.replace("<export>", "<buildtool_depend>ament_cmake</buildtool_depend><export>"))
    (tmp_path / "CMakeLists.txt").write_text(
        "project(demo)\nadd_executable(plain plain.cpp)\ninstall(TARGETS plain DESTINATION lib/${PROJECT_NAME})\nament_package()\n"
    )
    (tmp_path / "plain.cpp").write_text(MAIN)
    package = extract([str(tmp_path)]).document["packages"]["demo"]
    assert package["middleware"] == "ros2"
    assert package["executables"]["plain"]["class"] == "rclcpp"
