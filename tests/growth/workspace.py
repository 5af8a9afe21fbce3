"""A workspace in which one construct is repeated."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from pathlib import Path
from typing import NamedTuple

ENTRY = "launch/a.launch"
ENTRY_ROS2 = "launch/a.launch.xml"


class Construct(NamedTuple):
    """``files(n)``: the files of a workspace with ``n`` of the construct; ``entry`` is the one that is checked.

    ``most`` is the greatest number that is tried: beyond it a format's own bound is reached (roslaunch nests 988 elements), or there are
    more files than a test may write. ``product``: what is in force acts on everything behind it, or is named as what was meant, or a file
    is entered ever more often, so that the launch itself grows faster than its text, until the bound on work is reached.
    """

    name: str
    entry: str
    files: Callable[[int], Mapping[str, str]]
    most: int = 100_000
    product: bool = False


def build(construct: Construct, count: int, directory: Path) -> Path:
    """Write the workspace of ``count`` below ``directory`` and return its entry file."""
    for name, text in construct.files(count).items():
        file = directory / name
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(text, encoding="utf-8")
    return directory / construct.entry


def times(count: int, text: str, between: str = "\n") -> str:
    """``text`` so many times, each with its number for ``{}`` and the next number for ``{+}``."""
    return between.join(text.replace("{}", str(number)).replace("{+}", str(number + 1)) for number in range(count))
