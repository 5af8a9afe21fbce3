"""Launch files converted in a small workspace: for the tests of what is written."""

from __future__ import annotations

from pathlib import Path

from launchlint.evaluate.session import Session
from launchlint.export.ros2.converting import Converted, convert
from launchlint.fix.format.style import Style
from launchlint.workspace.packages import Packages

PACKAGE = "<package format='3'><name>demo</name><version>0.0.0</version><description>d</description></package>"
VARIABLES = {"HOME": "/home/somebody", "USER": "somebody"}


def session(directory: Path, distro: str = "jazzy") -> Session:
    return Session(Packages([str(directory)], VARIABLES, explicit=True), VARIABLES, str(directory), distro=distro)


def converted(directory: Path, name: str, text: str, language: str, *given: str, distro: str = "jazzy") -> Converted:
    """The launch file ``name``, which holds ``text``, of a package ``demo``, in ``language``."""
    file = directory / "demo/launch" / name
    file.parent.mkdir(parents=True, exist_ok=True)
    (directory / "demo/package.xml").write_text(PACKAGE)
    file.write_text(text, encoding="utf-8")
    pairs = tuple((key, value) for key, _, value in (each.partition(":=") for each in given))
    return convert(session(directory, distro), str(file), pairs, Style(), language)


def lines(result: Converted) -> list[str]:
    """What was said to be lost, and what a person should know, with their lines."""
    return [f"{place.source.position(place.span.start).line}: {words}" for place, words in (*result.lost, *result.remarks)]
