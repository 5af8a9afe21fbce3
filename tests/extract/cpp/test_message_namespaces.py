"""The type of a message whose namespace is no package, or only perhaps one."""

from __future__ import annotations

from pathlib import Path

import pytest

from launchlint.extract.cpp import cpp_program
from tests.extract.cpp.test_rclcpp import follow

INCLUDES = "#include <ros/ros.h>\n#include <arm_msgs/Grip.h>\n#include <leg_msgs/Step.h>\n"
INNER = "namespace arm { namespace msgs { using namespace arm_msgs; using namespace leg_msgs; } }\n"
OUTER = "namespace msgs { using namespace arm_msgs; }\n"

SAID = {
    "included": ("", "arm_msgs::Grip", "arm_msgs/Grip"),
    "not included": ("", "arm_msgs::Other", "arm_msgs/Other"),
    "one of several namespaces": (INNER, "msgs::Grip", "arm_msgs/Grip"),
    "the other": (INNER, "msgs::StepConstPtr", "leg_msgs/Step"),
    "by its full name": (INNER, "arm::msgs::Step::ConstPtr", "leg_msgs/Step"),
    "included elsewhere": (INNER, "msgs::Unseen", ""),
    "not inside": (OUTER, "msgs::Grip", "arm_msgs/Grip"),
    "not inside, included elsewhere": (OUTER, "msgs::Unseen", ""),
    "a package's own namespace": ("namespace our { using namespace std; }\n", "our::Thing", "our/Thing"),
    "a header that is not here": ("#include <moveit/some_terrain/terrain.h>\n", "terrain_modelling::TerrainMsg", ""),
    "a header of that package that is not here": ("#include <costmap_converter/some_words.h>\n", "costmap_converter::Thing", ""),
    "a message beside such a header": (
        "#include <costmap_converter/some_words.h>\n#include <costmap_converter/Thing.h>\n",
        "costmap_converter::Thing",
        "costmap_converter/Thing",
    ),
    "a short name for some package": ("", "msgs::Thing", ""),
    "a package of that short name": ("#include <msgs/Thing.h>\n", "msgs::Thing", "msgs/Thing"),
    "a message package beside it": ("#include <moveit/some_terrain/terrain.h>\n", "tall_msgs::Thing", "tall_msgs/Thing"),
    "a known package beside it": (
        "#include <moveit/some_terrain/terrain.h>\n",
        "dynamic_reconfigure::Config",
        "dynamic_reconfigure/Config",
    ),
    "a package of included messages": (
        "#include <moveit/some_terrain/terrain.h>\n#include <own/One.h>\n",
        "own::Two",
        "own/Two",
    ),
}


@pytest.mark.parametrize(("before", "spelled", "expected"), SAID.values(), ids=SAID)
def test_type(before: str, spelled: str, expected: str, tmp_path: Path) -> None:
    source = (
        f"{INCLUDES}{before}namespace arm {{\nvoid heard(const {spelled}& message) {{}}\n"
        'void start(ros::NodeHandle& nh) { nh.subscribe("a", 1, heard); }\n}\n'
        "int main(int argc, char** argv) { ros::NodeHandle nh; arm::start(nh); }\n"
    )
    (tmp_path / "main.cpp").write_text(source, encoding="utf-8")
    facts, _, _ = cpp_program([str(tmp_path / "main.cpp")], [], str(tmp_path), None)
    assert [(fact.name, fact.type) for fact in facts if fact.category == "subscribers"] == [("a", expected)]


INSIDE = {
    "the package's own, in its namespace": ("msg::Grip", "arm/msg/Grip"),
    "by its whole name": ("arm::msg::Grip", "arm/msg/Grip"),
    "not included": ("msg::Other", ""),
    "of a class of that namespace": ("msg::Own", ""),
}


@pytest.mark.parametrize(("used", "expected"), INSIDE.values(), ids=INSIDE)
def test_type_in_the_namespace_of_its_package(used: str, expected: str, tmp_path: Path) -> None:
    source = f"""#include <rclcpp/rclcpp.hpp>
#include <arm/msg/grip.hpp>
namespace arm::drive {{
namespace msg {{ struct Own {{}}; }}
class Talker : public rclcpp::Node {{
 public:
  Talker() : Node("talker") {{ talk_ = create_publisher<{used}>("a", 1); }}
  rclcpp::Publisher<{used}>::SharedPtr talk_;
}};
}}
int main(int argc, char** argv) {{
  rclcpp::init(argc, argv);
  rclcpp::spin(std::make_shared<arm::drive::Talker>());
}}
"""
    assert [(fact.name, fact.type) for fact in follow(tmp_path, source)[0] if fact.category == "publishers"] == [("a", expected)]
