"""Which launch files in Python are taken to describe nothing: only those of which nothing else can be true."""

from __future__ import annotations

import pytest

from launchlint.evaluate.ros2.python_files import describes_nothing

HEAD = "from launch import LaunchDescription\n"
FUNCTION = "def generate_launch_description():\n    return {}\n"


@pytest.mark.parametrize("value", ["LaunchDescription()", "LaunchDescription([])"])
def test_an_empty_description(value: str) -> None:
    assert describes_nothing((HEAD + FUNCTION.format(value)).encode())
    assert describes_nothing(('"""A text."""\n' + HEAD + FUNCTION.format(value)).encode())


@pytest.mark.parametrize(
    "text",
    [
        "",
        HEAD,
        "raise SystemExit\n",
        "import os\n" + HEAD + FUNCTION.format("LaunchDescription()"),
        HEAD + "x()\n" + FUNCTION.format("LaunchDescription()"),
        HEAD + "@late\n" + FUNCTION.format("LaunchDescription()"),
        HEAD + FUNCTION.format("LaunchDescription([Node()])"),
        HEAD + FUNCTION.format("LaunchDescription(x)"),
        HEAD + FUNCTION.format("LaunchDescription(initial_entities=[a])"),
        HEAD + FUNCTION.format("describe()"),
        HEAD + FUNCTION.format("LaunchDescription()").replace("    return", "    act()\n    return"),
        HEAD + FUNCTION.format("LaunchDescription()") + "act()\n",
        HEAD + FUNCTION.format("LaunchDescription(" + "(" * 900 + ")" * 900 + ")"),
        HEAD + FUNCTION.format("LaunchDescription()") + "#" * 2_000,
        "\0",
        "def :",
    ],
)
def test_anything_else(text: str) -> None:
    assert not describes_nothing(text.encode())
