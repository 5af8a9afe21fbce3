"""What no call in the program names: callbacks without their object, operators, packs of arguments, nodes that come from elsewhere."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.extract.cpp.following import lines
from tests.extract.cpp.test_rclcpp import HEAD, follow, node, spelled

_MADE = 'create_publisher<std_msgs::msg::String>("{}", 1);'
_CALLBACK = f"void heard() {{ {_MADE.format('late')} }}"
_NODE = 'class Talker : public rclcpp::Node {\n public:\n  Talker() : Node("talker") {}\n};\n'
FOUND = {
    "a callback of filters, with its object behind it": (
        node(
            "  filter_.registerCallback(&Talker::heard, this);",
            f"{_CALLBACK}\n  message_filters::Subscriber<std_msgs::msg::String> filter_;",
        ),
        "publishers late std_msgs/msg/String reliable/volatile/keep_last/1 when=message",
    ),
    "a task of diagnostics, with its object before it": (
        node(
            '  updater_.add("state", this, &Talker::heard);',
            f"{_CALLBACK}\n  diagnostic_updater::Updater updater_{{this}};",
        ),
        """
        params ~diagnostic_updater.period double default=1.0 declared
        params ~diagnostic_updater.use_fqn bool default=False declared
        publishers /diagnostics diagnostic_msgs/msg/DiagnosticArray reliable/volatile/keep_last/1
        publishers late std_msgs/msg/String reliable/volatile/keep_last/1 when=message
        """,
    ),
    "std::invoke": (
        node("  std::invoke(&Talker::heard, this);", _CALLBACK),
        "publishers late std_msgs/msg/String reliable/volatile/keep_last/1",
    ),
    "a pointer to a member, with its first value in the class": (
        node("  (this->*member_)();", f"{_CALLBACK}\n  void (Talker::*member_)() = &Talker::heard;"),
        "publishers late std_msgs/msg/String reliable/volatile/keep_last/1 when=message if heard is called",
    ),
    "a pointer to a member that is a variable": (
        node("  auto member = &Talker::heard;\n  (this->*member)();", _CALLBACK),
        "publishers late std_msgs/msg/String reliable/volatile/keep_last/1 when=message if heard is called",
    ),
    "an object that is called, and one that is written to": (
        f"""{HEAD}
struct Maker {{
  explicit Maker(rclcpp::Node * node) : node(node) {{}}
  void operator()(const std::string & name) {{ node->create_publisher<std_msgs::msg::String>(name, 1); }}
  Maker & operator<<(const std::string & name) {{ node->create_publisher<std_msgs::msg::String>(name, 1); return *this; }}
  ~Maker() {{ node->create_client<std_srvs::srv::Trigger>("gone"); }}
  rclcpp::Node * node;
}};
class Talker : public rclcpp::Node {{
 public:
  Talker() : Node("talker") {{
    Maker maker(this);
    maker("called");
    maker << "written" << "again";
  }}
}};
int main() {{ rclcpp::spin(std::make_shared<Talker>()); }}
""",
        """
        clients gone std_srvs/srv/Trigger when=message if ~Maker of Maker is called
        publishers again std_msgs/msg/String reliable/volatile/keep_last/1
        publishers called std_msgs/msg/String reliable/volatile/keep_last/1
        publishers written std_msgs/msg/String reliable/volatile/keep_last/1
        """,
    ),
}


@pytest.mark.parametrize("case", FOUND)
def test_found(case: str, tmp_path: Path) -> None:
    source, expected = FOUND[case]
    facts, doubts, _ = follow(tmp_path, source)
    assert [spelled(each) for each in facts] == lines(expected)
    assert not doubts


DOUBTED = {
    "a pack of arguments": (
        node(
            "  (make<std_msgs::msg::String>(numbers), ...);",
            'template <typename T> void make(int number) { create_publisher<T>("out", 1); }',
        ),
        "names are made for each of a pack of arguments",
    ),
    "a node of a class that is not here": (
        f'#include "other/node.hpp"\n{HEAD}int main() {{\n  rclcpp::spin(std::make_shared<other::Node>());\n}}\n',
        "it runs a node of which nothing is known: rclcpp::spin(std::make_shared<other::Node>())",
    ),
    "a node that a library gives, in an executor": (
        f"""{HEAD}
int main() {{
  auto make = dlsym(library, symbol);
  rclcpp::executors::SingleThreadedExecutor executor;
  executor.add_node(make());
}}
""",
        "it runs a node of which nothing is known: executor.add_node(make())",
    ),
    "no node at all": (
        f"{HEAD}int main(int argc, char ** argv) {{\n  rclcpp::init(argc, argv);\n}}\n",
        "it uses rclcpp, and no node of it was found",
    ),
    "an interface of rcl": (
        f"""{HEAD}{_NODE}
int main() {{
  auto node = std::make_shared<Talker>();
  rcl_publisher_init(&publisher, node->get_node_base_interface()->get_rcl_node_handle(), support, "raw", &options);
}}
""",
        "rcl_publisher_init makes an interface below rclcpp",
    ),
}


@pytest.mark.parametrize("case", DOUBTED)
def test_doubted(case: str, tmp_path: Path) -> None:
    source, reason = DOUBTED[case]
    _, doubts, _ = follow(tmp_path, source)
    assert {each.reason for each in doubts} == {reason}
    assert {each.category for each in doubts} == {"publishers", "subscribers", "services", "clients", "actions", "params"}


def test_a_node_that_is_known_and_its_base_are_run_without_a_doubt(tmp_path: Path) -> None:
    source = f"""{HEAD}{_NODE}
int main(int argc, char ** argv) {{
  rclcpp::init(argc, argv);
  auto node = std::make_shared<Talker>();
  rclcpp::executors::MultiThreadedExecutor executor;
  executor.add_node(node->get_node_base_interface());
  rclcpp::spin_some(node);
  rclcpp::spin(node);
}}
"""
    facts, doubts, made = follow(tmp_path, source)
    assert not facts
    assert not doubts
    assert [each.name for each in made] == ["talker"]
