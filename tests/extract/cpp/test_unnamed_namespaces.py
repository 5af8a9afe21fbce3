"""Classes in namespaces without a name: two files may have one each of the same name."""

from __future__ import annotations

from pathlib import Path

from tests.extract.cpp.following import program, spelled

PUBLISHES = 'Node::Node() {{ nh_.advertise<std_msgs::Bool>("{0}", 1); }}\n'
LOCAL = "namespace robot {\nnamespace {\nclass Node { public: Node(); ros::NodeHandle nh_; };\n" + PUBLISHES.format("local") + "}\n}\n"
HEADER = "namespace robot { class Node { public: Node(); void more(); ros::NodeHandle nh_; }; }\n"


def test_the_class_of_the_program_and_not_that_of_the_library(tmp_path: Path) -> None:
    files = {
        "main.cpp": LOCAL + "int main() { robot::Node node; }\n",
        "library.cpp": '#include "node.h"\nnamespace robot {\n' + PUBLISHES.format("of_the_library") + "}\n",
        "node.h": HEADER,
    }
    facts, doubts = program(tmp_path, files)
    assert [spelled(fact) for fact in facts] == ["publishers local std_msgs/Bool 4 queue=1"]
    assert doubts == ()


def test_the_class_of_the_library_and_not_that_of_another_file(tmp_path: Path) -> None:
    files = {
        "main.cpp": '#include "node.h"\nint main() { robot::Node node; }\n',
        "library.cpp": '#include "node.h"\nnamespace robot {\n' + PUBLISHES.format("of_the_library") + "}\n",
        "node.h": HEADER,
        "other.cpp": LOCAL,
    }
    facts, doubts = program(tmp_path, files)
    assert [spelled(fact) for fact in facts] == ["publishers of_the_library std_msgs/Bool 3 queue=1"]
    assert doubts == ()
