"""What the grammar has no place for: ``#if`` amid a list of arguments, macros behind members."""

from __future__ import annotations

from pathlib import Path

import pytest

from launchlint.extract.cpp import syntax
from tests.extract.cpp.following import program, spelled

SIDES = {
    "the first side": ('#if __cplusplus < 201400L\n  "old"\n#else\n  "new"\n#endif', "old"),
    "not the side that is never there": ('#if 0\n  "old"\n#else\n  "new"\n#endif', "new"),
    "of three": ('#ifdef A\n  "a"\n#elif B\n  "b"\n#else\n  "c"\n#endif', "a"),
    "an inner one": ('#if A\n  #if B\n  "a"\n  #endif\n#else\n  "b"\n#endif', "a"),
}


@pytest.mark.parametrize("name", SIDES)
def test_arguments(tmp_path: Path, name: str) -> None:
    lines, expected = SIDES[name]
    source = f'int main() {{ ros::NodeHandle nh; nh.param( // which?\n{lines}\n, n, 1);\nnh.advertise<std_msgs::Bool>("after", 1); }}\n'
    facts, doubts = program(tmp_path, source)
    last = source.count("\n")
    assert [spelled(fact) for fact in facts] == [
        f"params {expected} int 1 default=1",
        f"publishers after std_msgs/Bool {last} queue=1",
    ]
    assert doubts == ()


def test_endless_conditionals_are_left_as_they_are() -> None:
    text = "f(1,\n#if A\n" * 3_000
    assert syntax.parse(text.encode()).text == text


def test_members_that_say_what_guards_them(tmp_path: Path) -> None:
    facts, doubts = program(
        tmp_path,
        "class Node {\n public:\n  Node() : sub_(nh_.subscribe<std_msgs::Bool>(topic_, 1, f)) {}\n"
        '  ros::NodeHandle nh_;\n  std::string topic_ GUARDED_BY(mutex_) = "in";\n  ros::Subscriber sub_ ABSL_GUARDED_BY(mutex_);\n'
        "  void g() EXCLUSIVE_LOCKS_REQUIRED(mutex_);\n};\nint main() { Node node; }\n",
    )
    assert [spelled(fact) for fact in facts] == ["subscribers in std_msgs/Bool 3 queue=1"]
    assert doubts == ()


def test_what_the_parser_goes_back_and_forth_in_is_not_read() -> None:
    """Parts that it cannot read take it time by their square; what comes after it in another file is read as ever."""
    mended = b"int main() {}\n"
    torn = b"void f() { g([this](std_msgs::msg" + b"::String:" * 4_000 + b"){}); }\n"
    root = syntax.parse(torn)
    assert root.children == []
    assert root.errors == [(1, torn.decode())]
    assert [each.kind for each in syntax.parse(mended).children] == ["function_definition"]
    assert syntax.parse(mended * 4_000).errors == []
    assert syntax.parse_expression("a" + "::String:" * 4_000) is None
